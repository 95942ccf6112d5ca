// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferUnitTrial.h"

#include "vtkNBufferGL.h"

#include "vtkRenderer.h"

#include VTKNBUFFER_GL_HEADER

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
bool vtkNBufferContest::UsesFirst() const
{
  return this->Term > 0 ? this->FirstIsFaster
                        : this->Frame < SettlingFrames || (this->Frame - SettlingFrames) % 2 == 0;
}

bool vtkNBufferContest::IsTimed() const
{
  return this->Term == 0 && this->Frame >= SettlingFrames;
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
  const bool isFaster = this->First <= this->Second;
  const bool winsAgain = this->LastTerm > 0 && isFaster == this->FirstIsFaster;
  this->LastTerm = winsAgain ? std::min(2 * this->LastTerm, LongestTerm) : ShortestTerm;
  this->FirstIsFaster = isFaster;
  this->Term = this->LastTerm;
  this->Frame = 0;
  this->First = this->Second = std::numeric_limits<double>::infinity();
}

bool vtkNBufferUnitTrial::BeginFrame(vtkRenderer* renderer)
{
  const bool hasUnits = this->Contest.UsesFirst();
  this->IsTiming = this->Contest.IsTimed();
  if (!this->IsTiming)
  {
    this->Contest.CountFrame(0.0);
    return hasUnits;
  }
  if (this->Observed != renderer)
  {
    renderer->AddObserver(vtkCommand::EndEvent, this);
    this->Observed = renderer;
  }
  glFinish();
  this->Clock.Restart();
  return hasUnits;
}

void vtkNBufferUnitTrial::Detach()
{
  if (this->Observed)
  {
    this->Observed->RemoveObserver(this);
  }
}

void vtkNBufferUnitTrial::Execute(vtkObject*, unsigned long, void*)
{
  if (std::exchange(this->IsTiming, false))
  {
    glFinish();
    this->Contest.CountFrame(this->Clock.GetMilliseconds());
  }
}
VTK_ABI_NAMESPACE_END
