// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison.h"

#include "Frames.h"

#include <vector>

namespace NBufferView
{
namespace
{
/// While it lives, the scene is drawn alone. Then everything is as before.
class SceneAlone
{
public:
  SceneAlone(View& view, Comparison& comparison)
    : Where(view)
    , Owner(comparison)
    , On(comparison.IsCulling())
    , Swap(view.GetWindow()->GetSwapBuffers())
  {
    this->Where.SetDecorated(false);
  }
  ~SceneAlone()
  {
    this->Owner.SetCulling(this->On);
    this->Where.SetDecorated(true);
    this->Where.GetWindow()->SetSwapBuffers(this->Swap);
  }
  SceneAlone(const SceneAlone&) = delete;
  void operator=(const SceneAlone&) = delete;

  /// What is drawn does not reach the screen. Nor can it be read from there: GrabPixels() would
  /// return the frame before.
  void Hide()
  {
    this->Where.GetWindow()->SetSwapBuffers(this->Where.GetWindow()->GetOffScreenRendering());
  }

private:
  View& Where;
  Comparison& Owner;
  bool On;
  vtkTypeBool Swap;
};
}

Comparison::Comparison(View& view)
  : Where(view)
{
  this->SetCulling(true);
}

void Comparison::SetCulling(bool on)
{
  if (on == this->On)
  {
    return;
  }
  // The renderer keeps VTK's default culler, which the other one takes over while it is there.
  if (on)
  {
    this->Where.GetScene()->AddCuller(this->Culler);
  }
  else
  {
    this->Where.GetScene()->RemoveCuller(this->Culler);
  }
  this->On = on;
}

void Comparison::Measure(int turns)
{
  SceneAlone alone(this->Where, *this);
  alone.Hide();
  // The time is to be that of a camera that moves: each frame is tested anew.
  const vtkNBufferTuning usual = this->Culler->GetTuning();
  vtkNBufferTuning moving = usual;
  moving.ReuseWhenStill = false;
  this->Culler->SetTuning(moving);
  std::vector<double> times[2];
  for (int turn = 0; turn < turns; ++turn)
  {
    for (const bool on : { false, true })
    {
      this->SetCulling(on);
      // After a switch the culler reads again what it knows of the parts.
      for (int untimed = 0; untimed < 3; ++untimed)
      {
        this->Where.Draw();
      }
      times[on].push_back(this->Where.Draw());
    }
  }
  this->StockTime = NBufferExamples::GetMedian(times[0]);
  this->OwnTime = NBufferExamples::GetMedian(times[1]);
  this->Culler->SetTuning(usual);
}

long long Comparison::Verify()
{
  const SceneAlone alone(this->Where, *this);
  vtkSmartPointer<vtkUnsignedCharArray> frames[2];
  for (const bool on : { false, true })
  {
    this->SetCulling(on);
    this->Where.Draw();
    frames[on] = NBufferExamples::GrabPixels(this->Where.GetWindow());
  }
  return NBufferExamples::CountDifferingBytes(frames[0], frames[1]);
}

} // namespace NBufferView
