// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayOracle.h"

#include "ThinSides.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace
{
constexpr double Jitter = 1.0 / 64.0; // pixels
/// The sine of the angle between planes (6 degrees) from which on an edge is a sharp one.
constexpr double SharpEdge = 0.1;
/// Of a unit normal.
constexpr double PlaneRounding = 1e-6;
/// Window depth: two units of 24 bits for the receiver, two for the volume.
constexpr double DepthSteps = 4.0 / (1 << 24);
/// Pixels: two steps of a subpixel grid of 8 bits.
constexpr double GridSteps = 2.0 / 256;
constexpr double TerminatorMargin = 1e-4;
constexpr double ConeMargin = 1e-6;
}

Oracle::Oracle(vtkRenderer* renderer, const std::function<bool(vtkProp*)>& isCaster)
  : Triangles(CollectRenderedTriangles(renderer))
{
  this->SetView(renderer);
  for (const RenderedActor& actor : this->Triangles.Actors)
  {
    this->Casts.push_back(!isCaster || isCaster(actor.Prop));
  }
  double low[3] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double high[3] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  double largest = 0.0;
  const std::vector<double>& corners = this->Triangles.Corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    low[i % 3] = std::min(low[i % 3], corners[i]);
    high[i % 3] = std::max(high[i % 3], corners[i]);
    largest = std::max(largest, std::abs(corners[i]));
  }
  if (!corners.empty())
  {
    // The second term is the rounding of a computed point far from the origin.
    this->Tolerance =
      1e-9 * std::sqrt(vtkMath::Distance2BetweenPoints(low, high)) + 1e-14 * largest;
  }
  this->Tree.Build(corners);
  this->FindClipped();
}

void Oracle::SetView(vtkRenderer* renderer)
{
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&this->Width, &this->Height, &origin[0], &origin[1]);
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);
  std::copy_n(projection->GetData(), 16, &this->Projection[0][0]);
  const double* worldToView = camera->GetModelViewTransformMatrix()->GetData();
  vtkMatrix4x4::Multiply4x4(projection->GetData(), worldToView, &this->WorldToClip[0][0]);
  vtkMatrix4x4::Invert(worldToView, &this->ViewToWorld[0][0]);
}

void Oracle::SetSample(double x, double y)
{
  this->Sample[0] = x;
  this->Sample[1] = y;
}

Ray Oracle::GetEyeRay(int x, int y, double jitterX, double jitterY) const
{
  // The points that are drawn at (ndcX, ndcY) are where two planes meet in view coordinates:
  // clip x - ndcX clip w = 0, clip y - ndcY clip w = 0.
  const double ndcX = 2.0 * (x + this->Sample[0] + jitterX) / this->Width - 1.0;
  const double ndcY = 2.0 * (y + this->Sample[1] + jitterY) / this->Height - 1.0;
  double a[4];
  double b[4];
  double nearPlane[4]; // clip z + clip w >= 0 is drawn
  double farPlane[4];  // clip w - clip z >= 0 is drawn
  for (int j = 0; j < 4; ++j)
  {
    const double w = this->Projection[3][j];
    a[j] = this->Projection[0][j] - ndcX * w;
    b[j] = this->Projection[1][j] - ndcY * w;
    nearPlane[j] = w + this->Projection[2][j];
    farPlane[j] = w - this->Projection[2][j];
  }
  double direction[3];
  vtkMath::Cross(a, b, direction);
  vtkMath::Normalize(direction);
  if (vtkMath::Dot(direction, nearPlane) < 0.0)
  {
    vtkMath::MultiplyScalar(direction, -1.0);
  }
  // The point of the line that is nearest to the view's origin: the eye itself in perspective.
  double normal[3];
  double bxd[3];
  double dxa[3];
  double origin[3];
  vtkMath::Cross(a, b, normal);
  vtkMath::Cross(b, normal, bxd);
  vtkMath::Cross(normal, a, dxa);
  for (int i = 0; i < 3; ++i)
  {
    origin[i] = -(a[3] * bxd[i] + b[3] * dxa[i]) / vtkMath::Dot(normal, normal);
  }
  Ray ray;
  ray.Near = -(vtkMath::Dot(origin, nearPlane) + nearPlane[3]) / vtkMath::Dot(direction, nearPlane);
  ray.Far = -(vtkMath::Dot(origin, farPlane) + farPlane[3]) / vtkMath::Dot(direction, farPlane);
  for (int i = 0; i < 3; ++i)
  {
    const double* row = this->ViewToWorld[i];
    ray.Origin[i] = vtkMath::Dot(row, origin) + row[3];
    ray.Direction[i] = vtkMath::Dot(row, direction);
  }
  return ray;
}

