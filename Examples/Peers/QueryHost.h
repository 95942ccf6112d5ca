// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class QueryHost
 * @brief What an algorithm of occlusion queries needs of a frame; no OpenGL.
 */
#ifndef QueryHost_h
#define QueryHost_h

#include "vtkNBufferProjection.h"

namespace NBufferPeers
{

/// A box with its place in the view.
struct PlacedBox
{
  vtkNBufferBox Box;
  vtkNBufferScreenBox Screen; ///< If Inside.
  vtkNBufferPlacement Placement = vtkNBufferPlacement::Outside;

  /// For front to back: what reaches the eye comes first.
  double GetNearest() const
  {
    return this->Placement == vtkNBufferPlacement::Inside ? this->Screen.Nearest : -1e300;
  }
};

class QueryHost
{
public:
  virtual ~QueryHost() = default;

  /// Where a box is in this frame's view.
  virtual PlacedBox Place(const vtkNBufferBox& box) = 0;

  /// Start a query whether a sample of a box would pass the depth test now. The query's number, or
  /// -1 if the box cannot be queried: then it counts as visible.
  virtual int Ask(const PlacedBox& box) = 0;

  /// Whether the answer is there; never waits.
  virtual bool HasAnswer(int query) = 0;

  /// The answer; waits for it.
  virtual bool IsVisible(int query) = 0;

  /// Draw a prop now. Called once for a prop at most.
  virtual void Draw(int prop) = 0;
};

} // namespace NBufferPeers

#endif
