// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Windows, viewports, layers, eyes and projections of every kind.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkTransform.h"

#include <algorithm>

using Scenes::Wall;

namespace
{
ComparisonOptions Size(int width, int height)
{
  ComparisonOptions options;
  options.Width = width;
  options.Height = height;
  return options;
}

}

//------------------------------------------------------------------------------------------------
namespace
{
using CullerWindowSizes = testing::TestWithParam<std::pair<int, int>>;
}

// Hazard: windows are odd, narrow, wide or tiny, so that level 0 has cut texels or only one texel.
TEST_P(CullerWindowSizes, WallAndCity)
{
  const auto [width, height] = this->GetParam();
  ComparisonOptions options = Size(width, height);
  options.MayBeOfOneColor = width * height == 1;
  Comparison wall(Scenes::BuildWall, options);
  Comparison city([](Stage& stage) { Scenes::BuildCity(stage, 10); }, options);
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(wall, 0.3 * i, "wall");
    Scenes::FrameOfCity(city, 0.1 * i, "city");
  }
  if (std::min(width, height) > 60)
  {
    EXPECT_EQ(wall.GetDecision(), Decision::Culled);
    EXPECT_GE(wall.GetHidden(), Wall::Behind / 2);
    EXPECT_GT(city.GetHidden(), 10);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, CullerWindowSizes,
  testing::Values(std::pair<int, int>(1, 1), std::pair<int, int>(7, 3),
    std::pair<int, int>(97, 211), std::pair<int, int>(301, 173), std::pair<int, int>(640, 33),
    std::pair<int, int>(31, 500), std::pair<int, int>(256, 256), std::pair<int, int>(511, 377)),
  [](const testing::TestParamInfo<std::pair<int, int>>& info)
  { return std::to_string(info.param.first) + "x" + std::to_string(info.param.second); });

// Hazard: the framebuffer has a new size; levels and verdicts of the old size must not be used.
TEST(CullerWindows, ResizedBetweenFrames)
{
  Comparison comparison(Scenes::BuildWall);
  const int sizes[][2] = { { 301, 173 }, { 97, 211 }, { 400, 400 }, { 133, 300 }, { 301, 173 } };
  for (const auto& size : sizes)
  {
    comparison.Frame("resized", [&size](Stage& stage) { stage.Window->SetSize(size[0], size[1]); });
    comparison.Frame("the same again");
    EXPECT_GT(comparison.GetHidden(), Wall::Behind / 2) << size[0] << " x " << size[1];
  }
}

// Hazard: a window without a pixel has no depth, and no texel to build levels from.
TEST(CullerWindows, ResizedToZeroAndBack)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame("before");
  if (comparison.Culled.Window->IsA("vtkXOpenGLRenderWindow"))
  {
    GTEST_SKIP() << "X refuses windows of size zero, and Xlib then ends the program";
  }
  EXPECT_GT(comparison.GetHidden(), Wall::Behind / 2);
  const int sizes[][2] = { { 0, 0 }, { 0, 90 }, { 120, 0 } };
  for (const auto& size : sizes)
  {
    SCOPED_TRACE(std::to_string(size[0]) + " x " + std::to_string(size[1]));
    comparison.Both(
      [&size](Stage& stage)
      {
        stage.Window->SetSize(size[0], size[1]);
        stage.Window->Render();
        stage.Window->Render();
      });
    TakeMessages(); // VTK's own: it draws in a size of its choice, or in none
    comparison.Frame("back", [](Stage& stage) { stage.Window->SetSize(301, 173); });
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    EXPECT_GT(comparison.GetHidden(), Wall::Behind / 2);
  }
}

// Hazard: a viewport without a pixel in a window that has some.
TEST(CullerWindows, ViewportOfSizeZero)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame("before");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  comparison.Frame("a viewport without width",
    [](Stage& stage) { stage.GetRenderer()->SetViewport(0.5, 0.2, 0.5, 0.8); });
  EXPECT_EQ(comparison.GetDecision(), Decision::UnsupportedWindow);
  comparison.Frame(
    "back", [](Stage& stage) { stage.GetRenderer()->SetViewport(0.0, 0.0, 1.0, 1.0); });
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: names of objects of a context that is gone are used in its successor.
TEST(CullerWindows, ContextReleasedAndMadeAnew)
{
  for (int backend : { vtkNBufferCuller::CPU, vtkNBufferCuller::OpenGL })
  {
    ComparisonOptions options;
    options.Backend = backend;
    Comparison comparison(Scenes::BuildWall, options);
    for (int i = 0; i < 3; ++i)
    {
      Scenes::FrameOfWall(comparison, 0.2 * i, "before");
      EXPECT_GE(comparison.GetHidden(), Wall::Hidden) << i;
      comparison.Both([](Stage& stage) { stage.Window->Finalize(); });
    }
  }
}

