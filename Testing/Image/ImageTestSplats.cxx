// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Props of vtkPointGaussianMapper, of which only the points that can be seen are drawn, or which
// are blended among opaque props.
#include "LargeProps.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

using LargeProps::AddRandomArray;
using LargeProps::AddTallWalls;
using LargeProps::MakeOptionsWithoutDraws;
using LargeProps::WalkFromOutside;

namespace
{
/// Points, each with a color, a size and an opacity; optionally with vertices for two of three.
vtkSmartPointer<vtkPolyData> MakeSplatData(vtkPoints* points, bool withVertices)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  vtkPointData* values = data->GetPointData();
  const vtkIdType count = points->GetNumberOfPoints();
  values->SetScalars(AddRandomArray<vtkUnsignedCharArray>(values, count, "colors", 3, 0.0, 256.0));
  AddRandomArray<vtkFloatArray>(values, count, "sizes", 1, 0.1, 0.6);
  AddRandomArray<vtkFloatArray>(values, count, "opacities", 1, 0.0, 1.0);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < count; ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  if (withVertices)
  {
    data->SetVerts(vertices);
  }
  return data;
}

vtkSmartPointer<vtkPolyData> MakeSplatCloud(int count, bool withVertices = false)
{
  return MakeSplatData(LargeProps::MakeCloudPoints(count), withVertices);
}

/// Points on a lattice with steps of 1, each of them twice, with another color.
vtkSmartPointer<vtkPolyData> MakeSplatLattice()
{
  std::vector<glm::dvec3> places;
  for (int x = -20; x < 20; ++x)
  {
    for (int y = -20; y < 20; ++y)
    {
      places.insert(places.end(), 2, { 1.0 * x, 1.0 * y, 0.5 * ((x + y) % 8) });
    }
  }
  return MakeSplatData(LargeProps::MakeShuffledPoints(places), false);
}

vtkPointGaussianMapper* GetSplatMapper(Stage& stage)
{
  return static_cast<vtkPointGaussianMapper*>(stage.GetActor(0)->GetMapper());
}

/// Add opaque points of 9 pixels.
vtkPointGaussianMapper* AddSplats(Stage& stage, vtkPolyData* data)
{
  const double white[3] = { 1.0, 1.0, 1.0 };
  stage.AddActor(data, white);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleFactor(0.0);
  mapper->EmissiveOff();
  vtkActor* actor = stage.GetActor(static_cast<int>(stage.Props.size()) - 1);
  actor->SetMapper(mapper);
  actor->GetProperty()->SetPointSize(9.0);
  return mapper;
}

const LargeProps::Case SplatCases[] = {
  { "CloudAndWalls",
    [](Stage& stage)
    {
      AddSplats(stage, MakeSplatCloud(4000));
      AddTallWalls(stage);
    } },
  { "WallsFirst",
    [](Stage& stage)
    {
      AddTallWalls(stage);
      AddSplats(stage, MakeSplatCloud(4000, true));
    } },
  { "LargePoints",
    [](Stage& stage)
    {
      AddSplats(stage, MakeSplatCloud(4000));
      stage.GetActor(0)->GetProperty()->SetPointSize(60.0);
    } },
  { "Lattice",
    [](Stage& stage)
    {
      AddSplats(stage, MakeSplatLattice());
      Scenes::AddBox(stage, 1.0, 1.0, 0.0, 6.0, 6.0, 6.0); // shares planes with the points
      AddTallWalls(stage);
    } },
  { "OneColor",
    [](Stage& stage)
    {
      AddSplats(stage, MakeSplatCloud(4000, true))->ScalarVisibilityOff();
      AddTallWalls(stage);
    } },
  { "ScaledAndTurned",
    [](Stage& stage)
    {
      AddSplats(stage, MakeSplatCloud(4000));
      stage.GetActor(0)->RotateZ(20.0);
      stage.GetActor(0)->SetScale(1.0, 0.8, 1.1);
      AddTallWalls(stage);
    } },
  { "ClippingPlane",
    [](Stage& stage)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.6, 0.0, 0.8);
      AddSplats(stage, MakeSplatCloud(4000))->AddClippingPlane(plane);
      AddTallWalls(stage);
    } },
  // Both mappers have the same buffer, which the other one shifts.
  { "PointsOfAnotherMapper",
    [](Stage& stage)
    {
      const vtkSmartPointer<vtkPolyData> data = MakeSplatCloud(4000, true);
      AddSplats(stage, data);
      const double white[3] = { 1.0, 1.0, 1.0 };
      stage.AddActor(data, white);
      stage.GetActor(1)->SetPosition(2.0, 1.0, 0.0);
      AddTallWalls(stage);
    } },
  { "TwoProps",
    [](Stage& stage)
    {
      AddSplats(stage, MakeSplatLattice());
      AddSplats(stage, MakeSplatLattice());
      AddTallWalls(stage);
    } },
};
}

