// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Changes between frames show in the next one: its masks and image are those of a new pass.
#include "CompositeMapper.h"
#include "LightRig.h"
#include "PassTestTools.h"
#include "Tune.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"

namespace
{
/// With keys of its own, so that it is their replacement that has to be seen.
void SetCasts(vtkProp* prop, bool casts)
{
  const vtkSmartPointer<vtkInformation> keys = TestScene::LightRig::MakeCasterKeys();
  if (!casts)
  {
    keys->Clear();
  }
  prop->SetPropertyKeys(keys);
}

/// Props of each kind that either all cast or all do not.
struct Props
{
  void Add(vtkRenderer* renderer, double x, double z);
  void SetCast(bool casts);

  vtkActor* Box;
  vtkActor* Sphere;
  vtkActor* Clipped;
  vtkActor* Composite;
  vtkNew<vtkAssembly> Assembly;
  vtkNew<vtkActor> Part;
  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkPlane> Plane;
  vtkNew<vtkMultiBlockDataSet> Blocks;
  vtkNew<vtkMatrix4x4> Matrix;
};

void Props::Add(vtkRenderer* renderer, double x, double z)
{
  this->Box = AddMesh(renderer, MakeBox({ x, -1.0, z }, { 0.5, 0.5, 0.5 }, VTK_DOUBLE));
  this->Box->SetUserMatrix(this->Matrix);
  this->Sphere = AddMesh(renderer, this->Source->GetOutput());
  this->Source->SetCenter(x, 0.0, z);
  this->Source->SetRadius(0.3);
  this->Sphere->GetMapper()->SetInputConnection(this->Source->GetOutputPort());
  this->Clipped = AddMesh(renderer, MakeGlobe({ x, 1.0, z }, 0.4, 16));
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(this->Plane);
  this->Plane->SetOrigin(x - 0.1, 1.0, z);
  this->Plane->SetNormal(1.0, 0.0, 0.0);
  this->Clipped->GetMapper()->SetClippingPlanes(planes);
  this->Composite = AddMesh(renderer, nullptr);
  this->Blocks->SetBlock(0, MakeBox({ x, 2.0, z }, { 0.3, 0.3, 0.3 }));
  this->Blocks->SetBlock(1, MakeBox({ x, 2.0, z + 0.4 }, { 0.2, 0.2, 0.2 }));
  vtkNew<CompositeMapper> mapper;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetInputDataObject(this->Blocks);
  this->Composite->SetMapper(mapper);
  vtkNew<vtkPolyDataMapper> partMapper;
  partMapper->SetInputData(MakeBox({ x, -2.0, z }, { 0.4, 0.4, 0.4 }));
  this->Part->SetMapper(partMapper);
  this->Assembly->AddPart(this->Part);
}

void Props::SetCast(bool casts)
{
  for (vtkProp* prop : std::initializer_list<vtkProp*>{
         this->Box, this->Sphere, this->Clipped, this->Composite, this->Assembly })
  {
    SetCasts(prop, casts);
  }
}

/// Casters float over receivers that do not cast; a floor; three lights; a caster out of sight.
struct ChangingStage
{
  /// With assemblies no frame is as the last one.
  explicit ChangingStage(bool assemblies = false)
    : Stage(SetStage(AddFloorAndLights))
  {
    this->AddProps(this->GetRenderer());
    this->Pass = AddPass(this->Stage);
    this->Pass->SetCasterKeys(TestScene::LightRig::MakeCasterKeys());
    Tune(this->Pass, &vtkShadowTuning::LitmapResolution, 64);
    if (assemblies)
    {
      this->Stage.GetRenderer()->AddActor(this->Casters.Assembly);
      this->Stage.GetRenderer()->AddActor(this->Receivers.Assembly);
    }
  }

  static void AddFloorAndLights(SceneBuilder& scene)
  {
    scene.Floor(5.0);
    scene.Directional({ 1.0, 0.0, -1.0 });
    scene.Spot({ -2.0, -2.0, 5.0 }, { 0.0, 0.0, 0.0 }, 35.0);
    scene.PointLight({ -0.5, 0.5, 3.0 });
    TestScene::View& view = scene.Look({ 3.0, -7.0, 5.0 }, { 0.3, 0.0, 0.3 });
    view.Near = 2.0;
    view.Far = 30.0;
  }

