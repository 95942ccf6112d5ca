// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LargeProps.h"
#include "Scenes.h"
#include "TestedBackend.h"
#include "vtkNBufferComputePrograms.h"
#include "vtkNBufferVTKVersion.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace LargeProps
{
std::vector<Change> AndCommonChanges(std::vector<Change> changes)
{
  const Change common[] = {
    { "Actor",
      [](Stage& stage)
      {
        stage.GetActor(0)->SetPosition(2.0, 1.0, 0.3);
        stage.GetActor(0)->RotateX(4.0);
      } },
    { "Wireframe",
      [](Stage& stage) { stage.GetActor(0)->GetProperty()->SetRepresentationToWireframe(); },
      false },
    { "Edges", [](Stage& stage) { stage.GetActor(0)->GetProperty()->EdgeVisibilityOn(); },
      VTKNBUFFER_EDGES_KEEP_TRIANGLES },
    { "Removed", [](Stage& stage) { stage.GetRenderer()->RemoveActor(stage.GetActor(0)); }, false },
    { "Hidden", [](Stage& stage) { stage.GetActor(0)->VisibilityOff(); }, false },
    { "Window", [](Stage& stage) { stage.Window->SetSize(211, 307); } },
  };
  changes.insert(changes.end(), std::begin(common), std::end(common));
  return changes;
}

ComparisonOptions MakeOptions(int unitSize)
{
  ComparisonOptions options;
  options.Tuning.MinimumNumberOfCandidates = 1;
  options.Tuning.MinimumNumberOfPrimitives = 100;
  options.Tuning.UnitSize = unitSize;
  options.Tuning.DivideAfter = 0;
  options.Tuning.MinimumNumberOfUnitsOnDevice = 1;
  options.Tuning.DivideInBackground = false;
  return options;
}

ComparisonOptions MakeOptionsWithoutDraws(int unitSize)
{
  ComparisonOptions options = MakeOptions(unitSize);
  options.CompareDraws = false;
  return options;
}

void AddWalls(Stage& stage)
{
  Scenes::AddBox(stage, 6.0, 2.0, 1.0, 0.3, 12.0, 6.0);
  Scenes::AddBox(stage, -8.0, 12.0, 1.0, 10.0, 0.3, 6.0);
}

void AddSphereAndWalls(Stage& stage)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(12.0);
  sphere->SetCenter(0.0, 0.0, 4.0);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(40);
  sphere->Update();
  const double white[3] = { 1.0, 1.0, 1.0 };
  stage.AddActor(sphere->GetOutput(), white);
  AddWalls(stage);
}

void AddTallWalls(Stage& stage)
{
  Scenes::AddBox(stage, 6.0, 2.0, 1.0, 0.3, 22.0, 12.0);
  Scenes::AddBox(stage, -8.0, 12.0, 1.0, 20.0, 0.3, 12.0);
}

vtkSmartPointer<vtkPoints> MakeCloudPoints(int count)
{
  std::minstd_rand random(5);
  std::uniform_real_distribution<> uniform(-30.0, 30.0);
  auto points = vtkSmartPointer<vtkPoints>::New();
  for (int i = 0; i < count; ++i)
  {
    const double x = uniform(random);
    const double y = uniform(random);
    points->InsertNextPoint(x, y, 4.0 + uniform(random) / 7.5);
  }
  return points;
}

vtkSmartPointer<vtkPoints> MakeShuffledPoints(std::vector<glm::dvec3> places)
{
  std::shuffle(places.begin(), places.end(), std::minstd_rand(7));
  auto points = vtkSmartPointer<vtkPoints>::New();
  for (const glm::dvec3& place : places)
  {
    points->InsertNextPoint(glm::value_ptr(place));
  }
  return points;
}

namespace
{
void SetWalkCamera(vtkRenderer* renderer, int frame, double start, double above)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double t = 0.3 * frame;
  camera->SetPosition(
    frame < 8 ? start + 3.0 * frame : above, frame < 8 ? 2.0 : -50.0, frame < 8 ? 1.7 : 30.0);
  camera->SetFocalPoint(20.0 * std::cos(t), 20.0 * std::sin(t), 1.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetClippingRange(0.05, 200.0);
}

void CompareFrames(Comparison& comparison, const Path& path, int begin, int end)
{
  for (int i = begin; i < end; ++i)
  {
    comparison.Frame([&path, i](Stage& stage) { path(stage.GetRenderer(), i); });
  }
}
}

