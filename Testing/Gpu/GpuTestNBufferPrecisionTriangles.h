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
#include "vtkNew.h"

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

using Triangle = std::array<glm::dvec3, 3>;

/// Pixels and window depth of a vertex.
glm::dvec3 ToScreen(const glm::dmat4& worldToClip, const glm::dvec3& point);
Triangle ToScreen(const glm::dmat4& worldToClip, const Triangle& triangle);

/// The smallest height, in pixels.
double GetHeight(const Triangle& onScreen);

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
  Sampler(const CameraCase& camera, unsigned int seed);

  double Uniform(double a, double b)
  {
    return std::uniform_real_distribution<double>(a, b)(this->Random);
  }
  double Logarithmic(double a, double b) { return std::exp(Uniform(std::log(a), std::log(b))); }

  vtkCamera* GetCamera() const { return this->Camera; }
  const glm::dmat4& GetWorldToClip() const { return this->WorldToClip; }
  vtkNBufferProjection GetProjection(double quantum = 0x1p-24) const;
  /// Where the vertex buffer has its zero.
  glm::dvec3 GetShift() const
  {
    return this->Case.IsShifted ? glm::dvec3(this->Case.Offset, this->Case.Offset, 0.0)
                                : glm::dvec3(0.0);
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

  /// Of a place on the screen in pixels, z in NDC.
  glm::dvec3 ToWorld(double x, double y, double z) const;

  const CameraCase& Case;
  std::mt19937 Random;
  vtkNew<vtkCamera> Camera;
  glm::dmat4 WorldToClip;
  glm::dmat4 ClipToWorld;
};

/// Compares the depth of a rectangle with a triangle of which it is the only trace.
class Judge
{
public:
  Judge(const glm::dmat4& worldToClip, const Triangle& triangle, bool isBehind);

  /// `depth` is that of the rectangle.
  void Compare(const vtkNBufferScreenBox& screen, const vtkNBufferRectangle& rectangle,
    const std::vector<float>& depth, Finding& finding) const;

private:
  Triangle Vertices;
  bool IsBehind;
  double Nearest;
  double Farthest;
  glm::dvec2 Slope;
};

/// The box that a candidate with this triangle has.
vtkNBufferBox BoundTriangle(const Triangle& triangle, const Sampler& sampler);

#endif
