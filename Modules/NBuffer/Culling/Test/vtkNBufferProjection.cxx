// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferProjection.h"

#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr double UnitRoundoff = 1.0 / (1 << 24);
// Derived in the header, in units of UnitRoundoff.
constexpr double VertexErrors = 8.0;
constexpr double DepthErrors = 4.0;
constexpr double PlaneErrors = 8.0;
constexpr double SnapInPixels = 1.0 / 16;       // OpenGL's minimum of subpixel bits
constexpr double OvershootInPixels = 1.0 / 362; // half the diagonal of a step of 2^-8
constexpr double InverseOfHeight = 16.0;        // of the lowest triangle that is covered
// Of single triangles, see vtkNBufferSliverTest.h, in units of UnitRoundoff.
constexpr double SlopeErrors = 32.0;
constexpr double LowestHeight = 64.0;
constexpr double NearPlaneMargin = 1e-6; // far more than unprojecting in double can err

/// E of the header: how far the device's value of row i may be from Evaluate().
double GetError(const double row[4], const vtkNBufferBox& box)
{
  const double* m = box.Magnitude;
  const double* o = box.Origin;
  return VertexErrors * UnitRoundoff *
    (std::abs(row[0]) * m[0] + std::abs(row[1]) * m[1] + std::abs(row[2]) * m[2] +
      std::abs(row[0] * o[0] + row[1] * o[1] + row[2] * o[2] + row[3]));
}

double Evaluate(const double row[4], const double point[3])
{
  return row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
}

}

