// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComputePrograms.h"

#include "vtkNBufferGL.h"

#include "vtkShaderProgram.h"

namespace NBufferPeers
{

std::string ComputePrograms::WhyNot()
{
  return vtkNBufferGL::HasVersion(4, 3) ? "" : "compute shaders need OpenGL 4.3";
}

unsigned int ComputePrograms::Use(std::string& why, const std::string& definitions)
{
  unsigned int& program = this->Programs[definitions];
  if (program == 0)
  {
    std::string text = this->Text;
    vtkShaderProgram::Substitute(text, "//VTK::NBuffer::Dec", definitions);
    const char* source = text.c_str();
    const unsigned int shader = glCreateShader(GL_COMPUTE_SHADER);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    program = glCreateProgram();
    glAttachShader(program, shader);
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked)
    {
      // Where the shader did not compile, the program does not link either.
      char log[1024] = "";
      glGetShaderInfoLog(shader, sizeof(log), nullptr, log);
      why = std::string("the compute shader does not compile on this driver: ") + log;
      glGetProgramInfoLog(program, sizeof(log), nullptr, log);
      why += log;
      glDeleteProgram(program);
      program = 0;
      vtkNBufferGL::ClearErrors();
    }
    glDeleteShader(shader);
  }
  if (program != 0)
  {
    glUseProgram(program);
  }
  return program;
}

void ComputePrograms::Delete()
{
  for (const auto& [definitions, program] : this->Programs)
  {
    glDeleteProgram(program);
  }
  this->Programs.clear();
}

} // namespace NBufferPeers
