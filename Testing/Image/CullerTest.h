// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CullerTest.h
 * @brief The same scene twice in one process, with and without the culler, compared to the byte.
 *
 * A test gives a function that builds its scene. It is called for two stages, each with a window
 * of its own: the reference has no culler at all, the other one has vtkNBufferCuller added as a
 * user does. Every Frame() renders both and fails if
 *
 *  - a byte of the RGBA windows or, where it can be read, a bit of the depth differs,
 *  - the statistics are not consistent in themselves and with the draws that mappers announced,
 *  - VTK or OpenGL reported an error or a warning.
 *
 * Judge.h decides all of that.
 */
#ifndef CullerTest_h
#define CullerTest_h

#include "Judge.h"
#include "Messages.h"

#include "vtkNBufferCuller.h"
#include "vtkNBufferVTKVersion.h"

#include "vtkNew.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

/// Order-independent transparency, where this VTK has a switch for it.
inline void SetUseOIT(vtkRenderer* renderer, bool on)
{
#if VTKNBUFFER_HAS_OIT_SWITCH
  renderer->SetUseOIT(on);
#else
  (void)renderer;
  (void)on;
#endif
}

using TestScene::Stage;
using Verdict = vtkNBufferVerdict;
using Decision = vtkNBufferDecision;

/// The first part of the parameter of a suite whose cases have names.
struct NamedCase
{
  const char* Name;
};
inline std::ostream& operator<<(std::ostream& os, const NamedCase& named)
{
  return os << named.Name;
}
inline constexpr auto GetCaseName = [](const auto& info) { return std::string(info.param.Name); };

/// How a comparison is set up, where a test wants it otherwise.
struct ComparisonOptions
{
  int Width = 301;
  int Height = 173;
  int MultiSamples = 0;
  /// vtkRenderer's own vtkFrustumCoverageCuller stays in front of ours; else ours is alone.
  bool KeepDefaultCuller = true;
  /// The reference is stock VTK (with vtkFrustumCoverageCuller), not VTK without any culler.
  bool StockReference = false;
  /// Add the culler while the scene is built; else the test calls AddCuller().
  bool AddCuller = true;
  /// Compare depth as well; not where the last renderer or a pass leaves none to read.
  bool CompareDepth = true;
  /// Read what was rendered instead of the copy that VTK makes of it to show. Where the formats of
  /// depth differ VTK fails to make that copy; then its OpenGL errors are no failure.
  bool ReadRendered = false;
  /// Compare the draws of each prop with the reference. Not in stereo: the statistics are those
  /// of one eye.
  bool CompareDraws = true;
  int Backend = vtkNBufferCuller::Auto;
  /// The culler's default RoundSize would draw most of these small scenes before the first test.
  /// And it may not spare itself tests that hide little: most of these scenes are too small, and
  /// their cameras too quick, for that to be what is to be tested.
  vtkNBufferTuning Tuning = []
  {
    vtkNBufferTuning tuning;
    tuning.RoundSize = 12;
    tuning.BackOff = false;
    return tuning;
  }();
  /// What VTK reports is kept in Comparison::Messages instead of failing the test.
  bool KeepMessages = false;
  /// The culler is not added at all; see GetControl().
  bool Control = false;
};

class Comparison
{
public:
  using Change = std::function<void(Stage&)>;

  Comparison(const Change& build, const ComparisonOptions& options = ComparisonOptions());
  ~Comparison();

  /// Do the same to both stages.
  void Both(const Change& change);
  /// Render both, changed, and compare; `what` names the frame in failures.
  void Frame(const std::string& what = "", const Change& change = nullptr);
  void Frame(const Change& change) { this->Frame("", change); }
  /// Add the culler to all renderers of the second stage as a user does.
  void AddCuller();

  vtkNBufferCuller* GetCuller() const { return this->Culled.Culler; }
  const vtkNBufferStatistics& GetStatistics(int renderer = 0) const
  {
    return this->Culled.Culler->GetStatistics(this->Culled.Renderers[renderer]);
  }
  int GetHidden(int renderer = 0) const
  {
    return this->GetStatistics(renderer).GetCount(vtkNBufferVerdict::Hidden);
  }
  vtkNBufferDecision GetDecision(int renderer = 0) const
  {
    return this->GetStatistics(renderer).Decision;
  }
  vtkNBufferVerdict GetVerdict(int prop, int renderer = 0) const
  {
    return this->Culled.Culler->GetVerdict(
      this->Culled.Props[prop], this->Culled.Renderers[renderer]);
  }

  Stage Reference;
  Stage Culled;
  std::string Messages; ///< See ComparisonOptions::KeepMessages.

private:
  void CheckMessages(const std::string& messages);
  void CompareImages(const std::string& frame);

  ComparisonOptions Options;
  int Frames = 0;
};

/// Names in failures instead of bytes.
void PrintTo(vtkNBufferVerdict verdict, std::ostream* os);
void PrintTo(vtkNBufferDecision decision, std::ostream* os);

/// @name Environment variables
/// For who looks for the cause of a failure.
///@{
/// VTKNBUFFER_TEST_CONTROL: the control experiment. What differs without the culler on either side
/// is a fault of the test. "stock": stock VTK on both sides; anything else: VTK without any culler
/// against stock VTK. nullptr if it is not set.
const char* GetControl();
/// VTKNBUFFER_TEST_VERBOSE: print the statistics of each frame.
void PrintStatistics(const Stage& culled, const std::string& frame);
/// VTKNBUFFER_TEST_OUTPUT names a folder for the pictures of frames that differ.
void WritePictures(const Stage& reference, const Stage& culled, const std::string& frame);
///@}

/// No N-buffer work at all in this frame.
testing::AssertionResult DidNoWork(const vtkNBufferStatistics& statistics);

#endif
