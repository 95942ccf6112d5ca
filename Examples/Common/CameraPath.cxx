// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CameraPath.h"

#include "Random.h"
#include "Scene.h"
#include "StreetPath.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

struct Frame
{
  double Centre[3];
  double Radius;
  int Up, Ahead, Side;
};

Frame GetFrame(const Scene& scene)
{
  Frame frame;
  const vtkBoundingBox box = scene.GetBounds();
  box.GetCenter(frame.Centre);
  frame.Radius = 0.5 * box.GetDiagonalLength();
  frame.Up = scene.UpAxis;
  frame.Ahead = (frame.Up + 1) % 3;
  frame.Side = (frame.Up + 2) % 3;
  return frame;
}

/// Looking at the centre (or past it) from a direction given by azimuth and elevation.
CameraPose LookFrom(const Frame& frame, double azimuth, double elevation, double distance)
{
  CameraPose pose;
  double direction[3];
  direction[frame.Up] = std::sin(elevation);
  direction[frame.Ahead] = std::cos(elevation) * std::cos(azimuth);
  direction[frame.Side] = std::cos(elevation) * std::sin(azimuth);
  for (int i = 0; i < 3; ++i)
  {
    pose.Eye[i] = frame.Centre[i] + distance * direction[i];
    pose.Target[i] = frame.Centre[i];
    pose.Up[i] = i == frame.Up ? 1.0 : 0.0;
  }
  return pose;
}

/// Radii of the sphere around the scene from which most scenes fill a view of 30 degrees.
constexpr double FittingDistance = 2.9;

CameraPath MakeOrbit(const Scene& scene, int frames)
{
  const Frame frame = GetFrame(scene);
  CameraPath path;
  for (int i = 0; i < frames; ++i)
  {
    path.push_back(LookFrom(frame, 2.0 * Pi * i / frames, 0.35, FittingDistance * frame.Radius));
  }
  return path;
}

CameraPath MakeRandomViews(const Scene& scene, int frames, Random& random)
{
  const Frame frame = GetFrame(scene);
  CameraPath path;
  for (int i = 0; i < frames; ++i)
  {
    const double azimuth = random.Between(0.0, 2.0 * Pi);
    const double elevation = random.Between(-0.2, 1.0);
    path.push_back(
      LookFrom(frame, azimuth, elevation, random.Between(1.2, FittingDistance) * frame.Radius));
  }
  return path;
}

bool IsPathName(const std::string& name)
{
  return name == "street" || name == "rooftop" || name == "drone" || name == "cuts" ||
    name == "orbit";
}
}

void ApplyPose(const CameraPose& pose, const double bounds[6], vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(pose.Eye);
  camera->SetFocalPoint(pose.Target);
  camera->SetViewUp(pose.Up);
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
  if (frames > 0)
  {
    for (const auto& [own, make] : scene.Paths)
    {
      if (own == name)
      {
        return make(frames, seed);
      }
    }
  }
  if (!IsPathName(name))
  {
    if (!std::filesystem::is_regular_file(name))
    {
      std::string known = "street, rooftop, drone, orbit, cuts";
      for (const auto& own : scene.Paths)
      {
        known += ", " + own.first;
      }
      throw std::runtime_error("no path " + name + ": neither " + known + " nor a camera file");
    }
    CameraPath path = ReadCameraFile(name);
    if (frames > 0 && static_cast<std::size_t>(frames) < path.size())
    {
      path.resize(static_cast<std::size_t>(frames));
    }
    return path;
  }
  if (frames <= 0)
  {
    throw std::runtime_error("a path needs at least one frame");
  }
  if (name == "orbit")
  {
    return MakeOrbit(scene, frames);
  }
  if (scene.Plan)
  {
    return MakeCityPath(*scene.Plan, name, frames, seed);
  }
  if (name == "cuts")
  {
    Random random(seed);
    return MakeRandomViews(scene, frames, random);
  }
  throw std::runtime_error("the path " + name + " needs the streets of a city, and " + scene.Name +
    " has none; take orbit, cuts or a camera file");
}

CameraPath ReadCameraFile(const std::string& fileName)
{
  std::ifstream file(fileName);
  if (!file)
  {
    throw std::runtime_error("cannot open " + fileName);
  }
  CameraPath path;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number)
  {
    std::istringstream text(line.substr(0, line.find('#')));
    std::vector<double> v;
    for (double value = 0.0; text >> value;)
    {
      v.push_back(value);
    }
    if (v.empty() && text.eof())
    {
      continue;
    }
    const bool counted = v.size() == 9 || v.size() == 10 || v.size() == 12;
    if (!counted || !text.eof())
    {
      throw std::runtime_error(fileName + ", line " + std::to_string(number) +
        ": expected 9, 10 or 12 numbers (eye, target, up, view angle, near and far)");
    }
    CameraPose pose;
    for (std::size_t i = 0; i < 3; ++i)
    {
      pose.Eye[i] = v[i];
      pose.Target[i] = v[3 + i];
      pose.Up[i] = v[6 + i];
    }
    pose.ViewAngle = v.size() > 9 ? v[9] : pose.ViewAngle;
    pose.Near = v.size() > 10 ? v[10] : 0.0;
    pose.Far = v.size() > 10 ? v[11] : 0.0;
    path.push_back(pose);
  }
  if (path.empty())
  {
    throw std::runtime_error(fileName + " holds no frame");
  }
  return path;
}

void WriteCameraFile(const CameraPath& path, const std::string& fileName)
{
  std::ofstream file(fileName);
  file << std::setprecision(std::numeric_limits<double>::max_digits10)
       << "# eye x y z, target x y z, up x y z, view angle, near, far\n";
  for (const CameraPose& pose : path)
  {
    for (const double* vector : { pose.Eye, pose.Target, pose.Up })
    {
      file << vector[0] << ' ' << vector[1] << ' ' << vector[2] << ' ';
    }
    file << pose.ViewAngle << ' ' << pose.Near << ' ' << pose.Far << '\n';
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

} // namespace NBufferExamples
