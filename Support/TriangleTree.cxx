// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleTree.h"

#include <numeric>

namespace
{
constexpr int LeafSize = 4;

double GetCentre(const std::vector<double>& corners, int triangle, int axis)
{
  const double* c = &corners[9 * static_cast<std::size_t>(triangle)];
  return (c[axis] + c[3 + axis] + c[6 + axis]) / 3.0;
}
}

PreparedRay::PreparedRay(const Ray& ray)
  : Line(ray)
{
  const double* d = ray.Direction;
  int largest = 0;
  for (int i = 0; i < 3; ++i)
  {
    largest = std::abs(d[i]) > std::abs(d[largest]) ? i : largest;
    // Never 1 / 0: infinity times a distance of 0 would be NaN.
    this->Inverse[i] = 1.0 / (std::abs(d[i]) < 1e-300 ? 1e-300 : d[i]);
  }
  this->Axes[2] = largest;
  this->Axes[0] = (largest + 1) % 3;
  this->Axes[1] = (largest + 2) % 3;
  this->Shear[0] = d[this->Axes[0]] / d[largest];
  this->Shear[1] = d[this->Axes[1]] / d[largest];
  this->Shear[2] = 1.0 / d[largest];
}

bool PreparedRay::Intersect(const double corners[9], double& t) const
{
  double x[3];
  double y[3];
  double z[3];
  for (int i = 0; i < 3; ++i)
  {
    const double* corner = corners + 3 * i;
    z[i] = corner[this->Axes[2]] - this->Line.Origin[this->Axes[2]];
    x[i] = corner[this->Axes[0]] - this->Line.Origin[this->Axes[0]] - this->Shear[0] * z[i];
    y[i] = corner[this->Axes[1]] - this->Line.Origin[this->Axes[1]] - this->Shear[1] * z[i];
  }
  // The same two products for both triangles of an edge, hence opposite numbers to the bit.
  const double u = x[2] * y[1] - y[2] * x[1];
  const double v = x[0] * y[2] - y[0] * x[2];
  const double w = x[1] * y[0] - y[1] * x[0];
  const double sum = u + v + w;
  if ((std::min({ u, v, w }) < 0.0 && std::max({ u, v, w }) > 0.0) || sum == 0.0)
  {
    return false;
  }
  t = (u * z[0] + v * z[1] + w * z[2]) / sum * this->Shear[2];
  return true;
}

double PreparedRay::Enter(const double low[3], const double high[3], double far) const
{
  // Boxes are given a margin when they are made, which covers the rounding here.
  double enter = this->Line.Near;
  double leave = far;
  for (int i = 0; i < 3; ++i)
  {
    const double one = (low[i] - this->Line.Origin[i]) * this->Inverse[i];
    const double two = (high[i] - this->Line.Origin[i]) * this->Inverse[i];
    enter = std::max(enter, std::min(one, two));
    leave = std::min(leave, std::max(one, two));
  }
  return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

void TriangleTree::Build(const std::vector<double>& corners)
{
  const int count = static_cast<int>(corners.size() / 9);
  this->Nodes.clear();
  this->Ids.resize(count);
  std::iota(this->Ids.begin(), this->Ids.end(), 0);
  if (count > 0)
  {
    this->BuildNode(corners, 0, count);
  }
  this->Corners.clear();
  this->Corners.reserve(corners.size());
  for (const int id : this->Ids)
  {
    const auto first = corners.begin() + 9 * static_cast<std::ptrdiff_t>(id);
    this->Corners.insert(this->Corners.end(), first, first + 9);
  }
}

void TriangleTree::BuildNode(const std::vector<double>& corners, int first, int last)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.emplace_back();
  Node node;
  int axis = 0;
  double widest = -1.0;
  for (int i = 0; i < 3; ++i)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    double lowCentre = low;
    double highCentre = high;
    for (int k = first; k < last; ++k)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const double value = corners[9 * static_cast<std::size_t>(this->Ids[k]) + 3 * corner + i];
        low = std::min(low, value);
        high = std::max(high, value);
      }
      const double centre = GetCentre(corners, this->Ids[k], i);
      lowCentre = std::min(lowCentre, centre);
      highCentre = std::max(highCentre, centre);
    }
    const double margin = 1e-12 * std::max(std::abs(low), std::abs(high)) + 1e-300;
    node.Low[i] = low - margin;
    node.High[i] = high + margin;
    if (highCentre - lowCentre > widest)
    {
      widest = highCentre - lowCentre;
      axis = i;
    }
  }
  if (last - first <= LeafSize)
  {
    node.First = first;
    node.Count = last - first;
    this->Nodes[index] = node;
    return;
  }
  const int middle = (first + last) / 2;
  std::nth_element(this->Ids.begin() + first, this->Ids.begin() + middle, this->Ids.begin() + last,
    [&](int a, int b) { return GetCentre(corners, a, axis) < GetCentre(corners, b, axis); });
  this->BuildNode(corners, first, middle);
  node.First = static_cast<int>(this->Nodes.size());
  this->Nodes[index] = node;
  this->BuildNode(corners, middle, last);
}

TriangleTree::Hit TriangleTree::FindNearest(const Ray& ray) const
{
  Hit hit;
  this->Traverse(ray,
    [&](int triangle, double t, double& far)
    {
      hit.Triangle = triangle;
      hit.T = t;
      far = t;
    });
  return hit;
}
