// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferBackOff
 * @brief When testing does not pay: how long to rest, and when to look again. No OpenGL.
 *
 * A test is poor if it saves fewer than 16 draws or less than 5 % of what is in the frustum, draws
 * for the order of equal depths set off against it. Three poor tests in a row begin a rest of 8
 * frames. A single test then looks whether that has changed; if not, the rests double up to 64
 * frames. Where nothing is held back, every eighth frame and the first one after a rest are tested
 * all the same: only a test finds what has become hidden.
 */
#ifndef vtkNBufferBackOff_h
#define vtkNBufferBackOff_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferBackOff
{
public:
  static constexpr int PoorNumber = 16;
  static constexpr double PoorShare = 0.05;
  static constexpr int PoorTestsToRest = 3;
  static constexpr int ShortestRest = 8;
  static constexpr int LongestRest = 64;

  /// Whether this frame is one of a rest. Call once per frame.
  bool CountRestFrame();

  /// Whether a frame in which nothing is held back is due for a test. Call once per such frame.
  bool CountIdleFrame();

  /// How many draws of the candidates in the frustum a test saves: those found hidden, whether they
  /// had been drawn already or not, less those drawn once more.
  void Learn(int saved, int inside);

private:
  bool Rested = false;
  int FramesToRest = 0;
  int LastRest = 0;
  int PoorTests = 0;
  int FramesWithNothingHeld = 0;
};

VTK_ABI_NAMESPACE_END
#endif
