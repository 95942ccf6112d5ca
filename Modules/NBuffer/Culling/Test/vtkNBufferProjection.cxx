// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferProjection.h"

#include "vtkNBufferPolygonClip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A relative margin, far larger than the error of unprojecting in double precision.
constexpr double NearPlaneMargin = 1e-6;

constexpr auto& Evaluate = vtkNBufferBoxError::Evaluate;
}

/**
 * The extent in normalised device coordinates, slack included, of points of a box that are added
 * one by one in clip space. vtkNBufferBoxError.h derives the slack.
 */
class vtkNBufferProjection::Extent
{
public:
  /// An empty extent for points of `box`. `worldToClip` are the rows of the matrix that gives their
  /// clip coordinates.
  Extent(const Rows& worldToClip, const vtkNBufferBox& box)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->Error[i] = vtkNBufferBoxError::GetVertexError(worldToClip[i], box);
    }
  }

  /// How far the clip coordinates that a device computes may be from the exact ones.
  const glm::dvec4& GetErrors() const { return this->Error; }

  /// Add a point in clip space. Returns false for a point before the near plane, behind the eye, or
  /// too near to the eye for its error to be bounded, and for NaN.
  bool Add(const glm::dvec4& clip)
  {
    const double w = clip.w - this->Error.w;
    // A comparison with NaN is false, which has to end here.
    if (!(w > this->Error.w && clip.z + clip.w > this->Error.z + this->Error.w))
    {
      return false;
    }
    const double inverse = 1.0 / w;
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    const glm::dvec3 slack =
      (glm::dvec3(this->Error) + vtkNBufferGLM::Abs(ndc) * this->Error.w) * inverse;
    this->Low = glm::min(this->Low, ndc - slack);
    this->High = glm::max(this->High, ndc + slack);
    this->MaximumInverse = std::max(this->MaximumInverse, inverse);
    this->MaximumW = std::max(this->MaximumW, clip.w);
    return true;
  }

  ///@{
  /// The extent of what a device may draw of the points.
  glm::dvec3 Low = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 High = glm::dvec3(-std::numeric_limits<double>::infinity());
  ///@}
  /// No point amid those that were added has a larger slack. (It may be larger than theirs.)
  glm::dvec3 GetSlack() const
  {
    const glm::dvec3 aside = glm::max(vtkNBufferGLM::Abs(Low), vtkNBufferGLM::Abs(High));
    return (glm::dvec3(this->Error) + aside * this->Error.w) * this->MaximumInverse;
  }
  double MaximumInverse = 0.0; ///< Of the least w, less its error.
  /// The largest clip coordinate w of any point.
  double MaximumW = 0.0;

private:
  glm::dvec4 Error;
};

void vtkNBufferProjection::Set(const double worldToClip[16], int width, int height,
  const vtkNBufferDepthFormat& format, const glm::ivec2& origin, int subpixelBits)
{
  this->Width = width;
  this->Height = height;
  this->Error.Set(format, origin, glm::ivec2(width, height), subpixelBits);
  // If there is no inverse all its elements are NaN, which every comparison below takes for
  // "unknown".
  this->ClipToWorld.Set(worldToClip);
  for (int i = 0; i < 4; ++i)
  {
    this->WorldToClip[i] = glm::make_vec4(worldToClip + 4 * i);
  }
  for (int plane = 0; plane < 6; ++plane)
  {
    const double sign = plane % 2 == 0 ? 1.0 : -1.0;
    this->Planes[plane] = this->WorldToClip[3] + sign * this->WorldToClip[plane / 2];
  }
}

bool vtkNBufferProjection::IsOutside(const vtkNBufferBox& box) const
{
  if (box.Margin > 0.0)
  {
    return false;
  }
  for (int i = 0; i < 6; ++i)
  {
    const glm::dvec4& plane = this->Planes[i];
    // The value at the corner farthest inside, to which the errors of the device are added.
    const double reach = vtkNBufferClipToWorld::GetLargest(plane, box);
    if (reach < 0.0 &&
      reach + vtkNBufferBoxError::GetVertexError(this->WorldToClip[3], box) +
          vtkNBufferBoxError::GetVertexError(this->WorldToClip[i / 2], box) <
        0.0)
    {
      return true;
    }
  }
  return false;
}

