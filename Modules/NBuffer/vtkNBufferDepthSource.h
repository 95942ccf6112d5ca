// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferDepthSource.h
 * @brief The depth buffer of the framebuffer that is being drawn: what it is, and its pixels.
 *
 * The bound draw framebuffer is often not the render window's (SSAO, FXAA, framebuffer passes),
 * so that everything is asked of OpenGL and nothing assumed. No call changes the GL state.
 */
#ifndef vtkNBufferDepthSource_h
#define vtkNBufferDepthSource_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

struct VTKNBUFFER_EXPORT vtkNBufferDepthSource
{
  unsigned int Framebuffer = 0;       ///< GL name of the draw framebuffer; 0 is the window's own.
  int Viewport[4] = { 0, 0, 0, 0 };   ///< GL viewport: x, y, width, height in pixels.
  int Samples = 0;                    ///< 0 or 1: one sample per pixel.
  int DepthBits = 0;                  ///< 0: no depth buffer.
  bool FloatDepth = false;            ///< Floating-point depth instead of unsigned normalised.
  bool DefaultDepthRange = true;      ///< glDepthRange is [0, 1].
  bool Texture = false;               ///< The depth attachment is a texture (else a renderbuffer).
  unsigned int DepthName = 0;         ///< GL name of the depth attachment.
  int DepthLevel = 0;                 ///< Mip level of a texture attachment.

  /**
   * Ask OpenGL about the framebuffer bound for drawing. The window's context must be current.
   * Returns false, with the cause and a remedy in `why`, if there is no usable depth buffer.
   */
  bool Inspect(vtkOpenGLRenderWindow* window, std::string& why);

  /**
   * Read a rectangle of single-sample depth, in framebuffer pixels, as floats, row 0 at the
   * bottom, one blocking glReadPixels. Returns false, with the cause in `why`, on any GL error
   * and for multisampled framebuffers (vtkNBufferTexture reduces those first); `depth` is then
   * undefined.
   */
  bool Read(vtkOpenGLRenderWindow* window, int x, int y, int width, int height,
    std::vector<float>& depth, std::string& why) const;
};

VTK_ABI_NAMESPACE_END
#endif
