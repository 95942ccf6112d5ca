// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferGLObject.h"

#include "vtkNBufferGL.h"

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
struct Functions
{
  void (*Generate)(GLuint*);
  void (*Delete)(GLuint*);
};

/// The functions of OpenGL for each ObjectType. They are wrapped because their addresses are known
/// only after OpenGL has been loaded.
constexpr Functions FunctionsOf[] = {
  { [](GLuint* name) { glGenBuffers(1, name); }, [](GLuint* name) { glDeleteBuffers(1, name); } },
  { [](GLuint* name) { glGenFramebuffers(1, name); },
    [](GLuint* name) { glDeleteFramebuffers(1, name); } },
  { [](GLuint* name) { glGenQueries(1, name); }, [](GLuint* name) { glDeleteQueries(1, name); } },
  { [](GLuint* name) { glGenTextures(1, name); }, [](GLuint* name) { glDeleteTextures(1, name); } },
  { [](GLuint* name) { glGenVertexArrays(1, name); },
    [](GLuint* name) { glDeleteVertexArrays(1, name); } },
};

/// The format and type of texels in host memory, which OpenGL requires even if none are passed.
std::pair<GLenum, GLenum> GetTransferFormat(GLenum sizedFormat)
{
  switch (sizedFormat)
  {
    case GL_R32F:
      return { GL_RED, GL_FLOAT };
    case GL_R32UI:
      return { GL_RED_INTEGER, GL_UNSIGNED_INT };
    case GL_RGBA8:
      return { GL_RGBA, GL_UNSIGNED_BYTE };
    case GL_DEPTH24_STENCIL8:
      return { GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8 };
    case GL_DEPTH32F_STENCIL8:
      return { GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV };
    default:
      return { GL_DEPTH_COMPONENT, GL_FLOAT };
  }
}
}

namespace vtkNBufferGL
{
Object::Object(Object&& other) noexcept
  : Type(other.Type)
  , Name(std::exchange(other.Name, 0u))
{
}

Object& Object::operator=(Object&& other) noexcept
{
  if (this != &other)
  {
    this->Delete();
    this->Type = other.Type;
    this->Name = std::exchange(other.Name, 0u);
  }
  return *this;
}

unsigned int Object::Create()
{
  if (this->Name == 0)
  {
    FunctionsOf[static_cast<int>(this->Type)].Generate(&this->Name);
  }
  return this->Name;
}

void Object::Delete(Context context)
{
  if (this->Name != 0 && context == Context::Current)
  {
    FunctionsOf[static_cast<int>(this->Type)].Delete(&this->Name);
  }
  this->Name = 0;
}

bool GrowingTexture::Reserve(unsigned int format, int width, int height, std::string& why)
{
  if (format == this->Format && width <= this->Width && height <= this->Height)
  {
    return true;
  }
  const int bound = GetInteger(GL_TEXTURE_BINDING_2D);
  glBindTexture(GL_TEXTURE_2D, this->Texture.Create());
  SetPlainSampling(GL_TEXTURE_2D);
  this->Format = format;
  this->Width = std::max(width, this->Width);
  this->Height = std::max(height, this->Height);
  const auto [components, type] = GetTransferFormat(format);
  {
    const ScopedUpload nothing(0);
    glTexImage2D(GL_TEXTURE_2D, 0, format, this->Width, this->Height, 0, components, type, nullptr);
  }
  glBindTexture(GL_TEXTURE_2D, bound);
  ++this->Allocations;
  if (!CheckErrors("Allocating a texture", why))
  {
    this->Format = 0;
    this->Width = this->Height = 0;
    return false;
  }
  return true;
}

bool GrowingTexture::ReserveTarget(unsigned int format, int width, int height, std::string& why)
{
  if (!this->Reserve(format, width, height, why))
  {
    return false;
  }
  if (this->Framebuffer.GetName() != 0)
  {
    return true;
  }
  const ScopedFramebuffers bindings;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer.Create());
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Texture.GetName(), 0);
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    this->Delete();
    ClearErrors();
    why = "The device cannot draw into a texture of this format. Update the driver or call "
          "SetMultiSamples(0) on the render window.";
    return false;
  }
  return CheckErrors("Attaching a texture", why);
}

void GrowingTexture::Delete(Context context)
{
  this->Framebuffer.Delete(context);
  this->Texture.Delete(context);
  this->Format = 0;
  this->Width = this->Height = 0;
}

void SetPlainSampling(unsigned int target)
{
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_BASE_LEVEL, 0);
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}

}
VTK_ABI_NAMESPACE_END
