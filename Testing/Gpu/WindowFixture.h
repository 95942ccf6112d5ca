// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WindowFixture.h
 * @brief A fixture whose window exists and is current before a test begins.
 */
#ifndef WindowFixture_h
#define WindowFixture_h

#include "OffscreenFixture.h"

#include "vtkOpenGLRenderWindow.h"

/// Most of these tests draw into framebuffers of their own: any size of window will do.
class WindowFixture : public OffscreenFixture
{
protected:
  explicit WindowFixture(int width = 16, int height = 16)
    : WindowWidth(width)
    , WindowHeight(height)
  {
  }

  /// Leaves Window empty where tests are skipped.
  void SetUp() override
  {
    OffscreenFixture::SetUp();
    if (!this->IsSkipped())
    {
      this->Window = NewWindow(this->WindowWidth, this->WindowHeight);
    }
  }

  vtkSmartPointer<vtkOpenGLRenderWindow> Window;

private:
  int WindowWidth;
  int WindowHeight;
};

#endif
