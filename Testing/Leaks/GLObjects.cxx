// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLObjects.h"

#include "vtkNBufferVTKVersion.h"
#include VTKNBUFFER_GL_HEADER

namespace
{
/// Drivers either count names up, so that a new one is the highest, or reuse the free ones, which
/// leaves the highest within as many as ever lived at a time.
constexpr GLuint NamesBeyondTheNewest = 4096;

template <typename IsObject>
int CountNames(GLuint newest, IsObject isObject)
{
  int count = 0;
  for (GLuint name = 1; name <= newest + NamesBeyondTheNewest; ++name)
  {
    count += isObject(name) ? 1 : 0;
  }
  return count;
}

/// A name of the kind that these functions make.
template <typename Generate, typename Delete>
GLuint GetNewest(Generate generate, Delete remove)
{
  GLuint name = 0;
  generate(1, &name);
  remove(1, &name);
  return name;
}

// The functions of OpenGL are macros or pointers, as the loader has it: a lambda takes either.
#define COUNT(singular, plural)                                                                    \
  CountNames(GetNewest([](GLsizei n, GLuint* names) { glGen##plural(n, names); },                  \
               [](GLsizei n, const GLuint* names) { glDelete##plural(n, names); }),                \
    [](GLuint name) { return glIs##singular(name) == GL_TRUE; })
}

GLObjects::Counts GLObjects::Count()
{
  glFinish();
  Counts counts;
  counts["textures"] = COUNT(Texture, Textures);
  counts["buffers"] = COUNT(Buffer, Buffers);
  counts["framebuffers"] = COUNT(Framebuffer, Framebuffers);
  counts["renderbuffers"] = COUNT(Renderbuffer, Renderbuffers);
  counts["vertex arrays"] = COUNT(VertexArray, VertexArrays);
  counts["queries"] = COUNT(Query, Queries);
  // Programs and shaders share their names.
  const GLuint program = glCreateProgram();
  glDeleteProgram(program);
  counts["programs"] =
    CountNames(program, [](GLuint name) { return glIsProgram(name) == GL_TRUE; });
  counts["shaders"] = CountNames(program, [](GLuint name) { return glIsShader(name) == GL_TRUE; });
  return counts;
}
#undef COUNT
