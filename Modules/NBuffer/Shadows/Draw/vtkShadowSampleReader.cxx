// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSampleReader.h"

#include "vtkNBufferGL.h"
#include "vtkShadowSampleFS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN
vtkShadowSampleReader::vtkShadowSampleReader()
  : Pass(vtkShadowSampleFS,
      "The shader that reads samples does not compile on this driver. Update the driver, and "
      "report its message.")
{
}

bool vtkShadowSampleReader::Read(vtkOpenGLRenderWindow* window, unsigned int texture, int sample,
  int channel, const int rectangle[4], float* values, std::string& why)
{
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass scope(window);
  vtkShaderProgram* program = this->Image.ReserveTarget(GL_R32F, rectangle[2], rectangle[3], why)
    ? this->Pass.Begin(window, why)
    : nullptr;
  if (!program)
  {
    return false;
  }
  program->SetUniformi("samples", 0);
  program->SetUniformi("index", sample);
  program->SetUniformi("channel", channel);
  program->SetUniform2i("origin", rectangle);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
  this->Pass.Draw(this->Image.GetFramebuffer(), 0, 0, rectangle[2], rectangle[3]);
  const vtkNBufferGL::ScopedReadback readback(this->Image.GetFramebuffer());
  glReadPixels(0, 0, rectangle[2], rectangle[3], GL_RED, GL_FLOAT, values);
  return vtkNBufferGL::CheckErrors("Reading samples", why);
}

void vtkShadowSampleReader::Release()
{
  this->Image.Delete();
  this->Pass.Delete();
}
VTK_ABI_NAMESPACE_END
