// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Colours with vtkShadowVolumeClampPass, to the byte those of images without it.
#include "Fill.h"
#include "LightRig.h"
#include "PassTestTools.h"
#include "ScenePasses.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkSelectVisiblePoints.h"
#include "vtkSkybox.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTranslucentPass.h"

#include <algorithm>
#include <cmath>

namespace
{
/// A headlight, a light that is off, a camera light, and one more than fit into a mask.
void AddLights(SceneBuilder& scene)
{
  const auto add = [&scene](TestScene::LightKind kind, double intensity)
  {
    TestScene::Light& light = scene.Directional({ 0.0, 0.0, -1.0 });
    light.Kind = kind;
    light.Position = { 1.0, 1.0, 1.0 };
    light.Intensity = intensity;
  };
  add(TestScene::LightKind::Headlight, 0.25);
  scene.Directional({ 0.0, 0.0, -1.0 }).On = false;
  add(TestScene::LightKind::Camera, 0.5);
  scene.Directional({ 0.6, 0.35, -0.7 }).Intensity = 0.25;
  scene.Spot({ -4.0, -2.0, 5.0 }, { 0.0, 0.0, 0.0 }, 25.0).Intensity = 0.5;
  scene.Directional({ -0.6, 0.35, -0.7 }).On = false;
  scene.PointLight({ -0.1, 0.2, 2.2 }).Intensity = 0.25;
  scene.Directional({ -0.6, 0.35, -0.7 }).Intensity = 0.25;
}

/// Selects the visible points while it is drawn, as labels of vtkLabeledDataMapper do.
class PointLabels : public vtkActor2D
{
public:
  static PointLabels* New();
  vtkTypeMacro(PointLabels, vtkActor2D);

  vtkNew<vtkSelectVisiblePoints> Visible;

  int RenderOpaqueGeometry(vtkViewport*) override
  {
    this->Visible->Update();
    return 0;
  }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return false; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 0; }
  int RenderOverlay(vtkViewport*) override { return 0; }
};
vtkStandardNewMacro(PointLabels);

/// Counts how often its translucent geometry is drawn, and does not say that it has any.
class TranslucentUnawares : public vtkActor2D
{
public:
  static TranslucentUnawares* New();
  vtkTypeMacro(TranslucentUnawares, vtkActor2D);

  int Draws = 0;

  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return false; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override
  {
    ++this->Draws;
    return 0;
  }
  int RenderOverlay(vtkViewport*) override { return 0; }
};
vtkStandardNewMacro(TranslucentUnawares);

NamedScenario GetColourScene(const std::string& name)
{
  if (name != "SixLights")
  {
    return GetScenario(name);
  }
  NamedScenario scene = GetScenario("Directional");
  SceneBuilder builder;
  builder.Scene = scene.Scenario;
  AddLights(builder);
  scene.Scenario = builder.Scene;
  return scene;
}
}

using PassColours = OffscreenFixtureWithParam<const char*>;

