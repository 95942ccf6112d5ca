// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraPath.h"

#include "Random.h"
#include "Scene.h"
#include "StreetPlan.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
// The paths of a city.
constexpr double EyeHeight = 1.7;      // metres
constexpr double StreetStep = 0.5;     // metres per frame
constexpr double RooftopHeight = 25.0; // metres
constexpr double RooftopStep = 1.0;    // metres per frame
constexpr double RooftopPitch = -8.0;  // degrees
constexpr double DroneHeight = 120.0;  // metres
constexpr double DroneStep = 2.0;      // metres per frame
constexpr double DronePitch = -35.0;   // degrees
constexpr double LookAhead = 8.0;      // metres of the way over which the heading is averaged
constexpr double LookBack = 3.0;       // metres
constexpr double ViewAngle = 60.0;     // degrees
constexpr double Near = 0.3;           // metres
constexpr double Far = 30000.0;        // metres

/// A pose that looks at the centre of a scene from a direction given by azimuth and elevation
/// (radians); the distance is in radii of the sphere around the scene.
CameraPose LookFrom(const Scene& scene, double azimuth, double elevation, double radii)
{
  const vtkBoundingBox box = scene.GetBounds();
  const int up = scene.UpAxis;
  glm::dvec3 direction;
  direction[up] = std::sin(elevation);
  direction[(up + 1) % 3] = std::cos(elevation) * std::cos(azimuth);
  direction[(up + 2) % 3] = std::cos(elevation) * std::sin(azimuth);
  CameraPose pose;
  box.GetCenter(glm::value_ptr(pose.Target));
  pose.Eye = pose.Target + radii * (0.5 * box.GetDiagonalLength()) * direction;
  pose.Up = glm::dvec3();
  pose.Up[up] = 1.0;
  return pose;
}

/// The distance, in radii, from which most scenes fill a view of 30 degrees.
constexpr double FittingDistance = 2.9;

CameraPath MakeOrbit(const Scene& scene, int frames)
{
  CameraPath path;
  for (int i = 0; i < frames; ++i)
  {
    path.push_back(LookFrom(scene, 2.0 * vtkMath::Pi() * i / frames, 0.35, FittingDistance));
  }
  return path;
}

CameraPath MakeRandomViews(const Scene& scene, int frames, std::uint64_t seed)
{
  Random random(seed);
  CameraPath path;
  for (int i = 0; i < frames; ++i)
  {
    const double azimuth = random.Between(0.0, 2.0 * vtkMath::Pi());
    const double elevation = random.Between(-0.2, 1.0);
    path.push_back(LookFrom(scene, azimuth, elevation, random.Between(1.2, FittingDistance)));
  }
  return path;
}

CameraPath MakeAside(const Scene& scene, int frames)
{
  constexpr std::size_t inView = 5;
  const double diagonal = scene.GetBounds().GetDiagonalLength();
  CameraPath path;
  for (int i = 0; i < frames; ++i)
  {
    // The offset keeps the camera from looking along a row of copies, which all reach equally far.
    CameraPose pose = LookFrom(scene, 2.0 * vtkMath::Pi() * (i + 0.35) / frames, 0.0, 1.0);
    const glm::dvec3 outward = glm::normalize(pose.Eye - pose.Target);
    std::vector<glm::dvec3> corners; // The outermost one of each prop.
    for (vtkActor* actor : scene.Actors)
    {
      const double* bounds = actor->GetBounds();
      if (bounds && bounds[0] <= bounds[1])
      {
        corners.emplace_back(bounds[outward.x >= 0.0 ? 1 : 0], bounds[outward.y >= 0.0 ? 3 : 2],
          bounds[outward.z >= 0.0 ? 5 : 4]);
      }
    }
    const std::size_t last = std::min(inView, corners.size() - 1);
    std::partial_sort(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(last + 1),
      corners.end(),
      [&outward](const glm::dvec3& a, const glm::dvec3& b)
      { return glm::dot(a, outward) > glm::dot(b, outward); });
    // Behind a prop that is in view, and no farther in than the first one that is not.
    const glm::dvec3& ahead = corners[last / 2];
    pose.Eye = ahead - glm::dot(ahead - corners[last], outward) * outward;
    pose.Target = pose.Eye + outward;
    pose.Near = 1e-5 * diagonal;
    pose.Far = diagonal;
    path.push_back(pose);
  }
  return path;
}

/// A pose above a point of the plan; `pitch` in degrees.
CameraPose MakePose(const PlanPoint& eye, double height, const PlanPoint& heading, double pitch)
{
  const PlanPoint target = eye + heading / std::hypot(heading.x, heading.y);
  return { { eye, height }, { target, height + std::tan(pitch * vtkMath::Pi() / 180.0) },
    { 0.0, 0.0, 1.0 }, ViewAngle, Near, Far };
}

/// The direction of an angle in radians.
PlanPoint GetHeading(double angle)
{
  return { std::cos(angle), std::sin(angle) };
}

