// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RerenderedLitmap.h
 * @brief The litmap of the paper, for comparison: the receivers are drawn from the light.
 *
 * X. Decoret, "N-Buffers for efficient depth map query", Computer Graphics Forum 24(3), 2005,
 * section 3.3: the receivers are drawn from the light into a framebuffer of the litmap's size, and
 * each fragment is tested against the camera's depth. Fragments that the camera sees widen the
 * range of depths and the box of pixels of their lexel. (The paper has the depths alone; the box is
 * added so that both methods serve the same modes.) All bins between the nearest and the farthest
 * depth of a lexel are set.
 *
 * This method may miss receivers, so that shadows are lost:
 *
 *  - A lexel represents only the point of a receiver at the lexel's centre. A receiver that is
 *    smaller than a lexel as seen from the light, or is seen edge-on, may have no lexel at all.
 *  - If a lexel covers several pixels, only the pixel at its centre is in the box, and only the
 *    depth there is in the range.
 *  - The point is tested against the depth of the pixel in which it lies, and that depth is the one
 *    at the pixel's centre: on slopes, a visible point can lie behind it. DepthBias, which the
 *    paper does not have, includes most of these points, and some that the camera does not see.
 *
 * vtkShadowReceivers.h has none of these errors. Finer litmaps make them smaller: a receiver is not
 * missed if it covers the centre of a lexel and of the pixel there.
 *
 * The receivers drawn are the meshes that could cast shadows, whether they cast or not; lines,
 * points and glyphs are receivers only of vtkShadowReceivers.h. For a spot the litmap is the square
 * around its cone, and of a pixel with several samples only the first one is used.
 *
 * Set it as vtkShadowTuning::LitmapSource.
 */
#ifndef RerenderedLitmap_h
#define RerenderedLitmap_h

#include "vtkNBufferGLObject.h"
#include "vtkShadowCasterList.h"
#include "vtkShadowLitmapSource.h"

#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace NBufferPeers
{
class RerenderedLitmap : public vtkShadowLitmapSource
{
public:
  bool BeginFrame(vtkRenderer* renderer, const float* depth, const vtkShadowView& view,
    std::string& why) override;
  bool Fill(const vtkShadowLightSpace& space, const vtkShadowBlock& range, int resolution,
    vtkShadowLitmap& litmap, std::string& why) override;

  /// How far behind the camera's depth a point may lie and still count as visible, in window depth.
  static constexpr double DepthBias = 1e-4;

  /// Begins a frame without receivers. The next ones are stored relative to this eye.
  void Begin(const glm::dvec3& eye);

  /// Adds a receiver. `points` are world coordinates; `triangles` has three indices for each
  /// triangle.
  void AddReceiver(const vtkShadowPoints& points, const std::vector<int>& triangles);

  /**
   * Sends the receivers and the camera's depth (see vtkShadowReceivers::Scatter()) to the device.
   * Returns false, with the cause in `why`, on an error of OpenGL. The OpenGL state is restored.
   */
  bool Upload(
    vtkOpenGLRenderWindow* window, const float* depth, const vtkShadowView& view, std::string& why);

  /**
   * Fills `litmap` with the receivers that the light `frame` sees over a range as
   * vtkShadowReceivers::GetRange() gives it. The caller builds the levels of the litmap afterwards.
   * Returns false, with the cause in `why`, on an error of OpenGL. The OpenGL state is restored.
   * The cost is two draws of all receivers, and two read-backs of the litmap's size.
   */
  bool Draw(vtkOpenGLRenderWindow* window, const vtkShadowLightSpace& frame,
    const vtkShadowBlock& range, int resolution, vtkShadowLitmap& litmap, std::string& why);

  void Release() override { this->Device = DeviceObjects(); }

private:
  /// The objects of the litmaps on the graphics device.
  struct DeviceObjects
  {
    vtkNBufferGL::Texture Depth; ///< The camera's.
    vtkNBufferGL::Texture Litmap;
    vtkNBufferGL::Framebuffer Framebuffer; ///< Draws into Litmap.
    vtkNBufferGL::VertexArray VertexArray;
    vtkNBufferGL::Buffer Vertices;
    vtkNBufferGL::Buffer Indices;
    int Resolution = 0; ///< Texels along each side of Litmap.
    vtkSmartPointer<vtkShaderProgram> Program;
  };

  bool Reserve(int resolution, std::string& why);
  void DrawExtremes(int which, float* pixels, int resolution);

  vtkShadowCasterList Receivers;
  vtkOpenGLRenderWindow* Window = nullptr; ///< The window of the frame.
  std::vector<float> Vertices;             ///< x, y and z of each vertex, relative to the eye.
  std::vector<unsigned int> Indices;
  glm::dvec3 Eye = { 0.0, 0.0, 0.0 };
  glm::dmat4 EyeToClip = glm::dmat4(1.0);
  DeviceObjects Device;
};
}
#endif
