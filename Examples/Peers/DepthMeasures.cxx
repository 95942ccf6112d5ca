// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthMeasures.h"

#include <algorithm>
#include <cmath>

namespace NBufferPeers
{
namespace
{
constexpr int Size = 256; ///< Of the image, in pixels.
constexpr int Side = 64;  ///< Of the image, in tiles.
constexpr int Tiles = Side * Side;

const double HalfAngle = std::tan(0.5 * 30.0 * std::acos(-1.0) / 180.0);

double TakeMedian(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

glm::dvec3 GetRay(double x, double y)
{
  return { x * HalfAngle, y * HalfAngle, -1.0 };
}

/// Finds the distance of a triangle's plane on a ray, and whether the ray is well inside of it.
template <typename Triangle>
bool Meet(const Triangle& triangle, const glm::dvec3& ray, double& distance)
{
  const glm::dvec3 a(triangle[0]);
  const glm::dvec3 b(triangle[1]);
  const glm::dvec3 c(triangle[2]);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  distance = glm::dot(normal, a) / glm::dot(normal, ray);
  const double weights[3] = { glm::dot(ray, glm::cross(b, c)), glm::dot(ray, glm::cross(c, a)),
    glm::dot(ray, glm::cross(a, b)) };
  const double sum = weights[0] + weights[1] + weights[2];
  return std::min({ weights[0] / sum, weights[1] / sum, weights[2] / sum }) > 0.02;
}
}

DepthMeasures::DepthMeasures(vtkOpenGLRenderWindow* window, const NBufferStudy::DepthFormat& format,
  const NBufferStudy::DepthPlanes& planes)
  : Format(format)
  , View{ Size, Size, planes, { 1.0 / HalfAngle, 0.0, 0.0 }, { 0.0, 1.0 / HalfAngle, 0.0 },
    { 0.0, 0.0, -1.0 } }
  , Painter(window)
{
  this->Painter.SetView(this->Format, this->View, this->Obstacle);
}

DepthMeasures::Triangle DepthMeasures::MakeTriangle(
  double slopeX, double slopeY, double distance) const
{
  // No side is along an axis, and nothing is clipped.
  const double corners[3][2] = { { -0.95, -0.93 }, { 0.97, -0.81 }, { 0.07, 0.96 } };
  Triangle triangle;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 ray = GetRay(corners[i][0], corners[i][1]);
    triangle[i] = distance / (1.0 - slopeX * ray.x - slopeY * ray.y) * ray;
  }
  return triangle;
}

void DepthMeasures::Upload(const std::vector<Triangle>& triangles)
{
  std::vector<DepthVertex> vertices;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (const glm::vec3& corner : triangles[i])
    {
      vertices.push_back({ corner, static_cast<float>(i + 1) });
    }
  }
  this->Painter.SetTriangles(vertices);
  this->Vertices = static_cast<int>(vertices.size());
}

void DepthMeasures::Draw()
{
  this->Painter.Draw(0, this->Vertices);
}

DepthMeasures::Resolution DepthMeasures::MeasureResolution(double distance)
{
  const double most = 0.999 * this->View.Planes.Far - distance;
  // No surface is placed more exactly than floats are.
  const double least =
    std::max(this->Format.GetResolution(this->View.Planes, distance), distance * 0x1p-24);
  // Those that stand for this distance.
  const double nearby = std::max(0.05 * distance, least);
  for (double span = std::min(64.0 * least, most);; span = std::min(4.0 * span, most))
  {
    std::vector<double> distances;
    std::vector<Triangle> triangles;
    std::vector<std::size_t> pixels;
    for (int i = 0; i < Tiles; ++i)
    {
      // Neighbours in distance are far apart in the image.
      const int place = i * 1597 % Tiles;
      const int tile[2] = { place % Side, place / Side };
      const auto z = static_cast<float>(distance + span * i / Tiles);
      distances.push_back(z);
      const auto getCorner = [&](int x, int y)
      {
        return glm::vec3(distances.back() *
          GetRay(2.0 * (tile[0] + x) / Side - 1.0, 2.0 * (tile[1] + y) / Side - 1.0));
      };
      triangles.push_back({ getCorner(0, 0), getCorner(1, 0), getCorner(1, 1) });
      triangles.push_back({ getCorner(0, 0), getCorner(1, 1), getCorner(0, 1) });
      const int pixel = Size / Side;
      pixels.push_back(static_cast<std::size_t>(tile[1] * pixel + pixel / 2) * Size +
        static_cast<std::size_t>(tile[0] * pixel + pixel / 2));
    }
    this->Upload(triangles);
    this->Draw();
    const std::vector<double> depth = this->Painter.ReadDepth();
    // The nearest order of each tile and all beyond.
    std::vector<double> orders(Tiles);
    std::vector<double> nearest(Tiles);
    for (int i = Tiles - 1; i >= 0; --i)
    {
      orders[i] = this->Format.GetSign() * depth[pixels[i]];
      nearest[i] = i + 1 < Tiles ? std::min(orders[i], nearest[i + 1]) : orders[i];
    }
    std::vector<double> separations;
    bool areAllFound = true;
    for (int i = 0; i < Tiles / 2 && distances[i] <= distance + nearby; ++i)
    {
      const auto farther = std::upper_bound(nearest.begin(), nearest.end(), orders[i]);
      areAllFound = areAllFound && farther != nearest.end();
      if (areAllFound)
      {
        separations.push_back(distances[farther - nearest.begin()] - distances[i]);
      }
    }
    if (areAllFound)
    {
      Resolution resolution;
      resolution.Worst = *std::max_element(separations.begin(), separations.end());
      resolution.Median = TakeMedian(separations);
      return resolution;
    }
    if (span >= most)
    {
      return {};
    }
  }
}

