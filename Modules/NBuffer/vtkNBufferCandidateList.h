// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCandidateList
 * @brief The props of one view in the renderer's order, cached from frame to frame.
 *
 * Renderers hand over the same props in the same order in most frames, so that the list is
 * compared with the one before pointer by pointer, and only a difference costs look-ups. A prop
 * made at the address of a deleted one is told by its newer modification time.
 */
#ifndef vtkNBufferCandidateList_h
#define vtkNBufferCandidateList_h

#include "vtkNBufferCandidate.h"
#include "vtkNBufferProjection.h"

#include <unordered_map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/**
 * A prop and what is known of it in its view.
 */
struct vtkNBufferEntry
{
  vtkNBufferCandidate Candidate;
  vtkNBufferScreenBox Screen;
  vtkNBufferPlacement Placement = vtkNBufferPlacement::Crossing;
  vtkNBufferVerdict Verdict = vtkNBufferVerdict::Unknown; ///< Of this frame.
  bool WasVisible = false;                                ///< Found visible by the last test.
};

class vtkNBufferCandidateList
{
public:
  /// Take over a renderer's list. Returns whether it differs from the last one.
  bool Synchronize(vtkProp** props, int count);

  /// Bring the caches up to date. Returns how many props changed.
  int Refresh();

  /// Place every candidate with respect to the view: outside, crossing, or inside with its
  /// rectangle and depth interval.
  void Project(const vtkNBufferProjection& projection);

  /// Whether the depth that any of the props writes may change without a trace.
  bool HasUntrackedDepth() const { return this->UntrackedDepth; }

  std::vector<vtkNBufferEntry>& GetEntries() { return this->Entries; }
  const std::vector<vtkNBufferEntry>& GetEntries() const { return this->Entries; }

  /// The entry of a prop, or nullptr. One hash look-up, the first one after a change of the list
  /// fills the table.
  const vtkNBufferEntry* Find(vtkProp* prop) const;

private:
  std::vector<vtkNBufferEntry> Entries;
  std::vector<int> Stale;
  mutable std::unordered_map<vtkProp*, int> Index;
  vtkNBufferCandidate::GlobalState GlobalState{};
  bool UntrackedDepth = false;
};

VTK_ABI_NAMESPACE_END
#endif
