// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolumeBuffer.h"

#include "vtkNBufferGL.h"

#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A vertex as vtkShadowVolumeVS.glsl gets it.
struct Corner
{
  float High[4];
  float Low[3];
};

Corner MakeCorner(const glm::dvec4& vertex)
{
  Corner corner;
  for (int i = 0; i < 3; ++i)
  {
    // Volatile, because GCC 12.2 with -O2 or -O3 makes the low parts of some vertices of the
    // vectorised loop 0 (GpuTestShadowCounter.VolumesAreExactFarFromTheOrigin finds it).
    const volatile float high = static_cast<float>(vertex[i]);
    corner.High[i] = high;
    corner.Low[i] = static_cast<float>(vertex[i] - static_cast<double>(high));
  }
  corner.High[3] = static_cast<float>(vertex.w);
  return corner;
}

void BindAttribute(vtkShaderProgram* program, const char* name, int size, std::size_t offset)
{
  const int attribute = glGetAttribLocation(program->GetHandle(), name);
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(
    attribute, size, GL_FLOAT, GL_FALSE, sizeof(Corner), reinterpret_cast<const void*>(offset));
}
}

/// Makes the buffer hold get(0) to get(size - 1). Returns false if there is no memory.
template <typename T, typename Get>
bool vtkShadowVolumeBuffer::Send(
  unsigned int target, GrowingBuffer& buffer, std::size_t size, Get get)
{
  glBindBuffer(target, buffer.Object.Create());
  if (size > buffer.Capacity || buffer.Size == 0)
  {
    // New memory, so that nothing waits for earlier draws, with room for half as much again.
    buffer.Size = 0;
    buffer.Capacity = size + size / 2;
    glBufferData(
      target, static_cast<GLsizeiptr>(buffer.Capacity * sizeof(T)), nullptr, GL_DYNAMIC_DRAW);
  }
  if (size > buffer.Size)
  {
    // Earlier draws read what is before this range only.
    const std::size_t bytes = (size - buffer.Size) * sizeof(T);
    auto* place = static_cast<T*>(glMapBufferRange(target,
      static_cast<GLintptr>(buffer.Size * sizeof(T)), static_cast<GLsizeiptr>(bytes),
      GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_UNSYNCHRONIZED_BIT));
    if (!place)
    {
      return false;
    }
    for (std::size_t i = buffer.Size; i < size; ++i)
    {
      *place++ = get(i);
    }
    if (!glUnmapBuffer(target))
    {
      return false;
    }
    this->UploadedBytes += bytes;
    buffer.Size = size;
  }
  return glGetError() == GL_NO_ERROR;
}

bool vtkShadowVolumeBuffer::Upload(const vtkShadowVolumeStore& store, std::string& why)
{
  const vtkShadowVolume& volume = store.GetVolume();
  const auto& vertices = volume.GetVertices();
  const auto& indices = volume.GetIndices();
  if (this->StoreTime != store.GetTime())
  {
    this->Vertices.Size = 0;
    this->Indices.Size = 0;
    this->StoreTime = store.GetTime();
  }
  if (this->Vertices.Size == vertices.size() && this->Indices.Size == indices.size())
  {
    return true;
  }
  vtkNBufferGL::ClearErrors();
  const int arrayBuffer = vtkNBufferGL::GetInteger(GL_ARRAY_BUFFER_BINDING);
  const int vertexArray = vtkNBufferGL::GetInteger(GL_VERTEX_ARRAY_BINDING);
  glBindVertexArray(this->VertexArray.Create());
  const bool uploaded = this->Send<Corner>(GL_ARRAY_BUFFER, this->Vertices, vertices.size(),
                          [&vertices](std::size_t i) { return MakeCorner(vertices[i]); }) &&
    this->Send<unsigned int>(GL_ELEMENT_ARRAY_BUFFER, this->Indices, indices.size(),
      [&indices](std::size_t i) { return indices[i]; });
  glBindVertexArray(vertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, arrayBuffer);
  if (!uploaded)
  {
    vtkNBufferGL::ClearErrors();
    this->StoreTime = 0;
    why = "There is no memory on the device for " + std::to_string(indices.size() / 3) +
      " triangles of shadow volumes. Let fewer or simpler props cast.";
  }
  return uploaded;
}

void vtkShadowVolumeBuffer::Bind(
  vtkShaderProgram* program, const vtkShadowDrawList::View& view) const
{
  const Corner eye = MakeCorner(glm::dvec4(view.Eye, 1.0));
  program->SetUniform3f("eyeHigh", eye.High);
  program->SetUniform3f("eyeLow", eye.Low);
  vtkNBufferGL::SetMatrix(program, "eyeToClip", view.EyeToClip);
  glBindVertexArray(this->VertexArray.GetName());
  const int arrayBuffer = vtkNBufferGL::GetInteger(GL_ARRAY_BUFFER_BINDING);
  glBindBuffer(GL_ARRAY_BUFFER, this->Vertices.Object.GetName());
  BindAttribute(program, "high", 4, offsetof(Corner, High));
  BindAttribute(program, "low", 3, offsetof(Corner, Low));
  glBindBuffer(GL_ARRAY_BUFFER, arrayBuffer);
}
VTK_ABI_NAMESPACE_END
