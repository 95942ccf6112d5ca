// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RerenderedLitmap.h"

#include "vtkNBufferGL.h"

#include "PeerReceiverFS.h"
#include "PeerReceiverVS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace NBufferPeers
{
namespace
{
/// Less than all that is drawn: a lexel that holds it has no receiver.
constexpr float Nothing = -3e38f;

/// Of a position in single precision, in units of its distance from the eye.
constexpr double PositionRounding = 0x1p-20;

/// Row-major: from positions relative to the eye to the litmap in [-w, w], depth 0.
void GetEyeToLight(const vtkShadowLightSpace& frame, const glm::dvec3& eye,
  const vtkShadowBlock& range, double rows[16])
{
  const glm::dvec3 place = eye - frame.GetApex();
  std::fill_n(rows, 16, 0.0);
  double* w = rows + 12;
  if (frame.IsPositional())
  {
    std::copy_n(glm::value_ptr(frame.GetAxis()), 3, w);
    w[3] = glm::dot(place, frame.GetAxis());
  }
  else
  {
    w[3] = 1.0;
  }
  const glm::dvec3 axes[2] = { frame.GetU(), frame.GetV() };
  for (int i = 0; i < 2; ++i)
  {
    const double middle = 0.5 * (range.Low[i] + range.High[i]);
    const double scale = 2.0 / (range.High[i] - range.Low[i]);
    for (int j = 0; j < 3; ++j)
    {
      rows[4 * i + j] = scale * (axes[i][j] - middle * w[j]);
    }
    rows[4 * i + 3] = scale * (glm::dot(place, axes[i]) - middle * w[3]);
  }
}

void Allocate(unsigned int& texture, GLint internalFormat, int width, int height, GLenum format,
  const float* pixels)
{
  if (texture == 0)
  {
    glGenTextures(1, &texture);
  }
  const vtkNBufferGL::ScopedUpload upload(0);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, width, height, 0, format, GL_FLOAT, pixels);
}
}

bool RerenderedLitmap::BeginFrame(
  vtkRenderer* renderer, const float* depth, const vtkShadowView& view, std::string& why)
{
  this->Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->Receivers.Update(renderer, nullptr);
  this->Begin(view.Origin);
  for (const vtkShadowCaster* receiver : this->Receivers.GetCasters())
  {
    this->AddReceiver(receiver->GetPoints(), receiver->GetTriangles());
  }
  return this->Upload(this->Window, depth, view, why);
}

bool RerenderedLitmap::Fill(const vtkShadowLightSpace& space, const vtkShadowBlock& range,
  int resolution, vtkShadowLitmap& litmap, std::string& why)
{
  return this->Draw(this->Window, space, range, resolution, litmap, why);
}

void RerenderedLitmap::Begin(const glm::dvec3& eye)
{
  this->Eye = eye;
  this->Vertices.clear();
  this->Indices.clear();
}

void RerenderedLitmap::AddReceiver(vtkShadowPoints points, const std::vector<int>& triangles)
{
  const auto first = static_cast<unsigned int>(this->Vertices.size() / 3);
  for (const glm::dvec3& point : points)
  {
    const glm::vec3 vertex(point - this->Eye);
    this->Vertices.insert(this->Vertices.end(), { vertex[0], vertex[1], vertex[2] });
  }
  for (const int corner : triangles)
  {
    this->Indices.push_back(first + static_cast<unsigned int>(corner));
  }
}

bool RerenderedLitmap::Upload(
  vtkOpenGLRenderWindow* window, const float* depth, const vtkShadowView& view, std::string& why)
{
  this->EyeToClip = vtkNBufferGLM::Invert(view.ClipToWorld);
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(window);
  Allocate(this->DepthTexture, GL_R32F, view.Width, view.Height, GL_RED, depth);
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
    glGenBuffers(2, this->Buffers);
  }
  int bound = 0;
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->Vertices.size() * sizeof(float)),
    this->Vertices.data(), GL_STREAM_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
    static_cast<GLsizeiptr>(this->Indices.size() * sizeof(unsigned int)), this->Indices.data(),
    GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, bound);
  return vtkNBufferGL::CheckErrors("Sending receivers to the device", why);
}

bool RerenderedLitmap::Reserve(int resolution, std::string& why)
{
  if (this->Framebuffer == 0)
  {
    glGenFramebuffers(1, &this->Framebuffer);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  if (resolution > this->Resolution)
  {
    Allocate(this->Texture, GL_RGBA32F, resolution, resolution, GL_RGBA, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Texture, 0);
    this->Resolution = resolution;
  }
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    vtkNBufferGL::ClearErrors();
    why = "The device cannot draw into textures of floats. Use scattered litmaps.";
    return false;
  }
  return vtkNBufferGL::CheckErrors("Allocating a litmap", why);
}

