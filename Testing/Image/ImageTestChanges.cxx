// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever an application changes between two frames is seen in the very next one.
#include "CullerTest.h"
#include "SceneProps.h"
#include "Scenes.h"
#include "Tune.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkUnsignedCharArray.h"

using Scenes::Wall;

namespace
{
constexpr int Behind = Wall::FirstBehind;

/// A prop behind the wall that comes with a pipeline, and what a change needs to find again.
constexpr int Piped = Wall::Count;

struct Change : NamedCase
{
  std::function<void(Stage&)> Prepare;
  std::function<void(Stage&)> Apply;
  /// The verdict of prop `Prop` after it; Unknown for none.
  int Prop;
  Verdict After;
};

vtkPolyData* GetData(Stage& stage, int prop)
{
  return vtkPolyData::SafeDownCast(stage.GetActor(prop)->GetMapper()->GetInput());
}

vtkPolyDataMapper* GetMapper(Stage& stage, int prop)
{
  return vtkPolyDataMapper::SafeDownCast(stage.GetActor(prop)->GetMapper());
}

/// Above the wall, where the camera sees it.
void LiftPoints(vtkPoints* points)
{
  TestScene::MovePoints(points, { 0.0, 7.0, 0.0 });
}

/// The wall gets scalars and an opaque table, which is the mapper's or the scalars' own.
void AddTable(Stage& stage, bool isOfScalars)
{
  vtkPolyData* data = GetData(stage, Wall::Index);
  vtkNew<vtkFloatArray> scalars;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(i % 2));
  }
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->Build();
  if (isOfScalars)
  {
    scalars->SetLookupTable(table);
  }
  else
  {
    GetMapper(stage, Wall::Index)->SetLookupTable(table);
  }
  data->GetPointData()->SetScalars(scalars);
}

void MakeTableTranslucent(Stage& stage)
{
  vtkLookupTable* own = GetData(stage, Wall::Index)->GetPointData()->GetScalars()->GetLookupTable();
  vtkLookupTable* table =
    own ? own : vtkLookupTable::SafeDownCast(GetMapper(stage, Wall::Index)->GetLookupTable());
  table->SetTableValue(0, 1.0, 0.0, 0.0, 0.4);
  table->SetTableValue(1, 0.0, 0.0, 1.0, 0.4);
}

void Nothing(Stage&) {}

class CullerChanges : public testing::TestWithParam<Change>
{
protected:
  void TearDown() override { vtkMapper::SetResolveCoincidentTopologyToDefault(); }
};
}

// Hazard: verdicts and bounds are cached; a change that does not modify the actor itself must still
// be noticed before the frame in which it shows.
TEST_P(CullerChanges, SeenInThatFrame)
{
  const Change& change = this->GetParam();
  for (const auto& [still, observed] : { std::pair(true, true), { false, false }, { false, true } })
  {
    SCOPED_TRACE(std::string(still ? "after still frames" : "while the camera moves") +
      (observed ? ", observed" : ""));
    Comparison comparison(
      [&change](Stage& stage)
      {
        Scenes::BuildWall(stage);
        change.Prepare(stage);
      });
    Tune(comparison.GetCuller(), &vtkNBufferTuning::ObserveAfter, observed ? 1 : 0);
    for (int i = 0; i < 3; ++i)
    {
      Scenes::FrameOfWall(comparison, still ? 0.0 : 0.05 * i, "before");
    }
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    comparison.Frame("after", change.Apply);
    if (change.After != Verdict::Unknown)
    {
      EXPECT_EQ(comparison.GetVerdict(change.Prop), change.After);
    }
    comparison.Frame("after that");
    comparison.Frame("and after that");
    if (change.After != Verdict::Unknown)
    {
      EXPECT_EQ(comparison.GetVerdict(change.Prop), change.After);
    }
  }
}

namespace
{
void AddPipeline(Stage& stage, bool transformed)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.0, 0.0, -3.0);
  vtkNew<vtkTransform> transform;
  vtkNew<vtkTransformFilter> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetTransform(transform);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(transformed ? filter->GetOutputPort() : sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Add(actor);
}

void AddPiped(Stage& stage)
{
  AddPipeline(stage, false);
}

void AddPipedTransform(Stage& stage)
{
  AddPipeline(stage, true);
}

