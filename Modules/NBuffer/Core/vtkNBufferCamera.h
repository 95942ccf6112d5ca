// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCamera
 * @brief The camera of a renderer, for the eye that is being drawn, as the culler and the shadow
 * pass use it.
 *
 * vtkCamera::GetCompositeProjectionTransformMatrix() leaves out the shear that the eyes of a stereo
 * pair have. VTK's mappers multiply the projection matrix by the model-view matrix instead, and so
 * does this class.
 *
 * VTK draws with the matrices that vtkOpenGLCamera keeps until camera or renderer are modified. A
 * window that is switched to stereo or back modifies neither, so that the matrices may be those of
 * an eye that is no longer drawn. VTK draws with these matrices nevertheless, and so this class
 * uses them. Only if the stereo flag of the camera is not yet that of the window, or the camera is
 * no vtkOpenGLCamera, it computes the matrices from the camera's parameters.
 */
#ifndef vtkNBufferCamera_h
#define vtkNBufferCamera_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkType.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkRenderer;

struct VTKNBUFFER_EXPORT vtkNBufferCamera
{
  /// The active camera of a renderer that has one, for the eye that the renderer draws.
  explicit vtkNBufferCamera(vtkRenderer* renderer);

  /// The matrix from positions relative to Eye to clip coordinates. It avoids the large numbers
  /// that cancel each other in WorldToClip if the world's origin is far away.
  glm::dmat4 GetEyeToClip() const;

  glm::dmat4 WorldToClip;  ///< From world to clip coordinates; points with -w <= z <= w are seen.
  glm::dvec3 Eye;          ///< The camera's position in the world.
  bool IsParallel = false; ///< True for parallel projection.
};

/**
 * What the verdicts of a frame depend on, except for the props. Two frames with equal keys project
 * boxes alike and draw into the same buffers.
 */
struct vtkNBufferViewKey
{
  std::array<double, 16> WorldToClip{}; ///< Row-major, as the mappers get it.
  std::array<int, 4> Viewport{};        ///< x, y, width, height in pixels of the window.
  vtkCamera* Camera = nullptr;          ///< Only compared, never dereferenced.
  vtkMTimeType ContextTime = 0;         ///< When the window's OpenGL context was created.
  int MultiSamples = 0;                 ///< As vtkRenderWindow::GetMultiSamples().

  /// The key of a renderer that has a camera and an OpenGL window.
  static vtkNBufferViewKey Make(vtkRenderer* renderer);

  /// Whether both draw each point of the world at the same place, by whichever camera.
  bool HasSameView(const vtkNBufferViewKey& other) const
  {
    return this->WorldToClip == other.WorldToClip && this->Viewport == other.Viewport &&
      this->ContextTime == other.ContextTime && this->MultiSamples == other.MultiSamples;
  }
  bool operator==(const vtkNBufferViewKey& other) const
  {
    return this->HasSameView(other) && this->Camera == other.Camera;
  }
};

VTK_ABI_NAMESPACE_END
#endif
