// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FlatQueries.h
 * @brief One query for each prop in view, front to back, each waited for before the next.
 *
 * The plainest way that is right in the same frame: when a box is queried, everything nearer that
 * is visible has been drawn.
 */
#ifndef FlatQueries_h
#define FlatQueries_h

#include "QueryHost.h"

#include <vector>

namespace NBufferPeers
{

struct FlatItem
{
  PlacedBox Box;
  int Prop = 0;
};

/// Sorts `items` front to back. Props outside are neither queried nor drawn.
void DrawByFlatQueries(QueryHost& host, std::vector<FlatItem>& items);

} // namespace NBufferPeers

#endif
