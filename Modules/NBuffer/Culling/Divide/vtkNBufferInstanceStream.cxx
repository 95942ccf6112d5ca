// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferInstanceStream.h"

#include "vtkNBufferBox.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferGlyphs.h"
#include "vtkNBufferProtectedGlyphs.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr std::size_t MatrixSize = 16;
constexpr std::size_t NormalMatrixSize = 9;
constexpr std::size_t ColorSize = 4;

/// Each vertex of an instance is rounded in two products of matrices. See Read().
constexpr double Products = 2.0;

/// The number of points without an instance.
constexpr unsigned int NoInstance = std::numeric_limits<unsigned int>::max();

/// The size of a buffer of VTK.
std::size_t GetBytes(vtkOpenGLBufferObject* buffer)
{
  GLint64 bytes = 0;
  if (buffer->GetHandle() != 0 && buffer->Bind())
  {
    glGetBufferParameteri64v(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &bytes);
    buffer->Release();
  }
  return static_cast<std::size_t>(bytes);
}

/// The floats of a buffer of VTK.
std::vector<float> ReadBuffer(vtkOpenGLBufferObject* buffer)
{
  std::vector<float> values(GetBytes(buffer) / sizeof(float));
  if (!values.empty())
  {
    buffer->Bind();
    glGetBufferSubData(
      GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data());
    buffer->Release();
  }
  return values;
}
}

vtkOpenGLGlyph3DHelper* vtkNBufferInstanceStream::GetHelper(vtkAbstractMapper* mapper)
{
  return typeid(*mapper) == typeid(vtkOpenGLGlyph3DHelper)
    ? static_cast<vtkOpenGLGlyph3DHelper*>(mapper)
    : nullptr;
}

bool vtkNBufferInstanceStream::MayBeDivided(vtkActor* actor, bool isTranslucent)
{
  vtkGlyph3DMapper* mapper = vtkNBufferGlyphs::GetMapper(actor->GetMapper());
  return mapper && !mapper->GetMasking() && !vtkNBufferSurface::HasOtherCoordinates(actor) &&
    vtkNBufferSurface::DrawsAsSurface(actor->GetProperty(), false) &&
    !vtkNBufferSurface::HasReplacedShaders(actor) &&
    !vtkNBufferSurface::HasOffsetTowardsEye(actor, false) &&
    (actor->HasTranslucentPolygonalGeometry() != 0) == isTranslucent &&
    (actor->HasOpaqueGeometry() != 0) != isTranslucent;
}

vtkIdType vtkNBufferInstanceStream::CountPolygons(vtkActor* actor)
{
  vtkGlyph3DMapper* mapper = vtkNBufferGlyphs::GetMapper(actor->GetMapper());
  std::vector<double> polygons(1, 0.0); // Points without an instance have the number -1.
  for (int source = 0; source < mapper->GetNumberOfInputConnections(1); ++source)
  {
    polygons.push_back(static_cast<double>(mapper->GetSource(source)->GetNumberOfPolys()));
  }
  double sum = 0.0;
  if (polygons.size() == 2)
  {
    // The sources of all points need not be listed, which takes milliseconds for a million.
    sum = polygons[1] *
      static_cast<double>(
        mapper->GetInputDataObject(0, 0)->GetNumberOfElements(vtkDataObject::POINT));
  }
  else
  {
    const std::vector<int> sources = vtkNBufferGlyphs::GetSources(mapper);
    sum = std::accumulate(sources.begin(), sources.end(), 0.0,
      [&polygons](double before, int source) { return before + polygons[source + 1]; });
  }
  return static_cast<vtkIdType>(std::min<double>(sum, VTK_INT_MAX));
}

void vtkNBufferInstanceStream::Clear()
{
  this->Batches.clear();
  this->Magnitude = glm::dvec3(0.0);
}

vtkNBufferInstanceStream::Key vtkNBufferInstanceStream::GetKey(
  vtkOpenGLGlyph3DHelper* mapper, vtkOpenGLHelper* stream)
{
  const auto buffers = vtkNBufferProtectedMembers::GetInstanceBuffers(mapper);
  vtkPolyData* source = mapper->CurrentInput;
  const bool isKnown = buffers && source && stream &&
    stream->PrimitiveType != vtkOpenGLPolyDataMapper::PrimitivePoints;
  return isKnown ? Key{ mapper, source->GetMTime(), buffers->BuildTime, stream->IBO->IndexCount }
                 : Key{};
}

