// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of almost no height on the screen, to which a rasteriser may give any depth.
#include "CullerTest.h"
#include "Judge.h"
#include "Scenes.h"
#include "vtkNBufferGL.h"

#include "vtkCamera.h"
#include "vtkCylinderSource.h"
#include "vtkFloatArray.h"
#include "vtkPlaneSource.h"

namespace
{
constexpr int SliversWidth = 960;
constexpr int SliversHeight = 720;

/// A pipe along x with triangles in its outline that pass the middle of a pixel. llvmpipe draws it
/// at the depth of its box but for that pixel.
struct Pipe : NamedCase
{
  double Eye[3];
  double Center[3];
  double Diameter;
  double Length;
  int Pixel[2];     ///< From the lower left corner.
  double WallShare; ///< Where on the way from the eye to the pipe the wall is: behind the stray.
};

// Of the plant of nbuffer-bench (path "around": frame 610 of 1800 and 39 of 120). The triangles
// that own the pixels are 7.6e-6 and 3.8e-6 pixels high, the middles of the pixels 0.0009 and
// 0.0013 pixels beside them, and their planes have slopes of 3.1 and 9.4 per pixel.
const Pipe Pipes[] = {
  { "NearTheWall", { -57.965137504634534, 67.991415438949105, 25.0 },
    { -9.5633621132796733, -1.8982328788278648, 11.171131773636692 }, 0.14226354727338075,
    5.9133289056492808, { 569, 409 }, 0.94 },
  { "FarBeforeIt", { -49.938954971350135, 71.28052193506943, 25.0 },
    { 19.780298412222521, -18.841985499340527, 6.8870726774517221 }, 0.37414535490344419,
    5.9024238729778018, { 440, 420 }, 0.8 },
};
void Build(Stage& stage, const Pipe& pipe)
{
  vtkRenderer* renderer = stage.GetRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(pipe.Eye);
  camera->SetFocalPoint(0.0, 0.0, 5.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(45.0);
  camera->SetClippingRange(5.0, 300.0);

  // Before the pipe, parallel to the image, in a part of the view.
  double middle[3];
  for (int j = 0; j < 3; ++j)
  {
    middle[j] = pipe.Eye[j] + pipe.WallShare * (pipe.Center[j] - pipe.Eye[j]);
  }
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-10.0, -10.0, 0.0);
  wall->SetPoint1(10.0, -10.0, 0.0);
  wall->SetPoint2(-10.0, 10.0, 0.0);
  wall->SetCenter(middle);
  double direction[3];
  camera->GetDirectionOfProjection(direction);
  wall->SetNormal(-direction[0], -direction[1], -direction[2]);
  wall->Update();
  const double wallColor[3] = { 0.3, 0.5, 0.8 };
  stage.AddActor(wall->GetOutput(), wallColor);

  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(16);
  cylinder->Update();
  const double pipeColor[3] = { 0.9, 0.4, 0.2 };
  vtkActor* actor = stage.AddActor(cylinder->GetOutput(), pipeColor);
  actor->SetPosition(pipe.Center[0], pipe.Center[1], pipe.Center[2]);
  actor->SetScale(pipe.Diameter, pipe.Length, pipe.Diameter);
  actor->SetOrientation(0.0, 0.0, 90.0);
}

double GetDepth(Stage& stage, int x, int y)
{
  vtkNew<vtkFloatArray> depth;
  stage.Window->GetZbufferData(x, y, x, y, depth);
  return depth->GetValue(0);
}
}

using CullerSlivers = testing::TestWithParam<Pipe>;

// Hazard: a rasteriser draws a pixel of a sliver in front of the wall that hides the prop, and the
// culler leaves that prop out, so that the pixel is missing.
TEST_P(CullerSlivers, AreDrawnWhereTheyShow)
{
  const Pipe& pipe = this->GetParam();
  Comparison comparison([&pipe](Stage& stage) { Build(stage, pipe); },
    Scenes::MakeExactOptions(SliversWidth, SliversHeight, 4));
  Scenes::Settle(comparison);

  const int x = pipe.Pixel[0];
  const int y = pipe.Pixel[1];
  const double stray = GetDepth(comparison.Reference, x, y);
  const double wall = GetDepth(comparison.Reference, x, y + 20);
  ASSERT_LT(wall, 1.0);
  if (!vtkNBufferGL::GetSoftwareRenderer())
  {
    GTEST_SKIP() << "slivers are tested with software renderers";
  }
  // The box lies behind the wall, and so does every point of the pipe.
  comparison.GetCuller()->SetTestSlivers(false);
  comparison.Culled.Window->Render();
  comparison.Culled.Window->Render();
  EXPECT_EQ(comparison.GetVerdict(1), Verdict::Hidden);
  comparison.GetCuller()->SetTestSlivers(true);
  // Triangles that are not read because the prop is divided are read when it is not any more.
  const vtkNBufferTuning tuning = comparison.GetCuller()->GetTuning();
  vtkNBufferTuning divided = tuning;
  divided.MinimumNumberOfPrimitives = 2;
  comparison.GetCuller()->SetTuning(divided);
  comparison.Culled.Window->Render();
  EXPECT_EQ(comparison.GetVerdict(1), Verdict::Hidden);
  comparison.GetCuller()->SetTuning(tuning);
  comparison.Frame("slivers looked at");
  // Whether this rasteriser draws the stray pixel or not: one may.
  EXPECT_EQ(comparison.GetVerdict(1), Verdict::Visible);
  EXPECT_LT(stray, wall - 1e-4) << "llvmpipe draws it";
}

INSTANTIATE_TEST_SUITE_P(Each, CullerSlivers, testing::ValuesIn(Pipes), GetCaseName);

// The same with four samples in a pixel. The picture is moved so that each of them in turn is where
// the middle of the pixel was.
TEST(CullerSliversOnce, AreDrawnWhereASampleShows)
{
  int strays = 0;
  for (const Pipe& pipe : Pipes)
  {
    ComparisonOptions options = Scenes::MakeExactOptions(SliversWidth, SliversHeight, 4);
    options.MultiSamples = 4;
    options.CompareDepth = false;
    Comparison comparison([&pipe](Stage& stage) { Build(stage, pipe); }, options);
    Scenes::Settle(comparison);
    if (!vtkNBufferGL::GetSoftwareRenderer() || comparison.Culled.Window->GetMultiSamples() < 4)
    {
      GTEST_SKIP() << "slivers are tested with software renderers, and this one needs four samples";
    }
    for (const auto& [x, y] : TestScene::GetSamplePlaces(comparison.Reference.Window))
    {
      const double center[2] = { 2.0 * (0.5 - x) / SliversWidth, 2.0 * (0.5 - y) / SliversHeight };
      comparison.Both([&center](Stage& stage)
        { stage.GetRenderer()->GetActiveCamera()->SetWindowCenter(center[0], center[1]); });
      comparison.GetCuller()->SetTestSlivers(true);
      comparison.Frame("slivers looked at");
      const TestScene::Picture right = TestScene::TakePicture(comparison.Culled.Window);
      comparison.GetCuller()->SetTestSlivers(false);
      comparison.Culled.Window->Render();
      const TestScene::Picture without = TestScene::TakePicture(comparison.Culled.Window);
      strays += TestScene::FindDifference(right, without).empty() ? 0 : 1;
    }
  }
  EXPECT_GT(strays, 0) << "llvmpipe draws some";
}
