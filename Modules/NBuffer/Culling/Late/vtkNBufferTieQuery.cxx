// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTieQuery.h"

#include "vtkNBufferGL.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// While it lives, fragments that have the depth of their sample pass, and none writes a color.
class EqualDepthOnly
{
public:
  EqualDepthOnly()
  {
    int count = 0;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &count);
    this->ColorMasks.resize(static_cast<std::size_t>(count));
    for (GLuint i = 0; i < this->ColorMasks.size(); ++i)
    {
      glGetBooleani_v(GL_COLOR_WRITEMASK, i, this->ColorMasks[i].data());
    }
    glGetIntegerv(GL_DEPTH_FUNC, &this->DepthFunction);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_EQUAL);
  }

  ~EqualDepthOnly()
  {
    glDepthFunc(static_cast<GLenum>(this->DepthFunction));
    for (GLuint i = 0; i < this->ColorMasks.size(); ++i)
    {
      const std::array<GLboolean, 4>& mask = this->ColorMasks[i];
      glColorMaski(i, mask[0], mask[1], mask[2], mask[3]);
    }
  }

  EqualDepthOnly(const EqualDepthOnly&) = delete;
  void operator=(const EqualDepthOnly&) = delete;

private:
  std::vector<std::array<GLboolean, 4>> ColorMasks; ///< Of each draw buffer.
  int DepthFunction = GL_LEQUAL;
};
}

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
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  {
    const EqualDepthOnly scope;
    draw();
  }
  glEndQuery(GL_SAMPLES_PASSED);
  GLuint passed = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
  glDeleteQueries(1, &query);
  return passed > 0;
}
}
VTK_ABI_NAMESPACE_END
