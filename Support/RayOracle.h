// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RayOracle.h
 * @brief What is lit and what is in shadow, by rays in double precision. Shares no code with the
 * pass, and needs no OpenGL: a renderer in a window of the right size, which may never have
 * rendered.
 *
 * A sample is the centre of a pixel, or a place beside it. The ray of the camera's matrices through
 * it finds the nearest triangle and the point on it, the receiver; it is in shadow if the open
 * segment from it to the light crosses any triangle other than its own. Surfaces that coincide with
 * the receiver's do not shadow it: crossings nearer to it than 1e-9 of the scene's size do not
 * count.
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
  /// What the camera sees at a sample.
  struct Receiver
  {
    double Position[3];
    double Normal[3]; ///< Unit length, towards the eye.
    int Triangle = -1;
  };

  struct Classification
  {
    OracleSample Sample = OracleSample::Background;
    /// The light grazes the triangle's plane (|N.L| < 1e-4) or its ray the cone (1e-6 in the
    /// cosine): single precision may see it on the other side.
    bool Marginal = false;
  };

  /// Keeps nothing of the renderer but pointers to props. All props cast unless `isCaster` says no.
  explicit Oracle(vtkRenderer* renderer, const std::function<bool(vtkProp*)>& isCaster = {});

  /// Where the sample of a pixel is, in [0, 1] from its lower left corner: at first its centre.
  void SetSample(double x, double y);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  const RenderedTriangles& GetTriangles() const { return this->Triangles; }
  const TriangleTree& GetTree() const { return this->Tree; }

  /// The ray through pixel (x, y) of the viewport, `jitter` pixels off its sample, from the near
  /// to the far plane. Its direction has unit length.
  Ray GetEyeRay(int x, int y, double jitterX = 0.0, double jitterY = 0.0) const;

  /// False where there is nothing.
  bool GetReceiver(int x, int y, double jitterX, double jitterY, Receiver& receiver) const;

  bool IsShadowed(const Receiver& receiver, const OracleLight& light) const;

  /// m(P): how many triangles the open segment crosses, and those that coincide at the same place
  /// one by one.
  int CountCrossings(const Receiver& receiver, const OracleLight& light) const;

  Classification Classify(
    int x, int y, double jitterX, double jitterY, const OracleLight& light) const;

  /**
   * True if the sample is marginal; if one of the samples 1/64 of a pixel beside it in the four
   * diagonal directions is of another kind, or beyond an edge or a step of the surface, so that a
   * rasteriser may see another one; or if it is of another kind where rounding may put it: 4 or 8
   * units of depth of 24 bits along the eye ray, or 2 steps of a subpixel grid of 1/256 pixel
   * beside it, and from there back to its surface along the light's ray, which grazing light makes
   * a long way. Where its triangle reaches out of the view, the bound of DrawnPolygon.h, which is
   * the larger the farther it does, is added to the units of depth.
   */
  bool IsAmbiguous(int x, int y, const OracleLight& light) const;

  /// All pixels of the viewport, by several threads.
  OracleImage Cast(const OracleLight& light) const;

private:
  void SetView(vtkRenderer* renderer);
  void FindClipped();
  Ray GetShadowRay(const Receiver& receiver, const OracleLight& light) const;
  /**
   * Whether the surface that is seen at a is not, or only over a sharp edge, that at b next to it.
   * If their planes meet between them, neither is farther off the other's plane than the sine of
   * the planes' angle times the distance. Sheets behind each other are, at however small an angle
   * they are seen.
   */
  bool IsStep(const Receiver& a, const Receiver& b) const;
  bool IsAmbiguous(int x, int y, const OracleLight& light, const Classification& centre) const;
  /// The actors that are crossed between it and the light.
  std::set<int> GetCrossed(const Receiver& receiver, const OracleLight& light) const;
  bool DependsOnRounding(int x, int y, const Receiver& receiver, const OracleLight& light) const;
  double GetWindowDepth(const double world[3]) const;
  /// How far the window depth of its surface may be drawn from the exact one, beyond DepthSteps.
  double GetDepthBound(int x, int y, int triangle) const;

  int Width = 0;
  int Height = 0;
  double Sample[2] = { 0.5, 0.5 };
  double Projection[4][4]; ///< View to clip coordinates.
  double ViewToWorld[4][4];
  double WorldToClip[4][4];
  double Tolerance = 0.0; ///< World length in which surfaces coincide.
  RenderedTriangles Triangles;
  std::vector<unsigned char> Casts;    ///< For each actor.
  std::map<int, DrawnPolygon> Clipped; ///< Triangles that reach out of the view.
  TriangleTree Tree;
};

/// For one light of one scene.
OracleImage Cast(vtkRenderer* renderer, vtkLight* light);

#endif
