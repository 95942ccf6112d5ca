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
 */
#ifndef vtkNBufferOwnDraw_h
#define vtkNBufferOwnDraw_h

#include "vtkOpenGLPolyDataMapper.h" // For the smart pointer
#include "vtkSmartPointer.h"

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <cstddef>
#include <functional>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLHelper;

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
