// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "vtkNBufferVTKVersion.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <utility>

namespace
{
class MessageCollector : public vtkOutputWindow
{
public:
  static MessageCollector* New();
  vtkTypeMacro(MessageCollector, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Text += text; }
  void DisplayErrorText(const char* text) override
  {
    this->Report ? this->Report(text) : this->DisplayText(text);
  }
  void DisplayWarningText(const char* text) override
  {
    this->Report ? void(std::cerr << text) : this->DisplayText(text);
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }

  std::string Text;
  void (*Report)(const char*) = nullptr;
};
vtkStandardNewMacro(MessageCollector);

MessageCollector* GetCollector()
{
  static vtkSmartPointer<MessageCollector> collector;
  if (!collector)
  {
    collector = vtkSmartPointer<MessageCollector>::New();
    vtkOutputWindow::SetInstance(collector);
  }
  return collector;
}
}

std::string TakeMessages()
{
  std::string text;
  std::swap(text, GetCollector()->Text);
  return text;
}

int CountWarnings(const std::string& messages)
{
  const std::string beginning = "Warning: In ";
  int count = 0;
  for (std::size_t at = messages.find(beginning); at != std::string::npos;
       at = messages.find(beginning, at + 1))
  {
    ++count;
  }
  return count;
}

void ReportErrors(void (*report)(const char* text))
{
  GetCollector()->Report = report;
}

std::string FindWindowFault()
{
  TakeMessages();
  vtkNew<vtkRenderWindow> window;
  const char* wanted = std::getenv("VTK_DEFAULT_OPENGL_WINDOW");
  if (wanted && std::strcmp(wanted, window->GetClassName()) != 0)
  {
    return std::string(wanted) + " is not in this VTK (got " + window->GetClassName() + ")";
  }
  if (window->IsA("vtkXOpenGLRenderWindow") && !std::getenv("DISPLAY"))
  {
    return "this VTK opens X windows only, and DISPLAY is not set";
  }
  window->SetOffScreenRendering(1);
  window->SetSize(16, 16);
#if VTKNBUFFER_HAS_INITIALIZE
  window->Initialize();
#else
  window->Render();
#endif
  if (!window->SupportsOpenGL())
  {
    return std::string(window->GetClassName()) + " has no usable OpenGL: " + TakeMessages();
  }
  return "";
}
