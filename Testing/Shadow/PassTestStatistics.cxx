// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// What a frame costs, from nothing on, and the OpenGL state that it leaves.
#include "LightRig.h"
#include "PassTestTools.h"
#include "SceneBuilder.h"
#include "Tune.h"

#include "vtkNBufferGL.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderStepsPass.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace
{
/// What differs in the stage's renderer alone: what lies beside it, in a tile of a larger image, is
/// not drawn at all.
std::string FindDifferenceInView(const Stage& stage, const Picture& expected, const Picture& actual)
{
  const vtkNBufferRectangle view = GetPixels(stage.GetRenderer());
  const int region[4] = { view.X0, view.Y0, view.GetWidth(), view.GetHeight() };
  return FindDifference(expected, actual, region);
}

/// Adds a sphere above the scene.
void AddSphere(const Stage& stage, int meridians, int parallels)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(meridians);
  sphere->SetPhiResolution(parallels);
  sphere->SetRadius(0.2);
  sphere->SetCenter(0.0, 0.0, 2.0);
  sphere->Update();
  AddMesh(stage.GetRenderer(), sphere->GetOutput());
}

/// No volume, litmap or read-back, and nothing cached anew.
::testing::AssertionResult DidNothing(const vtkShadowStatistics& statistics)
{
  const bool nothing = statistics.Draws == 0 && statistics.Triangles == 0 &&
    statistics.Litmaps == 0 && statistics.Receivers == 0 && statistics.ReadBacks == 0 &&
    statistics.Silhouettes == 0 && statistics.Updates == 0 && statistics.Pieces == 0 &&
    std::count(statistics.Verdicts.begin(), statistics.Verdicts.end(), 0) ==
      vtkShadowStatistics::NumberOfVerdicts;
  return (nothing ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
    << statistics.GetAsJSON();
}
}

using PassStatistics = OffscreenFixture;

// Without a light that casts, or without a caster, the pass draws nothing and makes no OpenGL
// objects.
TEST_F(PassStatistics, NothingDueCostsNothing)
{
  for (const bool withLight : { false, true })
  {
    SCOPED_TRACE(withLight ? "no caster" : "no light");
    const Stage stage = SetNamedStage("ManyLights");
    vtkNew<vtkRenderStepsPass> steps;
    stage.GetRenderer()->SetPass(steps);
    stage.Window->Render();
    stage.Window->Render();
    const GLObjects::Counts before = CountObjects(stage);
    vtkNew<vtkShadowVolumeClampPass> pass;
    pass->SetCasterKeys(withLight ? TestScene::LightRig::MakeCasterKeys() : nullptr);
    for (vtkLight* light : stage.Lights)
    {
      pass->SetLightCasts(light, withLight);
    }
    stage.GetRenderer()->SetPass(pass);
    for (int frame = 0; frame < 3; ++frame)
    {
      stage.GetRenderer()->GetActiveCamera()->Azimuth(5.0);
      stage.Window->Render();
      EXPECT_TRUE(DidNothing(pass->GetStatistics()));
      EXPECT_EQ(pass->GetStatistics().Decision,
        withLight ? vtkShadowDecision::NoCaster : vtkShadowDecision::NoLight);
    }
    EXPECT_EQ(CountObjects(stage), before);
  }
}

// A still frame uses the masks of the last one, and a moving camera makes no new objects.
TEST_F(PassStatistics, FramesMakeNoNewObjects)
{
  for (const int mode : ShadowModes)
  {
    SCOPED_TRACE("mode " + std::to_string(mode));
    const Stage stage = SetNamedStage("ManyLights");
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    pass->SetMode(mode);
    for (int frame = 0; frame < 3; ++frame)
    {
      stage.Window->Render();
    }
    const GLObjects::Counts before = CountObjects(stage);
    for (int frame = 0; frame < 3; ++frame)
    {
      stage.Window->Render();
      EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Still);
      EXPECT_TRUE(DidNothing(pass->GetStatistics()));
    }
    for (int frame = 0; frame < 3; ++frame)
    {
      stage.GetRenderer()->GetActiveCamera()->Azimuth(5.0);
      stage.Window->Render();
      EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
    }
    EXPECT_EQ(CountObjects(stage), before);
  }
}

