// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowCostTrials
 * @brief Measures once how the estimates of vtkShadowCostModel compare with times on this device.
 *
 * In four frames one light is drawn in a given way, whatever its estimates say: twice with whole
 * volumes, then twice with litmaps. Only the second time of each way counts, because OpenGL may
 * compile programs in the first. For the trials it waits until the device has
 * drawn, which it does in no other frame except to read what was drawn. The trials
 * follow the first frame in which a light's estimate of its whole volumes is at least 1 ms: a
 * smaller estimate says little, and nothing depends on it.
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
  /// How a light is to be drawn. Estimated is no trial: the estimates decide.
  enum class Way
  {
    Estimated,
    Whole,
    Litmaps
  };

  void BeginFrame() { this->HasTried = false; }

  /// Chooses the way for a light with this estimate of its whole volumes, in milliseconds.
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

  /// Ends the measurement, and multiplies the factor of the way by the ratio of the measured time
  /// to `estimate`, in milliseconds.
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
  std::size_t Trials = 0; ///< The entries of `ways` that were used so far.
  bool HasTried = false;  ///< True if one was used in this frame.
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCostTrials.h
