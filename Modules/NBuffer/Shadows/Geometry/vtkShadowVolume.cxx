// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolume.h"

#include "vtkShadowFootprint.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The position of merged point i in the near cap.
glm::dvec3 GetNearPoint(const vtkShadowSilhouette& silhouette, const vtkShadowPoints& points, int i)
{
  const std::vector<glm::dvec3>& pushes = silhouette.GetPushes();
  return pushes.empty() ? points[i] : points[i] + pushes[static_cast<std::size_t>(i)];
}

/// Volumes that end beyond the view are made longer by this factor, so that the rounding of their
/// corners and of receivers does not matter.
constexpr double Lengthening = 1.01;

/// The largest factor by which a near cap is enlarged. A triangle that is nearer to the light than
/// this fraction of the distance of a receiver is within rounding errors of containing the light.
constexpr double LargestFactor = 1e12;

/// The distance of `x` from the triangle (a, b, c).
double GetDistance(
  const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const glm::dvec3 corners[] = { a, b, c };
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  double least = std::numeric_limits<double>::infinity();
  bool isInside = true; // Whether the nearest point of the plane lies in the triangle.
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 from = corners[i] - x;
    const glm::dvec3 edge = corners[(i + 1) % 3] - corners[i];
    const double length = glm::dot(edge, edge);
    const double t = length > 0.0 ? std::clamp(-glm::dot(from, edge) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::length(from + t * edge));
    isInside = isInside && glm::dot(glm::cross(from, edge), normal) > 0.0;
  }
  return isInside ? std::abs(glm::dot(a - x, normal)) / glm::length(normal) : least;
}

/// The factor k of vtkShadowVolume.h.
double GetFactor(const vtkShadowSilhouette& silhouette, const vtkShadowPoints& points,
  const glm::dvec3& light, const vtkShadowBlock& view)
{
  const double farthest =
    glm::length(glm::max(glm::abs(view.Low - light), glm::abs(view.High - light)));
  double nearest = std::numeric_limits<double>::infinity();
  const std::vector<int>& corners = silhouette.GetTriangles();
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    nearest = std::min(nearest,
      GetDistance(light, points[corners[i]], points[corners[i + 1]], points[corners[i + 2]]));
  }
  return Lengthening *
    (farthest < LargestFactor * nearest ? std::max(farthest / nearest, 1.0) : LargestFactor);
}
}

/// The vertices of the merged points in one cap of the volume. Each is made when it is first
/// needed.
class vtkShadowVolume::Image
{
public:
  Image(const vtkShadowPoints& points, std::function<unsigned int(int)> make)
    : Vertices(points.size(), Unknown)
    , Make(std::move(make))
  {
  }

  unsigned int operator[](int point)
  {
    unsigned int& vertex = this->Vertices[point];
    if (vertex == Unknown)
    {
      vertex = this->Make(point);
    }
    return vertex;
  }

private:
  static constexpr unsigned int Unknown = std::numeric_limits<unsigned int>::max();

  std::vector<unsigned int> Vertices;
  std::function<unsigned int(int)> Make;
};

unsigned int vtkShadowVolume::AddVertex(const glm::dvec3& x, double w)
{
  (w != 0.0 ? this->Piece.Points : this->Piece.Directions).Add(x);
  this->Vertices.emplace_back(x, w);
  return static_cast<unsigned int>(this->Vertices.size() - 1);
}

void vtkShadowVolume::AddTriangle(unsigned int a, unsigned int b, unsigned int c)
{
  this->Indices.insert(this->Indices.end(), { a, b, c });
}

void vtkShadowVolume::AddTriangles(const vtkShadowSilhouette& silhouette, Image& image, Side side)
{
  const std::vector<int>& corners = silhouette.GetTriangles();
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    const unsigned int a = image[corners[i]];
    const unsigned int b = image[corners[i + 1]];
    const unsigned int c = image[corners[i + 2]];
    this->AddTriangle(a, side == Side::Near ? b : c, side == Side::Near ? c : b);
  }
}

