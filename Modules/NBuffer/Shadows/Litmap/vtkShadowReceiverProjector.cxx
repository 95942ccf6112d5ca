// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowReceiverProjector.h"

#include "vtkNBufferDepthConvention.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Half the side of a cube's face around a point light, a little widened.
constexpr double FaceLimit = 1.0 + 0x1p-8;

/// The error of a window depth by the transformation to clip coordinates in float, in units of
/// 1 + r (see the header).
constexpr double DepthRounding = 0x1p-22;

/// The rounding error of a position, in units of its distance from the eye.
constexpr double PositionRounding = 0x1p-20;

/// The rounding error of world coordinates in double, in units of their size.
constexpr double WorldRounding = 0x1p-48;

/// The rounding error of a coordinate that a shader transforms in float: that of the products, of
/// the sums and of their operands.
constexpr double ShaderRounding = 5.0 * 0x1p-24;

/// How far along a surface the centre of a pixel may be from a sample, in pixel widths, if the
/// surface is seen at an angle of one degree.
constexpr double GrazingPixels = 64.0;

/// A generous bound of the rounding error of the cosine between a line of sight and a cone's axis.
constexpr double LineRounding = 1e-3;

/// How far from its exact place the side of a volume may be drawn, in pixels. Devices snap corners
/// to 1/256 of a pixel or better; the rest is for rounding errors where they clip long triangles.
constexpr double Guard = 0.25;

double GetLength1(const glm::dvec3& v)
{
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

/// The largest distance of a corner of the image from the eye, in units of that of its centre.
double GetCornerDistance(const vtkShadowView& view)
{
  const glm::dmat4& m = view.ClipToWorld;
  const auto getDistance = [&m](double x, double y)
  {
    const glm::dvec4 point = m[0] * x + m[1] * y + m[3];
    return glm::length(glm::dvec3(point)) / point[3];
  };
  return std::max({ getDistance(-1.0, -1.0), getDistance(1.0, -1.0), getDistance(-1.0, 1.0),
           getDistance(1.0, 1.0) }) /
    getDistance(0.0, 0.0);
}
}

vtkShadowReceiverProjector::vtkShadowReceiverProjector(
  const vtkShadowView& view, const vtkShadowLight& light, const vtkShadowLightSpace& space)
  : Kind(light.Kind)
  , Size(view.Width, view.Height)
  , DepthError(3.0 * view.DepthQuantum + DepthRounding * (1.0 + GetCornerDistance(view)))
  , ConeCosine(light.GetConeCosine())
  , LightingMargin(view.LightingMargin)
  , WorldError(WorldRounding * (GetLength1(view.Origin) + GetLength1(space.GetApex())))
{
  const auto toAxes = [&space](const glm::dvec3& x)
  {
    return glm::dvec3(
      glm::dot(x, space.GetU()), glm::dot(x, space.GetV()), glm::dot(x, space.GetAxis()));
  };
  this->Eye = toAxes(view.Origin - space.GetApex());
  this->Direction = toAxes(light.Direction);
  glm::dmat4 ndc; // from normalised device coordinates
  for (int j = 0; j < 4; ++j)
  {
    const glm::dvec4& column = view.ClipToWorld[j];
    ndc[j] = glm::dvec4(toAxes(glm::dvec3(column)) + this->Eye * column[3], column[3]);
  }
  // NDC are 2 x / width - 1, 2 y / height - 1 and, for VTK's depth, 2 depth - 1.
  this->Matrix[0] = 2.0 * ndc[0] / static_cast<double>(view.Width);
  this->Matrix[1] = 2.0 * ndc[1] / static_cast<double>(view.Height);
  this->Matrix[2] = vtkNBufferDepthConvention::InverseScale * ndc[2];
  this->Matrix[3] = ndc[3] - ndc[0] - ndc[1] + vtkNBufferDepthConvention::InverseOffset * ndc[2];
  // A factor of zero puts every place at the eye.
  const double push = ndc[2][3] < 0.0 ? std::min(view.Push, -1.0 / ndc[2][3]) : view.Push;
  this->PushFactor = 1.0 + push * ndc[2][3];
  this->PushShift = push * glm::dvec3(ndc[2]);
  this->GuardAtW1 = Guard *
    std::max(glm::length(glm::dvec3(this->Matrix[0])), glm::length(glm::dvec3(this->Matrix[1])));
  if (this->Kind == vtkShadowLightKind::Point)
  {
    this->Limit = FaceLimit;
  }
  if (this->Kind == vtkShadowLightKind::Spot)
  {
    const double widest =
      std::acos(std::clamp(this->Direction[2], -1.0, 1.0)) + std::acos(this->ConeCosine);
    this->Limit = widest < 0.5 * vtkMath::Pi() ? std::tan(widest) : this->Limit;
    this->SetShaderError(view);
    this->ByCentre = view.Samples.size() > 1;
  }
}

