// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferExchangePlan
 * @brief How many exchanges of depth the ranks of a parallel program have in a frame. No MPI, no
 * OpenGL, no renderer.
 *
 * An exchange is collective: if one rank waits for it and another one does not join, the program
 * hangs. So every rank has a plan, and all plans must come to the same number. Therefore a plan
 * depends on nothing but the replies to earlier messages, which are the same on all ranks:
 *
 *  - A frame has one exchange.
 *  - It has two if a rank reports more than 256 props in a view of which it knows nothing, as after
 *    a cut of the camera.
 *    The first exchange then gives the depth of the few props that were drawn as a guess.
 *  - After an exchange in which no rank has reported a change, each frame begins with a poll: a
 *    message of one float, by which the ranks find out whether anything has changed since. If not,
 *    the frame has no exchange, and all ranks use their verdicts once more.
 *  - A frame has neither an exchange nor a poll while the ranks back off together. Every fourth
 *    exchange is a trial: each rank tests with its own depth, too, and reports in the next exchange
 *    how many of the props that its own depth does not hide the depth of all ranks has hidden.
 *    Where that is next to nothing, vtkNBufferBackOff decides how long to pause. A trial in a new
 *    view that finds little does not count, because the first exchange of such a frame has little
 *    depth. After two trials in a row that find enough, 16 exchanges have none.
 *
 * A frame in which nothing moves needs the poll, unless it draws what only other ranks hide. Proof:
 * Let a prop of rank B be hidden by nothing but a wall of rank A. Compare a frame before which
 * nothing changes with a frame before which A removes the wall. If no message of A, sent directly
 * or through others, reaches B between the change and B's own draw, then B has received the same in
 * both cases, and does the same. In the second case it has to draw the prop, and so it does in
 * both. Any rank may be A or B, so that each rank has to hear from each other rank in every frame.
 * The cheapest way is the smallest all-reduce.
 */
#ifndef vtkNBufferExchangePlan_h
#define vtkNBufferExchangePlan_h

#include "vtkNBufferCullingPolicy.h"
#include "vtkNBufferExchangeMessage.h"
#include "vtkNBufferModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferExchangePlan
{
public:
  /// One in this many exchanges is a trial.
  static constexpr int ExchangesPerTrial = 4;
  /// The exchanges without a trial after two trials in a row that have found enough.
  static constexpr int ExchangesAfterGain = 16;
  /// A frame has a second exchange if a rank holds back more props than this of a new view. With
  /// fewer, those that only the second exchange could hide are drawn.
  static constexpr int FewNewProps = 256;

  /// Begin a frame. With `mayBackOff` false, which must be the same on all ranks, the ranks never
  /// back off, and there are no trials.
  void BeginFrame(bool mayBackOff);

  /// Whether the number of exchanges depends on a poll that is still to come.
  bool HasPoll() const { return this->Planned > 0 && this->IsQuiet; }

  /// The number of exchanges of this frame; a poll may reduce it to 0, and only Learn() may make it
  /// larger.
  int GetNumberOfExchanges() const { return this->Planned; }

  /// Whether the first exchange of this frame is a trial.
  bool IsTrial() const { return this->MayBackOff && this->UntilTrial == 0; }

  /// Learn from the poll whether any rank has changed.
  void LearnPoll(bool changed);

  /// Learn from the reply to an exchange; `number` is its number in the frame, from 0 on.
  void Learn(const vtkNBufferRankReply& reply, int number);

private:
  vtkNBufferBackOff BackOff;
  int Planned = 0;
  int UntilTrial = 0; ///< The exchanges before the next trial.
  int Gains = 0;      ///< The trials in a row that have found enough.
  bool MayBackOff = true;
  bool HadTrial = false; ///< Whether the next reply has the gain of a trial,
  bool WasNew = false;   ///< and whether that trial was in a new view.
  bool IsQuiet = false;  ///< Whether nothing had changed at the last exchange.
};

VTK_ABI_NAMESPACE_END
#endif