void vtkNBufferInstanceStream::ReadOrder(vtkGlyph3DMapper* mapper)
{
  const std::vector<int> sources = vtkNBufferGlyphs::GetSources(mapper);
  std::vector<std::size_t> next(static_cast<std::size_t>(mapper->GetNumberOfInputConnections(1)));
  for (const int source : sources)
  {
    next[std::max(source, 0)] += source >= 0;
  }
  this->Ends.resize(next.size());
  std::partial_sum(next.begin(), next.end(), this->Ends.begin());
  std::transform(this->Ends.begin(), this->Ends.end(), next.begin(), next.begin(), std::minus<>());
  this->Numbers.resize(sources.size());
  std::transform(sources.begin(), sources.end(), this->Numbers.begin(),
    [&next](int source)
    { return source < 0 ? NoInstance : static_cast<unsigned int>(next[source]++); });
}

std::size_t vtkNBufferInstanceStream::FindInstance(std::size_t point) const
{
  const bool isThere = point < this->Numbers.size() && this->Numbers[point] != NoInstance;
  return isThere ? this->Numbers[point] : std::numeric_limits<std::size_t>::max();
}

vtkNBufferInstanceStream::Batch* vtkNBufferInstanceStream::Find(const Key& key) const
{
  const auto found = std::find_if(this->Batches.begin(), this->Batches.end(),
    [&key](const auto& batch) { return batch->Drawn == key; });
  return found == this->Batches.end() ? nullptr : found->get();
}

bool vtkNBufferInstanceStream::IsAsRead(
  vtkOpenGLGlyph3DHelper* mapper, vtkOpenGLHelper* stream) const
{
  return this->Find(GetKey(mapper, stream)) != nullptr;
}

void vtkNBufferInstanceStream::Read(vtkActor* actor, vtkOpenGLGlyph3DHelper* mapper,
  vtkOpenGLHelper* stream, vtkNBufferUnits::Mesh& boxes)
{
  vtkGlyph3DMapper* glyphs = vtkNBufferGlyphs::GetMapper(actor->GetMapper());
  if (this->Batches.empty() && glyphs)
  {
    boxes.Corners = 2;
    this->ReadOrder(glyphs);
  }
  this->Batches.push_back(std::make_unique<Batch>());
  Batch& batch = *this->Batches.back();
  batch.Drawn = GetKey(mapper, stream);
  const bool isKnown = glyphs && batch.Drawn.Mapper && this->ReadBatch(mapper, batch, boxes);
  boxes.Corners = isKnown ? boxes.Corners : 0;
}

bool vtkNBufferInstanceStream::ReadBatch(
  vtkOpenGLGlyph3DHelper* mapper, Batch& batch, vtkNBufferUnits::Mesh& boxes)
{
  const auto buffers = vtkNBufferProtectedMembers::GetInstanceBuffers(mapper);
  const std::vector<float> matrices = ReadBuffer(buffers->Matrices);
  batch.First = boxes.Points.size() / 2;
  batch.Size = matrices.size() / MatrixSize;
  // VTK does not update the normals while it does not use them.
  const std::size_t normals = GetBytes(buffers->NormalMatrices);
  batch.HasNormals = batch.Size > 0 && normals == batch.Size * NormalMatrixSize * sizeof(float);
  vtkPolyData* source = mapper->CurrentInput;
  const auto end = std::upper_bound(this->Ends.begin(), this->Ends.end(), batch.First);
  const bool isKnown = end != this->Ends.end() && batch.First + batch.Size == *end &&
    GetBytes(buffers->Colors) == batch.Size * ColorSize && *end < NoInstance / 2 &&
    (batch.HasNormals || normals == 0 || batch.Size == 0);
  if (!isKnown)
  {
    return false;
  }
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 point;
    source->GetPoint(i, glm::value_ptr(point));
    if (!vtkNBufferGLM::IsFinite(point))
    {
      return false;
    }
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  /*
   * With G the matrix of an instance and v a vertex of the source, the device computes G v and then
   * M (G v), where M goes to clip coordinates. The elements of G are the floats that are read here.
   * With a = |G| |v|, translation included, the first product is off by at most 6 u a: the vertex
   * and the product are rounded once each, the additions three times, and 1 u is for terms of
   * second order. The second product adds the 6 u sum_j |M_j| a_j + 4 u |M_3| of
   * vtkNBufferBoxError.h. Together this is E of that file with twice the magnitude, 2 a.
   */
  for (std::size_t i = 0; i < batch.Size; ++i)
  {
    const glm::dmat4 toActor(glm::make_mat4(&matrices[i * MatrixSize]));
    vtkNBufferBox box;
    const glm::dvec3 magnitude = box.SetPlace(toActor, low, high);
    if (!vtkNBufferGLM::IsFinite(magnitude))
    {
      return false;
    }
    for (const glm::dvec3& corner : { box.Center - box.HalfSize, box.Center + box.HalfSize })
    {
      boxes.Indices.push_back(static_cast<unsigned int>(boxes.Points.size()));
      boxes.Points.push_back(corner);
    }
    this->Magnitude = glm::max(this->Magnitude, Products * magnitude);
  }
  return true;
}

