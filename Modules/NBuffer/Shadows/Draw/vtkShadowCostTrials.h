// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowCostTrials
 * @brief Measures once how the costs of vtkShadowCostModel compare with this device.
 *
 * In four frames one light is drawn in a way that its estimate does not choose: twice with whole
 * volumes, then twice with litmaps. The second time of each is measured; in the first one OpenGL
 * may compile programs. The pass waits for the device in these frames only. They come after the
 * first frame of a light whose estimate is large: a small one says little, and nothing depends on
 * it.
 */
#ifndef vtkShadowCostTrials_h
#define vtkShadowCostTrials_h

#include "vtkNBufferClock.h"
#include "vtkNBufferGL.h"

#include <cstddef>
#include <iterator>

VTK_ABI_NAMESPACE_BEGIN

class vtkShadowCostTrials
{
public:
  /// How a light is to be drawn; Estimated means that this is no trial.
  enum class Way
  {
    Estimated,
    Whole,
    Litmaps
  };

  void BeginFrame() { this->HasTried = false; }

  /// Chooses for a light with this estimate of its whole volumes, in milliseconds.
  Way Choose(double wholeEstimate)
  {
    constexpr Way ways[] = { Way::Estimated, Way::Whole, Way::Whole, Way::Litmaps, Way::Litmaps };
    constexpr double least = 1.0; // milliseconds before any correction
    if (this->HasTried || this->Trials == std::size(ways) ||
      !(wholeEstimate >= least * this->Whole))
    {
      return Way::Estimated;
    }
    this->HasTried = true;
    return ways[this->Trials++];
  }

  /// Starts the measurement of a trial.
  void Start(Way way)
  {
    if (way != Way::Estimated)
    {
      glFinish();
      this->Clock.Restart();
    }
  }

  /// Ends it, and corrects the factor of the way by what it was estimated to take.
  void Stop(Way way, double estimate)
  {
    if (way != Way::Estimated && estimate > 0.0)
    {
      glFinish();
      (way == Way::Whole ? this->Whole : this->Litmap) *= this->Clock.GetMilliseconds() / estimate;
    }
  }

  double Whole = 1.0;  ///< The factor for estimates of whole volumes.
  double Litmap = 1.0; ///< The factor for estimates of litmaps.

private:
  vtkNBufferClock Clock;
  std::size_t Trials = 0; ///< The frames so far.
  bool HasTried = false;  ///< True if this frame is one of them.
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCostTrials.h