vtkNBufferPlacement vtkNBufferProjection::Project(
  const vtkNBufferBox& box, vtkNBufferScreenBox& result) const
{
  glm::dvec4 center;
  glm::dvec4 axes[3];
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec4& row = this->WorldToClip[i];
    center[i] = Evaluate(row, box.Center);
    for (int j = 0; j < 3; ++j)
    {
      axes[j][i] = row[j] * box.HalfSize[j];
    }
  }
  const auto getCorner = [&](int corner)
  {
    return center + (corner & 1 ? axes[0] : -axes[0]) + (corner & 2 ? axes[1] : -axes[1]) +
      (corner & 4 ? axes[2] : -axes[2]);
  };
  Extent extent(this->WorldToClip, box);
  bool before = true;
  for (int corner = 0; corner < 8 && before; ++corner)
  {
    before = extent.Add(getCorner(corner));
  }
  result.Clipped = !before;
  if (!before)
  {
    Corners corners;
    for (int corner = 0; corner < 8; ++corner)
    {
      corners[corner] = getCorner(corner);
    }
    extent = Extent(this->WorldToClip, box);
    const vtkNBufferPlacement placement = this->Clip(box, corners, extent);
    if (placement != vtkNBufferPlacement::Inside)
    {
      return placement;
    }
  }
  return this->Finish(box, extent, result);
}

vtkNBufferPlacement vtkNBufferProjection::Clip(
  const vtkNBufferBox& box, const Corners& corners, Extent& extent) const
{
  if (!std::all_of(corners.begin(), corners.end(), vtkNBufferGLM::IsFinite<4>) ||
    !vtkNBufferGLM::IsFinite(extent.GetErrors()))
  {
    return vtkNBufferPlacement::Crossing;
  }

  // If a corner of the near plane is inside the box, nothing bounds what is drawn of the box.
  for (int corner = 0; corner < 4; ++corner)
  {
    const glm::dvec3 ndc = { corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, -1.0 };
    const double w = Evaluate(this->ClipToWorld.GetRow(3), ndc);
    bool inside = true;
    for (int j = 0; j < 3; ++j)
    {
      const double distance = Evaluate(this->ClipToWorld.GetRow(j), ndc) / w - box.Center[j];
      inside = inside &&
        !(std::abs(distance) >
          box.HalfSize[j] + NearPlaneMargin * (std::abs(box.Center[j]) + box.HalfSize[j]));
    }
    if (inside)
    {
      return vtkNBufferPlacement::Crossing;
    }
  }

  // Cut each face at the four sides of the view. The sides are moved outward by as much as the
  // device may draw points farther inside. What remains has w >= 0.
  static const int faces[6][4] = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
    { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };
  const int size[2] = { this->Width, this->Height };
  bool any = false;
  std::vector<glm::dvec4> polygon;
  std::vector<glm::dvec4> rest;
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
      const double widening = 1.0 + 2.0 * this->Error.GetBorder(box, false) / size[axis];
      const double offset = widening * extent.GetErrors().w + extent.GetErrors()[axis];
      const auto distance = [&](const glm::dvec4& point)
      { return widening * point.w + sign * point[axis] + offset; };
      vtkNBufferPolygonClip::Clip(polygon, distance, rest);
      polygon.swap(rest);
    }
    for (const glm::dvec4& point : polygon)
    {
      any = true;
      if (!extent.Add(point))
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
  if (!vtkNBufferGLM::IsFinite(extent.Low) || !vtkNBufferGLM::IsFinite(extent.High))
  {
    return vtkNBufferPlacement::Crossing;
  }
  const int size[2] = { this->Width, this->Height };
  // Whether the device cuts no triangle of the box at a side of the view.
  const bool isWhole = !result.Clipped &&
    glm::all(glm::greaterThanEqual(extent.Low, glm::dvec3(-1.0))) &&
    glm::all(glm::lessThanEqual(extent.High, glm::dvec3(1.0)));
  const double border = this->Error.GetBorder(box, isWhole);
  const glm::dvec3 ofPoints = extent.GetSlack();
  glm::ivec2 begin;
  glm::ivec2 end;
  glm::ivec2 firstMiddle;
  glm::ivec2 lastMiddle;
  for (int i = 0; i < 2; ++i)
  {
    const double low = 0.5 * (extent.Low[i] + 1.0) * size[i] - border;
    const double high = 0.5 * (extent.High[i] + 1.0) * size[i] + border;
    if (high <= 0.0 || low >= size[i] || size[i] < 1)
    {
      return vtkNBufferPlacement::Outside;
    }
    const double from = std::max(low, 0.0);
    const double to = std::min(high, static_cast<double>(size[i]));
    begin[i] = static_cast<int>(std::floor(from));
    end[i] = static_cast<int>(std::ceil(to));
    firstMiddle[i] = static_cast<int>(std::ceil(from - 0.5));
    lastMiddle[i] = static_cast<int>(std::floor(to - 0.5));
    result.Slack[i] = ofPoints[i] + 2.0 * border / size[i];
  }
  result.Pixels = { begin.x, begin.y, end.x, end.y };
  result.Middles = { firstMiddle.x, firstMiddle.y, lastMiddle.x + 1, lastMiddle.y + 1 };
  result.Border = border;
  const vtkNBufferDepthFormat& format = this->Error.GetFormat();
  result.DepthRange = format.Scale * (extent.High.z - extent.Low.z);
  const double slack = this->Error.GetDepthSlack(extent.Low.z, result.DepthRange);
  result.Nearest = format.Scale * extent.Low.z + format.Offset - slack;
  result.Farthest = format.Scale * extent.High.z + format.Offset + slack;
  result.Slack.z = ofPoints.z + slack / format.Scale;
  result.MaximumW = extent.MaximumW;
  // Beyond the far plane nothing is drawn.
  return result.Nearest > format.Farthest ? vtkNBufferPlacement::Outside
                                          : vtkNBufferPlacement::Inside;
}