bool Oracle::GetReceiver(int x, int y, double jitterX, double jitterY, Receiver& receiver) const
{
  const Ray ray = this->GetEyeRay(x, y, jitterX, jitterY);
  const TriangleTree::Hit hit = this->Tree.FindNearest(ray);
  receiver.Triangle = hit.Triangle;
  if (hit.Triangle < 0)
  {
    return false;
  }
  const double* corners = &this->Triangles.Corners[9 * static_cast<std::size_t>(hit.Triangle)];
  const glm::dvec3 a = glm::make_vec3(corners);
  const glm::dvec3 direction = glm::make_vec3(ray.Direction);
  const glm::dvec3 normal =
    glm::normalize(glm::cross(glm::make_vec3(corners + 3) - a, glm::make_vec3(corners + 6) - a));
  const glm::dvec3 towardsEye = glm::dot(normal, direction) > 0.0 ? -normal : normal;
  const glm::dvec3 position = glm::make_vec3(ray.Origin) + hit.T * direction;
  std::copy_n(glm::value_ptr(towardsEye), 3, receiver.Normal);
  std::copy_n(glm::value_ptr(position), 3, receiver.Position);
  return true;
}

Ray Oracle::GetShadowRay(const Receiver& receiver, const OracleLight& light) const
{
  Ray ray;
  std::copy_n(receiver.Position, 3, ray.Origin);
  light.GetDirectionTo(receiver.Position, ray.Direction);
  ray.Near = this->Tolerance;
  if (light.Positional)
  {
    ray.Far = std::sqrt(vtkMath::Distance2BetweenPoints(receiver.Position, light.Position)) -
      this->Tolerance;
  }
  return ray;
}

bool Oracle::IsShadowed(const Receiver& receiver, const OracleLight& light) const
{
  bool lit = true;
  this->VisitCasters(receiver, light, [&lit](int, double) { return lit = false; });
  return !lit;
}

int Oracle::CountCrossings(const Receiver& receiver, const OracleLight& light) const
{
  int count = 0;
  this->VisitCasters(receiver, light, [&](int, double) { return ++count > 0; });
  return count;
}

Oracle::Classification Oracle::Classify(
  int x, int y, double jitterX, double jitterY, const OracleLight& light) const
{
  Classification result;
  Receiver receiver;
  if (!this->GetReceiver(x, y, jitterX, jitterY, receiver))
  {
    return result;
  }
  double toLight[3];
  light.GetDirectionTo(receiver.Position, toLight);
  const double cosine = vtkMath::Dot(receiver.Normal, toLight);
  const double fromAxis = -vtkMath::Dot(toLight, light.Direction);
  result.Marginal =
    std::abs(cosine) < TerminatorMargin || std::abs(fromAxis - light.ConeCosine) < ConeMargin;
  if (cosine <= 0.0 || fromAxis < light.ConeCosine)
  {
    result.Sample = OracleSample::Unlit;
  }
  else
  {
    result.Sample = this->IsShadowed(receiver, light) ? OracleSample::Shadowed : OracleSample::Lit;
  }
  return result;
}

bool Oracle::IsStep(const Receiver& a, const Receiver& b) const
{
  double step[3];
  double cross[3];
  vtkMath::Subtract(b.Position, a.Position, step);
  vtkMath::Cross(a.Normal, b.Normal, cross);
  const double length = vtkMath::Norm(step);
  const double off =
    std::max(std::abs(vtkMath::Dot(step, a.Normal)), std::abs(vtkMath::Dot(step, b.Normal)));
  return off > SharpEdge * length ||
    off > (vtkMath::Norm(cross) + PlaneRounding) * length + this->Tolerance;
}

bool Oracle::IsAmbiguous(int x, int y, const OracleLight& light) const
{
  return this->IsAmbiguous(x, y, light, this->Classify(x, y, 0.0, 0.0, light));
}

