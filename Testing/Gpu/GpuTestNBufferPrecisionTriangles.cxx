// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GpuTestNBufferPrecisionTriangles.h"

#include "Pixels.h"
#include "vtkNBufferGL.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
/// Twice the signed area, in pixels.
double GetArea(const Triangle& v)
{
  return glm::cross(v[1] - v[0], v[2] - v[0]).z;
}
}

glm::dvec3 ToScreen(const glm::dmat4& worldToClip, const glm::dvec3& point)
{
  const glm::dvec4 clip = vtkNBufferGLM::Multiply(worldToClip, glm::dvec4(point, 1.0));
  return (0.5 * glm::dvec3(clip) / clip.w + 0.5) * glm::dvec3(Width, Height, 1.0);
}

Triangle ToScreen(const glm::dmat4& worldToClip, const Triangle& triangle)
{
  return { ToScreen(worldToClip, triangle[0]), ToScreen(worldToClip, triangle[1]),
    ToScreen(worldToClip, triangle[2]) };
}

double GetHeight(const Triangle& onScreen)
{
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const glm::dvec2 side = onScreen[(i + 1) % 3] - onScreen[i];
    longest = std::max(longest, glm::length(side));
  }
  return std::abs(GetArea(onScreen)) / longest;
}

Sampler::Sampler(const CameraCase& camera, unsigned int seed, vtkNBufferStoredDepth stored)
  : Case(camera)
  , Stored(stored)
  , Random(seed)
{
  // Along an axis, so that a triangle has the depth range of its bounds.
  this->Camera->SetPosition(camera.Offset, camera.Offset, 0.0);
  this->Camera->SetFocalPoint(camera.Offset, camera.Offset, -1.0);
  this->Camera->SetParallelProjection(camera.Parallel);
  this->Camera->SetParallelScale(0.01 * camera.Far);
  this->Camera->SetClippingRange(camera.Near, camera.Far);
  this->WorldToClip = vtkNBufferGLM::ToMatrix(
    this->Camera
      ->GetCompositeProjectionTransformMatrix(static_cast<double>(Width) / Height, -1.0, 1.0)
      ->GetData());
  this->ClipToWorld = vtkNBufferGLM::Invert(this->WorldToClip);
}

glm::dmat4 Sampler::GetWorldToClip() const
{
  glm::dmat4 matrix = this->WorldToClip;
  if (this->Stored == vtkNBufferStoredDepth::Reversed)
  {
    matrix = glm::row(matrix, 2, 0.5 * (glm::row(matrix, 3) - glm::row(matrix, 2)));
  }
  return matrix;
}

glm::dmat4 Sampler::GetWorldToOrder() const
{
  glm::dmat4 matrix = this->GetWorldToClip();
  if (this->Stored == vtkNBufferStoredDepth::Reversed)
  {
    matrix = glm::row(matrix, 2, -2.0 * glm::row(matrix, 2) - glm::row(matrix, 3));
  }
  return matrix;
}

vtkNBufferProjection Sampler::GetProjection(double quantum) const
{
  glm::dmat4 matrix = this->GetWorldToClip();
  if (this->Stored == vtkNBufferStoredDepth::Reversed)
  {
    matrix = glm::row(matrix, 2, -glm::row(matrix, 2));
  }
  vtkNBufferProjection projection;
  projection.Set(vtkNBufferGLM::ToRows(matrix).data(), Width, Height,
    vtkNBufferDepthFormat::FromQuantum(quantum, this->Stored), {}, vtkNBufferGL::GetSubpixelBits());
  return projection;
}

glm::dvec3 Sampler::ToWorld(double x, double y, double z) const
{
  const glm::dvec4 world = vtkNBufferGLM::Multiply(
    this->ClipToWorld, { 2.0 * x / Width - 1.0, 2.0 * y / Height - 1.0, z, 1.0 });
  return glm::dvec3(world) / world.w;
}

Triangle Sampler::Make(Kind kind)
{
  if (kind == Kind::Behind || kind == Kind::Steep || kind == Kind::Sliver)
  {
    return kind == Kind::Behind ? this->MakeGround()
      : kind == Kind::Steep     ? this->MakeSteep()
                                : this->MakeSliver();
  }
  // A middle depth anywhere between the planes, and crowded at both of them.
  const double fromPlane = this->Logarithmic(1e-6, 1.0);
  const double z = std::copysign(1.0 - fromPlane, this->Uniform(-1.0, 1.0));
  const double reach = kind == Kind::Facing ? 0.0 : 0.99 * fromPlane * this->Logarithmic(1e-3, 1);
  double x = this->Uniform(0.0, Width);
  double y = this->Uniform(0.0, Height);
  double size = this->Logarithmic(2.0, 200.0);
  if (kind == Kind::SubPixel)
  {
    x = std::floor(x) + 0.5;
    y = std::floor(y) + 0.5;
    size = this->Uniform(0.3, 1.0);
  }
  Triangle triangle;
  for (glm::dvec3& point : triangle)
  {
    point = this->ToWorld(x + this->Uniform(-size, size), y + this->Uniform(-size, size),
      z + this->Uniform(-reach, reach));
  }
  return triangle;
}

