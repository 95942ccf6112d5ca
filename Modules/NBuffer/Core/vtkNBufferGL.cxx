// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <map>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// What can discard fragments of a full-screen triangle or change what they write. A clip plane is
// undefined while the vertex shader writes no distance; VTK uses the first six. Blending is apart:
// it is a property of each draw buffer.
constexpr GLenum CapabilityNames[] = { GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST,
  GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_RASTERIZER_DISCARD, GL_POLYGON_SMOOTH, GL_CLIP_DISTANCE0,
  GL_CLIP_DISTANCE0 + 1, GL_CLIP_DISTANCE0 + 2, GL_CLIP_DISTANCE0 + 3, GL_CLIP_DISTANCE0 + 4,
  GL_CLIP_DISTANCE0 + 5 };

constexpr GLenum Targets[] = { GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_2D_MULTISAMPLE };
constexpr GLenum TargetBindings[] = { GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_2D_ARRAY,
  GL_TEXTURE_BINDING_2D_MULTISAMPLE };

// OpenGL 4.3; VTK's oldest loaders may not name it.
constexpr GLenum DepthStencilTextureMode = 0x90EA;

const char* GetErrorName(GLenum error)
{
  static const std::map<GLenum, const char*> names = { { GL_INVALID_ENUM, "GL_INVALID_ENUM" },
    { GL_INVALID_VALUE, "GL_INVALID_VALUE" }, { GL_INVALID_OPERATION, "GL_INVALID_OPERATION" },
    { GL_INVALID_FRAMEBUFFER_OPERATION, "GL_INVALID_FRAMEBUFFER_OPERATION" },
    { GL_OUT_OF_MEMORY, "GL_OUT_OF_MEMORY" } };
  const auto found = names.find(error);
  return found != names.end() ? found->second : "an OpenGL error";
}

bool HasExtension(const char* name)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    const auto* extension = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i));
    if (extension && std::strcmp(extension, name) == 0)
    {
      return true;
    }
  }
  return false;
}
}

namespace vtkNBufferGL
{
bool HasVersion(int major, int minor)
{
  GLint foundMajor = 0;
  GLint foundMinor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &foundMajor);
  glGetIntegerv(GL_MINOR_VERSION, &foundMinor);
  return foundMajor > major || (foundMajor == major && foundMinor >= minor);
}

bool CheckVersion(std::string& why)
{
  if (HasVersion(3, 2))
  {
    return true;
  }
  why = "The OpenGL context is older than 3.2. Update the driver or use Mesa's software renderer.";
  return false;
}

const char* GetSoftwareRenderer()
{
  static const std::array<const char*, 6> names = { "llvmpipe", "softpipe", "swrast",
    "Software Rasterizer", "SwiftShader", "Microsoft Basic Render" };
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const auto found = std::find_if(names.begin(), names.end(),
    [renderer](const char* name) { return renderer && std::strstr(renderer, name); });
  return found == names.end() ? nullptr : *found;
}

bool CoversTouchedPixels()
{
  // The enumerator of each extension, which is an error where the extension is missing.
  constexpr std::pair<const char*, GLenum> conservative[] = {
    { "GL_NV_conservative_raster", 0x9346 }, { "GL_INTEL_conservative_rasterization", 0x83FE }
  };
  return glIsEnabled(GL_POLYGON_SMOOTH) == GL_TRUE ||
    std::any_of(std::begin(conservative), std::end(conservative),
      [](const auto& extension)
      { return HasExtension(extension.first) && glIsEnabled(extension.second) == GL_TRUE; });
}

int GetSubpixelBits()
{
  GLint bits = 0;
  glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
  return std::clamp(static_cast<int>(bits), 4, 8);
}

bool KeepsToScissor(int samples)
{
  return samples <= 1 || !GetSoftwareRenderer();
}

void ClearErrors()
{
  // A lost context reports errors without end.
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
}

