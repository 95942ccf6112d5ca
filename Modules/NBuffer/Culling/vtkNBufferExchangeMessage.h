// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferExchangeMessage.h
 * @brief What the ranks of a parallel program exchange in a frame: an array of floats of which
 * every rank gets the minima. No MPI, no OpenGL, no renderer.
 *
 * The array begins with level 0 of the rank's own depth: the farthest depth of each tile. The
 * minimum over the ranks is never nearer than the farthest depth of the tile in the composited
 * image, because in each pixel p of a tile
 *
 *     composited depth(p) = min over r of depth_r(p) <= min over r of (max over q of depth_r(q)).
 *
 * A prop behind that value is hidden in the image. (The minimum of the nearest depths of the tile
 * would be wrong: a single near pixel would hide what is seen beside it.)
 *
 * The reports of the ranks follow. They are written so that the minima carry them, too:
 *
 *  - If the maximum of a number x is wanted, the message has -x.
 *  - Of each number x of the view it has x and -x: their minima show whether all ranks sent the
 *    same.
 *  - If the sum of a number x is wanted, it has one float for each rank: -x for the rank that sends
 *    it, and 0 for the others.
 */
#ifndef vtkNBufferExchangeMessage_h
#define vtkNBufferExchangeMessage_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <array>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// What a rank tells the others in addition to its depth.
struct vtkNBufferRankReport
{
  std::array<float, 20> View{}; ///< The matrix from world to clip coordinates, and the viewport.
  double Step = 0.0;            ///< The step of the rank's depth buffer, in window depth.
  bool Changed = false;         ///< Whether what the rank draws may have changed since the last
                                ///< frame.
  bool Misfit = false;          ///< Whether the rank's layout is not the one that this message has.
  int NewProps = 0;   ///< The props held back if the view is new (vtkNBufferPartition::IsNew()).
  int Candidates = 0; ///< The candidates in the frustum; like all counts, less than 2^24.
  int Unhidden = 0;   ///< The candidates that the rank's own depth did not hide in the last trial.
  int Gain = 0;       ///< How many of these the depth of all ranks hid in that trial.
};

/// What all ranks have reported. Each rank gets the same.
struct vtkNBufferRankReply
{
  bool SameView = false; ///< Whether all ranks have the same view.
  double Step = 0.0;     ///< The largest step.
  bool Changed = false;  ///< Whether what any of the ranks draws may have changed.
  bool Misfit = false;   ///< Whether at least one rank reports a Misfit.
  int NewProps = 0;      ///< The largest number of any rank.
  int Candidates = 0;    ///< The sum over all ranks.
  int Unhidden = 0;      ///< The sum over all ranks.
  int Gain = 0;          ///< The sum over all ranks.
};

class VTKNBUFFER_EXPORT vtkNBufferExchangeMessage
{
public:
  /// The message of rank `rank` of `ranks`, with room for a level 0 of `texels` texels, all of them
  /// at the far plane.
  vtkNBufferExchangeMessage(std::size_t texels, int ranks, int rank);

  /// Level 0 of the rank's own depth, to be filled in.
  float* GetTexels() { return this->Values.data(); }

  void SetReport(const vtkNBufferRankReport& report);

  /// The reports of all ranks, from the minima of their messages.
  vtkNBufferRankReply GetReply(const std::vector<float>& minima) const;

  const std::vector<float>& GetValues() const { return this->Values; }

private:
  std::size_t Texels;
  int Ranks;
  int Rank;
  std::vector<float> Values;
};

VTK_ABI_NAMESPACE_END
#endif
