// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferFirstDraws.h"

#include "vtkNBufferCandidate.h"
#include "vtkNBufferProtectedMembers.h"

#include "vtkProp.h"

#include <cstddef>
#include <unordered_map>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
struct ActorsOfMapper
{
  bool IsAnyDrawn = false;
  int NumberOfUndrawn = 0;
};

bool HasDrawn(const vtkProp* prop)
{
  return vtkNBufferProtectedMembers::GetShaderProperty(prop);
}

const void* GetMapper(const vtkNBufferCandidate& candidate)
{
  return candidate.GetUses()[vtkNBufferSharedState::Shaders].Object;
}
}

void vtkNBufferFirstDraws::Find(const std::vector<vtkNBufferCandidate>& candidates,
  const std::unordered_set<const vtkMapper*>& mappersOfParts, std::vector<vtkNBufferState>& states)
{
  std::unordered_map<const void*, ActorsOfMapper> mappers;
  std::vector<std::size_t> undrawn;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    states[i].FirstDrawIsDue = false;
    if (GetMapper(candidates[i]) && !HasDrawn(candidates[i].GetProp()))
    {
      undrawn.push_back(i);
      ++mappers[GetMapper(candidates[i])].NumberOfUndrawn;
    }
  }
  if (undrawn.empty())
  {
    return;
  }
  for (const vtkMapper* mapper : mappersOfParts)
  {
    mappers[mapper].IsAnyDrawn = true;
  }
  for (const vtkNBufferCandidate& candidate : candidates)
  {
    const auto found = mappers.find(GetMapper(candidate));
    if (found != mappers.end() && HasDrawn(candidate.GetProp()))
    {
      found->second.IsAnyDrawn = true;
    }
  }
  for (const std::size_t i : undrawn)
  {
    const ActorsOfMapper& actors = mappers[GetMapper(candidates[i])];
    states[i].FirstDrawIsDue = actors.IsAnyDrawn;
    // Actors that use the mapper in several ways are drawn anyway, and the times of their shader
    // properties decide by whose shaders.
    if (!actors.IsAnyDrawn && actors.NumberOfUndrawn > 1 && !candidates[i].GetSharesState())
    {
      candidates[i].GetProp()->GetShaderProperty();
    }
  }
}

bool vtkNBufferFirstDraws::IsDue(const vtkNBufferState& state, const vtkProp* prop)
{
  return state.FirstDrawIsDue && !HasDrawn(prop);
}
VTK_ABI_NAMESPACE_END
