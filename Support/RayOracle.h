// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RayOracle.h
 * @brief Finds which pixels are lit and which are in shadow, by rays in double precision. The
 * oracle shares no code with vtkShadowVolumeClampPass. It needs no OpenGL, only a renderer in a
 * window of the right size, which need not have rendered.
 *
 * A sample is the centre of a pixel, or another place in the pixel. The ray of the camera's
 * matrices through the sample finds the nearest triangle and a point on it, the receiver. The
 * receiver is in shadow if the open segment from it to the light crosses any triangle other than
 * its own. Surfaces that coincide with the receiver's do not shadow it: crossings nearer to it than
 * 1e-9 of the scene's size are ignored.
 *
 *     OracleImage expected = Cast(renderer, light);
 *     EXPECT_TRUE(MatchesOracle(mask, expected)); // ShadowTest.h
 */
#ifndef RayOracle_h
#define RayOracle_h

#include "DrawnPolygon.h"
#include "OracleImage.h"
#include "RenderedTriangles.h"
#include "TriangleTree.h"

#include <functional>
#include <map>
#include <set>
#include <vector>

class vtkLight;
class vtkProp;
class vtkRenderer;

class Oracle
{
public:
  /// The point that the camera sees at a sample.
  struct Receiver
  {
    double Position[3];
    double Normal[3]; ///< The unit normal towards the eye.
    int Triangle = -1;
  };

  struct Classification
  {
    OracleSample Sample = OracleSample::Background;
    /// True if the light grazes the triangle's plane (|N.L| < 1e-4), or the ray of the light grazes
    /// the cone (1e-6 in the cosine). Single precision may then find it on the other side.
    bool Marginal = false;
  };

  /// The oracle keeps only pointers to props of the renderer. All props cast shadows except those
  /// for which `isCaster` returns false.
  explicit Oracle(vtkRenderer* renderer, const std::function<bool(vtkProp*)>& isCaster = {});

  /// Sets the place of the sample in its pixel, in [0, 1] from the lower left corner. The default
  /// is the centre.
  void SetSample(double x, double y);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  const RenderedTriangles& GetTriangles() const { return this->Triangles; }
  const TriangleTree& GetTree() const { return this->Tree; }

  /// Returns the ray from the near to the far plane through pixel (x, y) of the viewport: through a
  /// place that is `jitterX` and `jitterY` pixels away from the sample. The direction has unit
  /// length.
  Ray GetEyeRay(int x, int y, double jitterX = 0.0, double jitterY = 0.0) const;

  /// Finds the receiver on the ray of GetEyeRay(). Returns false if the ray meets no triangle.
  bool GetReceiver(int x, int y, double jitterX, double jitterY, Receiver& receiver) const;

  /// Calls visit(actor, distance) for each other triangle of a caster that the segment from the
  /// receiver to the light crosses, until it returns false.
  template <typename Visitor>
  void VisitCasters(const Receiver& receiver, const OracleLight& light, Visitor&& visit) const
  {
    this->Tree.VisitCrossings(this->GetShadowRay(receiver, light),
      [&](int triangle, double t)
      {
        const int owner = this->Triangles.Owners[triangle];
        return triangle == receiver.Triangle || !this->Casts[owner] || visit(owner, t);
      });
  }

  /// Returns whether the segment crosses such a triangle.
  bool IsShadowed(const Receiver& receiver, const OracleLight& light) const;

  /// Returns how many of them it crosses. Those that coincide are counted one by one.
  int CountCrossings(const Receiver& receiver, const OracleLight& light) const;

  /// Classifies the receiver on the ray of GetEyeRay().
  Classification Classify(
    int x, int y, double jitterX, double jitterY, const OracleLight& light) const;

  /**
   * Returns whether rounding may decide about a sample. That is so in five cases:
   *
   *  - The sample is marginal (Classification).
   *  - One of the samples 1/64 of a pixel away in the four diagonal directions is of another kind
   *    (OracleSample), or is beyond an edge or a step of the surface, so that a rasteriser may find
   *    another surface.
   *  - The sample is of another kind at a place to which rounding, and the push of volumes away
   * from surfaces (vtkShadowCounter.h), may move it: 1, 2, 4 or 8 units of 24-bit depth along the
   * eye ray; or 2 steps of a subpixel grid of 1/256 pixel beside it and 4 units before or behind;
   * and from there back to its surface along the light's ray, which is a long way under grazing
   *    light. If the triangle reaches out of the view, the bound of DrawnPolygon.h, which grows
   * with the part outside, is added to the units of depth along the eye ray.
   *  - The eye ray meets another triangle of a caster within 8 units of depth of the receiver, for
   *    instance the other side of a thin sheet. That triangle, as the cap of a volume, may be drawn
   *    before the receiver.
   *  - The surface is less than a unit of depth before the far plane. Its depth may be stored as
   *    that of the background.
   */
  bool IsAmbiguous(int x, int y, const OracleLight& light) const;

  /// Classifies all pixels of the viewport, by several threads.
  OracleImage Cast(const OracleLight& light) const;

private:
  void SetView(vtkRenderer* renderer);
  void FindClipped();
  /**
   * Returns whether the neighbours a and b are on different surfaces, or on surfaces that meet only
   * at a sharp edge. If the planes of a and b meet between these points, neither point is farther
   * from the other's plane than the sine of the planes' angle times the distance of the points.
   * Points on two sheets, one behind the other, are farther, however small the angle from which the
   * sheets are seen.
   */
  bool IsStep(const Receiver& a, const Receiver& b) const;
  /// Returns the segment from the receiver to the light.
  Ray GetShadowRay(const Receiver& receiver, const OracleLight& light) const;
  bool IsAmbiguous(int x, int y, const OracleLight& light, const Classification& centre) const;
  /// Returns the actors that the segment from the receiver to the light crosses.
  std::set<int> GetCrossed(const Receiver& receiver, const OracleLight& light) const;
  bool DependsOnRounding(int x, int y, const Receiver& receiver, const OracleLight& light) const;
  double GetWindowDepth(const double world[3]) const;
  /// Returns how far from the exact one the window depth of a surface may be drawn, in addition to
  /// the units of depth of IsAmbiguous().
  double GetDepthBound(int x, int y, int triangle) const;

  int Width = 0;
  int Height = 0;
  double Sample[2] = { 0.5, 0.5 };
  double Projection[4][4]; ///< From view to clip coordinates.
  double ViewToWorld[4][4];
  double WorldToClip[4][4];
  double Tolerance = 0.0; ///< The length in the world within which surfaces coincide.
  RenderedTriangles Triangles;
  std::vector<unsigned char> Casts;    ///< Whether each actor casts shadows.
  std::map<int, DrawnPolygon> Clipped; ///< Triangles that reach out of the view.
  TriangleTree Tree;
};

/// Casts rays to one light of one scene.
OracleImage Cast(vtkRenderer* renderer, vtkLight* light);

#endif
