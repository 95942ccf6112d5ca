// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthChain.h"

#include "PeerChainFS.h"
#include "PeerGroupCS.h"

#include "PeerErrors.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferMath.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace NBufferPeers
{
namespace
{
/// The pixels of a work group along each axis.
constexpr int Cell = 16;

std::string Define(const char* name, int value)
{
  return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

/// While it lives, fragments write their depth, whatever it is.
class ScopedDepthWrites : public vtkNBufferGL::Scope
{
public:
  ScopedDepthWrites()
  {
    this->AtEnd(
      [function = vtkNBufferGL::GetInteger(GL_DEPTH_FUNC),
        mask = vtkNBufferGL::GetInteger(GL_DEPTH_WRITEMASK)]
      {
        glDepthFunc(function);
        glDepthMask(static_cast<GLboolean>(mask));
        glDisable(GL_DEPTH_TEST); // As ScopedPass leaves it.
      });
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
  }
};

/// Makes one level of the array that is bound the only one that shaders read.
void ReadLevel(int level)
{
  // In this order the base level never exceeds the maximum level.
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, level);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, level);
}

/// Makes a framebuffer that draws into one layer of one level.
vtkNBufferGL::Framebuffer MakeTarget(GLenum attachment, unsigned int texture, int level, int layer)
{
  vtkNBufferGL::Framebuffer target;
  glBindFramebuffer(GL_FRAMEBUFFER, target.Create());
  glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment, texture, level, layer);
  if (attachment == GL_DEPTH_ATTACHMENT)
  {
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }
  return target;
}
}

DepthChain::DepthChain()
  : Pass(PeerChainFS, "the shader of a chain does not compile on this driver")
  , Groups(PeerGroupCS)
{
}

int DepthChain::GetNumberOfLevels() const
{
  int levels = 1;
  while (std::max(this->Width, this->Height) >> levels > 0)
  {
    ++levels;
  }
  return levels;
}

int DepthChain::GetLevelSize(int size, int level)
{
  return std::max(size >> level, 1);
}

unsigned int DepthChain::GetFramebuffer(int level, int layer) const
{
  return this->ChainTargets[static_cast<std::size_t>(level * this->Layers + layer)].GetName();
}

void DepthChain::Allocate()
{
  this->ChainTargets.clear();
  this->LevelTargets.clear();
  this->Level.Delete();
  this->Chain.Delete();
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Level.Create());
  vtkNBufferGL::SetPlainSampling(GL_TEXTURE_2D_ARRAY);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32F, vtkNBufferMath::GetBaseSize(this->Width, Cell),
    vtkNBufferMath::GetBaseSize(this->Height, Cell), this->Layers, 0, GL_RED, GL_FLOAT, nullptr);
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Chain.Create());
  vtkNBufferGL::SetPlainSampling(GL_TEXTURE_2D_ARRAY);
  const int levels = this->GetNumberOfLevels();
  if (vtkNBufferGL::HasVersion(4, 2))
  {
    // Then OpenGL allows drawing into a level that shaders do not read.
    glTexStorage3D(
      GL_TEXTURE_2D_ARRAY, levels, GL_DEPTH_COMPONENT32F, this->Width, this->Height, this->Layers);
  }
  else
  {
    // Mesa allocates the levels together if it knows how many there will be.
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, levels - 1);
    for (int level = 0; level < levels; ++level)
    {
      glTexImage3D(GL_TEXTURE_2D_ARRAY, level, GL_DEPTH_COMPONENT32F,
        GetLevelSize(this->Width, level), GetLevelSize(this->Height, level), this->Layers, 0,
        GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    }
  }
  for (int i = 0; i < levels * this->Layers; ++i)
  {
    this->ChainTargets.push_back(
      MakeTarget(GL_DEPTH_ATTACHMENT, this->Chain.GetName(), i / this->Layers, i % this->Layers));
  }
  bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  for (int layer = 0; layer < this->Layers; ++layer)
  {
    this->LevelTargets.push_back(MakeTarget(GL_COLOR_ATTACHMENT0, this->Level.GetName(), 0, layer));
  }
  complete = complete && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  ThrowUnless(complete, "the device cannot draw into the layers of an array of depth");
}

