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
vtkShadowTarget::SamplePlaces GetCentre()
{
  return { { { 0.5, 0.5 } } };
}

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

vtkShadowTarget::SamplePlaces vtkShadowTarget::GetBoundSamples()
{
  int count = 0;
  glGetIntegerv(GL_SAMPLES, &count);
  if (count < 2)
  {
    return GetCentre();
  }
  SamplePlaces places;
  for (int i = 0; i < count; ++i)
  {
    float place[2] = { 0.0f, 0.0f };
    glGetMultisamplefv(GL_SAMPLE_POSITION, i, place);
    places.push_back({ place[0], place[1] });
  }
  return places;
}

bool vtkShadowTarget::Reserve(vtkOpenGLRenderWindow* window, int width, int height, int masks,
  const SamplePlaces& samples, std::string& why)
{
  if (samples != this->RefusedSamples)
  {
    this->RefusedSamples.clear();
  }
  const SamplePlaces wanted = this->HasRefusedSamples() ? GetCentre() : samples;
  if (width <= this->Width && height <= this->Height && masks <= this->GetNumberOfMasks() &&
    wanted == this->Samples)
  {
    return true;
  }
  const ScopedFramebuffers bindings;
  vtkNBufferGL::ClearErrors();
  const int newWidth = std::max(width, this->Width);
  const int newHeight = std::max(height, this->Height);
  const int count = std::max(masks, this->GetNumberOfMasks());
  if (wanted != this->Samples)
  {
    this->Free();
    this->Samples = wanted;
  }
  bool done = this->Allocate(window, newWidth, newHeight, count, why);
  if (!done && this->IsMultisampled())
  {
    this->Free();
    this->Samples = GetCentre();
    this->RefusedSamples = samples;
    done = this->Allocate(window, newWidth, newHeight, count, why);
  }
  if (!done)
  {
    this->Release();
  }
  return done;
}

bool vtkShadowTarget::Allocate(
  vtkOpenGLRenderWindow* window, int width, int height, int count, std::string& why)
{
  if (width > this->Width || height > this->Height)
  {
    this->Free();
    this->Width = width;
    this->Height = height;
    if (!this->AllocateDepth(window, why))
    {
      return false;
    }
  }
  while (this->GetNumberOfMasks() < count)
  {
    this->Masks.emplace_back();
    if (!this->AllocateMask(window, this->Masks.back(), why))
    {
      return false;
    }
  }
  return true;
}

bool vtkShadowTarget::AllocateDepth(vtkOpenGLRenderWindow* window, std::string& why)
{
  if (this->IsMultisampled())
  {
    this->Depth = this->NewTexture(window);
    this->Depth->AllocateDepthStencil(this->Width, this->Height);
    this->DepthStencil = this->Depth->GetHandle();
  }
  else
  {
    int bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    const vtkNBufferGL::ScopedUpload nothing(0);
    glGenTextures(1, &this->DepthStencil);
    glBindTexture(GL_TEXTURE_2D, this->DepthStencil);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, this->Width, this->Height, 0,
      GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, nullptr);
    glBindTexture(GL_TEXTURE_2D, bound);
  }
  ++this->Allocations;
  if (!vtkNBufferGL::CheckErrors("Allocating depth and stencil", why))
  {
    return false;
  }
  glGenFramebuffers(1, &this->DepthFramebuffer);
  return this->Attach(this->DepthFramebuffer, 0, why);
}

vtkSmartPointer<vtkTextureObject> vtkShadowTarget::NewTexture(vtkOpenGLRenderWindow* window) const
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetSamples(
    this->IsMultisampled() ? static_cast<unsigned int>(this->Samples.size()) : 0u);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  return texture;
}

bool vtkShadowTarget::AllocateMask(vtkOpenGLRenderWindow* window, Mask& mask, std::string& why)
{
  mask.Texture = this->NewTexture(window);
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
  const GLenum target = this->GetTextureTarget();
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, target, this->DepthStencil, 0);
  if (color != 0)
  {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, color, 0);
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
  if (GetBoundSamples() != this->Samples)
  {
    why = "The device has other samples in textures than in the framebuffer that is drawn.";
    return false;
  }
  return vtkNBufferGL::CheckErrors("Attaching depth and stencil", why);
}

unsigned int vtkShadowTarget::GetTextureTarget() const
{
  return this->IsMultisampled() ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
}

void vtkShadowTarget::Release()
{
  this->Free();
  this->RefusedSamples.clear();
}

void vtkShadowTarget::FreeMask(Mask& mask)
{
  glDeleteFramebuffers(1, &mask.Framebuffer);
  if (mask.Texture)
  {
    mask.Texture->ReleaseGraphicsResources(mask.Texture->GetContext());
  }
  mask = Mask();
}

void vtkShadowTarget::Free()
{
  for (Mask& mask : this->Masks)
  {
    FreeMask(mask);
  }
  this->Masks.clear();
  glDeleteFramebuffers(1, &this->DepthFramebuffer);
  if (this->Depth)
  {
    this->Depth->ReleaseGraphicsResources(this->Depth->GetContext());
    this->Depth = nullptr;
  }
  else
  {
    glDeleteTextures(1, &this->DepthStencil);
  }
  this->DepthFramebuffer = this->DepthStencil = 0;
  this->Width = this->Height = 0;
}
VTK_ABI_NAMESPACE_END
