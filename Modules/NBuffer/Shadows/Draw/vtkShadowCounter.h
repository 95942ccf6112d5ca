// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowCounter.h
 * @brief Draws shadow volumes into the stencil buffer and makes masks from the counts.
 *
 * A receiver is in shadow if it lies inside a volume. The stencil buffer counts the faces of
 * volumes along the line of sight, and the receivers' depth is in the depth buffer.
 * vtkShadowDrawList.h derives the two ways to count, z-pass and z-fail, and chooses one of them for
 * each volume.
 *
 * Depth is clamped, so the far plane does not cut volumes open. For z-fail a clip plane removes
 * what lies before the near plane, which z-fail never counts. Counts wrap modulo 256, so the order
 * of the faces does not matter; the caller ensures that no receiver is in 256 volumes at once.
 *
 * A near cap that is the caster's own triangles lies in the surface that is drawn. Where the
 * surface is seen, it has to be on one side of the cap, and not sometimes on this and sometimes on
 * that side by rounding: the shader program of the volumes may compute a depth that is two units
 * off (a unit is a step of 24-bit depth), and its vertices may be rounded to the next step of the
 * subpixel grid (1/256 of a pixel). A polygon offset therefore pushes such caps away from the eye
 * by two units and by the change of their depth over 1/128 of a pixel:
 *
 *     All   the cap may be in a lit surface, which is then before the volume and stays lit. Near
 *           the outline the sides are as near to this surface; they are pushed, too.
 *     Away  the cap is in the unlit side. Where this is seen, the cap is pushed into the caster, so
 *           that the unlit side is in the volume. This matters where it is lit all the same, by
 *           normals that are interpolated across the edges of a coarse mesh.
 *
 * A caster that is small compared with its distance from the origin of its coordinates is drawn
 * farther off its place (vtkShadowCaster.h). Its z and w are rounded independently of each other,
 * so that the error of its depth z / w is the sum of both, divided by w. With All, its volume is
 * pushed by as much, and litmaps know of that (vtkShadowReceiverProjector.h).
 *
 * Where the device offsets corners instead of fragments, which bends triangles
 * (vtkNBufferGL::OffsetsBeyondFarPlane), the fragment shader offsets the triangles. It adds four
 * units, because its sum and the conversion of the depth that it writes are rounded by at most one
 * unit each.
 *
 * In a multisampled target, each sample has its own depth and count.
 */
#ifndef vtkShadowCounter_h
#define vtkShadowCounter_h

#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowVolumeBuffer.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkShadowTarget;

class VTKNBUFFER_EXPORT vtkShadowCounter
{
public:
  vtkShadowCounter();

  /**
   * Sets the OpenGL state for counting, and restores the previous state when the scope ends. One
   * scope serves for all lights of a frame. The other functions, except Show() and Release(),
   * require it.
   */
  class Scope : public vtkNBufferGL::ScopedPass
  {
  public:
    Scope(vtkOpenGLRenderWindow* window, const int viewport[4]);
  };

  ///@{
  /// Sets all channels of a mask to lit, or the stencil buffer to 0, within the viewport (x, y,
  /// width and height in pixels).
  void ClearMask(const vtkShadowTarget& target, int mask, const int viewport[4]);
  void ClearStencil(const vtkShadowTarget& target, const int viewport[4]);
  ///@}

  /**
   * Draws the volumes `first` to `last - 1` of an uploaded buffer into the stencil, which counts
   * their faces. If `fragments` is not null, the number of fragments of the volumes is added to it,
   * whether or not they pass the depth test; in a multisampled target it is the number of their
   * samples. Then each volume is drawn twice, and the host waits for the device. Returns false,
   * with the cause in `why`, if an OpenGL call fails.
   */
  bool Count(vtkOpenGLRenderWindow* window, const vtkShadowTarget& target,
    const vtkShadowVolumeBuffer& volume, const vtkShadowDrawList::View& view,
    const vtkShadowDraw* first, const vtkShadowDraw* last, long long* fragments, std::string& why);

  /// Sets a channel of a mask to shadow where the count is not 0 and something has been drawn.
  /// Returns false, with the cause in `why`, if an OpenGL call fails.
  bool Resolve(vtkOpenGLRenderWindow* window, const vtkShadowTarget& target, int mask, int channel,
    const int viewport[4], std::string& why);

  /**
   * Draws volumes for a debug view, without a depth test, into the colours of the framebuffer that
   * is bound and the viewport that is set. With `edges` it draws the edges of triangles, blue for
   * z-pass and orange for z-fail; otherwise each fragment adds 1/255 to all channels. Call it
   * within a ScopedPass. Returns false, with the cause in `why`, if an OpenGL call fails.
   */
  bool Show(vtkOpenGLRenderWindow* window, const vtkShadowVolumeBuffer& volume,
    const vtkShadowDrawList::View& view, const std::vector<vtkShadowDraw>& draws, bool edges,
    std::string& why);

  /// Deletes the OpenGL objects. Their context must be current.
  void Release();

private:
  bool BeginVolumes(vtkOpenGLRenderWindow* window, vtkSmartPointer<vtkShaderProgram>& program,
    const std::string& fragmentShader, const vtkShadowVolumeBuffer& volume,
    const vtkShadowDrawList::View& view, std::string& why);

  vtkNBufferGL::Query Query;
  vtkNBufferGL::FullScreenPass MaskPass;
  vtkSmartPointer<vtkShaderProgram> VolumeProgram;
  vtkSmartPointer<vtkShaderProgram> TintProgram;
};
VTK_ABI_NAMESPACE_END
#endif
