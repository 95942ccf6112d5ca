// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// A wall that hides other props, drawn by every kind of prop: while it is there they are hidden,
// and in the first frame without it they are seen.
#include "CompositeMapper.h"
#include "CullerTest.h"
#include "SceneProps.h"
#include "Scenes.h"

#include "vtkAssembly.h"
#include "vtkDataArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkLODProp3D.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp3DCollection.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkTexture.h"

#if VTKNBUFFER_TEST_HAS_RENDERINGLOD
#include "vtkLODActor.h"
#include "vtkQuadricLODActor.h"
#endif

using Scenes::Wall;

namespace
{
struct Occluder : NamedCase
{
  std::function<vtkSmartPointer<vtkProp>(Stage&)> Make;
  std::function<void(vtkProp*)> Uncover;
  Verdict Expected;
  bool Hides = true;
  /// Some versions of VTK warn of what they do themselves.
  bool KeepMessages = false;
};

using CullerOccluders = testing::TestWithParam<Occluder>;

/// A wall like that of the wall scene, or a box too small to hide anything.
vtkSmartPointer<vtkPolyData> MakeWallData(bool small = false)
{
  const glm::dvec3 sizes[2] = { { 12.0, 6.0, 0.5 }, { 0.2, 0.2, 0.5 } };
  return Scenes::MakeBox({ 0.0, 0.0, 0.0 }, sizes[small]);
}

vtkSmartPointer<vtkPolyDataMapper> MakeOccluderMapper(vtkPolyData* data)
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  return mapper;
}

template <typename ActorType>
vtkSmartPointer<ActorType> MakeWall()
{
  auto actor = vtkSmartPointer<ActorType>::New();
  actor->SetMapper(MakeOccluderMapper(MakeWallData()));
  actor->GetProperty()->SetColor(1.0, 0.8, 0.1);
  return actor;
}

void LiftPointsOf(vtkDataObject* data)
{
  TestScene::MovePoints(vtkPolyData::SafeDownCast(data)->GetPoints(), { 0.0, 9.0, 0.0 });
  data->Modified();
}

vtkSmartPointer<vtkProp> MakeNestedAssembly(Stage&)
{
  vtkNew<vtkAssembly> inner;
  inner->AddPart(MakeWall<vtkActor>());
  auto outer = vtkSmartPointer<vtkAssembly>::New();
  outer->AddPart(inner);
  return outer;
}

template <typename AssemblyType>
vtkSmartPointer<vtkProp> MakeAssembly(Stage&)
{
  auto assembly = vtkSmartPointer<AssemblyType>::New();
  assembly->AddPart(MakeWall<vtkActor>());
  return assembly;
}

vtkSmartPointer<vtkProp> MakeLODProp(Stage&)
{
  auto lod = vtkSmartPointer<vtkLODProp3D>::New();
  lod->AutomaticLODSelectionOff();
  lod->SetSelectedLODID(lod->AddLOD(MakeOccluderMapper(MakeWallData()), 0.0));
  lod->AddLOD(MakeOccluderMapper(MakeWallData(true)), 0.0);
  return lod;
}

/// A wall as a scenario describes it, changed.
std::function<vtkSmartPointer<vtkProp>(Stage&)> AsPropOf(
  const std::function<void(TestScene::Prop&)>& change)
{
  return [change](Stage& stage)
  {
    TestScene::SceneBuilder scene;
    TestScene::Prop& prop = scene.Box({ 0.0, 0.0, 0.0 }, { 12.0, 6.0, 0.5 });
    change(prop);
    return TestScene::MakeProp(prop, stage.GetRenderer()->GetActiveCamera());
  };
}

vtkSmartPointer<vtkProp> MakeGlyphs(Stage&)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceData(MakeWallData());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkProp> MakeImageOccluder(Stage&)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(13, 7, 1);
  image->SetOrigin(-6.0, -3.0, -0.2);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  image->GetPointData()->GetScalars()->Fill(255.0);
  auto actor = vtkSmartPointer<vtkImageActor>::New();
  actor->SetInputData(image);
  return actor;
}

/// The wall is block 1 by flat index, another box in the middle of it block 2.
vtkSmartPointer<vtkProp> MakeComposite(Stage&)
{
  return Scenes::MakeTwoBlocks(MakeWallData(), MakeWallData(true));
}

CompositeMapper* GetComposite(vtkProp* prop)
{
  return CompositeMapper::SafeDownCast(vtkActor::SafeDownCast(prop)->GetMapper());
}

void MakeTextureTranslucent(vtkProp* prop)
{
  vtkImageData* image = vtkActor::SafeDownCast(prop)->GetTexture()->GetInput();
  image->GetPointData()->GetScalars()->FillComponent(3, 40.0);
  image->GetPointData()->GetScalars()->Modified();
  image->Modified();
}