TEST_F(PassStatistics, FragmentsAreCountedOnlyIfSwitchedOn)
{
  const Stage stage = SetNamedStage("Directional");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  stage.Window->Render();
  EXPECT_EQ(pass->GetStatistics().Fragments, -1);
  const Picture expected = TakePicture(stage.Window);
  Tune(pass, &vtkShadowTuning::CountFragments, true);
  stage.Window->Render();
  EXPECT_GT(pass->GetStatistics().Fragments, 0);
  EXPECT_EQ(FindDifference(expected, TakePicture(stage.Window)), "");
}

// With few casters litmaps take more time than they save: there must be no read-back and no litmap,
// and the same picture. With many triangles the costs of the device decide about each light.
TEST_F(PassStatistics, AutomaticMakesLitmapsWhereTheyPay)
{
  const Stage stage = SetNamedStage("ManyLights");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const vtkShadowStatistics& statistics = pass->GetStatistics();
  Tune(pass, &vtkShadowTuning::LitmapResolution, 80);
  const auto isPoint = [](vtkLight* light)
  { return light->GetPositional() && light->GetConeAngle() >= 90.0; };
  const auto lights = static_cast<int>(stage.Lights.size());
  const auto points =
    static_cast<int>(std::count_if(stage.Lights.begin(), stage.Lights.end(), isPoint));
  ASSERT_GT(points, 0);
  ASSERT_LT(points, lights);
  const auto expectSamePictures = [&]()
  {
    pass->SetMode(vtkShadowVolumeClampPass::Scissored);
    const Picture expected = RenderPicture(stage);
    EXPECT_EQ(statistics.Litmaps, lights + 5 * points);
    EXPECT_EQ(statistics.UnclampedLights, 0);
    EXPECT_EQ(FindInconsistency(statistics), "");
    pass->SetMode(vtkShadowVolumeClampPass::Automatic);
    EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
    EXPECT_EQ(FindInconsistency(statistics), "");
  };
  expectSamePictures();
  EXPECT_EQ(statistics.UnclampedLights, lights);
  EXPECT_EQ(statistics.ReadBacks, 0);

  AddSphere(stage, 300, 150);
  expectSamePictures();
  int litmaps = 0;
  int unclamped = 0;
  ASSERT_EQ(statistics.LightCosts.size(), stage.Lights.size());
  for (std::size_t i = 0; i < stage.Lights.size(); ++i)
  {
    const vtkShadowLightCost& cost = statistics.LightCosts[i];
    EXPECT_EQ(cost.HasLitmaps, 2.0 / 3.0 * cost.WholeEstimate > cost.LitmapEstimate) << i;
    litmaps += !cost.HasLitmaps ? 0 : isPoint(stage.Lights[i]) ? 6 : 1;
    unclamped += !cost.HasLitmaps;
  }
  EXPECT_EQ(statistics.Litmaps, litmaps);
  EXPECT_EQ(statistics.UnclampedLights, unclamped);
}

// Hazard: without a litmap the volumes of all casters around a spot are drawn, most of which shadow
// nothing that it lights; or one that does is left out.
TEST_F(PassStatistics, AutomaticLeavesOutCastersBesideTheCone)
{
  const Stage stage = SetStage(
    [](SceneBuilder& scene)
    {
      scene.Box({ 0.0, 0.0, -0.1 }, { 20.0, 20.0, 0.2 });
      scene.Box({ 0.3, 0.2, 1.0 }, { 0.6, 0.6, 0.6 });
      for (int i = 0; i < 5; ++i)
      {
        scene.Box({ 2.0 * i - 4.0, 0.0, 8.0 }, { 0.5, 0.5, 0.5 }); // behind the light
      }
      scene.Spot({ 0.0, 0.0, 5.0 }, { 0.0, 0.0, 0.0 }, 20.0);
    });
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  pass->SetMode(vtkShadowVolumeClampPass::Unclamped);
  const Picture expected = RenderPicture(stage);
  EXPECT_EQ(pass->GetStatistics().GetCount(vtkShadowVerdict::OutsideCone), 0);
  pass->SetMode(vtkShadowVolumeClampPass::Automatic);
  EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
  EXPECT_EQ(pass->GetStatistics().UnclampedLights, 1);
  EXPECT_EQ(pass->GetStatistics().GetCount(vtkShadowVerdict::OutsideCone), 5);
  EXPECT_EQ(pass->GetStatistics().GetCount(vtkShadowVerdict::Whole), 2);
}

