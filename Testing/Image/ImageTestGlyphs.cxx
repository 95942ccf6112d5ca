// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Props with many instances of some sources, of which only those that can be seen are drawn.
#include "LargeProps.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkBitArray.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

using LargeProps::AddRandomArray;
using LargeProps::AddTallWalls;
using LargeProps::WalkFromOutside;

namespace
{
ComparisonOptions MakeGlyphOptions()
{
  return LargeProps::MakeOptionsWithoutDraws(12);
}

vtkSmartPointer<vtkPolyData> MakeCube(double length, bool withNormals = true)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(length);
  cube->SetYLength(length);
  cube->SetZLength(length);
  cube->Update();
  vtkSmartPointer<vtkPolyData> data = cube->GetOutput();
  if (!withNormals)
  {
    data->GetPointData()->SetNormals(nullptr);
  }
  return data;
}

/// Points with a color, a size and a direction each.
vtkSmartPointer<vtkPolyData> MakeGlyphData(vtkPoints* points)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  vtkPointData* values = data->GetPointData();
  const vtkIdType count = points->GetNumberOfPoints();
  values->SetScalars(AddRandomArray<vtkUnsignedCharArray>(values, count, "colors", 3, 0.0, 256.0));
  AddRandomArray<vtkFloatArray>(values, count, "sizes", 1, 0.5, 1.5);
  AddRandomArray<vtkFloatArray>(values, count, "directions", 3, -50.0, 50.0);
  return data;
}

vtkSmartPointer<vtkPolyData> MakeGlyphCloud(int count)
{
  return MakeGlyphData(LargeProps::MakeCloudPoints(count));
}

/// Points on a lattice with steps of 2, some of them twice, in no order.
vtkSmartPointer<vtkPolyData> MakeGlyphLattice()
{
  std::vector<glm::dvec3> places;
  for (int x = -12; x < 12; ++x)
  {
    for (int y = -12; y < 12; ++y)
    {
      for (int z = 0; z < 3; ++z)
      {
        places.emplace_back(2.0 * x, 2.0 * y, 2.0 * z);
      }
    }
  }
  places.insert(places.end(), places.begin(), places.begin() + 300);
  return MakeGlyphData(LargeProps::MakeShuffledPoints(places));
}

vtkGlyph3DMapper* GetGlyphMapper(Stage& stage)
{
  return static_cast<vtkGlyph3DMapper*>(stage.GetActor(0)->GetMapper());
}

vtkGlyph3DMapper* AddGlyphs(Stage& stage, vtkPolyData* data, vtkPolyData* source)
{
  const double white[3] = { 1.0, 1.0, 1.0 };
  stage.AddActor(source, white);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceData(source);
  mapper->ScalingOff();
  mapper->OrientOff();
  stage.GetActor(static_cast<int>(stage.Props.size()) - 1)->SetMapper(mapper);
  return mapper;
}

/// Gives each point one of these sources besides the first one, in no order.
void AddSources(vtkGlyph3DMapper* mapper, const std::vector<vtkSmartPointer<vtkPolyData>>& sources)
{
  auto* data = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const double end = static_cast<double>(sources.size()) + 1.0;
  AddRandomArray<vtkFloatArray>(
    data->GetPointData(), data->GetNumberOfPoints(), "sources", 1, 0.0, end);
  for (const auto& source : sources)
  {
    mapper->SetSourceData(mapper->GetNumberOfInputConnections(1), source);
  }
  mapper->SetSourceIndexArray("sources");
  mapper->SourceIndexingOn();
}

vtkSmartPointer<vtkPolyData> MakeRoundSource(double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->Update();
  return sphere->GetOutput();
}

void AddCubesAndSpheres(Stage& stage)
{
  AddSources(AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(1.5)),
    { MakeRoundSource(1.0), MakeCube(2.0, false) });
}

