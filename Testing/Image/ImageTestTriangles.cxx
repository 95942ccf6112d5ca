// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Props whose triangles are hidden and whose boxes are not.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace
{
constexpr int TrianglesWidth = 160;
constexpr int TrianglesHeight = 120;

/// A wall with a notch at the upper right, and behind it a triangle. The upper right corner of the
/// triangle's box is in the notch, and no corner of the triangle. Its place in Stage::Props is 2. A
/// prop that is seen in the notch, far behind, is the one that is held back where all are visible.
void BuildNotch(Stage& stage)
{
  Scenes::SetPixelCamera(stage.GetRenderer(), TrianglesWidth, TrianglesHeight);
  Scenes::AddQuad(stage, 0, 0, TrianglesWidth, 60, 0.0);
  Scenes::AddQuad(stage, 0, 60, 80, TrianglesHeight, 0.0);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(20, 20, -5);
  points->InsertNextPoint(130, 20, -5);
  points->InsertNextPoint(20, 90, -5);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> triangle;
  triangle->SetPoints(points);
  triangle->SetPolys(cells);
  const double color[3] = { 0.9, 0.4, 0.2 };
  stage.AddActor(triangle, color);
  Scenes::AddQuad(stage, 140, 100, 150, 110, -50.0);
}

vtkPolyData* GetTriangle(Stage& stage)
{
  return vtkPolyData::SafeDownCast(stage.GetActor(2)->GetMapper()->GetInput());
}

/// The same with a filter in front of the mapper of the triangle.
void BuildFilteredNotch(Stage& stage)
{
  BuildNotch(stage);
  vtkNew<vtkAppendPolyData> filter;
  filter->SetInputData(GetTriangle(stage));
  stage.GetActor(2)->GetMapper()->SetInputConnection(filter->GetOutputPort());
}

struct TriangleChange : NamedCase
{
  Comparison::Change Apply;
};

const TriangleChange TriangleChanges[] = {
  { "Points",
    [](Stage& stage)
    {
      GetTriangle(stage)->GetPoints()->SetPoint(1, 130, 90, -5);
      GetTriangle(stage)->GetPoints()->Modified();
    } },
  { "Cells",
    [](Stage& stage)
    {
      GetTriangle(stage)->GetPoints()->InsertNextPoint(130, 90, -5);
      GetTriangle(stage)->GetPoints()->Modified();
      GetTriangle(stage)->GetPolys()->InsertNextCell({ 0, 1, 3 });
      GetTriangle(stage)->GetPolys()->Modified();
    } },
  { "Lines",
    [](Stage& stage)
    {
      vtkNew<vtkCellArray> lines;
      lines->InsertNextCell({ 0, 3 });
      GetTriangle(stage)->GetPoints()->InsertNextPoint(130, 90, -5);
      GetTriangle(stage)->SetLines(lines);
    } },
  { "Actor", [](Stage& stage) { stage.GetActor(2)->SetPosition(0, 25, 0); } },
};
}

using CullerTriangles = testing::TestWithParam<TriangleChange>;

// Hazard: triangles are not tested, or the triangles of former data are tested.
TEST_P(CullerTriangles, BehindTheEdgeOfAWall)
{
  ComparisonOptions options = Scenes::MakeExactOptions(TrianglesWidth, TrianglesHeight, 4);
  options.Backend = vtkNBufferCuller::CPU;
  Comparison comparison(BuildNotch, options);
  for (int i = 0; i < 5; ++i)
  {
    comparison.Frame("unchanged");
  }
  EXPECT_EQ(comparison.GetVerdict(2), Verdict::Hidden);
  EXPECT_EQ(comparison.GetStatistics().HiddenByTriangles, 1);
  comparison.Frame("changed", this->GetParam().Apply);
  EXPECT_NE(comparison.GetVerdict(2), Verdict::Hidden);
  EXPECT_EQ(comparison.GetStatistics().HiddenByTriangles, 0);
}

// Hazard: the triangles of a prop with a pipeline are forgotten in every frame, so that the prop is
// drawn in every second frame of a view that stands still.
TEST(CullerTrianglesOfAFilter, StayHidden)
{
  ComparisonOptions options = Scenes::MakeExactOptions(TrianglesWidth, TrianglesHeight, 4);
  options.Backend = vtkNBufferCuller::CPU;
  Comparison comparison(BuildFilteredNotch, options);
  for (int i = 0; i < 8; ++i)
  {
    comparison.Frame("unchanged");
    if (comparison.GetCuller() && i > 4)
    {
      EXPECT_EQ(comparison.GetVerdict(2), Verdict::Hidden) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, CullerTriangles, testing::ValuesIn(TriangleChanges), GetCaseName);
