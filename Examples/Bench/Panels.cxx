// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels.h"

#include "Frames.h"

#include "vtkCamera.h"
#include "vtkImageActor.h"
#include "vtkImageMapper3D.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <cmath>

namespace NBufferBench
{

vtkSmartPointer<vtkImageData> ComposePanels(const std::vector<Panel>& panels, double scale)
{
  constexpr int captionHeight = 36; // pixels
  constexpr int gap = 6;            // pixels
  const int* size = panels.front().Picture->GetDimensions();
  const auto width = static_cast<int>(std::lround(scale * size[0]));
  const int height = static_cast<int>(std::lround(scale * size[1])) + captionHeight;
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  int left = 0; // pixels
  for (const Panel& panel : panels)
  {
    vtkNew<vtkImageActor> actor;
    actor->GetMapper()->SetInputData(panel.Picture);
    actor->SetPosition(left / scale, 0.0, 0.0);
    renderer->AddActor(actor);
    vtkNew<vtkTextActor> caption;
    caption->SetInput(panel.Caption.c_str());
    caption->SetPosition(left + 0.5 * width, 0.5 * captionHeight);
    vtkTextProperty* font = caption->GetTextProperty();
    font->SetFontFamilyToArial();
    font->SetFontSize(18);
    font->SetColor(0.1, 0.1, 0.1);
    font->SetJustificationToCentered();
    font->SetVerticalJustificationToCentered();
    renderer->AddViewProp(caption);
    left += width + gap;
  }
  const int total = left - gap;
  // The unit of the world is a pixel of the images, whose pixels have their centres at 0, 1, 2, ...
  const double center[2] = { 0.5 * (total / scale - 1.0),
    0.5 * (size[1] - 1 - captionHeight / scale) };
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * height / scale);
  camera->SetFocalPoint(center[0], center[1], 0.0);
  camera->SetPosition(center[0], center[1], 100.0);
  camera->SetClippingRange(1.0, 200.0);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(total, height);
  window->AddRenderer(renderer);
  window->Render();
  return NBufferExamples::MakeColorImage(window, NBufferExamples::GrabPixels(window));
}

} // namespace NBufferBench
