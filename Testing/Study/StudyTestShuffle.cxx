// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace
{
using NBufferExamples::Scene;
/// The points of a triangle, and its value.
using Triangle = std::array<vtkIdType, 4>;

/// A plane of triangles with their numbers as values.
Scene MakePlane()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(8, 5);
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputConnection(plane->GetOutputPort());
  filter->Update();
  vtkPolyData* data = filter->GetOutput();
  vtkNew<vtkIntArray> numbers;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<int>(i));
  }
  data->GetCellData()->SetScalars(numbers);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  Scene scene;
  scene.Name = "plane";
  scene.Actors = { vtkSmartPointer<vtkActor>::New() };
  scene.Actors[0]->SetMapper(mapper);
  return scene;
}

std::vector<Triangle> GetTriangles(const Scene& scene)
{
  auto* data = vtkPolyData::SafeDownCast(scene.Actors[0]->GetMapper()->GetInputDataObject(0, 0));
  std::vector<Triangle> triangles;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    data->GetPolys()->GetCellAtId(i, size, points);
    const double number = data->GetCellData()->GetScalars()->GetTuple1(i);
    triangles.push_back({ points[0], points[1], points[2], static_cast<vtkIdType>(number) });
  }
  return triangles;
}
}

TEST(Shuffle, KeepsTrianglesWithTheirValuesInAnotherOrder)
{
  Scene scene = MakePlane();
  std::vector<Triangle> original = GetTriangles(scene);
  ASSERT_EQ(original.size(), 80u);
  scene.Shuffle();
  std::vector<Triangle> shuffled = GetTriangles(scene);
  EXPECT_NE(original, shuffled);
  Scene again = MakePlane();
  again.Shuffle();
  EXPECT_EQ(GetTriangles(again), shuffled);
  std::sort(original.begin(), original.end());
  std::sort(shuffled.begin(), shuffled.end());
  EXPECT_EQ(original, shuffled);
}

TEST(Shuffle, NeedsOneMesh)
{
  Scene scene = MakePlane();
  scene.Actors.push_back(MakePlane().Actors[0]);
  EXPECT_THROW(scene.Shuffle(), std::runtime_error);
}