vtkNBufferBox vtkNBufferBox::FromBounds(const double bounds[6])
{
  vtkNBufferBox box;
  for (int i = 0; i < 3; ++i)
  {
    box.Center[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    // Centre and half size are rounded, and so is their sum: a few steps outward.
    const double half = 0.5 * (bounds[2 * i + 1] - bounds[2 * i]);
    box.HalfSize[i] = half + (std::abs(box.Center[i]) + half) * 0x1p-50;
    box.Magnitude[i] = std::abs(box.Center[i]) + box.HalfSize[i];
  }
  return box;
}

void vtkNBufferProjection::Set(const double worldToClip[16], int width, int height,
  double depthQuantum, vtkNBufferDepthConvention convention, int largestCoordinate)
{
  this->Width = width;
  this->Height = height;
  this->PlaneRounding = PlaneErrors * UnitRoundoff * std::max({ width, height, largestCoordinate });
  this->DepthRangeSlack = InverseOfHeight * (OvershootInPixels + this->PlaneRounding);
  std::copy_n(worldToClip, 16, &this->WorldToClip[0][0]);
  std::copy_n(worldToClip, 16, &this->Rows[0][0]);
  this->SetConvention(convention, depthQuantum);
  // A matrix that cannot be inverted leaves NaN, which every comparison below takes for "unknown".
  const double determinant = vtkMatrix4x4::Determinant(&this->Rows[0][0]);
  std::fill_n(&this->ClipToWorld[0][0], 16, std::numeric_limits<double>::quiet_NaN());
  if (determinant != 0.0)
  {
    vtkMatrix4x4::Invert(&this->Rows[0][0], &this->ClipToWorld[0][0]);
  }
  for (int plane = 0; plane < 6; ++plane)
  {
    const int axis = plane / 2;
    const double sign = plane % 2 == 0 ? 1.0 : -1.0;
    for (int j = 0; j < 4; ++j)
    {
      this->Planes[plane][j] = this->WorldToClip[3][j] + sign * this->WorldToClip[axis][j];
    }
  }
}

void vtkNBufferProjection::SetConvention(vtkNBufferDepthConvention convention, double depthQuantum)
{
  this->DepthSign = vtkNBufferMath::GetDepthSign(convention);
  this->FarthestOrder = this->DepthSign * vtkNBufferMath::GetBackgroundDepth(convention);
  if (convention == vtkNBufferDepthConvention::Forward)
  {
    this->OrderScale = 0.5;
    this->OrderOffset = 0.5;
    this->DepthSlack = 2.0 * depthQuantum + DepthErrors * UnitRoundoff;
    this->RelativeDepthSlack = 0.0;
    return;
  }
  this->OrderScale = 1.0;
  this->OrderOffset = 0.0;
  this->DepthSlack = 2.0 * depthQuantum;
  this->RelativeDepthSlack = (DepthErrors + 2.0) * UnitRoundoff;
  if (convention == vtkNBufferDepthConvention::Reversed)
  {
    for (int j = 0; j < 4; ++j)
    {
      this->Rows[2][j] = 0.5 * (this->WorldToClip[2][j] - this->WorldToClip[3][j]);
    }
    return;
  }
  // w of the near plane, in the middle of the view.
  double clipToWorld[16];
  std::fill_n(clipToWorld, 16, std::numeric_limits<double>::quiet_NaN());
  vtkMatrix4x4::Invert(&this->WorldToClip[0][0], clipToWorld);
  std::fill_n(this->Rows[2], 3, 0.0);
  this->Rows[2][3] = -1.0 / (clipToWorld[15] - clipToWorld[14]);
}

bool vtkNBufferProjection::IsOutside(const vtkNBufferBox& box) const
{
  if (box.Margin > 0.0)
  {
    return false;
  }
  for (int i = 0; i < 6; ++i)
  {
    const double* plane = this->Planes[i];
    // The corner farthest inside, and by how much the device may see it farther inside still.
    const double reach = Evaluate(plane, box.Center) + std::abs(plane[0]) * box.HalfSize[0] +
      std::abs(plane[1]) * box.HalfSize[1] + std::abs(plane[2]) * box.HalfSize[2];
    if (reach < 0.0 &&
      reach + GetError(this->WorldToClip[3], box) + GetError(this->WorldToClip[i / 2], box) < 0.0)
    {
      return true;
    }
  }
  return false;
}

/**
 * What the points of a box, added one by one in clip space, cover in NDC with their slack.
 */
class vtkNBufferProjection::Extent
{
public:
  Extent(const vtkNBufferProjection& projection, const vtkNBufferBox& box)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->Error[i] = GetError(projection.Rows[i], box);
    }
  }

  const double* GetErrors() const { return this->Error; }

  /// False for a point before the near plane, behind the eye, or too near to the eye for its error
  /// to be bounded. Written so that NaN takes this way out.
  bool Add(const double clip[4])
  {
    const double w = clip[3] - this->Error[3];
    if (!(w > this->Error[3] && clip[2] + clip[3] > this->Error[2] + this->Error[3]))
    {
      return false;
    }
    const double inverse = 1.0 / w;
    for (int i = 0; i < 3; ++i)
    {
      const double ndc = clip[i] / clip[3];
      const double slack = (this->Error[i] + std::abs(ndc) * this->Error[3]) * inverse;
      this->Low[i] = std::min(this->Low[i], ndc - slack);
      this->High[i] = std::max(this->High[i], ndc + slack);
      this->Slack[i] = std::max(this->Slack[i], slack);
    }
    this->MaximumW = std::max(this->MaximumW, clip[3]);
    return true;
  }

  double Low[3] = { Infinity, Infinity, Infinity };
  double High[3] = { -Infinity, -Infinity, -Infinity };
  double Slack[3] = { 0.0, 0.0, 0.0 };
  double MaximumW = 0.0;

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  double Error[4];
};

