// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DepthStructure
 * @brief One structure of a family, built from a depth image; it returns a bound of the farthest
 * depth in a rectangle.
 *
 * The parameters that select one structure of the family are:
 *
 *     parameter   meaning
 *     Factor      pixels per texel of the base, which holds their farthest depth
 *     Grid        the texels along an axis, see DepthAxis.h
 *     Stride      the s of Windows
 *     Band        levels (i, j) of windows 2^i wide and 2^j high with |i - j| <= Band; 0: squares
 *     Taps        how many texels are read for a rectangle, and in which shapes
 *     Separable   whether rows and then columns are merged, through memory, or both at once
 *
 * The result of Query() is never nearer than the farthest depth in the rectangle. It is the
 * farthest depth in GetCovered(), which is the rectangle or larger. The base, and the levels of
 * plain squares, are those of the module's own vtkNBufferLevels.
 */
#ifndef DepthStructure_h
#define DepthStructure_h

#include "DepthAxis.h"

#include "vtkNBufferLevels.h"
#include "vtkNBufferMath.h"

#include <cstddef>
#include <string>
#include <vector>

namespace NBufferStudy
{

enum class DepthTaps
{
  One,
  Four,     ///< Two by two, four in a row or four in a column: the shape that covers least.
  TwoByTwo, ///< The texels that graphics hardware fetches at once.
  FourByFour,
  All ///< Every texel of the base that the rectangle touches; there are no levels.
};

constexpr int AllShapes = 30;

struct DepthFamily
{
  int Factor = 1;
  DepthGrid Grid = DepthGrid::Windows;
  int Stride = FullStride;
  int Band = 0;
  DepthTaps Taps = DepthTaps::Four;
  bool Separable = false;

  /// Returns a name that is unique within the family, such as "squares x4 1/4", "rectangles band 1
  /// s=2 x4 1/1" or "mips 2x2 1/1".
  std::string GetName() const;
};

/// The texels of one level that cover a rectangle: all of Columns x Rows.
struct DepthCover
{
  int Level = 0; ///< The place of the level in the list of levels.
  int LevelX = 0;
  int LevelY = 0;
  int Columns = 0;
  int Rows = 0;
  int X[4] = { 0, 0, 0, 0 };
  int Y[4] = { 0, 0, 0, 0 };
};

class DepthStructure
{
public:
  explicit DepthStructure(const DepthFamily& family);

  /// Lays out the levels for images of this size; Build() does the same if the size has changed.
  /// This suffices for GetCovered(), GetCover() and GetNumberOfTexels(). Only Build() allocates
  /// memory.
  void SetSize(int width, int height);

  /// Builds all levels. Larger values of `depth` are farther; row 0 is at the bottom.
  void Build(const float* depth, int width, int height);

  /// Returns a bound of the depth in `pixels`, which must not be empty and must lie inside the
  /// image. Adds the number of texels that were read to `lookups`.
  float Query(const vtkNBufferRectangle& pixels, long long& lookups) const;

  /// Returns the pixels that Query() covers.
  vtkNBufferRectangle GetCovered(const vtkNBufferRectangle& pixels) const;

  /// Returns the cover of a rectangle of texels of the base. Not for DepthTaps::All.
  DepthCover GetCover(const vtkNBufferRectangle& texels) const;

  int GetNumberOfLevels() const { return static_cast<int>(this->Levels.size()); }

  /// Returns the number of texels of all levels.
  std::size_t GetNumberOfTexels() const;

  /// Returns the bytes that are allocated for the levels, including scratch memory.
  std::size_t GetMemory() const;

private:
  struct Level
  {
    int X = 0; ///< The level of the horizontal axis.
    int Y = 0; ///< The level of the vertical axis.
    int Width = 0;
    int Height = 0;
    int From = 0; ///< The place of the level from which this one is built.
    ///@{
    /// Whether this level is one step above that one along each axis.
    bool StepX = false;
    bool StepY = false;
    ///@}
    float* Texels = nullptr;
    std::vector<float> Storage;
  };

  bool IsPlain() const;
  bool HasLevel(int x, int y) const;
  void Allocate();
  void BuildLevel(Level& level);
  void BuildColumns(const float* in, int width, int height, const Level& level, float* out);

  DepthFamily Family;
  DepthAxis Columns;
  DepthAxis Rows;
  vtkNBufferLevels Base;
  std::vector<Level> Levels;
  std::vector<int> Places; ///< The place of level (x, y) in Levels, or -1.
  int Side = 0;            ///< The side of the square Places.
  int Width = 0;
  int Height = 0;
  std::vector<float> Scratch;
};

} // namespace NBufferStudy

#endif
