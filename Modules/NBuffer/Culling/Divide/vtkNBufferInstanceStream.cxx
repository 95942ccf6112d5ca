// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferInstanceStream.h"

#include "vtkNBufferBox.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferGlyphs.h"
#include "vtkNBufferProtectedMembers.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <limits>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr std::size_t MatrixSize = 16;
constexpr std::size_t NormalMatrixSize = 9;
constexpr std::size_t ColorSize = 4;

/// The most instances in a unit. Larger groups have boxes that are seen more often.
constexpr std::size_t LargestUnit = 2;

/// Each vertex of an instance is rounded in two products of matrices. See Read().
constexpr double Products = 2.0;

/// The first `size` values of a buffer of VTK, or all of them if the size is 0.
template <typename T>
std::vector<T> ReadBuffer(vtkOpenGLBufferObject* buffer, std::size_t size = 0)
{
  GLint bytes = 0;
  if (buffer->GetHandle() == 0 || !buffer->Bind())
  {
    return {};
  }
  glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &bytes);
  std::vector<T> values(static_cast<std::size_t>(bytes) / sizeof(T));
  if (size == 0 || values.size() == size)
  {
    glGetBufferSubData(
      GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data());
  }
  else
  {
    values.clear();
  }
  buffer->Release();
  return values;
}

/// Upload the groups of `size` values that belong to the instances with these corners.
template <typename T>
void UploadPart(vtkOpenGLBufferObject* buffer, const std::vector<T>& all, std::size_t size,
  const std::vector<unsigned int>& corners)
{
  std::vector<T> part;
  part.reserve(corners.size() / 2 * size);
  for (std::size_t i = 0; i < corners.size() && !all.empty(); i += 2)
  {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(corners[i] / 2 * size);
    part.insert(part.end(), begin, begin + static_cast<std::ptrdiff_t>(size));
  }
  if (!part.empty())
  {
    buffer->Upload(part, vtkOpenGLBufferObject::ArrayBuffer);
  }
}
}

vtkOpenGLGlyph3DHelper* vtkNBufferInstanceStream::GetHelper(vtkAbstractMapper* mapper)
{
  return typeid(*mapper) == typeid(vtkOpenGLGlyph3DHelper)
    ? static_cast<vtkOpenGLGlyph3DHelper*>(mapper)
    : nullptr;
}

bool vtkNBufferInstanceStream::MayBeDivided(vtkActor* actor)
{
  vtkGlyph3DMapper* mapper = vtkNBufferGlyphs::GetMapper(actor->GetMapper());
  return mapper && !mapper->GetMasking() && !vtkNBufferSurface::HasOtherCoordinates(actor) &&
    vtkNBufferSurface::DrawsAsSurface(actor->GetProperty(), false) &&
    !vtkNBufferSurface::HasReplacedShaders(actor) &&
    !vtkNBufferSurface::HasOffsetTowardsEye(actor, false) &&
    !actor->HasTranslucentPolygonalGeometry() && actor->HasOpaqueGeometry();
}

vtkIdType vtkNBufferInstanceStream::CountPolygons(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  const vtkIdType instances =
    vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0))->GetNumberOfPoints();
  const vtkIdType cells =
    vtkPolyData::SafeDownCast(mapper->GetInputDataObject(1, 0))->GetNumberOfPolys();
  return cells > 0 && instances > VTK_INT_MAX / cells ? VTK_INT_MAX : instances * cells;
}

std::size_t vtkNBufferInstanceStream::GetUnitSize(std::size_t indices, std::size_t unitSize)
{
  return std::clamp<std::size_t>(3 * unitSize / std::max<std::size_t>(indices, 1), 1, LargestUnit);
}

