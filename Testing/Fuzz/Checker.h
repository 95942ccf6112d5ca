// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Checker.h
 * @brief Plays a scenario with and without the culler and compares every frame.
 *
 * With shadow volumes the reference draws the frame without them, with a pass that is Unclamped and
 * lives for this frame alone and, where the scenario is Clamped, with one that is so, too. The last
 * of these is what the culler's window has to be the same as, whose pass lives as long as the
 * scenario.
 *
 * A frame fails if
 *
 *  - a byte of the RGBA windows or, where it can be read, a bit of the depth differs,
 *  - a hardware selection before it found other props,
 *  - the statistics are not consistent in themselves or with the draws that mappers announced,
 *  - VTK or OpenGL reported an error or warning that they do not report without the culler,
 *  - the OpenGL state that it leaves, or what vtkOpenGLState remembers of it, is another one,
 *  - masks of shadows are not those of Unclamped (ShadowCheck.h says what Clamped may), or
 *    contradict rays; a pass failed, or its statistics are not consistent.
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
/// Sums over frames.
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
  /// Frames after which VTK alone leaves an error for glGetError(): it drew something other than it
  /// meant to, and what the image shows depends on nothing known. It is not compared.
  long long Undefined = 0;
  /// Frames in which VTK alone, without culler and shadows, makes an OpenGL error, of which it may
  /// know, or reports an error or warning.
  long long ReferenceFaults = 0;
  long long FramesWithHidden = 0;
  std::map<std::string, long long> Decisions;       ///< Renderer frames by decision.
  std::map<std::string, long long> Verdicts;        ///< Props by verdict.
  std::map<std::string, long long> Features;        ///< Frames in which something took part.
  long long ShadowFrames = 0;                       ///< With a pass with shadow volumes.
  std::map<std::string, long long> ShadowDecisions; ///< Renderer frames by decision.
  std::map<std::string, long long> ShadowVerdicts;  ///< Casters, for each light, by verdict.
  ShadowTally Shadows;
};

struct Outcome
{
  int Frame = -1;      ///< That failed; -1: none.
  std::string Failure; ///< What is wrong, as text.

  bool HasFailed() const { return this->Frame >= 0; }
};

class Checker
{
public:
  explicit Checker(Role tested = Role::Culled, Role reference = Role::Reference);

  /**
   * Up to the first frame that fails. Windows are kept from one scenario to the next, because
   * making them and compiling their shaders takes most of the time; `freshWindows` makes new ones.
   */
  Outcome Run(const Scenario& scenario, bool freshWindows, Tally* tally = nullptr);

  /// Called after each frame, if set, with what is wrong in it: empty, or the last frame.
  std::function<void(
    const Player& reference, const Player& tested, int frame, const std::string& failure)>
    AfterFrame;

private:
  struct Drawn;
  /// What is wrong with what came with a frame; the text is what came before it.
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

  /// Not where two stages are compared to see whether VTK repeats itself.
  const bool IsJudging;
  Player Reference;
  Player Tested;
  long long GLErrors = 0;
  bool HasReferenceFault = false; ///< In the frame; see Tally.
  bool HasMasks = false;          ///< In the frame, of the reference.
  ShadowFrame Unclamped;          ///< Of the reference, in the frame.
  ShadowTally Shadows;            ///< Since the beginning.
  bool IsUndefined = false;       ///< The frame; see Tally.
};
}

#endif