void MakeTranslucent(Stage& stage)
{
  for (const auto& prop : stage.Props)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (vtkGlyph3DMapper::SafeDownCast(actor->GetMapper()))
    {
      actor->GetProperty()->SetOpacity(0.4);
    }
  }
}

const LargeProps::Case GlyphCases[] = {
  { "CloudAndWalls",
    [](Stage& stage)
    {
      AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(1.0));
      AddTallWalls(stage);
    } },
  { "WallsFirst",
    [](Stage& stage)
    {
      AddTallWalls(stage);
      AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(1.0));
    } },
  { "DenseCloud", [](Stage& stage) { AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(2.5)); } },
  { "WithoutNormals",
    [](Stage& stage)
    {
      AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(2.5, false));
      stage.GetActor(0)->GetProperty()->SetAmbient(0.4);
    } },
  { "ValuesOfCells",
    [](Stage& stage)
    {
      const vtkSmartPointer<vtkPolyData> cube = MakeCube(2.5, false);
      vtkNew<vtkUnsignedCharArray> colors;
      colors->SetNumberOfComponents(3);
      vtkNew<vtkFloatArray> normals;
      normals->SetNumberOfComponents(3);
      for (int face = 0; face < 6; ++face)
      {
        colors->InsertNextTuple3(40 * face, 255 - 30 * face, 90 * (face % 3));
        normals->InsertNextTuple3(0.1 * face, 0.5 - 0.2 * face, 0.8);
      }
      cube->GetCellData()->SetScalars(colors);
      cube->GetCellData()->SetNormals(normals);
      AddGlyphs(stage, MakeGlyphCloud(2500), cube);
    } },
  { "OneColor",
    [](Stage& stage)
    {
      AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(2.5))->ScalarVisibilityOff();
      stage.GetActor(0)->GetProperty()->SetColor(0.2, 0.9, 0.4);
    } },
  { "Unlit",
    [](Stage& stage)
    {
      AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(2.5));
      stage.GetActor(0)->GetProperty()->LightingOff();
    } },
  { "Lattice", [](Stage& stage) { AddGlyphs(stage, MakeGlyphLattice(), MakeCube(2.0)); } },
  { "LatticeAndWalls",
    [](Stage& stage)
    {
      AddTallWalls(stage);
      AddGlyphs(stage, MakeGlyphLattice(), MakeCube(2.0));
      Scenes::AddBox(stage, 1.0, 1.0, 3.0, 6.0, 6.0, 6.0); // shares planes with the cubes
      AddTallWalls(stage);
    } },
  { "ScaledAndTurned",
    [](Stage& stage)
    {
      vtkGlyph3DMapper* mapper = AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(2.0));
      mapper->ScalingOn();
      mapper->SetScaleModeToScaleByMagnitude();
      mapper->SetScaleArray("sizes");
      mapper->OrientOn();
      mapper->SetOrientationModeToDirection();
      mapper->SetOrientationArray("directions");
      stage.GetActor(0)->RotateZ(20.0);
      stage.GetActor(0)->SetScale(1.0, 0.8, 1.1);
      AddTallWalls(stage);
    } },
  { "Spheres",
    [](Stage& stage)
    {
      vtkNew<vtkSphereSource> sphere;
      sphere->SetCenter(0.4, -0.3, 0.2);
      sphere->Update();
      AddGlyphs(stage, MakeGlyphCloud(2500), sphere->GetOutput())->SetScaleFactor(2.0);
      GetGlyphMapper(stage)->ScalingOn();
      AddTallWalls(stage);
    } },
  { "ClippingPlane",
    [](Stage& stage)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.6, 0.0, 0.8);
      AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(2.0))->AddClippingPlane(plane);
      AddTallWalls(stage);
    } },
  { "SeveralSources",
    [](Stage& stage)
    {
      AddCubesAndSpheres(stage);
      AddTallWalls(stage);
    } },
  { "CubesOfSeveralSources",
    [](Stage& stage)
    {
      AddSources(
        AddGlyphs(stage, MakeGlyphLattice(), MakeCube(2.0)), { MakeCube(2.0), MakeCube(2.0) });
      AddTallWalls(stage);
    } },
  { "SourcesWithoutPoints",
    [](Stage& stage)
    {
      vtkNew<vtkPolyData> empty;
      AddSources(
        AddGlyphs(stage, MakeGlyphCloud(3500), empty), { MakeCube(1.5), empty, MakeCube(2.0) });
      AddTallWalls(stage);
    } },
  { "SourcesNotIndexed",
    [](Stage& stage)
    {
      AddCubesAndSpheres(stage);
      GetGlyphMapper(stage)->SourceIndexingOff();
      AddTallWalls(stage);
    } },
  { "Translucent",
    [](Stage& stage)
    {
      AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(1.0));
      MakeTranslucent(stage);
      AddTallWalls(stage);
    } },
  { "TranslucentOfSeveralSources",
    [](Stage& stage)
    {
      AddTallWalls(stage);
      AddCubesAndSpheres(stage);
      MakeTranslucent(stage);
      AddGlyphs(stage, MakeGlyphLattice(), MakeCube(0.5));
    } },
  { "TranslucentPeeled",
    [](Stage& stage)
    {
      AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(1.0));
      MakeTranslucent(stage);
      AddTallWalls(stage);
      stage.Window->SetMultiSamples(0); // VTK peels with one sample only.
      stage.Window->AlphaBitPlanesOn();
      stage.GetRenderer()->UseDepthPeelingOn();
    } },
  { "TranslucentColors",
    [](Stage& stage)
    {
      const vtkSmartPointer<vtkPolyData> data = MakeGlyphCloud(2500);
      data->GetPointData()->SetScalars(AddRandomArray<vtkUnsignedCharArray>(
        data->GetPointData(), data->GetNumberOfPoints(), "colors", 4, 0.0, 256.0));
      AddGlyphs(stage, data, MakeCube(1.0));
      AddTallWalls(stage);
    } },
  { "TwoProps",
    [](Stage& stage)
    {
      AddGlyphs(stage, MakeGlyphLattice(), MakeCube(2.0));
      AddGlyphs(stage, MakeGlyphLattice(), MakeCube(2.0));
      stage.GetActor(1)->SetPosition(1.0, 0.0, 2.0);
    } },
};
}

