// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDrawHook.h"

#include "vtkNBufferDrawPass.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferHostList.h"
#include "vtkNBufferProtectedMembers.h"
#include "vtkNBufferSplatStream.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include VTKNBUFFER_GL_HEADER

#include <algorithm>
#include <optional>
#include <typeinfo>
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
    isKnown ? corners : 0, false, vtkNBufferOwnDraw::NumbersPrimitives(stream),
    !(isSplats && vtkNBufferSplatStream::DrawsArrays(stream)) };
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
  if (this->Hook->Reads && this->Hook->Window->GetAbortRender())
  {
    this->Hook->ReadNext(); // Some mappers of blocks may not have drawn.
  }
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
  this->Blocks.Restore();
  this->Own.Restore();
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
  this->OnDevice.Delete();
}

bool vtkNBufferDrawHook::CanListOnDevice() const
{
  const std::size_t bytes = this->Read.AreInstances ? this->Instances.GetLargestBuffer()
                                                    : this->Read.IndexCount * sizeof(unsigned int);
  return this->Device && !this->Read.IsNumbered && !this->Read.HasBlocks() &&
    this->Read.HasIndices && this->Device->CanCopy(bytes);
}

void vtkNBufferDrawHook::SetList(
  List list, const vtkNBufferUnits& units, const std::vector<unsigned char>& marked)
{
  this->Stale = false;
  Buffer& buffer = this->Buffers[list];
  const bool canBeDrawn = !buffer.IsPending && (this->Device || !buffer.IsOnDevice);
  if (buffer.Marked == marked && canBeDrawn)
  {
    return;
  }
  buffer.Marked = marked;
  buffer.Units = &units;
  buffer.IsOnDevice = this->CanListOnDevice();
  buffer.Ranges.clear();
  if (!buffer.IsOnDevice)
  {
    buffer.Ranges = units.GetRanges(marked);
  }
  buffer.IsPending = !this->Read.IsNumbered && !this->Read.HasBlocks();
  if (this->Read.HasBlocks())
  {
    this->Blocks.SetList(list, buffer.Ranges);
  }
  else if (this->Read.AreInstances)
  {
    this->Instances.SetPending(list);
  }
}

bool vtkNBufferDrawHook::MakeList(const Buffer& buffer, const vtkNBufferUnits::Range& part,
  const std::vector<vtkNBufferUnitDevice::Records>& records, std::size_t indices,
  vtkNBufferUnitDevice::List& list)
{
  if (buffer.IsOnDevice)
  {
    this->Device->MakeList(*buffer.Units, buffer.Marked, this->OnDevice, part, records, indices,
      this->Read.AreInstances, list);
    return true;
  }
  const std::optional<std::size_t> copied = vtkNBufferHostList::Copy(buffer.Ranges, part, records);
  const std::size_t count = copied.value_or(0);
  list.SetCommand({ static_cast<std::uint32_t>(this->Read.AreInstances ? indices : indices * count),
    static_cast<std::uint32_t>(this->Read.AreInstances ? count : 1) });
  return copied.has_value();
}

bool vtkNBufferDrawHook::IsAsRead(const Source& source)
{
  this->Stale =
    source.Corners == 0 || !(source == this->Read) || (source.IsNumbered && !this->Read.IsNumbered);
  return !this->Stale;
}

void vtkNBufferDrawHook::BeforeDraw(vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (!this->Actor || prop != this->Actor)
  {
    return;
  }
  this->Restore();
  // A mapper that another window has drawn before releases its objects there, after which VTK goes
  // on in the context of that window, to which the buffers of the hook do not belong.
  if (!glIsSync(static_cast<GLsync>(this->Context)))
  {
    this->Stale = true;
    return;
  }
  if (vtkNBufferBlockStream::DrawsBlocks(mapper))
  {
    this->SetBlocks(mapper);
  }
  else if (vtkOpenGLGlyph3DHelper* instances = vtkNBufferInstanceStream::GetHelper(mapper))
  {
    this->SetInstances(instances);
  }
  else
  {
    this->SetStream(mapper);
  }
}

