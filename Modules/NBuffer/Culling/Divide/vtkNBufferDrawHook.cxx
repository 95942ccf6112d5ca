// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDrawHook.h"

#include "vtkNBufferDrawPass.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferProtectedMembers.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
vtkNBufferDrawHook::Source GetSource(vtkOpenGLPolyDataMapper* mapper, vtkOpenGLHelper* stream)
{
  vtkPolyData* data = mapper->GetInput();
  const bool isSplats = vtkNBufferSplatStream::GetHelper(mapper) != nullptr;
  const std::size_t corners =
    isSplats || stream->PrimitiveType == vtkOpenGLPolyDataMapper::PrimitivePoints ? 1 : 3;
  const std::size_t vertices = vtkNBufferProtectedMembers::GetNumberOfVertices(mapper);
  const bool isKnown = data && data->GetPoints() &&
    vertices ==
      (isSplats && vtkNBufferSplatStream::DrawsArrays(stream)
          ? stream->IBO->IndexCount
          : static_cast<std::size_t>(data->GetNumberOfPoints())) &&
    stream->IBO->IndexCount % corners == 0;
  return { mapper, data, data ? data->GetMTime() : 0, stream->IBO->IndexCount,
    isKnown ? corners : 0, 0, vtkNBufferRangeDraw::IsNeeded(stream) };
}
}

vtkNBufferDrawHook::vtkNBufferDrawHook(vtkNBufferDrawPass* pass)
  : Pass(pass)
  , Resources(new Callback(this, &vtkNBufferDrawHook::ReleaseGraphicsResources))
{
}

vtkNBufferDrawHook::~vtkNBufferDrawHook()
{
  this->Resources->Release();
}

vtkNBufferDrawHook::Draw::Draw(vtkNBufferDrawHook* hook, vtkActor* actor, List list)
  : Hook(hook)
{
  hook->Actor = actor;
  hook->Current = list;
  hook->Pass->SetCallback(
    [hook](vtkAbstractMapper* mapper, vtkProp* prop) { hook->BeforeDraw(mapper, prop); });
}

vtkNBufferDrawHook::Draw::~Draw()
{
  this->Hook->Restore();
  this->Hook->Pass->SetCallback(nullptr);
  this->Hook->Actor = nullptr;
  this->Hook->Reads = this->Hook->Reads && !this->Hook->Read.Mapper;
}

int vtkNBufferDrawHook::Render(vtkActor* actor, vtkRenderer* renderer)
{
  const bool isDirect = this->Actor && this->Current != Whole && !this->Stale &&
    this->Blocks.DrawDirectly(actor, renderer);
  return isDirect ? 1 : actor->RenderOpaqueGeometry(renderer);
}

void vtkNBufferDrawHook::Restore()
{
  this->Instances.Restore();
  this->Blocks.Restore();
  this->Own.Restore();
  this->Splats.Restore();
  if (this->Changed)
  {
    this->Changed->IBO = this->Original;
    this->Changed = nullptr;
  }
}

void vtkNBufferDrawHook::ReadNext()
{
  this->Reads = true;
  this->Read = {};
  this->Mesh = {};
  this->Blocks.Clear();
  for (Buffer& buffer : this->Buffers)
  {
    buffer.Marked.clear(); // The same units of another mesh have other indices.
  }
}

void vtkNBufferDrawHook::SetList(List list, const vtkNBufferUnits& units,
  const std::vector<unsigned int>& indices, const std::vector<unsigned char>& marked)
{
  this->Stale = false;
  Buffer& buffer = this->Buffers[list];
  if (buffer.Marked != marked)
  {
    buffer.Marked = marked;
    buffer.IsUploaded = false;
    if (this->Read.IsNumbered)
    {
      buffer.Ranges = units.GetRanges(marked);
      return;
    }
    units.GetIndices(marked, indices, buffer.Indices);
  }
}

bool vtkNBufferDrawHook::IsAsRead(const Source& source)
{
  this->Stale =
    source.Corners == 0 || !(source == this->Read) || (source.IsNumbered && !this->Read.IsNumbered);
  return !this->Stale;
}

bool vtkNBufferDrawHook::Upload(Buffer& buffer)
{
  if (!buffer.IsUploaded && !buffer.Indices.empty())
  {
    buffer.IsUploaded =
      buffer.Object->Upload(buffer.Indices, vtkOpenGLBufferObject::ElementArrayBuffer);
    buffer.Object->IndexCount = buffer.Indices.size();
    buffer.Indices = {};
  }
  return buffer.IsUploaded;
}

