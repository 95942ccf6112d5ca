// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class QueryHost
 * @brief The interface of a frame for algorithms of occlusion queries. No OpenGL.
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
  vtkNBufferScreenBox Screen; ///< Valid if the placement is Inside.
  vtkNBufferPlacement Placement = vtkNBufferPlacement::Outside;

  /// Returns the key of the order from front to back. Boxes that reach the eye come first.
  double GetNearest() const
  {
    return this->Placement == vtkNBufferPlacement::Inside ? this->Screen.Nearest : -1e300;
  }
};

class QueryHost
{
public:
  virtual ~QueryHost() = default;

  /// Returns the place of a box in the view of this frame.
  virtual PlacedBox Place(const vtkNBufferBox& box) = 0;

  /// Begins a query: would a sample of the box pass the depth test now? Returns the number of the
  /// query, or -1 if the box cannot have a query; it counts as visible then.
  virtual int Query(const PlacedBox& box) = 0;

  /// Returns whether the answer has arrived. Never waits.
  virtual bool HasAnswer(int query) = 0;

  /// Waits for the answer, and returns it.
  virtual bool IsVisible(int query) = 0;

  /// Draws a prop now. Is called at most once for each prop.
  virtual void Draw(int prop) = 0;
};

} // namespace NBufferPeers

#endif