// Where a light does not reach, the colour is that of the image without this light; elsewhere it is
// that of the image without shadows. This must be so for all lights, ways of shading and
// attenuations.
TEST_P(PassColours, AreThoseOfDimmedLights)
{
  Stage stage = SetStage(GetColourScene(this->GetParam()));
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  for (const bool physicallyBased : { false, true })
  {
    SCOPED_TRACE(physicallyBased ? "PBR" : "Phong");
    for (vtkActor* actor : GetActors(stage.GetRenderer()))
    {
      actor->GetProperty()->SetInterpolation(physicallyBased ? VTK_PBR : VTK_PHONG);
      actor->GetProperty()->SetSpecular(0.5);
      actor->GetProperty()->SetRoughness(0.4);
    }
    for (const double attenuation : { 1.0, 0.5, 0.0 })
    {
      SCOPED_TRACE("attenuation " + std::to_string(attenuation));
      double next = attenuation;
      for (vtkLight* light : stage.Lights)
      {
        light->SetShadowAttenuation(next);
        next = next == 0.0 ? 1.0 : next - 0.5;
      }
      EXPECT_GT(ExpectComposedOfDimmed(stage, pass), 100);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PassColours,
  ::testing::Values("Directional", "Spot", "Point", "ManyLights", "SixLights", "SpotExponent",
    "MultiSamples", "Inset", "OddSize", "ParallelCamera", "LightInRoom", "Composite"),
  [](const auto& info) { return info.param; });

using PassImages = OffscreenFixture;

// Hazard: the pass changes images in which nothing is in shadow.
TEST_F(PassImages, WithoutShadowAreThoseWithoutThePass)
{
  const std::pair<const char*, std::function<void(const Stage&, vtkShadowVolumeClampPass*)>>
    ways[] = {
      { "no casting light",
        [](const Stage& stage, vtkShadowVolumeClampPass*)
        { stage.Lights[0]->SetLightTypeToHeadlight(); } },
      { "a light that may not cast",
        [](const Stage& stage, vtkShadowVolumeClampPass* pass)
        { pass->SetLightCasts(stage.Lights[0], false); } },
      { "no caster",
        [](const Stage&, vtkShadowVolumeClampPass* pass)
        { pass->SetCasterKeys(TestScene::LightRig::MakeCasterKeys()); } },
      { "casters that are translucent",
        [](const Stage& stage, vtkShadowVolumeClampPass*)
        {
          for (vtkActor* actor : GetActors(stage.GetRenderer()))
          {
            actor->GetProperty()->SetOpacity(0.5);
          }
        } },
      { "no receiver",
        [](const Stage& stage, vtkShadowVolumeClampPass*)
        {
          TestScene::SetView(
            stage.GetRenderer(), SceneBuilder().Look({ 20.0, 0.0, 1.0 }, { 30.0, 0.0, 1.0 }));
        } },
      { "nothing at all",
        [](const Stage& stage, vtkShadowVolumeClampPass*)
        { stage.GetRenderer()->RemoveAllViewProps(); } },
    };
  for (const auto& way : ways)
  {
    SCOPED_TRACE(way.first);
    const Stage stage = SetNamedStage("Directional");
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    way.second(stage, pass);
    for (int frame = 0; frame < 2; ++frame)
    {
      const Picture actual = RenderPicture(stage);
      EXPECT_EQ(FindDifference(GetPlainImage(stage.Window, stage.GetRenderer()), actual), "");
      EXPECT_EQ(FindInconsistency(pass->GetStatistics()), "");
    }
  }
}

// In a sequence of passes, in the place of vtkOpaquePass, the image is the same.
TEST_F(PassImages, InASequenceAreThoseOfThePassAlone)
{
  for (const char* name : { "ManyLights", "Inset", "MultiSamples" })
  {
    SCOPED_TRACE(name);
    const Stage stage = SetNamedStage(name);
    Fill(stage.GetRenderer(),
      [](SceneBuilder& scene) {
        scene.Box({ 0.0, -2.5, 1.0 }, { 1.0, 0.2, 1.0 }).Opacity = 0.5;
      });
    const vtkSmartPointer<vtkShadowVolumeClampPass> alone = AddPass(stage);
    alone->GetSteps()->SetTranslucentPass(vtkNew<vtkTranslucentPass>()); // As in the sequence.
    const Picture expected = RenderPicture(stage);
    EXPECT_EQ(alone->GetStatistics().Decision, vtkShadowDecision::Drawn);
    EXPECT_NE(FindDifference(GetPlainImage(stage.Window, stage.GetRenderer()), expected), "");

    const vtkSmartPointer<vtkShadowVolumeClampPass> shadows = AddPass(stage);
    stage.GetRenderer()->SetPass(
      TestScene::MakePass(TestScene::PassKind::ShadowVolumesInSequence, shadows));
    for (int frame = 0; frame < 2; ++frame)
    {
      EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
      EXPECT_GT(shadows->GetNumberOfRenderedProps(), 0);
    }
  }
}

// Hazard: VTK pushes surfaces away from the eye, so that edges and decals show, but not the volumes
// that begin in these surfaces: the lit side of an open caster would be in its own shadow.
TEST_F(PassImages, CoincidentTopologyDarkensNothing)
{
  const Stage stage = SetNamedStage("Directional");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const auto getMask = [&]()
  {
    stage.Window->Render();
    int size[2];
    return pass->GetMask(stage.Lights[0], size[0], size[1]);
  };
  for (const int mode : { vtkShadowVolumeClampPass::Unclamped, vtkShadowVolumeClampPass::Automatic,
         vtkShadowVolumeClampPass::Clamped })
  {
    pass->SetMode(mode);
    vtkMapper::SetResolveCoincidentTopologyToOff();
    const std::vector<unsigned char> expected = getMask();
    for (const double offset : { 1.0, 4.0, -4.0 })
    {
      SCOPED_TRACE(offset);
      for (vtkActor* actor : GetActors(stage.GetRenderer()))
      {
        actor->GetMapper()->SetResolveCoincidentTopology(VTK_RESOLVE_POLYGON_OFFSET);
        actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(offset, offset);
      }
      const std::vector<unsigned char> mask = getMask();
      ASSERT_EQ(mask.size(), expected.size());
      std::size_t differing = 0;
      for (std::size_t i = 0; i < mask.size(); ++i)
      {
        differing += mask[i] != expected[i];
      }
      // Where two surfaces meet, the other one may have the pixel.
      EXPECT_LT(differing, mask.size() / 1000) << "of " << mask.size();
      EXPECT_GT(ExpectComposedOfDimmed(stage, pass), 0) << "the picture has the offsets";
    }
  }
  vtkMapper::SetResolveCoincidentTopologyToDefault();
}

// Hazard: where front faces are not drawn, the inside of a closed caster is seen, which no light
// reaches.
TEST_F(PassImages, InsidesThatAreSeenAreDark)
{
  const Stage stage = SetStage(
    [](SceneBuilder& scene)
    {
      scene.Floor(5.0);
      scene.Sphere({ 0.0, 0.0, 1.5 }, 1.0);
      scene.Box({ 0.0, 0.0, 1.5 }, { 0.4, 0.4, 0.4 });
      scene.Directional({ 0.3, 0.2, -1.0 });
      scene.Look({ 0.0, -6.0, 4.0 }, { 0.0, 0.0, 1.5 });
    },
    200, 150);
  const vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const auto getMiddle = [&]
  {
    stage.Window->Render();
    return GetMask(stage, pass)[200 * 75 + 100];
  };
  EXPECT_EQ(getMiddle(), 0) << "the sphere, from outside";
  for (const int mode : ShadowModes)
  {
    pass->SetMode(mode);
    GetActors(stage.GetRenderer())[1]->GetProperty()->FrontfaceCullingOn();
    EXPECT_EQ(getMiddle(), 255) << "the box in it";
    GetActors(stage.GetRenderer())[1]->GetProperty()->FrontfaceCullingOff();
    EXPECT_EQ(getMiddle(), 0);
    // Mirrored, the front faces are back faces for the device.
    GetActors(stage.GetRenderer())[1]->SetScale(-1.0, 1.0, 1.0);
    GetActors(stage.GetRenderer())[1]->GetProperty()->BackfaceCullingOn();
    EXPECT_EQ(getMiddle(), 255) << "the box in the mirrored sphere";
    GetActors(stage.GetRenderer())[1]->SetScale(1.0);
    EXPECT_EQ(getMiddle(), 0);
    GetActors(stage.GetRenderer())[1]->GetProperty()->BackfaceCullingOff();
  }
}

// Hazard: labels read the depth that has been drawn before them, and the pass draws the receivers'
// depth elsewhere before it draws anything into the window.
TEST_F(PassImages, LabelsFindTheVisiblePoints)
{
  const Stage stage = SetStage(
    [](SceneBuilder& scene)
    {
      scene.Floor(5.0);
      scene.Sphere({ 0.0, 0.0, 1.5 }, 1.0);
      scene.Directional({ 0.3, 0.2, -1.0 });
      scene.Look({ 0.0, -6.0, 4.0 }, { 0.0, 0.0, 1.5 });
    },
    200, 150);
  vtkNew<vtkSphereSource> points; // around the sphere
  points->SetCenter(0.0, 0.0, 1.5);
  points->SetRadius(1.2);
  points->SetThetaResolution(12);
  points->SetPhiResolution(12);
  vtkNew<PointLabels> labels;
  labels->Visible->SetInputConnection(points->GetOutputPort());
  labels->Visible->SetTolerance(1e-4);
  labels->Visible->SetRenderer(stage.GetRenderer());
  stage.GetRenderer()->AddViewProp(labels);
  stage.Window->Render();
  const auto count = [&]
  {
    labels->Visible->Modified();
    stage.Window->Render();
    return labels->Visible->GetOutput()->GetNumberOfPoints();
  };
  const vtkIdType expected = count();
  EXPECT_GT(expected, 20);
  EXPECT_LT(expected, points->GetOutput()->GetNumberOfPoints() - 20);
  const vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  EXPECT_EQ(count(), expected) << "masks are made";
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
  EXPECT_EQ(count(), expected) << "masks are used again";
}

// Hazard: translucent props look different, or the image is not smoothed, when shadows are switched
// on: VTK's own passes draw less than a renderer without a pass.
TEST_F(PassImages, LaterStagesAreThoseOfTheRenderer)
{
  using Change = void (*)(vtkRenderer*);
  const std::pair<const char*, Change> ways[] = { { "default", [](vtkRenderer*) {} },
    { "depth peeling", [](vtkRenderer* renderer) { renderer->UseDepthPeelingOn(); } },
    { "depth peeling of volumes",
      [](vtkRenderer* renderer)
      {
        renderer->UseDepthPeelingOn();
        renderer->UseDepthPeelingForVolumesOn();
      } },
    { "FXAA", [](vtkRenderer* renderer) { renderer->UseFXAAOn(); } } };
  for (const auto& [name, change] : ways)
  {
    SCOPED_TRACE(name);
    const Stage stage = SetNamedStage("Directional");
    vtkRenderer* renderer = stage.GetRenderer();
    for (vtkLight* light : stage.Lights)
    {
      light->SetShadowAttenuation(0.0);
    }
    const std::vector<vtkActor*> actors = GetActors(renderer);
    for (std::size_t i = 1; i < actors.size(); ++i)
    {
      const auto copy = vtkSmartPointer<vtkActor>::New();
      copy->ShallowCopy(actors[i]);
      copy->SetProperty(vtkNew<vtkProperty>());
      copy->GetProperty()->SetColor(1.0, 0.2 * static_cast<double>(i), 0.0);
      copy->GetProperty()->SetOpacity(0.5);
      copy->AddPosition(0.1, -0.4, 0.3);
      renderer->AddActor(copy);
    }
    change(renderer);
    const Picture expected = RenderPicture(stage);
    renderer->SetPass(vtkNew<vtkRenderStepsPass>());
    EXPECT_NE(FindDifference(expected, RenderPicture(stage)), "");
    const vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
    EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
    renderer->SetPass(nullptr);
    EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
  }
}

// Hazard: a renderer that draws nothing smooths what lies below it when shadows are switched on.
TEST_F(PassImages, NothingIsSmoothedWhereNothingIsDrawn)
{
  Stage stage = SetNamedStage("Directional");
  stage.Window->SetNumberOfLayers(2);
  vtkRenderer* layer = stage.AddRenderer(0.0, 0.0, 1.0, 1.0, 1);
  layer->UseFXAAOn();
  const Picture expected = RenderPicture(stage);
  layer->SetPass(vtkNew<vtkShadowVolumeClampPass>());
  EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
}

// Hazard: a prop appears when shadows are switched on, such as the 3D text of PyVista's grid, which
// is translucent and does not say so. Without a translucent prop the renderer leaves the stage out.
TEST_F(PassImages, TheTranslucentStageIsDrawnWhereTheRendererDrawsIt)
{
  const Stage stage = SetNamedStage("Directional");
  vtkRenderer* renderer = stage.GetRenderer();
  vtkNew<TranslucentUnawares> prop;
  renderer->AddViewProp(prop);
  const auto count = [&]
  {
    const int before = prop->Draws;
    stage.Window->Render();
    return prop->Draws - before;
  };
  for (const double opacity : { 1.0, 0.5 })
  {
    SCOPED_TRACE(opacity);
    GetActors(renderer)[1]->GetProperty()->SetOpacity(opacity);
    renderer->SetPass(nullptr);
    const int expected = count();
    EXPECT_EQ(expected > 0, opacity < 1.0);
    AddPass(stage);
    EXPECT_EQ(count(), expected);
  }
}

// Hazard: a skybox casts a shadow as if its mesh were in the scene, or a shadow is seen on it.
TEST_F(PassImages, SkyboxesNeitherCastNorReceive)
{
  for (const int projection : { vtkSkybox::Cube, vtkSkybox::Sphere, vtkSkybox::Floor })
  {
    SCOPED_TRACE(projection);
    const Stage stage = SetNamedStage("Directional");
    vtkNew<vtkTexture> texture;
    vtkNew<vtkImageData> image;
    image->SetDimensions(8, 8, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int i = 0; i < 8 * 8 * 3; ++i)
    {
      values[i] = static_cast<unsigned char>(37 * i);
    }
    const bool isCube = projection == vtkSkybox::Cube;
    texture->SetCubeMap(isCube);
    for (int side = 0; side < (isCube ? 6 : 1); ++side)
    {
      texture->SetInputDataObject(side, image);
    }
    vtkNew<vtkSkybox> skybox;
    skybox->SetProjection(projection);
    skybox->SetFloorPlane(0.0F, 0.0F, 1.0F, 1.0F);
    skybox->SetTexture(texture);
    stage.GetRenderer()->AddActor(skybox);
    const vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    stage.Window->Render();
    const int casters = pass->GetStatistics().Casters;
    EXPECT_GT(ExpectComposedOfDimmed(stage, pass), 0);
    skybox->VisibilityOff();
    stage.Window->Render();
    EXPECT_EQ(pass->GetStatistics().Casters, casters);
  }
}

// There are more lights than one texture has channels for.
TEST_F(PassImages, ManyMasks)
{
  Stage stage = SetNamedStage("Directional");
  for (int i = 0; i < 27; ++i)
  {
    const double angle = 0.23 * i;
    vtkSmartPointer<vtkLight> light = TestScene::MakeLight(
      SceneBuilder().Directional({ std::cos(angle), std::sin(angle), -0.2 - 0.1 * (i % 5) }));
    light->SetIntensity(0.05);
    stage.GetRenderer()->AddLight(light);
    stage.Lights.push_back(light);
  }
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  std::vector<ShadowMask> masks;
  Picture expected;
  for (const int mode :
    { vtkShadowVolumeClampPass::Unclamped, vtkShadowVolumeClampPass::Scissored })
  {
    pass->SetMode(mode);
    const Picture picture = RenderPicture(stage);
    const std::vector<ShadowMask> found = GetMasks(stage, pass);
    if (!masks.empty())
    {
      EXPECT_EQ(found, masks);
      EXPECT_EQ(FindDifference(expected, picture), "");
    }
    masks = found;
    expected = picture;
  }
  for (std::size_t i = 0; i < masks.size(); ++i)
  {
    SCOPED_TRACE("light " + std::to_string(i));
    EXPECT_GT(CountShadowed(masks[i]), 50);
    // It shines where its own mask is 0, and nowhere else.
    const double intensity = stage.Lights[i]->GetIntensity();
    stage.Lights[i]->SetIntensity(2.0 * intensity);
    const Picture brighter = RenderPicture(stage);
    for (std::size_t pixel = 0; pixel < masks[i].size(); ++pixel)
    {
      ASSERT_TRUE(masks[i][pixel] == 0 ||
        std::equal(
          brighter.GetColor(pixel), brighter.GetColor(pixel) + 4, expected.GetColor(pixel)))
        << "pixel " << pixel;
    }
    EXPECT_NE(FindDifference(expected, brighter), "");
    stage.Lights[i]->SetIntensity(intensity);
  }
}
