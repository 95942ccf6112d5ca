// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferComputePrograms.h"

#include "vtkNBufferComputeDec.h"
#include "vtkNBufferQuery.h"
#include "vtkNBufferSharedText.h"

#include "vtkShaderProgram.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferGL
{
std::string ComputePrograms::WhyNot()
{
  const bool hasShaders = HasFeature(4, 3, "GL_ARB_compute_shader") &&
    HasFeature(4, 3, "GL_ARB_shader_storage_buffer_object") &&
    HasFeature(4, 3, "GL_ARB_clear_buffer_object");
  return hasShaders ? ""
                    : "compute shaders need OpenGL 4.3, or GL_ARB_compute_shader, "
                      "GL_ARB_shader_storage_buffer_object and GL_ARB_clear_buffer_object";
}

unsigned int ComputePrograms::Use(std::string& why, const std::string& definitions)
{
  unsigned int& program = this->Programs[definitions];
  if (program == 0)
  {
    std::string text = this->Text;
    if (!HasVersion(4, 3))
    {
      text.replace(0, text.find('\n'), vtkNBufferComputeDec); // The version is in the first line.
    }
    vtkShaderProgram::Substitute(text, "//VTK::NBuffer::Dec", definitions);
    vtkShaderProgram::Substitute(text, "//VTK::NBuffer::Shared", vtkNBufferSharedText);
    vtkShaderProgram::Substitute(text, "//VTK::NBuffer::Query", vtkNBufferQuery);
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
      ClearErrors();
    }
    glDeleteShader(shader);
  }
  if (program != 0)
  {
    glUseProgram(program);
  }
  return program;
}

void ComputePrograms::Delete(Context context)
{
  for (const auto& [definitions, program] : this->Programs)
  {
    if (context == Context::Current)
    {
      glDeleteProgram(program);
    }
  }
  this->Programs.clear();
}

ScopedCompute::ScopedCompute()
{
  this->AtEnd([program = GetInteger(GL_CURRENT_PROGRAM)] { glUseProgram(program); });
  // This one is restored last: the bindings by number change it as well.
  this->AtEnd([buffer = GetInteger(GL_SHADER_STORAGE_BUFFER_BINDING)]
    { glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer); });
  for (GLuint number = 0; number < NumberOfBuffers; ++number)
  {
    GLint buffer = 0;
    GLint64 start = 0;
    GLint64 size = 0; // 0: the whole buffer
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, number, &buffer);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, number, &start);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, number, &size);
    this->AtEnd(
      [number, buffer, start, size]
      {
        if (size > 0)
        {
          glBindBufferRange(GL_SHADER_STORAGE_BUFFER, number, buffer, start, size);
        }
        else
        {
          glBindBufferBase(GL_SHADER_STORAGE_BUFFER, number, buffer);
        }
      });
  }
  this->AtEnd([unit = GetInteger(GL_ACTIVE_TEXTURE)] { glActiveTexture(unit); });
  for (const GLenum unit : { GL_TEXTURE0, GL_TEXTURE1 })
  {
    glActiveTexture(unit);
    this->AtEnd(
      [unit, texture = GetInteger(GL_TEXTURE_BINDING_2D_ARRAY),
        sampler = GetInteger(GL_SAMPLER_BINDING)]
      {
        glActiveTexture(unit);
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
        glBindSampler(unit - GL_TEXTURE0, sampler);
      });
    glBindSampler(unit - GL_TEXTURE0, 0);
  }
}

void BindStorage(unsigned int number, unsigned int buffer)
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, number, buffer);
}

void AllocateStorage(unsigned int buffer, std::size_t bytes, const void* data)
{
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  GLint64 size = 0;
  glGetBufferParameteri64v(GL_SHADER_STORAGE_BUFFER, GL_BUFFER_SIZE, &size);
  if (static_cast<std::size_t>(size) < bytes)
  {
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
  }
  else if (data)
  {
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), data);
  }
}

std::size_t GetLargestStorage()
{
  return static_cast<std::size_t>(std::max(GetInteger(GL_MAX_SHADER_STORAGE_BLOCK_SIZE), 0));
}
}
VTK_ABI_NAMESPACE_END
