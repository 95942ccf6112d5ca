// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDivision
 * @brief The large props of one view, which are culled unit by unit (vtkNBufferDividedProp).
 *
 * What it answers at each step of a frame:
 *
 *     Update()     which props are large, and whether they have changed
 *     Classify()   which of them are tested in this frame, and which of their units are drawn first
 *     Draws()      which props have to be drawn by this class
 *     Test()       which of the other units may be seen
 *     Draw()       draws them
 *
 * Of a translucent prop, all units are tested when the depth of the opaque stage is complete
 * (TestTranslucent()).
 *
 * Props are named by their places in the list of candidates.
 */
#ifndef vtkNBufferDivision_h
#define vtkNBufferDivision_h

#include "vtkNBufferCullingPolicy.h"
#include "vtkNBufferDividedProp.h"
#include "vtkNBufferDrawPass.h"
#include "vtkNBufferTieOrder.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferCandidateList;
class vtkOpenGLRenderWindow;
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
  void Update(vtkOpenGLRenderWindow* window, const vtkNBufferSettings& settings);

  /// Set the view of the frame. To be called again if the format of the depth turns out to be
  /// another one.
  void SetView(const vtkNBufferViewSetup& view);

  /// Find the units that are drawn first, and add all units in the frustum to the counts.
  void Classify(const vtkNBufferSettings& settings, vtkNBufferFrustumCounts& counts);

  /// The number of translucent props that are tested unit by unit alone, because they reach the
  /// near plane.
  int CountTranslucentAtNearPlane() const;

  /// Whether any unit is held back while its prop is not.
  bool HoldsUnits() const;

  /// Give the verdict Outside to props that are not held back and have no unit in the frustum.
  void MarkOutside();

  /// Draw all props of this frame whole.
  void Reset();

  /// Whether a prop has to be drawn by Draw(), so that it has a proxy in the renderer's list.
  bool Draws(int place);

  /// An opaque prop with such a proxy is not in the list, because there was no room for it.
  void Postpone(int place) { this->Postponed = place; }

  /// The place of the prop given to Postpone(), or -1.
  int GetPostponed() const { return this->Postponed; }

  /// Test the units of the props that have been drawn and, of those in `heldBack`, remove the
  /// places of props without visible units.
  void Test(const vtkNBufferDividedProp::Depth& depth, std::vector<int>& heldBack);

  /// Test the units of translucent props, except for those that are hidden or, as `hasDrawn` says
  /// of their places, have been drawn. Calls `hide` with the places of those without visible units.
  void TestTranslucent(const vtkNBufferDividedProp::Depth& depth,
    const std::function<bool(int)>& hasDrawn, const std::function<void(int)>& hide);

  /// The places of the props with units that are to be drawn next although the props themselves are
  /// not held back.
  std::vector<int> GetFresh() const;

  /// Add the places of the props that the renderer's list does not draw wholly to `places`, which
  /// are sorted then: those of which units in the view have not been drawn, and the postponed one.
  /// From now on all props are drawn whole.
  void AddMissing(std::vector<int>& places);

  /// If the next draw of a prop draws only a small part of it, find out whether this part has
  /// fragments with the depth of an earlier draw (vtkNBufferTieQuery::HasTies()). If not, the prop
  /// need not be drawn once more. Empty if it was not worth finding out.
  std::optional<bool> HasTies(int place, const std::function<int()>& drawWhole);

  ///@{
  /// Draw what is to be drawn next of a prop, or once more what has been drawn of it, by calling
  /// `drawWhole`. A prop that is not drawn unit by unit is drawn whole.
  int Draw(int place, const std::function<int()>& drawWhole);
  int DrawAgain(int place, const std::function<int()>& drawWhole);
  ///@}

  /// Draw a prop in a call of `drawWhole`.
  int Render(int place, vtkRenderer* renderer);

  /// Whether only some units of a prop are drawn in this frame.
  bool IsDrawnByUnits(int place);

  /// The verdict of a prop or, if it is drawn unit by unit, of the unit to which a part of it
  /// belongs (vtkNBufferDividedProp::GetVerdict()).
  vtkNBufferVerdict GetVerdict(int place, std::optional<int> part);

  /// Describe for vtkNBufferTieOrder what the next Draw() of a prop draws.
  void DescribeNext(int place, int round, const vtkNBufferProjection& projection,
    std::vector<vtkNBufferDrawnProp>& drawn);

  /// Whether any prop has units that are tested in this frame.
  bool HasUnits() const;

  /// Set the statistics of units, after a test: the sums over all props that are drawn unit by
  /// unit.
  void Count(vtkNBufferStatistics& statistics) const;

private:
  struct Entry
  {
    int Place = -1;
    std::unique_ptr<vtkNBufferDividedProp> Prop;
    vtkNBufferProjection Projection; ///< From the coordinates of the mesh.
    vtkNBufferBackOff BackOff;
    bool IsActive = false; ///< It is drawn unit by unit.
    bool IsHeldBack = false;
    bool IsPending = false; ///< Its units are to be tested before the translucent stage.

    /// Whether draws of the prop draw some units, or read it.
    bool IsDrawnHere() const { return this->IsActive || this->Prop->IsReading(); }
  };

  Entry* Find(int place);
  void FindLarge(const std::vector<int>& places);
  vtkNBufferCandidateList& Props;
  vtkSmartPointer<vtkNBufferDrawPass> Pass; ///< That of the window.
  std::vector<Entry> Entries;               ///< In the order of their places.
  int ListNumber = -1;       ///< That of the list of candidates to which the places belong.
  int Minimum = VTK_INT_MAX; ///< The number of cells from which on a prop is large.
  int Postponed = -1;
};

VTK_ABI_NAMESPACE_END
#endif
