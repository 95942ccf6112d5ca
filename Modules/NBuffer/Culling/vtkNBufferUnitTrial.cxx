// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferUnitTrial.h"

#include "vtkNBufferDepthTest.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferStatistics.h"

#include "vtkCommand.h"

#include VTKNBUFFER_GL_HEADER

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The share of the time of a term that a contest may have lost by drawing in the slower way.
constexpr double LargestShare = 0.005;

/// The share by which the first way has to be faster. The times of equal ways differ by about so
/// much, and the first way also costs what no timed frame shows, such as the memory of units.
constexpr double LeastGain = 0.02;
}

bool vtkNBufferContest::UsesFirst() const
{
  return this->Term > 0 ? this->FirstIsFaster
                        : this->Frame < SettlingFrames || (this->Frame - SettlingFrames) % 2 == 0;
}

bool vtkNBufferContest::IsTimed() const
{
  return this->Term == 0 && this->Frame >= 3 * SettlingFrames;
}

void vtkNBufferContest::CountFrame(double milliseconds)
{
  if (this->Term > 0)
  {
    --this->Term;
    return;
  }
  if (this->IsTimed())
  {
    double& shortest = this->UsesFirst() ? this->First : this->Second;
    shortest = std::min(shortest, milliseconds);
  }
  if (++this->Frame < SettlingFrames + 2 * FramesOfEach)
  {
    return;
  }
  this->FirstIsFaster = this->First <= (1.0 - LeastGain) * this->Second;
  const auto [faster, slower] = std::minmax(this->First, this->Second);
  const double lost = (SettlingFrames + FramesOfEach) * (slower - faster);
  this->Term = lost < LongestTerm * LargestShare * faster
    ? std::max(static_cast<int>(lost / (LargestShare * faster)), +ShortestTerm)
    : LongestTerm;
  this->Frame = 0;
  this->First = this->Second = std::numeric_limits<double>::infinity();
}

vtkNBufferUnitTrial::~vtkNBufferUnitTrial()
{
  if (this->Observed)
  {
    this->Observed->RemoveObserver(this->Observer);
  }
}

bool vtkNBufferUnitTrial::DrawsUnits(
  vtkRenderer* renderer, const vtkNBufferSettings& settings, const vtkNBufferStatistics& last)
{
  // A software renderer takes longer to draw a hidden unit than this module takes to test it.
  const bool drawsFew = 2 * (last.UnitsKept + last.UnitsFresh) < last.Units;
  if (!settings.TimeUnits || settings.Shared || (drawsFew && vtkNBufferGL::GetSoftwareRenderer()))
  {
    return true;
  }
  const bool hasUnits = this->Contest.UsesFirst();
  this->IsTiming = this->Contest.IsTimed();
  if (!this->IsTiming)
  {
    this->Contest.CountFrame(0.0);
    return hasUnits;
  }
  // An application that removes its own observers may remove this one with them.
  if (this->Observer == 0 || !renderer->GetCommand(this->Observer))
  {
    this->Observed = renderer;
    this->Observer =
      renderer->AddObserver(vtkCommand::EndEvent, this, &vtkNBufferUnitTrial::EndFrame);
  }
  glFinish();
  this->Clock.Restart();
  return hasUnits;
}

void vtkNBufferUnitTrial::EndFrame()
{
  if (std::exchange(this->IsTiming, false))
  {
    glFinish();
    this->Contest.CountFrame(this->Clock.GetMilliseconds());
  }
}
VTK_ABI_NAMESPACE_END