void DepthChain::SetDepth(vtkOpenGLRenderWindow* window,
  const std::vector<std::vector<float>>& layers, int width, int height)
{
  this->Window = window;
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(window);
  const vtkNBufferGL::ScopedUpload upload(0);
  this->Width = width;
  this->Height = height;
  this->Layers = static_cast<int>(layers.size());
  this->Allocate();
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Chain.GetName());
  for (int layer = 0; layer < this->Layers; ++layer)
  {
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, width, height, 1, GL_DEPTH_COMPONENT,
      GL_FLOAT, layers[static_cast<std::size_t>(layer)].data());
  }
  ThrowOnErrors("Uploading depth");
}

void DepthChain::BuildChain(ChainEdges edges, int count)
{
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(this->Window);
  const ScopedDepthWrites writes;
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Chain.GetName());
  this->Timer.Start();
  std::string why;
  vtkShaderProgram* program =
    this->Pass.Begin(this->Window, why, Define("PEER_FAT", edges == ChainEdges::Fat));
  ThrowUnless(program, why);
  const int end = std::min(count + 1, this->GetNumberOfLevels());
  for (int level = 1; level < end; ++level)
  {
    ReadLevel(level - 1);
    const int size[2] = { GetLevelSize(this->Width, level - 1),
      GetLevelSize(this->Height, level - 1) };
    program->SetUniformi("depth", 0);
    program->SetUniform2i("size", size);
    for (int layer = 0; layer < this->Layers; ++layer)
    {
      program->SetUniformi("layer", layer);
      this->Pass.Draw(this->GetFramebuffer(level, layer), 0, 0, GetLevelSize(this->Width, level),
        GetLevelSize(this->Height, level));
    }
  }
  this->Timer.Stop();
  ThrowOnErrors("Building a chain");
}

void DepthChain::BuildGroups(const GroupForm& form)
{
  std::string why = WhyNotGroups();
  ThrowUnless(why.empty(), why);
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(this->Window);
  const unsigned int program = this->Groups.Use(why,
    Define("PEER_SIDE", form.Side) + Define("PEER_GATHER", form.Gather) +
      Define("PEER_ATOMICS", form.Atomics));
  ThrowUnless(program != 0, why);
  glUniform1i(glGetUniformLocation(program, "depth"), 0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Chain.GetName());
  ReadLevel(0);
  glBindImageTexture(0, this->Level.GetName(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
  this->Timer.Start();
  glDispatchCompute(static_cast<GLuint>(vtkNBufferMath::GetBaseSize(this->Width, Cell)),
    static_cast<GLuint>(vtkNBufferMath::GetBaseSize(this->Height, Cell)),
    static_cast<GLuint>(this->Layers));
  // Sampled or read back.
  glMemoryBarrier(
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT);
  this->Timer.Stop();
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  ThrowOnErrors("Reducing depth");
}

std::vector<float> DepthChain::DownloadChain(int level, int layer)
{
  vtkNBufferGL::ClearErrors();
  const int width = GetLevelSize(this->Width, level);
  const int height = GetLevelSize(this->Height, level);
  std::vector<float> texels(static_cast<std::size_t>(width) * height);
  const vtkNBufferGL::ScopedReadback readback(this->GetFramebuffer(level, layer));
  glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, texels.data());
  ThrowOnErrors("Reading a level back");
  return texels;
}

std::vector<float> DepthChain::DownloadGroups(int layer)
{
  vtkNBufferGL::ClearErrors();
  const int width = vtkNBufferMath::GetBaseSize(this->Width, Cell);
  const int height = vtkNBufferMath::GetBaseSize(this->Height, Cell);
  std::vector<float> texels(static_cast<std::size_t>(width) * height);
  const vtkNBufferGL::ScopedReadback readback(
    this->LevelTargets[static_cast<std::size_t>(layer)].GetName());
  glReadPixels(0, 0, width, height, GL_RED, GL_FLOAT, texels.data());
  ThrowOnErrors("Reading the level back");
  return texels;
}

} // namespace NBufferPeers
