// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StreetPath.h"

#include "StreetPlan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
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
constexpr double Pi = 3.14159265358979323846;

CameraPose MakePose(
  const PlanPoint& eye, double height, double headingX, double headingY, double pitch)
{
  CameraPose pose;
  const double length = std::hypot(headingX, headingY);
  const double down = std::tan(pitch * Pi / 180.0);
  pose.Eye[0] = eye.X;
  pose.Eye[1] = eye.Y;
  pose.Eye[2] = height;
  pose.Target[0] = eye.X + headingX / length;
  pose.Target[1] = eye.Y + headingY / length;
  pose.Target[2] = height + down;
  pose.Up[0] = pose.Up[1] = 0.0;
  pose.Up[2] = 1.0;
  pose.ViewAngle = ViewAngle;
  pose.Near = Near;
  pose.Far = Far;
  return pose;
}

/// A way of points that is asked for its point at any length.
class Way
{
public:
  explicit Way(std::vector<PlanPoint> points)
    : Points(std::move(points))
  {
    this->Lengths.push_back(0.0);
    for (std::size_t i = 1; i < this->Points.size(); ++i)
    {
      this->Lengths.push_back(this->Lengths.back() +
        std::hypot(
          this->Points[i].X - this->Points[i - 1].X, this->Points[i].Y - this->Points[i - 1].Y));
    }
  }

  PlanPoint operator()(double length) const
  {
    const double s = std::clamp(length, 0.0, this->Lengths.back());
    const auto upper = std::upper_bound(this->Lengths.begin() + 1, this->Lengths.end() - 1, s);
    const auto i = static_cast<std::size_t>(upper - this->Lengths.begin());
    const double span = this->Lengths[i] - this->Lengths[i - 1];
    const double t = span > 0.0 ? (s - this->Lengths[i - 1]) / span : 0.0;
    return { this->Points[i - 1].X + t * (this->Points[i].X - this->Points[i - 1].X),
      this->Points[i - 1].Y + t * (this->Points[i].Y - this->Points[i - 1].Y) };
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
    const PlanPoint ahead = way(s + LookAhead);
    const PlanPoint behind = way(s - LookBack);
    path.push_back(MakePose(way(s), height, ahead.X - behind.X, ahead.Y - behind.Y, pitch));
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
  const double heading = random.Between(0.0, 2.0 * Pi);
  CameraPath path;
  for (int i = 0; i < frames; ++i)
  {
    const double s = DroneStep * (i - 0.5 * frames);
    path.push_back(MakePose({ middle.X + s * std::cos(heading), middle.Y + s * std::sin(heading) },
      DroneHeight, std::cos(heading), std::sin(heading), DronePitch));
  }
  return path;
}

CameraPath MakeCuts(const StreetPlan& plan, int frames, Random& random)
{
  std::vector<PlanPoint> points = plan.GetDensePoints(0.25);
  points.erase(std::remove_if(points.begin(), points.end(),
                 [&plan](const PlanPoint& point) { return plan.IsBuiltOver(point, 0.45); }),
    points.end());
  if (points.empty())
  {
    throw std::runtime_error("the city has no street corner outside of its buildings");
  }
  CameraPath path;
  for (int i = 0; i < frames; ++i)
  {
    const PlanPoint& eye = points[random.Index(points.size())];
    const double heading = random.Between(0.0, 2.0 * Pi);
    path.push_back(MakePose(eye, EyeHeight, std::cos(heading), std::sin(heading), 0.0));
  }
  return path;
}
}

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
  return MakeCuts(plan, frames, random);
}

} // namespace NBufferExamples