// Hazard: the renderers move to another window, and the culler with them; the old window dies.
TEST(CullerWindows, RendererMovesToAnotherWindow)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame("first window");
  comparison.Frame("second window",
    [](Stage& stage)
    {
      auto window = vtkSmartPointer<vtkRenderWindow>::New();
      window->SetOffScreenRendering(1);
      window->SetMultiSamples(0);
      window->SetSize(222, 155);
      stage.Window->RemoveRenderer(stage.GetRenderer());
      window->AddRenderer(stage.GetRenderer());
      stage.Window = window;
    });
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: a culler that outlives its window, or dies before it.
TEST(CullerWindows, WindowAndCullerDieInAnyOrder)
{
  TakeMessages();
  for (int backend : { vtkNBufferCuller::CPU, vtkNBufferCuller::OpenGL })
  {
    auto culler = vtkSmartPointer<vtkNBufferCuller>::New();
    culler->SetBackend(backend);
    for (int i = 0; i < 2; ++i)
    {
      Comparison comparison(Scenes::BuildWall);
      comparison.Culled.GetRenderer()->AddCuller(culler);
      comparison.Culled.Window->Render();
      // Its own culler goes while the window lives.
      comparison.Culled.GetRenderer()->GetCullers()->RemoveItem(comparison.Culled.Culler);
      comparison.Culled.Window->Render();
    }
    EXPECT_EQ(culler->GetNumberOfProps(), Wall::Count);
  }
  EXPECT_EQ(TakeMessages(), "");
}

// Hazard: the depth of one viewport is used for another one. Viewports may begin anywhere and be
// cut.
TEST(CullerWindows, FourViewportsOneCuller)
{
  Comparison comparison(
    [](Stage& stage)
    {
      stage.GetRenderer()->SetViewport(0.03, 0.02, 0.47, 0.55);
      Scenes::BuildWall(stage);
      Scenes::BuildCity(stage, 9, stage.AddRenderer(0.47, 0.0, 1.0, 0.55));
      Scenes::AddWall(stage, stage.AddRenderer(0.11, 0.55, 0.5, 0.93));
      Scenes::BuildCity(stage, 9, stage.AddRenderer(0.5, 0.613, 0.98, 1.0));
      Scenes::SetWallCamera(stage.Renderers[2], 3.0);
      Scenes::SetCityCamera(stage.Renderers[3], 0.1);
    },
    Size(403, 301));
  for (int i = 0; i < 5; ++i)
  {
    comparison.Frame(
      [i](Stage& stage)
      {
        Scenes::SetWallCamera(stage.Renderers[0], 0.2 * i);
        Scenes::SetCityCamera(stage.Renderers[1], 0.05 * i);
        Scenes::SetWallCamera(stage.Renderers[2], 3.0 - 0.2 * i);
        Scenes::SetCityCamera(stage.Renderers[3], 0.1 + 0.03 * i);
      });
    EXPECT_GE(comparison.GetHidden(0), Wall::Hidden);
    EXPECT_GT(comparison.GetHidden(1), 5);
    EXPECT_GT(comparison.GetHidden(2), 0);
    EXPECT_GT(comparison.GetHidden(3), 5);
  }
  EXPECT_EQ(comparison.GetStatistics(0).Props, Wall::Count);
  EXPECT_EQ(comparison.GetStatistics(1).Props, 9 * 9 + 1);
}

