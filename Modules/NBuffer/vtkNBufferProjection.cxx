// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferProjection.h"

#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr double UnitRoundoff = 1.0 / (1 << 24);
constexpr double VertexErrors = 8.0;      // in units of UnitRoundoff, derived in the header
constexpr double SnapInPixels = 1.0 / 16; // OpenGL's minimum of subpixel bits
constexpr double SlopeErrors = 512.0;     // 2^9, derived in the header

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

void vtkNBufferProjection::Set(
  const double worldToClip[16], int width, int height, double depthQuantum)
{
  this->Width = width;
  this->Height = height;
  this->DepthSlack = 2.0 * depthQuantum + 4.0 * UnitRoundoff;
  this->DepthRangeSlack = SlopeErrors * UnitRoundoff * std::max(width, height);
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      this->Rows[i][j] = worldToClip[4 * i + j];
    }
  }
  // A matrix that cannot be inverted leaves NaN, which every comparison below takes for "unknown".
  const double determinant = vtkMatrix4x4::Determinant(worldToClip);
  std::fill_n(&this->ClipToWorld[0][0], 16, std::numeric_limits<double>::quiet_NaN());
  if (determinant != 0.0)
  {
    vtkMatrix4x4::Invert(worldToClip, &this->ClipToWorld[0][0]);
  }
  for (int plane = 0; plane < 6; ++plane)
  {
    const int axis = plane / 2;
    const double sign = plane % 2 == 0 ? 1.0 : -1.0;
    for (int j = 0; j < 4; ++j)
    {
      this->Planes[plane][j] = this->Rows[3][j] + sign * this->Rows[axis][j];
    }
  }
}

bool vtkNBufferProjection::IsOutside(const vtkNBufferBox& box) const
{
  if (box.Margin > 0.0)
  {
    return false;
  }
  const double errorOfW = GetError(this->Rows[3], box);
  double error = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    const double* plane = this->Planes[i];
    if (i % 2 == 0)
    {
      error = errorOfW + GetError(this->Rows[i / 2], box);
    }
    // The corner farthest inside, and by how much the device may see it farther inside still.
    const double reach = std::abs(plane[0]) * box.HalfSize[0] +
      std::abs(plane[1]) * box.HalfSize[1] + std::abs(plane[2]) * box.HalfSize[2];
    if (Evaluate(plane, box.Center) + reach + error < 0.0)
    {
      return true;
    }
  }
  return false;
}

