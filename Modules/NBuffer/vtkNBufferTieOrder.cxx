// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTieOrder.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferTieOrder
{
bool CanTie(const vtkNBufferProjection& projection, const vtkNBufferDrawnProp& a,
  const vtkNBufferDrawnProp& b)
{
  if (!a.Bounded || !b.Bounded)
  {
    return true;
  }
  const vtkNBufferRectangle& p = a.Screen.Pixels;
  const vtkNBufferRectangle& q = b.Screen.Pixels;
  return p.X0 < q.X1 && q.X0 < p.X1 && p.Y0 < q.Y1 && q.Y0 < p.Y1 &&
    a.Screen.Nearest <= b.Screen.Farthest && b.Screen.Nearest <= a.Screen.Farthest &&
    !projection.AreApart(a.Box, a.Screen, b.Box, b.Screen);
}

std::vector<int> GetRedraws(
  const vtkNBufferProjection& projection, std::vector<vtkNBufferDrawnProp>& drawn)
{
  std::sort(drawn.begin(), drawn.end(),
    [](const vtkNBufferDrawnProp& a, const vtkNBufferDrawnProp& b) { return a.Index < b.Index; });
  // Earlier props that were drawn after the first round, and with which round they count: a prop
  // drawn again comes after all rounds.
  struct Late
  {
    int Position;
    int Round;
  };
  std::vector<Late> late;
  std::vector<int> redraws;
  for (int i = 0; i < static_cast<int>(drawn.size()); ++i)
  {
    const bool again = std::any_of(late.begin(), late.end(),
      [&](const Late& other) {
        return other.Round > drawn[i].Round && CanTie(projection, drawn[other.Position], drawn[i]);
      });
    if (again)
    {
      redraws.push_back(i);
      late.push_back({ i, std::numeric_limits<int>::max() });
    }
    else if (drawn[i].Round > 0)
    {
      late.push_back({ i, drawn[i].Round });
    }
  }
  return redraws;
}
}
VTK_ABI_NAMESPACE_END