using CullerGlyphs = testing::TestWithParam<LargeProps::Case>;
INSTANTIATE_TEST_SUITE_P(Each, CullerGlyphs, testing::ValuesIn(GlyphCases), GetCaseName);

// Hazard: the boxes of instances are too small, instances are drawn in another order, fresh
// instances are drawn over those that come after them, or the culler's buffers stay attached.
TEST_P(CullerGlyphs, SameImage)
{
  LargeProps::CompareWalks(this->GetParam().Build, MakeGlyphOptions(), 100, WalkFromOutside,
    { 100, 10 },
    [](Comparison& comparison)
    {
      comparison.Frame("still");
      comparison.Frame("still");
    });
}

//------------------------------------------------------------------------------------------------
namespace
{
vtkPolyData* GetGlyphData(Stage& stage)
{
  return vtkPolyData::SafeDownCast(GetGlyphMapper(stage)->GetInputDataObject(0, 0));
}

vtkPolyData* GetSource(Stage& stage)
{
  return vtkPolyData::SafeDownCast(GetGlyphMapper(stage)->GetInputDataObject(1, 0));
}

const std::vector<LargeProps::Change> GlyphChanges = LargeProps::AndCommonChanges({
  { "Points",
    [](Stage& stage)
    {
      TestScene::MovePoints(GetGlyphData(stage)->GetPoints(), { 1.0, 2.0, 0.5 }, 0.3);
      GetGlyphData(stage)->Modified();
    } },
  { "FewerPoints", [](Stage& stage) { GetGlyphMapper(stage)->SetInputData(MakeGlyphCloud(500)); } },
  { "SourcePoints",
    [](Stage& stage)
    {
      TestScene::MovePoints(GetSource(stage)->GetPoints(), { 0.0, 0.0, 1.0 }, 0.5);
      GetSource(stage)->Modified();
    } },
  { "Source", [](Stage& stage) { GetGlyphMapper(stage)->SetSourceData(MakeCube(0.7, false)); } },
  { "ScaleFactor",
    [](Stage& stage)
    {
      GetGlyphMapper(stage)->ScalingOn();
      GetGlyphMapper(stage)->SetScaleFactor(0.4);
    } },
  { "Colors",
    [](Stage& stage)
    {
      GetGlyphMapper(stage)->ScalarVisibilityOff();
      stage.GetActor(0)->GetProperty()->SetColor(0.3, 0.8, 0.1);
    } },
  { "ColorOfProperty",
    [](Stage& stage) { stage.GetActor(0)->GetProperty()->SetColor(0.3, 0.8, 0.1); } },
  { "Lighting", [](Stage& stage) { stage.GetActor(0)->GetProperty()->LightingOff(); } },
  { "Mapper",
    [](Stage& stage)
    {
      vtkNew<vtkGlyph3DMapper> mapper;
      mapper->SetInputData(MakeGlyphCloud(2000));
      mapper->SetSourceData(MakeCube(1.5));
      mapper->ScalingOff();
      mapper->OrientOff();
      stage.GetActor(0)->SetMapper(mapper);
    } },
  { "Mask",
    [](Stage& stage)
    {
      vtkNew<vtkBitArray> mask;
      mask->SetName("mask");
      for (vtkIdType i = 0; i < GetGlyphData(stage)->GetNumberOfPoints(); ++i)
      {
        mask->InsertNextValue(i % 3 == 0);
      }
      GetGlyphData(stage)->GetPointData()->AddArray(mask);
      GetGlyphMapper(stage)->SetMaskArray("mask");
      GetGlyphMapper(stage)->MaskingOn();
    },
    false },
  { "TwoSources",
    [](Stage& stage)
    {
      GetGlyphMapper(stage)->SetSourceData(1, MakeCube(0.5));
      GetGlyphMapper(stage)->SetSourceIndexArray("sizes");
      GetGlyphMapper(stage)->SourceIndexingOn();
    } },
  { "SecondSourceOfLines",
    [](Stage& stage)
    {
      vtkNew<vtkCellArray> lines;
      lines->InsertNextCell({ 0, 7 });
      vtkSmartPointer<vtkPolyData> source = MakeCube(0.5);
      source->SetPolys(nullptr);
      source->SetLines(lines);
      AddSources(GetGlyphMapper(stage), { source });
    },
    false },
  { "Lines",
    [](Stage& stage)
    {
      vtkNew<vtkCellArray> lines;
      lines->InsertNextCell({ 0, 7 });
      GetSource(stage)->SetLines(lines);
      GetSource(stage)->Modified();
    },
    false },
  { "SharedMapper",
    [](Stage& stage)
    {
      AddGlyphs(stage, MakeGlyphCloud(10), MakeCube(1.0));
      vtkActor* other = stage.GetActor(static_cast<int>(stage.Props.size()) - 1);
      other->SetMapper(stage.GetActor(0)->GetMapper());
      other->SetPosition(3.0, 0.0, 1.0);
      other->GetProperty()->SetColor(1.0, 0.0, 0.0);
    } },
  { "Opacity", [](Stage& stage) { stage.GetActor(0)->GetProperty()->SetOpacity(0.5); } },
});
}

