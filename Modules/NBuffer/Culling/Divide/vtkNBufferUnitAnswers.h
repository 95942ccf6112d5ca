// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferUnitAnswers
 * @brief What a graphics device has found out about the units of a large prop and the nodes above
 * them (vtkNBufferUnits). No OpenGL.
 */
#ifndef vtkNBufferUnitAnswers_h
#define vtkNBufferUnitAnswers_h

#include "Shaders/vtkNBufferShared.h"
#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

struct vtkNBufferUnitAnswers
{
  enum Answer : std::uint32_t
  {
    /// The device cannot tell, or has not tried because a node above is Hidden or Outside.
    None = NBUFFER_ANSWER_NONE,
    Outside = NBUFFER_ANSWER_OUTSIDE, ///< Nothing of the node can be drawn.
    Hidden = NBUFFER_ANSWER_HIDDEN,   ///< The levels hide it.
    Visible = NBUFFER_ANSWER_VISIBLE  ///< It is in the view, and the levels do not hide it.
  };

  /// The highest level that has answers, the first one that is tested. Its nodes have 512 units.
  static constexpr std::size_t HighestLevel = 3;

  /// The answer for node n of a level.
  Answer Get(std::size_t level, std::size_t n) const
  {
    const std::size_t bit = NBUFFER_ANSWER_BITS * (this->FirstOfLevel[level] + n);
    return static_cast<Answer>(this->Words[bit / 32] >> (bit % 32) & NBUFFER_ANSWER_MASK);
  }

  std::vector<std::size_t> FirstOfLevel; ///< The place of each level's first node among all nodes.
  std::vector<std::uint32_t> Words;      ///< NBUFFER_ANSWER_BITS bits for each node.
};

VTK_ABI_NAMESPACE_END
#endif
