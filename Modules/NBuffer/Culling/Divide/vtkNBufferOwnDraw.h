// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferOwnDraw
 * @brief Draws in the place of a draw of vtkOpenGLPolyDataMapper.
 *
 * When everything for the mapper's draw has been bound (vtkCommand::UpdateShaderEvent), this class
 * calls a function that draws, and then lets VTK's own draw have no indices. Program, textures,
 * uniforms and vertices are VTK's.
 *
 * A draw without an index buffer (vtkNBufferSplatStream) takes no notice of that. OpenGL discards
 * it instead: within glBeginConditionalRender() with a query that has counted nothing, nothing is
 * drawn.
 *
 * Of a mesh that has scalars or normals of cells, ranges of VTK's own list of indices are drawn.
 * The shader of vtkOpenGLPolyDataMapper reads the values of a cell from a texture, at the place
 * gl_PrimitiveID + PrimitiveIDOffset. OpenGL counts gl_PrimitiveID from the beginning of each draw,
 * so that the triangles of a shortened list would have the values of others. Each range is drawn
 * with the number of its first primitive in the uniform variable PrimitiveIDOffset.
 */
#ifndef vtkNBufferOwnDraw_h
#define vtkNBufferOwnDraw_h

#include "vtkNBufferUnits.h"
#include "vtkOpenGLPolyDataMapper.h" // For the smart pointer
#include "vtkSmartPointer.h"

#include <cstddef>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLHelper;
class vtkOpenGLIndexBufferObject;

class vtkNBufferOwnDraw
{
public:
  vtkNBufferOwnDraw() = default;
  ~vtkNBufferOwnDraw() { this->Restore(); }
  vtkNBufferOwnDraw(const vtkNBufferOwnDraw&) = delete;
  void operator=(const vtkNBufferOwnDraw&) = delete;

  /// Let `draw` draw instead of the mapper, the shader parameters of whose stream are being set. If
  /// it returns false, it has drawn nothing, and VTK draws. `hasIndices`: whether VTK's draw has an
  /// index buffer.
  void SetNext(vtkOpenGLPolyDataMapper* mapper, vtkOpenGLHelper* stream, bool hasIndices,
    const std::function<bool()>& draw);

  /// Undo what SetNext() has changed.
  void Restore();

  void ReleaseGraphicsResources();

  ///@{
  /// Draw primitives by a list of indices, or ranges of the primitives of a stream, for which
  /// everything has been bound. Returns false if there are none.
  static bool DrawIndices(vtkOpenGLIndexBufferObject* indices, bool arePoints);
  static bool DrawRanges(
    const std::vector<vtkNBufferUnits::Range>& ranges, vtkOpenGLHelper* stream);
  ///@}

  /// Whether the shader of a stream, whose parameters are being set, reads values by the numbers of
  /// primitives.
  static bool NumbersPrimitives(vtkOpenGLHelper* stream);

private:
  void Draw();

  vtkSmartPointer<vtkOpenGLPolyDataMapper> Mapper; ///< Of the draw that is running.
  vtkOpenGLHelper* Stream = nullptr;
  std::function<bool()> Function;
  unsigned long Observer = 0;
  std::size_t IndexCount = 0; ///< That of the stream, while it has been taken away.
  bool HasIndices = true;
  unsigned int Nothing = 0;  ///< A query that has counted nothing, or 0.
  bool IsDiscarding = false; ///< Until Restore() nothing is drawn.
};

VTK_ABI_NAMESPACE_END
#endif
