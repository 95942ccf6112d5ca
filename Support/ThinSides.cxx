// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThinSides.h"

#include "DrawnPolygon.h"
#include "OracleImage.h"
#include "RenderedTriangles.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
/// An edge of a triangle, its smaller corner first.
struct Edge
{
  std::array<double, 6> Corners;
  int Owner;
  bool Facing; ///< The light sees the triangle's front.

  bool IsSame(const Edge& other) const
  {
    return this->Owner == other.Owner && this->Corners == other.Corners;
  }
};

void AddEdges(
  const double corners[9], int owner, const OracleLight& light, std::vector<Edge>& edges)
{
  double ab[3];
  double ac[3];
  double normal[3];
  double toLight[3];
  vtkMath::Subtract(corners + 3, corners, ab);
  vtkMath::Subtract(corners + 6, corners, ac);
  vtkMath::Cross(ab, ac, normal);
  for (int i = 0; i < 3; ++i)
  {
    toLight[i] = light.Positional ? light.Position[i] - corners[i] : -light.Direction[i];
  }
  const double facing = vtkMath::Dot(normal, toLight);
  if (facing == 0.0)
  {
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    const double* a = corners + 3 * i;
    const double* b = corners + 3 * ((i + 1) % 3);
    if (std::lexicographical_compare(b, b + 3, a, a + 3))
    {
      std::swap(a, b);
    }
    edges.push_back({ { a[0], a[1], a[2], b[0], b[1], b[2] }, owner, facing > 0.0 });
  }
}
}

ThinSides::ThinSides(const RenderedTriangles& triangles, const std::vector<unsigned char>& casts,
  const OracleLight& light, const View& view)
  : Width(view.Width)
  , Pixels(static_cast<std::size_t>(view.Width) * view.Height)
{
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < triangles.Owners.size(); ++i)
  {
    if (casts[triangles.Owners[i]])
    {
      AddEdges(&triangles.Corners[9 * i], triangles.Owners[i], light, edges);
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const Edge& a, const Edge& b)
    { return a.Owner != b.Owner ? a.Owner < b.Owner : a.Corners < b.Corners; });
  for (auto first = edges.begin(); first != edges.end();)
  {
    const auto last =
      std::find_if(first, edges.end(), [&](const Edge& edge) { return !edge.IsSame(*first); });
    if (last - first != 2 || first->Facing != first[1].Facing)
    {
      this->AddSide(first->Corners.data(), first->Corners.data() + 3, light, view);
    }
    first = last;
  }
}

void ThinSides::AddSide(
  const double a[3], const double b[3], const OracleLight& light, const View& view)
{
  std::vector<DrawnPolygon::Corner> corners;
  double x[3];
  for (const double* end : { a, b })
  {
    vtkMath::Subtract(end, view.Eye, x);
    corners.push_back(DrawnPolygon::Transform(view.EyeToClip, x));
  }
  if (light.Positional)
  {
    for (const double* end : { b, a })
    {
      vtkMath::Subtract(end, light.Position, x);
      corners.push_back(DrawnPolygon::Transform(view.EyeToClip, x, 0.0));
    }
  }
  else
  {
    corners.push_back(DrawnPolygon::Transform(view.EyeToClip, light.Direction, 0.0));
  }
  const DrawnPolygon polygon(corners, DrawnPolygon::Planes::Near, view.Width, view.Height);
  if ((!polygon.IsVisible() && !polygon.IsEdgeOn()) ||
    polygon.GetThickness() >= GetLargestThickness())
  {
    return;
  }
  const bool anyDepth = polygon.GetThickness() < GetLeastThickness();
  constexpr double margin = 1.0 / 256; // a step of the subpixel grid
  const int end = std::min(view.Height, static_cast<int>(polygon.GetBoundsY()[1] + margin) + 1);
  for (int row = std::max(0, static_cast<int>(polygon.GetBoundsY()[0] - margin)); row < end; ++row)
  {
    double x0;
    double x1;
    if (!polygon.GetRow(row + 0.5, margin, x0, x1))
    {
      continue;
    }
    const int last = std::min(view.Width - 1, static_cast<int>(std::floor(x1 - 0.5)));
    for (int column = std::max(0, static_cast<int>(std::ceil(x0 - 0.5))); column <= last; ++column)
    {
      const Crossing crossing = anyDepth ? Crossing{ 0.5, HUGE_VAL }
                                         : Crossing{ polygon.GetDepth(column + 0.5, row + 0.5),
                                             polygon.GetBound(column + 0.5, row + 0.5) };
      this->Pixels[static_cast<std::size_t>(row) * view.Width + column].push_back(crossing);
    }
  }
}

bool ThinSides::AreNear(int x, int y, double depth, double slack) const
{
  const std::vector<Crossing>& crossings =
    this->Pixels[static_cast<std::size_t>(y) * this->Width + x];
  return std::any_of(crossings.begin(), crossings.end(),
    [&](const Crossing& crossing)
    { return std::abs(crossing.Depth - depth) <= crossing.Bound + slack; });
}
