// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTextureStorage.h"

#include "vtkNBufferGL.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Texels are fetched one by one: without mip levels and filters the texture is complete.
void SetPlainSampling(GLenum target)
{
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_BASE_LEVEL, 0);
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}
}

bool vtkNBufferTextureStorage::ReserveLevels(int width, int height, int levels, std::string& why)
{
  if (width <= this->Width && height <= this->Height && levels <= this->Levels)
  {
    return true;
  }
  const int newWidth = std::max(width, this->Width);
  const int newHeight = std::max(height, this->Height);
  const int newLevels = std::max(levels, this->Levels);
  this->ReleaseLevels();
  if (!this->AllocateArrays(newWidth, newHeight, newLevels, why) ||
    !this->AllocateFramebuffers(newLevels, why))
  {
    this->ReleaseLevels();
    return false;
  }
  this->Width = newWidth;
  this->Height = newHeight;
  this->Levels = newLevels;
  return true;
}

bool vtkNBufferTextureStorage::AllocateArrays(int width, int height, int levels, std::string& why)
{
  const vtkNBufferGL::ScopedUpload nothing(0);
  glGenTextures(ArrayCount, this->Arrays);
  for (int i = 0; i < ArrayCount; ++i)
  {
    const int layers = (levels - i + ArrayCount - 1) / ArrayCount;
    glBindTexture(GL_TEXTURE_2D_ARRAY, this->Arrays[i]);
    SetPlainSampling(GL_TEXTURE_2D_ARRAY);
    if (layers > 0)
    {
      glTexImage3D(
        GL_TEXTURE_2D_ARRAY, 0, GL_R32F, width, height, layers, 0, GL_RED, GL_FLOAT, nullptr);
      ++this->Allocations;
    }
  }
  return vtkNBufferGL::CheckErrors("Allocating the levels", why);
}

bool vtkNBufferTextureStorage::AllocateFramebuffers(int levels, std::string& why)
{
  this->Framebuffers.assign(levels, 0u);
  glGenFramebuffers(levels, this->Framebuffers.data());
  for (int level = 0; level < levels; ++level)
  {
    glBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffers[level]);
    glFramebufferTextureLayer(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->GetArray(level), 0, GetLayer(level));
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    {
      why = "The device cannot draw into float textures (R32F). Use the CPU back-end without "
            "multisampling.";
      vtkNBufferGL::ClearErrors();
      return false;
    }
  }
  return vtkNBufferGL::CheckErrors("Attaching the levels", why);
}

bool vtkNBufferTextureStorage::ReserveCopy(
  unsigned int format, int width, int height, std::string& why)
{
  return this->ReserveImage(this->Copy, format, GL_DEPTH_COMPONENT, GL_FLOAT, width, height, why);
}

bool vtkNBufferTextureStorage::ReserveIntegers(int width, int height, std::string& why)
{
  const std::size_t bytes = sizeof(GLuint) * static_cast<std::size_t>(width) * height;
  return this->ReserveBuffer(
           this->IntegerBuffer, GL_PIXEL_PACK_BUFFER, GL_STREAM_COPY, bytes, why) &&
    this->ReserveImage(
      this->Integers, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, width, height, why);
}

bool vtkNBufferTextureStorage::ReserveReadback(std::size_t bytes, std::string& why)
{
  return this->ReserveBuffer(
    this->ReadbackBuffer, GL_PIXEL_PACK_BUFFER, GL_STREAM_READ, bytes, why);
}

bool vtkNBufferTextureStorage::ReserveImage(Image& image, unsigned int format,
  unsigned int components, unsigned int type, int width, int height, std::string& why)
{
  if (image.Name == 0)
  {
    glGenTextures(1, &image.Name);
    glBindTexture(GL_TEXTURE_2D, image.Name);
    SetPlainSampling(GL_TEXTURE_2D);
  }
  glBindTexture(GL_TEXTURE_2D, image.Name);
  if (image.Format == format && width <= image.Width && height <= image.Height)
  {
    return true;
  }
  const vtkNBufferGL::ScopedUpload nothing(0);
  image.Format = format;
  image.Width = std::max(width, image.Width);
  image.Height = std::max(height, image.Height);
  glTexImage2D(GL_TEXTURE_2D, 0, format, image.Width, image.Height, 0, components, type, nullptr);
  ++this->Allocations;
  if (!vtkNBufferGL::CheckErrors("Allocating a copy of the depth buffer", why))
  {
    image.Format = 0;
    image.Width = image.Height = 0;
    return false;
  }
  return true;
}

bool vtkNBufferTextureStorage::ReserveBuffer(
  Buffer& buffer, unsigned int target, unsigned int usage, std::size_t bytes, std::string& why)
{
  if (bytes <= buffer.Bytes)
  {
    return true;
  }
  GLint bound = 0;
  glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &bound);
  if (buffer.Name == 0)
  {
    glGenBuffers(1, &buffer.Name);
  }
  glBindBuffer(target, buffer.Name);
  glBufferData(target, static_cast<GLsizeiptr>(bytes), nullptr, usage);
  glBindBuffer(target, bound);
  ++this->Allocations;
  buffer.Bytes = bytes;
  if (!vtkNBufferGL::CheckErrors("Allocating a buffer for depth", why))
  {
    buffer.Bytes = 0;
    return false;
  }
  return true;
}

unsigned int vtkNBufferTextureStorage::GetVertexArray()
{
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  return this->VertexArray;
}

void vtkNBufferTextureStorage::ReleaseLevels()
{
  // Names of 0 are ignored.
  glDeleteFramebuffers(static_cast<GLsizei>(this->Framebuffers.size()), this->Framebuffers.data());
  glDeleteTextures(ArrayCount, this->Arrays);
  this->Framebuffers.clear();
  std::fill(std::begin(this->Arrays), std::end(this->Arrays), 0u);
  this->Width = this->Height = this->Levels = 0;
}

void vtkNBufferTextureStorage::Release()
{
  this->ReleaseLevels();
  glDeleteTextures(1, &this->Copy.Name);
  glDeleteTextures(1, &this->Integers.Name);
  glDeleteBuffers(1, &this->IntegerBuffer.Name);
  glDeleteBuffers(1, &this->ReadbackBuffer.Name);
  glDeleteVertexArrays(1, &this->VertexArray);
  this->Forget();
}

void vtkNBufferTextureStorage::Forget()
{
  const int allocations = this->Allocations;
  *this = vtkNBufferTextureStorage();
  this->Allocations = allocations;
}
VTK_ABI_NAMESPACE_END
