// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferGL.h
 * @brief OpenGL for this module's sources: the loader, error checks and scopes that restore state.
 *
 * Every scope reads the state from OpenGL itself when it begins and restores exactly that when it
 * ends. vtkOpenGLState, VTK's cache of the state, is then as right or as wrong as it was before.
 */
#ifndef vtkNBufferGL_h
#define vtkNBufferGL_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include VTKNBUFFER_GL_HEADER

#include <array>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace vtkNBufferGL
{
/// The value of a state variable that is one integer; 0 if the current context does not know it.
VTKNBUFFER_EXPORT int GetInteger(unsigned int name);

/// Whether the current context has at least this version of OpenGL.
VTKNBUFFER_EXPORT bool HasVersion(int major, int minor);

/// Whether the current context has a feature that this version of OpenGL contains and that this
/// extension adds to older ones. VTK requests OpenGL 3.2, and some drivers give exactly that.
VTKNBUFFER_EXPORT bool HasFeature(int major, int minor, const char* extension);

/// Whether a query that counts samples, or finds out whether any is drawn, is running. No other one
/// can begin then (OpenGL 4.6, section 4.2.1).
VTKNBUFFER_EXPORT bool IsCountingSamples();

/// Whether the current context has OpenGL 3.2, which everything in this module needs. If it has
/// not, `why` receives the cause and a remedy.
VTKNBUFFER_EXPORT bool CheckVersion(std::string& why);

/// The name of the software renderer (llvmpipe, ...) behind the current context; nullptr if the
/// context has a graphics device.
VTKNBUFFER_EXPORT const char* GetSoftwareRenderer();

/// Whether reading the depth leaves the colours as they are, as OpenGL promises. Mesa's softpipe
/// keeps colours as floats until something is read, and rounds them to the framebuffer's format
/// only then, so that what is blended later has another result than without the read.
VTKNBUFFER_EXPORT bool KeepsColorsWhenRead();

/// Whether a polygon offset leaves depths beyond the far plane as they are until fragments are
/// drawn, as OpenGL promises (4.6, section 14.6.5). Mesa's softpipe adds the offset to the corners
/// of a triangle and clamps each of them to [0, 1], which bends triangles that reach farther.
VTKNBUFFER_EXPORT bool OffsetsBeyondFarPlane();

/// Whether shaders compute with doubles as OpenGL promises (GLSL 4.60, section 4.7.1). Mesa's
/// softpipe rounds some results wrongly.
VTKNBUFFER_EXPORT bool ComputesDoubles();

/// Whether the current context, that of the window, draws a fragment in each pixel that a triangle
/// touches, and not only where a sample lies in the triangle: with smoothed polygons and
/// conservative rasterisation.
VTKNBUFFER_EXPORT bool CoversTouchedPixels(vtkOpenGLRenderWindow* window);

/// The number of subpixel bits of the grid to which the current context snaps vertices, clamped to
/// 4 (OpenGL requires no less) to 8 (a finer grid gains nothing).
VTKNBUFFER_EXPORT int GetSubpixelBits();

/// The places of samples in a pixel, in [0, 1] from its lower left corner. A single sample is in
/// the middle.
using SamplePlaces = std::vector<std::array<double, 2>>;

/// The places of the samples of the framebuffer that is bound for drawing.
VTKNBUFFER_EXPORT SamplePlaces GetSamplePlaces();

/// Whether the current context's renderer may draw samples of a triangle of almost no height nearer
/// than all of its corners (vtkNBufferSliverTest). Mesa's llvmpipe (22.3 and 25.0) does, and
/// graphics devices do not.
VTKNBUFFER_EXPORT bool DrawsStraySamples();

/// Whether the current context's renderer draws inside a scissor box only, where a pixel has
/// `samples` samples. With several samples llvmpipe (Mesa 22.3) also draws some samples of the row
/// below the box.
VTKNBUFFER_EXPORT bool KeepsToScissor(int samples);

/// Discard the errors of earlier calls of OpenGL, so that CheckErrors() reports only later ones.
VTKNBUFFER_EXPORT void ClearErrors();

/// Whether OpenGL has reported no error since ClearErrors(). If there is one, `why` receives
/// `where`, the name of the error and a remedy.
VTKNBUFFER_EXPORT bool CheckErrors(const char* where, std::string& why);

/// Set a uniform mat4 of the current program.
VTKNBUFFER_EXPORT void SetMatrix(
  vtkShaderProgram* program, const char* name, const glm::dmat4& matrix);

/**
 * When a scope ends, it undoes changes of the state, the last change first, even if an observer of
 * the application throws an exception. It is the base class of the scopes below.
 */
class VTKNBUFFER_EXPORT Scope
{
public:
  Scope() = default;
  ~Scope();
  Scope(const Scope&) = delete;
  void operator=(const Scope&) = delete;

  /// Call undo() when the scope ends.
  void AtEnd(std::function<void()> undo) { this->Changes.push_back(std::move(undo)); }

protected:
  /// Restore the current framebuffer bindings when the scope ends.
  void SaveFramebuffers();

  /// Transfer pixels with tightly packed rows until the scope ends, to or from a buffer object, or
  /// host memory if `buffer` is 0. `target` and `binding` are the target of the buffer and the
  /// state variable of its binding. `parameters` are the parameters of glPixelStore for this
  /// direction; the alignment must be the first.
  void SetTransfer(
    GLenum target, GLenum binding, std::initializer_list<GLenum> parameters, unsigned int buffer);

private:
  std::vector<std::function<void()>> Changes;
};

/// While it lives, code may bind other framebuffers; the bindings are restored when it ends.
class VTKNBUFFER_EXPORT ScopedFramebuffers : public Scope
{
public:
  ScopedFramebuffers() { this->SaveFramebuffers(); }
};

/// While it lives, glReadPixels() reads `readFramebuffer` into host memory or into `packBuffer`,
/// with rows tightly packed.
class VTKNBUFFER_EXPORT ScopedReadback : public Scope
{
public:
  explicit ScopedReadback(unsigned int readFramebuffer, unsigned int packBuffer = 0);
};

/// While it lives, textures receive texels from host memory or from `unpackBuffer`, with rows
/// tightly packed.
class VTKNBUFFER_EXPORT ScopedUpload : public Scope
{
public:
  explicit ScopedUpload(unsigned int unpackBuffer);
};

/**
 * The state for full-screen passes: while it lives, no state that the renderer left behind discards
 * a fragment or changes what the shader writes. Texture unit 0 is active. The user of the scope may
 * change the framebuffer bindings, the viewport, the program, the vertex array and what is bound to
 * unit 0; the scope restores them.
 */
class VTKNBUFFER_EXPORT ScopedPass : public Scope
{
public:
  explicit ScopedPass(vtkOpenGLRenderWindow* window);
};

/**
 * Within a ScopedPass: while it lives, fragments are blended into the first colour attachment, with
 * one equation and the same factors for colour and alpha.
 */
class VTKNBUFFER_EXPORT ScopedBlend : public Scope
{
public:
  ScopedBlend(unsigned int equation, unsigned int source, unsigned int destination);
};

/**
 * While it lives, shaders read plain depth from the GL_TEXTURE_2D or GL_TEXTURE_2D_MULTISAMPLE that
 * is bound to the active unit: no comparison, no filter, and only the level given. The texture
 * belongs to other code, so its own parameters are restored.
 */
class VTKNBUFFER_EXPORT ScopedDepthSampling : public Scope
{
public:
  ScopedDepthSampling(unsigned int target, int level);
};
}
VTK_ABI_NAMESPACE_END
#endif
