// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowCounter.h
 * @brief Draws shadow volumes into the stencil buffer and makes masks of what they count.
 *
 * Faces of a volume are counted along the line from the eye to the receiver, whose depth is in the
 * depth buffer:
 *
 *     z-pass   between eye and receiver: entered +1, left -1. Right where the eye is outside of the
 *              volume.
 *     z-fail   behind the receiver, in reverse. Right wherever the eye is, for closed volumes.
 *
 * Depth is clamped, so that the far plane cuts nothing off: all volumes are closed by themselves.
 * What lies before the near plane is cut off for z-fail, which has no use for it. Counts are kept
 * modulo 256 and wrap, so that their order does not matter; the caller sees to it that no receiver
 * is in 256 volumes at once.
 *
 * Volumes whose near cap may lie in a lit surface (those of open meshes) are pushed away from the
 * eye. There equal depths (fragments that fail LESS) are right, but another program may compute
 * them two units off, and vertices a step of the subpixel grid, 1/256 of a pixel, beside each other
 * in both.
 *
 * Where the target is multisampled, all of this is done for each sample by itself.
 */
#ifndef vtkShadowCounter_h
#define vtkShadowCounter_h

#include "vtkNBufferGL.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowPlan.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkShadowTarget;

class VTKNBUFFER_EXPORT vtkShadowCounter
{
public:
  /// Send a volume to the device. False, with the cause, if OpenGL refuses.
  bool Upload(const vtkShadowVolume& volume, std::string& why);

  /**
   * While it lives, the state for counting is set; then all is as before. One for any number of
   * lights of a frame.
   */
  class Scope
  {
  public:
    Scope(vtkOpenGLRenderWindow* window, const int viewport[4]);
    ~Scope();
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

  private:
    vtkNBufferGL::ScopedPass Pass;
    int DepthFunction = 0;
    unsigned char DepthMask = 0;
    int Scissor[4] = {};
    float OffsetFactor = 0.0f;
    float OffsetUnits = 0.0f;
    bool Clamp = false;
    bool Offset = false;
    std::array<bool, 5> SampleCapabilities = {};
    int Stencil[2][7] = {};
  };

  /**
   * Clear a mask (all four channels lit), and the stencil to a count, within the viewport.
   */
  void ClearMask(const vtkShadowTarget& target, int mask, const int viewport[4]);
  void ClearStencil(const vtkShadowTarget& target, const int viewport[4], int start);

  /**
   * Count draws [first, last). `volumeToClip`: row-major matrix from the uploaded vertices to clip
   * coordinates. `fragments`: if not null, the fragments that volumes covered, whether or not the
   * depth test passed, are added to it (as many more draws, and a wait for the device); samples of
   * them where the target is multisampled.
   */
  bool Count(vtkOpenGLRenderWindow* window, const vtkShadowTarget& target,
    const double volumeToClip[16], const vtkShadowDraw* first, const vtkShadowDraw* last,
    long long* fragments, std::string& why);

  /// Darken a channel of a mask where the count is not 0.
  bool Resolve(vtkOpenGLRenderWindow* window, const vtkShadowTarget& target, int mask, int channel,
    const int viewport[4], std::string& why);

  /// How volumes are made visible: their fragments, each of which adds 1/255 to all channels, or
  /// the edges of their triangles, blue where they are counted by z-pass and orange by z-fail.
  enum class Look
  {
    Fragments,
    Edges
  };

  /**
   * Draw volumes, without a depth test, into the colours of the framebuffer that is bound, in the
   * viewport that is set, for debug views. To be called within a ScopedPass.
   */
  bool Show(vtkOpenGLRenderWindow* window, const double volumeToClip[16],
    const std::vector<vtkShadowDraw>& draws, Look look, std::string& why);

  int GetNumberOfDraws() const { return this->Draws; }

  /// Delete everything; the context that made it must be current.
  void Release();

private:
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, vtkSmartPointer<vtkShaderProgram>& program,
    const char* vertexShader, const char* fragmentShader, std::string& why);
  void BindVolume(vtkShaderProgram* program, const double volumeToClip[16]);
  void SetDirection(bool zPass);
  void DrawVolume(const vtkShadowDraw& draw);

  unsigned int VertexBuffer = 0;
  unsigned int IndexBuffer = 0;
  unsigned int VertexArray = 0;
  unsigned int EmptyVertexArray = 0;
  unsigned int Query = 0;
  std::size_t VertexBytes = 0;
  std::size_t IndexBytes = 0;
  int Draws = 0;
  vtkSmartPointer<vtkShaderProgram> VolumeProgram;
  vtkSmartPointer<vtkShaderProgram> MaskProgram;
  vtkSmartPointer<vtkShaderProgram> TintProgram;
};
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCounter.h
