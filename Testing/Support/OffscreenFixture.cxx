// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OffscreenFixture.h"

#include "GLErrors.h"

#include "vtkNBufferVTKVersion.h"
#include VTKNBUFFER_GL_HEADER

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOutputWindow.h"
#include "vtkRenderer.h"

#include <cstdlib>

namespace
{
/// Errors of VTK fail the test that is running; while collecting, messages are kept instead.
class TestOutput : public vtkOutputWindow
{
public:
  static TestOutput* New();
  vtkTypeMacro(TestOutput, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    if (!this->Collect(text))
    {
      ADD_FAILURE() << text;
    }
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayWarningText(const char* text) override
  {
    if (!this->Collect(text))
    {
      std::cerr << text;
    }
  }

  std::string* Messages = nullptr;

protected:
  TestOutput() = default;

private:
  bool Collect(const char* text)
  {
    if (this->Messages)
    {
      *this->Messages += text;
    }
    return this->Messages != nullptr;
  }
};
vtkStandardNewMacro(TestOutput);

TestOutput* GetOutput()
{
  static vtkSmartPointer<TestOutput> output = []
  {
    auto created = vtkSmartPointer<TestOutput>::New();
    vtkOutputWindow::SetInstance(created);
    return created;
  }();
  return output;
}

vtkSmartPointer<vtkOpenGLRenderWindow> CreateWindow(int width, int height, int multiSamples)
{
  auto base = vtkSmartPointer<vtkRenderWindow>::New();
  auto window = vtkSmartPointer<vtkOpenGLRenderWindow>(vtkOpenGLRenderWindow::SafeDownCast(base));
  if (window)
  {
    window->SetOffScreenRendering(1);
    // VTK's default is 8, which most tests do not mean.
    window->SetMultiSamples(multiSamples);
    window->SetSize(width, height);
    // Rendering without a context ends in a crash.
    window->Initialize();
    int major = 0;
    int minor = 0;
    window->GetOpenGLVersion(major, minor);
    if (major >= 3)
    {
      window->Render();
      window->MakeCurrent();
      return window;
    }
  }
  return nullptr;
}

/// Why there is no window of the class under test; empty if there is one. Asked once.
const std::string& GetReasonToSkip()
{
  static const std::string reason = []() -> std::string
  {
    if (vtkNew<vtkRenderWindow>()->IsA("vtkXOpenGLRenderWindow") && !std::getenv("DISPLAY"))
    {
      return "This VTK opens X windows only, and DISPLAY is not set.";
    }
    const char* wanted = std::getenv("VTK_DEFAULT_OPENGL_WINDOW");
    std::string found;
    std::string version;
    std::string messages = OffscreenFixture::CollectMessages(
      [&]()
      {
        auto window = CreateWindow(16, 16, 0);
        if (window)
        {
          found = window->GetClassName();
          version = OffscreenFixture::GetGLVersion();
        }
      });
    if (wanted && found != wanted && !version.empty())
    {
      return std::string(wanted) + " was asked for, VTK made " + found + ". " + messages;
    }
    if (version.empty())
    {
      return "There is no OpenGL context. " + messages;
    }
    std::cout << found << ", OpenGL " << version << "\n";
    return {};
  }();
  return reason;
}
}

vtkSmartPointer<vtkOpenGLRenderWindow> OffscreenFixture::NewWindow(
  int width, int height, int multiSamples)
{
  auto window = CreateWindow(width, height, multiSamples);
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

std::string OffscreenFixture::GetGLVersion()
{
  const GLubyte* version = glGetString(GL_VERSION);
  return version ? reinterpret_cast<const char*>(version) : "";
}

std::string OffscreenFixture::CollectMessages(const std::function<void()>& function)
{
  std::string messages;
  std::string* const outer = GetOutput()->Messages;
  GetOutput()->Messages = &messages;
  function();
  GetOutput()->Messages = outer;
  return messages;
}

void OffscreenFixture::SetUp()
{
  GetOutput();
  const std::string& reason = GetReasonToSkip();
  if (!reason.empty())
  {
    GTEST_SKIP() << reason;
  }
}

void OffscreenFixture::TearDown() {}
