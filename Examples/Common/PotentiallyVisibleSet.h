// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class PotentiallyVisibleSet
 * @brief What may be seen from where, worked out beforehand and independently of any image.
 */
#ifndef PotentiallyVisibleSet_h
#define PotentiallyVisibleSet_h

#include <vector>

namespace NBufferExamples
{

/// Of a scene's actors, by their places in its list.
class PotentiallyVisibleSet
{
public:
  virtual ~PotentiallyVisibleSet() = default;

  /// 1 for every actor that may be seen from the eye, and for those that it knows nothing about
  /// (see IsKnown); empty if it knows nothing about this eye.
  virtual std::vector<char> Find(const double eye[3]) const = 0;

  virtual bool IsKnown(int actor) const = 0;

  /// Whether the straight way leads through what the set takes for opaque. What is seen all the
  /// same is seen through something that is not drawn, and the set says nothing about it.
  virtual bool IsBlocked(const double from[3], const double to[3]) const = 0;
};

} // namespace NBufferExamples

#endif
