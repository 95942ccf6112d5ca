// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OffscreenFixture.h"

#include "GLErrors.h"
#include "Messages.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

vtkSmartPointer<vtkOpenGLRenderWindow> OffscreenFixture::NewWindow(
  int width, int height, int multiSamples)
{
  auto base = vtkSmartPointer<vtkRenderWindow>::New();
  vtkSmartPointer<vtkOpenGLRenderWindow> window = vtkOpenGLRenderWindow::SafeDownCast(base);
  window->SetOffScreenRendering(1);
  // VTK's default is 8, which most tests do not mean.
  window->SetMultiSamples(multiSamples);
  window->SetSize(width, height);
  window->Render();
  window->MakeCurrent();
  ReportGLErrors([](const char* text) { ADD_FAILURE() << "OpenGL error: " << text; });
  return window;
}

void OffscreenFixture::WhileDrawing(
  vtkRenderWindow* window, vtkRenderer* renderer, const std::function<void()>& function)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(const_cast<void*>(static_cast<const void*>(&function)));
  command->SetCallback([](vtkObject*, unsigned long, void* data, void*)
    { (*static_cast<const std::function<void()>*>(data))(); });
  // Between drawing and this event vtkRenderer::Render changes no GL state.
  const unsigned long tag = renderer->AddObserver(vtkCommand::EndEvent, command);
  window->Render();
  renderer->RemoveObserver(tag);
}

void OffscreenFixture::SetUp()
{
  static const std::string fault = FindWindowFault();
  ReportErrors([](const char* text) { ADD_FAILURE() << text; });
  if (!fault.empty())
  {
    GTEST_SKIP() << fault;
  }
}