void vtkShadowReceiverProjector::SetShaderError(const vtkShadowView& view)
{
  this->ShaderOffset = 2.0 * GetLength1(view.Origin) + GetLength1(this->Eye);
  const glm::dmat4 worldToClip = vtkNBufferGLM::Invert(view.ClipToWorld);
  glm::dvec4 factors(0.0);
  for (int i = 0; i < 4; ++i)
  {
    factors += glm::abs(view.ClipToWorld[i]) * glm::length(glm::dvec3(glm::row(worldToClip, i)));
  }
  const double viewCoordinates = std::sqrt(3.0);
  this->PlaceFactor = viewCoordinates + glm::length(glm::dvec3(factors));
  this->InverseFactor = factors[3];
}

double vtkShadowReceiverProjector::GetShaderError(double distance) const
{
  const double error = ShaderRounding * (this->ShaderOffset + distance);
  const double left = 1.0 - error * this->InverseFactor;
  return left > 0.0 ? error * (this->PlaceFactor + distance * this->InverseFactor) / left
                    : std::numeric_limits<double>::infinity();
}

vtkShadowConeReach vtkShadowReceiverProjector::GetConeReach() const
{
  if (this->ByCentre)
  {
    return {};
  }
  // The corners of the far plane are farthest away. There the interval of depths is longest, too,
  // and a pixel is widest.
  double farthest = 0.0;
  double length = 0.0;
  double guard = 0.0;
  bool isParallel = true;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double x = corner % 2 * this->Size.x;
    const double y = corner / 2 * this->Size.y;
    const auto getPoint = [&](double depth) { return this->Matrix * glm::dvec4(x, y, depth, 1.0); };
    const glm::dvec4 a = getPoint(1.0 - 2.0 * this->DepthError);
    const glm::dvec4 b = getPoint(1.0);
    const glm::dvec3 end = glm::dvec3(b) / b.w;
    farthest = std::max(farthest, glm::distance(end, this->Eye));
    length = std::max(length, glm::distance(end, glm::dvec3(a) / a.w));
    guard = std::max(guard, this->GuardAtW1 / std::min(std::abs(a.w), std::abs(b.w)));
    isParallel = isParallel && a.w == b.w;
  }
  // The interval, and half as much for the difference between both of its ends as seen from the
  // light. The push lengthens it: by the same everywhere, or in proportion to the distance.
  const double interval = 1.5 * length;
  const double push = 1.5 * (isParallel ? glm::length(this->PushShift) : 1.0 - this->PushFactor);
  const double pixels = guard + this->LightingMargin * guard / Guard;
  // Project() adds up the coordinates of vectors, which gives at most sqrt(3) times their length.
  const double scale = std::sqrt(3.0);
  const double shader = ShaderRounding /
    (1.0 - ShaderRounding * (this->ShaderOffset + scale * farthest) * this->InverseFactor);
  const double farScale = 1.0 / farthest;
  vtkShadowConeReach reach;
  reach.A0 = this->WorldError + shader * this->ShaderOffset * this->PlaceFactor +
    (isParallel ? interval + push + pixels : 0.0);
  reach.A1 = PositionRounding * scale +
    shader * scale * (this->PlaceFactor + this->ShaderOffset * this->InverseFactor) +
    (isParallel ? 0.0 : push + pixels * farScale);
  reach.A2 =
    shader * 3.0 * this->InverseFactor + (isParallel ? 0.0 : interval * farScale * farScale);
  reach.Farthest = farthest;
  reach.EyeToLight = glm::length(this->Eye);
  const bool isKnown = shader > 0.0 && std::isfinite(reach.A0 + reach.A1 + reach.A2 + farthest);
  return isKnown ? reach : vtkShadowConeReach();
}

void vtkShadowReceiverProjector::SetRow(const std::array<double, 2>& sample, int y)
{
  const glm::dmat4& m = this->Matrix;
  this->Row = m[0] * sample[0] + m[1] * (y + sample[1]) + m[3];
  this->CentreRow = m[0] * 0.5 + m[1] * (y + 0.5) + m[3];
}

double vtkShadowReceiverProjector::GetAngle(const glm::dvec3& middle, double radius) const
{
  const double distance = glm::length(middle);
  return distance > radius
    ? std::acos(std::clamp(glm::dot(middle, this->Direction) / distance, -1.0, 1.0)) +
      std::asin(radius / distance)
    : vtkMath::Pi();
}

