// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthFormats.h"

#include <algorithm>
#include <cmath>

namespace NBufferStudy
{
namespace
{
/// Of a perspective projection: NDC z = Scale + Offset / distance.
struct Planes
{
  double Near;
  double Scale;
  double Offset;

  Planes(double near, double far)
    : Near(near)
    , Scale((far + near) / (far - near))
    , Offset(-2.0 * far * near / (far - near))
  {
  }

  double GetStored(DepthConvention convention, double distance) const
  {
    const double ndc = this->Scale + this->Offset / distance;
    return convention == DepthConvention::Forward ? 0.5 * (1.0 + ndc)
      : convention == DepthConvention::Reversed   ? 0.5 * (1.0 - ndc)
                                                  : this->Near / distance;
  }

  double GetDistance(DepthConvention convention, double stored) const
  {
    if (convention == DepthConvention::InverseW)
    {
      return this->Near / stored;
    }
    const double ndc =
      convention == DepthConvention::Forward ? 2.0 * stored - 1.0 : 1.0 - 2.0 * stored;
    return this->Offset / (ndc - this->Scale);
  }
};

}

float DepthFormat::Store(double depth) const
{
  if (this->Bits == 0)
  {
    return static_cast<float>(depth);
  }
  const double steps = std::ldexp(1.0, this->Bits) - 1.0;
  double stored = std::round(depth * steps) / steps;
  // What does not fit a float is read rounded away from the eye: vtkNBufferDepthSource::Read.
  if (this->Bits > 24)
  {
    const bool up = this->Convention == DepthConvention::Forward;
    stored = (up ? std::ceil(stored * 0x1p24) : std::floor(stored * 0x1p24)) * 0x1p-24;
  }
  return static_cast<float>(stored);
}

double DepthFormat::GetQuantum() const
{
  if (this->Bits == 0)
  {
    return this->Convention == DepthConvention::Forward ? 0x1p-24 : 0.0;
  }
  return 1.0 / (std::ldexp(1.0, std::min(this->Bits, 24)) - 1.0);
}

const std::vector<DepthFormat>& GetDepthFormats()
{
  static const std::vector<DepthFormat> formats = {
    { "16 bits", DepthConvention::Forward, 16 },
    { "24 bits", DepthConvention::Forward, 24 },
    { "32 bits", DepthConvention::Forward, 32 },
    { "float", DepthConvention::Forward, 0 },
    { "24 bits reversed", DepthConvention::Reversed, 24 },
    { "float reversed", DepthConvention::Reversed, 0 },
    { "1/w 24 bits", DepthConvention::InverseW, 24 },
    { "1/w float", DepthConvention::InverseW, 0 },
  };
  return formats;
}

DepthFrame Convert(
  const DepthFrame& frame, double near, double far, double newNear, const DepthFormat& format)
{
  DepthFrame result = frame;
  const Planes old(near, far);
  const Planes planes(newNear, far);
  vtkNBufferProjection::Rows rows = frame.Projection.GetWorldToClip();
  rows[2] = planes.Scale * rows[3];
  rows[2].w += planes.Offset;
  double worldToClip[16];
  for (int i = 0; i < 4; ++i)
  {
    std::copy_n(glm::value_ptr(rows[i]), 4, worldToClip + 4 * i);
  }
  SetProjection(result.Projection, worldToClip, frame.Width, frame.Height, format.GetQuantum(),
    format.Convention);
  const double unknown = 4.0 * 0x1p-24;
  for (float& depth : result.Depth)
  {
    const double distance = depth >= 1.0f
      ? far
      : std::min(old.GetDistance(DepthConvention::Forward, depth + unknown), far);
    depth = distance >= far ? GetBackgroundOrder(format.Convention)
                            : static_cast<float>(GetDepthSign(format.Convention) *
                                format.Store(planes.GetStored(format.Convention, distance)));
  }
  result.Boxes.clear();
  for (DepthBox box : frame.Boxes)
  {
    if (result.Projection.Project(box.Box, box.Screen) == vtkNBufferPlacement::Inside)
    {
      result.Boxes.push_back(box);
    }
  }
  return result;
}

std::vector<double> GetSlacks(
  const DepthFrame& frame, double near, double far, const DepthFormat& format)
{
  const Planes planes(near, far);
  const glm::dvec4& row = frame.Projection.GetWorldToClip()[3];
  std::vector<double> slacks;
  for (const DepthBox& box : frame.Boxes)
  {
    double nearest = row[3];
    for (int j = 0; j < 3; ++j)
    {
      nearest += row[j] * box.Box.Center[j] - std::abs(row[j]) * box.Box.HalfSize[j];
    }
    if (!box.Screen.Clipped)
    {
      slacks.push_back(nearest -
        planes.GetDistance(
          format.Convention, GetDepthSign(format.Convention) * box.Screen.Nearest));
    }
  }
  return slacks;
}

} // namespace NBufferStudy
