// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer.h"

#include "Frames.h"

#include "vtkCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkPropCollection.h"

#include <cstdio>
#include <iostream>

namespace NBufferView
{
namespace
{
constexpr unsigned long SunTick = 60; // milliseconds
constexpr double SunStep = 0.5;       // hours
constexpr double TurnStep = 5.0;      // degrees
constexpr int MeasuredTurns = 3;
constexpr int WarmUp = 8; // frames
/// After a movement the times are measured again if that takes no longer than this.
constexpr double PatientTime = 150.0; // milliseconds
constexpr double FramesOfATurn = 4.0;

std::string Format(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

vtkSmartPointer<vtkRenderWindowInteractor> MakeInteractor(bool isShown)
{
  if (isShown)
  {
    return vtkSmartPointer<vtkRenderWindowInteractor>::New();
  }
  return vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
}

std::string DescribeTimes(const Comparison& times)
{
  const double stock = times.GetStockTime();
  const double own = times.GetOwnTime();
  return "stock VTK " + Format("%.1f ms", stock) + " a frame, with the culler " +
    Format("%.1f ms", own) +
    (own > 0.0 ? Format(", %.1f times as fast", stock / own) : std::string());
}
}

Viewer::Viewer(const NBufferExamples::Scene& scene, std::array<int, 2> size, bool isShown)
  : Where(scene, size, isShown)
  , Culling(Where)
  , Red(Where, Culling, scene)
  , Levels(Where)
  , Shadows(Where, scene)
  , Text(Where)
  , Names(Where, Text, scene)
  , Interactor(MakeInteractor(isShown))
{
  this->Interactor->SetRenderWindow(this->Where.GetWindow());
  this->Interactor->Initialize();
  AddKeys(this->Commands, this);
  this->Commands.Follow(this->Interactor);
  this->Names.Follow(this->Interactor);
  this->Interactor->AddObserver(vtkCommand::TimerEvent, this, &Viewer::MoveSunOn, 2.0F);
  double up[3] = { 0.0, 0.0, 0.0 };
  up[scene.UpAxis] = 1.0;
  this->Flight->SetDefaultUpVector(up);
  this->Flight->RestoreUpVectorOn();
  this->Flight->SetMotionStepSize(this->Where.GetStep() / scene.GetBounds().GetDiagonalLength());
  this->Flight->SetUseTimers(isShown); // Only the interactor of a shown window has timers.
  for (vtkInteractorStyle* style :
    std::initializer_list<vtkInteractorStyle*>{ this->Orbit, this->Flight })
  {
    style->AutoAdjustCameraClippingRangeOff();
    style->AddObserver(vtkCommand::EndInteractionEvent, this, &Viewer::MeasureAgain);
  }
  this->Interactor->SetInteractorStyle(this->Orbit);
  this->Where.GetOverlay()->AddObserver(vtkCommand::StartEvent, this, &Viewer::WriteText);
  std::cout << scene.Actors.size() << (scene.Actors.size() == 1 ? " part" : " parts")
            << "; the key h shows the keys" << std::endl;
  // First everything is uploaded and compiled, and the culler finds out what is worth drawing
  // first.
  for (int i = 0; i < WarmUp; ++i)
  {
    this->Where.Draw();
  }
  this->Measure();
}

void Viewer::AddKeys(Keys& keys, Viewer* viewer)
{
  const auto add = [&keys](const char* key, const char* help, std::function<void()> action)
  { keys.Add(key, help, std::move(action)); };
  add("n", "the culler on and off", [viewer]() { viewer->SwitchCuller(); });
  add("f", "freeze what is culled, to fly around and look at it; thaw it again",
    [viewer]() { viewer->SwitchFreeze(); });
  add("c", "culled parts in red", [viewer]() { viewer->SwitchCulledParts(); });
  add("l", "the next level of the N-buffer", [viewer]() { viewer->ShowNextLevel(); });
  add("s", "shadows in the light of the sun", [viewer]() { viewer->SwitchShadows(); });
  add(",", "the sun half an hour back or on", [viewer]() { viewer->MoveSun(-SunStep); });
  add(".", "the sun half an hour back or on", [viewer]() { viewer->MoveSun(SunStep); });
  add("a", "the sun moves by itself, or stands still", [viewer]() { viewer->SwitchSunWalk(); });
  add("v", "verify: count the bytes that differ with and without the culler",
    [viewer]() { viewer->Verify(); });
  add("t", "times of a frame with and without the culler", [viewer]() { viewer->Measure(); });
  add("o", "orbit: left button turns, middle one shifts, right one and wheel zoom",
    [viewer]() { viewer->UseStyle(viewer->Orbit, "orbit"); });
  add("w", "walk: left button goes to where the pointer is, right one goes back",
    [viewer]() { viewer->UseStyle(viewer->Flight, "walk"); });
  const auto move = [viewer](double ahead, double up, double turn)
  {
    viewer->Where.Walk(ahead, up);
    viewer->Where.Turn(turn);
    viewer->Draw();
  };
  const char* moves = "steps level with the ground, and turns";
  add("Up", moves, [move]() { move(1.0, 0.0, 0.0); });
  add("Down", moves, [move]() { move(-1.0, 0.0, 0.0); });
  add("Left", moves, [move]() { move(0.0, 0.0, TurnStep); });
  add("Right", moves, [move]() { move(0.0, 0.0, -TurnStep); });
  const char* heights = "steps up and down: the keys Page Up and Page Down";
  add("Prior", heights, [move]() { move(0.0, 2.0, 0.0); });
  add("Next", heights, [move]() { move(0.0, -2.0, 0.0); });
  add("r", "back to where the camera was at first",
    [viewer]()
    {
      viewer->Where.GoHome();
      viewer->Draw();
    });
  add("i", "the text on and off", [viewer]() { viewer->SwitchText(); });
  add("h", "these keys", [viewer]() { viewer->SwitchHelp(); });
  add("q", "quit", [viewer]() { viewer->Quit(); });
}

void Viewer::Run()
{
  if (!this->IsOver)
  {
    this->Interactor->Start();
  }
}

void Viewer::WritePicture(const std::string& fileName)
{
  this->Where.Draw();
  NBufferExamples::WriteFrame(this->Where.GetWindow(), fileName);
}

void Viewer::SwitchCuller()
{
  this->Culling.SetCulling(!this->Culling.IsCulling());
  this->Say(this->Culling.IsCulling() ? "culler on" : "culler off");
}

void Viewer::SwitchFreeze()
{
  vtkNBufferCuller* culler = this->Culling.GetCuller();
  culler->SetFreeze(!culler->GetFreeze());
  this->Say(culler->GetFreeze() ? "frozen: what was culled here stays culled" : "thawed");
}

void Viewer::SwitchCulledParts()
{
  this->Red.SetShown(!this->Red.IsShown());
  this->Draw(); // The number of culled parts is that of a frame.
  this->Say(this->Red.IsShown() ? std::to_string(this->Red.GetCount()) + " culled parts in red"
                                : "culled parts not shown");
}

void Viewer::SwitchShadows()
{
  this->Shadows.SetShown(!this->Shadows.IsShown());
  this->Say(this->Shadows.IsShown() ? "shadows at " + this->Shadows.GetTime() : "no shadows");
}

void Viewer::MoveSun(double hours)
{
  this->Shadows.Move(hours);
  this->Say("the sun at " + this->Shadows.GetTime());
}

void Viewer::SwitchSunWalk()
{
  if (this->SunTimer != 0)
  {
    this->Interactor->DestroyTimer(this->SunTimer);
    this->SunTimer = 0;
    this->Say("the sun stands still");
    return;
  }
  this->Shadows.SetShown(true);
  this->SunTimer = this->Interactor->CreateRepeatingTimer(SunTick);
  this->Say(this->SunTimer != 0 ? "the sun moves" : "the sun moves only in a window");
}

bool Viewer::MoveSunOn(vtkObject*, unsigned long, void* timer)
{
  if (this->SunTimer == 0 || !timer || *static_cast<int*>(timer) != this->SunTimer)
  {
    return false;
  }
  this->Shadows.Move(0.1 * SunStep);
  this->Draw();
  return true;
}

void Viewer::ShowNextLevel()
{
  this->Levels.ShowNext();
  const std::string level = this->Levels.Describe();
  this->Say(level.empty() ? "no level" : level);
}

void Viewer::Verify()
{
  const long long bytes = this->Culling.Verify();
  const bool isFrozen = this->Culling.GetCuller()->GetFreeze();
  this->DifferingBytes += isFrozen ? 0 : bytes;
  this->Say("verify: " + std::to_string(bytes) + " bytes differ with and without the culler" +
    (isFrozen ? ", whose verdicts are frozen" : ""));
}

void Viewer::Measure()
{
  this->Culling.Measure(MeasuredTurns);
  this->Say(DescribeTimes(this->Culling));
}

void Viewer::MeasureAgain()
{
  const bool isFrozen = this->Culling.GetCuller()->GetFreeze();
  const double sum = this->Culling.GetStockTime() + this->Culling.GetOwnTime();
  if (!isFrozen && FramesOfATurn * sum < PatientTime)
  {
    this->Culling.Measure(1);
  }
  this->Message.clear();
  this->Draw();
}

void Viewer::UseStyle(vtkInteractorStyle* style, const std::string& message)
{
  this->Interactor->SetInteractorStyle(style);
  this->Say(message);
}

void Viewer::SwitchText()
{
  this->HasText = !this->HasText;
  this->Say(this->HasText ? "text on" : "text off");
}

void Viewer::SwitchHelp()
{
  this->HasHelp = !this->HasHelp;
  this->Text.SetList(this->HasHelp ? this->Commands.Describe() : "");
  this->Draw();
}

void Viewer::Quit()
{
  this->IsOver = true;
  this->Interactor->SetDone(true);
}

void Viewer::Say(const std::string& message)
{
  std::cout << message << std::endl;
  this->Message = message;
  this->Draw();
}

void Viewer::Draw()
{
  this->Interactor->Render();
}

void Viewer::WriteText()
{
  if (!this->HasText)
  {
    this->Text.SetLines("");
    return;
  }
  vtkNBufferCuller* culler = this->Culling.GetCuller();
  const vtkNBufferStatistics& counts = culler->GetStatistics(this->Where.GetScene());
  std::string text =
    DescribeTimes(this->Culling) + "\n" + Format("this frame %.1f ms, ", this->Where.GetLastTime());
  if (this->Culling.IsCulling())
  {
    text += "culler on: " + std::to_string(counts.GetNumberOfPropsDrawn()) + " of " +
      std::to_string(counts.Props) + " parts drawn, " +
      std::to_string(counts.GetCount(vtkNBufferVerdict::Hidden)) + " hidden, " +
      std::to_string(counts.GetCount(vtkNBufferVerdict::Outside)) + " outside the view (" +
      vtkNBufferStatistics::GetName(counts.Decision) + ")";
  }
  else
  {
    text += "culler off: " + std::to_string(this->Where.GetScene()->GetNumberOfPropsRendered()) +
      " of " + std::to_string(this->Where.GetScene()->GetViewProps()->GetNumberOfItems()) +
      " parts drawn";
  }
  std::string states;
  const auto addState = [&states](bool is, const std::string& state)
  { states += is ? (states.empty() ? "" : ", ") + state : ""; };
  addState(culler->GetFreeze(), "frozen");
  addState(this->Red.IsShown(), std::to_string(this->Red.GetCount()) + " culled parts in red");
  addState(this->Shadows.IsShown(), "shadows at " + this->Shadows.GetTime());
  const std::string level = this->Levels.Describe();
  addState(!level.empty(), level);
  text += states.empty() ? "" : "\n" + states;
  // Not twice, and not times that have changed since.
  const bool isNews = states.find(this->Message) == std::string::npos &&
    this->Message.find(" a frame") == std::string::npos;
  text += isNews ? "\n" + this->Message : "";
  this->Text.SetLines(text);
}

} // namespace NBufferView