bool vtkShadowReceiverProjector::MayCentreReach(int x, double widening) const
{
  const glm::dvec4 start = this->CentreRow + this->Matrix[0] * static_cast<double>(x);
  const glm::dvec4 end = start + this->Matrix[2];
  const glm::dvec3 near = glm::dvec3(start) / start[3];
  // The directions from the light to the points of the line make half a great circle. The largest
  // cosine of the angle between one of them and the cone's axis decides.
  const glm::dvec3 along = vtkNBufferGLM::Normalize(glm::dvec3(end) / end[3] - near);
  const glm::dvec3 across = vtkNBufferGLM::Normalize(near - glm::dot(near, along) * along);
  const double c = glm::dot(along, this->Direction);
  const double s = std::max(glm::dot(across, this->Direction), 0.0);
  return std::max(std::abs(c), std::hypot(c, s)) >= this->ConeCosine - widening;
}

bool vtkShadowReceiverProjector::MayReach(const glm::dvec3& middle, double radius) const
{
  if (std::isinf(radius))
  {
    return true;
  }
  const double s = middle[2];
  if (s + radius <= 0.0)
  {
    return false;
  }
  if (this->Kind == vtkShadowLightKind::Point)
  {
    return std::max(std::abs(middle[0]), std::abs(middle[1])) - radius <=
      this->Limit * (s + radius);
  }
  // The signed distance of the middle from the surface of the cone, positive outside. The surface
  // is continued behind the apex, where the distance may so be too small, which is conservative.
  const double sine = std::sqrt(1.0 - this->ConeCosine * this->ConeCosine);
  return this->ConeCosine * glm::length(glm::cross(middle, this->Direction)) -
    sine * glm::dot(middle, this->Direction) <=
    radius;
}

std::optional<vtkShadowReceiverProjector::Receiver> vtkShadowReceiverProjector::Project(
  int x, double depth) const
{
  const glm::dvec4 start = this->Row + this->Matrix[0] * static_cast<double>(x);
  const glm::dvec4& along = this->Matrix[2];
  const double nearest = std::max(depth - this->DepthError, 0.0);
  const double farthest = std::min(depth + this->DepthError, 1.0);
  const double scaleA = 1.0 / (start[3] + along[3] * nearest);
  const double scaleB = 1.0 / (start[3] + along[3] * farthest);
  glm::dvec3 a =
    (glm::dvec3(start) + glm::dvec3(along) * nearest) * scaleA * this->PushFactor - this->PushShift;
  glm::dvec3 b = (glm::dvec3(start) + glm::dvec3(along) * farthest) * scaleB;
  const double length = GetLength1(b - a);
  const double distance = GetLength1(b - this->Eye);
  const double rounding = PositionRounding * (distance + length) + this->WorldError;
  const double guard = this->GuardAtW1 * std::max(std::abs(scaleA), std::abs(scaleB));
  const double around = rounding + guard;
  double radiusInPq = around;
  double angle = 0.0;
  if (this->Kind != vtkShadowLightKind::Directional)
  {
    const glm::dvec3 middle = 0.5 * (a + b);
    const double radius = 0.5 * length + rounding;
    if (this->Kind == vtkShadowLightKind::Point)
    {
      if (!this->MayReach(middle, radius + guard))
      {
        return std::nullopt;
      }
    }
    else if (!this->MayReach(middle, radius))
    {
      const double error = radius + this->GetShaderError(distance + length);
      const double pixel = guard / Guard;
      if (!this->MayReach(middle, error + this->LightingMargin * pixel) &&
        !(this->ByCentre && this->MayReach(middle, error + GrazingPixels * pixel) &&
          this->MayCentreReach(x, LineRounding + error / glm::length(b))))
      {
        return std::nullopt;
      }
      angle = this->GetAngle(middle, radius);
    }
    const double nearestS = std::min(a[2], b[2]) - around;
    if (nearestS > 0.0)
    {
      for (glm::dvec3* end : { &a, &b })
      {
        const double scale = 1.0 / end->z;
        end->x *= scale;
        end->y *= scale;
      }
      const double largest = std::max(
        std::max(std::abs(a[0]), std::abs(a[1])), std::max(std::abs(b[0]), std::abs(b[1])));
      radiusInPq = around * (1.0 + largest) / nearestS;
    }
    else
    {
      a[0] = a[1] = b[0] = b[1] = 0.0;
      radiusInPq = std::numeric_limits<double>::infinity();
    }
  }
  const double sign = a[2] <= b[2] ? 1.0 : -1.0;
  a[2] -= sign * around;
  b[2] += sign * around;
  return Receiver{ a, b, radiusInPq, angle };
}
VTK_ABI_NAMESPACE_END