void Shrink(vtkProp* prop)
{
  vtkProp3D::SafeDownCast(prop)->SetScale(0.03);
}

#if VTKNBUFFER_TEST_HAS_RENDERINGLOD
template <typename LODType>
vtkSmartPointer<vtkProp> MakeLODActor(Stage& stage)
{
  // Time enough for the finest level in every frame.
  stage.Window->SetDesiredUpdateRate(1e-4);
  return MakeWall<LODType>();
}

void LiftActorsPoints(vtkProp* prop)
{
  LiftPointsOf(vtkActor::SafeDownCast(prop)->GetMapper()->GetInputDataObject(0, 0));
}
#endif
}

// Hazard: the occluder is not a plain actor, so that its depth changes without anything that the
// culler could notice.
TEST_P(CullerOccluders, WallStandsAndGoes)
{
  const Occluder& occluder = this->GetParam();
  if (!occluder.Make)
  {
    GTEST_SKIP() << "this VTK comes without RenderingLOD";
  }
  // Actors with levels of detail read the update rate of the window's interactor.
  std::vector<vtkSmartPointer<vtkRenderWindowInteractor>> interactors;
  ComparisonOptions options;
  options.KeepMessages = occluder.KeepMessages;
  Comparison comparison(
    [&](Stage& stage)
    {
      interactors.push_back(vtkSmartPointer<vtkRenderWindowInteractor>::New());
      interactors.back()->SetRenderWindow(stage.Window);
      Scenes::BuildWall(stage);
      stage.Props[Wall::Index]->VisibilityOff();
      stage.Add(occluder.Make(stage));
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    options);
  const auto expectHidden = [&](const char* when)
  {
    EXPECT_TRUE(comparison.GetHidden() >= Wall::Hidden || !occluder.Hides)
      << when << ": " << comparison.GetHidden();
    EXPECT_TRUE(comparison.GetHidden() < Wall::Behind / 4 || occluder.Hides)
      << when << ": " << comparison.GetHidden();
    EXPECT_EQ(comparison.GetVerdict(Wall::Count), occluder.Expected) << when;
  };
  for (int i = 0; i < 3; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.1 * i, "moved");
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
  }
  expectHidden("moved");
  comparison.Frame("still");
  comparison.Frame("still");
  expectHidden("still");
  comparison.Frame(
    "uncovered", [&occluder](Stage& stage) { occluder.Uncover(stage.Props[Wall::Count]); });
  // What writes no depth may change in a still frame: nobody else's verdict depends on it.
  EXPECT_EQ(comparison.GetDecision(), occluder.Hides ? Decision::Culled : Decision::Still);
  EXPECT_LT(comparison.GetHidden(), Wall::Behind / 4);
  comparison.Frame("after that");
  EXPECT_LT(comparison.GetHidden(), Wall::Behind / 4);
}

