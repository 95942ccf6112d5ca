// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LevelInset.h"

#include "LevelPicture.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkNBufferLevels.h"

#include <algorithm>

namespace NBufferView
{
namespace
{
/// More levels than any window has.
constexpr int AllLevels = 32;
}

LevelInset::LevelInset(View& view)
  : Where(view)
{
  this->Size->InterpolateOff();
  this->Mapper->SetInputConnection(this->Size->GetOutputPort());
  // The values of the image are its colours.
  this->Mapper->SetColorWindow(255.0);
  this->Mapper->SetColorLevel(127.5);
  this->Inset->SetMapper(this->Mapper);
  this->Inset->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Inset->SetPosition(0.5, 0.5);
  this->Where.GetScene()->AddObserver(vtkCommand::EndEvent, this, &LevelInset::Update);
}

void LevelInset::ShowNext()
{
  this->Level = this->Level + 1 < this->Count ? this->Level + 1 : -1;
  if (this->Level < 0)
  {
    this->Count = 1;
    this->Where.GetOverlay()->RemoveViewProp(this->Inset);
  }
}

std::string LevelInset::Describe() const
{
  if (this->Level < 0)
  {
    return "";
  }
  const std::string side = std::to_string(1 << this->Level);
  return "level " + std::to_string(this->Level) + " of the N-buffer: " +
    (this->Level == 0 ? "the depth" : "the farthest in " + side + " x " + side + " pixels");
}

void LevelInset::Update()
{
  if (this->Level < 0 || !this->Where.GetOverlay()->GetDraw())
  {
    return;
  }
  vtkNBufferLevels levels;
  NBufferExamples::ReadLevels(this->Where.GetWindow(), AllLevels, levels);
  this->Count = levels.GetNumberOfLevels();
  this->Level = std::min(this->Level, this->Count - 1);
  double range[2];
  this->Where.GetScene()->GetActiveCamera()->GetClippingRange(range);
  this->Size->SetInputData(NBufferExamples::MakeLevelImage(levels, this->Level, range));
  const int* window = this->Where.GetWindow()->GetActualSize();
  this->Size->SetOutputDimensions(std::max(window[0] / 2, 1), std::max(window[1] / 2, 1), 1);
  if (!this->Where.GetOverlay()->HasViewProp(this->Inset))
  {
    this->Where.GetOverlay()->AddViewProp(this->Inset);
  }
}

} // namespace NBufferView
