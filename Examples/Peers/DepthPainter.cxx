// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthPainter.h"

#include "PeerDepthFS.h"
#include "PeerDepthVS.h"

#include "PeerErrors.h"
#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <cmath>
#include <cstddef>

namespace NBufferPeers
{
using NBufferStudy::DepthEncoding;

void DepthPainter::SetTriangles(const std::vector<DepthVertex>& vertices)
{
  vtkNBufferGL::ClearErrors();
  const int bound = vtkNBufferGL::GetInteger(GL_ARRAY_BUFFER_BINDING);
  glBindBuffer(GL_ARRAY_BUFFER, this->Vertices.Create());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(DepthVertex)),
    vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(bound));
  ThrowOnErrors("Sending triangles to the device");
}

bool DepthPainter::SetView(
  const NBufferStudy::DepthFormat& format, const DepthView& view, std::string& why)
{
  this->Format = format;
  this->View = view;
  if (format.Encoding == DepthEncoding::Reversed &&
    !vtkNBufferGL::HasFeature(4, 5, "GL_ARB_clip_control"))
  {
    why = "reversed depth needs OpenGL 4.5 or ARB_clip_control";
    return false;
  }
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(this->Window);
  return this->Allocate(why);
}

void DepthPainter::SetOffset(float factor, float units)
{
  this->Offset[0] = factor;
  this->Offset[1] = units;
}

bool DepthPainter::Allocate(std::string& why)
{
  const int bits = this->Format.Bits;
  const vtkNBufferGL::ScopedUpload upload(0);
  const auto allocate = [this](vtkNBufferGL::Texture& texture, GLint internal, GLenum format)
  {
    texture.Delete();
    glBindTexture(GL_TEXTURE_2D, texture.Create());
    vtkNBufferGL::SetPlainSampling(GL_TEXTURE_2D);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, this->View.Width, this->View.Height, 0, format,
      GL_FLOAT, nullptr);
  };
  allocate(this->Numbers, GL_R32F, GL_RED);
  allocate(this->Depth,
    bits == 16     ? GL_DEPTH_COMPONENT16
      : bits == 24 ? GL_DEPTH_COMPONENT24
      : bits == 32 ? GL_DEPTH_COMPONENT32
                   : GL_DEPTH_COMPONENT32F,
    GL_DEPTH_COMPONENT);
  glBindFramebuffer(GL_FRAMEBUFFER, this->Target.Create());
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Numbers.GetName(), 0);
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->Depth.GetName(), 0);
  GLint size = 0;
  GLint type = 0;
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
  {
    glGetFramebufferAttachmentParameteriv(
      GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &size);
    glGetFramebufferAttachmentParameteriv(
      GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
  }
  if (size != (bits > 0 ? bits : 32) || (type == GL_FLOAT) != (bits == 0))
  {
    vtkNBufferGL::ClearErrors();
    why = "the device stores this depth as " + std::to_string(size) + " bits" +
      (type == GL_FLOAT ? " of a float" : "");
    return false;
  }
  ThrowOnErrors("Allocating a depth texture");
  return true;
}

vtkShaderProgram* DepthPainter::UseProgram()
{
  const bool isByShader = this->Format.Encoding == DepthEncoding::Linear ||
    this->Format.Encoding == DepthEncoding::Logarithmic;
  const DepthEncoding key = isByShader ? this->Format.Encoding : DepthEncoding::Forward;
  std::string text = PeerDepthFS;
  vtkShaderProgram::Substitute(text, "//VTK::NBuffer::Dec",
    "#define NBUFFER_ENCODING " + std::to_string(static_cast<int>(key)) + "\n");
  std::string why;
  vtkShaderProgram* program = vtkNBufferGL::UseProgram(this->Window, this->Programs[key],
    PeerDepthVS, text, "the shader of depths does not compile on this driver", why);
  ThrowUnless(program, why);
  const DepthView& view = this->View;
  const double near = view.Planes.Near;
  const double far = view.Planes.Far;
  // z of Reversed is the near distance everywhere.
  glm::dvec4 z(0.0, 0.0, 0.0, near);
  if (this->Format.Encoding != DepthEncoding::Reversed)
  {
    z = glm::dvec4((far + near) / (far - near) * view.W, -2.0 * far * near / (far - near));
  }
  vtkNBufferGL::SetMatrix(program, "eyeToClip",
    glm::transpose(
      glm::dmat4(glm::dvec4(view.X, 0.0), glm::dvec4(view.Y, 0.0), z, glm::dvec4(view.W, 0.0))));
  if (isByShader)
  {
    const bool isLinear = key == DepthEncoding::Linear;
    program->SetUniformf(
      "scale", static_cast<float>(1.0 / (isLinear ? far : std::log2(far / near))));
    if (!isLinear)
    {
      program->SetUniformf("nearest", static_cast<float>(near));
    }
  }
  return program;
}

