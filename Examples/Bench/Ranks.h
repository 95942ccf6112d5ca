// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ranks.h
 * @brief A parallel program of many ranks, simulated in one process: how many props its cullers
 * draw with and without the exchange of depth.
 */
#ifndef Ranks_h
#define Ranks_h

#include "Session.h"

#include <vector>

namespace NBufferBench
{

/// Counts of props, or of units if the props of each rank are merged to one mesh.
struct RankCounts
{
  int Local = 0;         ///< Drawn by all ranks, each of which culls by its own depth.
  int Shared = 0;        ///< Drawn by all ranks, which cull by the depth of all.
  int Busiest = 0;       ///< The most that one rank draws, with shared depth.
  int Idle = 0;          ///< The ranks that draw nothing, with shared depth.
  long long Bytes = 0;   ///< What a rank sends in an exchange.
  int VisibleHidden = 0; ///< Props that own a pixel, but were found hidden: must be 0. A merged
                         ///< mesh counts if one of its parts owns a pixel.
};

/**
 * Draws a pose with the props of each of `count` ranks, one rank after the other, again and again,
 * until the counts of a camera that stands still are reached. In each round a rank gets the depth
 * that the others have drawn in the round before. `rankOf`: the rank of each prop. `owners`: the
 * props that own a pixel, by their places in the list. `tileSize`: as
 * vtkNBufferDepthExchange::SetTileSize(). `mask`: send a CoverageMask instead of tiles; the number
 * of bytes is then that of tiles of one pixel. `merge`: the props of a rank are one mesh, which its
 * culler divides, however small it is.
 */
RankCounts SimulateRanks(Session& session, const NBufferExamples::CameraPose& pose, int count,
  const std::vector<int>& rankOf, const std::vector<int>& owners, int tileSize, bool mask,
  bool merge);

} // namespace NBufferBench

#endif
