// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferLevels
 * @brief The levels of an N-buffer in host memory: built, filled from elsewhere, and queried.
 *
 * It is the oracle of the OpenGL levels (vtkNBufferTexture, bit for bit the same) and, on
 * software renderers, what the culler uses instead of them. vtkNBufferMath.h says what a texel
 * covers. Values are window depths in [0, 1], but any floats without NaN do.
 *
 * Memory is (number of levels) * (base size) floats and is kept from build to build. Building a
 * level reads the level below once; images of four million texels and more are shared out by
 * vtkSMPTools. A query is at most four reads, whatever the size of its rectangle.
 */
#ifndef vtkNBufferLevels_h
#define vtkNBufferLevels_h

#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferLevels
{
public:
  /**
   * Make level 0 from a depth image of width x height pixels (row 0 at the bottom) by taking
   * the extremum over squares of `factor` pixels (1, 2, 4, 8 or any other positive number), the
   * cut ones at the right and upper border included. Levels above 0 are dropped.
   */
  void BuildBase(
    const float* depth, int width, int height, int factor, vtkNBufferExtremum extremum);

  /**
   * Make level 0 room for a base of width x height texels that somebody else fills (through
   * GetLevelData(0)), each standing for `factor` x `factor` pixels, and `levels` levels in all
   * if they are filled as well. pixelWidth and pixelHeight are the size of the depth image.
   */
  void Allocate(
    int pixelWidth, int pixelHeight, int factor, int levels, vtkNBufferExtremum extremum);

  /**
   * Build the levels that are missing up to `count` levels in all, at most
   * vtkNBufferMath::GetNumberOfLevels of the base. Returns how many levels it built.
   */
  int BuildLevels(int count);

  /// Forget the image: every query is refused until the next build.
  void Clear();

  int GetPixelWidth() const { return this->PixelWidth; }
  int GetPixelHeight() const { return this->PixelHeight; }
  int GetFactor() const { return this->Factor; }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  int GetNumberOfLevels() const { return this->NumberOfLevels; }
  vtkNBufferExtremum GetExtremum() const { return this->Extremum; }

  /// Texels of one level, row by row from the bottom; nullptr for a level that is not built.
  const float* GetLevelData(int level) const;
  float* GetLevelData(int level);

  /**
   * Extremum over a cover whose level is built. The caller asks vtkNBufferMath for the cover.
   */
  float Query(const vtkNBufferCover& cover) const
  {
    const bool maximum = this->Extremum == vtkNBufferExtremum::Maximum;
    return vtkNBufferMath::MergeCover(this->Texels.data(), this->Width, this->Height, cover,
      [maximum](float a, float b) { return maximum == (b > a) ? b : a; });
  }

private:
  std::size_t GetLevelOffset(int level) const
  {
    return static_cast<std::size_t>(level) * this->Width * this->Height;
  }

  std::vector<float> Texels;
  int PixelWidth = 0;
  int PixelHeight = 0;
  int Factor = 1;
  int Width = 0;
  int Height = 0;
  int NumberOfLevels = 0;
  vtkNBufferExtremum Extremum = vtkNBufferExtremum::Maximum;
};

VTK_ABI_NAMESPACE_END
#endif
