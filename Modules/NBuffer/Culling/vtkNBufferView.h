// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferView
 * @brief One renderer and one eye as the culler sees them: what happens in a frame, and what is
 * kept from frame to frame.
 *
 *     Cull()            updates the cached boxes and tests them against the frustum;
 *       |               decides whether this frame is tested (vtkNBufferCullingPolicy) and which
 *       |               props are held back (vtkNBufferPartition);
 *       |               replaces the props that are held back by a proxy (vtkNBufferListMaker)
 *     the renderer draws its list, and the proxy in it
 *       |
 *     DrawHeldProps()   builds the levels of this frame's depth, tests the boxes of all candidates
 *       |               and draws the props held back that may be visible, in rounds;
 *       |               repairs what drawing late breaks (Late/README.md)
 *     the renderer draws the translucent props that were not found hidden
 *
 * The phase of a view says how far its frame has come:
 *
 *     StepAside() ---> Aside
 *     Cull() -+------> Untested        all candidates in the frustum are drawn
 *             +------> Reused          the verdicts of the last test are still valid
 *             +------> AwaitingProxy
 *                        | DrawHeldProps()
 *                        +---> Tested       DrawHeldProps() again -----+-> Tested, the same draws
 *                        |                                             |
 *                        +---> Incomplete  <---------------------------+
 *
 * The cached boxes, and which candidates the last test found visible, are kept from frame to frame.
 * Depth is not: every test uses the depth of its own frame.
 */
#ifndef vtkNBufferView_h
#define vtkNBufferView_h

#include "vtkNBufferBackend.h"
#include "vtkNBufferCandidateList.h"
#include "vtkNBufferCompatibility.h"
#include "vtkNBufferDeferredProxy.h"
#include "vtkNBufferDepthTest.h"
#include "vtkNBufferDivision.h"
#include "vtkNBufferLateDraws.h"
#include "vtkNBufferLevels.h"
#include "vtkNBufferListMaker.h"
#include "vtkNBufferPartition.h"
#include "vtkNBufferProjection.h"
#include "vtkNBufferStatistics.h"
#include "vtkNBufferStillness.h"
#include "vtkNBufferViewSetup.h"

#include "vtkNew.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
class vtkRenderer;

class vtkNBufferView : private vtkNBufferDeferredProxy::Owner
{
public:
  /// The views of a window share a back-end.
  explicit vtkNBufferView(std::shared_ptr<vtkNBufferBackend> backend);
  ~vtkNBufferView();
  vtkNBufferView(const vtkNBufferView&) = delete;
  void operator=(const vtkNBufferView&) = delete;

  /// Begin a frame: replace the renderer's list in place, as vtkCuller::Cull() does. Returns the
  /// sum of the render time multipliers, as that function does.
  double Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& initialized,
    const vtkNBufferSettings& settings);

  /// Begin a frame that is drawn as it would be without the culler, because of `reason`.
  void StepAside(vtkNBufferDecision reason, vtkProp** props, int count);

  /// Count a frame that draws everything because of `failure`. Warns with the text `why` if it is
  /// the first failure of its kind in the window.
  void Fail(vtkRenderer* renderer, vtkNBufferDecision failure, const std::string& why);

  /// See the functions of vtkNBufferCuller with the same names.
  vtkNBufferVerdict GetVerdict(vtkProp* prop, std::optional<int> part);
  bool GetVisiblePixels(vtkProp* prop, vtkNBufferRectangle& pixels);
  const vtkNBufferStatistics& GetStatistics() const { return this->Statistics; }
  const std::shared_ptr<vtkNBufferBackend>& GetBackend() const { return this->Backend; }

private:
  enum class Phase
  {
    Aside,         ///< The list is as the renderer made it; candidates were not looked for.
    Untested,      ///< Only the candidates outside the frustum were removed from the list.
    Reused,        ///< The verdicts are those of an earlier test, and they are complete.
    AwaitingProxy, ///< The proxy is in the list and has not been drawn yet.
    Tested,        ///< The proxy has been drawn; the verdicts are complete.
    Incomplete     ///< The proxy has been drawn; the next frame must not reuse the verdicts.
  };

  ///@{
  /// See vtkNBufferDeferredProxy::Owner.
  int DrawHeldProps(vtkRenderer* renderer, vtkInformation* requiredKeys) override;
  bool HasHeldPropWithKeys(vtkInformation* requiredKeys) const override;
  ///@}

  ///@{
  /// The parts of Cull().
  void Classify(vtkRenderer* renderer);
  vtkNBufferDecision Divide(vtkRenderer* renderer);
  void ResetStatistics();
  ///@}

  ///@{
  /// The parts of DrawHeldProps().
  vtkNBufferDecision PrepareTest(vtkRenderer* renderer, vtkNBufferDepthSource& source);
  int TestAndDraw(vtkRenderer* renderer);
  bool DrawRounds(vtkRenderer* renderer, vtkNBufferDepthTest& test, int& drawn);
  int DrawRound(vtkRenderer* renderer, std::vector<int> props, int round);
  /// PrepareTest() for a pass that draws its list a second time in this frame. Returns whether the
  /// draws of the first time can be repeated.
  bool PrepareRepeat(vtkRenderer* renderer);
  int Repeat(vtkRenderer* renderer);
  int DrawAll(vtkRenderer* renderer, vtkInformation* requiredKeys, vtkNBufferDecision reason);
  ///@}

  std::shared_ptr<vtkNBufferBackend> Backend;
  vtkNBufferBackOff BackOffs[2]; ///< For frames in which all props are drawn whole, and for others.
  vtkNBufferBackOff* BackOff = nullptr;
  vtkNBufferProjection Projection;
  vtkNBufferCandidateList Props;
  vtkNBufferPartition Partition;
  vtkNBufferDivision Division;
  vtkNBufferLevels Levels;
  vtkNBufferSettings Settings{};
  vtkNBufferStatistics Statistics;
  Phase State = Phase::Aside;
  vtkNBufferStillness Stillness;

  vtkNew<vtkNBufferDeferredProxy> Proxy;
  vtkNBufferLateDraws Draws;
  vtkNBufferListMaker List;
  vtkNBufferViewSetup Setup;
  vtkNBufferDepthSource Tested; ///< The depth that was tested last.
  int HiddenButDrawn = 0; ///< The props that this frame's tests found hidden after they were drawn.
  /// Whether some of what the last frame has drawn is hidden, or may be hidden by what it has drawn
  /// last. Another test in the same view then saves drawing it again.
  bool DrawsInVain = false;
};

VTK_ABI_NAMESPACE_END
#endif
