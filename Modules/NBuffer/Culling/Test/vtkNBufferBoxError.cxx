// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferBoxError.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// The factors of the derivation in the header, in units of UnitRoundoff where they count roundings.
constexpr double DepthErrors = 4.0;
constexpr double ReversedDepthErrors = 6.0;
constexpr double PlaneErrors = 8.0;
constexpr double PositionErrors = 16.0;
constexpr double OvershootInPixels = 1.0 / 362; // half the diagonal of a step of the grid
// The factors for single triangles (vtkNBufferSliverTest.h), in units of UnitRoundoff.
constexpr double SlopeErrors = 32.0;
constexpr double LowestRelativeHeight = 64.0;
constexpr double DivisionErrors = 4.0;
constexpr double AdditionErrors = 2.0;

/// [x] of vtkNBufferSliverTest.h.
double GetPowerOf2(double x)
{
  // What is left without the bits of the mantissa. A call of std::ilogb() takes ten times as long.
  const double sum = x + 1.0;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &sum, sizeof bits);
  bits &= std::uint64_t{ 0x7ff } << 52;
  double power = 0.0;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}
}

vtkNBufferDepthFormat vtkNBufferDepthFormat::FromQuantum(
  double quantum, vtkNBufferStoredDepth stored)
{
  vtkNBufferDepthFormat format;
  if (stored == vtkNBufferStoredDepth::Reversed)
  {
    format.Scale = 1.0;
    format.Offset = 0.0;
    format.Slack = 2.0 * quantum;
    format.RelativeSlack = ReversedDepthErrors * vtkNBufferBoxError::UnitRoundoff;
    return format;
  }
  format.Slack = 2.0 * quantum + DepthErrors * vtkNBufferBoxError::UnitRoundoff;
  return format;
}

void vtkNBufferBoxError::Set(const vtkNBufferDepthFormat& format, const glm::ivec2& origin,
  const glm::ivec2& size, int subpixelBits)
{
  const double largestCoordinate = std::max(origin.x + size.x, origin.y + size.y);
  this->Format = format;
  this->Origin = origin;
  this->PositionRounding = PositionErrors * UnitRoundoff * largestCoordinate;
  this->WholeBorder =
    std::min(LargestSnap, std::ldexp(1.0, -subpixelBits) + this->PositionRounding);
  this->SnapsToGrid = std::ldexp(1.0, -subpixelBits) <= GridStep;
  this->PlaneRounding = PlaneErrors * UnitRoundoff * largestCoordinate;
  this->DepthRangeSlack = (OvershootInPixels + this->PlaneRounding) / LowestHeight;
}

vtkNBufferBoxError::TriangleErrors vtkNBufferBoxError::GetTriangleErrors(
  double position, double depth, double range) const
{
  TriangleErrors errors;
  errors.PositionError = position + this->PositionRounding;
  errors.Origin = this->Origin;
  errors.IsSnappedToGrid = this->SnapsToGrid;
  errors.Overshoot = OvershootInPixels;
  errors.DepthError = depth;
  errors.DepthErrorPerSlope = OvershootInPixels + this->PlaneRounding;
  errors.SlopeRounding = this->PlaneRounding;
  errors.SlopeRoundingPerLength = SlopeErrors * UnitRoundoff;
  errors.BoxSlack = this->GetInterpolationSlack(range);
  errors.CoveredSlope = errors.BoxSlack / (errors.DepthErrorPerSlope + errors.SlopeRounding);
  errors.LowestRelativeHeight = LowestRelativeHeight * UnitRoundoff;
  return errors;
}

glm::dvec2 vtkNBufferTriangleErrors::GetPlaceError(const glm::dvec2& ofPlace, double ofW,
  double inverseW, const glm::dvec2& aside, const glm::dvec2& half) const
{
  const glm::dvec2 largest = this->Origin + half + aside;
  return (ofPlace + aside * ofW) * inverseW +
    vtkNBufferBoxError::UnitRoundoff *
    (DivisionErrors * aside +
      AdditionErrors * glm::dvec2(GetPowerOf2(largest.x), GetPowerOf2(largest.y)));
}
VTK_ABI_NAMESPACE_END
