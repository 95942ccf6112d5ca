// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowLitmap
 * @brief An image of the receivers as the light sees them: where they are, and their extents. No
 * OpenGL.
 *
 * A litmap (X. Decoret, "N-Buffers for efficient depth map query", Computer Graphics Forum 24(3),
 * 2005, section 3.3) is an image from the light's point of view of what the camera sees. The paper
 * draws the scene again from the light and tests every pixel against the camera's depth, which
 * misses receivers. This one is made the other way round: every sample of the camera's depth is
 * scattered to the texels (lexels) where its light coordinates (p, q) may lie. In each it widens
 *
 *  - the range of depths [Near, Far] along the light's axis,
 *  - the box of pixels on the camera's screen,
 *  - the occupancy: one bit for each of 64 equal bins of the light depths of all receivers.
 *
 *        camera's depth image              litmap, over p and q
 *        +---+---+---+---+                +---+---+---+---+
 *        |   | R |   |   |  light (p,q,s) |   |   | o |   |   o: Near, Far, box of pixels, bins
 *        +---+---+---+---+  ----------->  +---+---+---+---+
 *        |   |   |   |   |   scatter      |   |   | o |   |   Several lexels where the place
 *        +---+---+---+---+                +---+---+---+---+   of R is not known exactly.
 *
 * So no receiver can be missed, whatever the resolution: the resolution decides only how tight the
 * answers are. Merging the same receiver twice changes none of the three. The levels of an N-buffer
 * require that, because their squares overlap: four lookups answer for any rectangle of lexels.
 *
 * vtkShadowReceivers.h says which samples are receivers, vtkShadowReceiverProjector.h where they
 * may lie.
 */
#ifndef vtkShadowLitmap_h
#define vtkShadowLitmap_h

#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowBlock.h"
#include "vtkShadowTiles.h"

