// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferGL.h
 * @brief OpenGL for this module's sources: the loader, error checks and what puts state back.
 *
 * Everything here asks OpenGL itself and puts back exactly what it found. vtkOpenGLState, which
 * only remembers, is then as right or as wrong after a scope as it was before.
 */
#ifndef vtkNBufferGL_h
#define vtkNBufferGL_h

#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include VTKNBUFFER_GL_HEADER

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace vtkNBufferGL
{
/// Is the context that is current at least this version?
VTKNBUFFER_EXPORT bool HasVersion(int major, int minor);

/// The name of the renderer of the current context if it runs on the host, or nullptr.
VTKNBUFFER_EXPORT const char* GetSoftwareRenderer();

/// Whether the renderer of the current context keeps to scissor boxes where pixels have `samples`.
/// llvmpipe (Mesa 22.3) draws some of the samples of the row below, too, if there are several.
VTKNBUFFER_EXPORT bool KeepsToScissor(int samples);

/// Drop errors that others left behind, so that those found later are ours.
VTKNBUFFER_EXPORT void ClearErrors();

/// False, with the error and `where` in `why`, if OpenGL has reported an error since.
VTKNBUFFER_EXPORT bool CheckErrors(const char* where, std::string& why);

/// Set a uniform mat4 of the program that is in use from a row-major matrix.
VTKNBUFFER_EXPORT void SetMatrix(
  vtkShaderProgram* program, const char* name, const double rows[16]);

/**
 * Read-back into host memory (or into `packBuffer`), rows tightly packed, from `readFramebuffer`.
 */
class VTKNBUFFER_EXPORT ScopedReadback
{
public:
  explicit ScopedReadback(unsigned int readFramebuffer, unsigned int packBuffer = 0);
  ~ScopedReadback();
  ScopedReadback(const ScopedReadback&) = delete;
  void operator=(const ScopedReadback&) = delete;

private:
  static constexpr int ParameterCount = 6;
  int ReadFramebuffer = 0;
  int PackBuffer = 0;
  int Parameters[ParameterCount] = {};
};

/**
 * Upload into textures from `unpackBuffer` (0: none), rows tightly packed.
 */
class VTKNBUFFER_EXPORT ScopedUpload
{
public:
  explicit ScopedUpload(unsigned int unpackBuffer);
  ~ScopedUpload();
  ScopedUpload(const ScopedUpload&) = delete;
  void operator=(const ScopedUpload&) = delete;

private:
  static constexpr int ParameterCount = 8;
  int UnpackBuffer = 0;
  int Parameters[ParameterCount] = {};
};

/**
 * Full-screen passes into one-channel colour attachments: while it lives, nothing that the
 * renderer left behind keeps a fragment from being written as the shader says. Framebuffer
 * bindings, viewport, program, vertex array and what is bound to texture unit 0, which is active,
 * may be changed freely meanwhile.
 */
class VTKNBUFFER_EXPORT ScopedPass
{
public:
  explicit ScopedPass(vtkOpenGLRenderWindow* window);
  ~ScopedPass();
  ScopedPass(const ScopedPass&) = delete;
  void operator=(const ScopedPass&) = delete;

private:
  static constexpr int CapabilityCount = 13;
  static constexpr int TargetCount = 3;
  vtkOpenGLRenderWindow* Window;
  vtkShaderProgram* Shader;
  bool Capabilities[CapabilityCount] = {};
  bool Blend = false;
  unsigned char ColorMask[4] = {};
  int PolygonMode[2] = {};
  int Viewport[4] = {};
  int DrawFramebuffer = 0;
  int ReadFramebuffer = 0;
  int Program = 0;
  int VertexArray = 0;
  int ActiveTexture = 0;
  int Textures[TargetCount] = {};
  int Sampler = 0;
};

/**
 * What is drawn meanwhile, by VTK or not, is drawn only inside a rectangle. OpenGL guarantees that
 * fragments inside are the same as without it (4.6, appendix A.3, rule 2: scissor parameters).
 */
class VTKNBUFFER_EXPORT ScopedScissor
{
public:
  ScopedScissor();
  ~ScopedScissor();
  ScopedScissor(const ScopedScissor&) = delete;
  void operator=(const ScopedScissor&) = delete;

  /// In pixels of the viewport as it is now. What the renderer's own scissor leaves out stays out.
  void Set(const vtkNBufferRectangle& pixels) const;

private:
  bool Enabled;
  vtkNBufferRectangle Viewport;
  vtkNBufferRectangle Outer; ///< Of the framebuffer: where drawing was confined to before.
  int Box[4] = {};
};

/// Call draw() once for each of the regions, in pixels of the viewport, confined to it; without
/// regions once and not confined. Returns how many times.
template <typename Functor>
int DrawIn(const std::vector<vtkNBufferRectangle>& regions, Functor&& draw)
{
  if (regions.empty())
  {
    draw();
    return 1;
  }
  const ScopedScissor scissor;
  for (const vtkNBufferRectangle& region : regions)
  {
    scissor.Set(region);
    draw();
  }
  return static_cast<int>(regions.size());
}

/**
 * Inside of a ScopedPass: blends into the first colour attachment, with one equation and the same
 * factors for colour and alpha.
 */
class VTKNBUFFER_EXPORT ScopedBlend
{
public:
  ScopedBlend(unsigned int equation, unsigned int source, unsigned int destination);
  ~ScopedBlend();
  ScopedBlend(const ScopedBlend&) = delete;
  void operator=(const ScopedBlend&) = delete;

private:
  int Equations[2] = {};
  int Factors[4] = {};
};

/**
 * The single-level GL_TEXTURE_2D or GL_TEXTURE_2D_MULTISAMPLE bound to the active unit is sampled
 * as plain depth, whatever its owner uses it for: no comparison, no filter, this level only.
 */
class VTKNBUFFER_EXPORT ScopedDepthSampling
{
public:
  ScopedDepthSampling(unsigned int target, int level);
  ~ScopedDepthSampling();
  ScopedDepthSampling(const ScopedDepthSampling&) = delete;
  void operator=(const ScopedDepthSampling&) = delete;

private:
  void Set(unsigned int name, int value);

  static constexpr int MaximumCount = 7;
  unsigned int Target;
  int Count = 0;
  unsigned int Names[MaximumCount] = {};
  int Values[MaximumCount] = {};
};
}
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferGL.h
