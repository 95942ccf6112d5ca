// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SingleLevel.h"

#include "PeerBaseFS.h"
#include "PeerFullScreenVS.h"
#include "PeerReduceCS.h"
#include "PeerSharedText.h"

#include "Shaders/vtkNBufferShared.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferMath.h"
#include "vtkNBufferResourceCallback.h"

#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

namespace NBufferPeers
{
namespace
{
/// Of the compute shader, along each axis.
constexpr int GroupSide = 16;

void MakeTexture(
  unsigned int& name, GLenum format, GLenum components, int width, int height, const float* values)
{
  if (name == 0)
  {
    glGenTextures(1, &name);
  }
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexImage2D(
    GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, components, GL_FLOAT, values);
}

std::string GetLog(unsigned int name, bool program)
{
  char text[1024] = "";
  if (program)
  {
    glGetProgramInfoLog(name, sizeof(text), nullptr, text);
  }
  else
  {
    glGetShaderInfoLog(name, sizeof(text), nullptr, text);
  }
  return text;
}
}

SingleLevel::SingleLevel()
  : ResourceCallback(std::make_unique<vtkOpenGLResourceFreeCallback<SingleLevel>>(
      this, &SingleLevel::ReleaseGraphicsResources))
{
}

SingleLevel::~SingleLevel()
{
  this->ResourceCallback->Release();
}

std::string SingleLevel::WhyNot(ReduceMethod method)
{
  return method == ReduceMethod::Compute && !vtkNBufferGL::HasVersion(4, 3)
    ? "compute shaders need OpenGL 4.3"
    : "";
}

bool SingleLevel::SetDepth(vtkOpenGLRenderWindow* window, const std::vector<float>& depth,
  int width, int height, std::string& why)
{
  if (this->Window != window)
  {
    this->ResourceCallback->RegisterGraphicsResources(window);
    this->Window = window;
    window->MakeCurrent();
  }
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(window);
  const vtkNBufferGL::ScopedUpload upload(0);
  this->PixelWidth = width;
  this->PixelHeight = height;
  MakeTexture(this->Depth, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, width, height, depth.data());
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  // Room for the largest of what passes of 2 x 2 leave on their way.
  for (Image& image : this->Targets)
  {
    MakeTexture(image.Texture, GL_R32F, GL_RED, vtkNBufferMath::GetBaseSize(width, 2),
      vtkNBufferMath::GetBaseSize(height, 2), nullptr);
    if (image.Framebuffer == 0)
    {
      glGenFramebuffers(1, &image.Framebuffer);
    }
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, image.Framebuffer);
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image.Texture, 0);
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    {
      why = "the device cannot draw into float textures (R32F)";
      return false;
    }
  }
  return vtkNBufferGL::CheckErrors("Uploading depth", why);
}

vtkShaderProgram* SingleLevel::ReadyPass(int factor, std::string& why)
{
  vtkOpenGLShaderCache* cache = this->Window->GetShaderCache();
  auto& program = this->Programs[factor];
  if (program)
  {
    program = cache->ReadyShaderProgram(program);
  }
  else
  {
    const auto define = [](const char* name, int value)
    { return std::string("#define ") + name + " " + std::to_string(value) + "\n"; };
    std::string text = PeerBaseFS;
    vtkShaderProgram::Substitute(text, "//VTK::NBuffer::Shared", PeerSharedText);
    vtkShaderProgram::Substitute(text, "//VTK::NBuffer::Dec",
      define("NBUFFER_MAXIMUM", 1) + define("NBUFFER_SOURCE", NBUFFER_SOURCE_DEPTH) +
        define("NBUFFER_FACTOR", factor) + define("NBUFFER_SAMPLES", 1) +
        define("NBUFFER_INEXACT", 0));
    program = cache->ReadyShaderProgram(PeerFullScreenVS, text.c_str(), "");
  }
  if (!program)
  {
    why = "the shader of a pass does not compile on this driver";
  }
  return program;
}

bool SingleLevel::DrawPass(
  unsigned int source, int width, int height, int factor, const Image& target, std::string& why)
{
  vtkShaderProgram* program = this->ReadyPass(factor, why);
  if (!program)
  {
    return false;
  }
  const int origin[2] = { 0, 0 };
  const int last[2] = { width - 1, height - 1 };
  program->SetUniformi("depth", 0);
  program->SetUniform2i("origin", origin);
  program->SetUniform2i("last", last);
  glBindTexture(GL_TEXTURE_2D, source);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.Framebuffer);
  glViewport(
    0, 0, vtkNBufferMath::GetBaseSize(width, factor), vtkNBufferMath::GetBaseSize(height, factor));
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return true;
}

bool SingleLevel::ReduceByPasses(int factor, std::string& why)
{
  unsigned int source = this->Depth;
  int width = this->PixelWidth;
  int height = this->PixelHeight;
  for (int side = factor; side > 1; side /= 2)
  {
    // The last one ends in the first target.
    const bool even = side == 2 || side == 8;
    const Image& target = this->Targets[even ? 0 : 1];
    if (!this->DrawPass(source, width, height, 2, target, why))
    {
      return false;
    }
    source = target.Texture;
    width = vtkNBufferMath::GetBaseSize(width, 2);
    height = vtkNBufferMath::GetBaseSize(height, 2);
  }
  return true;
}