// Hazard: the frame in which the device is measured shows another image, or there is more than one;
// or the statistics do not say why a light has no litmaps.
TEST_F(PassStatistics, AutomaticMeasuresTheDeviceOnce)
{
  const Stage stage = SetNamedStage("Directional");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const auto render = [&](const char* when)
  {
    SCOPED_TRACE(when);
    stage.GetRenderer()->GetActiveCamera()->Azimuth(1.0);
    pass->SetMode(vtkShadowVolumeClampPass::Unclamped);
    const Picture expected = RenderPicture(stage);
    EXPECT_EQ(pass->GetStatistics().LightCosts.at(0).WholeEstimate, -1.0);
    pass->SetMode(vtkShadowVolumeClampPass::Automatic);
    EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
    const vtkShadowStatistics& statistics = pass->GetStatistics();
    EXPECT_EQ(statistics.Decision, vtkShadowDecision::Drawn);
    EXPECT_EQ(FindInconsistency(statistics), "");
    EXPECT_EQ(statistics.LightCosts.size(), 1u);
    const vtkShadowLightCost cost = statistics.LightCosts.at(0);
    EXPECT_EQ(cost.HasLitmaps, statistics.UnclampedLights == 0);
    EXPECT_EQ(cost.HasLitmaps, 2.0 / 3.0 * cost.WholeEstimate > cost.LitmapEstimate);
    EXPECT_GT(cost.LitmapEstimate, 0.0);
    EXPECT_GT(cost.Time, 0.0);
    return cost;
  };
  const vtkShadowLightCost few = render("a few casters");
  EXPECT_EQ(pass->GetStatistics().MeasureTime, 0.0);

  AddSphere(stage, 90, 60);
  EXPECT_GT(render("many triangles").WholeEstimate, 0.0);
  EXPECT_GT(pass->GetStatistics().MeasureTime, 0.0);
  for (int frame = 0; frame < 4; ++frame)
  {
    render("after that");
    EXPECT_EQ(pass->GetStatistics().MeasureTime, 0.0) << frame;
  }
  GetActors(stage.GetRenderer()).back()->VisibilityOff();
  EXPECT_NE(render("the few casters again").LitmapEstimate, few.LitmapEstimate);
}

// Silhouettes are kept until mesh, matrix or light changes, and then only those are made again that
// depend on the change.
TEST_F(PassStatistics, SilhouettesAreMadeOnce)
{
  const Stage stage = SetNamedStage("ManyLights");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const auto expect = [&](int updates, int silhouettes, const char* what)
  {
    stage.Window->Render();
    const vtkShadowStatistics& statistics = pass->GetStatistics();
    EXPECT_EQ(statistics.Decision, vtkShadowDecision::Drawn) << what;
    EXPECT_EQ(statistics.Updates, updates) << what;
    EXPECT_EQ(statistics.Silhouettes, silhouettes) << what;
  };
  const int lights = static_cast<int>(stage.Lights.size());
  const int casters = stage.GetRenderer()->GetActors()->GetNumberOfItems();
  expect(casters, casters * lights, "the first frame");
  stage.GetRenderer()->GetActiveCamera()->Azimuth(5.0);
  expect(0, 0, "the camera moved");
  stage.GetRenderer()->GetActiveCamera()->ParallelProjectionOn();
  expect(0, 0, "the camera became parallel");
  pass->SetMode(vtkShadowVolumeClampPass::Clamped);
  expect(0, 0, "another mode");
  stage.Lights[1]->SetPosition(-4.5, -2.0, 5.0);
  expect(0, casters, "a light moved");
  stage.Lights[1]->SetColor(1.0, 0.5, 0.5);
  stage.GetRenderer()->GetActiveCamera()->Azimuth(5.0);
  expect(0, 0, "a light's colour");
  vtkActor* actor = GetActors(stage.GetRenderer()).back();
  actor->AddPosition(0.1, 0.0, 0.0);
  expect(1, lights, "an actor moved");
  auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
  mesh->GetPoints()->SetPoint(0, 0.3, -1.2, 1.7);
  mesh->GetPoints()->Modified();
  expect(1, lights, "points moved");
}