const Change PropChanges[] = {
  { "PointsInPlace", Nothing, [](Stage& s) { LiftPoints(GetData(s, Behind)->GetPoints()); }, Behind,
    Verdict::Visible },
  { "PointsReplaced", Nothing,
    [](Stage& s)
    {
      vtkNew<vtkPoints> points;
      points->DeepCopy(GetData(s, Behind)->GetPoints());
      LiftPoints(points);
      GetData(s, Behind)->SetPoints(points);
    },
    Behind, Verdict::Visible },
  // Hazard: neither the points nor the actor say that they have changed, only the array does.
  { "ArrayInPlace", Nothing,
    [](Stage& s)
    {
      auto* values = vtkFloatArray::SafeDownCast(GetData(s, Behind)->GetPoints()->GetData());
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
      {
        values->SetValue(3 * i + 1, values->GetValue(3 * i + 1) + 7.0f);
      }
      values->Modified();
    },
    Behind, Verdict::Visible },
  { "DataDeepCopied", Nothing,
    [](Stage& s) {
      GetData(s, Behind)->DeepCopy(Scenes::MakeBox({ 0.0, 6.0, -3.0 }, { 1.0, 1.0, 1.0 }));
    },
    Behind, Verdict::Visible },
  { "DataReplaced", Nothing,
    [](Stage& s) {
      GetMapper(s, Behind)->SetInputData(Scenes::MakeBox({ 0.0, 6.0, -3.0 }, { 1.0, 1.0, 1.0 }));
    },
    Behind, Verdict::Visible },
  { "MapperReplaced", Nothing,
    [](Stage& s)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(Scenes::MakeBox({ 0.0, 6.0, -3.0 }, { 1.0, 1.0, 1.0 }));
      s.GetActor(Behind)->SetMapper(mapper);
      s.CountDraws(s.GetActor(Behind));
    },
    Behind, Verdict::Visible },
  { "Position", Nothing, [](Stage& s) { s.GetActor(Behind)->SetPosition(0.0, 7.0, 0.0); }, Behind,
    Verdict::Visible },
  { "Scale", Nothing, [](Stage& s) { s.GetActor(Behind)->SetScale(30.0, 30.0, 1.0); }, Behind,
    Verdict::Unknown },
  { "Origin", [](Stage& s) { s.GetActor(Behind)->SetScale(0.1); },
    [](Stage& s) { s.GetActor(Behind)->SetOrigin(0.0, 7.0, 0.0); }, Behind, Verdict::Unknown },
  { "Orientation", [](Stage& s) { s.GetActor(Behind)->SetScale(1.0, 1.0, 0.5); },
    [](Stage& s) { s.GetActor(Behind)->RotateX(90.0); }, Behind, Verdict::Unknown },
  { "UserMatrixInPlace",
    [](Stage& s)
    {
      vtkNew<vtkMatrix4x4> matrix;
      s.GetActor(Behind)->SetUserMatrix(matrix);
    },
    [](Stage& s) { s.GetActor(Behind)->GetUserMatrix()->SetElement(1, 3, 7.0); }, Behind,
    Verdict::Visible },
  { "UserTransformInPlace",
    [](Stage& s)
    {
      vtkNew<vtkTransform> transform;
      s.GetActor(Behind)->SetUserTransform(transform);
    },
    [](Stage& s) {
      vtkTransform::SafeDownCast(s.GetActor(Behind)->GetUserTransform())->Translate(0.0, 7.0, 0.0);
    },
    Behind, Verdict::Visible },
  { "UserTransformInputInPlace",
    [](Stage& s)
    {
      vtkNew<vtkTransform> inner;
      vtkNew<vtkTransform> outer;
      outer->SetInput(inner);
      s.GetActor(Behind)->SetUserTransform(outer);
    },
    [](Stage& s)
    {
      auto* outer = vtkTransform::SafeDownCast(s.GetActor(Behind)->GetUserTransform());
      vtkTransform::SafeDownCast(outer->GetInput())->Translate(0.0, 7.0, 0.0);
    },
    Behind, Verdict::Visible },
  { "SourceRadius", AddPiped,
    [](Stage& s)
    { vtkSphereSource::SafeDownCast(GetMapper(s, Piped)->GetInputAlgorithm())->SetRadius(9.0); },
    Piped, Verdict::Visible },
  { "SourceCenter", AddPiped,
    [](Stage& s)
    {
      vtkSphereSource::SafeDownCast(GetMapper(s, Piped)->GetInputAlgorithm())
        ->SetCenter(0.0, 6.0, -3.0);
    },
    Piped, Verdict::Visible },
  { "FilterTransform", AddPipedTransform,
    [](Stage& s)
    {
      auto* filter = vtkTransformFilter::SafeDownCast(GetMapper(s, Piped)->GetInputAlgorithm());
      vtkTransform::SafeDownCast(filter->GetTransform())->Translate(0.0, 5.0, 0.0);
    },
    Piped, Verdict::Visible },
  { "SourceTwoFiltersUp", AddPipedTransform,
    [](Stage& s)
    {
      auto* filter = GetMapper(s, Piped)->GetInputAlgorithm();
      vtkSphereSource::SafeDownCast(filter->GetInputAlgorithm())->SetRadius(9.0);
    },
    Piped, Verdict::Visible },
  { "ConnectionReplaced", AddPiped,
    [](Stage& s)
    {
      vtkNew<vtkSphereSource> other;
      other->SetCenter(0.0, 6.0, -3.0);
      GetMapper(s, Piped)->SetInputConnection(other->GetOutputPort());
    },
    Piped, Verdict::Visible },
  { "BecomesTranslucent", Nothing,
    [](Stage& s) { s.GetActor(Behind)->GetProperty()->SetOpacity(0.5); }, Behind, Verdict::Hidden },
  { "BecomesWireframe", Nothing,
    [](Stage& s) { s.GetActor(Behind)->GetProperty()->SetRepresentationToWireframe(); }, Behind,
    Verdict::NotASurface },
  { "PropertyReplaced", Nothing,
    [](Stage& s)
    {
      vtkNew<vtkProperty> property;
      property->SetOpacity(0.5);
      s.GetActor(Behind)->SetProperty(property);
    },
    Behind, Verdict::Hidden },
  { "DepthOffsetSet", Nothing,
    [](Stage& s)
    {
      vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
      GetMapper(s, Behind)->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, -66000.0);
    },
    Behind, Verdict::DepthOffset },
  { "Recoloured", Nothing,
    [](Stage& s) { s.GetActor(Wall::Index)->GetProperty()->SetColor(1.0, 0.0, 0.5); }, Behind,
    Verdict::Hidden },
};

