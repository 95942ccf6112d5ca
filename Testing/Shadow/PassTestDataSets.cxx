// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Data sets that are not polydata cast as their surfaces do.
#include "PassTestTools.h"

#include "vtkActor.h"
#include "vtkDataSetMapper.h"
#include "vtkGeometryFilter.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <numeric>
#include <utility>

namespace
{
using ShadowDataSets = OffscreenFixture;

/// Hexahedra in a row, of which the inner faces are nobody's surface.
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(int cells)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i <= cells; ++i)
  {
    for (const auto& [y, z] : { std::pair(0, 0), { 1, 0 }, { 1, 1 }, { 0, 1 } })
    {
      points->InsertNextPoint(0.5 * i, y, 1.0 + z);
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  for (vtkIdType i = 0; i < cells; ++i)
  {
    vtkIdType corners[8];
    std::iota(corners, corners + 8, 4 * i);
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
  }
  return grid;
}

void Prepare(SceneBuilder& scene)
{
  scene.Floor(6.0);
  scene.Directional({ 0.4, 0.3, -1.0 });
  scene.Look({ 4.0, -7.0, 6.0 }, { 1.0, 0.5, 0.5 });
}
}

// Hazard: in a viewer that draws everything by vtkDataSetMapper nothing casts.
TEST_F(ShadowDataSets, CastAsTheirSurfaces)
{
  Stage asGrid = SetStage(Prepare);
  Stage asMesh = SetStage(Prepare);
  const vtkSmartPointer<vtkUnstructuredGrid> grid = MakeGrid(4);
  vtkActor* actor = AddMesh(asGrid.GetRenderer(), nullptr);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(grid);
  actor->SetMapper(mapper);
  vtkNew<vtkGeometryFilter> surface;
  surface->SetInputData(grid);
  surface->Update();
  AddMesh(asMesh.GetRenderer(), surface->GetOutput());

  const auto pass = AddPass(asGrid);
  const auto other = AddPass(asMesh);
  for (const double height : { 0.0, 0.0, 1.5 })
  {
    if (height > 0.0)
    {
      grid->GetPoints()->SetPoint(4, 0.5, 0.0, height);
      grid->GetPoints()->Modified();
      grid->Modified();
      surface->Update();
    }
    EXPECT_EQ(FindDifference(RenderPicture(asMesh), RenderPicture(asGrid)), "");
    const ShadowMask mask = GetMask(asGrid, pass);
    EXPECT_GT(CountShadowed(mask), 200);
    EXPECT_TRUE(mask == GetMask(asMesh, other));
    EXPECT_EQ(pass->GetStatistics().Casters, 2);
    EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
  }
  // A still frame keeps its masks with such a caster, too.
  asGrid.Window->Render();
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Still);
}
