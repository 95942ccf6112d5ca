// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTarget.h"

#include "vtkNBufferDepthSource.h"
#include "vtkNBufferGL.h"
#include "vtkShadowSampleFS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
vtkShadowTarget::SamplePlaces GetCentre()
{
  return { { { 0.5, 0.5 } } };
}

/// So many texture units are left to the textures of a prop, of which VTK's materials have six at
/// most. A prop that has no unit for one of its textures is drawn wrongly, or not at all.
constexpr int UnitsOfProps = 6;

bool HasTextureUnits(vtkOpenGLRenderWindow* window, int wanted, std::string& why)
{
  vtkTextureUnitManager* units = window->GetState()->GetTextureUnitManager();
  int left = 0;
  for (int i = 0; i < units->GetNumberOfTextureUnits(); ++i)
  {
    left += units->IsAllocated(i) ? 0 : 1;
  }
  if (left < wanted + UnitsOfProps)
  {
    why = "The shadows need " + std::to_string(wanted) + " texture units, and the props " +
      std::to_string(UnitsOfProps) + ", but the window has only " + std::to_string(left) +
      " left. Let fewer lights cast shadows: a unit serves four.";
    return false;
  }
  return true;
}
}

vtkShadowSampleReader::vtkShadowSampleReader()
  : Pass(vtkShadowSampleFS,
      "The shader that reads samples does not compile on this driver. Update the driver, and "
      "report its message.")
{
}

bool vtkShadowSampleReader::Read(vtkOpenGLRenderWindow* window, unsigned int texture, int sample,
  int channel, const int rectangle[4], float* values, std::string& why)
{
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass scope(window);
  vtkShaderProgram* program = this->Image.ReserveTarget(GL_R32F, rectangle[2], rectangle[3], why)
    ? this->Pass.Begin(window, why)
    : nullptr;
  if (!program)
  {
    return false;
  }
  program->SetUniformi("samples", 0);
  program->SetUniformi("index", sample);
  program->SetUniformi("channel", channel);
  program->SetUniform2i("origin", rectangle);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
  this->Pass.Draw(this->Image.GetFramebuffer(), 0, 0, rectangle[2], rectangle[3]);
  const vtkNBufferGL::ScopedReadback readback(this->Image.GetFramebuffer());
  glReadPixels(0, 0, rectangle[2], rectangle[3], GL_RED, GL_FLOAT, values);
  return vtkNBufferGL::CheckErrors("Reading samples", why);
}

void vtkShadowSampleReader::Release()
{
  this->Image.Delete();
  this->Pass.Delete();
}

bool vtkShadowTarget::Reserve(vtkOpenGLRenderWindow* window, int width, int height, int masks,
  const SamplePlaces& samples, std::string& why)
{
  if (vtkNBufferDepthSource::GetStoredDepth() != vtkNBufferStoredDepth::Ordinary)
  {
    why = "Depth is reversed or has another range than VTK's. Let the depth function, the depth "
          "range and the clip control be VTK's where shadows are drawn.";
    return false;
  }
  if (!HasTextureUnits(window, masks + (samples.size() > 1 ? 1 : 0), why))
  {
    return false;
  }
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
    this->Depth = this->NewTexture(window);
    this->Depth->AllocateDepthStencil(width, height);
    if (!vtkNBufferGL::CheckErrors("Allocating depth and stencil", why) ||
      !this->Attach(this->DepthFramebuffer, nullptr, why))
    {
      return false;
    }
  }
  while (this->GetNumberOfMasks() < count)
  {
    auto& [framebuffer, texture] = this->Masks.emplace_back();
    texture = this->NewTexture(window);
    if (!texture->Allocate2D(this->Width, this->Height, 4, VTK_UNSIGNED_CHAR) ||
      !vtkNBufferGL::CheckErrors("Allocating a shadow mask", why) ||
      !this->Attach(framebuffer, texture, why))
    {
      return false;
    }
  }
  return true;
}

