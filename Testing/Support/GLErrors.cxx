// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLErrors.h"

#include "vtkNBufferVTKVersion.h"
#include VTKNBUFFER_GL_HEADER

#include <sstream>
#include <utility>

namespace
{
std::string& GetCollected()
{
  static std::string text;
  return text;
}

#ifdef GL_DEBUG_OUTPUT
using Report = void (*)(const char*);

void OnDebugMessage(
  GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void* report)
{
  if (type == GL_DEBUG_TYPE_ERROR)
  {
    reinterpret_cast<Report>(const_cast<void*>(report))(text);
  }
}
#endif
}

void ReportGLErrors(void (*report)(const char* text))
{
#ifdef GL_DEBUG_OUTPUT
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (major > 4 || (major == 4 && minor >= 3))
  {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(
      reinterpret_cast<GLDEBUGPROC>(&OnDebugMessage), reinterpret_cast<void*>(report));
  }
#else
  (void)report;
#endif
}

void CollectGLErrors()
{
  ReportGLErrors([](const char* text) { GetCollected() += std::string(text) + "\n"; });
}

std::string TakeGLErrors(bool* isPending)
{
  std::string errors;
  std::swap(errors, GetCollected());
  // Without a context there is no end of errors.
  constexpr int most = 16;
  GLenum error = glGetError();
  if (isPending)
  {
    *isPending = error != GL_NO_ERROR;
  }
  for (int i = 0; i < most && error != GL_NO_ERROR; ++i, error = glGetError())
  {
    std::ostringstream text;
    text << "OpenGL error 0x" << std::hex << error << "\n";
    errors += text.str();
  }
  return errors;
}