DepthMeasures::Fight DepthMeasures::CountWrongPixels(double slope, double distance, double gap)
{
  const Triangle near = this->MakeTriangle(0.0, slope, distance);
  const Triangle far = this->MakeTriangle(0.0, slope, distance + gap);
  this->Upload({ near, far });
  this->Draw();
  const std::vector<float> numbers = this->Painter.ReadNumbers();
  Fight fight;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const glm::dvec3 ray = GetRay((2 * x + 1.0) / Size - 1.0, (2 * y + 1.0) / Size - 1.0);
      double distances[2];
      const bool isCovered = Meet(near, ray, distances[0]) && Meet(far, ray, distances[1]);
      const double first = std::min(distances[0], distances[1]);
      if (isCovered && distances[0] != distances[1] && first > this->View.Planes.Near)
      {
        ++fight.Pixels;
        const float nearer = distances[0] < distances[1] ? 1.0f : 2.0f;
        fight.Wrong += numbers[static_cast<std::size_t>(y) * Size + x] != nearer ? 1 : 0;
      }
    }
  }
  return fight;
}

DepthMeasures::Offset DepthMeasures::MeasureOffset(double slopeX, double slopeY, double distance)
{
  const Triangle triangle = this->MakeTriangle(slopeX, slopeY, distance);
  this->Upload({ triangle });
  const auto draw = [&](float factor, float units)
  {
    this->Painter.SetOffset(factor, units);
    this->Draw();
    return this->Painter.ReadDepth();
  };
  // Enough to be seen in any format, and so little that no depth reaches the end of its range.
  const double units = std::ldexp(1.0, this->Format.Bits > 0 ? this->Format.Bits - 10 : 12);
  const double factor = 4.0;
  const std::vector<double> plain = draw(0.0f, 0.0f);
  const std::vector<double> one = draw(0.0f, 1.0f);
  const std::vector<double> many = draw(0.0f, static_cast<float>(units));
  const std::vector<double> sloped = draw(static_cast<float>(factor), 0.0f);
  this->Painter.SetOffset(0.0f, 0.0f);
  std::vector<double> byUnits;
  std::vector<double> byFactor;
  Offset offset;
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    if (plain[i] != this->Format.GetBackground())
    {
      byUnits.push_back((many[i] - plain[i]) / units);
      byFactor.push_back((sloped[i] - plain[i]) / factor);
      offset.MovedByOne += one[i] != plain[i] ? 1.0 : 0.0;
    }
  }
  offset.MovedByOne /= static_cast<double>(byUnits.size());
  offset.Unit = TakeMedian(byUnits);
  offset.Slope = TakeMedian(byFactor);

  glm::dvec3 window[3];
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 corner(triangle[i]);
    const double depth = this->Format.GetDepth(this->View.Planes, -corner.z);
    window[i] = { 0.5 * Size * corner.x / (HalfAngle * -corner.z),
      0.5 * Size * corner.y / (HalfAngle * -corner.z), depth };
    largest = std::max(largest, depth);
  }
  const glm::dvec3 normal = glm::cross(window[1] - window[0], window[2] - window[0]);
  const glm::dvec2 gradient = glm::dvec2(normal) / normal.z;
  offset.LargerSlope = std::max(std::abs(gradient.x), std::abs(gradient.y));
  offset.SteepestSlope = glm::length(gradient);
  offset.ExpectedUnit =
    this->Format.Bits > 0 ? std::ldexp(1.0, -this->Format.Bits) : this->Format.GetQuantum(largest);
  return offset;
}

} // namespace NBufferPeers
