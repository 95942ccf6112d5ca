// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSampleReader.h"

#include "vtkNBufferFullScreenVS.h"
#include "vtkNBufferGL.h"
#include "vtkShadowSampleFS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
bool vtkShadowSampleReader::Reserve(int width, int height, std::string& why)
{
  if (width <= this->Width && height <= this->Height)
  {
    return true;
  }
  width = std::max(width, this->Width);
  height = std::max(height, this->Height);
  this->Release();
  glGenVertexArrays(1, &this->VertexArray);
  glGenTextures(1, &this->Texture);
  glBindTexture(GL_TEXTURE_2D, this->Texture);
  {
    const vtkNBufferGL::ScopedUpload nothing(0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, height, 0, GL_RED, GL_FLOAT, nullptr);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glGenFramebuffers(1, &this->Framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Texture, 0);
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (!vtkNBufferGL::CheckErrors("Allocating an image of samples", why))
  {
    return false;
  }
  if (!complete)
  {
    why = "The device cannot draw floats. Call SetMultiSamples(0) on the render window.";
    return false;
  }
  this->Width = width;
  this->Height = height;
  return true;
}

bool vtkShadowSampleReader::Read(vtkOpenGLRenderWindow* window, unsigned int texture, int sample,
  int channel, const int rectangle[4], float* values, std::string& why)
{
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(window);
  if (!this->Reserve(rectangle[2], rectangle[3], why))
  {
    this->Release();
    return false;
  }
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  this->Program = this->Program
    ? cache->ReadyShaderProgram(this->Program)
    : cache->ReadyShaderProgram(vtkNBufferFullScreenVS, vtkShadowSampleFS, "");
  if (!this->Program)
  {
    why = "The shader that reads samples does not compile on this driver. Update the driver, and "
          "report its message.";
    return false;
  }
  this->Program->SetUniformi("samples", 0);
  this->Program->SetUniformi("index", sample);
  this->Program->SetUniformi("channel", channel);
  this->Program->SetUniform2i("origin", rectangle);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  glViewport(0, 0, rectangle[2], rectangle[3]);
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  const vtkNBufferGL::ScopedReadback readback(this->Framebuffer);
  glReadPixels(0, 0, rectangle[2], rectangle[3], GL_RED, GL_FLOAT, values);
  return vtkNBufferGL::CheckErrors("Reading samples", why);
}

void vtkShadowSampleReader::Release()
{
  glDeleteTextures(1, &this->Texture);
  glDeleteFramebuffers(1, &this->Framebuffer);
  glDeleteVertexArrays(1, &this->VertexArray);
  *this = vtkShadowSampleReader();
}
VTK_ABI_NAMESPACE_END
