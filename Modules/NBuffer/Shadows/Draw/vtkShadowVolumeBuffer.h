// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowVolumeBuffer
 * @brief The vertices and indices of a light's shadow volumes on the device.
 *
 * Volumes are kept from frame to frame (vtkShadowVolumeStore.h). What is on the device stays there
 * while there is room, and only what has been added since is sent.
 *
 * Vertices are in world coordinates, in double precision. Shaders calculate in floats, which have
 * 24 bits. So each coordinate is sent as the sum of two floats, `high` and `low`, and the vertex
 * shader subtracts the eye's coordinates, which are given likewise, part by part (Cozzi and Ring,
 * 3D Engine Design for Virtual Globes, 2011, section 5.4). The error of the difference is then
 * about that of rounding the difference of doubles to a float: it is in proportion to the distance
 * from the eye, and not to that from the world's origin.
 */
#ifndef vtkShadowVolumeBuffer_h
#define vtkShadowVolumeBuffer_h

#include "vtkNBufferGLObject.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowDrawList.h"

#include "vtkType.h"

#include <cstddef>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkShaderProgram;

class VTKNBUFFER_EXPORT vtkShadowVolumeBuffer
{
public:
  /// Sends what the store's volume holds and the device does not have yet. If there is nothing to
  /// send, OpenGL is not called. Returns false, with the cause in `why`, if an OpenGL call fails.
  bool Upload(const vtkShadowVolumeStore& store, std::string& why);

  /// Binds the vertices to the current program, which must use vtkShadowVolumeVS.glsl, and sets the
  /// program's camera. The vertex array of this object stays bound.
  void Bind(vtkShaderProgram* program, const vtkShadowDrawList::View& view) const;

  /// The bytes that were sent to the device since construction.
  std::size_t GetUploadedBytes() const { return this->UploadedBytes; }

private:
  /// A buffer object that grows. Only what is added is sent, if the object has room for it.
  struct GrowingBuffer
  {
    vtkNBufferGL::Buffer Object;
    std::size_t Capacity = 0; ///< In elements.
    std::size_t Size = 0;     ///< The number of elements that were sent.
  };

  template <typename T, typename Get>
  bool Send(unsigned int target, GrowingBuffer& buffer, std::size_t size, Get get);

  GrowingBuffer Vertices;
  GrowingBuffer Indices;
  vtkNBufferGL::VertexArray VertexArray;
  vtkMTimeType StoreTime = 0; ///< vtkShadowVolumeStore::GetTime() of what is on the device.
  std::size_t UploadedBytes = 0;
};
VTK_ABI_NAMESPACE_END
#endif
