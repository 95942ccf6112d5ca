// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LevelImages.h"
#include "Viridis.h"

#include "vtkNBufferLevels.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace NBufferBench
{

std::vector<vtkSmartPointer<vtkImageData>> MakeLevelImages(
  const vtkNBufferLevels& levels, const std::vector<int>& which, double near, double far)
{
  const vtkIdType texels = static_cast<vtkIdType>(levels.GetWidth()) * levels.GetHeight();
  const auto distance = [near, far](float depth)
  { return near * far / (far - static_cast<double>(depth) * (far - near)); };

  double nearest = far;
  double farthest = near;
  for (vtkIdType i = 0; i < texels; ++i)
  {
    const float depth = levels.GetLevelData(0)[i];
    if (depth < 1.0f)
    {
      nearest = std::min(nearest, distance(depth));
      farthest = std::max(farthest, distance(depth));
    }
  }
  // The ground reaches to the horizon, which would leave one colour for all the rest.
  farthest = std::clamp(farthest, 2.0 * nearest, 300.0 * nearest);

  const vtkSmartPointer<vtkColorTransferFunction> colors = MakeViridis();

  std::vector<vtkSmartPointer<vtkImageData>> images;
  for (int level : which)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(levels.GetWidth(), levels.GetHeight(), 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
    const float* depth = levels.GetLevelData(level);
    for (vtkIdType i = 0; i < texels; ++i, pixel += 3)
    {
      double rgb[3] = { 1.0, 1.0, 1.0 };
      if (depth[i] < 1.0f)
      {
        colors->GetColor(
          std::log(distance(depth[i]) / nearest) / std::log(farthest / nearest), rgb);
      }
      for (int c = 0; c < 3; ++c)
      {
        pixel[c] = static_cast<unsigned char>(std::lround(255.0 * rgb[c]));
      }
    }
    images.push_back(image);
  }
  return images;
}

} // namespace NBufferBench
