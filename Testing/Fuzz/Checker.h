// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Checker.h
 * @brief Plays a scenario with and without the culler and compares every frame.
 *
 * A frame fails if
 *
 *  - a byte of the RGBA windows or, where it can be read, a bit of the depth differs,
 *  - a hardware selection before it found other props,
 *  - the statistics are not consistent in themselves or with the draws that mappers announced,
 *  - VTK or OpenGL reported an error or warning that they do not report without the culler,
 *  - the OpenGL state that it leaves, or what vtkOpenGLState remembers of it, is another one.
 */
#ifndef Checker_h
#define Checker_h

#include "FuzzStage.h"

#include <map>
#include <string>

namespace NBufferFuzz
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
  long long Undefined =
    0; ///< Frames in which VTK alone makes an OpenGL error: no image to compare.
  long long FramesWithHidden = 0;
  std::map<std::string, long long> Decisions; ///< Renderer frames by decision.
  std::map<std::string, long long> Verdicts;  ///< Props by verdict.
  std::map<std::string, long long> Features;  ///< Frames in which something took part.
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

private:
  Outcome RunFrames(const Scenario& scenario, Tally* tally);
  std::string CheckFrame(const Scenario& scenario, int frame);
  std::string CompareImages(bool compareDepth);
  std::string CheckStatistics();
  std::string CheckDraws(bool stockCuller);
  void Count(const Scenario& scenario, Tally& tally) const;

  Stage Reference;
  Stage Tested;
  long long GLErrors = 0;
  bool IsUndefined = false; ///< The frame: what VTK's error leaves behind depends on nothing known.
};

/// Text of the errors and warnings that VTK reported since the last call.
std::string TakeMessages();

/// Whether this VTK has the window class that the environment asks for, and OpenGL with it; if not,
/// why.
std::string FindFault();
}

#endif