// Whole volumes are kept as long as silhouettes, in every mode that draws them.
TEST_F(PassStatistics, VolumesAreMadeOnce)
{
  for (const int mode : { vtkShadowVolumeClampPass::Unclamped, vtkShadowVolumeClampPass::Culled,
         vtkShadowVolumeClampPass::Scissored, vtkShadowVolumeClampPass::Automatic })
  {
    SCOPED_TRACE(mode);
    const Stage stage = SetNamedStage("ManyLights");
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    pass->SetMode(mode);
    const auto render = [&]() -> const vtkShadowStatistics&
    {
      stage.Window->Render();
      EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
      return pass->GetStatistics();
    };
    EXPECT_GT(render().Pieces, 0);
    vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
    camera->Azimuth(1.0);
    render(); // It may draw casters that the first frame did not.
    camera->Azimuth(-1.0);
    EXPECT_EQ(render().Pieces, 0) << "the camera moved";
    EXPECT_GT(pass->GetStatistics().Draws, 0);
    vtkActor* actor = GetActors(stage.GetRenderer()).back();
    actor->AddPosition(0.01, 0.0, 0.0);
    const int lights = static_cast<int>(stage.Lights.size());
    EXPECT_LE(render().Pieces, lights) << "an actor moved";
    if (mode == vtkShadowVolumeClampPass::Unclamped)
    {
      EXPECT_EQ(pass->GetStatistics().Pieces, lights);
    }
    camera->Azimuth(1.0);
    EXPECT_EQ(render().Pieces, 0);
  }
}

// There are more casters than one thread processes.
TEST_F(PassStatistics, ManyCastersAreSharedOut)
{
  constexpr int side = 66;
  const Stage stage = SetStage(
    [](SceneBuilder& scene)
    {
      scene.Floor(10.0);
      for (int i = 0; i < side * side; ++i)
      {
        const double x = 0.25 * (i % side - side / 2);
        const double y = 0.25 * (i / side - side / 2);
        scene.Box({ x, y, 0.2 + 0.1 * (i % 7) }, { 0.1, 0.1, 0.1 });
      }
      scene.Directional({ 0.3, 0.2, -1.0 });
      scene.Spot({ 0.0, 0.0, 5.0 }, { 1.0, 1.0, 0.0 }, 30.0);
      scene.PointLight({ -1.0, 2.0, 4.0 });
      scene.Look({ 2.0, 1.0, 3.0 }, { 0.0, 0.0, 0.0 });
    },
    120, 90);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const int casters = stage.GetRenderer()->GetActors()->GetNumberOfItems();
  const int lights = static_cast<int>(stage.Lights.size());
  std::vector<Picture> images;
  int silhouettes = casters * lights;
  for (const int mode : ShadowModes)
  {
    pass->SetMode(mode);
    stage.Window->Render();
    const vtkShadowStatistics& statistics = pass->GetStatistics();
    EXPECT_EQ(statistics.Silhouettes, silhouettes);
    EXPECT_EQ(FindInconsistency(statistics), "");
    EXPECT_EQ(statistics.Draws < casters * lights, mode != vtkShadowVolumeClampPass::Unclamped);
    EXPECT_GT(statistics.Draws, 0);
    silhouettes = 0;
    for (const ShadowMask& mask : GetMasks(stage, pass))
    {
      EXPECT_GT(CountShadowed(mask), 0);
    }
    images.push_back(TakePicture(stage.Window));
  }
  EXPECT_EQ(FindDifference(images[0], images[1]), "");
}

