// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferUnitTrial.h
 * @brief Finds out by the times of frames whether drawing large props unit by unit is faster.
 *
 * What the units of a mesh cost is work of the calling thread: testing them, and copying the
 * indices of those that are drawn to the device. What they save is work of the device, which may
 * draw a mesh of a million triangles in less time. A frame whose props are all drawn whole may also
 * need no test at all (vtkNBufferBackOff).
 */
#ifndef vtkNBufferUnitTrial_h
#define vtkNBufferUnitTrial_h

#include "vtkNBufferClock.h"
#include "vtkNBufferCullingPolicy.h"
#include "vtkNBufferModule.h" // For export macro

#include "vtkRenderer.h" // For the weak pointer
#include "vtkWeakPointer.h"

#include <limits>

VTK_ABI_NAMESPACE_BEGIN
struct vtkNBufferSettings;
struct vtkNBufferStatistics;

/**
 * Compares the times of two ways of drawing. A contest begins with a few frames in the first way;
 * then both take turns. Only the last frames of each are timed, because a frame depends on what was
 * learned in earlier frames. The faster way, or the second one if the first is not faster by 2 %,
 * is then used for a term of many frames, after which the next contest begins. The term is so long
 * that the contest has made all these frames slower by 0.5 % at most, as long as it need not be
 * longer than LongestTerm. No OpenGL.
 */
class VTKNBUFFER_EXPORT vtkNBufferContest
{
public:
  ///@{
  /// While both ways take turns: how many frames of each are not timed, how many are timed, and the
  /// sum. Before that SettlingFrames frames are drawn in the first way.
  static constexpr int SettlingFrames = vtkNBufferBackOff::PoorTestsBeforePause;
  static constexpr int TimedFrames = 3;
  static constexpr int FramesOfEach = SettlingFrames + TimedFrames;
  ///@}
  ///@{
  /// The shortest and the longest term, in frames.
  static constexpr int ShortestTerm = 64;
  static constexpr int LongestTerm = 4096;
  ///@}

  /// Whether the next frame is to be drawn in the first way.
  bool UsesFirst() const;

  /// Whether the next frame is to be timed.
  bool IsTimed() const;

  /// Count a frame. `milliseconds` is its time; it is only used if the frame was to be timed.
  void CountFrame(double milliseconds);

private:
  /// Times are compared by the shortest of each way, because nothing makes a frame faster than it
  /// is, but much makes it slower.
  double First = std::numeric_limits<double>::infinity();
  double Second = std::numeric_limits<double>::infinity();
  int Frame = 0; ///< Counts the frames of the contest.
  int Term = 0;  ///< The frames left of the term.
  bool FirstIsFaster = true;
};

/// A contest between frames with units and without. It waits for the device before and after each
/// timed frame, and at no other time.
class vtkNBufferUnitTrial
{
public:
  vtkNBufferUnitTrial() = default;
  ~vtkNBufferUnitTrial();
  vtkNBufferUnitTrial(const vtkNBufferUnitTrial&) = delete;
  void operator=(const vtkNBufferUnitTrial&) = delete;

  /// Begin a frame in which units may be drawn, and return whether they are to be drawn. `last` has
  /// the numbers of units in the last frame in which they were. The context of the renderer's
  /// window must be current. `renderer` is the same in all calls.
  bool DrawsUnits(
    vtkRenderer* renderer, const vtkNBufferSettings& settings, const vtkNBufferStatistics& last);

  /// Forget all times.
  void Restart() { this->Contest = {}; }

private:
  void EndFrame();

  vtkNBufferContest Contest;
  vtkNBufferClock Clock;
  bool IsTiming = false;
  vtkWeakPointer<vtkRenderer> Observed;
  unsigned long Observer = 0; ///< Of the end of its frames.
};

VTK_ABI_NAMESPACE_END
#endif
