// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferDepthSource.h
 * @brief The depth buffer of the framebuffer that is being drawn: its properties and its pixels.
 *
 * The framebuffer that is bound for drawing is often not the render window's (SSAO, FXAA,
 * framebuffer passes), so every property is queried from OpenGL. No function changes the GL state.
 *
 * The window's own framebuffer can be used, and so can framebuffer objects whose depth attachment
 * is a renderbuffer, a GL_TEXTURE_2D or a GL_TEXTURE_2D_MULTISAMPLE. Layered, cube and array
 * attachments cannot.
 */
#ifndef vtkNBufferDepthSource_h
#define vtkNBufferDepthSource_h

#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferSamples.h"
#include "vtkNBufferVTKVersion.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

struct VTKNBUFFER_EXPORT vtkNBufferDepthSource
{
  unsigned int Framebuffer = 0;     ///< GL name of the draw framebuffer; 0 is the window's own.
  int Viewport[4] = { 0, 0, 0, 0 }; ///< GL viewport: x, y, width, height in pixels.
  int Width = 0;                    ///< Width of the depth buffer in pixels.
  int Height = 0;                   ///< Height of the depth buffer in pixels.
  int Samples = 0;                  ///< Samples of a pixel; 0 and 1 both mean one.
  vtkNBufferSamples Places;         ///< Where the samples of each pixel are.
  int DepthBits = 0;                ///< 0 if there is no depth buffer.
  bool FloatDepth = false;          ///< Depth is floating-point, not unsigned normalised.
  /// What is stored, by the depth function, the depth range and the clip control.
  vtkNBufferStoredDepth Stored = vtkNBufferStoredDepth::Ordinary;
  bool HasStencil = false;    ///< The depth attachment also holds the stencil.
  bool Texture = false;       ///< The depth attachment is a texture, not a renderbuffer.
  unsigned int DepthName = 0; ///< GL name of the depth attachment.
  int DepthLevel = 0;         ///< Mip level of a texture attachment.

  /// What the state of the current context lets VTK store as depth.
  static vtkNBufferStoredDepth GetStoredDepth();

  /**
   * Query the framebuffer that is bound for drawing and set all members. The window's context must
   * be current. Returns false, with the cause and a remedy in `why`, if there is no usable depth
   * buffer; all members then have their defaults. Cost: about twenty glGet calls; it does not wait
   * for the device.
   */
  bool Inspect(vtkOpenGLRenderWindow* window, std::string& why);

  /**
   * Whether the viewport lies inside the depth buffer. It does not if a pass draws into a
   * framebuffer that is only as large as the viewport, but sets the viewport at its place in the
   * window (vtkSSAOPass before VTK 9.7, if the renderer fills only a part of the window).
   */
  bool HoldsViewport() const;

  /// The number of bits of depth that both the buffer and a float near 1 can hold; at most 24.
  int GetPrecision() const { return std::min(this->DepthBits, 24); }

  /**
   * The step of depth near the far plane: 2^-16 for 16 bits, otherwise 2^-24, the step of floats
   * near 1. Reversed floats have no step near 0 (vtkNBufferDepthFormat::FromQuantum()).
   *
   * A depth that is read as Maximum is at most two steps nearer than the one that the rasteriser
   * calculated, and one that is read as Minimum at most two steps farther, whether Read() or a
   * shader reads it. vtkNBufferDepthFormat::FromQuantum() allows for them:
   *
   *  - Storing costs at most one step: OpenGL takes one of the two nearest integers i of b bits.
   *    (They are 1 / (2^b - 1) apart, about 2^-2b more than a step. For 16 bits, reading costs so
   *    much less than a step that two steps are enough for both; for 24 bits, the rounding terms of
   *    the slack cover the excess.)
   *  - Reading costs at most one more. OpenGL does not say how i becomes the float i / (2^b - 1),
   *    and glReadPixels() and texelFetch() differ on some devices. One of the two floats around the
   *    exact value is off by less than 2^-24. Read() and Mesa's llvmpipe multiply integers of 24
   *    bits by a rounded factor instead, which returns up to 1.25 * 2^-24 too far, but never too
   *    near. The excess over one step, 0.25 * 2^-24, matters only for the Minimum. There the
   *    relative slack of reversed depth covers it: reading moves a depth d by 2^-23 d at most.
   *  - Copying to a texture (vtkNBufferTexture) costs nothing, because the format stays the same.
   *  - Of normalised depth of 32 bits the last 8 bits are dropped, which moves the depth by less
   *    than a step, and only to the safe side (vtkNBufferBaseFS.glsl does the same). Where only
   *    samplers can read such depth, the shader moves the value to the safe side by the error of
   *    samplers.
   */
  double GetStep() const
  {
    return this->FloatDepth && this->Stored == vtkNBufferStoredDepth::Reversed
      ? 0.0
      : std::ldexp(1.0, -this->GetPrecision());
  }

  /// Whether depth is normalised and has more bits than fit into a float.
  bool ExceedsFloats() const { return this->DepthBits > 24 && !this->FloatDepth; }

  /**
   * Whether there is a depth buffer, and the rectangle (in framebuffer pixels) is not empty and
   * lies inside it. If not, `why` receives the cause and a remedy.
   */
  bool Holds(int x, int y, int width, int height, std::string& why) const;

  /**
   * Read a rectangle (in framebuffer pixels) of single-sample depth as floats in [0, 1], row by
   * row, the lowest row first, by one blocking glReadPixels(). Returns false, with the cause in
   * `why`, on any GL error, for a rectangle that is not inside the depth buffer, and for
   * multisampled framebuffers (use vtkNBufferTexture for these); `depth` is then undefined.
   *
   * Rounding: floating-point depth is returned unchanged. Depth of 16 bits is rounded by
   * the driver; depth of 24 bits is at most 1.25 * 2^-24 farther than stored and never nearer
   * (GetStep() says what follows from both). Normalised depth of 32 bits does not fit a float; it
   * is rounded to a multiple of 2^-24, up for Maximum (never nearer than stored, except for a
   * relative 2^-32) and down for Minimum (never farther). 0 and 1 are exact.
   *
   * Normalised depth of 24 and 32 bits is read as integers, which is a plain copy, and converted
   * here. Mesa's software drivers convert a read of floats pixel by pixel, which takes four times
   * as long.
   */
  bool Read(vtkOpenGLRenderWindow* window, int x, int y, int width, int height,
    std::vector<float>& depth, std::string& why,
    vtkNBufferExtremum rounding = vtkNBufferExtremum::Maximum) const;
  /// The same into memory that has room for the rectangle.
  bool Read(vtkOpenGLRenderWindow* window, int x, int y, int width, int height, float* depth,
    std::string& why, vtkNBufferExtremum rounding = vtkNBufferExtremum::Maximum) const;
};

VTK_ABI_NAMESPACE_END
#endif