void Walk(vtkRenderer* renderer, int frame)
{
  SetWalkCamera(renderer, frame, -20.0, 0.0);
}

void WalkFromOutside(vtkRenderer* renderer, int frame)
{
  SetWalkCamera(renderer, frame, -40.0, 0.13);
}

Units CompareWalk(Comparison& comparison, const Path& path)
{
  Units units;
  for (int i = 0; i < 14; ++i)
  {
    CompareFrames(comparison, path, i, i + 1);
    units.Hidden += comparison.GetStatistics().UnitsHidden;
    units.OnDevice += comparison.GetStatistics().UnitsOnDevice;
    units.Fresh += i > 2 ? comparison.GetStatistics().UnitsFresh : 0;
    EXPECT_TRUE(i < 2 || comparison.GetStatistics().Units > 0)
      << i << comparison.GetCuller()->GetStatisticsAsJSON();
  }
  return units;
}

void CompareWalks(const Comparison::Change& build, ComparisonOptions options, int largeUnitSize,
  const Path& path, const Units& least, const std::function<void(Comparison&)>& afterwards)
{
  for (const int samples : { 0, 4 })
  {
    options.MultiSamples = samples;
    options.CompareDepth = samples == 0;
    if (samples > 0)
    {
      options.Tuning.UnitSize = largeUnitSize;
    }
    Comparison comparison(
      [&build](Stage& stage)
      {
        build(stage);
        stage.GetRenderer()->SetBackground(0.2, 0.3, 0.4);
      },
      options);
    const Units units = CompareWalk(comparison, path);
    EXPECT_GT(units.Hidden, least.Hidden / (TestsAllPixels(comparison.GetCuller()) ? 1 : 3));
    EXPECT_GT(units.Fresh, least.Fresh) << "units that come into view are drawn late";
    const bool hasShaders = vtkNBufferGL::ComputePrograms::WhyNot().empty();
    EXPECT_EQ(units.OnDevice > 0, hasShaders && !TestsAllPixels(comparison.GetCuller()));
    afterwards(comparison);
  }
}

void CompareChange(Comparison& comparison, const Comparison::Change& change, const Path& path)
{
  CompareFrames(comparison, path, 0, 4);
  EXPECT_GT(comparison.GetStatistics().Units, 0);
  comparison.Frame("changed", change);
  CompareFrames(comparison, path, 4, 10);
}

void CompareSwitch(Comparison& comparison, const Path& path, int units)
{
  for (const bool divides : { true, false, true })
  {
    comparison.GetCuller()->SetDivideProps(divides);
    CompareFrames(comparison, path, 0, 4);
    EXPECT_EQ(comparison.GetStatistics().Units, divides ? units : 0);
  }
}

static void ExpectSamePicks(Comparison& comparison)
{
  using Pick = std::pair<int, vtkIdType>; // A block, 0 without composite data, and a cell.
  std::vector<std::vector<Pick>> picked;
  comparison.Both(
    [&picked](Stage& stage)
    {
      vtkNew<vtkHardwareSelector> selector;
      selector->SetRenderer(stage.GetRenderer());
      selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
      selector->SetArea(0, 0, 300, 172);
      const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
      picked.emplace_back();
      for (unsigned int n = 0; n < selection->GetNumberOfNodes(); ++n)
      {
        vtkSelectionNode* node = selection->GetNode(n);
        auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
        const int block = node->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX());
        for (vtkIdType k = 0; ids && k < ids->GetNumberOfTuples(); ++k)
        {
          picked.back().emplace_back(block, ids->GetValue(k));
        }
      }
      std::sort(picked.back().begin(), picked.back().end());
    });
  ASSERT_EQ(picked.size(), 2U);
  EXPECT_GT(picked[0].size(), 0U);
  EXPECT_EQ(picked[0], picked[1]);
}

void ComparePicks(Comparison& comparison, const Path& path)
{
  int hidden = 0;
  for (int i = 0; i < 6; ++i)
  {
    CompareFrames(comparison, path, i, i + 1);
    hidden += comparison.GetStatistics().UnitsHidden;
    ExpectSamePicks(comparison);
  }
  EXPECT_GT(hidden, 0);
}
}