bool Oracle::IsAmbiguous(int x, int y, const OracleLight& light, const Classification& centre) const
{
  Receiver receiver;
  const bool isHit = this->GetReceiver(x, y, 0.0, 0.0, receiver);
  if (centre.Marginal ||
    (isHit && this->GetWindowDepth(receiver.Position) > 1.0 - DepthSteps / 4.0))
  {
    return true;
  }
  for (const double jitterX : { -Jitter, Jitter })
  {
    for (const double jitterY : { -Jitter, Jitter })
    {
      Receiver beside;
      if (this->Classify(x, y, jitterX, jitterY, light).Sample != centre.Sample ||
        (this->GetReceiver(x, y, jitterX, jitterY, beside) && this->IsStep(receiver, beside)))
      {
        return true;
      }
    }
  }
  return (centre.Sample == OracleSample::Lit || centre.Sample == OracleSample::Shadowed) &&
    this->DependsOnRounding(x, y, receiver, light);
}

std::set<int> Oracle::GetCrossed(const Receiver& receiver, const OracleLight& light) const
{
  std::set<int> owners;
  this->VisitCasters(receiver, light,
    [&](int owner, double)
    {
      owners.insert(owner);
      return true;
    });
  return owners;
}

bool Oracle::DependsOnRounding(
  int x, int y, const Receiver& receiver, const OracleLight& light) const
{
  const std::set<int> crossed = this->GetCrossed(receiver, light);
  Ray ray = this->GetEyeRay(x, y);
  const glm::dvec3 position = glm::make_vec3(receiver.Position);
  const glm::dvec3 eye = glm::make_vec3(ray.Origin);
  const double distance = glm::distance(position, eye);
  // Steps of depth along the eye ray, as many again where a volume is pushed away from a surface:
  // by how much the depth changes over a part of it.
  const glm::dvec3 part = 1e-3 * distance * glm::make_vec3(ray.Direction);
  const double change = this->GetWindowDepth(glm::value_ptr(position + part)) -
    this->GetWindowDepth(glm::value_ptr(position - part));
  const glm::dvec3 step = 2.0 * part / change;
  const double bound = this->GetDepthBound(x, y, receiver.Triangle);
  std::vector<glm::dvec3> offs = { step * (DepthSteps + bound), step * (2.0 * DepthSteps + bound) };

  // Triangles that close to the receiver on the eye ray are caps that may be drawn before or behind
  // it.
  ray.Near = distance - glm::length(offs[1]);
  ray.Far = distance + glm::length(offs[1]);
  bool cap = false;
  this->Tree.VisitCrossings(ray,
    [&](int triangle, double t)
    {
      cap =
        std::abs(t - distance) > this->Tolerance && this->Casts[this->Triangles.Owners[triangle]];
      return !cap;
    });
  if (cap)
  {
    return true;
  }

  // On the way there, too: what is thinner must not be missed.
  for (double less = 0.5 * (DepthSteps + bound); less > 0.125 * DepthSteps; less *= 0.5)
  {
    offs.push_back(step * less);
  }
  // Two steps of the subpixel grid beside it, where its depth may be off as well.
  for (const Ray& beside :
    { this->GetEyeRay(x, y, GridSteps), this->GetEyeRay(x, y, 0.0, GridSteps) })
  {
    const glm::dvec3 place =
      glm::make_vec3(beside.Origin) + distance * glm::make_vec3(beside.Direction);
    const double deeper =
      this->GetWindowDepth(glm::value_ptr(place)) - this->GetWindowDepth(receiver.Position);
    for (const double depth : { -DepthSteps, DepthSteps })
    {
      offs.push_back(place - position + step * (depth - deeper));
    }
  }
  double toLight[3];
  light.GetDirectionTo(receiver.Position, toLight);
  const glm::dvec3 normal = glm::make_vec3(receiver.Normal);
  const double cosine = glm::dot(normal, glm::make_vec3(toLight));
  for (const glm::dvec3& off : offs)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      // Back to the surface along the light's ray: a volume's sides follow it.
      const double back = -glm::dot(off, normal) / cosine;
      const glm::dvec3 place = position + sign * (off + back * glm::make_vec3(toLight));
      Receiver moved = receiver;
      std::copy_n(glm::value_ptr(place), 3, moved.Position);
      // By which actors, not only whether: what has left one shadow may be below a floor.
      if (this->GetCrossed(moved, light) != crossed)
      {
        return true;
      }
    }
  }
  return false;
}

