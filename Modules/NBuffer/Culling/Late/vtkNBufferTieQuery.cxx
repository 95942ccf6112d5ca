// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTieQuery.h"

#include "vtkNBufferGL.h"
#include "vtkNBufferGLObject.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// While an object of this class exists, the query counts the fragments that have the depth of
/// their sample, and no fragment writes a color. The state is restored even if an observer of the
/// application throws an exception.
class EqualDepthOnly : public vtkNBufferGL::Scope
{
public:
  explicit EqualDepthOnly(GLuint query)
  {
    int count = 0;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &count);
    std::vector<std::array<GLboolean, 4>> colorMasks(static_cast<std::size_t>(count));
    for (GLuint i = 0; i < colorMasks.size(); ++i)
    {
      glGetBooleani_v(GL_COLOR_WRITEMASK, i, colorMasks[i].data());
    }
    int depthFunction = GL_LEQUAL;
    glGetIntegerv(GL_DEPTH_FUNC, &depthFunction);
    this->AtEnd(
      [colorMasks, depthFunction]()
      {
        glEndQuery(GL_SAMPLES_PASSED);
        glDepthFunc(static_cast<GLenum>(depthFunction));
        for (GLuint i = 0; i < colorMasks.size(); ++i)
        {
          const std::array<GLboolean, 4>& mask = colorMasks[i];
          glColorMaski(i, mask[0], mask[1], mask[2], mask[3]);
        }
      });
    glBeginQuery(GL_SAMPLES_PASSED, query);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_EQUAL);
  }
};
}

namespace vtkNBufferTieQuery
{
bool HasTies(const std::function<void()>& draw)
{
  if (vtkNBufferGL::IsCountingSamples())
  {
    return true;
  }
  vtkNBufferGL::Query query;
  {
    const EqualDepthOnly scope(query.Create());
    draw();
  }
  GLuint passed = 0;
  glGetQueryObjectuiv(query.GetName(), GL_QUERY_RESULT, &passed);
  return passed > 0;
}
}
VTK_ABI_NAMESPACE_END
