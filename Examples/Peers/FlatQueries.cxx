// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlatQueries.h"

#include <algorithm>

namespace NBufferPeers
{

void DrawByFlatQueries(QueryHost& host, std::vector<FlatItem>& items)
{
  std::stable_sort(items.begin(), items.end(),
    [](const FlatItem& a, const FlatItem& b) { return a.Box.GetNearest() < b.Box.GetNearest(); });
  for (const FlatItem& item : items)
  {
    if (item.Box.Placement == vtkNBufferPlacement::Outside)
    {
      continue;
    }
    const int query = item.Box.Placement == vtkNBufferPlacement::Inside ? host.Ask(item.Box) : -1;
    if (query < 0 || host.IsVisible(query))
    {
      host.Draw(item.Prop);
    }
  }
}

} // namespace NBufferPeers