  void AddProps(vtkRenderer* renderer)
  {
    this->Floor = GetActors(renderer).back();
    this->Casters.Add(renderer, 0.0, 1.5);
    this->Casters.SetCast(true);
    this->Receivers.Add(renderer, 0.5, 0.4);
    this->Unseen = AddMesh(renderer, MakeBox({ -8.0, 0.5, 8.5 }, { 1.0, 1.0, 1.0 }, VTK_DOUBLE));
    SetCasts(this->Unseen, true);
  }

  vtkRenderer* GetRenderer() const { return this->Stage.GetRenderer(); }
  vtkCamera* GetCamera() const { return this->GetRenderer()->GetActiveCamera(); }

  vtkActor* Floor;
  Props Casters;
  Props Receivers;
  vtkActor* Unseen;
  TestScene::Stage Stage;
  vtkSmartPointer<vtkShadowVolumeClampPass> Pass;
};

struct Change
{
  std::string Name;
  std::function<void(ChangingStage&)> Make;
  bool Assemblies = false; ///< Whether it needs them.
};

void PrintTo(const Change& change, std::ostream* stream)
{
  *stream << change.Name;
}

vtkPoints* GetPoints(vtkDataObject* data)
{
  return vtkPolyData::SafeDownCast(data)->GetPoints();
}

/// Of props that cast or that are only seen.
void AddPropChanges(const std::string& of, Props ChangingStage::*props, std::vector<Change>& result)
{
  const auto add =
    [&](const std::string& name, const std::function<void(Props&)>& change, bool assemblies = false)
  {
    result.push_back(
      { of + name, [props, change](ChangingStage& stage) { change(stage.*props); }, assemblies });
  };
  add("Moved", [](Props& p) { p.Sphere->AddPosition(0.2, 0.0, 0.1); });
  add("MatrixChanged", [](Props& p) { p.Matrix->SetElement(0, 3, 0.2); });
  add("Hidden", [](Props& p) { p.Box->VisibilityOff(); });
  add("PointsMoved",
    [](Props& p)
    {
      TestScene::MovePoints(
        GetPoints(p.Box->GetMapper()->GetInputDataObject(0, 0)), { 0.0, 0.0, 0.2 });
    });
  add("SourceChanged", [](Props& p) { p.Source->SetRadius(0.45); });
  add("PlaneMoved", [](Props& p) { p.Plane->SetOrigin(p.Plane->GetOrigin()[0] + 0.2, 1.0, 0.0); });
  add("PlaneRemoved", [](Props& p) { p.Clipped->GetMapper()->RemoveAllClippingPlanes(); });
  add("MapperReplaced",
    [](Props& p)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(MakeGlobe({ 0.0, -1.0, 1.0 }, 0.6, 8));
      p.Box->SetMapper(mapper);
    });
  add("BlockReplaced",
    [](Props& p) {
      p.Blocks->SetBlock(1, MakeBox({ 0.3, 1.6, 1.2 }, { 0.4, 0.4, 0.4 }));
    });
  add("BlockChanged",
    [](Props& p) {
      TestScene::MovePoints(GetPoints(p.Blocks->GetBlock(0)), { 0.3, 0.0, 0.0 });
    });
  add("BlockHidden",
    [](Props& p)
    { static_cast<CompositeMapper*>(p.Composite->GetMapper())->SetBlockVisibility(2, false); });
  add(
    "PartMoved", [](Props& p) { p.Part->AddPosition(0.3, 0.0, 0.0); }, true);
  add(
    "AssemblyMoved", [](Props& p) { p.Assembly->AddPosition(0.0, 0.3, 0.0); }, true);
  add("Translucent", [](Props& p) { p.Box->GetProperty()->SetOpacity(0.5); });
  add("Wireframe", [](Props& p) { p.Sphere->GetProperty()->SetRepresentationToWireframe(); });
  add("FrontFacesCulled", [](Props& p) { p.Sphere->GetProperty()->FrontfaceCullingOn(); });
  add("Cast", [](Props& p) { p.SetCast(true); });
  add("DoNotCast", [](Props& p) { p.SetCast(false); });
}