using CullerGlyphsChanges = testing::TestWithParam<LargeProps::Change>;
INSTANTIATE_TEST_SUITE_P(Each, CullerGlyphsChanges, testing::ValuesIn(GlyphChanges), GetCaseName);

// Hazard: the data, or the way in which they are drawn, have changed, and the former instances are
// used.
TEST_P(CullerGlyphsChanges, SameImage)
{
  Comparison comparison(
    [](Stage& stage)
    {
      AddGlyphs(stage, MakeGlyphCloud(2500), MakeCube(2.0));
      AddTallWalls(stage);
    },
    MakeGlyphOptions());
  LargeProps::CompareChange(comparison, this->GetParam().Apply, WalkFromOutside);
  EXPECT_EQ(comparison.GetStatistics().Units > 0, this->GetParam().IsDividedAfterwards);
}

// Hazard: of several sources, only changes of the first one are noticed.
TEST(CullerGlyphsSources, EachMayChange)
{
  Comparison comparison(
    [](Stage& stage)
    {
      AddCubesAndSpheres(stage);
      AddTallWalls(stage);
    },
    MakeGlyphOptions());
  for (int source = 0; source < 3; ++source)
  {
    LargeProps::CompareChange(
      comparison,
      [source](Stage& stage)
      {
        vtkPolyData* data = GetGlyphMapper(stage)->GetSource(source);
        TestScene::MovePoints(data->GetPoints(), { 0.0, 0.0, 2.0 }, 0.5);
        data->Modified();
      },
      WalkFromOutside);
    EXPECT_GT(comparison.GetStatistics().UnitsHidden, 0);
  }
}

