// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The verdicts of instances, blocks, triangles and points of props that are drawn unit by unit.
#include "CompositeMapper.h"
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkIntArray.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
constexpr int Side = 8;
constexpr int PlacesOfKind = Side * Side;
constexpr int KindsOfProps = 3;
constexpr int Copies = 4; // There are so many parts at each place.
constexpr int Count = Copies * KindsOfProps * PlacesOfKind;

/// Where a part is and what the verdict on it is to be, seen from (0, -30, 0) with a wall at y = 0.
struct VerdictPlace
{
  glm::dvec3 Center;
  Verdict Expected;
};

/// The three kinds take turns, and the copies of a part are far from it in the list.
VerdictPlace GetPlace(int part)
{
  const int n = part / KindsOfProps % PlacesOfKind;
  const glm::dvec3 inGrid(n % Side - 3.5, 0.0, n / Side - 3.5);
  const VerdictPlace kinds[KindsOfProps] = { { inGrid + glm::dvec3(0.0, -5.0, 0.0),
                                               Verdict::Visible },
    { inGrid + glm::dvec3(0.0, 5.0, 0.0), Verdict::Hidden },
    { inGrid + glm::dvec3(100.0, 0.0, 0.0), Verdict::Outside } };
  return kinds[part % KindsOfProps];
}

void LookAtWall(Stage& stage, double x)
{
  vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
  camera->SetPosition(x, -30.0, 0.0);
  camera->SetFocalPoint(x, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetClippingRange(1.0, 200.0);
}

vtkSmartPointer<vtkPolyData> MakeParts(int corners)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int part = 0; part < Count; ++part)
  {
    cells->InsertNextCell(corners);
    for (int k = 0; k < corners; ++k)
    {
      const glm::dvec3 shift(k == 1 ? 0.3 : 0.0, 0.0, k == 2 ? 0.3 : 0.0);
      cells->InsertCellPoint(
        points->InsertNextPoint(glm::value_ptr(GetPlace(part).Center + shift)));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(corners == 1 ? cells.Get() : nullptr);
  data->SetPolys(corners == 3 ? cells.Get() : nullptr);
  return data;
}

/// The same triangles as blocks.
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks()
{
  vtkSmartPointer<vtkPolyData> all = MakeParts(3);
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int part = 0; part < Count; ++part)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({ 0, 1, 2 });
    for (int k = 0; k < 3; ++k)
    {
      points->InsertNextPoint(all->GetPoint(3 * part + k));
    }
    vtkNew<vtkPolyData> block;
    block->SetPoints(points);
    block->SetPolys(cells);
    blocks->SetBlock(part, block);
  }
  return blocks;
}

void SetGlyphs(vtkActor* actor)
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(MakeParts(1));
  mapper->SetSourceData(cube->GetOutput());
  mapper->SetScaleFactor(0.3);
  actor->SetMapper(mapper);
}

/// Each third point has another source.
void SetGlyphsOfSeveralSources(vtkActor* actor)
{
  SetGlyphs(actor);
  auto* mapper = static_cast<vtkGlyph3DMapper*>(actor->GetMapper());
  vtkNew<vtkIntArray> sources;
  sources->SetName("sources");
  for (int part = 0; part < Count; ++part)
  {
    sources->InsertNextValue(part % 3);
  }
  vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0))->GetPointData()->AddArray(sources);
  mapper->SetSourceIndexArray("sources");
  mapper->SourceIndexingOn();
  mapper->SetSourceData(1, mapper->GetSource(0));
  mapper->SetSourceData(2, mapper->GetSource(0));
}

void SetBlocks(vtkActor* actor)
{
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(MakeBlocks());
  actor->SetMapper(mapper);
}

struct VerdictKind : NamedCase
{
  int Corners;
  int UnitSize;
  std::function<void(vtkActor*)> SetMapper;
  int First = 0; ///< The number of the first part.
  int UnitsOfPlace = 1;
};
const VerdictKind KindsOfParts[] = { { "Instances", 1, 12, SetGlyphs, 0, Copies },
  { "InstancesOfSeveralSources", 1, 12, SetGlyphsOfSeveralSources, 0, Copies },
  { "Blocks", 3, 4, SetBlocks, 1, Copies }, { "Triangles", 3, 4, nullptr },
  { "Points", 1, 4, nullptr } };
}

