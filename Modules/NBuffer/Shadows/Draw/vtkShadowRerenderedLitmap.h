// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowRerenderedLitmap.h
 * @brief The litmap of the paper, for comparison: the receivers drawn from the light.
 *
 * X. Decoret, "N-Buffers for efficient depth map query", Computer Graphics Forum 24(3), 2005,
 * section 3.3: the receivers are drawn from the light into a framebuffer of the litmap's size, and
 * each fragment is tested against the camera's depth. Fragments that the camera sees widen the
 * depths and the box of pixels of their lexel (the paper keeps the depths alone; the box is added
 * so that both methods serve the same modes). Bins between the nearest and the farthest of a lexel
 * all are set.
 *
 * It may miss receivers, so that shadows are lost:
 *
 *  - A lexel stands for the one point of a receiver at its centre. What is smaller than a lexel
 *    as seen from the light, or seen edge-on, may have no lexel at all.
 *  - Of a lexel that takes up several pixels only the one at its centre is in the box, and only the
 *    depth there in the range.
 *  - The point is tested against the depth of the pixel in which it lies, which the camera took at
 *    the pixel's centre: on slopes what is seen can lie behind it. DepthBias, which the paper does
 *    not have, takes in most of that, not all, and some of what the camera does not see.
 *
 * vtkShadowReceivers.h has none of this. What remains of it with finer litmaps is less: a receiver
 * is not missed if it covers the centre of a lexel and of the pixel there.
 *
 * Drawn are the meshes that could cast, whether they do or not: lines, points and glyphs are
 * receivers of the other method only. Spots have no cone here but the square around it, and of a
 * pixel with several samples the first counts.
 */
#ifndef vtkShadowRerenderedLitmap_h
#define vtkShadowRerenderedLitmap_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowLight.h"
#include "vtkShadowLitmap.h"
#include "vtkShadowPoints.h"
#include "vtkShadowReceivers.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class VTKNBUFFER_EXPORT vtkShadowRerenderedLitmap
{
public:
  /// How far behind the camera's depth what it sees may lie: window depth, 0 to 1.
  static constexpr double DepthBias = 1e-4;

  /// Forget the receivers of the last frame; the next ones are relative to this eye.
  void Begin(const glm::dvec3& eye);

  /// `points`: world; `triangles`: three of them each.
  void AddReceiver(vtkShadowPoints points, const std::vector<int>& triangles);

  /**
   * Send the receivers and the camera's depth (as vtkShadowReceivers::Scatter takes it) to the
   * device. False, with the cause in `why`, if OpenGL refuses. The state is as before.
   */
  bool Upload(
    vtkOpenGLRenderWindow* window, const float* depth, const vtkShadowView& view, std::string& why);

  /**
   * Fill `litmap` with what `frame` sees over a range as vtkShadowReceivers::GetRange gives it. The
   * caller builds its levels then. False, with the cause in `why`, if OpenGL refuses. The state is
   * as before. Costs two draws of all receivers, and two read-backs of the litmap's size.
   */
  bool Draw(vtkOpenGLRenderWindow* window, const vtkShadowLightSpace& frame,
    const vtkShadowBlock& range, int resolution, vtkShadowLitmap& litmap, std::string& why);

  /// Draws and read-backs so far.
  int GetNumberOfDraws() const { return this->Draws; }

  /// Delete everything; the context that made it must be current.
  void Release();

private:
  bool Reserve(int resolution, std::string& why);
  void DrawExtremes(int which, float* pixels, int resolution);

  std::vector<float> Vertices; ///< Relative to the eye, xyz each.
  std::vector<unsigned int> Indices;
  glm::dvec3 Eye = { 0.0, 0.0, 0.0 };
  double EyeToClip[16] = {};
  unsigned int DepthTexture = 0;
  unsigned int Texture = 0;
  unsigned int Framebuffer = 0;
  unsigned int VertexArray = 0;
  unsigned int Buffers[2] = {}; ///< Vertices, indices.
  int Resolution = 0;           ///< Of the framebuffer.
  int Draws = 0;
  vtkSmartPointer<vtkShaderProgram> Program;
};
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowRerenderedLitmap.h