bool CheckErrors(const char* where, std::string& why)
{
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR)
  {
    return true;
  }
  why = std::string(where) + ": OpenGL reports " + GetErrorName(error) +
    (error == GL_OUT_OF_MEMORY
        ? ". Make the render window smaller or call SetMultiSamples(0) on it."
        : ". A driver update may help.");
  ClearErrors();
  return false;
}

void SetMatrix(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix)
{
  glm::mat4 rounded(matrix);
  program->SetUniformMatrix4x4(name, glm::value_ptr(rounded));
}

ScopedFramebuffers::ScopedFramebuffers()
{
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &this->Draw);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &this->Read);
}

ScopedFramebuffers::~ScopedFramebuffers()
{
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Draw);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, this->Read);
}

struct ScopedTransfer::Direction
{
  GLenum Target;
  GLenum Binding;
  int Count;
  GLenum Names[MaximumCount];
};

const ScopedTransfer::Direction ScopedTransfer::Pack = { GL_PIXEL_PACK_BUFFER,
  GL_PIXEL_PACK_BUFFER_BINDING, 6,
  { GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
    GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST } };

const ScopedTransfer::Direction ScopedTransfer::Unpack = { GL_PIXEL_UNPACK_BUFFER,
  GL_PIXEL_UNPACK_BUFFER_BINDING, 8,
  { GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
    GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES } };

ScopedTransfer::ScopedTransfer(const Direction& direction, unsigned int buffer)
  : Parameters(direction)
{
  glGetIntegerv(direction.Binding, &this->Buffer);
  glBindBuffer(direction.Target, buffer);
  for (int i = 0; i < direction.Count; ++i)
  {
    glGetIntegerv(direction.Names[i], &this->Values[i]);
    // The first is the alignment, the others are 0 for rows that are tightly packed.
    glPixelStorei(direction.Names[i], i == 0 ? 4 : 0);
  }
}

ScopedTransfer::~ScopedTransfer()
{
  for (int i = 0; i < this->Parameters.Count; ++i)
  {
    glPixelStorei(this->Parameters.Names[i], this->Values[i]);
  }
  glBindBuffer(this->Parameters.Target, this->Buffer);
}

ScopedReadback::ScopedReadback(unsigned int readFramebuffer, unsigned int packBuffer)
  : ScopedTransfer(Pack, packBuffer)
{
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &this->ReadFramebuffer);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, readFramebuffer);
}

ScopedReadback::~ScopedReadback()
{
  glBindFramebuffer(GL_READ_FRAMEBUFFER, this->ReadFramebuffer);
}

ScopedPass::ScopedPass(vtkOpenGLRenderWindow* window)
  : Window(window)
  , Shader(window->GetShaderCache()->GetLastShaderBound())
{
  static_assert(std::size(CapabilityNames) == CapabilityCount &&
      std::size(Targets) == TargetCount && std::size(TargetBindings) == TargetCount,
    "one element for each value to restore");
  for (int i = 0; i < CapabilityCount; ++i)
  {
    this->Capabilities[i] = glIsEnabled(CapabilityNames[i]) == GL_TRUE;
    if (this->Capabilities[i])
    {
      glDisable(CapabilityNames[i]);
    }
  }
  this->Blend = glIsEnabledi(GL_BLEND, 0) == GL_TRUE;
  glDisablei(GL_BLEND, 0);
  glGetBooleani_v(GL_COLOR_WRITEMASK, 0, this->ColorMask);
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glGetIntegerv(GL_POLYGON_MODE, this->PolygonMode);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);

  glGetIntegerv(GL_VIEWPORT, this->Viewport);
  glGetIntegerv(GL_CURRENT_PROGRAM, &this->Program);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &this->VertexArray);

  glGetIntegerv(GL_ACTIVE_TEXTURE, &this->ActiveTexture);
  glActiveTexture(GL_TEXTURE0);
  for (int i = 0; i < TargetCount; ++i)
  {
    glGetIntegerv(TargetBindings[i], &this->Textures[i]);
  }
  if (HasVersion(3, 3))
  {
    glGetIntegerv(GL_SAMPLER_BINDING, &this->Sampler);
    if (this->Sampler != 0)
    {
      // A sampler object hides the parameters of the texture.
      glBindSampler(0, 0);
    }
  }
}