std::vector<Change> GetChanges()
{
  std::vector<Change> result = {
    { "CameraMoved", [](ChangingStage& s) { s.GetCamera()->Azimuth(10.0); } },
    { "CameraZoomed", [](ChangingStage& s) { s.GetCamera()->SetViewAngle(30.0); } },
    { "CameraParallel",
      [](ChangingStage& s)
      {
        s.GetCamera()->ParallelProjectionOn();
        s.GetCamera()->SetParallelScale(2.5);
      } },
    { "ClippingRange", [](ChangingStage& s) { s.GetCamera()->SetClippingRange(1.0, 7.0); } },
    { "Viewport", [](ChangingStage& s) { s.GetRenderer()->SetViewport(0.3, 0.2, 1.0, 0.9); } },
    { "Larger", [](ChangingStage& s) { s.Stage.Window->SetSize(311, 201); } },
    { "Smaller", [](ChangingStage& s) { s.Stage.Window->SetSize(111, 91); } },
    { "MultiSamples", [](ChangingStage& s) { s.Stage.Window->SetMultiSamples(4); } },
    { "LightMoved", [](ChangingStage& s) { s.Stage.Lights[1]->SetPosition(-2.5, -1.0, 5.0); } },
    { "LightTurned", [](ChangingStage& s) { s.Stage.Lights[0]->SetPosition(-1.0, 0.5, 1.5); } },
    { "LightCone", [](ChangingStage& s) { s.Stage.Lights[1]->SetConeAngle(20.0); } },
    { "LightColour", [](ChangingStage& s) { s.Stage.Lights[1]->SetColor(1.0, 0.0, 0.0); } },
    { "LightAttenuation", [](ChangingStage& s) { s.Stage.Lights[2]->SetShadowAttenuation(0.5f); } },
    { "LightOff", [](ChangingStage& s) { s.Stage.Lights[0]->SwitchOff(); } },
    { "LightDark", [](ChangingStage& s) { s.Stage.Lights[1]->SetIntensity(0.0); } },
    { "LightRemoved", [](ChangingStage& s) { s.GetRenderer()->RemoveLight(s.Stage.Lights[1]); } },
    { "LightAdded",
      [](ChangingStage& s) {
        Fill(s.GetRenderer(), [](SceneBuilder& scene) { scene.Directional({ -1.0, 0.0, -1.0 }); });
      } },
    { "LightBecomesHeadlight",
      [](ChangingStage& s) { s.Stage.Lights[0]->SetLightTypeToHeadlight(); } },
    { "LightBecomesSpot", [](ChangingStage& s) { s.Stage.Lights[2]->SetConeAngle(40.0); } },
    { "LightDoesNotCast",
      [](ChangingStage& s) { s.Pass->SetLightCasts(s.Stage.Lights[1], false); } },
    { "LightsReordered",
      [](ChangingStage& s)
      {
        const vtkSmartPointer<vtkLight> first = s.Stage.Lights[0];
        s.GetRenderer()->RemoveLight(first);
        s.GetRenderer()->AddLight(first);
      } },
    { "ModeUnclamped",
      [](ChangingStage& s) { s.Pass->SetMode(vtkShadowVolumeClampPass::Unclamped); } },
    { "ModeClamped", [](ChangingStage& s) { s.Pass->SetMode(vtkShadowVolumeClampPass::Clamped); } },
    { "Resolution",
      [](ChangingStage& s) { Tune(s.Pass, &vtkShadowTuning::LitmapResolution, 16); } },
    { "SlabGap", [](ChangingStage& s) { Tune(s.Pass, &vtkShadowTuning::SlabGap, 64); } },
    { "AllCast", [](ChangingStage& s) { s.Pass->SetCasterKeys(nullptr); } },
    { "KeysEmptied", [](ChangingStage& s) { s.Pass->GetCasterKeys()->Clear(); } },
    { "UnseenMoved", [](ChangingStage& s) { s.Unseen->AddPosition(0.5, 0.3, 0.0); } },
    { "UnseenHidden", [](ChangingStage& s) { s.Unseen->VisibilityOff(); } },
    { "UnseenRemoved", [](ChangingStage& s) { s.GetRenderer()->RemoveActor(s.Unseen); } },
    { "FloorRemoved", [](ChangingStage& s) { s.GetRenderer()->RemoveActor(s.Floor); } },
    { "FloorTextured", [](ChangingStage& s) { s.Floor->GetProperty()->SetAmbient(0.3); } },
    { "ActorAdded",
      [](ChangingStage& s) {
        AddMesh(s.GetRenderer(), MakeBox({ 1.5, 0.0, 0.5 }, { 0.5, 0.5, 1.0 }, VTK_DOUBLE));
      } },
    { "AllRemoved", [](ChangingStage& s) { s.GetRenderer()->RemoveAllViewProps(); } },
    { "PassReleased", [](ChangingStage& s) { s.Pass->ReleaseGraphicsResources(s.Stage.Window); } },
    { "WindowReleased",
      [](ChangingStage& s) { s.GetRenderer()->ReleaseGraphicsResources(s.Stage.Window); } },
    { "NewContext", [](ChangingStage& s) { s.Stage.Window->Finalize(); } },
  };
  AddPropChanges("Casters", &ChangingStage::Casters, result);
  AddPropChanges("Receivers", &ChangingStage::Receivers, result);
  return result;
}

