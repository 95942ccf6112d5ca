// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferRangeDraw
 * @brief Draws ranges of the primitives of a mesh that has scalars or normals of cells.
 *
 * The shader of vtkOpenGLPolyDataMapper reads the values of a cell from a texture, at the place
 * gl_PrimitiveID + PrimitiveIDOffset. OpenGL counts gl_PrimitiveID from the beginning of each draw.
 * The triangles of a shortened list of indices would therefore have the values of others. This
 * class draws ranges of VTK's own list instead, each with the number of its first primitive in the
 * uniform variable PrimitiveIDOffset.
 *
 * It does so when everything for the mapper's draw has been bound (vtkCommand::UpdateShaderEvent),
 * and lets VTK's own draw have no indices. Program, textures and vertices are VTK's.
 */
#ifndef vtkNBufferRangeDraw_h
#define vtkNBufferRangeDraw_h

#include "vtkNBufferUnits.h"

#include "vtkOpenGLPolyDataMapper.h" // For the smart pointer
#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLHelper;

class vtkNBufferRangeDraw
{
public:
  vtkNBufferRangeDraw() = default;
  ~vtkNBufferRangeDraw() { this->Restore(); }
  vtkNBufferRangeDraw(const vtkNBufferRangeDraw&) = delete;
  void operator=(const vtkNBufferRangeDraw&) = delete;

  /// Whether the shader, whose parameters are being set, reads values by the numbers of primitives.
  static bool IsNeeded(vtkOpenGLHelper* stream);

  /// Let the draw whose shader parameters are being set draw only these ranges of `stream`, one of
  /// the streams of `mapper`, which consists of triangles or points. The ranges must exist until
  /// Restore() is called.
  void DrawNext(const std::vector<vtkNBufferUnits::Range>& ranges, vtkOpenGLPolyDataMapper* mapper,
    vtkOpenGLHelper* stream);

  /// Undo what DrawNext() has changed in the mapper.
  void Restore();

private:
  void Draw();

  vtkSmartPointer<vtkOpenGLPolyDataMapper> Mapper; ///< Of the draw that is running.
  vtkOpenGLHelper* Stream = nullptr;
  const std::vector<vtkNBufferUnits::Range>* Ranges = nullptr;
  unsigned long Observer = 0;
  std::size_t IndexCount = 0; ///< That of the stream, while it has been taken away.
};

VTK_ABI_NAMESPACE_END
#endif