vtkNBufferPlacement vtkNBufferProjection::Project(
  const vtkNBufferBox& box, vtkNBufferScreenBox& result) const
{
  double center[4];
  double axes[3][4];
  double error[4];
  for (int i = 0; i < 4; ++i)
  {
    center[i] = Evaluate(this->Rows[i], box.Center);
    error[i] = GetError(this->Rows[i], box);
    for (int j = 0; j < 3; ++j)
    {
      axes[j][i] = this->Rows[i][j] * box.HalfSize[j];
    }
  }

  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low[3] = { infinity, infinity, infinity };
  double high[3] = { -infinity, -infinity, -infinity };
  double slacks[3] = { 0.0, 0.0, 0.0 };
  double maximumW = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double clip[4];
    for (int i = 0; i < 4; ++i)
    {
      clip[i] = center[i] + (corner & 1 ? axes[0][i] : -axes[0][i]) +
        (corner & 2 ? axes[1][i] : -axes[1][i]) + (corner & 4 ? axes[2][i] : -axes[2][i]);
    }
    const double w = clip[3] - error[3];
    // Before the near plane, behind the eye, or too near to the eye for its error to be bounded.
    // Written so that NaN takes this way out.
    if (!(w > error[3] && clip[2] + clip[3] > error[2] + error[3]))
    {
      return vtkNBufferPlacement::Crossing;
    }
    const double inverse = 1.0 / w;
    for (int i = 0; i < 3; ++i)
    {
      const double ndc = clip[i] / clip[3];
      const double slack = (error[i] + std::abs(ndc) * error[3]) * inverse;
      low[i] = std::min(low[i], ndc - slack);
      high[i] = std::max(high[i], ndc + slack);
      slacks[i] = std::max(slacks[i], slack);
    }
    maximumW = std::max(maximumW, clip[3]);
  }
  for (int i = 0; i < 3; ++i)
  {
    if (!std::isfinite(low[i]) || !std::isfinite(high[i]))
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
    const double from = 0.5 * (low[i] + 1.0) * size[i] - border;
    const double to = 0.5 * (high[i] + 1.0) * size[i] + border;
    if (to <= 0.0 || from >= size[i] || size[i] < 1)
    {
      return vtkNBufferPlacement::Outside;
    }
    begin[i] = static_cast<int>(std::floor(std::max(from, 0.0)));
    end[i] = static_cast<int>(std::ceil(std::min(to, static_cast<double>(size[i]))));
  }
  result.Pixels.X0 = begin[0];
  result.Pixels.Y0 = begin[1];
  result.Pixels.X1 = end[0];
  result.Pixels.Y1 = end[1];
  const double slack = this->DepthSlack + 0.5 * (high[2] - low[2]) * this->DepthRangeSlack;
  result.Nearest = 0.5 * (low[2] + 1.0) - slack;
  result.Farthest = 0.5 * (high[2] + 1.0) + slack;
  for (int i = 0; i < 2; ++i)
  {
    result.Slack[i] = slacks[i] + 2.0 * (box.Margin + SnapInPixels) / size[i];
  }
  result.Slack[2] = slacks[2] + 2.0 * slack;
  result.MaximumW = maximumW;
  // Beyond the far plane nothing is drawn.
  return result.Nearest > 1.0 ? vtkNBufferPlacement::Outside : vtkNBufferPlacement::Inside;
}

bool vtkNBufferProjection::AreApart(const vtkNBufferBox& a, const vtkNBufferScreenBox& screenA,
  const vtkNBufferBox& b, const vtkNBufferScreenBox& screenB) const
{
  const double w = std::max(screenA.MaximumW, screenB.MaximumW);
  for (int j = 0; j < 3; ++j)
  {
    const double distance = b.Center[j] - a.Center[j];
    const double gap = std::abs(distance) - a.HalfSize[j] - b.HalfSize[j];
    if (!(gap > 0.0))
    {
      continue;
    }
    const double middle = a.Center[j] + std::copysign(a.HalfSize[j] + 0.5 * gap, distance);
    double reach = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      reach += std::abs(this->ClipToWorld[j][k] - middle * this->ClipToWorld[3][k]) *
        (screenA.Slack[k] + screenB.Slack[k]);
    }
    if (gap > w * reach)
    {
      return true;
    }
  }
  return false;
}

bool vtkNBufferProjection::GetFacePlane(const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen, int face, FacePlane& plane) const
{
  const int axis = face / 2;
  const double sign = face % 2 == 0 ? -1.0 : 1.0;
  const double offset = box.Center[axis] + sign * box.HalfSize[axis];
  // Inside of the face L(q) <= 0, see AreApart.
  double l[4];
  for (int k = 0; k < 4; ++k)
  {
    l[k] = sign * (this->ClipToWorld[axis][k] - offset * this->ClipToWorld[3][k]);
  }
  if (!(l[2] < 0.0))
  {
    return false;
  }
  // z >= (l_x x + l_y y + l_w) / -l_z in NDC, then to pixels and window depth.
  const double x = -l[0] / l[2];
  const double y = -l[1] / l[2];
  plane.SlopeX = x / this->Width;
  plane.SlopeY = y / this->Height;
  plane.Depth = 0.5 + 0.5 * (-l[3] / l[2] - x - y -
    std::abs(x) * screen.Slack[0] - std::abs(y) * screen.Slack[1] - screen.Slack[2]);
  return std::isfinite(plane.Depth) && std::isfinite(plane.SlopeX) &&
    std::isfinite(plane.SlopeY);
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
    corners[2 * corner + 1] =
      0.5 * this->Height * (Evaluate(this->Rows[1], point) * inverse + 1.0);
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
