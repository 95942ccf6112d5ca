// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Occlusion queries of the hardware: the image of VTK without any culler, byte for byte, and what
// is hidden is not drawn.
#include "Judge.h"
#include "QueryCuller.h"
#include "Shapes.h"
#include "WindowFixture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <cmath>
#include <random>

namespace
{
using NBufferPeers::BoxQueries;
using NBufferPeers::QueryCuller;
using NBufferPeers::QueryMethod;
using NBufferPeers::QueryStatistics;
using NBufferPeers::QueryTarget;

struct Kind
{
  const char* Name;
  QueryMethod Method;
  QueryTarget Target;
};
void PrintTo(const Kind& kind, std::ostream* os)
{
  *os << kind.Name;
}

class StudyPeers
  : public WindowFixture
  , public testing::WithParamInterface<Kind>
{
protected:
  StudyPeers()
    : WindowFixture(301, 173)
  {
  }

  void SetUp() override
  {
    WindowFixture::SetUp();
    if (this->IsSkipped())
    {
      return;
    }
    const std::string why = BoxQueries::WhyNot(GetParam().Target);
    if (!why.empty())
    {
      GTEST_SKIP() << why;
    }
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->GetCullers()->RemoveAllItems();
    this->Culler->SetMethod(GetParam().Method);
    this->Culler->SetTarget(GetParam().Target);
  }

  void AddPart(double x, double y, double z, double sx, double sy, double sz)
  {
    const glm::dvec3 size = { sx, sy, sz };
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(TestScene::MakeBox(glm::dvec3(x, y, z) + 0.5 * size, size));
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(
      0.3 + 0.1 * (this->Props % 7), 0.2 + 0.15 * (this->Props % 5), 0.9);
    this->Renderer->AddActor(actor);
    ++this->Props;
  }

  /// A wall before a block of 64 boxes, and a box before it.
  void AddWall()
  {
    this->AddPart(-20.0, -20.0, 0.0, 40.0, 40.0, 0.0);
    for (int i = 0; i < 64; ++i)
    {
      this->AddPart(
        -6.0 + 3.0 * (i % 4), -6.0 + 3.0 * (i / 4 % 4), -5.0 - 3.0 * (i / 16), 2.0, 2.0, 2.0);
    }
    this->AddPart(-1.0, -1.0, 4.0, 2.0, 2.0, 2.0);
    this->SetCamera(0.0, 0.0, 20.0);
  }

  void SetCamera(double x, double y, double z)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(x, y, z);
    camera->SetFocalPoint(0.4 * x, 0.4 * y, 0.0);
    camera->SetClippingRange(0.1, 100.0);
  }

  TestScene::Picture Render(bool culled)
  {
    this->Renderer->GetCullers()->RemoveAllItems();
    if (culled)
    {
      this->Renderer->AddCuller(this->Culler);
    }
    this->Window->Render();
    return TestScene::TakePicture(this->Window);
  }