bool vtkNBufferInstanceStream::Read(
  vtkActor* actor, vtkOpenGLGlyph3DHelper* mapper, vtkNBufferUnits::Mesh& boxes)
{
  const auto buffers = vtkNBufferProtectedMembers::GetInstanceBuffers(mapper);
  this->Matrices = ReadBuffer<float>(buffers->Matrices);
  const std::size_t size = this->Matrices.size() / MatrixSize;
  this->Colors = ReadBuffer<unsigned char>(buffers->Colors, size * ColorSize);
  this->NormalMatrices = ReadBuffer<float>(buffers->NormalMatrices, size * NormalMatrixSize);
  auto* data = vtkDataSet::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  vtkPolyData* source = mapper->CurrentInput;
  const bool isKnown = data && size > 0 && this->Colors.size() == size * ColorSize &&
    static_cast<std::size_t>(data->GetNumberOfPoints()) == size &&
    size < std::numeric_limits<unsigned int>::max() / 2 && source->GetNumberOfPoints() > 0;
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
   * second order. The second product adds the 8 u (sum_j |M_j| a_j + |M_3|) of
   * vtkNBufferBoxError.h. Both are less than 8 u (sum_j |M_j| 2 a_j + |M_3|): twice the magnitude.
   */
  boxes.Corners = 2;
  boxes.Points.resize(2 * size);
  boxes.Indices.resize(2 * size);
  this->Magnitude = glm::dvec3(0.0);
  for (std::size_t i = 0; i < size; ++i)
  {
    const glm::dmat4 toActor(glm::make_mat4(&this->Matrices[i * MatrixSize]));
    vtkNBufferBox box;
    const glm::dvec3 magnitude = box.SetPlace(toActor, low, high);
    boxes.Points[2 * i] = box.Center - box.HalfSize;
    boxes.Points[2 * i + 1] = box.Center + box.HalfSize;
    boxes.Indices[2 * i] = static_cast<unsigned int>(2 * i);
    boxes.Indices[2 * i + 1] = static_cast<unsigned int>(2 * i + 1);
    if (!vtkNBufferGLM::IsFinite(magnitude))
    {
      return false;
    }
    this->Magnitude = glm::max(this->Magnitude, Products * magnitude);
  }
  return true;
}

void vtkNBufferInstanceStream::Upload(int list, const std::vector<unsigned int>& corners)
{
  List& target = this->Lists[list];
  target.Size = corners.size() / 2;
  UploadPart(target.Matrices, this->Matrices, MatrixSize, corners);
  UploadPart(target.NormalMatrices, this->NormalMatrices, NormalMatrixSize, corners);
  UploadPart(target.Colors, this->Colors, ColorSize, corners);
}

bool vtkNBufferInstanceStream::Draw(
  int number, vtkOpenGLGlyph3DHelper* mapper, vtkOpenGLHelper* stream)
{
  const List& list = this->Lists[number];
  const auto buffers = vtkNBufferProtectedMembers::GetInstanceBuffers(mapper);
  const bool willAttach = buffers &&
    (buffers->BuildTime > buffers->LoadTime ||
      stream->ShaderSourceTime.GetMTime() > buffers->LoadTime);
  if (!buffers || willAttach || list.Size == 0)
  {
    return false;
  }
  this->Attach(stream, list.Matrices, list.NormalMatrices, list.Colors);
  stream->IBO->Bind();
  glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(stream->IBO->IndexCount),
    GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(list.Size));
  stream->IBO->Release();
  this->Attach(stream, buffers->Matrices, buffers->NormalMatrices, buffers->Colors);
  return true;
}

void vtkNBufferInstanceStream::Attach(vtkOpenGLHelper* stream, vtkOpenGLBufferObject* matrices,
  vtkOpenGLBufferObject* normalMatrices, vtkOpenGLBufferObject* colors)
{
  vtkShaderProgram* program = stream->Program;
  vtkOpenGLVertexArrayObject* array = stream->VAO;
  matrices->Bind();
  array->AddAttributeMatrixWithDivisor(program, matrices, "GCMCMatrix", 0,
    MatrixSize * sizeof(float), VTK_FLOAT, 4, false, 1, 4 * sizeof(float));
  matrices->Release();
  if (!this->NormalMatrices.empty() && program->IsAttributeUsed("glyphNormalMatrix"))
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
  for (List& list : this->Lists)
  {
    list.Matrices->ReleaseGraphicsResources();
    list.NormalMatrices->ReleaseGraphicsResources();
    list.Colors->ReleaseGraphicsResources();
    list.Size = 0;
  }
}
VTK_ABI_NAMESPACE_END