using CullerSplats = testing::TestWithParam<LargeProps::Case>;
INSTANTIATE_TEST_SUITE_P(Each, CullerSplats, testing::ValuesIn(SplatCases), GetCaseName);

// Hazard: points reach out of the boxes of their units, or are drawn in another order.
TEST_P(CullerSplats, SameImage)
{
  LargeProps::CompareWalks(this->GetParam().Build, MakeOptionsWithoutDraws(), 16, WalkFromOutside,
    { 20, 5 },
    [](Comparison& comparison)
    {
      comparison.Frame("still");
      comparison.Frame("still");
    });
}

//------------------------------------------------------------------------------------------------
namespace
{
enum class Outcome
{
  Divided,
  Whole,
  Blended
};

struct SplatChange : NamedCase
{
  Comparison::Change Apply;
  Outcome Afterwards = Outcome::Divided;
};

/// Shader code of opaque discs.
const char* const Discs = "//VTK::Color::Impl\n"
                          "if (dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy) > 1.0) { discard; }\n";

const SplatChange SplatChanges[] = {
  { "Points",
    [](Stage& stage)
    {
      vtkPolyData* data =
        vtkPolyData::SafeDownCast(GetSplatMapper(stage)->GetInputDataObject(0, 0));
      TestScene::MovePoints(data->GetPoints(), { 1.0, 2.0, 0.5 }, 0.3);
      data->Modified();
    } },
  { "FewerPoints", [](Stage& stage) { GetSplatMapper(stage)->SetInputData(MakeSplatCloud(500)); } },
  { "Vertices",
    [](Stage& stage) { GetSplatMapper(stage)->SetInputData(MakeSplatCloud(3000, true)); } },
  { "PointSize", [](Stage& stage) { stage.GetActor(0)->GetProperty()->SetPointSize(31.0); } },
  { "Colors", [](Stage& stage) { GetSplatMapper(stage)->ScalarVisibilityOff(); } },
  { "Actor", [](Stage& stage) { stage.GetActor(0)->SetPosition(2.0, 1.0, 0.3); } },
  { "Mapper",
    [](Stage& stage)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(MakeSplatCloud(2000, true));
      stage.GetActor(0)->SetMapper(mapper);
    } },
  { "Window", [](Stage& stage) { stage.Window->SetSize(211, 307); } },
  { "Discs",
    [](Stage& stage)
    {
      GetSplatMapper(stage)->SetScaleFactor(0.4);
      GetSplatMapper(stage)->SetSplatShaderCode(Discs);
    },
    Outcome::Whole },
  { "DiscsOfSizes",
    [](Stage& stage)
    {
      GetSplatMapper(stage)->SetScaleFactor(1.0);
      GetSplatMapper(stage)->SetScaleArray("sizes");
      GetSplatMapper(stage)->SetSplatShaderCode(Discs);
    },
    Outcome::Whole },
  { "Spheres", [](Stage& stage) { stage.GetActor(0)->GetProperty()->RenderPointsAsSpheresOn(); },
    Outcome::Whole },
  { "Blocks",
    [](Stage& stage)
    {
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, MakeSplatCloud(1000));
      blocks->SetBlock(1, MakeSplatCloud(300, true));
      GetSplatMapper(stage)->SetInputDataObject(blocks);
    },
    Outcome::Whole },
  { "Translucent", [](Stage& stage) { stage.GetActor(0)->GetProperty()->SetOpacity(0.5); },
    Outcome::Whole },
  { "Removed", [](Stage& stage) { stage.GetRenderer()->RemoveActor(stage.GetActor(0)); },
    Outcome::Whole },
  { "ScaleFactor", [](Stage& stage) { GetSplatMapper(stage)->SetScaleFactor(0.4); },
    Outcome::Blended },
  { "Sizes",
    [](Stage& stage)
    {
      GetSplatMapper(stage)->SetScaleFactor(1.0);
      GetSplatMapper(stage)->SetScaleArray("sizes");
    },
    Outcome::Blended },
  { "CodeWithOpacity",
    [](Stage& stage)
    {
      GetSplatMapper(stage)->SetScaleFactor(0.4);
      GetSplatMapper(stage)->SetSplatShaderCode("//VTK::Color::Impl\nopacity = opacity * 0.5;\n");
    },
    Outcome::Blended },
  { "Emissive", [](Stage& stage) { GetSplatMapper(stage)->EmissiveOn(); }, Outcome::Blended },
  { "EmissiveSplats",
    [](Stage& stage)
    {
      GetSplatMapper(stage)->EmissiveOn();
      GetSplatMapper(stage)->SetScaleFactor(0.4);
    },
    Outcome::Blended },
  { "Opacities", [](Stage& stage) { GetSplatMapper(stage)->SetOpacityArray("opacities"); },
    Outcome::Blended },
};
}