// Hazard: translucent glyphs that are hidden as a whole are drawn, or stay hidden.
TEST(CullerGlyphsTranslucent, HiddenAsAWhole)
{
  Comparison comparison(
    [](Stage& stage)
    {
      AddGlyphs(stage, MakeGlyphCloud(500), MakeCube(1.0));
      MakeTranslucent(stage);
      Scenes::AddBox(stage, 0.0, -35.0, 0.0, 200.0, 0.3, 200.0);
      Scenes::AddBox(stage, 0.0, 40.0, 0.0, 1.0, 1.0, 1.0);
    },
    MakeGlyphOptions());
  for (int i = 0; i < 9; ++i)
  {
    comparison.Frame(
      [i](Stage& stage)
      {
        vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
        camera->SetPosition(0.1 * i, -60.0, 4.0);
        camera->SetFocalPoint(0.0, 0.0, 4.0);
        camera->SetViewUp(0.0, 0.0, 1.0);
        camera->SetClippingRange(1.0, 200.0);
        stage.GetActor(1)->SetPosition(0.0, 0.0, i == 7 ? 120.0 : 0.0);
      });
    const bool isHidden = i > 1 && i != 7;
    EXPECT_EQ(comparison.GetVerdict(0), isHidden ? Verdict::Hidden : Verdict::Translucent) << i;
    if (isHidden)
    {
      const vtkNBufferStatistics& statistics = comparison.GetStatistics();
      EXPECT_GT(statistics.UnitsHidden, 400) << i;
      EXPECT_EQ(statistics.UnitsHidden + statistics.UnitsOutside, statistics.Units) << i;
    }
  }
  comparison.Frame("still");
  EXPECT_EQ(comparison.GetVerdict(0), Verdict::Hidden);
}

// Hazard: hidden instances cannot be picked, or have the ids of others.
TEST(CullerGlyphsPicking, SamePoints)
{
  Comparison comparison(
    [](Stage& stage) { AddGlyphs(stage, MakeGlyphCloud(800), MakeCube(2.5)); }, MakeGlyphOptions());
  LargeProps::ComparePicks(comparison, WalkFromOutside);
}

TEST(CullerGlyphsPicking, SamePointsOfSeveralSources)
{
  Comparison comparison(AddCubesAndSpheres, MakeGlyphOptions());
  LargeProps::ComparePicks(comparison, WalkFromOutside);
}

// Each instance is a unit, with DivideProps on and off.
TEST(CullerGlyphsSettings, SizeAndSwitch)
{
  Comparison comparison([](Stage& stage) { AddGlyphs(stage, MakeGlyphCloud(1000), MakeCube(2.5)); },
    MakeGlyphOptions());
  LargeProps::CompareSwitch(comparison, WalkFromOutside, 1000);
}
