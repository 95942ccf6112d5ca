// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDebugImage.h"

#include <algorithm>
#include <bitset>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using vtkShadowDebugImage::Color;
using vtkShadowDebugImage::Image;

constexpr unsigned char Opacity = 160;
constexpr Color Dark = { 20, 20, 30, 200 };
constexpr Color Edge = { 255, 255, 255, 200 };

/// The colours of 1, 4, 16, 64 and 256; the steps between them are logarithmic.
constexpr int NumberOfHeats = 5;
constexpr unsigned char Heats[NumberOfHeats][3] = { { 40, 60, 255 }, { 0, 200, 255 },
  { 40, 220, 40 }, { 255, 230, 0 }, { 255, 20, 0 } };

void SetPixel(Image& image, std::size_t pixel, const Color& color)
{
  std::copy(color.begin(), color.end(), image.begin() + static_cast<std::ptrdiff_t>(4 * pixel));
}

Color GetColor(const vtkShadowExtent& extent, const vtkShadowExtent& all, int panel)
{
  if (extent.IsEmpty())
  {
    return Dark;
  }
  if (panel < 2)
  {
    // The grey of a depth is between those of all receivers.
    const double depth = panel == 0 ? extent.Near : extent.Far;
    const double share = all.Far > all.Near ? (depth - all.Near) / (all.Far - all.Near) : 0.0;
    const auto level = static_cast<unsigned char>(std::lround(255.0 - 205.0 * share));
    return { level, level, level, 255 };
  }
  Color heat = vtkShadowDebugImage::GetHeat(
    static_cast<int>(std::bitset<vtkShadowLitmap::NumberOfBins>(extent.Bins).count()));
  heat[3] = 255;
  return heat;
}
}

namespace vtkShadowDebugImage
{
Color GetHeat(int number)
{
  if (number <= 0)
  {
    return { 0, 0, 0, 0 };
  }
  const double place =
    std::min(std::log2(static_cast<double>(number)) / 8.0, 1.0) * (NumberOfHeats - 1);
  const int first = std::min(static_cast<int>(place), NumberOfHeats - 2);
  Color color = { 0, 0, 0, Opacity };
  for (int i = 0; i < 3; ++i)
  {
    color[i] = static_cast<unsigned char>(
      std::lround(Heats[first][i] + (place - first) * (Heats[first + 1][i] - Heats[first][i])));
  }
  return color;
}

Image PaintLitmaps(const vtkShadowLitmap* litmaps, int count, int width, int height)
{
  Image image(4 * static_cast<std::size_t>(width) * height, 0);
  constexpr int panels = 3;
  constexpr int gap = 2;
  const int side = std::min(width / panels, count > 0 ? height / count : 0) - gap;
  for (int i = 0; i < count && side > 0; ++i)
  {
    const vtkShadowExtent* lexels = litmaps[i].GetLevelData(0);
    if (!lexels)
    {
      continue;
    }
    const vtkShadowExtent all = litmaps[i].Query(1.0, 1.0, 0.0, 0.0); // of the whole litmap
    const int resolution = litmaps[i].GetResolution();
    for (int panel = 0; panel < panels; ++panel)
    {
      for (int y = 0; y < side; ++y)
      {
        const std::size_t row = static_cast<std::size_t>(y) * resolution / side;
        const std::size_t line = static_cast<std::size_t>(i * (side + gap) + y) * width;
        for (int x = 0; x < side; ++x)
        {
          const std::size_t column = static_cast<std::size_t>(x) * resolution / side;
          SetPixel(image, line + panel * (side + gap) + x,
            GetColor(lexels[row * resolution + column], all, panel));
        }
      }
    }
  }
  return image;
}

Image PaintExtents(const std::vector<vtkShadowDraw>& draws, int width, int height)
{
  Image image(4 * static_cast<std::size_t>(width) * height, 0);
  // A summed-area table: each box adds +1 and -1 at its corners, and the sum of these over all
  // pixels below and to the left of a pixel is the number of boxes that contain it.
  const std::size_t stride = static_cast<std::size_t>(width) + 1;
  std::vector<int> sums(stride * (static_cast<std::size_t>(height) + 1), 0);
  std::vector<vtkNBufferRectangle> boxes;
  for (const vtkShadowDraw& draw : draws)
  {
    const vtkNBufferRectangle box = draw.Box.GetIntersection({ 0, 0, width, height });
    if (!box.IsEmpty())
    {
      boxes.push_back(box);
      ++sums[box.Y0 * stride + box.X0];
      --sums[box.Y0 * stride + box.X1];
      --sums[box.Y1 * stride + box.X0];
      ++sums[box.Y1 * stride + box.X1];
    }
  }
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const std::size_t i = y * stride + x;
      sums[i] += (x > 0 ? sums[i - 1] : 0) + (y > 0 ? sums[i - stride] : 0) -
        (x > 0 && y > 0 ? sums[i - stride - 1] : 0);
      SetPixel(image, static_cast<std::size_t>(y) * width + x, GetHeat(sums[i]));
    }
  }
  const auto paintEdge = [&](int x, int y)
  { SetPixel(image, static_cast<std::size_t>(y) * width + x, Edge); };
  for (const vtkNBufferRectangle& box : boxes)
  {
    for (int x = box.X0; x < box.X1; ++x)
    {
      paintEdge(x, box.Y0);
      paintEdge(x, box.Y1 - 1);
    }
    for (int y = box.Y0; y < box.Y1; ++y)
    {
      paintEdge(box.X0, y);
      paintEdge(box.X1 - 1, y);
    }
  }
  return image;
}

void PaintCounts(Image& image)
{
  for (std::size_t pixel = 0; pixel < image.size() / 4; ++pixel)
  {
    SetPixel(image, pixel, GetHeat(image[4 * pixel]));
  }
}
}
VTK_ABI_NAMESPACE_END