// Hazard: the same props in two renderers have two verdicts.
TEST(CullerWindows, OnePropSetInTwoRenderers)
{
  Comparison comparison(
    [](Stage& stage)
    {
      stage.GetRenderer()->SetViewport(0.0, 0.0, 0.5, 1.0);
      Scenes::BuildWall(stage);
      vtkRenderer* other = stage.AddRenderer(0.5, 0.0, 1.0, 1.0);
      for (const auto& prop : stage.Props)
      {
        other->AddViewProp(prop);
      }
      other->GetActiveCamera()->SetPosition(1.0, 0.5, -20.0);
      other->ResetCameraClippingRange();
    });
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.1 * i);
    EXPECT_GT(comparison.GetHidden(0), Wall::Behind / 2) << "from the front";
    EXPECT_LT(comparison.GetHidden(1), Wall::Behind / 2) << "from behind";
  }
  EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind, 0), Verdict::Hidden);
  EXPECT_NE(comparison.GetVerdict(Wall::FirstBehind, 1), Verdict::Unknown);
}

// Hazard: two renderers draw into the same pixels, the second one after the depth was cleared.
TEST(CullerWindows, Layers)
{
  for (bool preserveDepth : { false, true })
  {
    SCOPED_TRACE(preserveDepth ? "depth preserved" : "depth cleared");
    Comparison comparison(
      [preserveDepth](Stage& stage)
      {
        stage.Window->SetNumberOfLayers(2);
        Scenes::BuildWall(stage);
        vtkRenderer* upper = stage.AddRenderer(0.0, 0.0, 1.0, 1.0, 1);
        upper->SetPreserveDepthBuffer(preserveDepth);
        for (int i = 0; i < 50; ++i)
        {
          Scenes::AddBox(stage, -3.0 + 0.12 * i, -1.5, -2.0 - 0.1 * i, 0.3, 0.4, 0.3, upper);
        }
        Scenes::AddBox(stage, 0.0, -1.5, 0.0, 5.0, 1.5, 0.2, upper);
        upper->SetActiveCamera(stage.GetRenderer()->GetActiveCamera());
      });
    for (int i = 0; i < 4; ++i)
    {
      Scenes::FrameOfWall(comparison, 0.2 * i);
      EXPECT_GE(comparison.GetHidden(0), Wall::Hidden);
      EXPECT_GT(comparison.GetHidden(1), 20);
    }
  }
}

// Hazard: a renderer that does not erase keeps the depth of the one before it.
TEST(CullerWindows, RendererWithoutErase)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      vtkRenderer* second = stage.AddRenderer(0.0, 0.0, 1.0, 1.0);
      second->EraseOff();
      Scenes::BuildCity(stage, 8, second);
    });
  for (int i = 0; i < 3; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.2 * i);
    EXPECT_GE(comparison.GetHidden(0), Wall::Hidden);
    EXPECT_EQ(comparison.GetDecision(1), Decision::Culled) << "what it keeps hides as well";
    EXPECT_GT(comparison.GetHidden(1), 5);
  }
}

// Hazard: one culler, several windows of different sizes, drawn in turn.
TEST(CullerWindows, OneCullerInTwoWindows)
{
  Comparison first(Scenes::BuildWall, Size(301, 173));
  Comparison second([](Stage& stage) { Scenes::BuildCity(stage, 10); }, Size(97, 211));
  second.Culled.GetRenderer()->GetCullers()->RemoveItem(second.Culled.Culler);
  second.Culled.Culler = first.Culled.Culler;
  second.AddCuller();
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(first, 0.2 * i, "first");
    Scenes::FrameOfCity(second, 0.1 * i, "second");
    EXPECT_GE(first.GetHidden(), Wall::Hidden) << "statistics are kept per renderer";
    EXPECT_GT(second.GetHidden(), 10);
  }
  EXPECT_EQ(first.GetCuller()->GetNumberOfProps(), 101) << "the renderer culled last";
}

//------------------------------------------------------------------------------------------------
namespace
{
struct Stereo : NamedCase
{
  int Type;
};
using CullerStereo = testing::TestWithParam<Stereo>;
}

