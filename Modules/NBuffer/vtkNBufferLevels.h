// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferLevels
 * @brief The levels of an N-buffer in host memory: builds them, or stores those built elsewhere,
 * and answers queries.
 *
 * The levels that vtkNBufferTexture builds with OpenGL are the same to the bit, and the tests
 * compare them. The culler tests props with the levels of this class. vtkNBufferMath.h
 * defines which squares a texel covers. Values are window depths in [0, 1]; any floats without NaN
 * work.
 *
 * The memory is (number of levels) * (base size) floats and is kept from build to build. Building a
 * level reads the level below once; for images of four million texels and more vtkSMPTools shares
 * the rows among threads. A query reads at most four texels, whatever the size of its rectangle.
 */
#ifndef vtkNBufferLevels_h
#define vtkNBufferLevels_h

#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro

#include "vtkType.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// The rows of a depth image in which anything may have been drawn: Begin to End - 1.
struct vtkNBufferRows
{
  int Begin = 0;
  int End = VTK_INT_MAX;
  float Outside = 1.0f; ///< The depth of every pixel in other rows.
};

class VTKNBUFFER_EXPORT vtkNBufferLevels
{
public:
  /**
   * Make level 0 from a depth image of width x height pixels, whose row 0 is the lowest, by taking
   * the extremum over squares of `factor` x `factor` pixels. The factor is any positive number. A
   * square at the right or upper border may contain fewer pixels. Squares in which no pixel is in
   * `rows` are not looked at. Levels above 0 are dropped.
   */
  void BuildBase(const float* depth, int width, int height, int factor, vtkNBufferExtremum extremum,
    const vtkNBufferRows& rows = {});

  /**
   * Make room for `levels` levels (at most vtkNBufferMath::GetNumberOfLevels() of the base) over a
   * depth image of pixelWidth x pixelHeight pixels, of which each texel of level 0 covers
   * `factor` x `factor`. The caller fills the levels through GetLevelData().
   */
  void Allocate(
    int pixelWidth, int pixelHeight, int factor, int levels, vtkNBufferExtremum extremum);

  /**
   * Build the missing levels, so that there are `count` levels, but at most
   * vtkNBufferMath::GetNumberOfLevels() of the base. Returns how many levels this call built.
   */
  int BuildLevels(int count);

  /// Drop all levels. The memory is kept.
  void Clear();

  ///@{
  /// The size of the depth image in pixels, and the side in pixels of the square that a texel of
  /// level 0 covers.
  int GetPixelWidth() const { return this->PixelWidth; }
  int GetPixelHeight() const { return this->PixelHeight; }
  int GetFactor() const { return this->Factor; }
  ///@}

  ///@{
  /// The size of each level in texels, and the number of levels that are built or allocated.
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  int GetNumberOfLevels() const { return this->NumberOfLevels; }
  ///@}

  /// Whether texels are maxima or minima.
  vtkNBufferExtremum GetExtremum() const { return this->Extremum; }

  /// The texels of a level, row by row, the lowest first; nullptr for a level that is not built.
  const float* GetLevelData(int level) const;
  float* GetLevelData(int level);

  /// A texel of a level that is built.
  float GetTexel(int level, int x, int y) const
  {
    return this
      ->Texels[this->GetLevelOffset(level) + static_cast<std::size_t>(y) * this->Width + x];
  }

  /**
   * The extremum over the texels of a cover (vtkNBufferMath::GetCoverOfFour), whose level must be
   * built.
   */
  float Query(const vtkNBufferCover& cover) const
  {
    const bool maximum = this->Extremum == vtkNBufferExtremum::Maximum;
    return vtkNBufferMath::MergeCover(this->Texels.data(), this->Width, this->Height, cover,
      [maximum](float a, float b) { return maximum == (b > a) ? b : a; });
  }

  /**
   * Where the extremum is that Query() finds: the pixels of a texel of level 0 that has it, at most
   * GetFactor() x GetFactor(). The paper (section 2) stores places next to the depths; here a texel
   * of each lower level is found that has the same value, so that the places need neither memory
   * nor time while levels are built. Reads at most four texels per level.
   */
  vtkNBufferRectangle FindPixels(const vtkNBufferCover& cover) const;

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
