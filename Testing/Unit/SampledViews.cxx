// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampledViews.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

vtkNBufferProjection MakeProjection(const View& view, vtkNBufferDepthConvention convention)
{
  vtkNBufferProjection projection;
  projection.Set(view.WorldToClip.data(), view.Width, view.Height,
    convention == vtkNBufferDepthConvention::Forward ? 0x1p-24 : 0.0, convention);
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
  camera->SetPosition(view.Position.data());
  camera->SetFocalPoint(view.Position[0] + view.Direction[0], view.Position[1] + view.Direction[1],
    view.Position[2] + view.Direction[2]);
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
       << " near " << view.Near << " far " << view.Far << " at";
  for (double x : view.Position)
  {
    text << " " << x;
  }
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

std::vector<std::array<double, 3>> ViewSampler::MakePoints(
  const std::array<double, 6>& bounds, int count)
{
  std::vector<std::array<double, 3>> points;
  for (int corner = 0; corner < 8; ++corner)
  {
    points.push_back(
      { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)] });
  }
  for (int n = 0; n < count; ++n)
  {
    std::array<double, 3> point{};
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

double View::ToStored(double windowDepth, vtkNBufferDepthConvention convention) const
{
  switch (convention)
  {
    case vtkNBufferDepthConvention::Forward:
      break;
    case vtkNBufferDepthConvention::Reversed:
      return 1.0 - windowDepth;
    case vtkNBufferDepthConvention::InverseW:
      // 1 / w is linear in window depth.
      return 1.0 - windowDepth * (1.0 - this->Near / this->Far);
  }
  return windowDepth;
}

namespace
{
using Matrix = std::array<double, 16>;

/// The matrix that a renderer uploads. The third row gives the depth that it stores times w, but
/// for Forward NDC z times w.
Matrix GetMatrix(const View& view, vtkNBufferDepthConvention convention)
{
  Matrix matrix = view.WorldToClip;
  for (int j = 0; j < 4; ++j)
  {
    if (convention == vtkNBufferDepthConvention::Reversed)
    {
      matrix[8 + j] = 0.5 * (matrix[12 + j] - matrix[8 + j]);
    }
    else if (convention == vtkNBufferDepthConvention::InverseW)
    {
      matrix[8 + j] = j == 3 ? view.Near : 0.0;
    }
  }
  return matrix;
}

template <typename Real>
std::optional<ScreenPoint> ToScreen(
  const View& view, const Real clip[4], vtkNBufferDepthConvention convention)
{
  if (!(clip[3] > 0))
  {
    return {};
  }
  // Where the third one ends: at the near plane for Forward, at the far plane for the others.
  const Real end = convention == vtkNBufferDepthConvention::Forward ? -clip[3]
    : convention == vtkNBufferDepthConvention::Reversed
    ? 0
    : clip[3] * static_cast<Real>(view.Near / view.Far);
  for (int i = 0; i < 3; ++i)
  {
    if (clip[i] < (i < 2 ? -clip[3] : end) || clip[i] > clip[3])
    {
      return {};
    }
  }
  const Real half = static_cast<Real>(0.5);
  const Real depth = clip[2] / clip[3];
  return ScreenPoint{ static_cast<double>((clip[0] / clip[3] * half + half) * view.Width),
    static_cast<double>((clip[1] / clip[3] * half + half) * view.Height),
    static_cast<double>(
      convention == vtkNBufferDepthConvention::Forward ? depth * half + half : depth) };
}
}

std::optional<ScreenPoint> ProjectExactly(
  const View& view, const std::array<double, 3>& point, vtkNBufferDepthConvention convention)
{
  const Matrix matrix = GetMatrix(view, convention);
  long double clip[4];
  for (int i = 0; i < 4; ++i)
  {
    clip[i] = matrix[4 * i + 3];
    for (int j = 0; j < 3; ++j)
    {
      clip[i] += static_cast<long double>(matrix[4 * i + j]) * point[j];
    }
  }
  return ToScreen(view, clip, convention);
}

std::optional<ScreenPoint> ProjectAsDevice(const View& view, const std::array<double, 3>& point,
  int permutation, vtkNBufferDepthConvention convention)
{
  const Matrix matrix = GetMatrix(view, convention);
  float clip[4];
  for (int i = 0; i < 4; ++i)
  {
    float terms[4];
    for (int j = 0; j < 4; ++j)
    {
      terms[j] =
        static_cast<float>(matrix[4 * i + j]) * (j < 3 ? static_cast<float>(point[j]) : 1.0f);
    }
    std::swap(terms[0], terms[permutation]);
    clip[i] = terms[0];
    for (int j = 1; j < 4; ++j)
    {
      clip[i] += terms[j];
    }
  }
  return ToScreen(view, clip, convention);
}

std::optional<std::array<double, 2>> GetDepthsAlongRay(
  const View& view, const std::array<double, 6>& bounds, double x, double y)
{
  double inverse[16];
  vtkMatrix4x4::Invert(view.WorldToClip.data(), inverse);
  const auto unproject = [&](double z, long double out[3])
  {
    const long double ndc[4] = { 2.0L * x / view.Width - 1.0L, 2.0L * y / view.Height - 1.0L,
      2.0L * z - 1.0L, 1.0L };
    long double world[4];
    for (int i = 0; i < 4; ++i)
    {
      world[i] = 0.0L;
      for (int j = 0; j < 4; ++j)
      {
        world[i] += static_cast<long double>(inverse[4 * i + j]) * ndc[j];
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      out[i] = world[i] / world[3];
    }
  };
  long double from[3];
  long double to[3];
  unproject(0.0, from);
  unproject(1.0, to);
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
  std::array<double, 2> depths{};
  for (int n = 0; n < 2; ++n)
  {
    const long double t = n == 0 ? enter : leave;
    const std::array<double, 3> point = { static_cast<double>(from[0] + t * (to[0] - from[0])),
      static_cast<double>(from[1] + t * (to[1] - from[1])),
      static_cast<double>(from[2] + t * (to[2] - from[2])) };
    long double z = view.WorldToClip[11];
    long double w = view.WorldToClip[15];
    for (int j = 0; j < 3; ++j)
    {
      z += static_cast<long double>(view.WorldToClip[8 + j]) * point[j];
      w += static_cast<long double>(view.WorldToClip[12 + j]) * point[j];
    }
    depths[n] = static_cast<double>(0.5L * z / w + 0.5L);
  }
  return depths;
}

std::string GetText(const std::array<double, 6>& bounds)
{
  std::ostringstream text;
  text.precision(17);
  text << "box";
  for (double bound : bounds)
  {
    text << " " << bound;
  }
  return text.str();
}