using CullerSplatsChanges = testing::TestWithParam<SplatChange>;
INSTANTIATE_TEST_SUITE_P(Each, CullerSplatsChanges, testing::ValuesIn(SplatChanges), GetCaseName);

// Hazard: the data, or the way in which they are drawn, have changed, and the former points are
// used; or splats begin to blend with what is drawn before them, which must then be neither left
// out nor drawn later.
TEST_P(CullerSplatsChanges, SameImage)
{
  Comparison comparison(
    [](Stage& stage)
    {
      AddSplats(stage, MakeSplatCloud(4000));
      AddTallWalls(stage);
    },
    MakeOptionsWithoutDraws());
  LargeProps::CompareChange(comparison, this->GetParam().Apply, WalkFromOutside);
  const Outcome outcome = this->GetParam().Afterwards;
  EXPECT_EQ(comparison.GetStatistics().Units > 0, outcome == Outcome::Divided);
  EXPECT_EQ(comparison.GetDecision() == Decision::Blending, outcome == Outcome::Blended);
}

// Hazard: splats in front of boxes blend with what was drawn before them.
TEST(CullerSplatsBlending, InFrontOfWhatTheyHide)
{
  for (const bool emissive : { false, true })
  {
    int last = -1;
    Comparison comparison(
      [emissive, &last](Stage& stage)
      {
        Scenes::BuildWall(stage);
        const vtkSmartPointer<vtkPolyData> data = MakeSplatCloud(200);
        AddSplats(stage, data);
        vtkActor* actor = stage.GetActor(static_cast<int>(stage.Props.size()) - 1);
        auto* mapper = static_cast<vtkPointGaussianMapper*>(actor->GetMapper());
        mapper->SetScaleFactor(1.5);
        mapper->SetEmissive(emissive);
        actor->SetScale(0.2, 0.2, 0.2);
        actor->SetPosition(0.0, 0.0, 4.0);
        last = Scenes::AddBox(stage, 0.0, 5.0, -2.0, 9.0, 2.0, 0.5);
      });
    for (int i = 0; i < 6; ++i)
    {
      Scenes::FrameOfWall(comparison, 1.0 * i);
      EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
      EXPECT_GT(comparison.GetHidden(), Scenes::Wall::Behind / 2);
      EXPECT_EQ(comparison.GetVerdict(last), Verdict::Blended);
    }
  }
}

// Hazard: hidden points cannot be picked, or have the ids of others.
TEST(CullerSplatsPicking, SamePoints)
{
  Comparison comparison(
    [](Stage& stage)
    {
      AddSplats(stage, MakeSplatCloud(800, true));
      AddTallWalls(stage);
    },
    MakeOptionsWithoutDraws());
  LargeProps::ComparePicks(comparison, WalkFromOutside);
}

// The number of units, with DivideProps on and off.
TEST(CullerSplatsSettings, SizeAndSwitch)
{
  Comparison comparison(
    [](Stage& stage) { AddSplats(stage, MakeSplatCloud(1000)); }, MakeOptionsWithoutDraws(50));
  LargeProps::CompareSwitch(comparison, WalkFromOutside, 1000 / 50);
}