#include "vtkType.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkShadowLitmap
{
public:
  static constexpr int NumberOfBins = 64;
  static constexpr int MaximumResolution = 4096;

  /**
   * Removes all receivers and sets the range. The litmap has resolution x resolution lexels (1 to
   * MaximumResolution) over the range of p and q. Receivers outside of it go into the lexels of the
   * border, where queries that reach outside find them. The bins divide the range of depths s;
   * receivers outside of it go into the first or the last bin. Memory is kept.
   */
  void Begin(int resolution, const vtkShadowBlock& range);

  /**
   * Adds a receiver that covers pixel (x, y) of the viewport, both below 65535. It lies somewhere
   * on the segment from a to b in light coordinates (p, q, s), or at most `radius` from it in p and
   * q. If its place is known, a equals b. A radius of infinity puts it into all lexels. Returns
   * false, and adds nothing, if an end (or the sum of all coordinates) is not finite.
   */
  bool Add(const glm::dvec3& a, const glm::dvec3& b, double radius, int x, int y);

  /**
   * Adds receivers that lie in lexel (i, j), column and row, at depths from `extent.Near` to
   * `extent.Far` and within the extent's box of pixels. extent.Bins is ignored: all bins from Near
   * to Far are set. Returns false, and adds nothing, if the lexel is outside of the litmap, if the
   * box is empty, or if the depths are not finite or not in order.
   */
  bool AddLexel(int i, int j, vtkShadowExtent extent);

  /// Records a receiver outside of a spot's cone that VTK's shader may still light
  /// (vtkShadowReceiverProjector.h). `angle` is its angle from the spot's axis in radians.
  void WidenAngle(double angle)
  {
    this->WidestAngle = angle > this->WidestAngle ? angle : this->WidestAngle;
  }

  /// The largest of these angles, or 0 if no such receiver was added since Begin().
  double GetWidestAngle() const { return this->WidestAngle; }

  /// The same receivers by tiles of the screen. The tiles have a Begin() of their own; until it is
  /// called, vtkShadowTiles::IsKnown() is false.
  vtkShadowTiles& GetTiles() { return this->Tiles; }
  const vtkShadowTiles& GetTiles() const { return this->Tiles; }

  /// Makes `count` parts (at least 1) so that several threads can add receivers, each to its own
  /// part. Call it after Begin() and before receivers are added. The memory of parts is kept.
  void Split(int count) { this->Parts.resize(static_cast<std::size_t>(std::max(count, 1) - 1)); }

  /// Clears one of the parts that Split() made, and returns it. Part 0 is the litmap itself, which
  /// is clear already. Threads may clear different parts at the same time. Only the litmap itself
  /// has tiles.
  vtkShadowLitmap& BeginPart(int i);

  /// Merges the parts, all of which must have begun. The order of receivers does not matter to
  /// extents, so the litmap is the same to the bit with any number of parts.
  void Join();

  /// Builds the levels for Query(). Call it when all receivers have been added. More of them may be
  /// added only after the next Begin().
  void Build();

  /**
   * Returns the merged extent of the lexels that the rectangle [p0, p1] x [q0, q1] touches, widened
   * by one lexel on all sides. At most four lookups answer it. Their squares may reach beyond the
   * rectangle, so that the extent may be wider than necessary. If a value is NaN, or if p0 > p1 or
   * q0 > q1, the rectangle is the whole litmap. The extent is empty before Build().
   */
  vtkShadowExtent Query(double p0, double q0, double p1, double q1) const;

  int GetResolution() const { return this->Resolution; }
  int GetNumberOfLevels() const { return this->NumberOfLevels; }
  vtkIdType GetNumberOfReceivers() const { return this->NumberOfReceivers; }

  /// The lexels of one level, row by row, or nullptr for a level that is not built.
  const vtkShadowExtent* GetLevelData(int level) const;

  /// The lexels that Query() has to merge, with the additional lexel on all sides. The rectangle is
  /// empty if there can be no receiver in them.
  vtkNBufferRectangle GetLexels(double p0, double q0, double p1, double q1) const;

  /**
   * Returns the slabs that hold all receivers of an extent, the nearest first, from its bins.
   * Occupied bins belong to the same slab if fewer than `gap` (at least 1) empty bins lie between
   * them:
   *
   *     bins        . # # . # . . . . # .      gap 4: one slab from 1 to 4, one of bin 9
   *     s ------->  0 1 2 3 4 5 6 7 8 9 10     gap 5: one slab from 1 to 9
   *
   * Each slab is cut to the extent's Near and Far and is no wider than its bins, except for
   * rounding. The first and the last bin reach as far as the extent.
   */
  std::vector<vtkShadowSlab> GetSlabs(const vtkShadowExtent& extent, int gap) const;

private:
  /// An interval, divided into equal cells. Values outside belong to the first or the last cell.
  struct Scale
  {
    explicit Scale(double low = 0.0, double high = 0.0, int count = 1)
      : Low(low)
      , High(high)
      , CellsPerUnit(high > low ? count / (high - low) : 0.0)
      , Count(count)
    {
    }

    /// The number of the cell of x. It never decreases as x grows, in spite of rounding: a value
    /// between two others lies in one of the cells from theirs to theirs.
    int GetCell(double x) const
    {
      const double cell = (x - this->Low) * this->CellsPerUnit;
      if (!(cell > 0.0)) // An interval without a width gives 0 or NaN: everything is in cell 0.
      {
        return 0;
      }
      return cell < this->Count ? static_cast<int>(cell) : this->Count - 1;
    }
    /// The lower edge of a cell.
    double GetEdge(int cell) const
    {
      return this->Low + (this->High - this->Low) * cell / this->Count;
    }

    double Low;
    double High;
    double CellsPerUnit;
    int Count;
  };

  std::uint64_t GetBins(double nearest, double farthest) const;
  void AddToLexels(int i0, int i1, int j0, int j1, const vtkShadowExtent& receiver);

  int Resolution = 0;
  int NumberOfLevels = 0;
  Scale P;
  Scale Q;
  Scale Depths;
  ///@{
  /// The least and the largest p and q of the litmap's range and of receivers outside of it.
  glm::dvec2 Low = glm::dvec2(0.0);
  glm::dvec2 High = glm::dvec2(0.0);
  ///@}
  vtkIdType NumberOfReceivers = 0;
  double WidestAngle = 0.0;
  vtkShadowExtent Everywhere;          ///< The receivers that may be on any ray, for all lexels.
  std::vector<vtkShadowExtent> Lexels; ///< All levels, one after the other.
  vtkShadowTiles Tiles;
  std::vector<vtkShadowLitmap> Parts; ///< All parts except for the first.
};

VTK_ABI_NAMESPACE_END
#endif
