// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTarget.h"

#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// What is bound for drawing and reading, as it was.
class ScopedFramebuffers
{
public:
  ScopedFramebuffers()
  {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &this->Draw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &this->Read);
  }
  ~ScopedFramebuffers()
  {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Draw);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, this->Read);
  }
  ScopedFramebuffers(const ScopedFramebuffers&) = delete;
  void operator=(const ScopedFramebuffers&) = delete;

private:
  int Draw = 0;
  int Read = 0;
};
}

bool vtkShadowTarget::Reserve(
  vtkOpenGLRenderWindow* window, int width, int height, int masks, std::string& why)
{
  if (width <= this->Width && height <= this->Height && masks <= this->GetNumberOfMasks())
  {
    return true;
  }
  const ScopedFramebuffers bindings;
  vtkNBufferGL::ClearErrors();
  const int count = std::max(masks, this->GetNumberOfMasks());
  if (width > this->Width || height > this->Height)
  {
    const int newWidth = std::max(width, this->Width);
    const int newHeight = std::max(height, this->Height);
    this->Release();
    this->Width = newWidth;
    this->Height = newHeight;
    if (!this->AllocateDepth(why))
    {
      this->Release();
      return false;
    }
  }
  while (this->GetNumberOfMasks() < count)
  {
    this->Masks.emplace_back();
    if (!this->AllocateMask(window, this->Masks.back(), why))
    {
      this->Release();
      return false;
    }
  }
  return true;
}

bool vtkShadowTarget::AllocateDepth(std::string& why)
{
  int bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  {
    const vtkNBufferGL::ScopedUpload nothing(0);
    glGenTextures(1, &this->DepthStencil);
    glBindTexture(GL_TEXTURE_2D, this->DepthStencil);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, this->Width, this->Height, 0,
      GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, nullptr);
  }
  glBindTexture(GL_TEXTURE_2D, bound);
  ++this->Allocations;
  if (!vtkNBufferGL::CheckErrors("Allocating depth and stencil", why))
  {
    return false;
  }
  glGenFramebuffers(1, &this->DepthFramebuffer);
  return this->Attach(this->DepthFramebuffer, 0, why);
}

bool vtkShadowTarget::AllocateMask(vtkOpenGLRenderWindow* window, Mask& mask, std::string& why)
{
  mask.Texture = vtkSmartPointer<vtkTextureObject>::New();
  mask.Texture->SetContext(window);
  mask.Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  mask.Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  mask.Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  mask.Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  if (!mask.Texture->Allocate2D(this->Width, this->Height, 4, VTK_UNSIGNED_CHAR) ||
    !vtkNBufferGL::CheckErrors("Allocating a shadow mask", why))
  {
    return false;
  }
  ++this->Allocations;
  glGenFramebuffers(1, &mask.Framebuffer);
  return this->Attach(mask.Framebuffer, mask.Texture->GetHandle(), why);
}

bool vtkShadowTarget::Attach(unsigned int framebuffer, unsigned int color, std::string& why)
{
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, this->DepthStencil, 0);
  if (color != 0)
  {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
  }
  const GLenum buffer = color != 0 ? GL_COLOR_ATTACHMENT0 : GL_NONE;
  glDrawBuffers(1, &buffer);
  glReadBuffer(buffer);
  int stencilBits = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_STENCIL_ATTACHMENT,
    GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, &stencilBits);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE || stencilBits < 8)
  {
    vtkNBufferGL::ClearErrors();
    why = "The device cannot draw with 24 bits of depth and 8 of stencil in a texture. Update the "
          "driver or use Mesa's software renderer.";
    return false;
  }
  return vtkNBufferGL::CheckErrors("Attaching depth and stencil", why);
}

void vtkShadowTarget::Release()
{
  for (const Mask& mask : this->Masks)
  {
    glDeleteFramebuffers(1, &mask.Framebuffer);
    mask.Texture->ReleaseGraphicsResources(mask.Texture->GetContext());
  }
  this->Masks.clear();
  glDeleteFramebuffers(1, &this->DepthFramebuffer);
  glDeleteTextures(1, &this->DepthStencil);
  this->DepthFramebuffer = this->DepthStencil = 0;
  this->Width = this->Height = 0;
}
VTK_ABI_NAMESPACE_END
