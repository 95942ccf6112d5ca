// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class BoxQueries
 * @brief Occlusion queries of OpenGL around boxes that are drawn without writing colour or depth.
 *
 * The boxes are compared with the depth of the bound framebuffer by GL_LEQUAL. All changes of state
 * go through vtkOpenGLState, so that VTK's own draws between the queries work as usual. Nothing is
 * read back from the device except for the answers of the queries.
 */
#ifndef BoxQueries_h
#define BoxQueries_h

#include "ClipBox.h"

#include "vtkNBufferGLObject.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
template <class T>
class vtkOpenGLResourceFreeCallback;

namespace NBufferPeers
{

enum class QueryTarget
{
  Any,             ///< GL_ANY_SAMPLES_PASSED; needs OpenGL 3.3.
  AnyConservative, ///< GL_ANY_SAMPLES_PASSED_CONSERVATIVE: may say yes too often; needs OpenGL 4.3.
  Samples          ///< GL_SAMPLES_PASSED: counts the samples.
};

class BoxQueries
{
public:
  BoxQueries();
  ~BoxQueries();
  BoxQueries(const BoxQueries&) = delete;
  void operator=(const BoxQueries&) = delete;

  /// Returns why the current context does not have these queries, or an empty text if it has.
  static std::string WhyNot(QueryTarget target);

  /// Begins a frame, which reuses the queries of the frame before. The window's context must be
  /// current. Returns false, with the cause in `why`, if the context cannot do this.
  bool Begin(vtkOpenGLRenderWindow* window, QueryTarget target, std::string& why);

  /// Draws a box within a query. Returns the number of the query in this frame, from 0 on.
  int Query(const ClipBox& box);

  /// Returns whether the answer of a query has arrived.
  bool HasAnswer(int query) const;

  /// Waits for the answer of a query, and returns whether a sample passed the depth test.
  bool IsVisible(int query) const;

  /// Returns the number of queries since Begin().
  int GetCount() const { return this->Count; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::vector<vtkNBufferGL::Query> Queries;
  vtkNBufferGL::VertexArray Empty; ///< A vertex array without attributes: the shader needs none.
  unsigned int Target = 0;
  int Count = 0;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkSmartPointer<vtkShaderProgram> Program;
  std::unique_ptr<vtkOpenGLResourceFreeCallback<BoxQueries>> ResourceCallback;
};

} // namespace NBufferPeers

#endif
