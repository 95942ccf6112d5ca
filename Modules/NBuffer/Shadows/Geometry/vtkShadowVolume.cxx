// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolume.h"

#include "vtkMath.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Where the near cap has point i.
void GetNearPoint(const vtkShadowSilhouette& silhouette, const double* points, int i, double x[3])
{
  std::copy_n(points + 3 * i, 3, x);
  if (!silhouette.GetPushes().empty())
  {
    vtkMath::Add(x, &silhouette.GetPushes()[3 * std::size_t(i)], x);
  }
}
}

/// The vertices that stand for merged points on one side of the volume, each made when it is first
/// asked for.
class vtkShadowVolume::Image
{
public:
  using Maker = std::function<unsigned int(int point)>;

  Image(int numberOfPoints, Maker make)
    : Vertices(static_cast<std::size_t>(numberOfPoints), Unknown)
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
  Maker Make;
};

void vtkShadowVolume::Begin(const double origin[3])
{
  std::copy_n(origin, 3, this->Origin);
  this->Vertices.clear();
  this->Indices.clear();
}

void vtkShadowVolume::AddWhole(const vtkShadowSilhouette& silhouette, const double* points,
  int numberOfPoints, const vtkShadowLight& light)
{
  const auto addPoint = [&](int i)
  {
    double x[3];
    GetNearPoint(silhouette, points, i, x);
    vtkMath::Subtract(x, this->Origin, x);
    return this->AddVertex(x, 1.0f);
  };
  Image nearImage(numberOfPoints, addPoint);
  this->AddTriangles(silhouette, nearImage, Side::Near);

  if (light.IsPositional())
  {
    const auto addDirection = [&](int i)
    {
      double ray[3];
      vtkMath::Subtract(points + 3 * i, light.Position, ray);
      return this->AddVertex(ray, 0.0f);
    };
    Image farImage(numberOfPoints, addDirection);
    this->AddTriangles(silhouette, farImage, Side::Far);
    this->AddSides(silhouette, nearImage, farImage);
  }
  else
  {
    const unsigned int end = this->AddVertex(light.Direction, 0.0f);
    Image farImage(numberOfPoints, [end](int) { return end; });
    this->AddSides(silhouette, nearImage, farImage);
  }
}

void vtkShadowVolume::AddClamped(const vtkShadowSilhouette& silhouette, const double* points,
  int numberOfPoints, const vtkShadowLightSpace& frame, const vtkShadowSlab& slab, double casterFar,
  vtkShadowCap cap)
{
  const bool nearPlane = casterFar < slab.Near;
  const double farDepth =
    slab.Far > casterFar ? slab.Far : casterFar + 1e-6 * (casterFar - slab.Near);
  const auto addImage = [&](int i, bool extruded, double depth)
  {
    double x[3];
    if (extruded)
    {
      frame.Extrude(points + 3 * i, depth, x);
    }
    else
    {
      GetNearPoint(silhouette, points, i, x);
    }
    vtkMath::Subtract(x, this->Origin, x);
    return this->AddVertex(x, 1.0f);
  };
  Image nearImage(numberOfPoints, [&](int i) { return addImage(i, nearPlane, slab.Near); });
  Image farImage(numberOfPoints, [&](int i) { return addImage(i, true, farDepth); });

  if (nearPlane && cap == vtkShadowCap::Fan)
  {
    this->AddFan(silhouette, nearImage, Side::Near);
  }
  else
  {
    this->AddTriangles(silhouette, nearImage, Side::Near);
  }
  if (cap == vtkShadowCap::Fan)
  {
    this->AddFan(silhouette, farImage, Side::Far);
  }
  else
  {
    this->AddTriangles(silhouette, farImage, Side::Far);
  }
  this->AddSides(silhouette, nearImage, farImage);
}

unsigned int vtkShadowVolume::AddVertex(const double x[3], float w)
{
  const std::size_t vertex = this->Vertices.size() / 4;
  for (int i = 0; i < 3; ++i)
  {
    this->Vertices.push_back(static_cast<float>(x[i]));
  }
  this->Vertices.push_back(w);
  return static_cast<unsigned int>(vertex);
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
  double mean[3] = { 0.0, 0.0, 0.0 };
  for (const vtkShadowSilhouette::Edge& edge : silhouette.GetEdges())
  {
    const unsigned int vertex = image[edge.From];
    for (int i = 0; i < 3; ++i)
    {
      mean[i] += this->Vertices[4 * std::size_t(vertex) + i] /
        static_cast<double>(silhouette.GetEdges().size());
    }
  }
  const unsigned int centre = this->AddVertex(mean, 1.0f);
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
VTK_ABI_NAMESPACE_END
