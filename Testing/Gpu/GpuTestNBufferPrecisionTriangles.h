// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GpuTestNBufferPrecisionTriangles.h
 * @brief Random triangles before given cameras, and the comparison of drawn depth with exact depth.
 */
#ifndef GpuTestNBufferPrecisionTriangles_h
#define GpuTestNBufferPrecisionTriangles_h

#include "vtkNBufferGL.h"
#include "vtkNBufferProjection.h"

#include "vtkCamera.h"
#include "vtkNew.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

constexpr int Width = 640;
constexpr int Height = 480;
constexpr double LowestHeight = 1.0 / 16; // The t of vtkNBufferBoxError.h, in pixels.

struct CameraCase
{
  const char* Name;
  double Near;
  double Far;
  bool Parallel;
  double Offset;  ///< The world coordinates x and y of the eye, around which the scene lies.
  bool IsShifted; ///< Whether the vertex buffer holds coordinates relative to the scene.
};

enum class Kind
{
  Facing,   ///< All corners have one depth, so that only quanta and rounding matter.
  Slanted,  ///< The corners have any depths, up to 2 to 200 pixels away from a place.
  SubPixel, ///< As Slanted, but smaller than two pixels, around the middle of one.
  Steep,    ///< 1/16 to 1/4 pixel high, with a large range of depths across that height.
  Sliver,   ///< As Steep, but with lower heights, down to almost 0, and with any depths.
  Behind,   ///< Reaches behind the eye and out of the view.
};

using Triangle = std::array<glm::dvec3, 3>;

///@{
/// Return x and y in pixels, and the window depth, or the order of reversed depth, as z.
glm::dvec3 ToScreen(const glm::dmat4& worldToClip, const glm::dvec3& point);
Triangle ToScreen(const glm::dmat4& worldToClip, const Triangle& triangle);
///@}

/// Returns the smallest height, in pixels.
double GetHeight(const Triangle& onScreen);

/// What was found about the triangles of one kind under one camera. Depths are window depths.
struct Finding
{
  long long Fragments = 0;
  long long Nearer = 0; ///< Fragments nearer than their triangle's exact nearest depth.
  ///@{
  /// Of the fragment that comes closest to its slack: how far it is outside of its triangle's exact
  /// range of depths, the slack there, and the ratio of the two.
  double Outside = 0.0;
  double Slack = 0.0;
  double Largest = 0.0;
  ///@}
  double OfPlane = 0.0; ///< The largest such ratio for the distance from the exact plane.

  /// Replaces the three values above if this fragment has a larger ratio.
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

/// Makes random triangles for one camera.
class Sampler
{
public:
  Sampler(const CameraCase& camera, unsigned int seed,
    vtkNBufferStoredDepth stored = vtkNBufferStoredDepth::Ordinary);

  double Uniform(double a, double b)
  {
    return std::uniform_real_distribution<double>(a, b)(this->Random);
  }
  /// Returns a number in [a, b) whose logarithm is uniform.
  double Logarithmic(double a, double b) { return std::exp(Uniform(std::log(a), std::log(b))); }

  vtkCamera* GetCamera() const { return this->Camera; }
  /// Returns the matrix with which a device draws.
  glm::dmat4 GetWorldToClip() const;
  /// Returns the matrix for ToScreen().
  glm::dmat4 GetWorldToOrder() const;
  vtkNBufferStoredDepth GetStored() const { return this->Stored; }
  vtkNBufferProjection GetProjection(double quantum = 0x1p-24) const;
  /// Returns the origin, in world coordinates, of the coordinates in the vertex buffer.
  glm::dvec3 GetShift() const
  {
    return this->Case.IsShifted ? glm::dvec3(this->Case.Offset, this->Case.Offset, 0.0)
                                : glm::dvec3(0.0);
  }

  /// Returns a triangle in world coordinates.
  Triangle Make(Kind kind);

  /// The places in a pixel of which the worst cases lie near one; by default its middle.
  void SetSamples(const vtkNBufferGL::SamplePlaces& samples) { this->Samples = samples; }

private:
  /// Makes the worst case for the plane: a height near the lowest one that the slack covers, a
  /// large range of depths, and a long edge within 1/512 pixel of the middles of pixels, so that
  /// snapping decides which of them are covered.
  Triangle MakeSteep();
  Triangle MakeSliver();

  /// Makes a triangle of the ground, a wall or the ceiling around the eye, which reaches far ahead
  /// and may reach behind the eye.
  Triangle MakeGround();

  /// Returns the world coordinates of a place on the screen: x and y in pixels, z in NDC.
  glm::dvec3 ToWorld(double x, double y, double z) const;

  const CameraCase& Case;
  vtkNBufferStoredDepth Stored;
  std::mt19937 Random;
  vtkNBufferGL::SamplePlaces Samples = { { 0.5, 0.5 } };
  vtkNew<vtkCamera> Camera;
  glm::dmat4 WorldToClip;
  glm::dmat4 ClipToWorld;
};

/// Compares the depth of a rectangle, in which only one triangle was drawn, with this triangle.
class Judge
{
public:
  Judge(const Sampler& sampler, const Triangle& triangle, bool isBehind);

  /// Checks all fragments against the slack. `depth` has the orders of the rectangle, row by row;
  /// `screen` is the triangle's projected box.
  void Compare(const vtkNBufferScreenBox& screen, const vtkNBufferRectangle& rectangle,
    const std::vector<float>& depth, Finding& finding) const;

private:
  Triangle Vertices;
  bool IsBehind;
  vtkNBufferStoredDepth Stored;
  double Nearest;
  double Farthest;
  glm::dvec2 Slope;
};

/// Returns the box that a candidate with this triangle has.
vtkNBufferBox BoundTriangle(const Triangle& triangle, const Sampler& sampler);

#endif
