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
  const vtkNBufferGL::ScopedFramebuffers bindings;
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
  ++this->Allocations;
  if (this->IsMultisampled())
  {
    this->SampledDepth = this->NewTexture(window);
    this->SampledDepth->AllocateDepthStencil(this->Width, this->Height);
  }
  else if (!this->PlainDepth.Reserve(GL_DEPTH24_STENCIL8, this->Width, this->Height, why))
  {
    return false;
  }
  return vtkNBufferGL::CheckErrors("Allocating depth and stencil", why) &&
    this->Attach(this->DepthFramebuffer, nullptr, why);
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
  return this->Attach(mask.Framebuffer, mask.Texture, why);
}

bool vtkShadowTarget::Attach(
  vtkNBufferGL::Framebuffer& framebuffer, vtkTextureObject* color, std::string& why)
{
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.Create());
  const bool multisampled = this->IsMultisampled();
  const GLenum target = multisampled ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, target,
    multisampled ? this->SampledDepth->GetHandle() : this->PlainDepth.GetName(), 0);
  if (color)
  {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, color->GetHandle(), 0);
  }
  const GLenum buffer = color ? GL_COLOR_ATTACHMENT0 : GL_NONE;
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

void vtkShadowTarget::Release()
{
  this->Free();
  this->RefusedSamples.clear();
}

void vtkShadowTarget::Free()
{
  this->Masks.clear();
  this->DepthFramebuffer.Delete();
  this->PlainDepth.Delete();
  this->SampledDepth = nullptr;
  this->Width = this->Height = 0;
}
VTK_ABI_NAMESPACE_END
