// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferProtectedBlocks.h
 * @brief The protected members of the mapper that draws the blocks of composite data, and nothing
 * else. See vtkNBufferProtectedMembers.h.
 *
 * vtkCompositePolyDataMapper has one such mapper for all blocks with arrays of the same kinds. Its
 * class differs between versions of VTK, but each of these classes draws the blocks in the order of
 * a list, a std::map. The elements of the list do not own the blocks, except in VTK 9.3, where
 * blocks can therefore not be left out.
 */
#ifndef vtkNBufferProtectedBlocks_h
#define vtkNBufferProtectedBlocks_h

#include "vtkAbstractMapper.h"
#include "vtkNBufferVTKVersion.h"
#include "vtkPolyData.h"

#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
// The header of the helper does not include what it needs.
#include VTKNBUFFER_GL_HEADER
#include "vtkColor.h"

#include "vtkCompositeMapperHelper2.h"
#include "vtkCompositePolyDataMapper2.h"
#elif VTKNBUFFER_HAS_BATCHED_MAPPER
#include "vtkCompositePolyDataMapper.h"
#include "vtkOpenGLBatchedPolyDataMapper.h"
#endif

#include <cstdint>
#include <map>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferProtectedMembers
{
#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
using CompositeMapper = vtkCompositePolyDataMapper2;
using BlockMapper = vtkCompositeMapperHelper2;
using BlockMap = std::map<vtkPolyData*, vtkCompositeMapperHelperData*>;
#elif VTKNBUFFER_HAS_BATCHED_MAPPER
using CompositeMapper = vtkCompositePolyDataMapper;
using BlockMapper = vtkOpenGLBatchedPolyDataMapper;
using BlockMap = std::map<unsigned int, std::uintptr_t>;
#else
using BlockMap = std::map<unsigned int, std::uintptr_t>;
#endif

/// What a mapper of blocks draws.
struct BlockList
{
  BlockMap* Blocks = nullptr;        ///< In the order of drawing; null for all other mappers.
  vtkMTimeType BuildTime = 0;        ///< When the vertex buffers were made.
  vtkOpenGLHelper* Stream = nullptr; ///< What it draws next of them: triangles, for example.
};

#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2 || VTKNBUFFER_HAS_BATCHED_MAPPER
/// Whether a mapper has such lists. Subclasses may draw in another way.
inline bool HasBlockLists(vtkAbstractMapper* mapper)
{
  return typeid(*mapper) == typeid(CompositeMapper);
}

/// The blocks of a mapper that is about to draw. After the mapper has set the parameters of its
/// shader, it draws the blocks that are in the list.
inline BlockList GetBlockList(vtkAbstractMapper* mapper)
{
  struct Access : BlockMapper
  {
    static BlockList Get(BlockMapper* mapper)
    {
#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
      BlockMap& blocks = mapper->*&Access::Data;
#else
      BlockMap& blocks = mapper->*&Access::FlatIndexToPolyData;
#endif
      return { &blocks, (mapper->*&Access::VBOBuildTime).GetMTime(),
        mapper->*&Access::LastBoundBO };
    }
  };
  return typeid(*mapper) == typeid(BlockMapper) ? Access::Get(static_cast<BlockMapper*>(mapper))
                                                : BlockList{};
}

/// The mesh of a block in that list, or nullptr if it is not drawn any more.
inline vtkPolyData* GetMesh(vtkAbstractMapper* mapper, const BlockMap::value_type& block)
{
#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
  (void)mapper;
  return block.first;
#else
  struct Access : BlockMapper
  {
    static bool Draws(BlockMapper* mapper, std::uintptr_t address)
    {
      return (mapper->*&Access::VTKPolyDataToGLBatchElement).count(address) > 0;
    }
  };
  return Access::Draws(static_cast<BlockMapper*>(mapper), block.second)
    ? reinterpret_cast<vtkPolyData*>(block.second)
    : nullptr;
#endif
}

/// The flat index of a block in that list.
inline unsigned int GetFlatIndex(const BlockMap::value_type& block)
{
#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
  return block.second->FlatIndex;
#else
  return block.first;
#endif
}
#else
inline bool HasBlockLists(vtkAbstractMapper*)
{
  return false;
}

inline BlockList GetBlockList(vtkAbstractMapper*)
{
  return {};
}

inline vtkPolyData* GetMesh(vtkAbstractMapper*, const BlockMap::value_type&)
{
  return nullptr;
}

inline unsigned int GetFlatIndex(const BlockMap::value_type& block)
{
  return block.first;
}
#endif
}
VTK_ABI_NAMESPACE_END
#endif