struct Frame
{
  Picture Image;
  std::vector<ShadowMask> Masks;
};

Frame Render(const ChangingStage& stage, vtkShadowVolumeClampPass* pass)
{
  Frame result = { RenderPicture(stage.Stage), {} };
  EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
  EXPECT_EQ(FindInconsistency(pass->GetStatistics()), "");
  vtkCollectionSimpleIterator cookie;
  stage.GetRenderer()->GetLights()->InitTraversal(cookie);
  while (vtkLight* light = stage.GetRenderer()->GetLights()->GetNextLight(cookie))
  {
    int width = 0;
    int height = 0;
    result.Masks.push_back(pass->GetMask(light, width, height));
  }
  return result;
}

/// What the stage's pass draws is what one that has no past does.
void ExpectNoMemory(const ChangingStage& stage)
{
  const Frame actual = Render(stage, stage.Pass);
  vtkNew<vtkShadowVolumeClampPass> fresh;
  fresh->SetMode(stage.Pass->GetMode());
  Tune(fresh, &vtkShadowTuning::LitmapResolution, stage.Pass->GetTuning().LitmapResolution);
  Tune(fresh, &vtkShadowTuning::SlabGap, stage.Pass->GetTuning().SlabGap);
  fresh->SetCasterKeys(stage.Pass->GetCasterKeys());
  for (vtkLight* light : stage.Stage.Lights)
  {
    if (stage.GetRenderer()->GetLights()->IsItemPresent(light))
    {
      fresh->SetLightCasts(light, stage.Pass->GetLightCasts(light));
    }
  }
  stage.GetRenderer()->SetPass(fresh);
  const Frame expected = Render(stage, fresh);
  stage.GetRenderer()->SetPass(stage.Pass);
  EXPECT_EQ(FindDifference(expected.Image, actual.Image), "")
    << stage.Pass->GetStatistics().GetAsJSON();
  EXPECT_TRUE(expected.Masks == actual.Masks) << stage.Pass->GetStatistics().GetAsJSON();
}
}

using PassChanges = OffscreenFixtureWithParam<Change>;

