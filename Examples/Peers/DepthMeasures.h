// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DepthMeasures
 * @brief What a depth buffer of one format and encoding distinguishes, measured by drawing.
 *
 * The view has an angle of 30 degrees, VTK's default, and 256 x 256 pixels. The eye is at the
 * origin, so that vertices are as exact as floats are: 2^-24 of their distance. All functions
 * except WhyNot() throw std::runtime_error on errors of OpenGL.
 */
#ifndef DepthMeasures_h
#define DepthMeasures_h

#include "DepthPainter.h"

#include <array>

namespace NBufferPeers
{

class DepthMeasures
{
public:
  DepthMeasures(vtkOpenGLRenderWindow* window, const NBufferStudy::DepthFormat& format,
    const NBufferStudy::DepthPlanes& planes);

  /// Returns why the device cannot draw this format, or an empty text if it can.
  const std::string& WhyNot() const { return this->Obstacle; }

  /// The unit of these is that of distances. They are -1 if nothing up to the far plane is
  /// distinguished.
  struct Resolution
  {
    double Median = -1.0;
    double Worst = -1.0;
  };

  /// Measures by how much a surface has to be behind another one for its stored depth to be
  /// strictly farther, as that of every surface beyond. 4,096 tiles that face the eye are drawn, at
  /// distances from this one on and all over the image; those that are at most 5 % or a step of the
  /// format farther, and at most half of them, are compared with the others.
  Resolution MeasureResolution(double distance);

  struct Fight
  {
    long long Pixels = 0;
    long long Wrong = 0;
  };

  /// Draws two parallel triangles with a gap along the axis of the view, the farther one last, and
  /// counts the pixels that show the one that is farther there. Distances are those of the axis;
  /// towards the upper side of the image the triangles recede by `slope`. Which one is farther is
  /// computed in double precision from the vertices that the device got. Pixels near the outlines
  /// or before the near plane are not counted.
  Fight CountWrongPixels(double slope, double distance, double gap);

  struct Offset
  {
    double Unit = 0.0;          ///< r of the specification, 4.6 section 14.6.5, as measured.
    double ExpectedUnit = 0.0;  ///< 2^-bits, or the step of floats at the triangle's largest depth.
    double MovedByOne = 0.0;    ///< The share of the pixels that an offset of one unit changes.
    double Slope = 0.0;         ///< m of the specification, as measured.
    double LargerSlope = 0.0;   ///< The larger one of the slopes along x and y, in depth per pixel.
    double SteepestSlope = 0.0; ///< The slope along the gradient, in depth per pixel.
  };

  /// Measures what glPolygonOffset() adds to the depth of a triangle that recedes by these slopes
  /// to the right and to the upper side. What Offset expects is that of the matrices, Forward and
  /// Reversed.
  Offset MeasureOffset(double slopeX, double slopeY, double distance);

private:
  using Triangle = std::array<glm::vec3, 3>;
  Triangle MakeTriangle(double slopeX, double slopeY, double distance) const;
  void Upload(const std::vector<Triangle>& triangles);
  void Draw();

  NBufferStudy::DepthFormat Format;
  DepthView View;
  DepthPainter Painter;
  std::string Obstacle;
  int Vertices = 0;
};

} // namespace NBufferPeers

#endif