// Hazard: both eyes share camera object and renderer; what one sees the other need not.
TEST_P(CullerStereo, WallAndCity)
{
  ComparisonOptions options;
  options.CompareDraws = false;
  options.CompareDepth = false;
  // Stock VTK's culler tests both eyes with the frustum of the middle one and drops props at the
  // border of the window that an eye sees; the image without culler is the right one.
  options.KeepDefaultCuller = false;
  const auto stereo = [type = this->GetParam().Type](Stage& stage)
  {
    stage.Window->SetStereoCapableWindow(type == VTK_STEREO_CRYSTAL_EYES);
    stage.Window->SetStereoType(type);
    stage.Window->StereoRenderOn();
    stage.GetRenderer()->GetActiveCamera()->SetEyeAngle(6.0);
  };
  Comparison wall(
    [&](Stage& stage)
    {
      Scenes::BuildWall(stage);
      stereo(stage);
    },
    options);
  Comparison city(
    [&](Stage& stage)
    {
      Scenes::BuildCity(stage, 10);
      stereo(stage);
    },
    options);
  for (int i = 0; i < 5; ++i)
  {
    Scenes::FrameOfWall(wall, 0.4 * i, "wall");
    // The second eye of Fake sees what the first one has seen.
    EXPECT_TRUE(i == 0 || wall.GetDecision() == Decision::Culled ||
      (this->GetParam().Type == VTK_STEREO_FAKE && wall.GetDecision() == Decision::Still));
    EXPECT_TRUE(i == 0 || wall.GetHidden() > Wall::Behind / 2) << wall.GetHidden();
    Scenes::FrameOfCity(city, 0.1 * i, "city");
    // A camera learns that it is one of two eyes when it draws for the first time.
    EXPECT_TRUE(i == 0 || city.GetHidden() > 10) << city.GetHidden();
  }
  wall.Frame("still");
  wall.Frame("still");

  if (this->GetParam().Type == VTK_STEREO_CRYSTAL_EYES)
  {
    return; // VTK warns where the screen has no such stereo, even when it is switched off.
  }
  // VTK goes on to draw with the matrices of the last eye until the camera is modified.
  for (Comparison* scene : { &wall, &city })
  {
    scene->Frame("mono", [](Stage& stage) { stage.Window->StereoRenderOff(); });
    for (int i = 0; i < 4; ++i)
    {
      // Something that changes lets the props be tested anew.
      scene->Frame("mono",
        [i](Stage& stage) { stage.GetRenderer()->GetActors()->GetLastActor()->SetScale(1.0 + i); });
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, CullerStereo,
  testing::Values(Stereo{ "CrystalEyes", VTK_STEREO_CRYSTAL_EYES },
    Stereo{ "RedBlue", VTK_STEREO_RED_BLUE }, Stereo{ "Anaglyph", VTK_STEREO_ANAGLYPH },
    Stereo{ "Interlaced", VTK_STEREO_INTERLACED }, Stereo{ "Dresden", VTK_STEREO_DRESDEN },
    Stereo{ "Checkerboard", VTK_STEREO_CHECKERBOARD },
    Stereo{ "Split", VTK_STEREO_SPLITVIEWPORT_HORIZONTAL }, Stereo{ "Left", VTK_STEREO_LEFT },
    Stereo{ "Right", VTK_STEREO_RIGHT }, Stereo{ "Fake", VTK_STEREO_FAKE },
    Stereo{ "Emulate", VTK_STEREO_EMULATE }),
  GetCaseName);

//------------------------------------------------------------------------------------------------
namespace
{
struct Projection : NamedCase
{
  std::function<void(vtkCamera*)> Set;
  bool WallHidesAll;
};
using CullerProjections = testing::TestWithParam<Projection>;
}

// Hazard: the projection matrix is an unusual one. Every setting of the camera that enters it is
// tested; in parallel projection w is 1.
TEST_P(CullerProjections, Wall)
{
  Comparison comparison(Scenes::BuildWall);
  Scenes::FrameOfWall(comparison, 0.0, "before");
  for (int i = 0; i < 4; ++i)
  {
    Scenes::MoveWallCamera(comparison, 0.15 * i);
    comparison.Frame("set",
      [this](Stage& stage)
      {
        this->GetParam().Set(stage.GetRenderer()->GetActiveCamera());
        stage.GetRenderer()->ResetCameraClippingRange();
      });
    comparison.Frame("still");
    if (this->GetParam().WallHidesAll)
    {
      EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    }
  }
}

const Projection Projections[] = {
  { "Parallel",
    [](vtkCamera* camera)
    {
      camera->ParallelProjectionOn();
      camera->SetParallelScale(5.0);
    },
    true },
  { "ParallelOblique",
    [](vtkCamera* camera)
    {
      camera->ParallelProjectionOn();
      camera->SetParallelScale(4.0);
      camera->SetObliqueAngles(60.0, 70.0);
    },
    false },
  { "WideAngle", [](vtkCamera* camera) { camera->SetViewAngle(120.0); }, true },
  { "NarrowAngle", [](vtkCamera* camera) { camera->SetViewAngle(4.0); }, false },
  { "HorizontalAngle",
    [](vtkCamera* camera)
    {
      camera->UseHorizontalViewAngleOn();
      camera->SetViewAngle(50.0);
    },
    true },
  { "WindowCenter", [](vtkCamera* camera) { camera->SetWindowCenter(0.4, -0.3); }, true },
  { "Rolled", [](vtkCamera* camera) { camera->SetRoll(33.0); }, true },
  { "ViewShear", [](vtkCamera* camera) { camera->SetViewShear(0.2, -0.1, 1.0); }, false },
  { "UserViewTransform",
    [](vtkCamera* camera)
    {
      vtkNew<vtkTransform> transform;
      transform->RotateZ(20.0);
      transform->Translate(0.3, 0.0, 0.0);
      camera->SetUserViewTransform(transform);
    },
    true },
  { "UserTransform",
    [](vtkCamera* camera)
    {
      vtkNew<vtkTransform> transform;
      transform->Scale(1.2, 0.9, 1.0);
      camera->SetUserTransform(transform);
    },
    true },
  { "ModelTransform",
    [](vtkCamera* camera)
    {
      vtkNew<vtkTransform> transform;
      transform->RotateY(3.0);
      transform->Scale(1.1, 1.1, 1.1);
      camera->SetModelTransformMatrix(transform->GetMatrix());
    },
    false },
  { "OffAxis",
    [](vtkCamera* camera)
    {
      camera->SetScreenBottomLeft(-2.0, -1.0, 0.0);
      camera->SetScreenBottomRight(2.0, -1.0, 0.0);
      camera->SetScreenTopRight(2.0, 1.0, 0.0);
      camera->SetUseOffAxisProjection(true);
    },
    false },
  { "ExplicitMatrix",
    [](vtkCamera* camera)
    {
      vtkNew<vtkMatrix4x4> matrix;
      matrix->Identity();
      matrix->SetElement(0, 0, 2.0);
      matrix->SetElement(1, 1, 3.5);
      matrix->SetElement(2, 2, -1.1);
      matrix->SetElement(2, 3, -12.0);
      matrix->SetElement(3, 2, -1.0);
      matrix->SetElement(3, 3, 0.0);
      camera->SetExplicitProjectionTransformMatrix(matrix);
      camera->SetUseExplicitProjectionTransformMatrix(true);
    },
    true },
};
INSTANTIATE_TEST_SUITE_P(Each, CullerProjections, testing::ValuesIn(Projections), GetCaseName);

// Hazard: tiled rendering changes the projection of an unchanged camera, tile by tile.
TEST(CullerWindows, TiledWindow)
{
  Comparison comparison(Scenes::BuildWall, Size(200, 120));
  for (int tile = 0; tile < 4; ++tile)
  {
    comparison.Frame("tile " + std::to_string(tile),
      [tile](Stage& stage)
      {
        const double x = 0.5 * (tile % 2);
        const double y = 0.5 * (tile / 2);
        stage.Window->SetTileScale(2);
        stage.Window->SetTileViewport(x, y, x + 0.5, y + 0.5);
      });
    EXPECT_GT(comparison.GetHidden(), 0);
  }
}

// Hazard: a camera shared by two renderers whose aspect differs gives two projections.
TEST(CullerWindows, OneCameraTwoAspects)
{
  Comparison comparison(
    [](Stage& stage)
    {
      stage.GetRenderer()->SetViewport(0.0, 0.0, 0.2, 1.0);
      Scenes::BuildWall(stage);
      vtkRenderer* wide = stage.AddRenderer(0.2, 0.0, 1.0, 1.0);
      Scenes::AddWall(stage, wide);
      wide->SetActiveCamera(stage.GetRenderer()->GetActiveCamera());
    });
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.3 * i);
    EXPECT_GE(comparison.GetHidden(1), Wall::Hidden);
  }
}
