// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels.h"

#include "vtkCamera.h"
#include "vtkImageActor.h"
#include "vtkImageMapper3D.h"
#include "vtkImageProperty.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <cmath>

namespace NBufferBench
{
namespace
{
constexpr int CaptionHeight = 36; // pixels
constexpr int Gap = 6;            // pixels
}

vtkSmartPointer<vtkImageData> ComposePanels(const std::vector<Panel>& panels, double scale)
{
  const int* size = panels.front().Image->GetDimensions();
  const int width = static_cast<int>(std::lround(scale * size[0]));
  const int height = static_cast<int>(std::lround(scale * size[1]));
  const int count = static_cast<int>(panels.size());
  const double totalWidth = count * width + (count - 1) * Gap;
  const double totalHeight = height + CaptionHeight;

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(static_cast<int>(totalWidth), static_cast<int>(totalHeight));
  vtkNew<vtkRenderer> paper;
  paper->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(paper);
  for (int i = 0; i < count; ++i)
  {
    const Panel& panel = panels[static_cast<std::size_t>(i)];
    const double left = i * (width + Gap);
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(
      left / totalWidth, CaptionHeight / totalHeight, (left + width) / totalWidth, 1.0);
    window->AddRenderer(renderer);
    vtkNew<vtkImageActor> actor;
    actor->GetMapper()->SetInputData(panel.Image);
    if (scale >= 1.0)
    {
      actor->GetProperty()->SetInterpolationTypeToNearest();
    }
    renderer->AddActor(actor);
    vtkCamera* camera = renderer->GetActiveCamera();
    const double x = 0.5 * (size[0] - 1), y = 0.5 * (size[1] - 1);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * size[1]);
    camera->SetFocalPoint(x, y, 0.0);
    camera->SetPosition(x, y, 100.0);
    camera->SetClippingRange(1.0, 200.0);

    vtkNew<vtkTextActor> caption;
    caption->SetInput(panel.Caption.c_str());
    vtkTextProperty* font = caption->GetTextProperty();
    font->SetFontFamilyToArial();
    font->SetFontSize(18);
    font->SetColor(0.1, 0.1, 0.1);
    font->SetJustificationToCentered();
    font->SetVerticalJustificationToCentered();
    caption->SetPosition(left + 0.5 * width, 0.5 * CaptionHeight);
    paper->AddViewProp(caption);
  }
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->Update();
  return grab->GetOutput();
}

} // namespace NBufferBench
