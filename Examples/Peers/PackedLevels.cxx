// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PackedLevels.h"

#include "PeerPackedLevelFS.h"
#include "PeerPackedQueryFS.h"

#include "PeerErrors.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferMath.h"
#include "vtkNBufferQuery.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace NBufferPeers
{
namespace
{
constexpr const char* Failure = "a shader of packed levels does not compile on this driver";

/// Returns how many images of this width fit side by side into a texture.
int CountColumns(int width, int levels)
{
  return std::min(vtkNBufferGL::GetInteger(GL_MAX_TEXTURE_SIZE) / width, levels);
}
}

PackedLevels::PackedLevels()
  : LevelPass(PeerPackedLevelFS, Failure)
  , QueryPass(PeerPackedQueryFS, Failure)
{
}

std::string PackedLevels::WhyNot(int width, int height)
{
  const int levels = vtkNBufferMath::GetNumberOfLevels(width, height);
  const int columns = CountColumns(width, levels);
  if (!vtkNBufferGL::HasVersion(4, 5))
  {
    return "glTextureBarrier() needs OpenGL 4.5";
  }
  return columns == 0 ||
      (levels + columns - 1) / columns * height > vtkNBufferGL::GetInteger(GL_MAX_TEXTURE_SIZE)
    ? "all levels do not fit into one texture"
    : "";
}

void PackedLevels::Build(vtkOpenGLRenderWindow* window, vtkNBufferTexture* base)
{
  this->Width = base->GetWidth();
  this->Height = base->GetHeight();
  const int levels = vtkNBufferMath::GetNumberOfLevels(this->Width, this->Height);
  this->Columns = CountColumns(this->Width, levels);
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(window);
  std::string why;
  ThrowUnless(this->Packed.ReserveTarget(GL_R32F, this->Columns * this->Width,
                (levels + this->Columns - 1) / this->Columns * this->Height, why),
    why);
  glCopyImageSubData(base->GetHandle(0), GL_TEXTURE_2D_ARRAY, 0, 0, 0, base->GetLayer(0),
    this->Packed.GetName(), GL_TEXTURE_2D, 0, 0, 0, 0, this->Width, this->Height, 1);
  glBindTexture(GL_TEXTURE_2D, this->Packed.GetName());
  const int last[2] = { this->Width - 1, this->Height - 1 };
  for (int level = 1; level < levels; ++level)
  {
    vtkShaderProgram* program = this->LevelPass.Begin(window, why);
    ThrowUnless(program, why);
    const auto corner = [this](int i, int axis)
    { return axis == 0 ? i % this->Columns * this->Width : i / this->Columns * this->Height; };
    const int from[2] = { corner(level - 1, 0), corner(level - 1, 1) };
    const int to[2] = { corner(level, 0), corner(level, 1) };
    program->SetUniformi("levels", 0);
    program->SetUniform2i("from", from);
    program->SetUniform2i("to", to);
    program->SetUniformi("side", 1 << (level - 1));
    program->SetUniform2i("last", last);
    glTextureBarrier();
    this->LevelPass.Draw(this->Packed.GetFramebuffer(), to[0], to[1], this->Width, this->Height);
  }
  glTextureBarrier();
  ThrowOnErrors("Building packed levels");
}

void PackedLevels::Query(vtkOpenGLRenderWindow* window, vtkNBufferTexture* levels)
{
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(window);
  std::string why;
  ThrowUnless(this->Answers.ReserveTarget(GL_R32F, this->Width, this->Height, why), why);
  vtkShaderProgram* program = this->QueryPass.Begin(window, why,
    std::string("#define NBUFFER_PACKED ") + (levels ? "0\n" : "1\n") + vtkNBufferQuery);
  ThrowUnless(program, why);
  const int size[2] = { this->Width, this->Height };
  program->SetUniform2i("shape.size", size);
  program->SetUniformi("shape.factor", 1);
  program->SetUniformi(
    "shape.levels", vtkNBufferMath::GetNumberOfLevels(this->Width, this->Height));
  if (levels)
  {
    program->SetUniformi("even", 0);
    program->SetUniformi("odd", 1);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D_ARRAY, levels->GetHandle(1));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, levels->GetHandle(0));
  }
  else
  {
    program->SetUniformi("levels", 0);
    program->SetUniformi("columns", this->Columns);
    glBindTexture(GL_TEXTURE_2D, this->Packed.GetName());
  }
  this->QueryPass.Draw(this->Answers.GetFramebuffer(), 0, 0, this->Width, this->Height);
  if (levels)
  {
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    glActiveTexture(GL_TEXTURE0);
  }
  ThrowOnErrors("Querying levels");
}

std::vector<float> PackedLevels::ReadDepths()
{
  std::vector<float> depths(static_cast<std::size_t>(this->Width) * this->Height);
  const vtkNBufferGL::ScopedReadback readback(this->Answers.GetFramebuffer());
  glReadPixels(0, 0, this->Width, this->Height, GL_RED, GL_FLOAT, depths.data());
  return depths;
}

void PackedLevels::Release()
{
  this->Packed.Delete();
  this->Answers.Delete();
  this->LevelPass.Delete();
  this->QueryPass.Delete();
}

} // namespace NBufferPeers
