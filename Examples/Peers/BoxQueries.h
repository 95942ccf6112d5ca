// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class BoxQueries
 * @brief Occlusion queries of OpenGL around boxes drawn without writing colour or depth.
 *
 * Boxes are compared with the bound framebuffer's depth by GL_LEQUAL. State goes through
 * vtkOpenGLState, so that draws of VTK in between find the state that they expect; nothing is read
 * back from OpenGL except the results of queries.
 */
#ifndef BoxQueries_h
#define BoxQueries_h

#include "ClipBox.h"

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
  Any,             ///< GL_ANY_SAMPLES_PASSED, OpenGL 3.3.
  AnyConservative, ///< GL_ANY_SAMPLES_PASSED_CONSERVATIVE, OpenGL 4.3: may say yes too often.
  Samples          ///< GL_SAMPLES_PASSED, counts them.
};

class BoxQueries
{
public:
  BoxQueries();
  ~BoxQueries();
  BoxQueries(const BoxQueries&) = delete;
  void operator=(const BoxQueries&) = delete;

  /// Why the current context does not have these queries; empty if it does.
  static std::string WhyNot(QueryTarget target);

  /// The queries of the last frame are used again. The window's context must be current.
  bool Begin(vtkOpenGLRenderWindow* window, QueryTarget target, std::string& why);

  /// Draw a box within a query; its number, counted from 0.
  int Ask(const ClipBox& box);

  bool HasAnswer(int query) const;

  /// Waits.
  bool IsVisible(int query) const;

  /// Queries since Begin().
  int GetCount() const { return this->Count; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::vector<unsigned int> Names;
  unsigned int Target = 0;
  unsigned int VertexArray = 0;
  int Count = 0;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkSmartPointer<vtkShaderProgram> Program;
  std::unique_ptr<vtkOpenGLResourceFreeCallback<BoxQueries>> ResourceCallback;
};

} // namespace NBufferPeers

#endif
