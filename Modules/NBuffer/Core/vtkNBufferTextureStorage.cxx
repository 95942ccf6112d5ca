// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTextureStorage.h"

#include "Shaders/vtkNBufferShared.h"
#include "vtkNBufferDepthSource.h"
#include "vtkNBufferGL.h"

#include <algorithm>
#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The format of the source: devices may round depth that they copy to another one (Mesa's zink).
GLenum GetCopyFormat(const vtkNBufferDepthSource& source)
{
  if (source.FloatDepth)
  {
    return source.HasStencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
  }
  if (source.DepthBits <= 16)
  {
    return GL_DEPTH_COMPONENT16;
  }
  return source.HasStencil ? GL_DEPTH24_STENCIL8 : GL_DEPTH_COMPONENT24;
}
}

bool vtkNBufferTextureStorage::ReserveLevels(
  int width, int height, int levels, int channels, std::string& why)
{
  if (width <= this->Width && height <= this->Height && levels <= this->Levels &&
    channels <= this->Channels)
  {
    return true;
  }
  const int newWidth = std::max(width, this->Width);
  const int newHeight = std::max(height, this->Height);
  const int newLevels = std::max(levels, this->Levels);
  const int newChannels = std::max(channels, this->Channels);
  this->DeleteLevels(vtkNBufferGL::Context::Current);
  if (!this->AllocateArrays(newWidth, newHeight, newLevels, newChannels, why) ||
    !this->AllocateFramebuffers(newLevels, why))
  {
    this->DeleteLevels(vtkNBufferGL::Context::Current);
    return false;
  }
  this->Width = newWidth;
  this->Height = newHeight;
  this->Levels = newLevels;
  this->Channels = newChannels;
  return true;
}

bool vtkNBufferTextureStorage::AllocateArrays(
  int width, int height, int levels, int channels, std::string& why)
{
  const vtkNBufferGL::ScopedUpload nothing(0);
  for (int i = 0; i < ArrayCount; ++i)
  {
    const int layers = (levels - i + ArrayCount - 1) / ArrayCount;
    glBindTexture(GL_TEXTURE_2D_ARRAY, this->Arrays[i].Create());
    vtkNBufferGL::SetPlainSampling(GL_TEXTURE_2D_ARRAY);
    if (layers > 0)
    {
      glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, channels == 2 ? GL_RG32F : GL_R32F, width, height,
        layers, 0, GL_RED, GL_FLOAT, nullptr);
      ++this->Allocations;
    }
  }
  return vtkNBufferGL::CheckErrors("Allocating the levels", why);
}

bool vtkNBufferTextureStorage::AllocateFramebuffers(int levels, std::string& why)
{
  for (int level = 0; level < levels; ++level)
  {
    this->Framebuffers.emplace_back();
    glBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffers.back().Create());
    glFramebufferTextureLayer(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->GetArray(level), 0, GetLayer(level));
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    {
      why = "The device cannot draw into float textures (R32F or RG32F). Use the CPU back-end "
            "without multisampling.";
      vtkNBufferGL::ClearErrors();
      return false;
    }
  }
  return vtkNBufferGL::CheckErrors("Attaching the levels", why);
}

