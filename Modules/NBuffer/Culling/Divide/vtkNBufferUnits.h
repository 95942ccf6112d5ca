// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferUnits
 * @brief The parts of a large mesh that are culled one by one, and a hierarchy of their boxes. No
 * OpenGL.
 *
 * A unit is a group of primitives, which are triangles or points. The units are either runs of
 * neighbours in the order in which the mesh is drawn, or groups of neighbours in space, whichever
 * have the smaller boxes. Many files list their triangles row by row or part by part, so that runs
 * are small. Isosurfaces and scans do not.
 *
 * Groups in space are the leaves of a k-d tree of the middles of the primitives: each part is split
 * across its longest side until it is a unit. They only say which primitives belong together:
 * GetRanges() returns the primitives of any set of units in the order in which the mesh is drawn,
 * because of several fragments of equal depth the last one drawn stays.
 *
 * Level 0 of the hierarchy consists of the units. A node of a higher level bounds up to Fanout
 * nodes of the level below it:
 *
 *     level 2                            0
 *     level 1            0               1                  2
 *     level 0     0 1 2 3 4 5 6 7   8 9 ... 15   16 17 18
 *
 * Boxes are in the coordinates of the mesh, rounded outward to floats. The memory is 28 bytes per
 * unit, and 4 bytes per primitive if the units are groups in space.
 */
#ifndef vtkNBufferUnits_h
#define vtkNBufferUnits_h

#include "Shaders/vtkNBufferShared.h"
#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferUnits
{
public:
  /// The largest number of children of a node.
  static constexpr std::size_t Fanout = NBUFFER_FANOUT;

  /// The primitives of a mesh in the order in which it is drawn.
  struct Mesh
  {
    std::vector<unsigned int> Indices; ///< The points of each primitive.
    std::size_t Corners = 3;           ///< Points of a primitive: 3, 1, or 2 for a box.
    std::vector<glm::dvec3> Points;
    /// Whether each range of neighbours in this order is a draw of its own (vtkNBufferOwnDraw).
    /// Groups in space that would make too many draws are not made then.
    bool IsDrawnInRanges = false;
  };

  /// The primitives from Begin to End - 1.
  struct Range
  {
    std::size_t Begin = 0;
    std::size_t End = 0;
  };

  /// The bounds of a unit or node, which are infinite if a point in it is not finite.
  struct Box
  {
    glm::vec3 Low;
    glm::vec3 High;
  };

  /**
   * Make units of `unitSize` primitives each; the last one may have fewer. Returns no units if an
   * index is out of range. Takes about 0.2 microseconds per primitive.
   */
  static vtkNBufferUnits Make(const Mesh& mesh, std::size_t unitSize);

  /// The number of units.
  std::size_t GetSize() const { return this->Levels.empty() ? 0 : this->Levels[0].size(); }

  /// Whether the units are groups in space, and not runs of the order of drawing.
  bool AreSpatial() const { return !this->Order.empty(); }

  /// The boxes of each level, that of the units first. The last level has one node.
  const std::vector<std::vector<Box>>& GetLevels() const { return this->Levels; }

  ///@{
  /// The units below node n of a level are those from GetBegin() to GetEnd() - 1.
  std::size_t GetBegin(std::size_t level, std::size_t n) const { return n << (3 * level); }
  std::size_t GetEnd(std::size_t level, std::size_t n) const
  {
    const std::size_t end = (n + 1) << (3 * level);
    return end < this->GetSize() ? end : this->GetSize();
  }
  ///@}

  /// Get the ranges of the primitives whose units are marked in `drawn`, in the order of drawing.
  /// Adjacent ranges are merged.
  std::vector<Range> GetRanges(const std::vector<unsigned char>& drawn) const;

  /// Get the parts of ascending ranges that are in `part`, counted from its beginning.
  static std::vector<Range> Clip(const std::vector<Range>& ranges, const Range& part);

  /// Get the bounds of the units that are marked, in a few groups of neighbours, at most 16.
  std::vector<Box> GetGroups(const std::vector<unsigned char>& marked) const;

  /// The number of primitives of a unit; the last unit may have fewer.
  std::size_t GetUnitSize() const { return this->UnitSize; }

  /// Get the unit of each primitive.
  std::vector<std::uint32_t> GetUnitsOfPrimitives() const;

  /// Get the unit of one primitive, or GetSize() if there is no such primitive. If the units are
  /// groups in space, the first call makes a table by GetUnitsOfPrimitives(), which takes 4 bytes
  /// for each primitive.
  std::size_t FindUnit(std::size_t primitive);

private:
  void MakeBoxes(const Mesh& mesh);

  std::size_t UnitSize = 1;
  std::size_t NumberOfPrimitives = 0;
  std::vector<std::uint32_t> UnitOfPrimitive; ///< The table of FindUnit().
  std::vector<unsigned int> Order; ///< The primitives of all units; empty if units are runs.
  std::vector<std::vector<Box>> Levels;
};

static_assert(vtkNBufferUnits::Fanout == 1 << 3, "GetBegin() and GetEnd() shift by 3 bits");

VTK_ABI_NAMESPACE_END
#endif