using CullerVerdicts = testing::TestWithParam<VerdictKind>;
INSTANTIATE_TEST_SUITE_P(Each, CullerVerdicts, testing::ValuesIn(KindsOfParts), GetCaseName);

TEST_P(CullerVerdicts, EachPartHasItsOwn)
{
  ComparisonOptions options;
  options.Tuning.MinimumNumberOfCandidates = 1;
  options.Tuning.MinimumNumberOfPrimitives = 100;
  options.Tuning.UnitSize = this->GetParam().UnitSize;
  options.Tuning.DivideAfter = 0;
  options.Tuning.DivideInBackground = false;
  options.CompareDraws = false; // A mapper of which no instance is drawn announces nothing.
  Comparison comparison(
    [this](Stage& stage)
    {
      Scenes::AddBox(stage, 0.0, 0.0, 0.0, 30.0, 0.3, 30.0);
      const double white[3] = { 1.0, 1.0, 1.0 };
      stage.AddActor(MakeParts(this->GetParam().Corners), white);
      stage.GetActor(1)->GetProperty()->LightingOff();
      if (this->GetParam().SetMapper)
      {
        this->GetParam().SetMapper(stage.GetActor(1));
      }
    },
    options);
  int frame = 0;
  const auto move = [&]()
  {
    for (int i = 0; i < 6; ++i)
    {
      const double x = 0.01 * ++frame;
      comparison.Frame([x](Stage& stage) { LookAtWall(stage, x); });
    }
  };
  move();
  vtkNBufferCuller* culler = comparison.GetCuller();
  vtkActor* wall = comparison.Culled.GetActor(0);
  vtkActor* parts = comparison.Culled.GetActor(1);
  const vtkNBufferStatistics& statistics = comparison.GetStatistics();
  const int units = PlacesOfKind * this->GetParam().UnitsOfPlace;
  const int first = this->GetParam().First;
  const int hidden = first + 1;
  ASSERT_EQ(statistics.Units, KindsOfProps * units);
  EXPECT_EQ(statistics.UnitsHidden, units);
  EXPECT_EQ(statistics.UnitsOutside, units);
  for (int part = 0; part < Count; ++part)
  {
    ASSERT_EQ(culler->GetVerdict(parts, first + part), GetPlace(part).Expected) << part;
  }
  EXPECT_EQ(culler->GetVerdict(parts, hidden, comparison.Culled.GetRenderer()), Verdict::Hidden);
  for (const int part : { -1, first - 1, first + Count })
  {
    EXPECT_EQ(culler->GetVerdict(parts, part), Verdict::Unknown) << part;
  }
  EXPECT_EQ(culler->GetVerdict(nullptr, 0), Verdict::Unknown);
  EXPECT_EQ(culler->GetVerdict(comparison.Reference.GetActor(1), 0), Verdict::Unknown);
  EXPECT_EQ(culler->GetVerdict(wall, 0), Verdict::Visible) << "it is drawn whole";

  comparison.Frame("still");
  EXPECT_EQ(culler->GetVerdict(parts, first), Verdict::Visible);
  EXPECT_EQ(culler->GetVerdict(parts, hidden), Verdict::Hidden);

  culler->DividePropsOff();
  move();
  EXPECT_EQ(culler->GetVerdict(parts, hidden), culler->GetVerdict(parts)) << "it is drawn whole";
  culler->DividePropsOn();
  move();
  EXPECT_EQ(culler->GetVerdict(parts, hidden), Verdict::Hidden);

  // Behind the wall all parts have the verdict of the prop.
  comparison.Both([](Stage& stage) { stage.GetActor(1)->SetPosition(0.0, 20.0, 0.0); });
  move();
  EXPECT_EQ(culler->GetVerdict(parts, hidden), Verdict::Hidden);
  culler->EnabledOff();
  move();
  EXPECT_EQ(culler->GetVerdict(parts, hidden), Verdict::Untested);
}

