// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ColorTarget.h
 * @brief A framebuffer object with colour and without depth.
 */
#ifndef ColorTarget_h
#define ColorTarget_h

#include "vtkNBufferVTKVersion.h"
#include VTKNBUFFER_GL_HEADER

#include <cstddef>
#include <vector>

/// The constructor binds the framebuffer; the destructor binds the one before.
class ColorTarget
{
public:
  ColorTarget(int width, int height)
    : Width(width)
    , Height(height)
  {
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &this->Before);
    glGenTextures(1, &this->Texture);
    glBindTexture(GL_TEXTURE_2D, this->Texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glGenFramebuffers(1, &this->Framebuffer);
    this->Bind();
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Texture, 0);
  }
  ~ColorTarget()
  {
    glBindFramebuffer(GL_FRAMEBUFFER, this->Before);
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteTextures(1, &this->Texture);
  }
  ColorTarget(const ColorTarget&) = delete;
  void operator=(const ColorTarget&) = delete;

  void Bind() const { glBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer); }

  /// Returns the RGBA bytes of all pixels, the lowest row first.
  std::vector<unsigned char> Read() const
  {
    this->Bind();
    std::vector<unsigned char> rgba(static_cast<std::size_t>(4) * this->Width * this->Height);
    glReadPixels(0, 0, this->Width, this->Height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
  }

private:
  int Width;
  int Height;
  GLint Before = 0;
  GLuint Framebuffer = 0;
  GLuint Texture = 0;
};

#endif
