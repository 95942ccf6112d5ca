// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferExchangePlan
 * @brief How many exchanges of depth the ranks of a parallel program have in a frame. No MPI, no
 * OpenGL, no renderer.
 *
 * An exchange is collective: if one rank waits for it and another one does not join, the program
 * hangs. So every rank has a plan, and all plans must come to the same number. They do without a
 * further message, because they depend only on what all ranks have in common, which is the view and
 * the replies to earlier exchanges:
 *
 *  - A frame has one exchange.
 *  - It has two if a rank reports a view of which it knows nothing, as after a cut of the camera.
 *    The first exchange then gives the depth of the few props that were drawn as a guess.
 *  - It has none from the fourth frame of the same view on, unless props change somewhere. (The
 *    frames before that find out what was drawn in vain.) Every 16th such frame has an exchange all
 *    the same, because only an exchange shows whether props have begun to change.
 *  - It has none while the ranks back off together. Every fourth exchange is a trial: each rank
 *    tests with its own depth, too, and reports in the next exchange how many more props the depth
 *    of all has hidden. Where that is next to nothing, vtkNBufferBackOff decides how long to pause.
 */
#ifndef vtkNBufferExchangePlan_h
#define vtkNBufferExchangePlan_h

#include "vtkNBufferCullingPolicy.h"
#include "vtkNBufferExchangeMessage.h"
#include "vtkNBufferModule.h" // For export macro

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferExchangePlan
{
public:
  ///@{
  /// The frames of the same view before exchanges stop; how often there is one after that; how many
  /// exchanges there are to a trial.
  static constexpr int FramesToSettle = 3;
  static constexpr int FramesToProbe = 16;
  static constexpr int ExchangesPerTrial = 4;
  ///@}
  /// A frame has a second exchange if a rank holds back more new props than this. Fewer are drawn
  /// after the first one, however many of them are hidden.
  static constexpr int FewNewProps = 256;

  /// Begin a frame. `view` is whatever numbers the ranks have in common that describe the view.
  /// With `mayBackOff` false the ranks never back off, and there are no trials. Both must be the
  /// same on all ranks.
  void BeginFrame(const std::vector<double>& view, bool mayBackOff);

  /// The number of exchanges of this frame. Only Learn() may make it larger.
  int GetNumberOfExchanges() const { return this->Planned; }

  /// Whether the first exchange of this frame is a trial.
  bool IsTrial() const { return this->MayBackOff && this->SinceTrial == 0; }

  /// Learn from the reply to an exchange; `number` counts those of the frame and begins with 0.
  void Learn(const vtkNBufferRankReply& reply, int number);

private:
  vtkNBufferBackOff BackOff;
  std::vector<double> View;
  int Planned = 0;
  int StillFrames = 0; ///< The frames before this one with the same view.
  int SinceTrial = 0;  ///< The exchanges since the last trial; 0 if the next one is a trial.
  bool MayBackOff = true;
  bool HadTrial = false; ///< Whether the next reply has the gain of a trial.
  bool Changed = false;  ///< Whether props of any rank had changed at the last exchange.
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferExchangePlan.h
