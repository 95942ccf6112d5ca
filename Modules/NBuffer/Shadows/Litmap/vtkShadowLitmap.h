// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowLitmap
 * @brief Where, seen from the light, the camera sees something: receivers, and their extents. No
 * OpenGL.
 *
 * A litmap (X. Decoret, 2005, section 3.3) is an image from the light's point of view of what the
 * camera sees. The paper draws the scene again from the light and tests every pixel against the
 * camera's depth; that misses receivers. This one is made the other way round: every sample of the
 * camera's depth is scattered to the texels (lexels) where its light coordinates (p, q) may lie,
 * where it widens
 *
 *  - the range of depths [Near, Far] along the light's axis,
 *  - the box of pixels on the camera's screen,
 *  - the occupancy: one bit for each of 64 equal bins of the light depths of all receivers.
 *
 * So no receiver can be missed, whatever the resolution: resolution decides only how tight the
 * answers are. All three are merges that may count the same receiver twice, which is what the
 * levels of an N-buffer need: any rectangle of lexels is answered by four lookups.
 *
 * Which samples are receivers, and where they may lie, vtkShadowReceivers.h says. For comparison
 * vtkShadowRerenderedLitmap.h fills a litmap in the paper's way.
 */
#ifndef vtkShadowLitmap_h
#define vtkShadowLitmap_h

#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowTiles.h"

#include "vtkType.h"

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/**
 * What is known of the receivers in a part of the litmap; without any, as constructed. 32 bytes.
 */
struct vtkShadowExtent
{
  double Near = std::numeric_limits<double>::infinity(); ///< Least depth.
  double Far = -std::numeric_limits<double>::infinity(); ///< Largest depth.
  std::uint16_t X0 = 0xffff; ///< Box of pixels, half-open: X0 <= x < X1.
  std::uint16_t Y0 = 0xffff;
  std::uint16_t X1 = 0;
  std::uint16_t Y1 = 0;
  std::uint64_t Bins = 0; ///< Bit i: a receiver may lie in bin i of the litmap's depths.

  bool IsEmpty() const { return this->X1 <= this->X0; }

  void Merge(const vtkShadowExtent& other)
  {
    this->Near = other.Near < this->Near ? other.Near : this->Near;
    this->Far = other.Far > this->Far ? other.Far : this->Far;
    this->X0 = other.X0 < this->X0 ? other.X0 : this->X0;
    this->Y0 = other.Y0 < this->Y0 ? other.Y0 : this->Y0;
    this->X1 = other.X1 > this->X1 ? other.X1 : this->X1;
    this->Y1 = other.Y1 > this->Y1 ? other.Y1 : this->Y1;
    this->Bins |= other.Bins;
  }
};

class VTKNBUFFER_EXPORT vtkShadowLitmap
{
public:
  static constexpr int NumberOfBins = 64;
  static constexpr int MaximumResolution = 4096;

  /**
   * Start anew. The map has resolution x resolution lexels (1 to MaximumResolution) over
   * [range[0], range[1]] x [range[2], range[3]] in p and q; receivers outside are put into the
   * lexels of the border, where queries that reach outside find them. Bins divide
   * [depths[0], depths[1]]; receivers outside are in the first or last one. Memory is kept.
   */
  void Begin(int resolution, const double range[4], const double depths[2]);

  /**
   * Add a receiver that lies somewhere on the segment from a to b in light coordinates (p, q, s),
   * or at most `radius` beside it in p and q, and covers pixel (x, y), both below 65535. For a
   * receiver whose place is known a = b. Ends that are not finite (or whose sum is not) are
   * refused, which returns false; a radius of infinity puts it into all lexels.
   */
  bool Add(const double a[3], const double b[3], double radius, int x, int y);

  /**
   * Add receivers that lie in one lexel, at depths from `extent.Near` to `extent.Far` and within
   * its box of pixels; its bins are not used: all from Near to Far are set. Lexels outside of the
   * map, empty boxes, and depths that are not finite or not in order are refused, which returns
   * false.
   */
  bool AddLexel(int i, int j, vtkShadowExtent extent);

