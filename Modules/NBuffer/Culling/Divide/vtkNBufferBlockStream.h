// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferBlockStream
 * @brief The blocks of composite data: reads which ones VTK draws, and lets it draw some of them.
 *
 * vtkCompositePolyDataMapper (before VTK 9.3, vtkCompositePolyDataMapper2) has an internal mapper
 * for all blocks with arrays of the same kinds, which is called a mapper of blocks here. That
 * mapper has the vertices of its blocks in common buffers, and draws one block after the other,
 * each by a call of OpenGL with uniforms of its own. Which blocks it draws, and in which order, is
 * in a list (vtkNBufferProtectedBlocks.h). While this class lets it draw some of them, the list has
 * only these. Buffers, program, uniforms and order stay VTK's.
 *
 * Here, a unit of vtkNBufferUnits is one block. The units are made from a mesh with two points for
 * each block: two opposite corners of its box. Blocks may have cells of any kind, with or without
 * values of cells.
 */
#ifndef vtkNBufferBlockStream_h
#define vtkNBufferBlockStream_h

#include "vtkNBufferProtectedBlocks.h"
#include "vtkNBufferUnits.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkActor;
class vtkMapper;
class vtkOpenGLHelper;
class vtkRenderer;

class vtkNBufferBlockStream
{
public:
  vtkNBufferBlockStream() = default;
  ~vtkNBufferBlockStream() { this->Restore(); }
  vtkNBufferBlockStream(const vtkNBufferBlockStream&) = delete;
  void operator=(const vtkNBufferBlockStream&) = delete;

  /// Whether this mapper draws composite data by mappers of blocks, and no cells are selected,
  /// which VTK would draw by the same list.
  static bool MayBeDivided(vtkMapper* mapper);

  /// Whether this is a mapper of blocks.
  static bool DrawsBlocks(vtkAbstractMapper* mapper);

  /// Forget all blocks.
  void Clear();

  /// Add to `boxes` the boxes of the blocks that a mapper of blocks is about to draw, if they have
  /// not been added since Clear().
  void Read(vtkAbstractMapper* mapper, vtkNBufferUnits::Mesh& boxes);

  /// The number of the block with this flat index among the blocks that were read since Clear();
  /// the largest std::size_t if there is no such block.
  std::size_t FindBlock(unsigned int flatIndex) const;

  /// Begin a frame, in which VTK has not drawn any blocks yet.
  void BeginFrame();

  /// Let list 0 or 1 consist of the blocks with the numbers in these ranges, which ascend.
  void SetList(int list, const std::vector<vtkNBufferUnits::Range>& ranges);

  /// Let the next draw of `mapper`, for which VTK is setting the shader parameters, draw only a
  /// list. Returns false, and does nothing, if the mapper is about to draw other blocks than those
  /// that were read.
  bool DrawNext(int list, vtkAbstractMapper* mapper);

  /// Undo what DrawNext() has changed in the mapper.
  void Restore();

  /**
   * Draw the blocks of the actor again, as vtkActor::RenderOpaqueGeometry() does. That function
   * visits each block several times before it draws the first one, in order to find out whether any
   * has changed. If VTK has done so in this frame, this function leaves that out. Returns false,
   * and draws nothing, if VTK has not, or if the blocks have textures, which only VTK binds.
   */
  bool DrawDirectly(vtkActor* actor, vtkRenderer* renderer);

private:
  using Map = vtkNBufferProtectedMembers::BlockMap;

  /// What one mapper of blocks draws.
  struct Batch
  {
    vtkWeakPointer<vtkAbstractMapper> Mapper;
    vtkMTimeType BuildTime;
    std::vector<Map::value_type> Blocks; ///< In the order of the list.
    std::array<Map, 2> Lists;
    vtkOpenGLHelper* Last = nullptr; ///< The stream that was drawn last in this frame.
    bool UsesTextures = false;
  };

  Batch* Find(vtkAbstractMapper* mapper);

  std::vector<Batch> Batches;
  std::map<unsigned int, std::size_t> Numbers; ///< The numbers of the blocks, by flat index.
  vtkSmartPointer<vtkAbstractMapper> Changed;
  Map* Exchanged = nullptr; ///< Where the list of `Changed` is while it has one of ours.
  unsigned long Observer = 0;
};

VTK_ABI_NAMESPACE_END
#endif