// The pixels that keep a prop visible are seen past the occluder: a wall has a hole, and behind it
// stands a board that is seen through the hole alone.
TEST(CullerVerdictsOnce, AVisiblePropHasPixelsThatKeepIt)
{
  ComparisonOptions options;
  options.Tuning.MinimumNumberOfCandidates = 1;
  options.Tuning.TestPixels = false;
  Comparison comparison(
    [](Stage& stage)
    {
      for (const double side : { -1.0, 1.0 })
      {
        Scenes::AddBox(stage, 5.5 * side, 0.0, 0.0, 10.0, 0.3, 30.0);
        Scenes::AddBox(stage, 0.0, 0.0, 8.0 * side, 30.0, 0.3, 15.0);
      }
      Scenes::AddBox(stage, 0.0, 5.0, 0.0, 12.0, 0.3, 12.0); // The board.
      Scenes::AddBox(stage, 5.0, 5.0, 5.0, 1.0, 0.3, 1.0);   // Hidden.
      Scenes::AddBox(stage, 90.0, 5.0, 0.0, 1.0, 0.3, 1.0);  // Outside of the view.
    },
    options);
  for (const double x : { 0.0, 0.01 })
  {
    comparison.Frame([x](Stage& stage) { LookAtWall(stage, x); });
  }
  vtkNBufferCuller* culler = comparison.GetCuller();
  Stage& stage = comparison.Culled;
  const int* size = stage.GetRenderer()->GetSize();
  const auto find = [&](vtkProp* prop, int* pixels)
  { return culler->GetVisiblePixels(prop, pixels); };
  int pixels[4] = { 9, 9, 9, 9 };
  ASSERT_EQ(culler->GetVerdict(stage.GetActor(4)), Verdict::Visible);
  ASSERT_TRUE(find(stage.GetActor(4), pixels));
  const int factor = culler->GetTuning().BaseFactor;
  EXPECT_LE(pixels[2] - pixels[0], factor);
  EXPECT_LE(pixels[3] - pixels[1], factor);
  // The hole is one unit wide and high, in the middle of the picture.
  const double unit = size[1] / (60.0 * std::tan(vtkMath::RadiansFromDegrees(15.0)));
  EXPECT_NEAR(0.5 * (pixels[0] + pixels[2]), 0.5 * size[0], 0.5 * unit + factor);
  EXPECT_NEAR(0.5 * (pixels[1] + pixels[3]), 0.5 * size[1], 0.5 * unit + factor);

  const int none[4] = { 0, 0, 0, 0 };
  const Verdict verdicts[] = { Verdict::Hidden, Verdict::Outside };
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(culler->GetVerdict(stage.GetActor(5 + i)), verdicts[i]) << i;
    EXPECT_FALSE(find(stage.GetActor(5 + i), pixels)) << i;
    EXPECT_TRUE(std::equal(pixels, pixels + 4, none)) << i;
  }
  EXPECT_FALSE(find(nullptr, pixels));
  EXPECT_FALSE(find(comparison.Reference.GetActor(4), pixels)) << "of another renderer";

  comparison.Frame("still");
  EXPECT_TRUE(find(stage.GetActor(4), pixels)) << "the last test is still valid";
  culler->EnabledOff();
  comparison.Frame("not tested");
  EXPECT_FALSE(find(stage.GetActor(4), pixels));
}

// Ambient occlusion draws opaque props with one sample for each pixel. Where the window has more,
// what is translucent may have others, so that a pixel counts wherever it is touched.
TEST(CullerVerdictsOnce, AThinPropHasPixelsWhereTheWindowHasOtherSamples)
{
  for (const int samples : { 0, 4 })
  {
    ComparisonOptions options;
    options.Tuning.MinimumNumberOfCandidates = 1;
    Comparison comparison(
      [samples](Stage& stage)
      {
        stage.Window->SetMultiSamples(samples);
        stage.GetRenderer()->SetUseSSAO(true);
        Scenes::AddBox(stage, 0.021, 0.0, 0.0, 0.0001, 0.3, 0.0001);
        Scenes::AddBox(stage, 5.0, 0.0, 0.0, 1.0, 0.3, 1.0);
      },
      options);
    for (const double x : { 0.0, 0.01 })
    {
      comparison.Frame([x](Stage& stage) { LookAtWall(stage, x); });
    }
    vtkProp* thin = comparison.Culled.GetActor(0);
    int pixels[4];
    EXPECT_EQ(comparison.GetCuller()->GetVerdict(thin) == Verdict::Visible, samples > 0);
    EXPECT_EQ(comparison.GetCuller()->GetVisiblePixels(thin, pixels), samples > 0);
  }
}