  ///@{
  /// Radians between a spot's axis and the farthest receiver outside of its cone
  /// (vtkShadowReceivers.h); 0, as after Begin(), without any.
  void WidenAngle(double angle)
  {
    this->WidestAngle = angle > this->WidestAngle ? angle : this->WidestAngle;
  }
  double GetWidestAngle() const { return this->WidestAngle; }
  ///@}

  ///@{
  /// The same receivers by tiles of the screen. Begin() leaves nothing known of them.
  vtkShadowTiles& GetTiles() { return this->Tiles; }
  const vtkShadowTiles& GetTiles() const { return this->Tiles; }
  ///@}

  ///@{
  /**
   * Add by several threads: after Begin() of litmap and tiles, Split() makes `count` (at least 1)
   * parts, each of which one thread may add to, and Join() merges them. The order of receivers
   * does not matter to extents and blocks, so that the litmap is the same to the bit. Part 0 is the
   * litmap itself; memory of the others is kept.
   */
  void Split(int count);
  vtkShadowLitmap& GetPart(int i) { return i == 0 ? *this : this->Parts[i - 1]; }
  void Join();
  ///@}

  /// Make all levels that queries need. No Add() until the next Begin().
  void Build();

  /**
   * Merge of the lexels that [p0, p1] x [q0, q1] touches, widened by one lexel on all sides, by at
   * most four lookups; the squares may reach beyond, so that the answer may be wider than need be.
   * NaN anywhere, or p0 > p1, asks for the whole map. Empty before Build().
   */
  vtkShadowExtent Query(double p0, double q0, double p1, double q1) const;

  int GetResolution() const { return this->Resolution; }
  int GetNumberOfLevels() const { return this->NumberOfLevels; }
  vtkIdType GetNumberOfReceivers() const { return this->NumberOfReceivers; }

  /// Lexels of one level, row by row; nullptr for a level that is not built.
  const vtkShadowExtent* GetLevelData(int level) const;

  /// The lexels that Query() merges at least; empty if they can hold no receiver.
  vtkNBufferRectangle GetLexels(double p0, double q0, double p1, double q1) const;

  /**
   * The slabs that hold all receivers of an extent, nearest first, from its bins: bins that follow
   * each other, or are parted by less than `gap` (at least 1) empty ones, make one slab. Each is
   * cut to the extent's Near and Far and is no wider than its bins, but for rounding; the first and
   * the last bin reach as far as the extent.
   */
  std::vector<std::pair<double, double>> GetSlabs(const vtkShadowExtent& extent, int gap) const;

private:
  /// `count` equal cells over an interval; what lies outside belongs to the first or last cell.
  struct Scale
  {
    double Low = 0.0;
    double High = 0.0;
    double CellsPerUnit = 0.0;
    int Count = 1;

    void Set(double low, double high, int count);
    /// Never decreases as x grows, rounding included: what lies between two values lies in a cell
    /// between theirs.
    int GetCell(double x) const
    {
      const double cell = (x - this->Low) * this->CellsPerUnit;
      if (!(cell > 0.0)) // NaN: an interval without a width has one cell.
      {
        return 0;
      }
      return cell < this->Count ? static_cast<int>(cell) : this->Count - 1;
    }
    double GetEdge(int cell) const;
  };

  std::uint64_t GetBins(double nearest, double farthest) const;
  void AddToLexels(int i0, int i1, int j0, int j1, const vtkShadowExtent& receiver);

  int Resolution = 0;
  int NumberOfLevels = 0;
  Scale P;
  Scale Q;
  Scale Depths;
  double Bounds[4] = {}; ///< The map's range, and of receivers outside.
  vtkIdType NumberOfReceivers = 0;
  double WidestAngle = 0.0;
  vtkShadowExtent Everywhere;          ///< Of receivers on any ray, for all lexels.
  std::vector<vtkShadowExtent> Lexels; ///< Level by level.
  vtkShadowTiles Tiles;
  std::vector<vtkShadowLitmap> Parts; ///< But for the first.
  int NumberOfParts = 1;
};

VTK_ABI_NAMESPACE_END
#endif
