// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RerenderedLitmap.h
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
 * The meshes that could cast are drawn, whether they do or not: lines, points and glyphs are
 * receivers of the other method only. A spot has the square around its cone here, and of a pixel
 * with several samples the first one counts.
 *
 * Set it as vtkShadowTuning::LitmapSource.
 */
#ifndef RerenderedLitmap_h
#define RerenderedLitmap_h

#include "vtkShadowCasterList.h"
#include "vtkShadowLitmapSource.h"
#include "vtkShadowPoints.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;

namespace NBufferPeers
{
class RerenderedLitmap : public vtkShadowLitmapSource
{
public:
  bool BeginFrame(vtkRenderer* renderer, const float* depth, const vtkShadowView& view,
    std::string& why) override;
  bool Fill(const vtkShadowLightSpace& space, const vtkShadowBlock& range, int resolution,
    vtkShadowLitmap& litmap, std::string& why) override;

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
  void Release() override;

private:
  bool Reserve(int resolution, std::string& why);
  void DrawExtremes(int which, float* pixels, int resolution);

  vtkShadowCasterList Receivers;
  vtkOpenGLRenderWindow* Window = nullptr; ///< The window of the frame.
  std::vector<float> Vertices;             ///< Relative to the eye, xyz each.
  std::vector<unsigned int> Indices;
  glm::dvec3 Eye = { 0.0, 0.0, 0.0 };
  glm::dmat4 EyeToClip = glm::dmat4(1.0);
  unsigned int DepthTexture = 0;
  unsigned int Texture = 0;
  unsigned int Framebuffer = 0;
  unsigned int VertexArray = 0;
  unsigned int Buffers[2] = {}; ///< Vertices, indices.
  int Resolution = 0;           ///< Of the framebuffer.
  int Draws = 0;
  vtkSmartPointer<vtkShaderProgram> Program;
};
}
#endif
