// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampledViews.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkNBufferProjection MakeProjection(const View& view, DepthConvention convention)
{
  vtkNBufferProjection projection;
  NBufferStudy::SetProjection(projection, view.WorldToClip.data(), view.Width, view.Height,
    convention == DepthConvention::Forward ? 0x1p-24 : 0.0, convention);
  return projection;
}

double ViewSampler::Uniform(double a, double b)
{
  return std::uniform_real_distribution<double>(a, b)(this->Random);
}

int ViewSampler::Integer(int a, int b)
{
  return std::uniform_int_distribution<int>(a, b)(this->Random);
}

View ViewSampler::MakeView(double offset, bool extremeRange)
{
  View view;
  const int sizes[][2] = { { 301, 173 }, { 97, 211 }, { 640, 33 }, { 1, 1 }, { 1920, 1080 },
    { 1, 300 }, { 257, 1 } };
  const auto& size = sizes[this->Integer(0, 6)];
  view.Width = size[0];
  view.Height = size[1];
  view.Parallel = this->Integer(0, 3) == 0;
  vtkNew<vtkCamera> camera;
  for (int i = 0; i < 3; ++i)
  {
    view.Position[i] = offset + this->Uniform(-5.0, 5.0);
    view.Direction[i] = this->Uniform(-1.0, 1.0);
  }
  const glm::dvec3 focalPoint = view.Position + view.Direction;
  camera->SetPosition(glm::value_ptr(view.Position));
  camera->SetFocalPoint(glm::value_ptr(focalPoint));
  camera->SetViewUp(this->Uniform(-1.0, 1.0), this->Uniform(-1.0, 1.0), this->Uniform(-1.0, 1.0));
  camera->SetViewAngle(std::pow(10.0, this->Uniform(0.3, 2.15)));
  camera->SetParallelProjection(view.Parallel);
  camera->SetParallelScale(std::pow(10.0, this->Uniform(-1.0, 2.0)));
  view.Near = extremeRange ? std::pow(10.0, this->Uniform(-3.0, 1.0)) : 1.0;
  view.Far = view.Near * (extremeRange ? std::pow(10.0, this->Uniform(0.5, 7.0)) : 100.0);
  camera->SetClippingRange(view.Near, view.Far);
  vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(
    static_cast<double>(view.Width) / view.Height, -1.0, 1.0);
  std::copy(matrix->GetData(), matrix->GetData() + 16, view.WorldToClip.begin());
  std::ostringstream text;
  text.precision(17);
  text << view.Width << " x " << view.Height << (view.Parallel ? " parallel" : " perspective")
       << " near " << view.Near << " far " << view.Far << " at " << view.Position.x << " "
       << view.Position.y << " " << view.Position.z;
  view.Text = text.str();
  return view;
}

std::array<double, 6> ViewSampler::MakeBounds(const View& view)
{
  // Along the view direction at any distance, beside it by as much, of any size.
  const double distance = view.Near * std::pow(view.Far / view.Near, this->Uniform(-0.1, 1.05)) *
    (this->Integer(0, 9) == 0 ? -1.0 : 1.0);
  const double length = std::hypot(view.Direction[0], view.Direction[1], view.Direction[2]);
  const double size = std::abs(distance) * std::pow(10.0, this->Uniform(-4.0, 0.5));
  std::array<double, 6> bounds{};
  for (int i = 0; i < 3; ++i)
  {
    const double center = view.Position[i] + distance * view.Direction[i] / length +
      std::abs(distance) * this->Uniform(-0.8, 0.8);
    const double half = this->Integer(0, 7) == 0 ? 0.0 : size * this->Uniform(0.0, 1.0);
    bounds[2 * i] = static_cast<float>(center - half);
    bounds[2 * i + 1] = std::max<double>(bounds[2 * i], static_cast<float>(center + half));
  }
  return bounds;
}

void ViewSampler::Flatten(View& view, const std::array<double, 6>& bounds)
{
  const glm::dvec3 center = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
  // y and z go to nearly the same direction. That of x is kept, so that nothing of size is in the
  // row of the inverse which gives x.
  glm::dmat3 rows(1.0);
  rows[1] = { 0.0, this->Uniform(-1, 1), this->Uniform(-1, 1) };
  rows[2] = this->Uniform(-1, 1) * rows[1];
  rows[2].z += this->Integer(0, 1) == 0 ? 0.0 : std::pow(10.0, this->Uniform(-20, -6));
  const glm::dmat3 flat = glm::transpose(rows);
  glm::dmat4 toWorld(flat);
  toWorld[3] = glm::dvec4(center - flat * center, 1.0);
  vtkMatrix4x4::Multiply4x4(
    view.WorldToClip.data(), vtkNBufferGLM::ToRows(toWorld).data(), view.WorldToClip.data());
}

std::vector<glm::dvec3> ViewSampler::MakePoints(const std::array<double, 6>& bounds, int count)
{
  std::vector<glm::dvec3> points;
  for (int corner = 0; corner < 8; ++corner)
  {
    points.emplace_back(
      bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)]);
  }
  for (int n = 0; n < count; ++n)
  {
    glm::dvec3 point;
    for (int i = 0; i < 3; ++i)
    {
      // A vertex is a float inside the bounds; every other one lies on a face.
      const auto inside = static_cast<float>(this->Uniform(bounds[2 * i], bounds[2 * i + 1]));
      point[i] = std::min(std::max<double>(inside, bounds[2 * i]), bounds[2 * i + 1]);
    }
    if (n % 2)
    {
      const int face = this->Integer(0, 5);
      point[face / 2] = bounds[face];
    }
    points.push_back(point);
  }
  return points;
}