void DepthPainter::Draw(int first, int count)
{
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(this->Window);
  const vtkNBufferGL::ScopedFramebuffers framebuffers;
  vtkShaderProgram* program = this->UseProgram();
  const int function = vtkNBufferGL::GetInteger(GL_DEPTH_FUNC);
  GLboolean mask = GL_TRUE;
  glGetBooleanv(GL_DEPTH_WRITEMASK, &mask);
  const bool isReversed = this->Format.Encoding == DepthEncoding::Reversed;
  glBindFramebuffer(GL_FRAMEBUFFER, this->Target.GetName());
  glViewport(0, 0, this->View.Width, this->View.Height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(isReversed ? GL_GEQUAL : GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(this->Offset[0], this->Offset[1]);
  if (isReversed)
  {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  }
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const auto background = static_cast<float>(this->Format.GetBackground());
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_DEPTH, 0, &background);
  glBindVertexArray(this->VertexArray.Create());
  const int bound = vtkNBufferGL::GetInteger(GL_ARRAY_BUFFER_BINDING);
  glBindBuffer(GL_ARRAY_BUFFER, this->Vertices.GetName());
  const auto setAttribute = [program](const char* name, int components, std::size_t offset)
  {
    const auto place = static_cast<GLuint>(glGetAttribLocation(program->GetHandle(), name));
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, components, GL_FLOAT, GL_FALSE, sizeof(DepthVertex),
      reinterpret_cast<const void*>(offset));
  };
  setAttribute("place", 3, 0);
  setAttribute("number", 1, offsetof(DepthVertex, Number));
  glDrawArrays(GL_TRIANGLES, first, count);
  glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(bound));
  if (isReversed)
  {
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  }
  glPolygonOffset(0.0f, 0.0f);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_TEST);
  glDepthFunc(static_cast<GLenum>(function));
  glDepthMask(mask);
  ThrowOnErrors("Drawing depths");
}

std::vector<float> DepthPainter::ReadNumbers()
{
  vtkNBufferGL::ClearErrors();
  const DepthView& view = this->View;
  std::vector<float> numbers(static_cast<std::size_t>(view.Width) * view.Height);
  const vtkNBufferGL::ScopedReadback readback(this->Target.GetName());
  glReadPixels(0, 0, view.Width, view.Height, GL_RED, GL_FLOAT, numbers.data());
  ThrowOnErrors("Reading numbers back");
  return numbers;
}

std::vector<double> DepthPainter::ReadDepth()
{
  vtkNBufferGL::ClearErrors();
  const DepthView& view = this->View;
  const std::size_t count = static_cast<std::size_t>(view.Width) * view.Height;
  std::vector<double> depth;
  const vtkNBufferGL::ScopedReadback readback(this->Target.GetName());
  const auto read = [&](auto& values, GLenum type, double scale)
  {
    values.resize(count);
    glReadPixels(0, 0, view.Width, view.Height, GL_DEPTH_COMPONENT, type, values.data());
    for (const auto value : values)
    {
      depth.push_back(static_cast<double>(value) * scale);
    }
  };
  if (this->Format.Bits == 0)
  {
    std::vector<float> values;
    read(values, GL_FLOAT, 1.0);
  }
  else
  {
    // Integers, because a float does not hold all depths of 32 bits.
    std::vector<unsigned int> values;
    read(values, GL_UNSIGNED_INT, 1.0 / 4294967295.0);
  }
  ThrowOnErrors("Reading depth back");
  return depth;
}

} // namespace NBufferPeers
