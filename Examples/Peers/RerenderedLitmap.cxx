// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RerenderedLitmap.h"

#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGL.h"

#include "PeerReceiverFS.h"
#include "PeerReceiverVS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace NBufferPeers
{
namespace
{
/// Less than all that is drawn: a lexel that holds it has no receiver.
constexpr float Nothing = -3e38f;

/// Of a position in single precision, in units of its distance from the eye.
constexpr double PositionRounding = 0x1p-20;

using MatrixRows = std::array<glm::dvec4, 4>;

/// Returns the matrix from positions relative to the eye to the litmap in [-w, w], depth 0.
MatrixRows GetEyeToLight(
  const vtkShadowLightSpace& frame, const glm::dvec3& eye, const vtkShadowBlock& range)
{
  const glm::dvec3 place = eye - frame.GetApex();
  const auto getRow = [&place](const glm::dvec3& axis)
  { return glm::dvec4(axis, glm::dot(place, axis)); };
  MatrixRows rows{};
  rows[3] = frame.IsPositional() ? getRow(frame.GetAxis()) : glm::dvec4(0.0, 0.0, 0.0, 1.0);
  const glm::dvec3 axes[2] = { frame.GetU(), frame.GetV() };
  for (int i = 0; i < 2; ++i)
  {
    const double middle = 0.5 * (range.Low[i] + range.High[i]);
    const double scale = 2.0 / (range.High[i] - range.Low[i]);
    rows[i] = scale * (getRow(axes[i]) - middle * rows[3]);
  }
  return rows;
}

void Allocate(vtkNBufferGL::Texture& texture, GLint internalFormat, int width, int height,
  GLenum format, const float* pixels)
{
  const vtkNBufferGL::ScopedUpload upload(0);
  glBindTexture(GL_TEXTURE_2D, texture.Create());
  vtkNBufferGL::SetPlainSampling(GL_TEXTURE_2D);
  glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, width, height, 0, format, GL_FLOAT, pixels);
}

template <typename T>
void SetStreamData(GLenum target, vtkNBufferGL::Buffer& buffer, const std::vector<T>& values)
{
  glBindBuffer(target, buffer.Create());
  glBufferData(
    target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STREAM_DRAW);
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

void RerenderedLitmap::AddReceiver(const vtkShadowPoints& points, const std::vector<int>& triangles)
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
  Allocate(this->Device.Depth, GL_R32F, view.Width, view.Height, GL_RED, depth);
  int bound = 0;
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
  glBindVertexArray(this->Device.VertexArray.Create());
  SetStreamData(GL_ARRAY_BUFFER, this->Device.Vertices, this->Vertices);
  SetStreamData(GL_ELEMENT_ARRAY_BUFFER, this->Device.Indices, this->Indices);
  glBindBuffer(GL_ARRAY_BUFFER, bound);
  return vtkNBufferGL::CheckErrors("Sending receivers to the device", why);
}

bool RerenderedLitmap::Reserve(int resolution, std::string& why)
{
  glBindFramebuffer(GL_FRAMEBUFFER, this->Device.Framebuffer.Create());
  if (resolution > this->Device.Resolution)
  {
    Allocate(this->Device.Litmap, GL_RGBA32F, resolution, resolution, GL_RGBA, nullptr);
    glFramebufferTexture2D(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Device.Litmap.GetName(), 0);
    this->Device.Resolution = resolution;
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
  this->Device.Program->SetUniformi("rows", which);
  const float nothing[4] = { Nothing, Nothing, Nothing, Nothing };
  glClearBufferfv(GL_COLOR, 0, nothing);
  glDrawElements(
    GL_TRIANGLES, static_cast<GLsizei>(this->Indices.size()), GL_UNSIGNED_INT, nullptr);
  const vtkNBufferGL::ScopedReadback readback(this->Device.Framebuffer.GetName());
  glReadPixels(0, 0, resolution, resolution, GL_RGBA, GL_FLOAT, pixels);
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
    vtkShaderProgram* program =
      vtkNBufferGL::UseProgram(window, this->Device.Program, PeerReceiverVS, PeerReceiverFS,
        "The shader for litmaps does not compile on this driver. Use scattered litmaps, and report "
        "its message.",
        why);
    if (!program)
    {
      return false;
    }
    const MatrixRows eyeToLight = GetEyeToLight(frame, this->Eye, range);
    vtkNBufferGL::SetMatrix(
      program, "eyeToLight", vtkNBufferGLM::ToMatrix(glm::value_ptr(eyeToLight[0])));
    vtkNBufferGL::SetMatrix(program, "eyeToClip", this->EyeToClip);
    const glm::dvec3& axis = frame.GetAxis();
    program->SetUniform3f("axis", glm::value_ptr(glm::vec3(axis)));
    program->SetUniformf("depthBias", static_cast<float>(DepthBias));
    program->SetUniformi("cameraDepth", 0);
    glBindTexture(GL_TEXTURE_2D, this->Device.Depth.GetName());
    glBindVertexArray(this->Device.VertexArray.GetName());
    int bound = 0;
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
    glBindBuffer(GL_ARRAY_BUFFER, this->Device.Vertices.GetName());
    const int attribute = glGetAttribLocation(program->GetHandle(), "corner");
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
}
