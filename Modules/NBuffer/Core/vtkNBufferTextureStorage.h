// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferTextureStorage.h
 * @brief The OpenGL objects of a vtkNBufferTexture: they grow and never shrink until released.
 *
 * Even and odd levels live in two array textures, level i in layer i / 2 of array i % 2:
 *
 *     array 0:  level 0   level 2   level 4  ...
 *                  |     ^   |     ^
 *                  v    /    v    /
 *     array 1:  level 1   level 3   level 5  ...
 *
 * A pass then reads one array and writes the other. With a single array it would be a feedback
 * loop: OpenGL 3.2 looks only at the mip level of what is attached and sampled, which is 0 for
 * both, and not at the layer (section 4.4.3). Two samplers are enough for queries in shaders.
 */
#ifndef vtkNBufferTextureStorage_h
#define vtkNBufferTextureStorage_h

#include "vtkNBufferVTKVersion.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferTextureStorage
{
public:
  static constexpr int ArrayCount = 2;
  static int GetArrayIndex(int level) { return level % ArrayCount; }
  static int GetLayer(int level) { return level / ArrayCount; }

  /// Room for levels of at least this size; false, with the cause, if OpenGL refuses.
  bool ReserveLevels(int width, int height, int levels, std::string& why);

  /// A copy of depth in the sized GL format given, at least this large; left bound.
  bool ReserveCopy(unsigned int format, int width, int height, std::string& why);

  /// Depth as 32-bit integers, and the buffer through which they come; the texture is left bound.
  bool ReserveIntegers(int width, int height, std::string& why);

  /// A buffer to read levels back through.
  bool ReserveReadback(std::size_t bytes, std::string& why);

  /// One of the arrays (by level) and a framebuffer that has this level as its only attachment.
  unsigned int GetArray(int level) const { return this->Arrays[GetArrayIndex(level)]; }
  unsigned int GetFramebuffer(int level) const { return this->Framebuffers[level]; }

  unsigned int GetIntegerBuffer() const { return this->IntegerBuffer.Name; }
  unsigned int GetReadbackBuffer() const { return this->ReadbackBuffer.Name; }
  unsigned int GetVertexArray();

  /// Times that OpenGL was asked for memory since construction.
  int GetNumberOfAllocations() const { return this->Allocations; }

  /// Delete everything; the context that made it must be current.
  void Release();

  /// The context that made the objects is gone, and they with it.
  void Forget();

private:
  struct Image
  {
    unsigned int Name = 0;
    unsigned int Format = 0;
    int Width = 0;
    int Height = 0;
  };
  struct Buffer
  {
    unsigned int Name = 0;
    std::size_t Bytes = 0;
  };

  bool ReserveImage(Image& image, unsigned int format, unsigned int components, unsigned int type,
    int width, int height, std::string& why);
  bool ReserveBuffer(
    Buffer& buffer, unsigned int target, unsigned int usage, std::size_t bytes, std::string& why);
  bool AllocateArrays(int width, int height, int levels, std::string& why);
  bool AllocateFramebuffers(int levels, std::string& why);
  void ReleaseLevels();

  int Width = 0;
  int Height = 0;
  int Levels = 0;
  int Allocations = 0;
  unsigned int VertexArray = 0;
  unsigned int Arrays[ArrayCount] = { 0, 0 };
  std::vector<unsigned int> Framebuffers;
  Image Copy;
  Image Integers;
  Buffer IntegerBuffer;
  Buffer ReadbackBuffer;
};
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferTextureStorage.h
