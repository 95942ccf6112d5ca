// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferView
 * @brief One renderer and eye as a culler sees it: the two phases of a frame, and what lasts.
 *
 *     Cull()           caches up to date, frustum test, list = kept props + the proxy
 *       |              kept: visible in the last test, crossing the near plane, not candidates
 *     renderer draws the kept props
 *       |
 *     DrawHeldProps()  rounds: levels of the depth so far, test, draw what may be visible
 *                      then restore the order of equal depths
 *       |              and close the gates of translucent props that are hidden
 *       |              If a pass draws the same list once more (vtkNBufferCompatibility), the same
 *       |              draws again in the same order, without another test.
 *     renderer draws the translucent props whose gates are open
 *
 * Lasting from frame to frame: the caches and which candidates the last test found visible. Depth
 * does not last: every test is against depth of its own frame.
 */
#ifndef vtkNBufferView_h
#define vtkNBufferView_h

#include "vtkNBufferBackOff.h"
#include "vtkNBufferBackend.h"
#include "vtkNBufferCandidateList.h"
#include "vtkNBufferDeferredProxy.h"
#include "vtkNBufferDepthTest.h"
#include "vtkNBufferGates.h"
#include "vtkNBufferLateDraws.h"
#include "vtkNBufferLevels.h"
#include "vtkNBufferProjection.h"
#include "vtkNBufferStatistics.h"
#include "vtkNBufferTuning.h"
#include "vtkNBufferViewKey.h"

#include "vtkNew.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
class vtkOpenGLRenderWindow;
class vtkRenderer;

/**
 * The settings of a culler that a user decides, as they stand at the beginning of a frame;
 * vtkNBufferCuller.h says what they mean.
 */
struct vtkNBufferSettings
{
  vtkNBufferBackend::Kind Backend = vtkNBufferBackend::Auto;
  vtkNBufferSliverPolicy TestSlivers = vtkNBufferSliverPolicy::Never;
  bool Freeze = false;
};

class vtkNBufferView
{
public:
  /// Both are the culler's own and outlive the view.
  vtkNBufferView(vtkNBufferBackend& backend, const vtkNBufferTuning& tuning);
  ~vtkNBufferView();
  vtkNBufferView(const vtkNBufferView&) = delete;
  void operator=(const vtkNBufferView&) = delete;

  /// First phase. Permutes and shortens the list as vtkCuller::Cull may; see there for the rest.
  double Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& initialized,
    const vtkNBufferSettings& settings);

  /// This frame is drawn as without the culler, for the reason given.
  void StepAside(vtkNBufferDecision reason, vtkProp** props, int count);

  /// Count a failure, whose frame is drawn whole; the first of its kind in the window is told.
  void Fail(vtkRenderer* renderer, vtkNBufferDecision failure, const std::string& why);

  /// Second phase, called by the proxy. Returns the number of props drawn.
  int DrawHeldProps(vtkRenderer* renderer, vtkInformation* requiredKeys);

  bool HasHeldPropWithKeys(vtkInformation* requiredKeys) const;

  template <typename Functor>
  void ForEachDrawnHeldProp(Functor&& functor)
  {
    for (const vtkNBufferDrawnProp& drawn : this->Draws.Get())
    {
      functor(this->Props.GetProp(drawn.Index));
    }
  }

  vtkNBufferVerdict GetVerdict(vtkProp* prop) const;
  const vtkNBufferStatistics& GetStatistics() const { return this->Statistics; }
  const vtkNBufferBackend& GetBackend() const { return this->Backend; }

private:
  void SetProjection(const vtkNBufferViewKey& key);
  bool MayReuse(vtkRenderer* renderer) const;
  vtkNBufferDecision Decide(bool blending);
  double Emit(vtkProp** props, int& count, int& initialized);
  void ResetStatistics();

  vtkNBufferDecision PrepareTest(vtkRenderer* renderer, vtkNBufferDepthSource& source);
  void CloseGates(vtkNBufferDepthTest& test);
  void TestKept(vtkNBufferDepthTest& test);
  int DrawRounds(vtkRenderer* renderer, const vtkNBufferDepthSource& source);
  int DrawRound(vtkRenderer* renderer, std::vector<int> props, int round);
  bool MayRepeat(vtkRenderer* renderer, vtkNBufferDepthSource& source);
  int Repeat(vtkRenderer* renderer);
  int DrawAll(vtkRenderer* renderer, vtkInformation* requiredKeys, vtkNBufferDecision reason);

  vtkNBufferBackend& Backend;
  const vtkNBufferTuning& Tuning;
  vtkNBufferBackOff BackOff;
  vtkNBufferCandidateList Props;
  vtkNBufferProjection Projection;
  vtkNBufferLevels Levels;
  vtkNBufferSettings Settings;
  vtkNBufferStatistics Statistics;
  vtkNew<vtkNBufferDeferredProxy> Proxy;
  vtkNBufferLateDraws Draws; ///< Of this frame.
  vtkNBufferGates Gates;     ///< Gate n is that of the n-th of Gated.
  vtkNBufferViewKey LastKey;
  double DepthQuantum = 0x1p-24; ///< Of the framebuffer drawn last, in window depth.
  int TestedBits = 0;            ///< Of the depth of this frame's test.
  int TestedSamples = 0;

  std::vector<int> Kept;  ///< Candidates inside that are let through.
  std::vector<int> Held;  ///< Candidates inside that are held back.
  std::vector<int> Gated; ///< Translucent props inside, behind gates.

  bool Pending = false;   ///< The proxy is in the list and has not been drawn yet.
  bool DrawnOnce = false; ///< The proxy has been drawn in this frame.
  bool Aside = false;     ///< The frame is drawn as usual.
  bool Settled = false;   ///< The verdicts of the last frame are complete.
  bool Improves = false;  ///< The last test found props hidden that had been drawn already.
};

VTK_ABI_NAMESPACE_END
#endif
