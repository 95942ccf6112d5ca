// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether vtkNBufferTieQuery sees equal depths, and leaves no trace.
#include "vtkNBufferTieQuery.h"

#include "GLStateSnapshot.h"
#include "WindowFixture.h"
#include "vtkNBufferGL.h"

#include "vtkProperty.h"

#include <stdexcept>
#include <utility>
#include <vector>

namespace
{
class GpuTestNBufferTieQuery : public WindowFixture
{
protected:
  GpuTestNBufferTieQuery()
    : WindowFixture(40, 30)
  {
  }

  void SetUp() override
  {
    WindowFixture::SetUp();
    if (!this->IsSkipped())
    {
      vtkNew<vtkConeSource> cone;
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(cone->GetOutputPort());
      this->Actor->SetMapper(mapper);
      this->Renderer->AddActor(this->Actor);
      this->Window->AddRenderer(this->Renderer);
    }
  }

  static std::vector<float> Read(GLenum format)
  {
    std::vector<float> values(40 * 30);
    glReadPixels(0, 0, 40, 30, format, GL_FLOAT, values.data());
    return values;
  }

  bool HasTies()
  {
    return vtkNBufferTieQuery::HasTies(
      [this]()
      {
        ++this->Draws;
        this->Actor->RenderOpaqueGeometry(this->Renderer);
      });
  }

  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  int Draws = 0;
};
}

TEST_F(GpuTestNBufferTieQuery, SeesEqualDepthsAlone)
{
  WhileDrawing(this->Window, this->Renderer,
    [this]()
    {
      EXPECT_TRUE(this->HasTies());
      for (const auto& [x, z] : { std::pair(0.0, 0.01), std::pair(0.0, -5.0), std::pair(9.0, 0.0) })
      {
        this->Actor->SetPosition(x, 0.0, z);
        EXPECT_FALSE(this->HasTies()) << x << " " << z;
      }
    });
  EXPECT_EQ(this->Draws, 4);
}

// Hazard: the draws that find ties change the image or the state of OpenGL.
TEST_F(GpuTestNBufferTieQuery, LeavesNoTrace)
{
  WhileDrawing(this->Window, this->Renderer,
    [this]()
    {
      const std::vector<float> depthBefore = this->Read(GL_DEPTH_COMPONENT);
      const std::vector<float> colorBefore = this->Read(GL_RED);
      this->Actor->GetProperty()->SetColor(0.2, 0.0, 0.0);
      this->Actor->RenderOpaqueGeometry(this->Renderer); // so that VTK's state is as after a draw
      EXPECT_NE(this->Read(GL_RED), colorBefore);
      this->Actor->GetProperty()->SetColor(0.9, 0.0, 0.0);
      const std::vector<float> redBefore = this->Read(GL_RED);
      glColorMaski(0, GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
      const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
      EXPECT_TRUE(this->HasTies());
      EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
      glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      EXPECT_EQ(this->Read(GL_RED), redBefore);
      EXPECT_EQ(this->Read(GL_DEPTH_COMPONENT), depthBefore);
    });
}

// Hazard: an observer of the application throws during a query for ties, and the next draws write
// no colors.
TEST_F(GpuTestNBufferTieQuery, LeavesNoTraceOfAnException)
{
  WhileDrawing(this->Window, this->Renderer,
    [this]()
    {
      const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
      EXPECT_THROW(vtkNBufferTieQuery::HasTies([]() { throw std::runtime_error("drawn"); }),
        std::runtime_error);
      EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
      int running = 0;
      glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &running);
      EXPECT_EQ(running, 0);
    });
}

TEST_F(GpuTestNBufferTieQuery, StepsAsideForAnotherQuery)
{
  WhileDrawing(this->Window, this->Renderer,
    [this]()
    {
      this->Actor->SetPosition(9.0, 0.0, 0.0);
      for (const GLenum target : { GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED })
      {
        if (target == GL_SAMPLES_PASSED ||
          vtkNBufferGL::HasFeature(3, 3, "GL_ARB_occlusion_query2"))
        {
          GLuint query = 0;
          glGenQueries(1, &query);
          glBeginQuery(target, query);
          EXPECT_TRUE(this->HasTies());
          EXPECT_EQ(this->Draws, 0);
          glEndQuery(target);
          glDeleteQueries(1, &query);
        }
      }
    });
}
