// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferBlockStream.h"

#include "vtkNBufferGL.h"
#include "vtkNBufferOwnDraw.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataObjectTree.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
using vtkNBufferProtectedMembers::GetBlockList;

bool vtkNBufferBlockStream::MayBeDivided(vtkMapper* mapper)
{
  vtkSelection* selection = mapper->GetSelection();
  return vtkNBufferProtectedMembers::HasBlockLists(mapper) &&
    vtkDataObjectTree::SafeDownCast(mapper->GetInputDataObject(0, 0)) &&
    !(selection && selection->GetNumberOfNodes() > 0);
}

bool vtkNBufferBlockStream::DrawsBlocks(vtkAbstractMapper* mapper)
{
  return GetBlockList(mapper).Blocks != nullptr;
}

void vtkNBufferBlockStream::Clear()
{
  this->Restore();
  this->Batches.clear();
  this->Numbers.clear();
}

vtkNBufferBlockStream::Batch* vtkNBufferBlockStream::Find(vtkAbstractMapper* mapper)
{
  const vtkNBufferProtectedMembers::BlockList drawn = GetBlockList(mapper);
  const auto found = std::find_if(this->Batches.begin(), this->Batches.end(),
    [&](const Batch& batch)
    {
      return batch.Mapper == mapper && batch.BuildTime == drawn.BuildTime &&
        batch.Blocks.size() == drawn.Blocks->size();
    });
  return found == this->Batches.end() ? nullptr : &*found;
}

void vtkNBufferBlockStream::Read(vtkAbstractMapper* mapper, vtkNBufferUnits::Mesh& boxes)
{
  if (this->Find(mapper))
  {
    return; // It draws triangles first, and then strips of the same blocks.
  }
  const vtkNBufferProtectedMembers::BlockList drawn = GetBlockList(mapper);
  this->Batches.push_back(
    { mapper, drawn.BuildTime, { drawn.Blocks->begin(), drawn.Blocks->end() }, {} });
  boxes.Corners = 2;
  for (const Map::value_type& block : *drawn.Blocks)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    glm::dvec3 low(-infinity);
    glm::dvec3 high(infinity);
    vtkPolyData* mesh = vtkNBufferProtectedMembers::GetMesh(mapper, block);
    if (mesh && mesh->GetNumberOfPoints() > 0)
    {
      const double* bounds = mesh->GetPoints()->GetBounds();
      low = { bounds[0], bounds[2], bounds[4] };
      high = { bounds[1], bounds[3], bounds[5] };
    }
    this->Numbers.emplace(
      vtkNBufferProtectedMembers::GetFlatIndex(block), boxes.Indices.size() / boxes.Corners);
    for (const glm::dvec3& corner : { low, high })
    {
      boxes.Indices.push_back(static_cast<unsigned int>(boxes.Points.size()));
      boxes.Points.push_back(corner);
    }
  }
}

std::size_t vtkNBufferBlockStream::FindBlock(unsigned int flatIndex) const
{
  const auto found = this->Numbers.find(flatIndex);
  return found == this->Numbers.end() ? std::numeric_limits<std::size_t>::max() : found->second;
}

void vtkNBufferBlockStream::SetList(int list, const std::vector<vtkNBufferUnits::Range>& ranges)
{
  std::size_t first = 0;
  for (Batch& batch : this->Batches)
  {
    const auto begin = batch.Blocks.begin();
    Map& blocks = batch.Lists[list];
    blocks.clear();
    for (const vtkNBufferUnits::Range& range :
      vtkNBufferUnits::Clip(ranges, { first, first + batch.Blocks.size() }))
    {
      blocks.insert(begin + static_cast<std::ptrdiff_t>(range.Begin),
        begin + static_cast<std::ptrdiff_t>(range.End));
    }
    first += batch.Blocks.size();
  }
}

bool vtkNBufferBlockStream::DrawNext(int list, vtkAbstractMapper* mapper)
{
  this->Restore();
  Batch* batch = this->Find(mapper);
  if (!batch)
  {
    return false;
  }
  batch->Last = GetBlockList(mapper).Stream;
  // The texture is either an image or has values of cells.
  batch->UsesTextures = batch->UsesTextures || vtkNBufferOwnDraw::NumbersPrimitives(batch->Last) ||
    batch->Last->Program->IsAttributeUsed("tcoord") ||
    batch->Last->Program->IsAttributeUsed("colorTCoord");
  this->Changed = mapper;
  this->Exchanged = &batch->Lists[list];
  this->Exchanged->swap(*GetBlockList(mapper).Blocks);
  this->Observer =
    mapper->AddObserver(vtkCommand::ProgressEvent, this, &vtkNBufferBlockStream::Restore);
  return true;
}

void vtkNBufferBlockStream::Restore()
{
  if (this->Changed)
  {
    this->Exchanged->swap(*GetBlockList(this->Changed).Blocks);
    this->Changed->RemoveObserver(this->Observer);
    this->Changed = nullptr;
  }
}

void vtkNBufferBlockStream::BeginFrame()
{
  for (Batch& batch : this->Batches)
  {
    batch.Last = nullptr;
  }
}

bool vtkNBufferBlockStream::DrawDirectly(vtkActor* actor, vtkRenderer* renderer)
{
  if (this->Batches.empty() ||
    !std::all_of(this->Batches.begin(), this->Batches.end(),
      [](const Batch& batch)
      {
        // Another actor with this mapper may have been drawn since, in colors of its own.
        return batch.Mapper && batch.Last && !batch.UsesTextures &&
          GetBlockList(batch.Mapper).BuildTime == batch.BuildTime;
      }))
  {
    return false;
  }
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderer*>(renderer)->GetState();
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkProperty* property = actor->GetProperty();
  property->Render(actor, renderer);
  if (vtkProperty* backface = actor->GetBackfaceProperty())
  {
    backface->BackfaceRender(actor, renderer);
  }
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglPointSize(property->GetPointSize());
  for (Batch& batch : this->Batches)
  {
    static_cast<vtkOpenGLPolyDataMapper*>(batch.Mapper.Get())->RenderPieceDraw(renderer, actor);
    this->Restore();
    batch.Last->VAO->Release();
  }
  property->PostRender(actor, renderer);
  return true;
}
VTK_ABI_NAMESPACE_END