/// A line through points, which gives the point at any length along it.
class Way
{
public:
  explicit Way(std::vector<PlanPoint> points)
    : Points(std::move(points))
  {
    this->Lengths.push_back(0.0);
    for (std::size_t i = 1; i < this->Points.size(); ++i)
    {
      this->Lengths.push_back(
        this->Lengths.back() + GetDistance(this->Points[i - 1], this->Points[i]));
    }
  }

  PlanPoint operator()(double length) const
  {
    const double s = std::clamp(length, 0.0, this->Lengths.back());
    const auto upper = std::upper_bound(this->Lengths.begin() + 1, this->Lengths.end() - 1, s);
    const auto i = static_cast<std::size_t>(upper - this->Lengths.begin());
    const double span = this->Lengths[i] - this->Lengths[i - 1];
    const double t = span > 0.0 ? (s - this->Lengths[i - 1]) / span : 0.0;
    return this->Points[i - 1] + t * (this->Points[i] - this->Points[i - 1]);
  }

private:
  std::vector<PlanPoint> Points;
  std::vector<double> Lengths;
};

CameraPath MakeWalk(
  const StreetPlan& plan, int frames, double step, double height, double pitch, Random& random)
{
  const Way way(plan.Walk(frames * step + LookAhead, random));
  CameraPath path;
  for (int i = 0; i < frames; ++i)
  {
    const double s = i * step;
    path.push_back(MakePose(way(s), height, way(s + LookAhead) - way(s - LookBack), pitch));
  }
  return path;
}

CameraPath MakeFlight(const StreetPlan& plan, int frames, Random& random)
{
  const std::vector<PlanPoint> points = plan.GetDensePoints(0.1);
  if (points.empty())
  {
    throw std::runtime_error("the city has no streets, and the drone flies over their corners");
  }
  const PlanPoint middle = points[random.Index(points.size())];
  const PlanPoint heading = GetHeading(random.Between(0.0, 2.0 * vtkMath::Pi()));
  CameraPath path;
  for (int i = 0; i < frames; ++i)
  {
    const double s = DroneStep * (i - 0.5 * frames);
    path.push_back(MakePose(middle + s * heading, DroneHeight, heading, DronePitch));
  }
  return path;
}

CameraPath MakeCityCuts(const StreetPlan& plan, int frames, Random& random)
{
  std::vector<PlanPoint> points = plan.GetDensePoints(0.25);
  points.erase(std::remove_if(points.begin(), points.end(),
                 [&plan](const PlanPoint& point) { return plan.IsBuiltOver(point); }),
    points.end());
  if (points.empty())
  {
    throw std::runtime_error("the city has no street corner outside of its buildings");
  }
  CameraPath path;
  for (int i = 0; i < frames; ++i)
  {
    const PlanPoint& eye = points[random.Index(points.size())];
    path.push_back(
      MakePose(eye, EyeHeight, GetHeading(random.Between(0.0, 2.0 * vtkMath::Pi())), 0.0));
  }
  return path;
}

/// `name` is street, rooftop, drone or cuts.
CameraPath MakeCityPath(const City& city, const std::string& name, int frames, std::uint64_t seed)
{
  const StreetPlan plan(city);
  Random random(seed);
  if (name == "street")
  {
    return MakeWalk(plan, frames, StreetStep, EyeHeight, 0.0, random);
  }
  if (name == "rooftop")
  {
    return MakeWalk(plan, frames, RooftopStep, RooftopHeight, RooftopPitch, random);
  }
  if (name == "drone")
  {
    return MakeFlight(plan, frames, random);
  }
  return MakeCityCuts(plan, frames, random);
}
}

void ApplyPose(const CameraPose& pose, const double bounds[6], vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(glm::value_ptr(pose.Eye));
  camera->SetFocalPoint(glm::value_ptr(pose.Target));
  camera->SetViewUp(glm::value_ptr(pose.Up));
  camera->SetViewAngle(pose.ViewAngle);
  if (pose.Far > pose.Near)
  {
    camera->SetClippingRange(pose.Near, pose.Far);
  }
  else
  {
    renderer->ResetCameraClippingRange(bounds);
  }
}

CameraPath MakePath(const Scene& scene, const std::string& name, int frames, std::uint64_t seed)
{
  std::string known = "orbit, cuts, aside";
  for (const auto& [own, make] : scene.Paths)
  {
    if (own == name)
    {
      return make(frames, seed);
    }
    known += ", " + own;
  }
  if (name == "orbit")
  {
    return MakeOrbit(scene, frames);
  }
  if (name == "aside")
  {
    return MakeAside(scene, frames);
  }
  if (scene.Plan && (name == "street" || name == "rooftop" || name == "drone" || name == "cuts"))
  {
    return MakeCityPath(*scene.Plan, name, frames, seed);
  }
  if (name == "cuts")
  {
    return MakeRandomViews(scene, frames, seed);
  }
  throw std::runtime_error("no path " + name + " through " + scene.Name + "; there are " + known +
    (scene.Plan ? ", street, rooftop, drone" : ""));
}

std::string GetUsualPath(const Scene& scene)
{
  return scene.Plan ? "street" : !scene.Paths.empty() ? scene.Paths.front().first : "orbit";
}

} // namespace NBufferExamples
