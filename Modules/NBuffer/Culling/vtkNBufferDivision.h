// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDivision
 * @brief The large props of one view, which are culled unit by unit (vtkNBufferDividedProp).
 *
 * What its functions find out and do, in the order in which a frame calls them:
 *
 *     Update()     which props are large, and whether they have changed
 *     Classify()   which of them are tested in this frame, and which of their units are drawn first
 *     Draws()      which props have to be drawn by this class
 *     Test()       which of the other units may be seen
 *     Draw()       draws them
 *
 * TestTranslucent() tests all units of a translucent prop when the opaque depth is complete.
 *
 * The place of a prop is its index in the list of candidates.
 */
#ifndef vtkNBufferDivision_h
#define vtkNBufferDivision_h

#include "vtkNBufferCullingPolicy.h"
#include "vtkNBufferDividedProp.h"
#include "vtkNBufferDrawPass.h"
#include "vtkNBufferUnitTrial.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferCandidateList;
class vtkNBufferPartition;
class vtkRenderer;
struct vtkNBufferSettings;
struct vtkNBufferStatistics;
struct vtkNBufferViewSetup;

class vtkNBufferDivision
{
public:
  /// The candidates are kept by reference and must outlive this object.
  explicit vtkNBufferDivision(vtkNBufferCandidateList& props)
    : Props(props)
  {
  }

  /// Begin a frame, after the candidates have been brought up to date.
  void Update(vtkRenderer* renderer, const vtkNBufferSettings& settings);

  /// Set the view of the frame. To be called again if the framebuffer turns out to have another
  /// depth format.
  void SetView(const vtkNBufferViewSetup& view);

  /// Decide whether units are drawn in this frame, find those that are drawn first, and add all
  /// units in the frustum to the counts. Opaque props from `firstBlended` on
  /// (vtkNBufferListTraits::GetFirstBlended()) are drawn whole. Returns false if all props are
  /// drawn whole because of vtkNBufferUnitTrial.
  bool Classify(vtkRenderer* renderer, const vtkNBufferSettings& settings, int firstBlended,
    vtkNBufferFrustumCounts& counts);

  /// The number of translucent props of which the units are tested, but not the whole box, because
  /// it reaches the near plane or there is none.
  int CountTranslucentByUnits() const;

  /// Whether any unit is held back while its prop is not.
  bool HoldsUnits() const;

  /// How many units of opaque props the levels hide.
  int CountHidden(const vtkNBufferDividedProp::Depth& depth) const;

  /// Call SetOutside() for props that have no unit in the frustum.
  void MarkOutside(vtkNBufferPartition& partition);

  /// Let all props be drawn whole in this frame.
  void Reset();

  /// Whether a prop has to be drawn by Draw(), so that it has a proxy in the renderer's list.
  bool Draws(int place);

  /// Record that an opaque prop that Draw() has to draw is not in the renderer's list, because the
  /// list had no room for its proxy.
  void Postpone(int place) { this->Postponed = place; }

  /// The place of the prop given to Postpone(), or -1.
  int GetPostponed() const { return this->Postponed; }

  /// Whether the last tests found units hidden that had been drawn.
  bool HasKeptInVain() const;

  /// Test the units of the props that have been drawn, and of those in `heldBack`. Removes props
  /// without visible units from `heldBack`. Returns whether all visible units of the props that
  /// have been drawn are fresh now; those of a prop may be left to the next test if they are more
  /// than `limit`.
  bool Test(const vtkNBufferDividedProp::Depth& depth, std::vector<int>& heldBack, int limit);

  /// Test the units of the translucent props that are not hidden as a whole and for which
  /// `hasDrawn(place)` is false. Calls `hide(place)` for those without visible units.
  void TestTranslucent(const vtkNBufferDividedProp::Depth& depth,
    const std::function<bool(int)>& hasDrawn, const std::function<void(int)>& hide);

  /// Let all units that have not been drawn be tested again, by a depth that is farther than the
  /// one before.
  void TestAgain();

  /// The places of the props that have been drawn and have fresh units, which are drawn next.
  std::vector<int> GetFresh() const;

  /// Add to `places` the opaque props that have been drawn, but without some of their units in the
  /// view, and the postponed prop; then sort `places`. From now on all props are drawn whole.
  void AddMissing(std::vector<int>& places);

  /// Draw what is to be drawn next of a prop by calling `drawWhole`: the whole prop if it is not
  /// drawn unit by unit. Returns the number of props drawn.
  int Draw(int place, const std::function<int()>& drawWhole);

  /// The prop at a place if it is drawn unit by unit in this frame, otherwise nullptr.
  vtkNBufferDividedProp* FindActive(int place);

  /// The verdict of a prop or, if it is drawn unit by unit, of the unit to which a part of it
  /// belongs (vtkNBufferDividedProp::GetVerdict()).
  vtkNBufferVerdict GetVerdict(int place, std::optional<int> part);

  /// The number of levels that it takes to test units: the boxes of groups of units may cover much
  /// of the viewport. It is 1 if no units are tested in this frame.
  int GetLevelsNeeded(int factor) const;

  /// Set the statistics of units to the sums over all props that are drawn unit by unit.
  void Count(vtkNBufferStatistics& statistics) const;

private:
  struct Entry
  {
    int Place = -1;
    std::unique_ptr<vtkNBufferDividedProp> Prop;
    vtkNBufferProjection Projection; ///< From the coordinates of the mesh.
    vtkNBufferBackOff BackOff;
    bool IsActive = false;   ///< It is drawn unit by unit.
    bool IsHeldBack = false; ///< The renderer does not draw it before the test.
    bool IsPending = false;  ///< Its units are to be tested before the translucent stage.

    /// Whether Draw() draws only some units of the prop, or reads what VTK draws of it.
    bool IsDrawnHere() const { return this->IsActive || this->Prop->IsReading(); }
  };

  Entry* Find(int place);
  void FindLarge(const std::vector<int>& places);
  vtkNBufferCandidateList& Props;
  vtkSmartPointer<vtkNBufferDrawPass> Pass; ///< The pass of the window.
  vtkNBufferUnitTrial Trial;
  vtkNBufferUnitDevice Device;
  std::vector<Entry> Entries; ///< In the order of their places.
  int ListNumber = -1;        ///< vtkNBufferCandidateList::GetListNumber() of the places.
  int Minimum = VTK_INT_MAX;  ///< A prop with at least this many cells is large.
  int Postponed = -1;
};

VTK_ABI_NAMESPACE_END
#endif