vtkSmartPointer<vtkTextureObject> vtkShadowTarget::NewTexture(vtkOpenGLRenderWindow* window)
{
  ++this->Allocations;
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetSamples(
    this->IsMultisampled() ? static_cast<unsigned int>(this->Samples.size()) : 0u);
  return texture;
}

bool vtkShadowTarget::Attach(
  vtkNBufferGL::Framebuffer& framebuffer, vtkTextureObject* color, std::string& why)
{
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.Create());
  const GLenum target = this->IsMultisampled() ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, target, this->Depth->GetHandle(), 0);
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
  if (vtkNBufferGL::GetSamplePlaces() != this->Samples)
  {
    why = "The device has other samples in textures than in the framebuffer that is drawn.";
    return false;
  }
  return vtkNBufferGL::CheckErrors("Attaching depth and stencil", why);
}

bool vtkShadowTarget::ReadDepth(
  vtkOpenGLRenderWindow* window, const int viewport[4], std::vector<float>& depth, std::string& why)
{
  if (!this->IsMultisampled())
  {
    const vtkNBufferGL::ScopedFramebuffers bindings;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->GetDepthFramebuffer());
    vtkNBufferDepthSource source;
    return source.Inspect(window, why) &&
      source.Read(window, viewport[0], viewport[1], viewport[2], viewport[3], depth, why);
  }
  const std::size_t pixels = static_cast<std::size_t>(viewport[2]) * viewport[3];
  depth.resize(this->Samples.size() * pixels);
  bool done = true;
  for (std::size_t i = 0; i < this->Samples.size() && done; ++i)
  {
    done = this->SampleReader.Read(window, this->Depth->GetHandle(), static_cast<int>(i), 0,
      viewport, depth.data() + i * pixels, why);
  }
  return done;
}

bool vtkShadowTarget::ReadMask(vtkOpenGLRenderWindow* window, const int viewport[4],
  std::size_t light, int sample, std::vector<unsigned char>& mask, std::string& why)
{
  const Mask& source = this->Masks[GetMaskIndex(light)];
  const int channel = GetChannel(light);
  mask.resize(static_cast<std::size_t>(viewport[2]) * viewport[3]);
  if (!this->IsMultisampled())
  {
    std::vector<unsigned char> pixels(LightsPerMask * mask.size());
    vtkNBufferGL::ClearErrors();
    const vtkNBufferGL::ScopedReadback readback(source.Framebuffer.GetName());
    glReadPixels(
      viewport[0], viewport[1], viewport[2], viewport[3], GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      mask[i] = pixels[LightsPerMask * i + channel];
    }
    return vtkNBufferGL::CheckErrors("Reading a shadow mask", why);
  }
  const int first = std::max(sample, 0);
  const int last = sample < 0 ? static_cast<int>(this->Samples.size()) : sample + 1;
  std::vector<float> values(mask.size());
  std::vector<float> sums(mask.size(), 0.0f);
  for (int i = first; i < last; ++i)
  {
    if (!this->SampleReader.Read(
          window, source.Texture->GetHandle(), i, channel, viewport, values.data(), why))
    {
      return false;
    }
    for (std::size_t k = 0; k < mask.size(); ++k)
    {
      sums[k] += values[k];
    }
  }
  std::transform(sums.begin(), sums.end(), mask.begin(),
    [&](float sum)
    { return static_cast<unsigned char>(255.0f * sum / static_cast<float>(last - first) + 0.5f); });
  return true;
}

void vtkShadowTarget::Release()
{
  this->Free();
  this->SampleReader.Release();
  this->RefusedSamples.clear();
}

void vtkShadowTarget::Free()
{
  this->Masks.clear();
  this->DepthFramebuffer.Delete();
  this->Depth = nullptr;
  this->Width = this->Height = 0;
}
VTK_ABI_NAMESPACE_END