using PassWork = OffscreenFixtureWithParam<NamedScenario>;

// Every caster has a verdict for each light, and no mode draws more than one that knows less.
TEST_P(PassWork, IsLessTheMoreIsKnown)
{
  const NamedScenario& scene = this->GetParam();
  const Stage stage = SetStage(scene);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  Tune(pass, &vtkShadowTuning::CountFragments, true);
  std::map<int, long long> fragments;
  for (const int mode : ShadowModes)
  {
    pass->SetMode(mode);
    stage.Window->Render();
    const vtkShadowStatistics& statistics = pass->GetStatistics();
    EXPECT_EQ(FindInconsistency(statistics), "");
    fragments[mode] = statistics.Fragments;
  }
  const long long unclamped = fragments[vtkShadowVolumeClampPass::Unclamped];
  const long long scissored = fragments[vtkShadowVolumeClampPass::Scissored];
  const long long clamped = fragments[vtkShadowVolumeClampPass::Clamped];
  std::cout << scene.Name << ": " << unclamped << " fragments, scissored "
            << 100.0 * scissored / unclamped << " %, clamped " << 100.0 * clamped / unclamped
            << " %\n";
  pass->SetMode(vtkShadowVolumeClampPass::Culled);
  stage.Window->Render();
  const long long culled = pass->GetStatistics().Fragments;
  const Picture image = TakePicture(stage.Window);
  pass->SetMode(vtkShadowVolumeClampPass::Scissored);
  EXPECT_EQ(FindDifferenceInView(stage, image, RenderPicture(stage)), "");
  EXPECT_GT(unclamped, 0);
  EXPECT_LE(culled, unclamped);
  EXPECT_LE(scissored, culled);
  const std::vector<NamedScenario> large = TestScene::GetLargeScenarios();
  if (std::any_of(large.begin(), large.end(),
        [&scene](const NamedScenario& other) { return other.Name == scene.Name; }))
  {
    EXPECT_LE(clamped, scissored);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PassWork, ::testing::ValuesIn(GetScenarios()),
  [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------------------------
using PassState = OffscreenFixture;

// The state of OpenGL, and VTK's record of it, are those after a frame without shadows, except for
// the program of the mapper that drew last, and for textures in units that nothing uses.
TEST_F(PassState, IsThatOfAFrameWithoutShadows)
{
  for (const char* name : { "ManyLights", "Inset", "MultiSamples" })
  {
    SCOPED_TRACE(name);
    const Stage stage = SetNamedStage(name);
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    for (vtkLight* light : stage.Lights)
    {
      pass->SetLightCasts(light, false);
    }
    CaptureFrame(stage);
    const GLStateSnapshot plain = CaptureFrame(stage);
    for (vtkLight* light : stage.Lights)
    {
      pass->SetLightCasts(light, true);
    }
    for (const int mode : ShadowModes)
    {
      SCOPED_TRACE("mode " + std::to_string(mode));
      pass->SetMode(mode);
      for (int frame = 0; frame < 4; ++frame)
      {
        const GLStateSnapshot shadowed = CaptureFrame(stage);
        std::istringstream lines(plain.GetDifference(shadowed));
        for (std::string line; std::getline(lines, line);)
        {
          const bool expected = line.find("GL_CURRENT_PROGRAM") == 0 ||
            line.find("GL_TEXTURE_BINDING_2D of unit ") == 0 ||
            line.find("GL_TEXTURE_BINDING_2D_MULTISAMPLE of unit ") == 0 ||
            line.find("vtkOpenGLShaderCache LastShaderBound") == 0;
          EXPECT_TRUE(expected) << line;
        }
      }
    }
  }
}