void vtkNBufferInstanceStream::SetPending(int list)
{
  for (const auto& batch : this->Batches)
  {
    batch->Lists[list].IsPending = true;
  }
}

std::size_t vtkNBufferInstanceStream::GetLargestBuffer() const
{
  std::size_t largest = 0;
  for (const auto& batch : this->Batches)
  {
    largest = std::max(largest, batch->Size * MatrixSize * sizeof(float));
  }
  return largest;
}

bool vtkNBufferInstanceStream::MakeList(Batch& batch, int number, vtkOpenGLGlyph3DHelper* mapper,
  vtkOpenGLHelper* stream, const Maker& make)
{
  const auto buffers = vtkNBufferProtectedMembers::GetInstanceBuffers(mapper);
  List& list = batch.Lists[number];
  std::vector<vtkNBufferUnitDevice::Records> records;
  const auto add =
    [&records](vtkOpenGLBufferObject* source, vtkOpenGLBufferObject* target, std::size_t bytes)
  {
    target->GenerateBuffer(vtkOpenGLBufferObject::ArrayBuffer);
    records.push_back({ static_cast<unsigned int>(source->GetHandle()),
      static_cast<unsigned int>(target->GetHandle()),
      static_cast<unsigned int>(bytes / sizeof(std::uint32_t)) });
  };
  add(buffers->Matrices, list.Matrices, MatrixSize * sizeof(float));
  add(buffers->Colors, list.Colors, ColorSize);
  if (batch.HasNormals)
  {
    add(buffers->NormalMatrices, list.NormalMatrices, NormalMatrixSize * sizeof(float));
  }
  list.IsPending =
    !make({ batch.First, batch.First + batch.Size }, records, stream->IBO->IndexCount, list.Draw);
  return !list.IsPending;
}

bool vtkNBufferInstanceStream::Draw(
  int number, vtkOpenGLGlyph3DHelper* mapper, vtkOpenGLHelper* stream, const Maker& make)
{
  Batch* batch = this->Find(GetKey(mapper, stream));
  const auto buffers = vtkNBufferProtectedMembers::GetInstanceBuffers(mapper);
  if (!batch || buffers->BuildTime > buffers->LoadTime ||
    stream->ShaderSourceTime.GetMTime() > buffers->LoadTime)
  {
    return false;
  }
  const List& list = batch->Lists[number];
  if (list.IsPending && !MakeList(*batch, number, mapper, stream, make))
  {
    return false;
  }
  if (list.Draw.MayDraw())
  {
    Attach(stream, batch->HasNormals, list.Matrices, list.NormalMatrices, list.Colors);
    stream->IBO->Bind();
    list.Draw.Draw(GL_TRIANGLES);
    stream->IBO->Release();
    Attach(stream, batch->HasNormals, buffers->Matrices, buffers->NormalMatrices, buffers->Colors);
  }
  return true;
}

void vtkNBufferInstanceStream::Attach(vtkOpenGLHelper* stream, bool withNormals,
  vtkOpenGLBufferObject* matrices, vtkOpenGLBufferObject* normalMatrices,
  vtkOpenGLBufferObject* colors)
{
  vtkShaderProgram* program = stream->Program;
  vtkOpenGLVertexArrayObject* array = stream->VAO;
  matrices->Bind();
  array->AddAttributeMatrixWithDivisor(program, matrices, "GCMCMatrix", 0,
    MatrixSize * sizeof(float), VTK_FLOAT, 4, false, 1, 4 * sizeof(float));
  matrices->Release();
  if (withNormals && program->IsAttributeUsed("glyphNormalMatrix"))
  {
    normalMatrices->Bind();
    array->AddAttributeMatrixWithDivisor(program, normalMatrices, "glyphNormalMatrix", 0,
      NormalMatrixSize * sizeof(float), VTK_FLOAT, 3, false, 1, 3 * sizeof(float));
    normalMatrices->Release();
  }
  if (program->IsAttributeUsed("glyphColor"))
  {
    colors->Bind();
    array->AddAttributeArrayWithDivisor(
      program, colors, "glyphColor", 0, ColorSize, VTK_UNSIGNED_CHAR, 4, true, 1, false);
    colors->Release();
  }
}

void vtkNBufferInstanceStream::ReleaseGraphicsResources()
{
  for (const auto& batch : this->Batches)
  {
    for (List& list : batch->Lists)
    {
      list.Matrices->ReleaseGraphicsResources();
      list.NormalMatrices->ReleaseGraphicsResources();
      list.Colors->ReleaseGraphicsResources();
      list.Draw.SetCommand({});
      list.IsPending = false;
    }
  }
}
VTK_ABI_NAMESPACE_END