void vtkShadowVolume::AddFan(const vtkShadowSilhouette& silhouette, Image& image, Side side)
{
  glm::dvec3 mean(0.0);
  for (const vtkShadowSilhouette::Edge& edge : silhouette.GetEdges())
  {
    mean += glm::dvec3(this->Vertices[image[edge.From]]) /
      static_cast<double>(silhouette.GetEdges().size());
  }
  const unsigned int centre = this->AddVertex(mean, 1.0);
  for (const vtkShadowSilhouette::Edge& edge : silhouette.GetEdges())
  {
    const unsigned int from = image[edge.From];
    const unsigned int to = image[edge.To];
    for (int i = 0; i < edge.Multiplicity; ++i)
    {
      this->AddTriangle(centre, side == Side::Near ? from : to, side == Side::Near ? to : from);
    }
  }
}

void vtkShadowVolume::AddSides(
  const vtkShadowSilhouette& silhouette, Image& nearImage, Image& farImage)
{
  for (const vtkShadowSilhouette::Edge& edge : silhouette.GetEdges())
  {
    const unsigned int a = nearImage[edge.From];
    const unsigned int b = nearImage[edge.To];
    const unsigned int farA = farImage[edge.From];
    const unsigned int farB = farImage[edge.To];
    for (int i = 0; i < edge.Multiplicity; ++i)
    {
      this->AddTriangle(b, a, farA);
      if (farA != farB)
      {
        this->AddTriangle(b, farA, farB);
      }
    }
  }
}

vtkShadowPiece vtkShadowVolume::AddWhole(const vtkShadowSilhouette& silhouette,
  const vtkShadowPoints& points, const vtkShadowLight& light, const vtkShadowBlock* view)
{
  if (view && !light.IsPositional())
  {
    const vtkShadowLightSpace space(light);
    const vtkShadowBlock block = vtkShadowFootprint::Make(points, space).Block;
    const double casterFar = block.High[2];
    const glm::dvec3& axis = space.GetAxis();
    const glm::dvec3 farthest = glm::max(view->Low * axis, view->High * axis);
    vtkShadowSlab slab = { block.Low[2],
      std::max(casterFar, farthest.x + farthest.y + farthest.z) };
    slab.Far += (Lengthening - 1.0) * (slab.Far - slab.Near);
    return this->AddClamped(silhouette, points, space, slab, casterFar);
  }
  this->Piece = { this->Indices.size() };
  Image nearImage(
    points, [&](int i) { return this->AddVertex(GetNearPoint(silhouette, points, i), 1.0); });
  this->AddTriangles(silhouette, nearImage, Side::Near);

  if (light.IsPositional())
  {
    const double factor = view ? GetFactor(silhouette, points, light.Position, *view) : 1.0;
    const glm::dvec3 origin = view ? light.Position : glm::dvec3(0.0);
    Image farImage(points,
      [&](int i) {
        return this->AddVertex(origin + factor * (points[i] - light.Position), view ? 1.0 : 0.0);
      });
    this->AddTriangles(silhouette, farImage, Side::Far);
    this->AddSides(silhouette, nearImage, farImage);
  }
  else
  {
    const unsigned int end = this->AddVertex(light.Direction, 0.0);
    Image farImage(points, [end](int) { return end; });
    this->AddSides(silhouette, nearImage, farImage);
  }
  this->Piece.EndIndex = this->Indices.size();
  return this->Piece;
}

vtkShadowPiece vtkShadowVolume::AddClamped(const vtkShadowSilhouette& silhouette,
  const vtkShadowPoints& points, const vtkShadowLightSpace& space, const vtkShadowSlab& slab,
  double casterFar)
{
  this->Piece = { this->Indices.size() };
  const bool nearPlane = casterFar < slab.Near;
  const double farDepth =
    slab.Far > casterFar ? slab.Far : casterFar + 1e-6 * (casterFar - slab.Near);
  const auto addExtruded = [&](int i, double depth)
  { return this->AddVertex(space.Extrude(points[i], depth), 1.0); };
  Image nearImage(points,
    [&](int i)
    {
      return nearPlane ? addExtruded(i, slab.Near)
                       : this->AddVertex(GetNearPoint(silhouette, points, i), 1.0);
    });
  Image farImage(points, [&](int i) { return addExtruded(i, farDepth); });

  if (nearPlane)
  {
    this->AddFan(silhouette, nearImage, Side::Near);
  }
  else
  {
    this->AddTriangles(silhouette, nearImage, Side::Near);
  }
  this->AddFan(silhouette, farImage, Side::Far);
  this->AddSides(silhouette, nearImage, farImage);
  this->Piece.EndIndex = this->Indices.size();
  return this->Piece;
}

VTK_ABI_NAMESPACE_END
