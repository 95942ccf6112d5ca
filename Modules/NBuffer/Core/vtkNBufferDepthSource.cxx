// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDepthSource.h"

#include "Shaders/vtkNBufferShared.h"
#include "vtkNBufferGL.h"
#include "vtkOpenGLRenderWindow.h"

#include <cstdint>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
GLint GetAttachmentParameter(GLenum attachment, GLenum name)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
  return value;
}

/// Set the members that describe a texture with this target. Returns false if the texture has
/// another target.
bool InspectTarget(GLenum target, GLenum bindingName, vtkNBufferDepthSource& source)
{
  const int bound = vtkNBufferGL::GetInteger(bindingName);
  // OpenGL 3.2 cannot be queried for the target of a texture, but binding the texture to another
  // target is an error.
  glBindTexture(target, source.DepthName);
  const bool isTarget = glGetError() == GL_NO_ERROR;
  if (isTarget)
  {
    glGetTexLevelParameteriv(target, source.DepthLevel, GL_TEXTURE_WIDTH, &source.Width);
    glGetTexLevelParameteriv(target, source.DepthLevel, GL_TEXTURE_HEIGHT, &source.Height);
    GLint isFixed = GL_FALSE; // If false, samples may lie elsewhere in other pixels.
    if (source.Samples > 1)
    {
      glGetTexLevelParameteriv(target, 0, GL_TEXTURE_FIXED_SAMPLE_LOCATIONS, &isFixed);
    }
    if (isFixed)
    {
      source.Places = { {}, 0.0 };
      for (const auto& [x, y] : vtkNBufferGL::GetSamplePlaces())
      {
        source.Places.Places.emplace_back(x, y);
      }
    }
    glBindTexture(target, bound);
  }
  return isTarget;
}

/// Set the members of `source` that describe a texture.
bool InspectTexture(vtkNBufferDepthSource& source, std::string& why)
{
  source.Texture = true;
  source.DepthName =
    GetAttachmentParameter(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME);
  source.DepthLevel =
    GetAttachmentParameter(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
  const bool plain =
    GetAttachmentParameter(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_LAYERED) == 0 &&
    GetAttachmentParameter(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER) == 0 &&
    GetAttachmentParameter(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE) ==
      0;
  const bool multisample = source.Samples > 1;
  if (!plain ||
    !InspectTarget(multisample ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D,
      multisample ? GL_TEXTURE_BINDING_2D_MULTISAMPLE : GL_TEXTURE_BINDING_2D, source))
  {
    why = "The depth attachment is a layered, cube, array or rectangle texture, which is not "
          "supported. Attach a GL_TEXTURE_2D or a renderbuffer.";
    return false;
  }
  return true;
}

void InspectRenderbuffer(vtkNBufferDepthSource& source)
{
  source.DepthName =
    GetAttachmentParameter(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME);
  const int bound = vtkNBufferGL::GetInteger(GL_RENDERBUFFER_BINDING);
  glBindRenderbuffer(GL_RENDERBUFFER, source.DepthName);
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &source.Width);
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &source.Height);
  glBindRenderbuffer(GL_RENDERBUFFER, bound);
}

