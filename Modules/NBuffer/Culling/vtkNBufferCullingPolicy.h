// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferCullingPolicy.h
 * @brief Whether a frame in which props could be held back is worth a test against depth. No
 * OpenGL, no renderer.
 */
#ifndef vtkNBufferCullingPolicy_h
#define vtkNBufferCullingPolicy_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferStatistics.h"

VTK_ABI_NAMESPACE_BEGIN

/**
 * Stops testing for some frames where tests save too little.
 *
 * Testing costs time even if nothing is found hidden, as where a viewer looks down on a city. This
 * class counts what tests save and decides in which frames to test.
 *
 * A test is poor if it saves fewer than 16 draws or less than 5 % of the candidates in the frustum;
 * draws that only restore the order of equal depths are subtracted from what it saves. Three poor
 * tests in a row begin a pause of 8 frames without tests. After the pause a single test shows
 * whether that has changed. If it is poor again, the next pause is twice as long, up to 64 frames.
 *
 * A frame is idle if no prop is held back in it, because all in the frustum were visible already.
 * Idle frames need no test for the picture. But only a test finds out what has become hidden since,
 * so every eighth idle frame, and the first idle one after a pause, is tested all the same.
 */
class VTKNBUFFER_EXPORT vtkNBufferBackOff
{
public:
  /// A test that saves fewer draws than this is poor.
  static constexpr int PoorNumber = 16;
  /// A test that saves less than this share of the candidates in the frustum is poor.
  static constexpr double PoorShare = 0.05;
  /// The number of poor tests in a row that begin a pause.
  static constexpr int PoorTestsBeforePause = 3;
  ///@{
  /// The lengths of the first and of the longest pause, in frames.
  static constexpr int ShortestPause = 8;
  static constexpr int LongestPause = 64;
  ///@}

  /**
   * Count one frame of a pause. Returns true, and shortens the pause by a frame, if one is going
   * on: this frame must not be tested. Returns false and changes nothing if there is no pause. Call
   * it exactly once in each frame.
   */
  bool CountPausedFrame();

  /**
   * Count one idle frame, and return whether it has to be tested nevertheless. Call it exactly once
   * in each frame that is idle and not part of a pause.
   */
  bool CountIdleFrame();

  /**
   * Report the result of a test. `saved` is how many draws it saved: the candidates that it found
   * hidden (drawn already in this frame or not) less those that were drawn once more. `inside` is
   * how many candidates in the frustum could be tested, translucent ones included; if it is 0, the
   * test says nothing and is ignored.
   */
  void Learn(int saved, int inside);

  /// Whether a test is poor that is reported in this way.
  static bool IsPoor(int saved, int inside)
  {
    return saved < PoorNumber || saved < PoorShare * inside;
  }

  /// Whether a pause is going on, so that the next frame must not be tested.
  bool IsPaused() const { return this->FramesLeft > 0; }

private:
  bool WasPaused = false; ///< Whether the last frame that was counted was part of a pause.
  int FramesLeft = 0;     ///< The frames left of the pause.
  int LastPause = 0;      ///< The length of the last pause; 0 after a test that was not poor.
  int PoorTests = 0;      ///< The number of poor tests in a row.
  int IdleFrames = 0;     ///< The number of idle frames so far.
};

/**
 * The number of props of each kind in a frame, before any of them is drawn. Each unit of a prop
 * that is drawn unit by unit counts like a prop.
 */
struct vtkNBufferFrustumCounts
{
  int Candidates = 0;  ///< Opaque (not Blended) and translucent candidates, in the frustum or not.
  int Inside = 0;      ///< Opaque candidates, and units of any prop, in the frustum.
  int Kept = 0;        ///< Those of Inside that can be tested and were visible in the last test.
  int HeldBack = 0;    ///< Opaque ones of Inside that can be tested and that are not Kept.
  int Translucent = 0; ///< Translucent candidates that can be tested.
  int Blended = 0;     ///< Opaque candidates in the frustum that come after a prop that blends.
  bool Blending = false; ///< The order in which any props are drawn may show.
};

namespace vtkNBufferCullingPolicy
{
/**
 * Choose what to do with a frame. Returns vtkNBufferDecision::Culled if the frame is to be tested,
 * otherwise the reason why not. If the result is Culled and no prop is held back, there are kept
 * props, and the caller must see to it that there is a test (vtkNBufferPartition::HoldBack()).
 *
 * A frame with fewer candidates Inside than `minimumNumberOfCandidates` is never tested. `backOff`
 * counts the frame, and leaves out frames of a pause and most idle frames; nullptr leaves out none.
 */
VTKNBUFFER_EXPORT vtkNBufferDecision ChooseDecision(
  const vtkNBufferFrustumCounts& counts, int minimumNumberOfCandidates, vtkNBufferBackOff* backOff);
}

VTK_ABI_NAMESPACE_END
#endif
