// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Checker.h
 * @brief Plays a scenario with and without the culler and compares every frame.
 *
 * A frame with shadow volumes is drawn several times by the reference: without shadows, by an
 * Unclamped pass that is made for this frame alone and, if the mode is Clamped, also by a Clamped
 * pass that is made for this frame alone. The image of the culler's window, whose pass lives as
 * long as the scenario, must be the same as the last of these.
 *
 * A frame fails if
 *
 *  - a byte of the RGBA images or, where it can be read, a bit of the depth differs,
 *  - a hardware selection before the frame found other props,
 *  - the statistics are not consistent in themselves or with the draws that mappers announced,
 *  - VTK or OpenGL reported an error or warning that they do not report without the culler,
 *  - the OpenGL state after the frame, or the copy of it in vtkOpenGLState, differs,
 *  - masks of shadows differ from those of Unclamped more than ShadowCheck.h allows, or contradict
 *    rays; a shadow pass failed, or its statistics are not consistent.
 */
#ifndef Checker_h
#define Checker_h

#include "Judge.h"
#include "Player.h"
#include "ShadowCheck.h"

#include <functional>
#include <map>
#include <string>

namespace TestScene
{
/// Sums over all frames that were checked.
struct Tally
{
  long long Scenarios = 0;
  long long Frames = 0;
  long long Props = 0;
  long long Tested = 0;
  long long HeldBack = 0;
  long long Hidden = 0;
  long long Redrawn = 0;
  long long GLErrors = 0;
  /// Frames after which VTK alone (without culler and shadows) leaves an error for glGetError().
  /// Their images are undefined and not compared.
  long long Undefined = 0;
  /// Frames in which VTK alone makes an OpenGL error, or reports an error or warning.
  long long ReferenceFaults = 0;
  long long FramesWithHidden = 0;
  std::map<std::string, long long> Decisions;       ///< Frames of one renderer, by decision.
  std::map<std::string, long long> Verdicts;        ///< Props, by verdict.
  std::map<std::string, long long> Features;        ///< Frames, by what they use, such as stereo.
  long long ShadowFrames = 0;                       ///< Frames with a shadow pass.
  std::map<std::string, long long> ShadowDecisions; ///< Frames of one renderer, by decision.
  std::map<std::string, long long> ShadowVerdicts;  ///< Casters, for each light, by verdict.
  ShadowTally Shadows;
};

struct Outcome
{
  int Frame = -1;      ///< The frame that failed; -1 if none did.
  std::string Failure; ///< The text that says what is wrong.

  bool HasFailed() const { return this->Frame >= 0; }
};

class Checker
{
public:
  explicit Checker(Role tested = Role::Culled, Role reference = Role::Reference);

  /**
   * Plays a scenario up to the first frame that fails. Windows are kept from one scenario to the
   * next, because making them and compiling their shaders takes most of the time, unless
   * `freshWindows` is true. Adds the counts to `tally`, if given.
   */
  Outcome Run(const Scenario& scenario, bool freshWindows, Tally* tally = nullptr);

  /// Is called after each frame, if it is set. `failure` is "" unless the frame has failed.
  std::function<void(
    const Player& reference, const Player& tested, int frame, const std::string& failure)>
    AfterFrame;

private:
  struct Drawn;
  /// Returns which errors of a frame are not those of VTK alone. `before` has the messages of VTK
  /// while the frame was prepared.
  using Judge = std::function<std::string(const Drawn& drawn, const std::string& before)>;

  static Drawn Draw(Player& stage, ShadowPasses passes, bool captureState);
  Outcome RunFrames(const Scenario& scenario, Tally* tally);
  std::string CheckFrame(const Scenario& scenario, int frame);
  std::string DrawReferenceShadows(const Scenario& scenario, int frame, const Judge& judge);
  std::string CheckShadows(bool& strays);
  /// Whether the images of a frame whose masks cannot be read differ by ShadowStrays alone: in at
  /// most MaximumFlipsElsewhere pixels, and not from a fresh pass of the same mode.
  bool HasUnreadStrays(const Picture& expected, const Picture& actual);
  void Count(const Scenario& scenario, Tally& tally) const;
  void CountShadows(Tally& tally) const;

  /// False where two stages without the culler are compared, to see whether VTK repeats itself.
  const bool IsJudging;
  Player Reference;
  Player Tested;
  long long GLErrors = 0;
  bool HasReferenceFault = false; ///< Whether the frame is one of Tally::ReferenceFaults.
  bool HasMasks = false;          ///< Whether Unclamped is that of the frame.
  ShadowFrame Unclamped;          ///< What the reference's Unclamped pass has drawn.
  ShadowTally Shadows;            ///< The sums over all frames so far.
  bool IsUndefined = false;       ///< Whether the frame is one of Tally::Undefined.
  bool HasSelected = false;       ///< Whether a selection before the frame has found props.
};
}

#endif