const Change OccluderChanges[] = {
  { "Invisible", Nothing, [](Stage& s) { s.Props[Wall::Index]->VisibilityOff(); }, Wall::Index,
    Verdict::Unknown },
  { "Removed", Nothing, [](Stage& s) { s.GetRenderer()->RemoveViewProp(s.Props[Wall::Index]); },
    Wall::Index, Verdict::Unknown },
  { "Moved", Nothing, [](Stage& s) { s.GetActor(Wall::Index)->SetPosition(7.0, 0.0, 0.0); },
    Wall::Index, Verdict::Visible },
  { "Translucent", Nothing,
    [](Stage& s) { s.GetActor(Wall::Index)->GetProperty()->SetOpacity(0.5); }, Wall::Index,
    Verdict::Translucent },
  { "ForceTranslucent", Nothing, [](Stage& s) { s.GetActor(Wall::Index)->ForceTranslucentOn(); },
    Wall::Index, Verdict::Translucent },
  { "Wireframe", Nothing,
    [](Stage& s) { s.GetActor(Wall::Index)->GetProperty()->SetRepresentationToWireframe(); },
    Wall::Index, Verdict::NotASurface },
  { "Points", Nothing,
    [](Stage& s) { s.GetActor(Wall::Index)->GetProperty()->SetRepresentationToPoints(); },
    Wall::Index, Verdict::NotASurface },
  { "FrontFacesCulled", Nothing,
    [](Stage& s)
    {
      s.GetActor(Wall::Index)->GetProperty()->FrontfaceCullingOn();
      s.GetActor(Wall::Index)->GetProperty()->BackfaceCullingOn();
    },
    Wall::Index, Verdict::Unknown },
  { "FacesRemovedBoundsTheSame", Nothing,
    [](Stage& s)
    {
      // Only the two small sides stay: same points, same bounds, a hole between.
      vtkPolyData* data = GetData(s, Wall::Index);
      vtkNew<vtkCellArray> faces;
      faces->InsertNextCell(data->GetCell(0));
      faces->InsertNextCell(data->GetCell(1));
      data->SetPolys(faces);
    },
    Wall::Index, Verdict::Unknown },
  { "Clipped", Nothing,
    [](Stage& s)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(1.0, 0.0, 0.0);
      GetMapper(s, Wall::Index)->AddClippingPlane(plane);
    },
    Wall::Index, Verdict::Unknown },
  { "ClippingPlaneMoved",
    [](Stage& s)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(1.0, 0.0, 0.0);
      plane->SetOrigin(-7.0, 0.0, 0.0);
      GetMapper(s, Wall::Index)->AddClippingPlane(plane);
    },
    [](Stage& s)
    { GetMapper(s, Wall::Index)->GetClippingPlanes()->GetItem(0)->SetOrigin(3.0, 0.0, 0.0); },
    Wall::Index, Verdict::Unknown },
  { "TextureWithAlpha", Nothing,
    [](Stage& s)
    { s.GetActor(Wall::Index)->SetTexture(TestScene::MakeTexture(TestScene::Translucency::Some)); },
    Wall::Index, Verdict::Translucent },
  { "ScalarsWithAlpha", Nothing,
    [](Stage& s)
    {
      vtkPolyData* data = GetData(s, Wall::Index);
      vtkNew<vtkUnsignedCharArray> colors;
      colors->SetNumberOfComponents(4);
      for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      {
        colors->InsertNextTuple4(200, 100, 50, 80);
      }
      data->GetPointData()->SetScalars(colors);
    },
    Wall::Index, Verdict::Translucent },
  // The table of the mapper, or of the array of scalars, is all that changes.
  { "OpacityInTheLookupTable", [](Stage& s) { AddTable(s, false); }, MakeTableTranslucent,
    Wall::Index, Verdict::Translucent },
  { "OpacityInTheLookupTableOfScalars", [](Stage& s) { AddTable(s, true); }, MakeTableTranslucent,
    Wall::Index, Verdict::Translucent },
  { "DataEmptied", Nothing, [](Stage& s) { GetData(s, Wall::Index)->Initialize(); }, Wall::Index,
    Verdict::Unknown },
};

