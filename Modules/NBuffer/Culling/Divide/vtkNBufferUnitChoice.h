// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferUnitChoice
 * @brief Which units of a large prop to draw where the last test says little about the view, for
 * example after a cut, or in a cloud that is seen through gaps. No OpenGL.
 *
 * Those that are not behind others in a coarse depth image (vtkNBufferCoarseDepth.h) are chosen.
 * The choice need not be right: every unit that is not chosen is tested.
 */
#ifndef vtkNBufferUnitChoice_h
#define vtkNBufferUnitChoice_h

#include "vtkNBufferEye.h"
#include "vtkNBufferUnits.h"

#include <cstddef>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferUnitChoice
{
public:
  /// Forget the last test.
  void Clear() { *this = {}; }

  /// Remember a test of `tested` units, of which `seen` are visible.
  void SetTested(const vtkNBufferProjection& projection, int tested, int seen);

  /// Whether most of the units that are marked, which the last test found visible, are seen from
  /// another direction now, so that other units hide them.
  bool IsFromElsewhere(const vtkNBufferProjection& projection, const vtkNBufferUnits& units,
    const std::vector<unsigned char>& marked) const;

  /// Whether most of what is in the frustum was not tested, or most of what was visible has left
  /// the frustum. It contains `inside` units; `kept` of these were visible.
  bool IsNew(int inside, int kept) const;

  /// Whether `fresh` units are so many, after `drawn` have been drawn, that most of them are
  /// probably hidden by others of them.
  static bool AreMany(int fresh, int drawn) { return NewView * fresh > drawn; }

  /// Project a unit. Returns false if it is not among those in question or reaches the near plane.
  using Project = std::function<bool(std::size_t unit, vtkNBufferScreenBox& screen)>;

  /// Choose units that probably hide the others in question among `size` units.
  static std::vector<std::size_t> FindOccluders(
    std::size_t size, const vtkNBufferProjection& projection, const Project& project);

private:
  /// A view is new if less than 1/NewView of the units that the last test found visible are in the
  /// frustum, or if the frustum has more than NewView times as many units as that of the last test.
  /// Units are many if they are more than 1/NewView of those that have been drawn.
  static constexpr int NewView = 4;

  int Tested = 0;
  int Seen = 0;
  vtkNBufferEye Eye;
};

VTK_ABI_NAMESPACE_END
#endif
