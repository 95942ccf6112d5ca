// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowReceivers.h"

#include "vtkNBufferDepthConvention.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The range of a litmap is taken from every fourth row and column. It need not be exact, because
/// receivers outside of it are not lost (vtkShadowLitmap::Begin).
constexpr int RangeStride = 4;

using Receiver = vtkShadowReceiverProjector::Receiver;

/// Selects the pixels that fulfil both conditions.
struct Lattice
{
  int Stride = 1; ///< The numbers of their row and column are multiples of this.
  int Band = 0;   ///< The number of their row of tiles is Band modulo Bands.
  int Bands = 1;  ///< The number of bands; the rows of tiles take turns.
};

/// Calls functor(receiver, x, y, depth) for each receiver in these pixels.
template <typename Functor>
void ForEachReceiver(const float* depth, const vtkShadowView& view,
  vtkShadowReceiverProjector& projector, const Lattice& lattice, Functor&& functor)
{
  std::size_t image = 0;
  for (const std::array<double, 2>& sample : view.Samples)
  {
    for (int y = 0; y < view.Height; y += lattice.Stride)
    {
      if (y / vtkShadowTiles::Size % lattice.Bands != lattice.Band)
      {
        continue;
      }
      projector.SetRow(sample, y);
      const float* row = depth + image + static_cast<std::size_t>(y) * view.Width;
      for (int x = 0; x < view.Width; x += lattice.Stride)
      {
        if (!vtkNBufferDepthConvention::IsDrawn(row[x]))
        {
          continue;
        }
        if (const std::optional<Receiver> receiver = projector.Project(x, row[x]))
        {
          functor(*receiver, x, y, row[x]);
        }
      }
    }
    image += static_cast<std::size_t>(view.Width) * view.Height;
  }
}

/// The window depth halfway between two others, where distance is measured along the camera's axis.
float GetMiddle(const vtkShadowView& view, float nearest, float farthest)
{
  // 1 / w is a linear function of depth, and constant for parallel projections.
  const double slope = vtkNBufferDepthConvention::InverseScale * view.ClipToWorld[2][3];
  const double start =
    view.ClipToWorld[3][3] + vtkNBufferDepthConvention::InverseOffset * view.ClipToWorld[2][3];
  const double nearW = 1.0 / (start + slope * nearest);
  const double farW = 1.0 / (start + slope * farthest);
  const double middle = slope != 0.0 ? (2.0 / (nearW + farW) - start) / slope
                                     : 0.5 * (static_cast<double>(nearest) + farthest);
  return static_cast<float>(middle);
}

/// Divides all tiles into layers by the depths of their samples that are not background.
void SplitLayers(const float* depth, const vtkShadowView& view, vtkShadowTiles& tiles)
{
  constexpr int size = vtkShadowTiles::Size;
  const std::size_t image = static_cast<std::size_t>(view.Width) * view.Height;
  const auto splitRow = [&](int row, std::vector<std::array<float, 2>>& ranges)
  {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    ranges.assign(static_cast<std::size_t>(tiles.GetNumberOfColumns()), { infinity, -infinity });
    for (int y = row * size; y < std::min((row + 1) * size, view.Height); ++y)
    {
      for (std::size_t sample = 0; sample < view.Samples.size(); ++sample)
      {
        const std::size_t first = sample * image + static_cast<std::size_t>(y) * view.Width;
        for (std::size_t x = 0; x < static_cast<std::size_t>(view.Width); ++x)
        {
          const float z = depth[first + x];
          if (vtkNBufferDepthConvention::IsDrawn(z))
          {
            std::array<float, 2>& range = ranges[x / size];
            range = { std::min(range[0], z), std::max(range[1], z) };
          }
        }
      }
    }
    for (int column = 0; column < tiles.GetNumberOfColumns(); ++column)
    {
      const auto [nearest, farthest] = ranges[static_cast<std::size_t>(column)];
      if (nearest < farthest)
      {
        tiles.SetSplit(column, row, GetMiddle(view, nearest, farthest));
      }
    }
  };
  vtkSMPTools::For(0, tiles.GetNumberOfRows(),
    [&splitRow](vtkIdType begin, vtkIdType end)
    {
      std::vector<std::array<float, 2>> ranges;
      for (vtkIdType row = begin; row < end; ++row)
      {
        splitRow(static_cast<int>(row), ranges);
      }
    });
}

/// The number of bands, which threads scatter in parallel. Each band has lexels of its own. To
/// clear and merge a lexel takes about a third of the time of scattering a sample. Each thread
/// merges a part of the lexels of all bands.
int GetNumberOfBands(const vtkShadowView& view, int resolution)
{
  const double samples = static_cast<double>(view.Samples.size()) * view.Width * view.Height;
  const double lexels = static_cast<double>(resolution) * resolution;
  const int threads = std::min(vtkSMPTools::GetEstimatedNumberOfThreads(), view.Height);
  int bands = 1;
  while (bands < threads && 3.0 * samples * threads > lexels * bands * (bands + 1))
  {
    ++bands;
  }
  return bands;
}
}

namespace vtkShadowReceivers
{
vtkShadowBlock GetRange(const float* depth, const vtkShadowView& view, const vtkShadowLight& light,
  const vtkShadowLightSpace& space)
{
  vtkShadowReceiverProjector projector(view, light, space);
  vtkShadowBlock range;
  for (int stride : { RangeStride, 1 })
  {
    ForEachReceiver(depth, view, projector, { stride },
      [&range](const Receiver& receiver, int, int, float)
      { range.AddSegment(receiver.A, receiver.B, receiver.GetRadii()); });
    if (!range.IsEmpty())
    {
      break;
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    range.Low[i] = std::max(range.Low[i], -projector.GetLimit());
    range.High[i] = std::min(range.High[i], projector.GetLimit());
  }
  return range;
}

vtkIdType Scatter(const float* depth, const vtkShadowView& view, const vtkShadowLight& light,
  const vtkShadowLightSpace& space, int resolution, vtkShadowLitmap& litmap)
{
  litmap.Begin(resolution, GetRange(depth, view, light, space));
  vtkShadowTiles& tiles = litmap.GetTiles(); // Each band has rows of its own.
  tiles.Begin(view.Width, view.Height);
  SplitLayers(depth, view, tiles);
  const int bands = GetNumberOfBands(view, litmap.GetResolution());
  litmap.Split(bands);
  const auto addBand = [&](int band)
  {
    vtkShadowLitmap& part = litmap.BeginPart(band);
    vtkShadowReceiverProjector projector(view, light, space);
    ForEachReceiver(depth, view, projector, { 1, band, bands },
      [&part, &tiles](const Receiver& receiver, int x, int y, float windowDepth)
      {
        if (part.Add(receiver.A, receiver.B, receiver.Radius, x, y))
        {
          tiles.Add(receiver.A, receiver.B, receiver.GetRadii(), x, y, windowDepth);
          part.WidenAngle(receiver.Angle);
        }
      });
  };
  vtkSMPTools::For(0, bands, 1,
    [&addBand](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType band = begin; band < end; ++band)
      {
        addBand(static_cast<int>(band));
      }
    });
  litmap.Join();
  return litmap.GetNumberOfReceivers();
}
}
VTK_ABI_NAMESPACE_END