void RerenderedLitmap::DrawExtremes(int which, float* pixels, int resolution)
{
  this->Program->SetUniformi("rows", which);
  const float nothing[4] = { Nothing, Nothing, Nothing, Nothing };
  glClearBufferfv(GL_COLOR, 0, nothing);
  glDrawElements(
    GL_TRIANGLES, static_cast<GLsizei>(this->Indices.size()), GL_UNSIGNED_INT, nullptr);
  const vtkNBufferGL::ScopedReadback readback(this->Framebuffer);
  glReadPixels(0, 0, resolution, resolution, GL_RGBA, GL_FLOAT, pixels);
  ++this->Draws;
}

bool RerenderedLitmap::Draw(vtkOpenGLRenderWindow* window, const vtkShadowLightSpace& frame,
  const vtkShadowBlock& range, int resolution, vtkShadowLitmap& litmap, std::string& why)
{
  litmap.Begin(resolution, range);
  resolution = litmap.GetResolution();
  if (!(range.Low[0] < range.High[0] && range.Low[1] < range.High[1]) || this->Indices.empty())
  {
    return true; // Nothing is seen.
  }
  const std::size_t count = static_cast<std::size_t>(resolution) * resolution;
  std::vector<float> pixels(8 * count);
  {
    vtkNBufferGL::ClearErrors();
    const vtkNBufferGL::ScopedPass pass(window);
    if (!this->Reserve(resolution, why))
    {
      return false;
    }
    vtkOpenGLShaderCache* cache = window->GetShaderCache();
    this->Program = this->Program ? cache->ReadyShaderProgram(this->Program)
                                  : cache->ReadyShaderProgram(PeerReceiverVS, PeerReceiverFS, "");
    if (!this->Program)
    {
      why = "The shader for litmaps does not compile on this driver. Use scattered litmaps, and "
            "report its message.";
      return false;
    }
    double eyeToLight[16];
    GetEyeToLight(frame, this->Eye, range, eyeToLight);
    vtkNBufferGL::SetMatrix(this->Program, "eyeToLight", vtkNBufferGLM::ToMatrix(eyeToLight));
    vtkNBufferGL::SetMatrix(this->Program, "eyeToClip", this->EyeToClip);
    const glm::dvec3& axis = frame.GetAxis();
    const float axisInFloats[3] = { static_cast<float>(axis[0]), static_cast<float>(axis[1]),
      static_cast<float>(axis[2]) };
    this->Program->SetUniform3f("axis", axisInFloats);
    this->Program->SetUniformf("depthBias", static_cast<float>(DepthBias));
    this->Program->SetUniformi("cameraDepth", 0);
    glBindTexture(GL_TEXTURE_2D, this->DepthTexture);
    glBindVertexArray(this->VertexArray);
    int bound = 0;
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
    glBindBuffer(GL_ARRAY_BUFFER, this->Buffers[0]);
    const int attribute = glGetAttribLocation(this->Program->GetHandle(), "corner");
    glEnableVertexAttribArray(attribute);
    glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, bound);
    glViewport(0, 0, resolution, resolution);
    const vtkNBufferGL::ScopedBlend blend(GL_MAX, GL_ONE, GL_ONE);
    this->DrawExtremes(0, pixels.data(), resolution);
    this->DrawExtremes(1, pixels.data() + 4 * count, resolution);
    if (!vtkNBufferGL::CheckErrors("Drawing a litmap", why))
    {
      return false;
    }
  }
  const double eyeDepth = frame.GetDepth(this->Eye);
  for (std::size_t i = 0; i < count; ++i)
  {
    const float* a = pixels.data() + 4 * i;
    const float* b = a + 4 * count;
    if (a[1] <= Nothing)
    {
      continue;
    }
    vtkShadowExtent extent;
    const double rounding = PositionRounding * b[2];
    extent.Near = eyeDepth - a[0] - rounding;
    extent.Far = eyeDepth + a[1] + rounding;
    extent.X0 = static_cast<std::uint16_t>(-a[2]);
    extent.X1 = static_cast<std::uint16_t>(a[3] + 1.0f);
    extent.Y0 = static_cast<std::uint16_t>(-b[0]);
    extent.Y1 = static_cast<std::uint16_t>(b[1] + 1.0f);
    litmap.AddLexel(static_cast<int>(i % resolution), static_cast<int>(i / resolution), extent);
  }
  return true;
}

void RerenderedLitmap::Release()
{
  glDeleteTextures(1, &this->DepthTexture);
  glDeleteTextures(1, &this->Texture);
  glDeleteFramebuffers(1, &this->Framebuffer);
  glDeleteVertexArrays(1, &this->VertexArray);
  glDeleteBuffers(2, this->Buffers);
  this->DepthTexture = this->Texture = this->Framebuffer = this->VertexArray = 0;
  this->Buffers[0] = this->Buffers[1] = 0;
  this->Resolution = 0;
  this->Program = nullptr;
}
}
