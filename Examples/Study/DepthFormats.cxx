// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthFormats.h"

#include <algorithm>
#include <cmath>

namespace NBufferStudy
{
namespace
{
/// The rounding of a number of single precision.
constexpr double Unit = 0x1p-24;

/// The errors of the fragment shader as GLSL 4.60, section 4.7.1, bounds them, as shares of the
/// depth: a division 2.5 and log2() 3 units in the last place, a product and a constant half a
/// unit. A unit in the last place is at most 2 u.
constexpr double LinearError = 7.0 * Unit;
constexpr double LogarithmError = 8.0 * Unit;

/// The error of log2() between 0.5 and 2, and what the rounding of its argument adds to it.
constexpr double AbsoluteLogarithmError = 0x1p-21 + 5.0 * Unit;

/// The error of converting a depth to an integer, in steps of the format. Mesa's llvmpipe converts
/// to 32 bits through 31 and has been found wrong by 2.4 steps.
double GetConversionError(int bits)
{
  return bits == 32 ? 3.0 : 1.0;
}

/// Of a perspective projection: NDC z = Scale + Offset / distance.
struct Row
{
  double Scale;
  double Offset;

  explicit Row(const DepthPlanes& planes)
    : Scale((planes.Far + planes.Near) / (planes.Far - planes.Near))
    , Offset(-2.0 * planes.Far * planes.Near / (planes.Far - planes.Near))
  {
  }
};

bool IsByMatrix(DepthEncoding encoding)
{
  return encoding == DepthEncoding::Forward || encoding == DepthEncoding::Reversed;
}
}

std::string DepthFormat::GetName() const
{
  const char* const encodings[] = { "", " reversed", " W", " logarithmic" };
  return (this->Bits > 0 ? std::to_string(this->Bits) + " bits" : "float") +
    encodings[static_cast<int>(this->Encoding)];
}

double DepthFormat::GetDepth(const DepthPlanes& planes, double distance) const
{
  switch (this->Encoding)
  {
    case DepthEncoding::Forward:
      return 0.5 * (1.0 + Row(planes).Scale + Row(planes).Offset / distance);
    case DepthEncoding::Reversed:
      return planes.Near / distance;
    case DepthEncoding::Linear:
      return distance / planes.Far;
    default:
      return std::log(distance / planes.Near) / std::log(planes.Far / planes.Near);
  }
}

double DepthFormat::GetDistance(const DepthPlanes& planes, double depth) const
{
  switch (this->Encoding)
  {
    case DepthEncoding::Forward:
      return Row(planes).Offset / (2.0 * depth - 1.0 - Row(planes).Scale);
    case DepthEncoding::Reversed:
      return planes.Near / depth;
    case DepthEncoding::Linear:
      return planes.Far * depth;
    default:
      return planes.Near * std::pow(planes.Far / planes.Near, depth);
  }
}

double DepthFormat::GetQuantum(double depth) const
{
  return this->Bits > 0 ? 1.0 / (std::ldexp(1.0, this->Bits) - 1.0)
                        : std::ldexp(1.0, std::max(std::ilogb(depth), -126) - 23);
}

double DepthFormat::GetResolution(const DepthPlanes& planes, double distance) const
{
  const double depth = this->GetDepth(planes, distance);
  const double nearby = distance * (1.0 + 1e-5);
  const double depthThere = this->GetDepth(planes, nearby);
  return this->GetQuantum(std::max(depth, depthThere)) * (nearby - distance) /
    std::abs(depthThere - depth);
}

double DepthFormat::GetFarthest(const DepthPlanes& planes, double depth) const
{
  double error = GetConversionError(this->Bits) * this->GetQuantum(depth);
  if (this->Encoding == DepthEncoding::Linear)
  {
    error += LinearError * depth;
  }
  else if (this->Encoding == DepthEncoding::Logarithmic)
  {
    error += LogarithmError * depth + AbsoluteLogarithmError / std::log2(planes.Far / planes.Near);
  }
  return this->GetDistance(planes, depth + this->GetSign() * error);
}

const std::vector<DepthFormat>& GetDepthFormats()
{
  static const std::vector<DepthFormat> formats = []()
  {
    std::vector<DepthFormat> all;
    for (const DepthEncoding encoding : { DepthEncoding::Forward, DepthEncoding::Reversed,
           DepthEncoding::Linear, DepthEncoding::Logarithmic })
    {
      for (const int bits : { 16, 24, 32, 0 })
      {
        all.push_back({ encoding, bits });
      }
    }
    return all;
  }();
  return formats;
}

DepthFrame MakeFrame(const DepthFrame& frame, const DepthFormat& format, const DepthPlanes& planes,
  const std::vector<double>& depth)
{
  DepthFrame result;
  result.Width = frame.Width;
  result.Height = frame.Height;
  const bool isForward = format.Encoding == DepthEncoding::Forward;
  const Row row(planes);
  vtkNBufferProjection::Rows rows = frame.Projection.GetWorldToClip();
  rows[2] = row.Scale * rows[3];
  rows[2].w += row.Offset;
  double worldToClip[16];
  for (int i = 0; i < 4; ++i)
  {
    std::copy_n(glm::value_ptr(rows[i]), 4, worldToClip + 4 * i);
  }
  // The device computes Forward depths near 1 in floats, whatever it stores. Of Reversed, the
  // relative slack of the convention has all errors of floats. Encodings of the fragment shader are
  // converted below, with the quantum included.
  const double quantum = isForward ? std::max(format.GetQuantum(0.5), Unit)
    : format.Encoding == DepthEncoding::Reversed && format.Bits > 0 ? format.GetQuantum(0.5)
                                                                    : 0.0;
  SetProjection(result.Projection, worldToClip, frame.Width, frame.Height, quantum,
    isForward ? DepthConvention::Forward : DepthConvention::InverseW);
  for (const double stored : depth)
  {
    const double order = stored == format.GetBackground()
      ? GetBackgroundOrder(isForward ? DepthConvention::Forward : DepthConvention::InverseW)
      : IsByMatrix(format.Encoding) ? format.GetSign() * stored
                                    : -planes.Near / format.GetFarthest(planes, stored);
    const auto rounded = static_cast<float>(order);
    result.Depth.push_back(rounded < order ? std::nextafter(rounded, 2.0f) : rounded);
  }
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
  const DepthFrame& frame, const DepthFormat& format, const DepthPlanes& planes)
{
  const DepthFormat order = {
    format.Encoding == DepthEncoding::Forward ? DepthEncoding::Forward : DepthEncoding::Reversed, 0
  };
  const glm::dvec4& row = frame.Projection.GetWorldToClip()[3];
  std::vector<double> slacks;
  for (const DepthBox& box : frame.Boxes)
  {
    const glm::dvec3 w(row);
    const double nearest =
      glm::dot(w, box.Box.Center) + row.w - glm::dot(vtkNBufferGLM::Abs(w), box.Box.HalfSize);
    if (!box.Screen.Clipped)
    {
      // What is drawn here can have the depth of what is drawn nearer.
      const double widened = IsByMatrix(format.Encoding)
        ? nearest
        : format.GetFarthest(planes, format.GetDepth(planes, nearest));
      slacks.push_back(widened - order.GetDistance(planes, order.GetSign() * box.Screen.Nearest));
    }
  }
  return slacks;
}

} // namespace NBufferStudy
