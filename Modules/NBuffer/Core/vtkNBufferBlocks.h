// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferBlocks
 * @brief The bounds of composite data, which follow every change of a block.
 *
 * VTK's own bounds follow the time of the tree alone. If a block changes and the tree does not, VTK
 * notices that when it draws, but a culler may not let it draw. Each Update() compares the times of
 * the points of all blocks, which takes about 0.2 microseconds per block.
 */
#ifndef vtkNBufferBlocks_h
#define vtkNBufferBlocks_h

#include "vtkBoundingBox.h"
#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN
#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkMapper;

class vtkNBufferBlocks
{
public:
  /// Read the blocks of a composite mapper, if the points of one of them or the mapper have
  /// changed.
  void Update(vtkMapper* mapper);

  ///@{
  /// The bounds of the mapper and of the points of the visible blocks, or of all blocks.
  const vtkBoundingBox& GetVisible() const { return this->Visible; }
  const vtkBoundingBox& GetAll() const { return this->All; }
  ///@}

private:
  vtkMTimeType Time = 0;
  const vtkDataObject* Data = nullptr; ///< Only compared.
  vtkBoundingBox Visible;
  vtkBoundingBox All;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferBlocks.h