TEST_P(PassChanges, AreSeenInTheNextFrame)
{
  ChangingStage stage(this->GetParam().Assemblies);
  const Frame first = Render(stage, stage.Pass);
  EXPECT_EQ(stage.Pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
  // VTK gives props without keys some in the first frame, which changes them.
  Render(stage, stage.Pass);
  const Frame still = Render(stage, stage.Pass);
  EXPECT_EQ(stage.Pass->GetStatistics().Decision,
    this->GetParam().Assemblies ? vtkShadowDecision::Drawn : vtkShadowDecision::Still);
  EXPECT_TRUE(first.Masks == still.Masks);
  EXPECT_EQ(FindDifference(first.Image, still.Image), "");
  this->GetParam().Make(stage);
  ExpectNoMemory(stage);
}

INSTANTIATE_TEST_SUITE_P(Changes, PassChanges, ::testing::ValuesIn(GetChanges()),
  [](const auto& info) { return info.param.Name; });

using PassHistory = OffscreenFixture;

// Lights are switched on and off, which changes the code of all shaders. The images must not depend
// on earlier frames.
TEST_F(PassHistory, SwitchingOnAndOff)
{
  ChangingStage stage;
  const Frame first = Render(stage, stage.Pass);
  for (int lights : { 6, 0, 7, 5, 1, 2, 4, 3, 0, 7 })
  {
    SCOPED_TRACE("lights " + std::to_string(lights));
    for (int i = 0; i < 3; ++i)
    {
      stage.Stage.Lights[i]->SetSwitch((lights >> i) & 1);
    }
    ExpectNoMemory(stage);
  }
  const Frame last = Render(stage, stage.Pass);
  EXPECT_TRUE(first.Masks == last.Masks);
  EXPECT_EQ(FindDifference(first.Image, last.Image), "");
}

TEST_F(PassHistory, ModesAndResolutions)
{
  ChangingStage stage;
  std::vector<Frame> exact;
  using Pass = vtkShadowVolumeClampPass;
  for (int mode :
    { Pass::Unclamped, Pass::Scissored, Pass::Clamped, Pass::Scissored, Pass::Unclamped })
  {
    stage.Pass->SetMode(mode);
    for (int resolution : { 1, 7, 512 })
    {
      SCOPED_TRACE("mode " + std::to_string(mode) + ", " + std::to_string(resolution) + " lexels");
      Tune(stage.Pass, &vtkShadowTuning::LitmapResolution, resolution);
      const Frame frame = Render(stage, stage.Pass);
      if (mode != vtkShadowVolumeClampPass::Clamped)
      {
        exact.push_back(frame);
        EXPECT_EQ(FindDifference(exact.front().Image, frame.Image), "");
      }
    }
  }
}

// A caster moves through view and light. Each frame must equal that of a new pass.
TEST_F(PassHistory, AMovingCaster)
{
  ChangingStage stage;
  Render(stage, stage.Pass);
  for (int frame = 1; frame <= 10; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame));
    stage.Unseen->SetPosition(1.5 * frame, -0.05 * frame, -0.9 * frame);
    ExpectNoMemory(stage);
    EXPECT_EQ(stage.Pass->GetStatistics().Updates, 1);
  }
}

// Hazard: actors and meshes of the next frame are at the addresses of deleted ones of the last
// frame.
TEST_F(PassHistory, ActorsThatAreReplaced)
{
  ChangingStage stage;
  for (int frame = 0; frame < 10; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame));
    stage.GetRenderer()->RemoveActor(stage.Unseen);
    stage.Unseen = AddMesh(
      stage.GetRenderer(), MakeBox({ -0.1 * frame, 0.5, 2.5 }, { 0.5, 0.5, 0.5 }, VTK_DOUBLE));
    SetCasts(stage.Unseen, true);
    ExpectNoMemory(stage);
  }
}

// Hazard: the pass is added to shared property keys once for each prop, and removed from them only
// once.
TEST_F(PassHistory, PropsThatShareTheirKeys)
{
  ChangingStage stage;
  stage.Casters.Sphere->SetPropertyKeys(stage.Casters.Box->GetPropertyKeys());
  stage.Unseen->SetPropertyKeys(stage.Casters.Box->GetPropertyKeys());
  EXPECT_GT(ExpectComposedOfDimmed(stage.Stage, stage.Pass), 100);
  // VTK gives back one reference of several.
  stage.Stage.Window->Render();
  const int references = stage.Pass->GetReferenceCount();
  stage.GetCamera()->Azimuth(3.0);
  stage.Stage.Window->Render();
  EXPECT_EQ(stage.Pass->GetReferenceCount(), references);
}