bool InspectFramebuffer(
  vtkOpenGLRenderWindow* window, vtkNBufferDepthSource& source, std::string& why)
{
  source.Framebuffer = vtkNBufferGL::GetInteger(GL_DRAW_FRAMEBUFFER_BINDING);
  source.Samples = vtkNBufferGL::GetInteger(GL_SAMPLES);
  source.Places = source.Samples > 1 ? vtkNBufferSamples::Anywhere() : vtkNBufferSamples();
  glGetIntegerv(GL_VIEWPORT, source.Viewport);
  source.Stored = vtkNBufferDepthSource::GetStoredDepth();

  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    why = "The framebuffer that is being drawn is incomplete. Complete it before rendering.";
    return false;
  }
  const GLenum attachment = source.Framebuffer == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  const GLint kind = GetAttachmentParameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
  if (kind != GL_NONE)
  {
    source.DepthBits = GetAttachmentParameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  }
  if (source.DepthBits == 0)
  {
    why = "The framebuffer that is being drawn has no depth buffer. Attach one.";
    return false;
  }
  source.FloatDepth =
    GetAttachmentParameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
  const GLenum stencil = source.Framebuffer == 0 ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
  source.HasStencil =
    GetAttachmentParameter(stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == kind &&
    (source.Framebuffer == 0 ||
      GetAttachmentParameter(stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) ==
        GetAttachmentParameter(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  if (kind == GL_TEXTURE)
  {
    return InspectTexture(source, why);
  }
  if (kind == GL_RENDERBUFFER)
  {
    InspectRenderbuffer(source);
    return true;
  }
  const int* size = window->GetActualSize();
  source.Width = size[0];
  source.Height = size[1];
  return true;
}

// Reading integers is a copy or a shift in every driver, and compilers vectorise the loops below.
// The integers are converted in the memory into which they were read.
template <typename Convert>
void ConvertInPlace(float* values, std::size_t count, Convert&& convert)
{
  static_assert(sizeof(std::uint32_t) == sizeof(float), "converted in place");
  for (std::size_t i = 0; i < count; ++i)
  {
    std::uint32_t bits;
    std::memcpy(&bits, values + i, sizeof(bits));
    values[i] = convert(bits);
  }
}

void ConvertNormalised(float* values, std::size_t count, int depthBits, vtkNBufferExtremum rounding)
{
  // No integer below exceeds 2^24, so that none is rounded on its way to a float.
  constexpr float unit = static_cast<float>(1.0 / NBUFFER_DEPTH32_SCALE);
  if (depthBits == 24)
  {
    // The upper 24 bits are the depth, whatever the driver filled the lower ones with. This is
    // how Mesa's llvmpipe samples, too.
    ConvertInPlace(values, count,
      [](std::uint32_t bits)
      {
        return static_cast<float>(static_cast<int>(bits >> NBUFFER_DEPTH32_DROPPED_BITS)) *
          static_cast<float>(1.0 / NBUFFER_DEPTH24_LARGEST);
      });
  }
  else if (rounding == vtkNBufferExtremum::Maximum)
  {
    ConvertInPlace(values, count,
      [](std::uint32_t bits)
      {
        return unit *
          static_cast<float>(static_cast<int>(bits >> NBUFFER_DEPTH32_DROPPED_BITS) +
            ((bits & NBUFFER_DEPTH32_DROPPED_MASK) != 0));
      });
  }
  else
  {
    ConvertInPlace(values, count,
      [](std::uint32_t bits)
      {
        return unit *
          static_cast<float>(
            static_cast<int>(bits >> NBUFFER_DEPTH32_DROPPED_BITS) + (bits == 0xFFFFFFFFu));
      });
  }
}
}

vtkNBufferStoredDepth vtkNBufferDepthSource::GetStoredDepth()
{
  GLdouble range[2] = { 0.0, 1.0 };
  glGetDoublev(GL_DEPTH_RANGE, range);
  const int passes = vtkNBufferGL::GetInteger(GL_DEPTH_FUNC);
  const bool hasClipControl = vtkNBufferGL::HasFeature(4, 5, "GL_ARB_clip_control");
  const bool isZeroToOne =
    hasClipControl && vtkNBufferGL::GetInteger(GL_CLIP_DEPTH_MODE) == GL_ZERO_TO_ONE;
  const bool isUpsideDown =
    hasClipControl && vtkNBufferGL::GetInteger(GL_CLIP_ORIGIN) != GL_LOWER_LEFT;
  if (isUpsideDown || range[0] != 0.0 || range[1] != 1.0)
  {
    return vtkNBufferStoredDepth::Other;
  }
  if (isZeroToOne)
  {
    return passes == GL_GEQUAL ? vtkNBufferStoredDepth::Reversed : vtkNBufferStoredDepth::Other;
  }
  return passes == GL_LEQUAL || passes == GL_LESS ? vtkNBufferStoredDepth::Ordinary
                                                  : vtkNBufferStoredDepth::Other;
}

bool vtkNBufferDepthSource::Inspect(vtkOpenGLRenderWindow* window, std::string& why)
{
  *this = vtkNBufferDepthSource();
  int major = 0;
  int minor = 0;
  if (window)
  {
    // This gives 2.0 for a window without a context.
    window->GetOpenGLVersion(major, minor);
  }
  if (major < 3)
  {
    why = "There is no OpenGL context yet. Render the window first.";
    return false;
  }
  vtkNBufferGL::ClearErrors();
  vtkNBufferDepthSource source;
  if (!InspectFramebuffer(window, source, why))
  {
    vtkNBufferGL::ClearErrors();
    return false;
  }
  if (!vtkNBufferGL::CheckErrors("Inspecting the depth buffer", why))
  {
    return false;
  }
  *this = source;
  return true;
}

bool vtkNBufferDepthSource::HoldsViewport() const
{
  const auto& [x, y, width, height] = this->Viewport;
  std::string why;
  return this->Holds(x, y, width, height, why);
}

bool vtkNBufferDepthSource::Holds(int x, int y, int width, int height, std::string& why) const
{
  if (this->DepthBits == 0)
  {
    why = "There is no depth buffer. Call vtkNBufferDepthSource::Inspect first.";
    return false;
  }
  if (width <= 0 || height <= 0 || x < 0 || y < 0 || width > this->Width - x ||
    height > this->Height - y)
  {
    why = "The rectangle of depth is empty or reaches outside the depth buffer. Keep the viewport "
          "inside the framebuffer.";
    return false;
  }
  return true;
}

bool vtkNBufferDepthSource::Read(vtkOpenGLRenderWindow* window, int x, int y, int width, int height,
  std::vector<float>& depth, std::string& why, vtkNBufferExtremum rounding) const
{
  if (!this->Holds(x, y, width, height, why))
  {
    return false;
  }
  depth.resize(static_cast<std::size_t>(width) * height);
  return this->Read(window, x, y, width, height, depth.data(), why, rounding);
}

bool vtkNBufferDepthSource::Read(vtkOpenGLRenderWindow* window, int x, int y, int width, int height,
  float* depth, std::string& why, vtkNBufferExtremum rounding) const
{
  if (!this->Holds(x, y, width, height, why))
  {
    return false;
  }
  if (!window)
  {
    why = "There is no render window. Pass the one that is drawn.";
    return false;
  }
  if (this->Samples > 1)
  {
    why = "A multisampled depth buffer cannot be read sample by sample. Reduce it on the device "
          "(vtkNBufferTexture) or call SetMultiSamples(0) on the render window.";
    return false;
  }
  const bool integers = !this->FloatDepth && (this->DepthBits == 24 || this->DepthBits == 32);
  vtkNBufferGL::ClearErrors();
  {
    vtkNBufferGL::ScopedReadback readback(this->Framebuffer);
    glReadPixels(
      x, y, width, height, GL_DEPTH_COMPONENT, integers ? GL_UNSIGNED_INT : GL_FLOAT, depth);
  }
  if (!vtkNBufferGL::CheckErrors("Reading the depth buffer", why))
  {
    return false;
  }
  if (integers)
  {
    ConvertNormalised(depth, static_cast<std::size_t>(width) * height, this->DepthBits, rounding);
  }
  return true;
}
VTK_ABI_NAMESPACE_END
