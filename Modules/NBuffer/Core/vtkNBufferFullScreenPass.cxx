// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferFullScreenPass.h"

#include "vtkNBufferFullScreenVS.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferSharedText.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferGL
{
vtkShaderProgram* UseProgram(vtkOpenGLRenderWindow* window,
  vtkSmartPointer<vtkShaderProgram>& program, const char* vertexShader,
  const std::string& fragmentShader, const char* failure, std::string& why)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  program = program ? cache->ReadyShaderProgram(program)
                    : cache->ReadyShaderProgram(vertexShader, fragmentShader.c_str(), "");
  if (!program)
  {
    why = failure;
  }
  return program;
}

vtkShaderProgram* FullScreenPass::Begin(
  vtkOpenGLRenderWindow* window, std::string& why, const std::string& definitions)
{
  vtkSmartPointer<vtkShaderProgram>& program = this->Programs[definitions];
  std::string text;
  if (!program)
  {
    text = this->FragmentShader;
    vtkShaderProgram::Substitute(text, "//VTK::NBuffer::Shared", vtkNBufferSharedText);
    vtkShaderProgram::Substitute(text, "//VTK::NBuffer::Dec", definitions);
  }
  return UseProgram(window, program, vtkNBufferFullScreenVS, text, this->Failure, why);
}

void FullScreenPass::Draw()
{
  glBindVertexArray(this->Empty.Create());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void FullScreenPass::Draw(unsigned int framebuffer, int x, int y, int width, int height)
{
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glViewport(x, y, width, height);
  this->Draw();
}

void FullScreenPass::Delete(Context context)
{
  this->Empty.Delete(context);
  this->Programs.clear();
}
}
VTK_ABI_NAMESPACE_END