namespace
{
const Occluder Occluders[] = {
  // Hazard: a part moves and its assembly knows nothing of it.
  { "Assembly", MakeAssembly<vtkAssembly>,
    [](vtkProp* p)
    { vtkAssembly::SafeDownCast(p)->GetParts()->GetLastProp3D()->SetPosition(0.0, 9.0, 0.0); },
    Verdict::NotAPlainActor },
  // Hazard: matrices of assemblies multiply; a part's own bounds are not where it is drawn.
  { "NestedAssembly", MakeNestedAssembly, Shrink, Verdict::NotAPlainActor },
  // Hazard: an assembly that is no vtkProp3D; one of its parts is switched off.
  { "PropAssembly", MakeAssembly<vtkPropAssembly>,
    [](vtkProp* p)
    { vtkPropAssembly::SafeDownCast(p)->GetParts()->GetLastProp()->VisibilityOff(); },
    Verdict::NotAPlainActor },
  // Hazard: the level of detail changes, and with it the depth.
  { "LODProp3D", MakeLODProp,
    [](vtkProp* p)
    {
      auto* lod = vtkLODProp3D::SafeDownCast(p);
      lod->SetSelectedLODID(lod->GetSelectedLODID() + 1);
    },
    Verdict::NotAPlainActor },
// Hazard: actors that draw by devices and mappers of their own, at a level of their choice.
#if VTKNBUFFER_TEST_HAS_RENDERINGLOD
  { "LODActor", MakeLODActor<vtkLODActor>, LiftActorsPoints, Verdict::NotAPlainActor, true, true },
  { "QuadricLODActor", MakeLODActor<vtkQuadricLODActor>, LiftActorsPoints, Verdict::NotAPlainActor,
    true, true },
#else
  { "LODActor", nullptr, nullptr, Verdict::NotAPlainActor },
  { "QuadricLODActor", nullptr, nullptr, Verdict::NotAPlainActor },
#endif
  // Hazard: a follower turns with the camera; its matrix is known when it is drawn.
  { "Follower", AsPropOf([](TestScene::Prop& p) { p.Kind = TestScene::PropKind::Follower; }),
    Shrink, Verdict::NotAPlainActor },
  // Hazard: glyphs are drawn where the points of another data set are.
  { "Glyphs", MakeGlyphs,
    [](vtkProp* p)
    { LiftPointsOf(vtkActor::SafeDownCast(p)->GetMapper()->GetInputDataObject(0, 0)); },
    Verdict::NotAPlainMapper },
  { "ImageActor", MakeImageOccluder, Shrink, Verdict::NotAPlainActor },
  // Hazard: a volume covers and hides nothing; what shines through it must be drawn.
  { "Volume", AsPropOf([](TestScene::Prop& p) { p.Kind = TestScene::PropKind::Volume; }), Shrink,
    Verdict::NotAPlainActor, false },
  // Hazard: a block is switched off in the mapper's attributes: same data, same actor.
  { "CompositeBlockInvisible", MakeComposite,
    [](vtkProp* p) { GetComposite(p)->SetBlockVisibility(1, false); }, Verdict::Visible },
  // Hazard: one block turns translucent, the others stay opaque: one actor is both.
  { "CompositeBlockTranslucent", MakeComposite,
    [](vtkProp* p) { GetComposite(p)->SetBlockOpacity(1, 0.4); }, Verdict::Visible },
  // Hazard: the points of a block change in place.
  { "CompositeBlockMoved", MakeComposite,
    [](vtkProp* p)
    {
      auto* blocks = vtkMultiBlockDataSet::SafeDownCast(GetComposite(p)->GetInputDataObject(0, 0));
      LiftPointsOf(blocks->GetBlock(0));
      blocks->Modified();
    },
    Verdict::Visible },
  // Hazard: the tree of blocks is as old as before.
  { "CompositeBlockMovedAlone", MakeComposite,
    [](vtkProp* p)
    {
      auto* blocks = vtkMultiBlockDataSet::SafeDownCast(GetComposite(p)->GetInputDataObject(0, 0));
      LiftPointsOf(blocks->GetBlock(0));
    },
    Verdict::Visible },
  // Hazard: texels become translucent in place, far from actor and mapper.
  { "TextureTurnsTranslucent",
    AsPropOf([](TestScene::Prop& p) { p.Texture = TestScene::Translucency::Opaque; }),
    MakeTextureTranslucent, Verdict::Visible },
  // Hazard: a matrix that mirrors turns the faces round, one that shears moves the corners.
  { "MirroredAndSheared",
    AsPropOf(
      [](TestScene::Prop& p) {
        p.UserMatrix = { -1, 0, 0, 0, 0.02, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
      }),
    [](vtkProp* p) { vtkActor::SafeDownCast(p)->GetUserMatrix()->SetElement(1, 3, 9.0); },
    Verdict::Visible },
};
}

INSTANTIATE_TEST_SUITE_P(Each, CullerOccluders, testing::ValuesIn(Occluders), GetCaseName);

// Hazard: an actor is drawn twice, once by itself and once as a part of an assembly, which replaces
// the actor's matrix while it draws.
TEST(CullerOccludersOnce, PartOfAnAssemblyThatIsAlsoInTheRenderer)
{
  constexpr int parts = 10;
  ComparisonOptions options;
  options.CompareDraws = false; // of props drawn by others
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      vtkNew<vtkAssembly> assembly;
      for (int i = 0; i < parts; ++i)
      {
        assembly->AddPart(stage.GetActor(Wall::FirstBehind + i));
      }
      assembly->SetPosition(5.0, 1.0, 0.0);
      stage.Add(assembly);
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    options);
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame("moved",
      [i](Stage& stage)
      {
        Scenes::SetWallCamera(stage.GetRenderer(), 0.1 * i);
        vtkProp3D::SafeDownCast(stage.Props[Wall::Count])->SetPosition(-5.0 + i, 2.0, 4.0 * i);
      });
  }
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  for (int prop = Wall::FirstBehind; prop < Wall::FirstBehind + parts; ++prop)
  {
    EXPECT_EQ(comparison.GetVerdict(prop), Verdict::Hidden) << prop;
    EXPECT_EQ(comparison.Reference.GetDraws(prop), 2) << prop;
    EXPECT_EQ(comparison.Culled.GetDraws(prop), 1) << prop << ", as a part";
  }
}
