// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferTexture
 * @brief An N-buffer on the graphics device: one 2D array texture, layer i holding level i.
 *
 * Build() reduces a rectangle of the depth buffer that is being drawn to level 0 and makes the
 * levels above it, all by fragment passes of OpenGL 3.2. vtkNBufferMath.h says what a texel
 * covers; vtkNBufferLevels holds the same levels, bit for bit, in host memory.
 *
 * Texels are 32-bit floats (R32F), layers are width x height of the base, so that memory is
 * 4 * levels * ceil(w / factor) * ceil(h / factor) bytes. It is kept while the size stays.
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
   * samples of its pixels. Cost: one pass over the depth and one over the base per level.
   */
  bool Build(vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source, int x, int y,
    int width, int height, int factor, int levels, vtkNBufferExtremum extremum);

  /**
   * Copy the levels that are built to host memory in one blocking read-back.
   */
  bool Download(vtkOpenGLRenderWindow* window, vtkNBufferLevels& levels);

  ///@{
  /// Size of the base in texels, levels built and the GL name of the array texture (0: none).
  int GetWidth() const;
  int GetHeight() const;
  int GetNumberOfLevels() const;
  unsigned int GetHandle() const;
  ///@}

  /// Cause and remedy of the last failure; empty after a success.
  const std::string& GetError() const;

  /// Milliseconds on the device of the last build whose timer query has finished; never waits.
  /// 0 where timer queries are missing.
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
};

VTK_ABI_NAMESPACE_END
#endif
