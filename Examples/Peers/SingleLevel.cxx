// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SingleLevel.h"

#include "PeerBaseFS.h"
#include "PeerReduceCS.h"

#include "PeerErrors.h"
#include "Shaders/vtkNBufferShared.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferMath.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace NBufferPeers
{
namespace
{
/// The invocations of a work group of the compute shader along each axis.
constexpr int GroupSide = 16;
}

SingleLevel::SingleLevel()
  : Pass(PeerBaseFS, "the shader of a pass does not compile on this driver")
  , Compute(PeerReduceCS)
{
}

std::string SingleLevel::WhyNot(ReduceMethod method)
{
  return method == ReduceMethod::Compute ? vtkNBufferGL::ComputePrograms::WhyNot() : "";
}

void SingleLevel::SetDepth(
  vtkOpenGLRenderWindow* window, const std::vector<float>& depth, int width, int height)
{
  this->Window = window;
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(window);
  const vtkNBufferGL::ScopedUpload upload(0);
  this->PixelWidth = width;
  this->PixelHeight = height;
  std::string why;
  ThrowUnless(this->Depth.Reserve(GL_DEPTH_COMPONENT32F, width, height, why), why);
  glBindTexture(GL_TEXTURE_2D, this->Depth.GetName());
  glTexSubImage2D(
    GL_TEXTURE_2D, 0, 0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  // There is room for the largest level that passes of 2 x 2 leave on their way.
  for (vtkNBufferGL::GrowingTexture& target : this->Targets)
  {
    ThrowUnless(target.ReserveTarget(GL_R32F, vtkNBufferMath::GetBaseSize(width, 2),
                  vtkNBufferMath::GetBaseSize(height, 2), why),
      why);
  }
  ThrowOnErrors("Uploading depth");
}

void SingleLevel::DrawPass(unsigned int source, int width, int height, int factor, int target)
{
  std::string why;
  const auto define = [](const char* name, int value)
  { return std::string("#define ") + name + " " + std::to_string(value) + "\n"; };
  vtkShaderProgram* program = this->Pass.Begin(this->Window, why,
    define("NBUFFER_MAXIMUM", 1) + define("NBUFFER_BOTH", 0) +
      define("NBUFFER_SOURCE", NBUFFER_SOURCE_DEPTH) + define("NBUFFER_FACTOR", factor) +
      define("NBUFFER_SAMPLES", 1) + define("NBUFFER_INEXACT", 0));
  ThrowUnless(program, why);
  const int origin[2] = { 0, 0 };
  const int last[2] = { width - 1, height - 1 };
  program->SetUniformi("depth", 0);
  program->SetUniform2i("origin", origin);
  program->SetUniform2i("last", last);
  glBindTexture(GL_TEXTURE_2D, source);
  this->Pass.Draw(this->Targets[target].GetFramebuffer(), 0, 0,
    vtkNBufferMath::GetBaseSize(width, factor), vtkNBufferMath::GetBaseSize(height, factor));
}

void SingleLevel::ReduceByPasses(int factor)
{
  unsigned int source = this->Depth.GetName();
  int width = this->PixelWidth;
  int height = this->PixelHeight;
  for (int side = factor; side > 1; side /= 2)
  {
    // The last pass draws into the first target.
    const int target = side == 2 || side == 8 ? 0 : 1;
    this->DrawPass(source, width, height, 2, target);
    source = this->Targets[target].GetName();
    width = vtkNBufferMath::GetBaseSize(width, 2);
    height = vtkNBufferMath::GetBaseSize(height, 2);
  }
}

void SingleLevel::Dispatch(int factor)
{
  std::string why;
  const unsigned int program = this->Compute.Use(why);
  ThrowUnless(program != 0, why);
  glUniform1i(glGetUniformLocation(program, "depth"), 0);
  glUniform2i(glGetUniformLocation(program, "size"), this->PixelWidth, this->PixelHeight);
  glUniform1i(glGetUniformLocation(program, "factor"), factor);
  glBindTexture(GL_TEXTURE_2D, this->Depth.GetName());
  glBindImageTexture(0, this->Targets[0].GetName(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  glDispatchCompute(static_cast<GLuint>(vtkNBufferMath::GetBaseSize(this->PixelWidth, GroupSide)),
    static_cast<GLuint>(vtkNBufferMath::GetBaseSize(this->PixelHeight, GroupSide)), 1);
  // Sampled, drawn into again or read back.
  glMemoryBarrier(
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT);
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
}

void SingleLevel::Reduce(ReduceMethod method, int factor)
{
  const std::string why = WhyNot(method);
  ThrowUnless(why.empty(), why);
  ThrowUnless(this->PixelWidth > 0, "there is no depth; call SetDepth first");
  ThrowUnless(factor == 4 || factor == 8 || factor == 16, "the factor must be 4, 8 or 16");
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(this->Window);
  this->Width = vtkNBufferMath::GetBaseSize(this->PixelWidth, factor);
  this->Height = vtkNBufferMath::GetBaseSize(this->PixelHeight, factor);
  this->Timer.Start();
  if (method == ReduceMethod::Compute)
  {
    this->Dispatch(factor);
  }
  else if (method == ReduceMethod::Passes)
  {
    this->ReduceByPasses(factor);
  }
  else
  {
    this->DrawPass(this->Depth.GetName(), this->PixelWidth, this->PixelHeight, factor, 0);
  }
  this->Timer.Stop();
  ThrowOnErrors("Reducing depth");
}

void SingleLevel::Download(std::vector<float>& level)
{
  vtkNBufferGL::ClearErrors();
  level.resize(static_cast<std::size_t>(this->Width) * this->Height);
  const vtkNBufferGL::ScopedReadback readback(this->Targets[0].GetFramebuffer());
  glReadPixels(0, 0, this->Width, this->Height, GL_RED, GL_FLOAT, level.data());
  ThrowOnErrors("Reading the level back");
}

} // namespace NBufferPeers
