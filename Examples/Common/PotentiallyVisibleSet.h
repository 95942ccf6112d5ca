// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class PotentiallyVisibleSet
 * @brief What can be seen from where, computed beforehand and independently of any image.
 */
#ifndef PotentiallyVisibleSet_h
#define PotentiallyVisibleSet_h

#include "vtkNBufferGLM.h"

#include <vector>

namespace NBufferExamples
{

class PotentiallyVisibleSet
{
public:
  virtual ~PotentiallyVisibleSet() = default;

  /// Returns, for every actor in the order of the scene's list, 1 if it may be seen from the eye or
  /// if the set knows nothing about it, else 0. Returns an empty list if the set knows nothing
  /// about this eye.
  virtual std::vector<char> Find(const glm::dvec3& eye) const = 0;

  /// Returns whether the set knows something about an actor, given by its place in the list.
  virtual bool IsKnown(int actor) const = 0;

  /// Returns whether the straight line between two points leads through what the set takes for
  /// opaque. What is seen along such a line is seen through something that is not drawn, and the
  /// set says nothing about it.
  virtual bool IsBlocked(const glm::dvec3& from, const glm::dvec3& to) const = 0;
};

} // namespace NBufferExamples

#endif
