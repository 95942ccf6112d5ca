// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WindowFixture.h
 * @brief A fixture whose window exists and is current before a test begins.
 */
#ifndef WindowFixture_h
#define WindowFixture_h

#include "OffscreenFixture.h"
#include "Pixels.h"
#include "vtkNBufferDepthSource.h"
#include VTKNBUFFER_GL_HEADER

#include "vtkActor.h"
#include "vtkConeSource.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <string>
#include <vector>

/// The size of the window, in pixels, does not matter for tests that draw into their own
/// framebuffers.
class WindowFixture : public OffscreenFixture
{
protected:
  explicit WindowFixture(int width = 16, int height = 16)
    : WindowWidth(width)
    , WindowHeight(height)
  {
  }

  /// Makes the window, unless the tests are skipped.
  void SetUp() override
  {
    OffscreenFixture::SetUp();
    if (!this->IsSkipped())
    {
      this->Window = NewWindow(this->WindowWidth, this->WindowHeight);
    }
  }

  /// Returns where the depth of the bound framebuffer can be read.
  vtkNBufferDepthSource Inspect() const
  {
    vtkNBufferDepthSource source;
    std::string why;
    EXPECT_TRUE(source.Inspect(this->Window, why)) << why;
    return source;
  }

  /// Reads the depth of a rectangle; of several samples in a pixel the extremum.
  std::vector<float> Read(const vtkNBufferDepthSource& source, const vtkNBufferRectangle& r,
    vtkNBufferExtremum extremum = vtkNBufferExtremum::Maximum) const
  {
    std::vector<float> depth;
    std::string why;
    EXPECT_TRUE(
      source.Read(this->Window, r.X0, r.Y0, r.GetWidth(), r.GetHeight(), depth, why, extremum))
      << why;
    return depth;
  }

  static void AddCone(vtkRenderer* renderer)
  {
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(30);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(cone->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
  }

  vtkSmartPointer<vtkOpenGLRenderWindow> Window;

private:
  int WindowWidth;
  int WindowHeight;
};

#endif
