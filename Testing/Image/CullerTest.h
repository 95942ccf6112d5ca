// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CullerTest.h
 * @brief Compares frames of a scene with and without the culler, byte for byte, in one process.
 *
 * A test gives a function that builds its scene. The function is called for two stages, each with
 * its own window: the reference has no culler at all; the other one has vtkNBufferCuller, added as
 * applications do. Every Frame() renders both and fails if
 *
 *  - a byte of the RGBA images or, where it can be read, a bit of the depth differs,
 *  - the statistics are not consistent in themselves and with the draws that mappers announced,
 *  - VTK or OpenGL reported an error or a warning.
 *
 * The checks are in Judge.h.
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

/// Switches order-independent transparency, where this VTK has a switch for it.
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

/// The base of the parameters of a suite whose cases have names.
struct NamedCase
{
  const char* Name;
};
inline std::ostream& operator<<(std::ostream& os, const NamedCase& named)
{
  return os << named.Name;
}
inline constexpr auto GetCaseName = [](const auto& info) { return std::string(info.param.Name); };

/// The options of a comparison.
struct ComparisonOptions
{
  int Width = 301;
  int Height = 173;
  int MultiSamples = 0;
  /// Whether VTK's default culler (vtkFrustumCoverageCuller) stays in front of vtkNBufferCuller.
  bool KeepDefaultCuller = true;
  /// Whether the reference has VTK's default culler; otherwise it has none.
  bool StockReference = false;
  /// Whether the constructor adds the culler; otherwise the test calls AddCuller().
  bool AddCuller = true;
  /// Whether depth is compared as well. False where the last renderer or a pass leaves none to
  /// read.
  bool CompareDepth = true;
  /// Whether the rendered image is compared instead of the copy that VTK makes to show it. Where
  /// the formats of depth differ, VTK fails to make that copy; its OpenGL errors are then no
  /// failure.
  bool ReadRendered = false;
  /// Whether the draws of each prop are compared with the reference. False in stereo, where the
  /// statistics are those of one eye.
  bool CompareDraws = true;
  int Backend = vtkNBufferCuller::Auto;
  /// With the default RoundSize most of these small scenes would be drawn before the first test.
  /// With BackOff the culler would often not test, because tests hide little in small scenes and
  /// after large moves of the camera. With TimeUnits times would decide what is drawn.
  vtkNBufferTuning Tuning = []
  {
    vtkNBufferTuning tuning;
    tuning.RoundSize = 12;
    tuning.BackOff = false;
    tuning.TimeUnits = false;
    return tuning;
  }();
  /// Whether all pictures of the test may be of one color. A test whose scene is never drawn finds
  /// no difference, whatever the culler does.
  bool MayBeOfOneColor = false;
  /// Whether the messages of VTK are added to Comparison::Messages instead of failing the test.
  bool KeepMessages = false;
};

class Comparison
{
public:
  using Change = std::function<void(Stage&)>;

  Comparison(const Change& build, const ComparisonOptions& options = ComparisonOptions());
  ~Comparison();

  /// Applies a change to both stages.
  void Both(const Change& change);
  ///@{
  /// Apply a change to both stages, render a frame of both, and compare. `what` describes the frame
  /// in messages of failures.
  void Frame(const std::string& what = "", const Change& change = nullptr);
  void Frame(const Change& change) { this->Frame("", change); }
  ///@}
  /// Adds the culler to all renderers of the second stage, as applications do.
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
  bool HasShown = false; ///< Whether a picture of the reference had pixels of different colors.
};

///@{
/// Make GoogleTest print the names of values.
void PrintTo(vtkNBufferVerdict verdict, std::ostream* os);
void PrintTo(vtkNBufferDecision decision, std::ostream* os);
///@}

/// @name Environment variables that help to find the cause of a failure
///@{
/// Prints the statistics of a frame if VTKNBUFFER_TEST_VERBOSE is set.
void PrintStatistics(const Stage& culled, const std::string& frame);
/// Writes the pictures of a frame that differs to the folder that VTKNBUFFER_TEST_OUTPUT names.
void WritePictures(const Stage& reference, const Stage& culled, const std::string& frame);
///@}

/// Succeeds if the culler built no levels, read no depth and tested nothing in the frame.
testing::AssertionResult DidNoWork(const vtkNBufferStatistics& statistics);

#endif