vtkNBufferPlacement vtkNBufferProjection::Project(
  const vtkNBufferBox& box, vtkNBufferScreenBox& result) const
{
  double center[4];
  double axes[3][4];
  for (int i = 0; i < 4; ++i)
  {
    center[i] = Evaluate(this->Rows[i], box.Center);
    for (int j = 0; j < 3; ++j)
    {
      axes[j][i] = this->Rows[i][j] * box.HalfSize[j];
    }
  }
  ClipPoint corners[8];
  Extent extent(*this, box);
  bool before = true;
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int i = 0; i < 4; ++i)
    {
      corners[corner][i] = center[i] + (corner & 1 ? axes[0][i] : -axes[0][i]) +
        (corner & 2 ? axes[1][i] : -axes[1][i]) + (corner & 4 ? axes[2][i] : -axes[2][i]);
    }
    before = before && extent.Add(corners[corner].data());
  }
  result.Clipped = !before;
  if (!before)
  {
    extent = Extent(*this, box);
    const vtkNBufferPlacement placement = this->Clip(box, corners, extent);
    if (placement != vtkNBufferPlacement::Inside)
    {
      return placement;
    }
  }
  return this->Finish(box, extent, result);
}

vtkNBufferPlacement vtkNBufferProjection::Clip(
  const vtkNBufferBox& box, const ClipPoint corners[8], Extent& extent) const
{
  for (int corner = 0; corner < 8; ++corner)
  {
    if (!std::all_of(corners[corner].begin(), corners[corner].end(),
          [](double value) { return std::isfinite(value); }))
    {
      return vtkNBufferPlacement::Crossing;
    }
  }

  // A corner of the near plane inside the box: nothing bounds what is drawn of it.
  for (int corner = 0; corner < 4; ++corner)
  {
    const double ndc[4] = { corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, -1.0, 1.0 };
    const double w = Evaluate(this->ClipToWorld[3], ndc);
    bool inside = true;
    for (int j = 0; j < 3; ++j)
    {
      const double distance = Evaluate(this->ClipToWorld[j], ndc) / w - box.Center[j];
      inside = inside &&
        !(std::abs(distance) >
          box.HalfSize[j] + NearPlaneMargin * (std::abs(box.Center[j]) + box.HalfSize[j]));
    }
    if (inside)
    {
      return vtkNBufferPlacement::Crossing;
    }
  }

  // Each face, cut at the four sides of the view (Sutherland and Hodgman, 1974), which are moved
  // out by what the device may see farther inside. What remains has w >= 0.
  static const int faces[6][4] = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
    { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };
  const int size[2] = { this->Width, this->Height };
  bool any = false;
  std::vector<ClipPoint> polygon;
  std::vector<ClipPoint> rest;
  for (const auto& face : faces)
  {
    polygon.clear();
    for (int corner : face)
    {
      polygon.push_back(corners[corner]);
    }
    for (int side = 0; side < 4; ++side)
    {
      const int axis = side / 2;
      const double sign = side % 2 == 0 ? 1.0 : -1.0;
      const double widening = 1.0 + 2.0 * (box.Margin + SnapInPixels) / size[axis];
      const double offset = widening * extent.GetErrors()[3] + extent.GetErrors()[axis];
      const auto distance = [&](const ClipPoint& point)
      { return widening * point[3] + sign * point[axis] + offset; };
      rest.clear();
      for (std::size_t i = 0; i < polygon.size(); ++i)
      {
        const ClipPoint& from = polygon[i];
        const ClipPoint& to = polygon[(i + 1) % polygon.size()];
        const double d = distance(from);
        const double e = distance(to);
        if (d >= 0.0)
        {
          rest.push_back(from);
        }
        if ((d >= 0.0) != (e >= 0.0))
        {
          ClipPoint cut;
          for (int k = 0; k < 4; ++k)
          {
            cut[k] = from[k] + (to[k] - from[k]) * (d / (d - e));
          }
          rest.push_back(cut);
        }
      }
      polygon.swap(rest);
    }
    for (const ClipPoint& point : polygon)
    {
      any = true;
      if (!extent.Add(point.data()))
      {
        return vtkNBufferPlacement::Crossing;
      }
    }
  }
  return any ? vtkNBufferPlacement::Inside : vtkNBufferPlacement::Outside;
}

