// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferOwnDraw
 * @brief Draws in the place of a draw of vtkOpenGLPolyDataMapper.
 *
 * When everything for the mapper's draw has been bound (vtkCommand::UpdateShaderEvent), this class
 * calls a function that draws, and then sets the number of indices of VTK's own draw to 0. Program,
 * textures, uniforms and vertices are VTK's.
 *
 * This does not stop a draw without an index buffer (vtkNBufferSplatStream). Such a draw is made
 * after glBeginConditionalRender() with a query that has counted nothing, so that OpenGL discards
 * it.
 *
 * If a mesh has scalars or normals of cells, ranges of VTK's own list of indices are drawn. The
 * shader of vtkOpenGLPolyDataMapper reads the values of a cell from a texture, at the place
 * gl_PrimitiveID + PrimitiveIDOffset. OpenGL counts gl_PrimitiveID from the beginning of each draw,
 * so that the triangles of a shortened list would get the values of other cells. Each range is
 * drawn with the number of its first primitive in the uniform variable PrimitiveIDOffset.
 */
#ifndef vtkNBufferOwnDraw_h
#define vtkNBufferOwnDraw_h

#include "vtkNBufferGLObject.h"
#include "vtkNBufferUnits.h"
#include "vtkOpenGLPolyDataMapper.h" // For the smart pointer
#include "vtkSmartPointer.h"

#include <cstddef>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLHelper;

class vtkNBufferOwnDraw
{
public:
  vtkNBufferOwnDraw() = default;
  ~vtkNBufferOwnDraw() { this->Restore(); }
  vtkNBufferOwnDraw(const vtkNBufferOwnDraw&) = delete;
  void operator=(const vtkNBufferOwnDraw&) = delete;

  /// Let `draw` draw in the place of the mapper, which is setting the shader parameters of
  /// `stream`. If `draw` returns false, it has drawn nothing, and VTK draws. `hasIndices` says
  /// whether VTK's draw has an index buffer.
  void SetNext(vtkOpenGLPolyDataMapper* mapper, vtkOpenGLHelper* stream, bool hasIndices,
    const std::function<bool()>& draw);

  /// Undo what SetNext() has changed.
  void Restore();

  void ReleaseGraphicsResources() { this->Nothing.Delete(); }

  /// Draw ranges of the primitives of a stream, when everything else has been bound. Returns false
  /// if there are none.
  static bool DrawRanges(
    const std::vector<vtkNBufferUnits::Range>& ranges, vtkOpenGLHelper* stream);

  /// Whether the shader of a stream reads values by the numbers of primitives. To be called while
  /// VTK is setting the parameters of that shader.
  static bool NumbersPrimitives(vtkOpenGLHelper* stream);

private:
  void Draw();

  vtkSmartPointer<vtkOpenGLPolyDataMapper> Mapper; ///< The mapper of the draw that is running.
  vtkOpenGLHelper* Stream = nullptr;
  std::function<bool()> Function;
  unsigned long Observer = 0;
  std::size_t IndexCount = 0; ///< The stream's number of indices, while that is set to 0.
  bool HasIndices = true;
  vtkNBufferGL::Query Nothing; ///< A query that has counted nothing, once it is needed.
  bool IsDiscarding = false;   ///< Whether OpenGL discards all draws until Restore().
};

VTK_ABI_NAMESPACE_END
#endif
