// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HoverName.h"

#include "vtkCommand.h"
#include "vtkProp3D.h"
#include "vtkRenderWindowInteractor.h"

#include <iostream>

namespace NBufferView
{
namespace
{
constexpr unsigned long Delay = 300; // milliseconds
}

HoverName::HoverName(View& view, Panel& panel, const NBufferExamples::Scene& scene)
  : Where(view)
  , Text(panel)
  , Parts(scene)
{
  for (std::size_t i = 0; i < scene.Actors.size(); ++i)
  {
    this->Places.emplace(scene.Actors[i], i);
  }
  this->Picker->SetTolerance(0.0);
}

void HoverName::Follow(vtkRenderWindowInteractor* interactor)
{
  this->Pointer = interactor;
  // Before the interactor's style, which would see all timers as its own.
  constexpr float first = 2.0F;
  interactor->AddObserver(vtkCommand::MouseMoveEvent, this, &HoverName::Move, first);
  interactor->AddObserver(vtkCommand::LeaveEvent, this, &HoverName::Hide, first);
  interactor->AddObserver(vtkCommand::TimerEvent, this, &HoverName::Wait, first);
}

std::string HoverName::Find(int x, int y)
{
  if (this->Picker->Pick(x, y, 0.0, this->Where.GetScene()) == 0)
  {
    return "";
  }
  const auto found = this->Places.find(this->Picker->GetProp3D());
  return found == this->Places.end() ? "" : this->Parts.GetPartName(found->second);
}

void HoverName::Move()
{
  if (this->Timer != 0)
  {
    this->Pointer->DestroyTimer(this->Timer);
  }
  this->Timer = this->Pointer->CreateOneShotTimer(Delay);
  this->IsWaiting = true;
  this->Hide();
}

bool HoverName::Wait(vtkObject*, unsigned long, void* timer)
{
  if (!this->IsWaiting || (timer && *static_cast<int*>(timer) != this->Timer))
  {
    return false;
  }
  this->IsWaiting = false;
  const int* place = this->Pointer->GetEventPosition();
  const std::string name = this->Find(place[0], place[1]);
  if (!name.empty())
  {
    std::cout << "under the pointer: " << name << std::endl;
    this->Text.SetLabel(name, place[0], place[1]);
    this->IsShown = true;
    this->Pointer->Render();
  }
  return true;
}

void HoverName::Hide()
{
  if (this->IsShown)
  {
    this->IsShown = false;
    this->Text.SetLabel("", 0, 0);
    this->Pointer->Render();
  }
}

} // namespace NBufferView
