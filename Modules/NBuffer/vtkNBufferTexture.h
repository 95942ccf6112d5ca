// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferTexture
 * @brief An N-buffer on the graphics device: levels in two 2D array textures.
 *
 * Build() reduces a rectangle of the depth buffer that is being drawn to level 0 and makes the
 * levels above it, all by fragment passes of OpenGL 3.2. vtkNBufferMath.h defines which squares a
 * texel covers; vtkNBufferLevels builds the same levels, bit for bit, in host memory.
 *
 * Texels are 32-bit floats (R32F; RG32F with both extrema). Even and odd levels live in two array
 * textures, so that a pass never reads the texture that it writes. Level i is layer GetLayer(i) of
 * GetHandle(i), and fills the lower left GetWidth() x GetHeight() texels of that layer. The memory
 * grows with the largest image and the largest number of levels since construction, to 4 * levels *
 * ceil(w / factor) * ceil(h / factor) bytes, and is kept until ReleaseGraphicsResources(). Shaders
 * query the levels by the functions of vtkNBufferQuery.glsl.
 *
 * Where depth comes from: Build() samples a depth texture directly. It first copies, on the device,
 * the depth of a renderbuffer or of the window's own framebuffer. It copies normalised depth of 32
 * bits, which samplers round, as integers. Multisampled depth must be a texture: Build() fetches
 * every sample, without resolving them into one.
 *
 * Depth is rounded as by vtkNBufferDepthSource::Read(), with two exceptions. Depth of 24 bits has
 * the value that the driver's sampler returns, which can be one unit in the last place lower than
 * what Read() returns. Multisampled normalised depth of 32 bits can only be sampled, and is moved
 * by 2^-23 to the conservative side (up for Maximum, down for Minimum).
 *
 * Build() and Download() restore the GL state that they change. On a failure (no float textures, no
 * readable depth, incomplete framebuffer, shader error) they return false and leave no levels, and
 * GetError() names the cause and a remedy.
 */
#ifndef vtkNBufferTexture_h
#define vtkNBufferTexture_h

#include "vtkNBufferLevels.h" // For Download
#include "vtkNBufferModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For the implementation's pointer
#include <string> // For the error text
#include <vector> // For rectangles

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkWindow;
struct vtkNBufferDepthSource;

class VTKNBUFFER_EXPORT vtkNBufferTexture : public vtkObject
{
public:
  static vtkNBufferTexture* New();
  vtkTypeMacro(vtkNBufferTexture, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Build `levels` levels (clamped to vtkNBufferMath::GetNumberOfLevels) over the rectangle (x, y,
   * width, height) in framebuffer pixels of `source`, which describes the framebuffer bound for
   * drawing. `factor`, the side in pixels of the square that a texel of level 0 covers, is 1, 2, 4
   * or 8. With multisampling a texel holds the extremum over all samples of its pixels. The
   * window's context must be current. Cost: one pass over the depth, and one over the texels of
   * each further level; it does not wait for the device.
   */
  bool Build(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source, int x, int y,
    int width, int height, int factor, int levels, vtkNBufferExtremum extremum);

  /// Build over the viewport of the framebuffer that is bound, as in an observer of EndEvent.
  bool Build(vtkOpenGLRenderWindow* window, int factor, int levels, vtkNBufferExtremum extremum);

  /**
   * Copy all levels to host memory in one blocking read-back of 4 * levels * width * height bytes.
   * Returns false and clears `levels` on failure.
   */
  bool Download(vtkOpenGLRenderWindow* window, vtkNBufferLevels& levels);

  /**
   * Copy the texels of level 0 that lie in `rectangles` to their places in `base`, which has room
   * for GetWidth() * GetHeight() texels, in one blocking read-back of 4 bytes per texel. The
   * rectangles are not empty and lie inside the level. Other texels of `base` stay as they are.
   * Returns false on failure; the texels are then undefined.
   */
  bool Download(
    vtkOpenGLRenderWindow* window, const std::vector<vtkNBufferRectangle>& rectangles, float* base);

  ///@{
  /// Size of a level in texels, and the number of levels; all are 0 while there are no levels.
  int GetWidth() const;
  int GetHeight() const;
  int GetNumberOfLevels() const;
  ///@}

  ///@{
  /// The GL name of the GL_TEXTURE_2D_ARRAY that holds a level, and the level's layer there. Both
  /// are 0 for a level that is not built.
  unsigned int GetHandle(int level) const;
  int GetLayer(int level) const;
  ///@}

  ///@{
  /// The number of passes that the last Build() drew, and the numbers of allocations and of
  /// read-backs since construction.
  int GetNumberOfDraws() const;
  int GetNumberOfAllocations() const;
  int GetNumberOfDownloads() const;
  ///@}

  ///@{
  /**
   * Whether float textures may be used (on by default). If off, Build() fails as it does on devices
   * that cannot draw into them, so that tests on any device can show what happens then.
   */
  vtkSetMacro(AllowFloatTextures, bool);
  vtkGetMacro(AllowFloatTextures, bool);
  ///@}

  ///@{
  /**
   * Whether Build() also stores the other extremum, in the second channel of the textures. The
   * passes are the same, with less than twice the time and with twice the memory (which the
   * textures keep when this is switched off again). Shaders then read the minima of a texture of
   * maxima with `minima` = 1 (vtkNBufferQuery.glsl). Download() copies the first channel. Default:
   * off.
   */
  vtkSetMacro(BothExtrema, bool);
  vtkGetMacro(BothExtrema, bool);
  vtkBooleanMacro(BothExtrema, bool);
  ///@}

  /// Whether the last Build() failed because there are no float textures to draw into.
  bool LacksFloatTextures() const;

  /// The cause of the last failure and a remedy; empty after a success.
  const std::string& GetError() const;

  /// How many milliseconds the device took for the last build whose timer query has finished; 0
  /// before there is one, and without timer queries (before OpenGL 3.3). Never waits. The context
  /// must be current.
  double GetDeviceTime();

  /// Delete all OpenGL objects. VTK calls this before it destroys the window's context; the
  /// application may call it at any time.
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkNBufferTexture();
  ~vtkNBufferTexture() override;

private:
  vtkNBufferTexture(const vtkNBufferTexture&) = delete;
  void operator=(const vtkNBufferTexture&) = delete;

  class Internals;
  std::unique_ptr<Internals> Implementation;
  bool AllowFloatTextures = true;
  bool BothExtrema = false;
};

VTK_ABI_NAMESPACE_END
#endif
