// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// The capabilities that can discard fragments of a full-screen triangle or change what they write.
// A clip distance (VTK uses the first six) is undefined if the vertex shader does not write it.
// Blending is not in this list, because each draw buffer has a switch of its own.
constexpr GLenum Capabilities[] = { GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST,
  GL_COLOR_LOGIC_OP, GL_RASTERIZER_DISCARD, GL_POLYGON_SMOOTH, GL_CLIP_DISTANCE0,
  GL_CLIP_DISTANCE0 + 1, GL_CLIP_DISTANCE0 + 2, GL_CLIP_DISTANCE0 + 3, GL_CLIP_DISTANCE0 + 4,
  GL_CLIP_DISTANCE0 + 5 };

// The targets to which passes bind textures, and the state variables of these bindings.
constexpr std::pair<GLenum, GLenum> Targets[] = { { GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D },
  { GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY },
  { GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE } };

// GL_DEPTH_STENCIL_TEXTURE_MODE of OpenGL 4.3, which VTK's oldest loaders may not declare.
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
  const GLint count = vtkNBufferGL::GetInteger(GL_NUM_EXTENSIONS);
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
int GetInteger(unsigned int name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

bool HasVersion(int major, int minor)
{
  const std::pair<int, int> found = { GetInteger(GL_MAJOR_VERSION), GetInteger(GL_MINOR_VERSION) };
  return found >= std::make_pair(major, minor);
}

bool HasFeature(int major, int minor, const char* extension)
{
  return HasVersion(major, minor) || HasExtension(extension);
}

bool IsCountingSamples()
{
  const auto isRunning = [](GLenum target)
  {
    int query = 0;
    glGetQueryiv(target, GL_CURRENT_QUERY, &query);
    return query != 0;
  };
  return isRunning(GL_SAMPLES_PASSED) ||
    (HasFeature(3, 3, "GL_ARB_occlusion_query2") && isRunning(GL_ANY_SAMPLES_PASSED)) ||
    (HasFeature(4, 3, "GL_ARB_ES3_compatibility") && isRunning(GL_ANY_SAMPLES_PASSED_CONSERVATIVE));
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

/// Whether the current context is that of Mesa's softpipe, which breaks three of OpenGL's promises.
static bool IsSoftpipe()
{
  const char* software = GetSoftwareRenderer();
  return software && std::strcmp(software, "softpipe") == 0;
}

bool KeepsColorsWhenRead()
{
  return !IsSoftpipe();
}

bool OffsetsBeyondFarPlane()
{
  return !IsSoftpipe();
}

bool ComputesDoubles()
{
  return !IsSoftpipe();
}

bool CoversTouchedPixels(vtkOpenGLRenderWindow* window)
{
  // Extensions and their capabilities. It is an error to query one whose extension is missing.
  constexpr std::pair<const char*, GLenum> conservative[] = {
    { "GL_NV_conservative_raster", 0x9346 }, { "GL_INTEL_conservative_rasterization", 0x83FE }
  };
  // Looking for extensions takes 0.07 ms, so that it is done only where the context is another one
  // than in the last call.
  static thread_local vtkMTimeType contextTime = 0;
  static thread_local std::vector<GLenum> capabilities;
  if (contextTime != window->GetContextCreationTime())
  {
    contextTime = window->GetContextCreationTime();
    capabilities = { GL_POLYGON_SMOOTH };
    for (const auto& [extension, capability] : conservative)
    {
      if (HasExtension(extension))
      {
        capabilities.push_back(capability);
      }
    }
  }
  return std::any_of(capabilities.begin(), capabilities.end(),
    [](GLenum capability) { return glIsEnabled(capability) == GL_TRUE; });
}

int GetSubpixelBits()
{
  return std::clamp<int>(GetInteger(GL_SUBPIXEL_BITS), 4, 8);
}

SamplePlaces GetSamplePlaces()
{
  const int count = GetInteger(GL_SAMPLES);
  if (count < 2)
  {
    return { { { 0.5, 0.5 } } };
  }
  SamplePlaces places;
  for (int i = 0; i < count; ++i)
  {
    float place[2] = { 0.5f, 0.5f };
    glGetMultisamplefv(GL_SAMPLE_POSITION, i, place);
    places.push_back({ place[0], place[1] });
  }
  return places;
}

bool DrawsStraySamples()
{
  return GetSoftwareRenderer();
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

Scope::~Scope()
{
  std::for_each(this->Changes.rbegin(), this->Changes.rend(), [](const auto& undo) { undo(); });
}

void Scope::SaveFramebuffers()
{
  this->AtEnd(
    [draw = GetInteger(GL_DRAW_FRAMEBUFFER_BINDING), read = GetInteger(GL_READ_FRAMEBUFFER_BINDING)]
    {
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw);
      glBindFramebuffer(GL_READ_FRAMEBUFFER, read);
    });
}

void Scope::SetTransfer(
  GLenum target, GLenum binding, std::initializer_list<GLenum> parameters, unsigned int buffer)
{
  this->AtEnd([target, bound = GetInteger(binding)] { glBindBuffer(target, bound); });
  glBindBuffer(target, buffer);
  for (const GLenum name : parameters)
  {
    this->AtEnd([name, value = GetInteger(name)] { glPixelStorei(name, value); });
    // The first one is the alignment. The others are 0 for tightly packed rows.
    glPixelStorei(name, name == *parameters.begin() ? 4 : 0);
  }
}

ScopedReadback::ScopedReadback(unsigned int readFramebuffer, unsigned int packBuffer)
{
  this->SetTransfer(GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING,
    { GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
      GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST },
    packBuffer);
  this->SaveFramebuffers();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, readFramebuffer);
}

ScopedUpload::ScopedUpload(unsigned int unpackBuffer)
{
  this->SetTransfer(GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING,
    { GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
      GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES },
    unpackBuffer);
}

ScopedPass::ScopedPass(vtkOpenGLRenderWindow* window)
{
  this->SaveFramebuffers();
  for (const GLenum name : Capabilities)
  {
    if (glIsEnabled(name))
    {
      this->AtEnd([name] { glEnable(name); });
      glDisable(name);
    }
  }
  if (glIsEnabledi(GL_BLEND, 0))
  {
    this->AtEnd([] { glEnablei(GL_BLEND, 0); });
    glDisablei(GL_BLEND, 0);
  }
  std::array<GLboolean, 4> mask{};
  glGetBooleani_v(GL_COLOR_WRITEMASK, 0, mask.data());
  this->AtEnd([mask] { glColorMaski(0, mask[0], mask[1], mask[2], mask[3]); });
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  // A core profile has one polygon mode for both faces.
  std::array<GLint, 2> polygonMode{};
  glGetIntegerv(GL_POLYGON_MODE, polygonMode.data());
  this->AtEnd([mode = polygonMode[0]] { glPolygonMode(GL_FRONT_AND_BACK, mode); });
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);

  std::array<GLint, 4> viewport{};
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  this->AtEnd([viewport] { glViewport(viewport[0], viewport[1], viewport[2], viewport[3]); });
  this->AtEnd([name = GetInteger(GL_VERTEX_ARRAY_BINDING)] { glBindVertexArray(name); });
  // The shader cache remembers which program is bound; foreign code may have bound another.
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  this->AtEnd([program = GetInteger(GL_CURRENT_PROGRAM)] { glUseProgram(program); });
  this->AtEnd(
    [cache, shader = cache->GetLastShaderBound()] {
      shader ? static_cast<void>(cache->ReadyShaderProgram(shader)) : cache->ReleaseCurrentShader();
    });

  this->AtEnd([unit = GetInteger(GL_ACTIVE_TEXTURE)] { glActiveTexture(unit); });
  glActiveTexture(GL_TEXTURE0);
  for (const auto& [target, binding] : Targets)
  {
    this->AtEnd([target = target, name = GetInteger(binding)] { glBindTexture(target, name); });
  }
  const GLint sampler =
    HasFeature(3, 3, "GL_ARB_sampler_objects") ? GetInteger(GL_SAMPLER_BINDING) : 0;
  if (sampler != 0)
  {
    // A sampler object hides the parameters of the texture.
    this->AtEnd([sampler] { glBindSampler(0, sampler); });
    glBindSampler(0, 0);
  }
}