vtkNBufferPlacement vtkNBufferProjection::Finish(
  const vtkNBufferBox& box, const Extent& extent, vtkNBufferScreenBox& result) const
{
  for (int i = 0; i < 3; ++i)
  {
    if (!std::isfinite(extent.Low[i]) || !std::isfinite(extent.High[i]))
    {
      return vtkNBufferPlacement::Crossing;
    }
  }
  const int size[2] = { this->Width, this->Height };
  int begin[2];
  int end[2];
  for (int i = 0; i < 2; ++i)
  {
    const double border = box.Margin + SnapInPixels;
    const double from = 0.5 * (extent.Low[i] + 1.0) * size[i] - border;
    const double to = 0.5 * (extent.High[i] + 1.0) * size[i] + border;
    if (to <= 0.0 || from >= size[i] || size[i] < 1)
    {
      return vtkNBufferPlacement::Outside;
    }
    begin[i] = static_cast<int>(std::floor(std::max(from, 0.0)));
    end[i] = static_cast<int>(std::ceil(std::min(to, static_cast<double>(size[i]))));
    result.Slack[i] = extent.Slack[i] + 2.0 * border / size[i];
  }
  result.Pixels.X0 = begin[0];
  result.Pixels.Y0 = begin[1];
  result.Pixels.X1 = end[0];
  result.Pixels.Y1 = end[1];
  const double scale = this->OrderScale;
  result.DepthRange = scale * (extent.High[2] - extent.Low[2]);
  const double slack = this->DepthSlack + this->RelativeDepthSlack * std::abs(extent.Low[2]) +
    result.DepthRange * this->DepthRangeSlack;
  result.Nearest = scale * extent.Low[2] + this->OrderOffset - slack;
  result.Farthest = scale * extent.High[2] + this->OrderOffset + slack;
  result.Slack[2] = extent.Slack[2] + slack / scale;
  result.MaximumW = extent.MaximumW;
  // Beyond the far plane nothing is drawn.
  return result.Nearest > this->FarthestOrder ? vtkNBufferPlacement::Outside
                                              : vtkNBufferPlacement::Inside;
}

vtkNBufferProjection::TriangleErrors vtkNBufferProjection::GetTriangleErrors(
  const vtkNBufferBox& box, const vtkNBufferScreenBox& screen) const
{
  const double border = box.Margin + SnapInPixels;
  TriangleErrors errors;
  errors.Position = std::max({ 0.5 * screen.Slack[0] * this->Width - border,
    0.5 * screen.Slack[1] * this->Height - border, 0.0 });
  errors.Overshoot = OvershootInPixels;
  // What Finish() adds to the extent of the box, but for the part of R, and what vertices may err.
  errors.Depth = this->OrderScale * screen.Slack[2] - screen.DepthRange * this->DepthRangeSlack;
  errors.OfSlope = OvershootInPixels + this->PlaneRounding;
  errors.OfRounding = this->PlaneRounding;
  errors.OfLength = SlopeErrors * UnitRoundoff;
  errors.Granted = screen.DepthRange * this->DepthRangeSlack;
  errors.LargestSlope = errors.Granted / (errors.OfSlope + errors.OfRounding);
  errors.LowestHeight = LowestHeight * UnitRoundoff;
  return errors;
}

void vtkNBufferProjection::GetWindowMatrix(const double toWorld[16], double matrix[4][4]) const
{
  double clip[16];
  vtkMatrix4x4::Multiply4x4(&this->Rows[0][0], toWorld, clip);
  const double scales[3] = { 0.5 * this->Width, 0.5 * this->Height, this->OrderScale };
  const double offsets[3] = { scales[0], scales[1], this->OrderOffset };
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 3; ++i)
    {
      matrix[i][j] = scales[i] * clip[4 * i + j] + offsets[i] * clip[12 + j];
    }
    matrix[3][j] = clip[12 + j];
  }
}