void vtkNBufferDrawHook::SetStream(vtkAbstractMapper* mapper)
{
  vtkOpenGLPolyDataMapper* splats = vtkNBufferSplatStream::GetHelper(mapper);
  const bool isDrawnByStreams = splats || typeid(*mapper) == typeid(vtkOpenGLPolyDataMapper);
  auto* surface = isDrawnByStreams ? static_cast<vtkOpenGLPolyDataMapper*>(mapper) : nullptr;
  vtkOpenGLHelper* stream = surface ? vtkNBufferProtectedMembers::GetOnlyStream(surface) : nullptr;
  const Source source = stream ? ::GetSource(surface, stream) : Source{ surface };
  if (std::exchange(this->Reads, false))
  {
    this->ReadSource(surface, stream, source);
    return;
  }
  if (this->Current == Whole || !this->IsAsRead(source))
  {
    return;
  }
  this->Own.SetNext(surface, stream, source.HasIndices,
    [this, list = this->Current, stream]()
    {
      Buffer& buffer = this->Buffers[list];
      return this->Read.IsNumbered ? vtkNBufferOwnDraw::DrawRanges(buffer.Ranges, stream)
                                   : this->DrawIndices(buffer, stream);
    });
}

bool vtkNBufferDrawHook::DrawIndices(Buffer& buffer, vtkOpenGLHelper* stream)
{
  const std::size_t corners = this->Read.Corners;
  if (buffer.IsPending)
  {
    buffer.Object->GenerateBuffer(vtkOpenGLBufferObject::ElementArrayBuffer);
    const vtkNBufferUnitDevice::Records indices{
      this->Read.HasIndices ? static_cast<unsigned int>(stream->IBO->GetHandle()) : 0,
      static_cast<unsigned int>(buffer.Object->GetHandle()), static_cast<unsigned int>(corners)
    };
    this->Stale = !this->MakeList(
      buffer, { 0, this->Read.IndexCount / corners }, { indices }, corners, buffer.Draw);
    if (this->Stale)
    {
      return false;
    }
    buffer.IsPending = false;
    buffer.Ranges = {}; // OpenGL has the list now.
  }
  buffer.Object->Bind();
  buffer.Draw.Draw(corners == 1 ? GL_POINTS : GL_TRIANGLES);
  buffer.Object->Release();
  return true;
}

void vtkNBufferDrawHook::SetInstances(vtkOpenGLGlyph3DHelper* mapper)
{
  // There is one mapper for each source.
  vtkOpenGLHelper* stream = vtkNBufferProtectedMembers::GetOnlyStream(mapper);
  if (this->Reads)
  {
    if (!this->Read.Mapper)
    {
      this->Instances.Clear();
    }
    this->Instances.Read(this->Actor, mapper, stream, this->Mesh);
    const std::size_t indices = stream ? stream->IBO->IndexCount : 0;
    this->Read = { mapper, nullptr, 0, std::max(this->Read.IndexCount, indices), this->Mesh.Corners,
      true };
    return;
  }
  if (this->Current == Whole)
  {
    return;
  }
  if (!this->Instances.IsAsRead(mapper, stream))
  {
    this->Stale = true;
    return;
  }
  this->Own.SetNext(mapper, stream, true,
    [this, list = this->Current, mapper, stream]()
    {
      Buffer& buffer = this->Buffers[list];
      buffer.IsPending = false;
      return this->Instances.Draw(list, mapper, stream,
        [this, &buffer](const auto& part, const auto& records, std::size_t indices, auto& made)
        { return this->MakeList(buffer, part, records, indices, made); });
    });
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
  if (this->Current != Whole && !this->Blocks.DrawNext(this->Current, mapper))
  {
    this->Stale = true;
  }
}

void vtkNBufferDrawHook::ReadSource(
  vtkOpenGLPolyDataMapper* mapper, vtkOpenGLHelper* stream, const Source& source)
{
  this->Read = source;
  if (source.Corners == 0)
  {
    return;
  }
  vtkPolyData* data = mapper->GetInput();
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

void vtkNBufferDrawHook::BeginFrame(vtkOpenGLRenderWindow* window, vtkNBufferUnitDevice* device)
{
  this->Resources->RegisterGraphicsResources(window);
  this->Blocks.BeginFrame();
  this->Window = window;
  this->Device = device;
  if (!this->Context)
  {
    this->Context = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  }
}

void vtkNBufferDrawHook::ReleaseGraphicsResources(vtkWindow*)
{
  glDeleteSync(static_cast<GLsync>(std::exchange(this->Context, nullptr)));
  for (Buffer& buffer : this->Buffers)
  {
    buffer.Object->ReleaseGraphicsResources();
    buffer.Draw.SetCommand({});
    buffer.Marked.clear();
  }
  this->OnDevice.Delete();
  this->Instances.ReleaseGraphicsResources();
  this->Own.ReleaseGraphicsResources();
}
VTK_ABI_NAMESPACE_END
