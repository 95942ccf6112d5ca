// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GpuTestNBufferPrecisionTriangles.h
 * @brief Random triangles before random cameras, and their exact depth to judge what was drawn.
 */
#ifndef GpuTestNBufferPrecisionTriangles_h
#define GpuTestNBufferPrecisionTriangles_h

#include "vtkNBufferProjection.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

constexpr int Width = 640;
constexpr int Height = 480;
constexpr double LowestHeight = 1.0 / 16; // t of vtkNBufferProjection.h, in pixels

struct CameraCase
{
  const char* Name;
  double Near;
  double Far;
  bool Parallel;
  double Offset;  ///< Of the scene from the world's origin.
  bool IsShifted; ///< Whether the vertex buffer holds coordinates relative to the scene.
};

enum class Kind
{
  Facing,   ///< One depth: quanta and rounding.
  Slanted,  ///< Any depth, 2 to 200 pixels.
  SubPixel, ///< Of less than two pixels, around the middle of one.
  Steep,    ///< Seen edge-on: 1/16 pixel high and more, deep across.
  Sliver,   ///< As steep ones, but lower, down to nothing, and of any depths.
  Behind,   ///< Reaching behind the eye and out of the view.
};

using Point = std::array<double, 3>;
using Triangle = std::array<Point, 3>;

/// Pixels and window depth of a vertex.
struct ScreenVertex
{
  double X;
  double Y;
  double Z;
};

template <typename Real>
ScreenVertex ToScreen(const Real matrix[16], const Real point[3])
{
  double clip[4];
  for (int i = 0; i < 4; ++i)
  {
    clip[i] = matrix[4 * i + 3];
    for (int j = 0; j < 3; ++j)
    {
      clip[i] += static_cast<double>(matrix[4 * i + j]) * point[j];
    }
  }
  return { (0.5 * clip[0] / clip[3] + 0.5) * Width, (0.5 * clip[1] / clip[3] + 0.5) * Height,
    0.5 * clip[2] / clip[3] + 0.5 };
}

/// The smallest height, in pixels.
double GetHeight(const ScreenVertex v[3]);

/// What was found of one kind under one camera.
struct Finding
{
  long long Fragments = 0;
  long long Nearer = 0; ///< Fragments nearer than their triangle's exact nearest depth.
  double Outside = 0.0; ///< Largest distance from the triangle's exact depth range,
  double Slack = 0.0;   ///< what was granted there,
  double Largest = 0.0; ///< and the largest ratio of the two.
  double OfPlane = 0.0; ///< The same ratio for the distance from the exact plane.

  void AddOutside(double outside, double slack)
  {
    if (outside > this->Largest * slack)
    {
      this->Outside = outside;
      this->Slack = slack;
      this->Largest = outside / slack;
    }
  }
};

class Sampler
{
public:
  Sampler(const CameraCase& camera, unsigned int seed)
    : Case(camera)
    , Random(seed)
  {
    // Along an axis, so that a triangle has the depth range of its bounds.
    this->Camera->SetPosition(camera.Offset, camera.Offset, 0.0);
    this->Camera->SetFocalPoint(camera.Offset, camera.Offset, -1.0);
    this->Camera->SetParallelProjection(camera.Parallel);
    this->Camera->SetParallelScale(0.01 * camera.Far);
    this->Camera->SetClippingRange(camera.Near, camera.Far);
    const vtkMatrix4x4* matrix = this->Camera->GetCompositeProjectionTransformMatrix(
      static_cast<double>(Width) / Height, -1.0, 1.0);
    std::copy_n(matrix->GetData(), 16, this->WorldToClip.begin());
    vtkMatrix4x4::Invert(this->WorldToClip.data(), this->ClipToWorld.data());
  }

  double Uniform(double a, double b)
  {
    return std::uniform_real_distribution<double>(a, b)(this->Random);
  }
  double Logarithmic(double a, double b) { return std::exp(Uniform(std::log(a), std::log(b))); }

  vtkCamera* GetCamera() const { return this->Camera; }
  const double* GetWorldToClip() const { return this->WorldToClip.data(); }
  double GetShift(int axis) const
  {
    return this->Case.IsShifted && axis < 2 ? this->Case.Offset : 0.0;
  }

  /// In world coordinates.
  Triangle Make(Kind kind);

private:
  /// The worst for the plane: as low as is covered, as deep as can be across, and with a long edge
  /// through the middles of pixels, or beside them by less than snapping can make up for.
  Triangle MakeSteep();
  Triangle MakeSliver();

  /// Of the ground, a wall or the ceiling around the eye, on beyond and behind it.
  Triangle MakeGround();

  Point ToWorld(double x, double y, double z) const
  {
    const double ndc[4] = { 2.0 * x / Width - 1.0, 2.0 * y / Height - 1.0, z, 1.0 };
    double world[4];
    vtkMatrix4x4::MultiplyPoint(this->ClipToWorld.data(), ndc, world);
    return { world[0] / world[3], world[1] / world[3], world[2] / world[3] };
  }

  const CameraCase& Case;
  std::mt19937 Random;
  vtkNew<vtkCamera> Camera;
  std::array<double, 16> WorldToClip{};
  std::array<double, 16> ClipToWorld{};
};

/// Compares the depth of a rectangle with a triangle of which it is the only trace.
class Judge
{
public:
  Judge(const double* worldToClip, const Triangle& triangle, bool isBehind);

  void Compare(const vtkNBufferScreenBox& screen, int x0, int y0, int width,
    const std::vector<float>& depth, Finding& finding) const;

private:
  ScreenVertex Vertices[3];
  bool IsBehind;
  double Nearest = 2.0;
  double Farthest = -1.0;
  double SlopeX;
  double SlopeY;
};

/// The box that a candidate with this triangle has.
vtkNBufferBox BoundTriangle(const Triangle& triangle, const Sampler& sampler);

#endif
