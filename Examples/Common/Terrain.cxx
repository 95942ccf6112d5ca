// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain.h"

#include "LoadScene.h"

#include "vtkImageData.h"
#include "vtkImageDataGeometryFilter.h"
#include "vtkImageInterpolator.h"
#include "vtkImageResize.h"
#include "vtkNew.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleFilter.h"
#include "vtkWarpScalar.h"

#include <fstream>
#include <stdexcept>

namespace NBufferExamples
{

vtkSmartPointer<vtkPolyData> MakeTerrain(const std::string& program)
{
  constexpr int side = 97;
  vtkNew<vtkImageData> data;
  data->SetDimensions(side, side, 1);
  data->SetSpacing(74.41, 92.66, 1.0); // Of 3 arc seconds at 36.6 degrees north.
  data->AllocateScalars(VTK_FLOAT, 1);
  std::ifstream file(FindData(program, "jacksboro-heights.csv"));
  for (int i = 0; i < side * side; ++i)
  {
    // The first row is the northernmost. A comma or the end of the line follows each number.
    file >> *static_cast<float*>(data->GetScalarPointer(i % side, side - 1 - i / side, 0));
    file.ignore();
  }
  if (!file)
  {
    throw std::runtime_error("jacksboro-heights.csv is missing or damaged");
  }
  vtkNew<vtkImageInterpolator> cubic;
  cubic->SetInterpolationModeToCubic();
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(data);
  resize->SetInterpolator(cubic);
  resize->SetOutputDimensions(3 * side - 2, 3 * side - 2, 1);
  vtkNew<vtkImageDataGeometryFilter> plane;
  plane->SetInputConnection(resize->GetOutputPort());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(warp->GetOutputPort());
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
}

} // namespace NBufferExamples