bool vtkNBufferProjection::GetContact(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen,
  const vtkNBufferBox& other, const vtkNBufferScreenBox& otherScreen,
  vtkNBufferRectangle& pixels) const
{
  vtkNBufferBox shared = box;
  for (int j = 0; j < 3; ++j)
  {
    double range[2];
    for (int end = 0; end < 2; ++end)
    {
      const double sign = end == 0 ? -1.0 : 1.0;
      const double face = other.Center[j] + sign * other.HalfSize[j];
      double reach = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        reach += std::abs(this->ClipToWorld[j][k] - face * this->ClipToWorld[3][k]) *
          (screen.Slack[k] + otherScreen.Slack[k]);
      }
      range[end] = sign *
        std::min(sign * face + screen.MaximumW * reach, sign * box.Center[j] + box.HalfSize[j]);
    }
    if (range[0] > range[1])
    {
      return false;
    }
    shared.Center[j] = 0.5 * (range[0] + range[1]);
    shared.HalfSize[j] = 0.5 * (range[1] - range[0]);
  }
  pixels = screen.Pixels.GetIntersection(otherScreen.Pixels);
  vtkNBufferScreenBox sharedScreen;
  const vtkNBufferPlacement placement = this->Project(shared, sharedScreen);
  if (placement == vtkNBufferPlacement::Inside)
  {
    pixels = pixels.GetIntersection(sharedScreen.Pixels);
  }
  return placement != vtkNBufferPlacement::Outside && !pixels.IsEmpty();
}

bool vtkNBufferProjection::GetFacePlane(
  const vtkNBufferBox& box, const vtkNBufferScreenBox& screen, int face, FacePlane& plane) const
{
  const int axis = face / 2;
  const double sign = face % 2 == 0 ? -1.0 : 1.0;
  const double offset = box.Center[axis] + sign * box.HalfSize[axis];
  // Inside of the face L(q) <= 0, see GetContact.
  double l[4];
  for (int k = 0; k < 4; ++k)
  {
    l[k] = sign * (this->ClipToWorld[axis][k] - offset * this->ClipToWorld[3][k]);
  }
  if (!(l[2] < 0.0))
  {
    return false;
  }
  // z >= (l_x x + l_y y + l_w) / -l_z in NDC, then to pixels and order.
  const double x = -l[0] / l[2];
  const double y = -l[1] / l[2];
  plane.SlopeX = 2.0 * this->OrderScale * x / this->Width;
  plane.SlopeY = 2.0 * this->OrderScale * y / this->Height;
  plane.Depth = this->OrderOffset +
    this->OrderScale *
      (-l[3] / l[2] - x - y - std::abs(x) * screen.Slack[0] - std::abs(y) * screen.Slack[1] -
        screen.Slack[2]);
  return std::isfinite(plane.Depth) && std::isfinite(plane.SlopeX) && std::isfinite(plane.SlopeY);
}

void vtkNBufferProjection::GetCorners(const vtkNBufferBox& box, double corners[16]) const
{
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[3];
    for (int j = 0; j < 3; ++j)
    {
      point[j] = box.Center[j] + (corner >> j & 1 ? box.HalfSize[j] : -box.HalfSize[j]);
    }
    const double inverse = 1.0 / Evaluate(this->Rows[3], point);
    corners[2 * corner] = 0.5 * this->Width * (Evaluate(this->Rows[0], point) * inverse + 1.0);
    corners[2 * corner + 1] = 0.5 * this->Height * (Evaluate(this->Rows[1], point) * inverse + 1.0);
  }
}

void vtkNBufferProjection::GetAxisLengths(const vtkNBufferBox& box, double lengths[3]) const
{
  const double w = Evaluate(this->Rows[3], box.Center);
  const double x = Evaluate(this->Rows[0], box.Center);
  const double y = Evaluate(this->Rows[1], box.Center);
  for (int j = 0; j < 3; ++j)
  {
    const double h = box.HalfSize[j];
    const double dx = this->Rows[0][j] * h;
    const double dy = this->Rows[1][j] * h;
    const double dw = this->Rows[3][j] * h;
    lengths[j] = std::hypot(0.5 * this->Width * ((x + dx) / (w + dw) - (x - dx) / (w - dw)),
      0.5 * this->Height * ((y + dy) / (w + dw) - (y - dy) / (w - dw)));
  }
}
VTK_ABI_NAMESPACE_END
