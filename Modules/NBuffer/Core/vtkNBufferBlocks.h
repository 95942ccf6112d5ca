// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferBlocks
 * @brief The bounds of composite data and of grids, which follow every change that VTK draws.
 *
 * VTK's own bounds follow the time of the tree, and those of its points. If a block changes and the
 * tree does not, or if coordinates change in place and only the data set is marked as modified, VTK
 * notices that when it draws, but a culler may not let it draw. Each Update() compares the times of
 * the points of all blocks, which takes about 0.2 microseconds per block. After a change of the
 * data it reads all coordinates.
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
  /// Whether the bounds of a mapper have to be read by this class: those of composite data, and of
  /// data sets whose surface is extracted. If the surface has the points of the data set itself, as
  /// that of a grid of polygons, VTK does not draw what changes in place.
  static bool AreNeeded(vtkMapper* mapper);

  /// Read the data of a mapper, if points, a data set or the mapper have changed.
  void Update(vtkMapper* mapper);

  ///@{
  /// The bounds of the mapper and of the points of the visible blocks, or of all blocks. If VTK's
  /// own bounds of points are too small, both are those of all blocks.
  const vtkBoundingBox& GetVisible() const { return this->Visible; }
  const vtkBoundingBox& GetAll() const { return this->All; }
  ///@}

private:
  vtkMTimeType Time = 0;
  vtkMTimeType DataTime = 0;           ///< That of the data alone.
  const vtkDataObject* Data = nullptr; ///< Only compared.
  vtkBoundingBox Visible;
  vtkBoundingBox All;
  vtkBoundingBox OfValues; ///< Computed from all coordinates.
};

VTK_ABI_NAMESPACE_END
#endif