vtkNBufferBoxError::TriangleErrors vtkNBufferProjection::GetTriangleErrors(
  const vtkNBufferScreenBox& screen) const
{
  const double position = std::max({ 0.5 * screen.Slack.x * this->Width - screen.Border,
    0.5 * screen.Slack.y * this->Height - screen.Border, 0.0 });
  // The errors of the vertices, and what Finish() adds to the depths except for the part with R.
  const double depth = this->Error.GetFormat().Scale * screen.Slack.z -
    this->Error.GetInterpolationSlack(screen.DepthRange);
  vtkNBufferBoxError::TriangleErrors errors =
    this->Error.GetTriangleErrors(position, depth, screen.DepthRange);
  // Where the device cuts a triangle, it snaps other corners.
  errors.IsSnappedToGrid = errors.IsSnappedToGrid && this->IsWhollyInside(screen);
  return errors;
}

vtkNBufferProjection::Rows vtkNBufferProjection::GetWindowMatrix(const glm::dmat4& toWorld) const
{
  Rows clip;
  for (int i = 0; i < 4; ++i)
  {
    // Row i of the product.
    const glm::dvec4& row = this->WorldToClip[i];
    clip[i] = row.x * glm::row(toWorld, 0) + row.y * glm::row(toWorld, 1) +
      row.z * glm::row(toWorld, 2) + row.w * glm::row(toWorld, 3);
  }
  const vtkNBufferDepthFormat& format = this->Error.GetFormat();
  const double halfWidth = 0.5 * this->Width;
  const double halfHeight = 0.5 * this->Height;
  return { halfWidth * clip[0] + halfWidth * clip[3], halfHeight * clip[1] + halfHeight * clip[3],
    format.Scale * clip[2] + format.Offset * clip[3], clip[3] };
}