Triangle Sampler::MakeSteep()
{
  const double reach = this->Logarithmic(1e-3, 0.99);
  const double z = this->Uniform(reach - 1.0, 1.0 - reach);
  const double away = this->Uniform(-1.0, 1.0) < 0.0 ? reach : -reach;
  constexpr double step = 1.0 / 512;
  const auto& place = this->Samples[std::uniform_int_distribution<std::size_t>(
    0, this->Samples.size() - 1)(this->Random)];
  const double x = std::floor(this->Uniform(0.0, Width)) + place[0] + this->Uniform(-step, step);
  const double y = std::floor(this->Uniform(0.0, Height)) + place[1] + this->Uniform(-step, step);
  static const glm::dvec2 directions[4] = { { 1, 0 }, { 0, 1 }, { 1, 1 }, { 1, -1 } };
  const glm::dvec2& direction = directions[std::uniform_int_distribution<int>(0, 3)(this->Random)];
  const double length = std::floor(this->Logarithmic(2.0, 200.0));
  const double height = (this->Uniform(-1.0, 1.0) < 0.0 ? 1.0 : -1.0) *
    this->Logarithmic(LowestHeight, 4.0 * LowestHeight);
  const double middle = length * this->Uniform(0.0, 1.0);
  const glm::dvec2 start(x, y);
  const glm::dvec2 end = start + length * direction;
  const glm::dvec2 third = start + middle * direction +
    height * glm::dvec2(-direction.y, direction.x) / glm::length(direction);
  return { this->ToWorld(x, y, z + away), this->ToWorld(end.x, end.y, z + away),
    this->ToWorld(third.x, third.y, z - away) };
}

Triangle Sampler::MakeSliver()
{
  Triangle screen = ToScreen(this->WorldToClip, this->MakeSteep());
  // The third corner towards the side below, and the depths anywhere between the two there were.
  const glm::dvec2 side = screen[1] - screen[0];
  const double foot = glm::dot(glm::dvec2(screen[2] - screen[0]), side) / glm::dot(side, side);
  const double lower = this->Logarithmic(1e-6, 1.0);
  const glm::dvec2 third =
    glm::mix(glm::dvec2(screen[0]) + foot * side, glm::dvec2(screen[2]), lower);
  screen[1].z += this->Uniform(0.0, 1.0) * (screen[2].z - screen[1].z);
  screen[2] = glm::dvec3(third,
    glm::mix(screen[0].z, screen[1].z, foot) +
      this->Logarithmic(1e-4, 1.0) * (screen[2].z - screen[0].z) * 0.5);
  for (glm::dvec3& point : screen)
  {
    point = this->ToWorld(point.x, point.y, std::clamp(2.0 * point.z - 1.0, -0.999, 0.999));
  }
  return screen;
}

Triangle Sampler::MakeGround()
{
  const double aside = this->Case.Near * this->Logarithmic(2.0, 50.0);
  const int axis = this->Uniform(0.0, 1.0) < 0.5 ? 0 : 1;
  const double sign = this->Uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
  Triangle triangle;
  for (int i = 0; i < 3; ++i)
  {
    glm::dvec3& point = triangle[i];
    point[axis] = this->Case.Offset + sign * aside * this->Uniform(1.0, 2.0);
    point[1 - axis] = this->Case.Offset + aside * this->Uniform(-5.0, 5.0);
    point[2] = aside * (i == 0 ? this->Uniform(0.0, 5.0) : -this->Uniform(2.0, 20.0));
  }
  return triangle;
}

Judge::Judge(const Sampler& sampler, const Triangle& triangle, bool isBehind)
  : Vertices(ToScreen(sampler.GetWorldToOrder(), triangle))
  , IsBehind(isBehind)
  , Stored(sampler.GetStored())
{
  const Triangle& v = this->Vertices;
  this->Nearest = std::min({ v[0].z, v[1].z, v[2].z });
  this->Farthest = std::max({ v[0].z, v[1].z, v[2].z });
  const glm::dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
  this->Slope = -glm::dvec2(normal) / normal.z;
}

void Judge::Compare(const vtkNBufferScreenBox& screen, const vtkNBufferRectangle& rectangle,
  const std::vector<float>& depth, Finding& finding) const
{
  const double slack =
    vtkNBufferDepthFormat::FromQuantum(0.0, this->Stored).Scale * screen.Slack[2];
  const double background = this->Stored == vtkNBufferStoredDepth::Reversed ? 0.0 : 1.0;
  const glm::dvec2 pixelSlack = 0.5 * glm::dvec2(Width, Height) * glm::dvec2(screen.Slack);
  const double planeSlack = slack + glm::dot(glm::abs(this->Slope), pixelSlack);
  const float* next = depth.data();
  for (const auto& [x, y] : Pixels(rectangle))
  {
    const double z = *next++;
    if (z == background)
    {
      continue;
    }
    ++finding.Fragments;
    ASSERT_TRUE(IsIn(x, y, screen.Middles)) << x << " " << y;
    ASSERT_GE(z, screen.Nearest);
    ASSERT_LE(z, screen.Farthest);
    const glm::dvec2 place(x + 0.5, y + 0.5);
    const double plane =
      this->Vertices[0].z + glm::dot(this->Slope, place - glm::dvec2(this->Vertices[0]));
    ASSERT_LE(std::abs(z - plane), planeSlack);
    finding.OfPlane = std::max(finding.OfPlane, std::abs(z - plane) / planeSlack);
    // Vertices behind the eye have no depth that bounds what is drawn.
    if (!this->IsBehind)
    {
      const double outside = std::max(this->Nearest - z, z - this->Farthest);
      ASSERT_LE(outside, slack);
      finding.AddOutside(outside, slack);
      finding.Nearer += z < this->Nearest;
    }
  }
}

vtkNBufferBox BoundTriangle(const Triangle& triangle, const Sampler& sampler)
{
  const glm::dvec3 low = glm::min(glm::min(triangle[0], triangle[1]), triangle[2]);
  const glm::dvec3 high = glm::max(glm::max(triangle[0], triangle[1]), triangle[2]);
  const double bounds[6] = { low.x, high.x, low.y, high.y, low.z, high.z };
  vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds);
  box.Origin = sampler.GetShift();
  box.Magnitude = glm::abs(box.Center - box.Origin) + box.HalfSize;
  return box;
}
