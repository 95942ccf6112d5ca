// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panel.h"

#include "vtkTextProperty.h"

#include <algorithm>

namespace NBufferView
{
namespace
{
constexpr double Margin = 8.0; // pixels
constexpr int FontSize = 15;

void SetUp(vtkTextActor* text, vtkRenderer* renderer)
{
  text->VisibilityOff();
  vtkTextProperty* font = text->GetTextProperty();
  font->SetFontFamilyToArial();
  font->SetFontSize(FontSize);
  font->SetLineSpacing(1.15);
  font->SetColor(0.08, 0.08, 0.08);
  font->SetBackgroundColor(1.0, 1.0, 1.0);
  font->SetBackgroundOpacity(0.85);
  renderer->AddViewProp(text);
}

void SetText(vtkTextActor* actor, const std::string& text)
{
  actor->SetInput(text.c_str());
  actor->SetVisibility(!text.empty());
}
}

Panel::Panel(View& view)
  : Where(view)
{
  for (vtkTextActor* text : { this->Lines.Get(), this->List.Get(), this->Label.Get() })
  {
    SetUp(text, view.GetOverlay());
  }
  this->Lines->SetPosition(Margin, Margin);
  this->List->GetTextProperty()->SetFontFamilyToCourier(); // It has columns.
  this->List->GetTextProperty()->SetVerticalJustificationToTop();
  this->List->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->List->SetPosition(0.01, 0.985);
}

void Panel::SetLines(const std::string& text)
{
  SetText(this->Lines, text);
}

void Panel::SetList(const std::string& text)
{
  SetText(this->List, text);
}

void Panel::SetLabel(const std::string& text, int x, int y)
{
  SetText(this->Label, text);
  if (text.empty())
  {
    return;
  }
  // Beside the pointer, and within the window.
  double size[2];
  this->Label->GetSize(this->Where.GetOverlay(), size);
  const int* window = this->Where.GetWindow()->GetSize();
  this->Label->SetPosition(
    std::clamp(x + 14.0, Margin, std::max(Margin, window[0] - size[0] - Margin)),
    std::clamp(y + 10.0, Margin, std::max(Margin, window[1] - size[1] - Margin)));
}

} // namespace NBufferView