vtkNBufferContact vtkNBufferProjection::GetContact(const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen, const vtkNBufferBox& other,
  const vtkNBufferScreenBox& otherScreen) const
{
  vtkNBufferBox shared = box;
  const double perOtherW = this->ClipToWorld.GetLargestInverseW(other);
  for (int j = 0; j < 3; ++j)
  {
    double range[2];
    for (int end = 0; end < 2; ++end)
    {
      const double sign = end == 0 ? -1.0 : 1.0;
      const double face = other.Center[j] + sign * other.HalfSize[j];
      const glm::dvec4 row = this->ClipToWorld.GetFace(j, face);
      const double reach =
        glm::dot(vtkNBufferGLM::Abs(glm::dvec3(row)), screen.Slack + otherScreen.Slack) +
        this->ClipToWorld.GetError(row, j, face, other) * perOtherW;
      range[end] = sign *
        std::min(
          sign * face + screen.MaximumW * reach + this->ClipToWorld.GetError(row, j, face, box),
          sign * box.Center[j] + box.HalfSize[j]);
    }
    if (range[0] > range[1])
    {
      return {};
    }
    shared.Center[j] = 0.5 * (range[0] + range[1]);
    shared.HalfSize[j] = 0.5 * (range[1] - range[0]);
  }
  vtkNBufferContact contact = { box, screen };
  vtkNBufferScreenBox sharedScreen;
  const vtkNBufferPlacement placement = this->Project(shared, sharedScreen);
  if (placement == vtkNBufferPlacement::Outside)
  {
    return {};
  }
  if (placement == vtkNBufferPlacement::Inside)
  {
    // The fragments of this box are drawn with its errors. Its border may be wider by less than one
    // pixel.
    const int wider = screen.Border > sharedScreen.Border ? 1 : 0;
    const auto cut = [wider](const vtkNBufferRectangle& pixels, const vtkNBufferRectangle& to) {
      return pixels.GetIntersection({ to.X0 - wider, to.Y0 - wider, to.X1 + wider, to.Y1 + wider });
    };
    const double error = this->Error.GetFormat().Scale * screen.Slack.z;
    contact = { shared, sharedScreen };
    contact.Screen.Pixels = cut(screen.Pixels, sharedScreen.Pixels);
    contact.Screen.Middles = cut(screen.Middles, sharedScreen.Middles);
    contact.Screen.Nearest = std::max(screen.Nearest, sharedScreen.Nearest - error);
    contact.Screen.Slack = screen.Slack;
  }
  contact.Screen.Pixels = contact.Screen.Pixels.GetIntersection(otherScreen.Pixels);
  contact.Screen.Middles = contact.Screen.Middles.GetIntersection(otherScreen.Middles);
  contact.Screen.Nearest = std::max(contact.Screen.Nearest, otherScreen.Nearest);
  return contact;
}

std::optional<vtkNBufferProjection::FacePlane> vtkNBufferProjection::GetFacePlane(
  const vtkNBufferBox& box, const vtkNBufferScreenBox& screen, int face) const
{
  const int axis = face / 2;
  const double sign = face % 2 == 0 ? -1.0 : 1.0;
  const double offset = box.Center[axis] + sign * box.HalfSize[axis];
  // L(q) <= 0 on the inner side of the face, see GetContact().
  const glm::dvec4 l = sign * this->ClipToWorld.GetFace(axis, offset);
  if (!(l.z < 0.0))
  {
    return {};
  }
  // Because the inverse is rounded, the face passes the corner that is farthest beyond it.
  const double beyond =
    std::max(vtkNBufferClipToWorld::GetLargest(this->ClipToWorld.ToWorld(l), box), 0.0) *
    this->ClipToWorld.GetLargestInverseW(box);
  // z >= (l_x x + l_y y + l_w) / -l_z in NDC, then to pixels and order.
  const double x = -l.x / l.z;
  const double y = -l.y / l.z;
  const vtkNBufferDepthFormat& format = this->Error.GetFormat();
  FacePlane plane;
  plane.SlopeX = 2.0 * format.Scale * x / this->Width;
  plane.SlopeY = 2.0 * format.Scale * y / this->Height;
  plane.Depth = format.Offset +
    format.Scale *
      ((beyond - l.w) / l.z - x - y - std::abs(x) * screen.Slack.x - std::abs(y) * screen.Slack.y -
        screen.Slack.z);
  if (!std::isfinite(plane.Depth) || !std::isfinite(plane.SlopeX) || !std::isfinite(plane.SlopeY))
  {
    return {};
  }
  return plane;
}

std::array<glm::dvec2, 8> vtkNBufferProjection::GetCorners(const vtkNBufferBox& box) const
{
  const glm::dvec2 half = { 0.5 * this->Width, 0.5 * this->Height };
  std::array<glm::dvec2, 8> corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    glm::dvec3 point;
    for (int j = 0; j < 3; ++j)
    {
      point[j] = box.Center[j] + (corner >> j & 1 ? box.HalfSize[j] : -box.HalfSize[j]);
    }
    const double inverse = 1.0 / Evaluate(this->WorldToClip[3], point);
    const glm::dvec2 clip = { Evaluate(this->WorldToClip[0], point),
      Evaluate(this->WorldToClip[1], point) };
    corners[corner] = half * (clip * inverse + 1.0);
  }
  return corners;
}
VTK_ABI_NAMESPACE_END
