// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class PackedLevels
 * @brief All levels of an N-buffer side by side in one texture, to compare with the module's
 * arrays.
 *
 *     +---------+---------+---------+
 *     | level 3 | level 4 | level 5 |
 *     +---------+---------+---------+
 *     | level 0 | level 1 | level 2 |
 *     +---------+---------+---------+
 *
 * The paper (section 4.1) packs the levels horizontally, and could not for widths above 256,
 * because the device had a limit. Here a row ends at the limit.
 *
 * A pass reads and writes different texels of the same texture, which OpenGL 4.5 allows with
 * glTextureBarrier() before the pass.
 */
#ifndef PackedLevels_h
#define PackedLevels_h

#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGLObject.h"
#include "vtkNBufferTexture.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace NBufferPeers
{

class PackedLevels
{
public:
  PackedLevels();

  /// Returns why the current context cannot have levels of this size, or an empty text if it can.
  static std::string WhyNot(int width, int height);

  /// Copies level 0 of `base`, of factor 1, and builds all levels above it. This function and the
  /// next one do not wait for the device, and throw std::runtime_error on an error of OpenGL.
  void Build(vtkOpenGLRenderWindow* window, vtkNBufferTexture* base);

  /// Queries a rectangle for each pixel: of these levels, or of `levels`, which has all levels of
  /// an image of the same size and of factor 1.
  void Query(vtkOpenGLRenderWindow* window, vtkNBufferTexture* levels);

  /// Waits for the last Query(), and reads the depths that it found.
  std::vector<float> ReadDepths();

  /// Deletes the objects of OpenGL; the context must be current.
  void Release();

private:
  int Width = 0;
  int Height = 0;
  int Columns = 1;
  vtkNBufferGL::GrowingTexture Packed;
  vtkNBufferGL::GrowingTexture Answers;
  vtkNBufferGL::FullScreenPass LevelPass;
  vtkNBufferGL::FullScreenPass QueryPass;
};

} // namespace NBufferPeers

#endif
