// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FlatQueries.h
 * @brief One query for each prop in view, front to back; each answer is awaited before the next
 * query.
 *
 * This is the plainest way that is right in the same frame: when a box gets its query, everything
 * visible that is nearer has been drawn.
 */
#ifndef FlatQueries_h
#define FlatQueries_h

#include "QueryHost.h"

#include <algorithm>
#include <vector>

namespace NBufferPeers
{

struct FlatItem
{
  PlacedBox Box;
  int Prop = 0;
};

/// Sorts `items` front to back. Props outside the view get no query and are not drawn.
inline void DrawByFlatQueries(QueryHost& host, std::vector<FlatItem>& items)
{
  std::stable_sort(items.begin(), items.end(),
    [](const FlatItem& a, const FlatItem& b) { return a.Box.GetNearest() < b.Box.GetNearest(); });
  for (const FlatItem& item : items)
  {
    if (item.Box.Placement == vtkNBufferPlacement::Outside)
    {
      continue;
    }
    const int query = item.Box.Placement == vtkNBufferPlacement::Inside ? host.Query(item.Box) : -1;
    if (query < 0 || host.IsVisible(query))
    {
      host.Draw(item.Prop);
    }
  }
}

} // namespace NBufferPeers

#endif
