// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCandidateList.h"

#include "vtkSMPTools.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Props that one thread looks at before another is worth waking.
constexpr vtkIdType PropsPerThread = 2048;

/// How far ahead of its use an object must be asked for to be there in time.
constexpr vtkIdType PropsToFetchAhead = 4;

template <typename Functor>
void ForEachEntry(std::size_t count, Functor&& functor)
{
  const auto size = static_cast<vtkIdType>(count);
  if (size < 2 * PropsPerThread)
  {
    functor(0, size);
    return;
  }
  vtkSMPTools::For(0, size, PropsPerThread, functor);
}
}

bool vtkNBufferCandidateList::Synchronize(vtkProp** props, int count)
{
  const auto size = static_cast<std::size_t>(count);
  std::size_t same = 0;
  while (same < size && same < this->Entries.size() &&
    this->Entries[same].Candidate.GetProp() == props[same])
  {
    ++same;
  }
  if (same == size && size == this->Entries.size())
  {
    return false;
  }
  std::unordered_map<vtkProp*, int> old;
  old.reserve(this->Entries.size() - same);
  for (std::size_t i = same; i < this->Entries.size(); ++i)
  {
    old.emplace(this->Entries[i].Candidate.GetProp(), static_cast<int>(i));
  }
  std::vector<vtkNBufferEntry> rest;
  rest.reserve(size - same);
  for (std::size_t i = same; i < size; ++i)
  {
    const auto found = old.find(props[i]);
    if (found == old.end())
    {
      rest.emplace_back();
      rest.back().Candidate = vtkNBufferCandidate(props[i]);
    }
    else
    {
      rest.push_back(this->Entries[found->second]);
    }
  }
  this->Entries.resize(same);
  this->Entries.insert(this->Entries.end(), rest.begin(), rest.end());
  this->Index.clear();
  return true;
}

int vtkNBufferCandidateList::Refresh()
{
  const vtkNBufferCandidate::GlobalState state = vtkNBufferCandidate::GetGlobalState();
  const bool all = state != this->GlobalState;
  this->GlobalState = state;

  // Asking for times is most of the work and may be shared out; refreshing may run pipelines.
  this->Stale.assign(this->Entries.size(), 0);
  ForEachEntry(this->Entries.size(),
    [this, all](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (i + PropsToFetchAhead < end)
        {
          this->Entries[i + PropsToFetchAhead].Candidate.Prefetch();
        }
        this->Stale[i] = all || this->Entries[i].Candidate.IsStale();
      }
    });
  int changed = 0;
  this->UntrackedDepth = false;
  for (std::size_t i = 0; i < this->Entries.size(); ++i)
  {
    vtkNBufferCandidate& candidate = this->Entries[i].Candidate;
    if (this->Stale[i] && candidate.Refresh())
    {
      ++changed;
    }
    this->UntrackedDepth =
      this->UntrackedDepth || (candidate.WritesDepth() && !candidate.IsTracked());
  }
  return changed;
}

void vtkNBufferCandidateList::Project(const vtkNBufferProjection& projection)
{
  ForEachEntry(this->Entries.size(),
    [this, &projection](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        vtkNBufferEntry& entry = this->Entries[i];
        entry.Verdict = entry.Candidate.GetVerdict();
        if (entry.Candidate.IsCandidate())
        {
          const vtkNBufferBox& box = entry.Candidate.GetBox();
          entry.Placement = projection.IsOutside(box) ? vtkNBufferPlacement::Outside
                                                      : projection.Project(box, entry.Screen);
        }
      }
    });
}

const vtkNBufferEntry* vtkNBufferCandidateList::Find(vtkProp* prop) const
{
  if (this->Index.empty())
  {
    for (std::size_t i = 0; i < this->Entries.size(); ++i)
    {
      this->Index.emplace(this->Entries[i].Candidate.GetProp(), static_cast<int>(i));
    }
  }
  const auto found = this->Index.find(prop);
  return found == this->Index.end() ? nullptr : &this->Entries[found->second];
}
VTK_ABI_NAMESPACE_END
