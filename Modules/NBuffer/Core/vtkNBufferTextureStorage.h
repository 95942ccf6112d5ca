// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferTextureStorage.h
 * @brief The OpenGL objects of a vtkNBufferTexture. They grow and never shrink until deleted.
 *
 * Even and odd levels live in two array textures, level i in layer i / 2 of array i % 2:
 *
 *     array 0:  level 0   level 2   level 4  ...
 *                  |     ^   |     ^
 *                  v    /    v    /
 *     array 1:  level 1   level 3   level 5  ...
 *
 * A pass then reads one array and writes the other. With a single array this would be a feedback
 * loop: OpenGL 3.2 compares only the mip levels that are attached and sampled, which are both 0,
 * and not the layers (section 4.4.3). Shaders that query the levels need only two samplers.
 */
#ifndef vtkNBufferTextureStorage_h
#define vtkNBufferTextureStorage_h

#include "vtkNBufferGLObject.h"
#include "vtkNBufferMath.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
struct vtkNBufferDepthSource;

class vtkNBufferTextureStorage
{
public:
  static constexpr int ArrayCount = 2;
  static int GetLayer(int level) { return level / ArrayCount; }

  /// Make room for at least `levels` levels of at least width x height texels with at least
  /// `channels` channels, 1 or 2. Returns false, with the cause in `why`, if OpenGL refuses.
  bool ReserveLevels(int width, int height, int levels, int channels, std::string& why);

  /// The depth that the base pass samples, and where the rectangle begins in it.
  struct SampledDepth
  {
    int Kind = 0;         ///< NBUFFER_SOURCE_DEPTH or another of vtkNBufferShared.h.
    bool Foreign = false; ///< Other code owns the texture, whose parameters must be restored.
    unsigned int Target = 0;
    int Level = 0;
    int Origin[2] = { 0, 0 };
  };

  /**
   * Bind the texture that holds the depth of a rectangle of framebuffer pixels of `source`, which
   * is copied unless it is in a texture whose texels fit floats. Returns false, with the cause in
   * `why`, if OpenGL refuses.
   */
  bool BindDepth(const vtkNBufferDepthSource& source, int x, int y, int width, int height,
    SampledDepth& depth, std::string& why);

  /**
   * Copy the texels of the lowest levels that lie in `rectangles` to their places in `texels`,
   * where levels of width x height texels follow each other, in one blocking read-back. Returns
   * false, with the cause in `why`, if OpenGL refuses.
   */
  bool Read(const std::vector<vtkNBufferRectangle>& rectangles, int levels, int width, int height,
    float* texels, std::string& why);

  /// The name of the array that holds a level.
  unsigned int GetArray(int level) const { return this->Arrays[level % ArrayCount].GetName(); }

  /// The name of the framebuffer that has a level as its only attachment.
  unsigned int GetFramebuffer(int level) const { return this->Framebuffers[level].GetName(); }

  /// How often memory was requested from OpenGL since construction.
  int GetNumberOfAllocations() const;

  /// Delete the objects.
  void Delete(vtkNBufferGL::Context context);

private:
  struct Buffer
  {
    vtkNBufferGL::Buffer Object;
    std::size_t Bytes = 0;
  };

  bool ReserveBuffer(Buffer& buffer, unsigned int usage, std::size_t bytes, std::string& why);
  bool AllocateArrays(int width, int height, int levels, int channels, std::string& why);
  bool AllocateFramebuffers(int levels, std::string& why);
  void DeleteLevels(vtkNBufferGL::Context context);

  int Width = 0;
  int Height = 0;
  int Levels = 0;
  int Channels = 0;
  int Allocations = 0; ///< Without those of Copy and Integers.
  vtkNBufferGL::Texture Arrays[ArrayCount];
  std::vector<vtkNBufferGL::Framebuffer> Framebuffers;
  vtkNBufferGL::GrowingTexture Copy;     ///< A copy of the depth from which level 0 is made.
  vtkNBufferGL::GrowingTexture Integers; ///< A copy of the depth as 32-bit integers.
  Buffer IntegerBuffer;
  Buffer ReadbackBuffer;
};
VTK_ABI_NAMESPACE_END
#endif