ScopedBlend::ScopedBlend(unsigned int equation, unsigned int source, unsigned int destination)
{
  this->AtEnd([] { glDisablei(GL_BLEND, 0); });
  this->AtEnd(
    [color = GetInteger(GL_BLEND_EQUATION_RGB), alpha = GetInteger(GL_BLEND_EQUATION_ALPHA)]
    { glBlendEquationSeparate(color, alpha); });
  this->AtEnd([source = GetInteger(GL_BLEND_SRC_RGB), destination = GetInteger(GL_BLEND_DST_RGB),
                sourceAlpha = GetInteger(GL_BLEND_SRC_ALPHA),
                destinationAlpha = GetInteger(GL_BLEND_DST_ALPHA)]
    { glBlendFuncSeparate(source, destination, sourceAlpha, destinationAlpha); });
  glBlendEquation(equation);
  glBlendFunc(source, destination);
  glEnablei(GL_BLEND, 0);
}

ScopedDepthSampling::ScopedDepthSampling(unsigned int target, int level)
{
  const auto set = [this, target](GLenum name, GLint value)
  {
    GLint before = 0;
    glGetTexParameteriv(target, name, &before);
    this->AtEnd([=] { glTexParameteri(target, name, before); });
    glTexParameteri(target, name, value);
  };
  if (HasFeature(4, 3, "GL_ARB_stencil_texturing"))
  {
    set(DepthStencilTextureMode, GL_DEPTH_COMPONENT);
  }
  if (target == GL_TEXTURE_2D_MULTISAMPLE)
  {
    // Multisampled textures have no sampler state.
    return;
  }
  set(GL_TEXTURE_COMPARE_MODE, GL_NONE);
  set(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  set(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  // In this order the base level never exceeds the maximum level.
  set(GL_TEXTURE_BASE_LEVEL, 0);
  set(GL_TEXTURE_MAX_LEVEL, level);
  set(GL_TEXTURE_BASE_LEVEL, level);
}
}
VTK_ABI_NAMESPACE_END
