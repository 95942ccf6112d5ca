// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferTexture
 * @brief An N-buffer on the graphics device: levels in two 2D array textures.
 *
 * Build() reduces a rectangle of the depth buffer that is being drawn to level 0 and makes the
 * levels above it, all by fragment passes of OpenGL 3.2. vtkNBufferMath.h says what a texel
 * covers; vtkNBufferLevels holds the same levels, bit for bit, in host memory.
 *
 * Texels are 32-bit floats (R32F). Even and odd levels live in two arrays, so that a pass never
 * reads the texture that it writes: level i is layer GetLayer(i) of GetHandle(i), in the lower left
 * GetWidth() x GetHeight() texels, which may be a part of the layer: memory grows with the largest
 * image and number of levels seen, 4 * levels * ceil(w / factor) * ceil(h / factor) bytes, and is
 * kept until ReleaseGraphicsResources().
 *
 * Where depth comes from: a depth texture is sampled where it is. A renderbuffer and the window's
 * own framebuffer are first copied on the device. Normalised depth of 32 bits, which samplers
 * round, is copied as integers. Multisampled depth must be a texture; all samples are fetched and
 * never resolved.
 *
 * Rounding is that of vtkNBufferDepthSource::Read, with two exceptions. Depth of 24 bits is what
 * the driver's sampler makes of it, which can be one unit in the last place lower than what Read
 * returns. Multisampled depth of 32 normalised bits can only be sampled, and is moved by 2^-23 to
 * the safe side (up for Maximum, down for Minimum).
 *
 * The GL state that Build() and Download() touch is put back. A failure (no float textures, no
 * readable depth, incomplete framebuffer, shader error) returns false, leaves no levels, and
 * GetError() names its cause and a remedy.
 */
#ifndef vtkNBufferTexture_h
#define vtkNBufferTexture_h

#include "vtkNBufferLevels.h" // For Download
#include "vtkNBufferModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For the implementation's pointer
#include <string> // For the error text

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
   * Build `levels` levels (clamped to vtkNBufferMath::GetNumberOfLevels) over the rectangle
   * (x, y, width, height) in framebuffer pixels of `source`, which describes the framebuffer bound
   * for drawing. `factor` is 1, 2, 4 or 8. Under multisampling a texel takes the extremum over all
   * samples of its pixels. The window's context must be current. Cost: one pass over the depth and
   * one over the base per level, nothing is waited for.
   */
  bool Build(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source, int x, int y,
    int width, int height, int factor, int levels, vtkNBufferExtremum extremum);

  /**
   * Copy the levels that are built to host memory in one blocking read-back of
   * 4 * levels * width * height bytes. On failure returns false and clears `levels`.
   */
  bool Download(vtkOpenGLRenderWindow* window, vtkNBufferLevels& levels);

  ///@{
  /// Size of the base in texels, and levels built (0: none).
  int GetWidth() const;
  int GetHeight() const;
  int GetNumberOfLevels() const;
  ///@}

  ///@{
  /// GL name of the GL_TEXTURE_2D_ARRAY that holds a level, and its layer there. Name 0 and layer
  /// 0 for a level that is not built.
  unsigned int GetHandle(int level) const;
  int GetLayer(int level) const;
  ///@}

  ///@{
  /// Passes drawn by the last Build; times that memory was asked of OpenGL, and read-backs, since
  /// construction.
  int GetNumberOfDraws() const;
  int GetNumberOfAllocations() const;
  int GetNumberOfDownloads() const;
  ///@}

  ///@{
  /**
   * Whether float textures may be used (on by default). Off, Build() fails as it does on devices
   * that cannot draw into them, so that what follows then can be seen on any device.
   */
  vtkSetMacro(AllowFloatTextures, bool);
  vtkGetMacro(AllowFloatTextures, bool);
  ///@}

  /// Whether the last Build() failed because there are no float textures to draw into.
  bool LacksFloatTextures() const;

  /// Cause and remedy of the last failure; empty after a success.
  const std::string& GetError() const;

  /// Milliseconds on the device of the last build whose timer query has finished; never waits.
  /// 0 where timer queries are missing (before OpenGL 3.3). The context must be current.
  double GetDeviceTime();

  /// Called by VTK when the window lets go of its context; may also be called by hand.
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
};

VTK_ABI_NAMESPACE_END
#endif
