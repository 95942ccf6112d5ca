// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DepthStructure
 * @brief Any member of the family (DepthFamily.h): built from a depth image, queried by rectangles.
 *
 * An answer is never nearer than the farthest depth in the rectangle. It is the farthest depth of
 * GetCovered(), which says how much more than the rectangle was looked at. The base, and the levels
 * of plain squares, are those of vtkNBufferLevels, the module's own.
 */
#ifndef DepthStructure_h
#define DepthStructure_h

#include "DepthFamily.h"

#include "vtkNBufferLevels.h"
#include "vtkNBufferMath.h"

#include <cstddef>
#include <vector>

namespace NBufferStudy
{

/// The texels of one level that answer a rectangle: all of Columns x Rows.
struct DepthCover
{
  int Level = 0; ///< Place in the list of levels.
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

  const DepthFamily& GetFamily() const { return this->Family; }

  /// Lay out the levels for images of this size, which Build() does where it has changed. Enough
  /// for GetCovered(), GetCover() and GetNumberOfTexels(): memory comes with the first build.
  void SetSize(int width, int height);

  /// `depth`: order of distance, larger is farther; row 0 at the bottom.
  void Build(const float* depth, int width, int height);

  /// `pixels` must not be empty and lie inside the image. Adds what was read to `lookups`.
  float Query(const vtkNBufferRectangle& pixels, long long& lookups) const;

  /// The pixels that Query() looks at.
  vtkNBufferRectangle GetCovered(const vtkNBufferRectangle& pixels) const;

  /// The cover of a rectangle of texels of the base; not for DepthTaps::All.
  DepthCover GetCover(const vtkNBufferRectangle& texels) const;

  int GetNumberOfLevels() const { return static_cast<int>(this->Levels.size()); }

  /// Of all levels, from their sizes alone.
  std::size_t GetNumberOfTexels() const;

  /// Bytes that are held for the levels, scratch included.
  std::size_t GetMemory() const;

private:
  struct Level
  {
    int X = 0; ///< Level of the horizontal axis.
    int Y = 0;
    int Width = 0;
    int Height = 0;
    int From = 0; ///< Place of the level that it is made of.
    ///@{
    /// Axes along which it is one step above that.
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
  std::vector<int> Places; ///< Of level (x, y) in Levels, or -1.
  int Side = 0;            ///< Of Places.
  int Width = 0;
  int Height = 0;
  std::vector<float> Scratch;
};

} // namespace NBufferStudy

#endif