  /// The image must be that without a culler.
  const QueryStatistics& Compare(const char* what)
  {
    const TestScene::Picture expected = this->Render(false);
    EXPECT_EQ(TestScene::FindDifference(expected, this->Render(true)), "") << what;
    EXPECT_EQ(this->Culler->GetError(), "");
    const QueryStatistics& statistics = this->Culler->GetStatistics();
    EXPECT_EQ(statistics.Drawn + statistics.Hidden, statistics.InView);
    if (GetParam().Method == QueryMethod::Coherent)
    {
      EXPECT_EQ(statistics.Nodes, 2 * this->Props - 1);
      EXPECT_LE(statistics.Queries, statistics.Visits);
      EXPECT_LE(statistics.Visits, statistics.Nodes);
    }
    else
    {
      EXPECT_LE(statistics.Queries, statistics.InView);
    }
    return statistics;
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<QueryCuller> Culler;
  int Props = 0;
};

TEST_P(StudyPeers, WhatTheWallHidesIsNotDrawn)
{
  this->AddWall();
  for (int frame = 0; frame < 4; ++frame)
  {
    const QueryStatistics& statistics = this->Compare("the wall");
    EXPECT_EQ(statistics.InView, 66);
    // Over a hierarchy, what is asked for before the wall has been drawn is drawn once.
    if (GetParam().Method == QueryMethod::Flat || frame >= 2)
    {
      EXPECT_EQ(statistics.Hidden, 64) << "frame " << frame;
    }
    EXPECT_GT(statistics.Queries, 0);
  }
}

TEST_P(StudyPeers, NothingIsLateWhenTheCameraJumps)
{
  this->AddWall();
  this->Compare("before");
  this->SetCamera(0.0, 0.0, -20.0);
  EXPECT_GT(this->Compare("behind the wall").Drawn, 10);
  this->SetCamera(15.0, 0.0, -3.0);
  this->Compare("beside");
  this->SetCamera(0.0, 0.0, 20.0);
  EXPECT_GE(this->Compare("before again").Drawn, 2);
  this->Compare("once more");
  EXPECT_EQ(this->Compare("settled").Hidden, 64);
}

TEST_P(StudyPeers, FacesInOnePlaneEndInTheRenderersOrder)
{
  // Boxes that share faces and planes, in an order that is not front to back.
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i)
  {
    const double x = static_cast<double>(random() % 8) - 4.0;
    const double y = static_cast<double>(random() % 8) - 4.0;
    const double z = static_cast<double>(random() % 3) - 3.0;
    this->AddPart(x, y, z, 1.0 + random() % 3, 1.0 + random() % 3, random() % 3);
  }
  for (int frame = 0; frame < 6; ++frame)
  {
    this->SetCamera(3.0 * std::sin(frame), 3.0 * std::cos(frame), 15.0);
    this->Compare("ties");
  }
}

TEST_P(StudyPeers, FlatPropsDoNotHideThemselves)
{
  for (int i = 0; i < 30; ++i)
  {
    this->AddPart(-8.0 + 0.5 * i, -4.0 + 0.2 * i, -0.1 * i, 3.0, 2.0, 0.0);
  }
  for (double x : { -30.0, 0.0, 14.0 })
  {
    this->SetCamera(x, 2.0, 12.0);
    this->Compare("flat");
  }
}

TEST_P(StudyPeers, InsideOfAProp)
{
  this->AddWall();
  this->AddPart(-1.0, -1.0, 18.0, 2.0, 2.0, 4.0);
  this->Compare("the eye in a box");
  this->SetCamera(0.0, 0.0, 17.95);
  this->Compare("the near plane at a face");
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Renderer->GetActiveCamera()->SetParallelScale(7.0);
  EXPECT_GE(this->Compare("parallel").Hidden, 60);
}

TEST_P(StudyPeers, PropsComeAndGo)
{
  this->AddWall();
  this->Compare("before");
  this->AddPart(-4.0, 2.0, 2.0, 1.0, 1.0, 1.0);
  EXPECT_EQ(this->Compare("one more").InView, 67);
  vtkActor* wall = vtkActor::SafeDownCast(this->Renderer->GetViewProps()->GetItemAsObject(0));
  wall->SetPosition(0.0, 0.0, -30.0);
  EXPECT_GT(this->Compare("the wall moved").Drawn, 20);
  this->Renderer->RemoveActor(wall);
  --this->Props;
  this->Compare("no wall");
}

TEST_P(StudyPeers, MultisampledInAnotherWindow)
{
  this->AddWall();
  this->Compare("one sample");
  this->Window->RemoveRenderer(this->Renderer);
  this->Window = NewWindow(301, 173, 4);
  this->Window->AddRenderer(this->Renderer);
  for (int frame = 0; frame < 3; ++frame)
  {
    this->SetCamera(0.3 * frame, 0.1, 20.0);
    this->Compare("four samples");
  }
  EXPECT_GT(this->Culler->GetStatistics().Hidden, 50);
}

INSTANTIATE_TEST_SUITE_P(Kinds, StudyPeers,
  testing::Values(Kind{ "Flat", QueryMethod::Flat, QueryTarget::Any },
    Kind{ "FlatConservative", QueryMethod::Flat, QueryTarget::AnyConservative },
    Kind{ "FlatSamples", QueryMethod::Flat, QueryTarget::Samples },
    Kind{ "Coherent", QueryMethod::Coherent, QueryTarget::Any },
    Kind{ "CoherentConservative", QueryMethod::Coherent, QueryTarget::AnyConservative }),
  [](const auto& info) { return std::string(info.param.Name); });
}