bool SingleLevel::CompileCompute(std::string& why)
{
  const unsigned int shader = glCreateShader(GL_COMPUTE_SHADER);
  const char* text = PeerReduceCS;
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  const unsigned int program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!compiled || !linked)
  {
    why = "the compute shader does not compile on this driver: " + GetLog(shader, false) +
      GetLog(program, true);
    glDeleteProgram(program);
    glDeleteShader(shader);
    vtkNBufferGL::ClearErrors();
    return false;
  }
  glDeleteShader(shader);
  this->ComputeProgram = program;
  return true;
}

bool SingleLevel::Dispatch(int factor, std::string& why)
{
  if (this->ComputeProgram == 0 && !this->CompileCompute(why))
  {
    return false;
  }
  glUseProgram(this->ComputeProgram);
  glUniform1i(glGetUniformLocation(this->ComputeProgram, "depth"), 0);
  glUniform2i(
    glGetUniformLocation(this->ComputeProgram, "size"), this->PixelWidth, this->PixelHeight);
  glUniform1i(glGetUniformLocation(this->ComputeProgram, "factor"), factor);
  glBindTexture(GL_TEXTURE_2D, this->Depth);
  glBindImageTexture(0, this->Targets[0].Texture, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  glDispatchCompute(static_cast<GLuint>(vtkNBufferMath::GetBaseSize(this->PixelWidth, GroupSide)),
    static_cast<GLuint>(vtkNBufferMath::GetBaseSize(this->PixelHeight, GroupSide)), 1);
  // Sampled, drawn into again or read back.
  glMemoryBarrier(
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT);
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  return true;
}

bool SingleLevel::Reduce(ReduceMethod method, int factor, std::string& why)
{
  why = WhyNot(method);
  if (!why.empty())
  {
    return false;
  }
  if (this->PixelWidth == 0 || (factor != 4 && factor != 8 && factor != 16))
  {
    why = this->PixelWidth == 0 ? "there is no depth; call SetDepth first"
                                : "the factor must be 4, 8 or 16";
    return false;
  }
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(this->Window);
  this->Width = vtkNBufferMath::GetBaseSize(this->PixelWidth, factor);
  this->Height = vtkNBufferMath::GetBaseSize(this->PixelHeight, factor);
  this->Timer = vtkNBufferGL::HasVersion(3, 3) && vtkOpenGLRenderTimer::IsSupported()
    ? std::make_unique<vtkOpenGLRenderTimer>()
    : nullptr;
  if (this->Timer)
  {
    // Rasterisers that collect draws before they begin would begin to count with the last of them,
    // and those that dispatch at once would not count that at all.
    this->Timer->Start();
    glFlush();
  }
  const bool done = method == ReduceMethod::Compute ? this->Dispatch(factor, why)
    : method == ReduceMethod::Passes                ? this->ReduceByPasses(factor, why)
                                                    : this->DrawPass(this->Depth, this->PixelWidth,
                                                        this->PixelHeight, factor, this->Targets[0], why);
  if (this->Timer)
  {
    this->Timer->Stop();
    glFlush();
  }
  return done && vtkNBufferGL::CheckErrors("Reducing depth", why);
}

double SingleLevel::GetDeviceTime()
{
  if (!this->Timer)
  {
    return -1.0;
  }
  glFinish();
  while (!this->Timer->Ready())
  {
  }
  return 1e-6 * static_cast<double>(this->Timer->GetElapsedNanoseconds());
}

bool SingleLevel::Download(std::vector<float>& level, std::string& why)
{
  vtkNBufferGL::ClearErrors();
  level.resize(static_cast<std::size_t>(this->Width) * this->Height);
  const vtkNBufferGL::ScopedReadback readback(this->Targets[0].Framebuffer);
  glReadPixels(0, 0, this->Width, this->Height, GL_RED, GL_FLOAT, level.data());
  return vtkNBufferGL::CheckErrors("Reading the level back", why);
}

void SingleLevel::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->ResourceCallback->IsReleasing())
  {
    this->ResourceCallback->Release();
    return;
  }
  if (window)
  {
    for (const Image& image : this->Targets)
    {
      glDeleteTextures(1, &image.Texture);
      glDeleteFramebuffers(1, &image.Framebuffer);
    }
    glDeleteTextures(1, &this->Depth);
    glDeleteVertexArrays(1, &this->VertexArray);
    if (this->ComputeProgram != 0)
    {
      glDeleteProgram(this->ComputeProgram);
    }
    this->Timer.reset();
  }
  this->Programs.clear();
  this->Targets[0] = this->Targets[1] = Image();
  this->Depth = this->VertexArray = this->ComputeProgram = 0;
  this->PixelWidth = this->PixelHeight = this->Width = this->Height = 0;
  this->Window = nullptr;
}

} // namespace NBufferPeers
