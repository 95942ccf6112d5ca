// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LevelPicture.h"

#include "vtkColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkNBufferLevels.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace NBufferExamples
{

void ReadLevels(vtkRenderWindow* window, int count, vtkNBufferLevels& levels)
{
  const int* size = window->GetActualSize();
  vtkNew<vtkFloatArray> depth;
  window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depth);
  levels.BuildBase(depth->GetPointer(0), size[0], size[1], 1, vtkNBufferExtremum::Maximum);
  levels.BuildLevels(count);
}

vtkSmartPointer<vtkImageData> MakeLevelImage(
  vtkNBufferLevels& levels, int level, const double range[2])
{
  const vtkIdType texels = static_cast<vtkIdType>(levels.GetWidth()) * levels.GetHeight();
  const auto makeDistances = [&](int which)
  {
    vtkNew<vtkFloatArray> distances;
    distances->SetNumberOfValues(texels);
    for (vtkIdType i = 0; i < texels; ++i)
    {
      const double depth = levels.GetLevelData(which)[i];
      distances->SetValue(i,
        depth < 1.0 ? static_cast<float>(
                        std::log(range[0] * range[1] / (range[1] - depth * (range[1] - range[0]))))
                    : std::numeric_limits<float>::quiet_NaN());
    }
    return vtkSmartPointer<vtkFloatArray>(distances);
  };
  double logarithms[2];
  makeDistances(0)->GetFiniteRange(logarithms);
  // The ground reaches to the horizon, which would leave one colour for everything else.
  const double length = std::clamp(logarithms[1] - logarithms[0], std::log(2.0), std::log(300.0));
  constexpr double viridis[][3] = { { 0.267, 0.005, 0.329 }, { 0.254, 0.265, 0.530 },
    { 0.164, 0.471, 0.558 }, { 0.135, 0.659, 0.518 }, { 0.478, 0.821, 0.318 },
    { 0.993, 0.906, 0.144 } };
  vtkNew<vtkColorTransferFunction> colors;
  for (int i = 0; i < 6; ++i)
  {
    colors->AddRGBPoint(
      logarithms[0] + length * i / 5.0, viridis[i][0], viridis[i][1], viridis[i][2]);
  }
  colors->SetNanColor(1.0, 1.0, 1.0);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(levels.GetWidth(), levels.GetHeight(), 1);
  image->GetPointData()->SetScalars(vtkSmartPointer<vtkUnsignedCharArray>::Take(
    colors->MapScalars(makeDistances(level), VTK_COLOR_MODE_MAP_SCALARS, -1, VTK_RGB)));
  return image;
}

} // namespace NBufferExamples