const Change ViewChanges[] = {
  { "CameraMoved", Nothing, [](Stage& s) { Scenes::SetWallCamera(s.GetRenderer(), 9.0); }, Behind,
    Verdict::Unknown },
  { "ViewAngle", Nothing, [](Stage& s) { s.GetRenderer()->GetActiveCamera()->SetViewAngle(80.0); },
    Behind, Verdict::Hidden },
  { "ClippingRange", Nothing,
    [](Stage& s) { s.GetRenderer()->GetActiveCamera()->SetClippingRange(20.5, 60.0); }, Wall::Index,
    Verdict::Unknown },
  { "ParallelProjection", Nothing,
    [](Stage& s) { s.GetRenderer()->GetActiveCamera()->ParallelProjectionOn(); }, Behind,
    Verdict::Unknown },
  { "WindowCenter", Nothing,
    [](Stage& s) { s.GetRenderer()->GetActiveCamera()->SetWindowCenter(0.7, 0.3); }, Behind,
    Verdict::Unknown },
  { "CameraReplaced", Nothing,
    [](Stage& s)
    {
      vtkNew<vtkCamera> camera;
      s.GetRenderer()->SetActiveCamera(camera);
      Scenes::SetWallCamera(s.GetRenderer(), 9.0);
    },
    Behind, Verdict::Unknown },
  { "Viewport", Nothing, [](Stage& s) { s.GetRenderer()->SetViewport(0.3, 0.2, 0.9, 0.95); },
    Behind, Verdict::Hidden },
  { "OccluderSlidesAway", Nothing,
    [](Stage& s)
    {
      s.GetActor(Wall::Index)->SetPosition(2.0, 0.0, 0.0);
      Scenes::SetWallCamera(s.GetRenderer(), 0.3);
    },
    Wall::Index, Verdict::Visible },
};
}

INSTANTIATE_TEST_SUITE_P(Prop, CullerChanges, testing::ValuesIn(PropChanges), GetCaseName);
INSTANTIATE_TEST_SUITE_P(Occluder, CullerChanges, testing::ValuesIn(OccluderChanges), GetCaseName);
INSTANTIATE_TEST_SUITE_P(View, CullerChanges, testing::ValuesIn(ViewChanges), GetCaseName);

// Hazard: all props move and deform at once, and each has its own caches.
TEST(CullerChangesOnce, EverythingMoves)
{
  Comparison comparison(Scenes::BuildWall);
  for (int i = 0; i < 8; ++i)
  {
    comparison.Frame(
      [i](Stage& stage)
      {
        for (int prop = 1; prop < Wall::Count; ++prop)
        {
          stage.GetActor(prop)->AddPosition(
            0.3 * ((prop + i) % 3 - 1), 0.25 * ((prop + 2 * i) % 3 - 1), 0.2);
          stage.GetActor(prop)->RotateZ(10.0);
        }
      });
    EXPECT_GT(comparison.GetHidden(), 10);
  }
}