ScopedPass::~ScopedPass()
{
  if (this->Sampler != 0)
  {
    glBindSampler(0, this->Sampler);
  }
  for (int i = 0; i < TargetCount; ++i)
  {
    glBindTexture(Targets[i], this->Textures[i]);
  }
  glActiveTexture(this->ActiveTexture);

  // The shader cache remembers which program is bound; foreign code may have bound another.
  if (this->Shader)
  {
    this->Window->GetShaderCache()->ReadyShaderProgram(this->Shader);
  }
  else
  {
    this->Window->GetShaderCache()->ReleaseCurrentShader();
  }
  glUseProgram(this->Program);
  glBindVertexArray(this->VertexArray);
  glViewport(this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);

  // A core profile has one polygon mode for both faces.
  glPolygonMode(GL_FRONT_AND_BACK, this->PolygonMode[0]);
  glColorMaski(0, this->ColorMask[0], this->ColorMask[1], this->ColorMask[2], this->ColorMask[3]);
  if (this->Blend)
  {
    glEnablei(GL_BLEND, 0);
  }
  for (int i = 0; i < CapabilityCount; ++i)
  {
    if (this->Capabilities[i])
    {
      glEnable(CapabilityNames[i]);
    }
  }
}

ScopedBlend::ScopedBlend(unsigned int equation, unsigned int source, unsigned int destination)
{
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->Equations[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->Equations[1]);
  glGetIntegerv(GL_BLEND_SRC_RGB, &this->Factors[0]);
  glGetIntegerv(GL_BLEND_DST_RGB, &this->Factors[1]);
  glGetIntegerv(GL_BLEND_SRC_ALPHA, &this->Factors[2]);
  glGetIntegerv(GL_BLEND_DST_ALPHA, &this->Factors[3]);
  glBlendEquation(equation);
  glBlendFunc(source, destination);
  glEnablei(GL_BLEND, 0);
}

ScopedBlend::~ScopedBlend()
{
  glDisablei(GL_BLEND, 0);
  glBlendEquationSeparate(this->Equations[0], this->Equations[1]);
  const int* f = this->Factors;
  glBlendFuncSeparate(f[0], f[1], f[2], f[3]);
}

ScopedDepthSampling::ScopedDepthSampling(unsigned int target, int level)
  : Target(target)
{
  if (HasVersion(4, 3))
  {
    this->Set(DepthStencilTextureMode, GL_DEPTH_COMPONENT);
  }
  if (target == GL_TEXTURE_2D_MULTISAMPLE)
  {
    // Multisampled textures have no sampler state.
    return;
  }
  this->Set(GL_TEXTURE_COMPARE_MODE, GL_NONE);
  this->Set(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  this->Set(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  // The order keeps base <= maximum on the way.
  this->Set(GL_TEXTURE_BASE_LEVEL, 0);
  this->Set(GL_TEXTURE_MAX_LEVEL, level);
  this->Set(GL_TEXTURE_BASE_LEVEL, level);
}

ScopedDepthSampling::~ScopedDepthSampling()
{
  for (int i = this->Count - 1; i >= 0; --i)
  {
    glTexParameteri(this->Target, this->Names[i], this->Values[i]);
  }
}

void ScopedDepthSampling::Set(unsigned int name, int value)
{
  this->Names[this->Count] = name;
  glGetTexParameteriv(this->Target, name, &this->Values[this->Count]);
  ++this->Count;
  glTexParameteri(this->Target, name, value);
}
}
VTK_ABI_NAMESPACE_END