double Oracle::GetWindowDepth(const double world[3]) const
{
  const double* z = this->WorldToClip[2];
  const double* w = this->WorldToClip[3];
  return 0.5 + 0.5 * (vtkMath::Dot(z, world) + z[3]) / (vtkMath::Dot(w, world) + w[3]);
}

double Oracle::GetDepthBound(int x, int y, int triangle) const
{
  const auto polygon = this->Clipped.find(triangle);
  return polygon == this->Clipped.end() ? 0.0 : polygon->second.GetBound(x + 0.5, y + 0.5);
}

void Oracle::FindClipped()
{
  for (std::size_t triangle = 0; triangle < this->Triangles.Owners.size(); ++triangle)
  {
    // Relative to the triangle's middle: VTK moves coordinates that are large for the size of what
    // they belong to.
    const double* points = &this->Triangles.Corners[9 * triangle];
    double middle[3];
    double middleToClip[4][4];
    for (int i = 0; i < 3; ++i)
    {
      middle[i] = (points[i] + points[3 + i] + points[6 + i]) / 3.0;
    }
    for (int i = 0; i < 4; ++i)
    {
      std::copy_n(this->WorldToClip[i], 3, middleToClip[i]);
      middleToClip[i][3] = vtkMath::Dot(this->WorldToClip[i], middle) + this->WorldToClip[i][3];
    }
    std::vector<DrawnPolygon::Corner> corners;
    bool clipped = false;
    for (int k = 0; k < 3; ++k)
    {
      double x[3];
      vtkMath::Subtract(points + 3 * k, middle, x);
      corners.push_back(DrawnPolygon::Transform(middleToClip, x));
      const std::array<double, 4>& clip = corners.back().Clip;
      for (int i = 0; i < 3; ++i)
      {
        clipped = clipped || std::abs(clip[i]) > clip[3];
      }
    }
    if (clipped)
    {
      DrawnPolygon polygon(corners, DrawnPolygon::Planes::NearAndFar, this->Width, this->Height);
      if (polygon.IsVisible())
      {
        this->Clipped.emplace(static_cast<int>(triangle), std::move(polygon));
      }
    }
  }
}

OracleImage Oracle::Cast(const OracleLight& light) const
{
  OracleImage image;
  image.Width = this->Width;
  image.Height = this->Height;
  const std::size_t size = static_cast<std::size_t>(this->Width) * this->Height;
  image.Samples.resize(size);
  image.Ambiguous.resize(size);
  ThinSides::View view;
  for (int i = 0; i < 3; ++i)
  {
    view.Eye[i] = this->ViewToWorld[i][3];
  }
  for (int i = 0; i < 4; ++i)
  {
    const double* m = this->WorldToClip[i];
    std::copy_n(m, 3, view.EyeToClip[i]);
    view.EyeToClip[i][3] = vtkMath::Dot(m, view.Eye) + m[3];
  }
  view.Width = this->Width;
  view.Height = this->Height;
  const ThinSides sides(this->Triangles, this->Casts, light, view);
  vtkSMPTools::For(0, this->Height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int y = static_cast<int>(begin); y < end; ++y)
      {
        for (int x = 0; x < this->Width; ++x)
        {
          const std::size_t i = static_cast<std::size_t>(y) * this->Width + x;
          const Classification centre = this->Classify(x, y, 0.0, 0.0, light);
          image.Samples[i] = centre.Sample;
          image.Ambiguous[i] = this->IsAmbiguous(x, y, light, centre);
          Receiver receiver;
          if (!image.Ambiguous[i] && this->GetReceiver(x, y, 0.0, 0.0, receiver))
          {
            image.Ambiguous[i] = sides.AreNear(x, y, this->GetWindowDepth(receiver.Position),
              DepthSteps + this->GetDepthBound(x, y, receiver.Triangle));
          }
        }
      }
    });
  return image;
}

OracleImage Cast(vtkRenderer* renderer, vtkLight* light)
{
  return Oracle(renderer).Cast(OracleLight(light));
}