bool vtkNBufferTextureStorage::BindDepth(const vtkNBufferDepthSource& source, int x, int y,
  int width, int height, SampledDepth& depth, std::string& why)
{
  if (source.Samples > 1 || (source.Texture && !source.ExceedsFloats()))
  {
    depth.Foreign = true;
    depth.Kind = source.Samples > 1 ? NBUFFER_SOURCE_MULTISAMPLE : NBUFFER_SOURCE_DEPTH;
    depth.Target = source.Samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    depth.Level = source.DepthLevel;
    depth.Origin[0] = x;
    depth.Origin[1] = y;
    glBindTexture(depth.Target, source.DepthName);
    return vtkNBufferGL::CheckErrors("Binding the depth texture", why);
  }
  if (!source.ExceedsFloats())
  {
    if (!this->Copy.Reserve(GetCopyFormat(source), width, height, why))
    {
      return false;
    }
    glBindTexture(GL_TEXTURE_2D, this->Copy.GetName());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source.Framebuffer);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, x, y, width, height);
    return vtkNBufferGL::CheckErrors("Copying the depth buffer", why);
  }
  // Depth can be copied as integers only through a buffer object. That costs little: graphics
  // devices lack this depth format, and software renderers copy it without a conversion.
  depth.Kind = NBUFFER_SOURCE_INTEGER;
  const std::size_t bytes = sizeof(GLuint) * static_cast<std::size_t>(width) * height;
  if (!this->ReserveBuffer(this->IntegerBuffer, GL_STREAM_COPY, bytes, why) ||
    !this->Integers.Reserve(GL_R32UI, width, height, why))
  {
    return false;
  }
  glBindTexture(GL_TEXTURE_2D, this->Integers.GetName());
  const unsigned int buffer = this->IntegerBuffer.Object.GetName();
  {
    const vtkNBufferGL::ScopedReadback readback(source.Framebuffer, buffer);
    glReadPixels(x, y, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  }
  {
    const vtkNBufferGL::ScopedUpload upload(buffer);
    glTexSubImage2D(
      GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  }
  return vtkNBufferGL::CheckErrors("Copying the depth buffer as integers", why);
}

bool vtkNBufferTextureStorage::Read(const std::vector<vtkNBufferRectangle>& rectangles, int levels,
  int width, int height, float* texels, std::string& why)
{
  std::size_t size = 0;
  for (const vtkNBufferRectangle& rectangle : rectangles)
  {
    size += sizeof(float) * rectangle.GetWidth() * rectangle.GetHeight() * levels;
  }
  if (!this->ReserveBuffer(this->ReadbackBuffer, GL_STREAM_READ, size, why))
  {
    return false;
  }
  const vtkNBufferGL::ScopedReadback readback(0, this->ReadbackBuffer.Object.GetName());
  std::size_t offset = 0;
  for (int level = 0; level < levels; ++level)
  {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, this->GetFramebuffer(level));
    for (const vtkNBufferRectangle& rectangle : rectangles)
    {
      glReadPixels(rectangle.X0, rectangle.Y0, rectangle.GetWidth(), rectangle.GetHeight(), GL_RED,
        GL_FLOAT, reinterpret_cast<void*>(offset));
      offset += sizeof(float) * rectangle.GetWidth() * rectangle.GetHeight();
    }
  }
  // This is the one call that waits.
  const auto* from = static_cast<const float*>(
    glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(size), GL_MAP_READ_BIT));
  if (!vtkNBufferGL::CheckErrors("Reading the levels back", why))
  {
    if (from)
    {
      glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    }
    return false;
  }
  for (int level = 0; level < levels; ++level, texels += static_cast<std::size_t>(width) * height)
  {
    for (const vtkNBufferRectangle& rectangle : rectangles)
    {
      for (int y = rectangle.Y0; y < rectangle.Y1; ++y, from += rectangle.GetWidth())
      {
        std::copy_n(
          from, rectangle.GetWidth(), texels + static_cast<std::size_t>(y) * width + rectangle.X0);
      }
    }
  }
  if (!glUnmapBuffer(GL_PIXEL_PACK_BUFFER))
  {
    why = "The driver lost the depth that was read back. Use the CPU back-end.";
    return false;
  }
  return true;
}

bool vtkNBufferTextureStorage::ReserveBuffer(
  Buffer& buffer, unsigned int usage, std::size_t bytes, std::string& why)
{
  if (bytes <= buffer.Bytes)
  {
    return true;
  }
  const int bound = vtkNBufferGL::GetInteger(GL_PIXEL_PACK_BUFFER_BINDING);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer.Object.Create());
  glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, usage);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, bound);
  ++this->Allocations;
  const bool done = vtkNBufferGL::CheckErrors("Allocating a buffer for depth", why);
  buffer.Bytes = done ? bytes : 0;
  return done;
}

int vtkNBufferTextureStorage::GetNumberOfAllocations() const
{
  return this->Allocations + this->Copy.GetNumberOfAllocations() +
    this->Integers.GetNumberOfAllocations();
}

void vtkNBufferTextureStorage::DeleteLevels(vtkNBufferGL::Context context)
{
  for (vtkNBufferGL::Framebuffer& framebuffer : this->Framebuffers)
  {
    framebuffer.Delete(context);
  }
  this->Framebuffers.clear();
  for (vtkNBufferGL::Texture& array : this->Arrays)
  {
    array.Delete(context);
  }
  this->Width = this->Height = this->Levels = this->Channels = 0;
}

void vtkNBufferTextureStorage::Delete(vtkNBufferGL::Context context)
{
  this->DeleteLevels(context);
  this->Copy.Delete(context);
  this->Integers.Delete(context);
  for (Buffer* buffer : { &this->IntegerBuffer, &this->ReadbackBuffer })
  {
    buffer->Object.Delete(context);
    buffer->Bytes = 0;
  }
}
VTK_ABI_NAMESPACE_END
