// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTieQuery.h"

#include "vtkNBufferGL.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferTieQuery
{
bool HasTies(const std::function<void()>& draw)
{
  int running = 0;
  glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &running);
  if (running != 0)
  {
    return true;
  }
  int count = 0;
  glGetIntegerv(GL_MAX_DRAW_BUFFERS, &count);
  std::vector<std::array<GLboolean, 4>> colorMasks(static_cast<std::size_t>(count));
  for (GLuint i = 0; i < colorMasks.size(); ++i)
  {
    glGetBooleani_v(GL_COLOR_WRITEMASK, i, colorMasks[i].data());
  }
  int depthFunction = GL_LEQUAL;
  glGetIntegerv(GL_DEPTH_FUNC, &depthFunction);
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  // Fragments that have the depth of their sample pass, and none writes a color.
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthFunc(GL_EQUAL);
  draw();
  glDepthFunc(static_cast<GLenum>(depthFunction));
  for (GLuint i = 0; i < colorMasks.size(); ++i)
  {
    const std::array<GLboolean, 4>& mask = colorMasks[i];
    glColorMaski(i, mask[0], mask[1], mask[2], mask[3]);
  }
  glEndQuery(GL_SAMPLES_PASSED);
  GLuint passed = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
  glDeleteQueries(1, &query);
  return passed > 0;
}
}
VTK_ABI_NAMESPACE_END