void vtkNBufferDrawHook::BeforeDraw(vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (!this->Actor || prop != this->Actor)
  {
    return;
  }
  this->Restore();
  if (vtkOpenGLGlyph3DHelper* instances = vtkNBufferInstanceStream::GetHelper(mapper))
  {
    this->SetInstances(instances);
    return;
  }
  if (vtkNBufferBlockStream::DrawsBlocks(mapper))
  {
    this->SetBlocks(mapper);
    return;
  }
  vtkOpenGLPolyDataMapper* splats = vtkNBufferSplatStream::GetHelper(mapper);
  auto* surface = typeid(*mapper) == typeid(vtkOpenGLPolyDataMapper)
    ? static_cast<vtkOpenGLPolyDataMapper*>(mapper)
    : splats;
  vtkOpenGLHelper* stream = surface ? vtkNBufferProtectedMembers::GetOnlyStream(surface) : nullptr;
  const Source source = stream ? ::GetSource(surface, stream) : Source{ surface };
  if (this->Reads)
  {
    this->Reads = false;
    this->ReadSource(stream, source, surface ? surface->GetInput() : nullptr);
    return;
  }
  if (this->Current == Whole)
  {
    return;
  }
  Buffer& buffer = this->Buffers[this->Current];
  if (!this->IsAsRead(source))
  {
    return;
  }
  if (this->Read.IsNumbered)
  {
    this->Own.SetNext(surface, stream,
      [&buffer, stream]() { return vtkNBufferRangeDraw::Draw(buffer.Ranges, stream); });
  }
  else if (this->Upload(buffer) && splats && vtkNBufferSplatStream::DrawsArrays(stream))
  {
    this->Splats.DrawNext(splats, stream, buffer.Object);
  }
  else if (buffer.IsUploaded)
  {
    this->Changed = stream;
    this->Original = std::exchange(stream->IBO, buffer.Object.Get());
  }
}

void vtkNBufferDrawHook::SetInstances(vtkOpenGLGlyph3DHelper* mapper)
{
  vtkOpenGLHelper* stream = vtkNBufferProtectedMembers::GetOnlyStream(mapper);
  const auto buffers = vtkNBufferProtectedMembers::GetInstanceBuffers(mapper);
  vtkPolyData* data = mapper->CurrentInput;
  Source source = { mapper };
  if (stream && buffers && data &&
    stream->PrimitiveType != vtkOpenGLPolyDataMapper::PrimitivePoints)
  {
    source = { mapper, data, data->GetMTime(), stream->IBO->IndexCount, 2, buffers->BuildTime };
  }
  if (this->Reads)
  {
    this->Reads = false;
    if (source.Corners > 0 && !this->Instances.Read(this->Actor, mapper, this->Mesh))
    {
      source.Corners = 0;
    }
    this->Read = source;
    return;
  }
  if (this->Current == Whole)
  {
    return;
  }
  if (this->IsAsRead(source))
  {
    Buffer& buffer = this->Buffers[this->Current];
    if (!std::exchange(buffer.IsUploaded, true))
    {
      this->Instances.Upload(this->Current, std::exchange(buffer.Indices, {}));
    }
    this->Instances.DrawNext(this->Current, mapper, stream);
  }
}

void vtkNBufferDrawHook::SetBlocks(vtkAbstractMapper* mapper)
{
  // There are several mappers of blocks if some blocks have other arrays.
  if (this->Reads)
  {
    vtkMapper* whole = this->Actor->GetMapper();
    vtkDataObject* data = whole->GetInputDataObject(0, 0);
    this->Blocks.Read(mapper, this->Mesh);
    this->Read = { whole, data, data->GetMTime(), this->Mesh.Indices.size(), this->Mesh.Corners };
    return;
  }
  if (this->Current == Whole)
  {
    return;
  }
  if (!this->Blocks.IsAsRead(mapper))
  {
    this->Stale = true;
    return;
  }
  Buffer& buffer = this->Buffers[this->Current];
  if (!std::exchange(buffer.IsUploaded, true))
  {
    this->Blocks.SetList(this->Current, std::exchange(buffer.Indices, {}));
  }
  this->Blocks.DrawNext(this->Current, mapper);
}

void vtkNBufferDrawHook::ReadSource(
  vtkOpenGLHelper* stream, const Source& source, vtkPolyData* data)
{
  this->Read = source;
  if (source.Corners == 0)
  {
    return;
  }
  this->Mesh.Corners = source.Corners;
  this->Mesh.IsDrawnInRanges = source.IsNumbered;
  this->Mesh.Indices.resize(source.IndexCount);
  if (source.Corners == 1 && vtkNBufferSplatStream::DrawsArrays(stream))
  {
    vtkNBufferSplatStream::ReadVertices(data, this->Mesh);
    return;
  }
  stream->IBO->Bind();
  glGetBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0,
    static_cast<GLsizeiptr>(this->Mesh.Indices.size() * sizeof(unsigned int)),
    this->Mesh.Indices.data());
  this->Mesh.Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < this->Mesh.Points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), glm::value_ptr(this->Mesh.Points[i]));
  }
}

void vtkNBufferDrawHook::ReleaseGraphicsResources(vtkWindow*)
{
  for (Buffer& buffer : this->Buffers)
  {
    buffer.Object->ReleaseGraphicsResources();
    buffer.IsUploaded = false;
    buffer.Marked.clear();
  }
  this->Instances.ReleaseGraphicsResources();
  this->Splats.ReleaseGraphicsResources();
}
VTK_ABI_NAMESPACE_END