// Hazard: a new light is at the address of a deleted one that was not to cast.
TEST_F(PassHistory, LightsAreNotRememberedByAddress)
{
  ChangingStage stage;
  std::vector<vtkSmartPointer<vtkLight>> others;
  auto light = vtkSmartPointer<vtkLight>::New();
  const vtkLight* const address = light;
  stage.Pass->SetLightCasts(light, false);
  light = nullptr;
  for (int i = 0; i < 1000 && light != address; ++i)
  {
    others.push_back(vtkSmartPointer<vtkLight>::New());
    light = others.back();
  }
  if (light != address)
  {
    GTEST_SKIP() << "The address is not given out again.";
  }
  EXPECT_TRUE(stage.Pass->GetLightCasts(light));
}

// Hazard: composite data without display attributes, all of whose blocks are visible and opaque, do
// not cast.
TEST_F(PassHistory, CompositeDataWithoutAttributes)
{
  ChangingStage stage;
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(stage.Casters.Blocks);
  stage.Casters.Composite->SetMapper(mapper);
  const Frame expected = Render(stage, stage.Pass);
  EXPECT_EQ(stage.Pass->GetStatistics().Skipped, (std::array<int, NumberOfShadowSkips>{}));
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  const Frame actual = Render(stage, stage.Pass);
  EXPECT_TRUE(expected.Masks == actual.Masks);
}

// Hazard: volumes that were made for one view are infinite, but those of the next one have to end.
TEST_F(PassHistory, AParallelCameraThatTurnsIntoTheLight)
{
  const Stage stage = SetNamedStage("ParallelAlongLight");
  const vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  pass->SetMode(vtkShadowVolumeClampPass::Unclamped);
  vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
  camera->Azimuth(10.0);
  ExpectMatchesOracle(stage, pass);
  const std::array<double, 3> position = { 0.0, -10.0, 1.0 };
  camera->SetPosition(position.data());
  ExpectMatchesOracle(stage, pass);
  camera->Azimuth(10.0);
  ExpectMatchesOracle(stage, pass);
}

// Hazard: a uniform moves a prop, of which no time tells.
TEST_F(PassHistory, UniformsOfTheApplicationsShaders)
{
  ChangingStage stage;
  Render(stage, stage.Pass);
  Render(stage, stage.Pass);
  Render(stage, stage.Pass);
  EXPECT_EQ(stage.Pass->GetStatistics().Decision, vtkShadowDecision::Still);
  vtkShaderProperty* shaders = stage.Unseen->GetShaderProperty();
  shaders->AddVertexShaderReplacement(
    "//VTK::PositionVC::Dec", true, "//VTK::PositionVC::Dec\n", false);
  for (int frame = 0; frame < 3; ++frame)
  {
    Render(stage, stage.Pass);
    EXPECT_EQ(stage.Pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
  }
  shaders->ClearAllVertexShaderReplacements();
  Render(stage, stage.Pass);
  Render(stage, stage.Pass);
  EXPECT_EQ(stage.Pass->GetStatistics().Decision, vtkShadowDecision::Still);
}

// Camera lights move with the camera in the same frame.
TEST_F(PassHistory, CameraLights)
{
  ChangingStage stage;
  stage.Pass->SetCasterKeys(nullptr);
  vtkRenderer* renderer = stage.GetRenderer();
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(0.7, 0.7, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AddLight(light);
  for (vtkLight* other : stage.Stage.Lights)
  {
    other->SwitchOff();
  }
  stage.Stage.Lights = { light };
  for (int frame = 0; frame < 3; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame));
    renderer->GetActiveCamera()->Azimuth(15.0);
    ExpectMatchesOracle(stage.Stage, stage.Pass);
  }
}