double View::ToOrder(double windowDepth, DepthConvention convention) const
{
  // 1 / w is linear in window depth.
  return convention == DepthConvention::Forward ? windowDepth
    : convention == DepthConvention::Reversed   ? windowDepth - 1.0
                                              : windowDepth * (1.0 - this->Near / this->Far) - 1.0;
}

namespace
{
using Rows = vtkNBufferProjection::Rows;
template <typename Real>
using Vector3 = glm::vec<3, Real>;
template <typename Real>
using Vector4 = glm::vec<4, Real>;

/// The matrix that a renderer uploads. Its row 2 gives the stored depth times w, except that for
/// Forward it gives NDC z times w.
Rows GetMatrix(const View& view, DepthConvention convention)
{
  Rows rows;
  for (int i = 0; i < 4; ++i)
  {
    rows[i] = glm::make_vec4(view.WorldToClip.data() + 4 * i);
  }
  if (convention == DepthConvention::Reversed)
  {
    rows[2] = 0.5 * (rows[3] - rows[2]);
  }
  else if (convention == DepthConvention::InverseW)
  {
    rows[2] = { 0.0, 0.0, 0.0, view.Near };
  }
  return rows;
}

template <typename Real>
std::optional<glm::dvec3> ToScreen(
  const View& view, const Vector4<Real>& clip, DepthConvention convention)
{
  if (!(clip.w > 0))
  {
    return {};
  }
  // The least third coordinate in view: on the near plane for Forward, on the far plane for others.
  const Real end = convention == DepthConvention::Forward ? -clip.w
    : convention == DepthConvention::Reversed             ? 0
                                              : clip.w * static_cast<Real>(view.Near / view.Far);
  for (int i = 0; i < 3; ++i)
  {
    if (clip[i] < (i < 2 ? -clip.w : end) || clip[i] > clip.w)
    {
      return {};
    }
  }
  const Real half = static_cast<Real>(0.5);
  const Real depth = clip.z / clip.w;
  return glm::dvec3{ static_cast<double>((clip.x / clip.w * half + half) * view.Width),
    static_cast<double>((clip.y / clip.w * half + half) * view.Height),
    static_cast<double>(convention == DepthConvention::Forward ? depth * half + half : -depth) };
}
}

std::optional<glm::dvec3> ProjectExactly(
  const View& view, const glm::dvec3& point, DepthConvention convention)
{
  const Rows rows = GetMatrix(view, convention);
  const Vector4<long double> exact(point, 1.0);
  Vector4<long double> clip;
  for (int i = 0; i < 4; ++i)
  {
    clip[i] = glm::dot(Vector4<long double>(rows[i]), exact);
  }
  return ToScreen(view, clip, convention);
}

std::optional<glm::dvec3> ProjectAsDevice(
  const View& view, const glm::dvec3& point, int permutation, DepthConvention convention)
{
  const Rows rows = GetMatrix(view, convention);
  glm::vec4 clip;
  for (int i = 0; i < 4; ++i)
  {
    glm::vec4 terms = glm::vec4(rows[i]) * glm::vec4(point, 1.0f);
    std::swap(terms[0], terms[permutation]);
    // From left to right.
    clip[i] = terms.x + terms.y + terms.z + terms.w;
  }
  return ToScreen(view, clip, convention);
}

std::optional<std::array<double, 2>> GetDepthsAlongRay(
  const View& view, const std::array<double, 6>& bounds, double x, double y)
{
  double inverse[16];
  vtkMatrix4x4::Invert(view.WorldToClip.data(), inverse);
  const auto unproject = [&](double z)
  {
    const Vector4<long double> ndc(
      2.0L * x / view.Width - 1.0L, 2.0L * y / view.Height - 1.0L, 2.0L * z - 1.0L, 1.0L);
    Vector4<long double> world;
    for (int i = 0; i < 4; ++i)
    {
      world[i] = glm::dot(Vector4<long double>(glm::make_vec4(inverse + 4 * i)), ndc);
    }
    return Vector3<long double>(world) / world.w;
  };
  const Vector3<long double> from = unproject(0.0);
  const Vector3<long double> to = unproject(1.0);
  long double enter = 0.0L;
  long double leave = 1.0L;
  for (int i = 0; i < 3; ++i)
  {
    const long double d = to[i] - from[i];
    if (d == 0.0L)
    {
      if (from[i] < bounds[2 * i] || from[i] > bounds[2 * i + 1])
      {
        return {};
      }
      continue;
    }
    const long double a = (bounds[2 * i] - from[i]) / d;
    const long double b = (bounds[2 * i + 1] - from[i]) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (!(enter <= leave))
  {
    return {};
  }
  const Rows rows = GetMatrix(view, DepthConvention::Forward);
  const auto getDepth = [&](long double t)
  {
    const Vector4<long double> point(glm::dvec3(from + t * (to - from)), 1.0);
    const long double z = glm::dot(Vector4<long double>(rows[2]), point);
    const long double w = glm::dot(Vector4<long double>(rows[3]), point);
    return static_cast<double>(0.5L * z / w + 0.5L);
  };
  return std::array<double, 2>{ getDepth(enter), getDepth(leave) };
}

bool IsWithin(const glm::dvec3& point, const vtkNBufferScreenBox& screen)
{
  const vtkNBufferRectangle& r = screen.Pixels;
  return glm::all(glm::lessThanEqual(glm::dvec3(r.X0, r.Y0, screen.Nearest), point)) &&
    glm::all(glm::lessThanEqual(point, glm::dvec3(r.X1, r.Y1, screen.Farthest)));
}

std::string GetText(const View& view, const std::array<double, 6>& bounds)
{
  std::ostringstream text;
  text.precision(17);
  text << view.Text << ", box";
  for (double bound : bounds)
  {
    text << " " << bound;
  }
  return text.str();
}
