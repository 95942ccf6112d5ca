// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include "vtkCamera.h"
#include "vtkNBufferVTKVersion.h"

#include <vtksys/SystemTools.hxx>

#include <chrono>
#include <sstream>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
const char* GetClassOf(const std::string& window)
{
  if (window == "osmesa")
  {
    return "vtkOSOpenGLRenderWindow";
  }
  if (window == "egl")
  {
    return "vtkEGLRenderWindow";
  }
  if (window == "glx")
  {
    return "vtkXOpenGLRenderWindow";
  }
  return nullptr;
}
}

void ChooseWindowSystem(const std::string& system)
{
  if (const char* name = GetClassOf(system))
  {
    vtksys::SystemTools::PutEnv(std::string("VTK_DEFAULT_OPENGL_WINDOW=") + name);
  }
}

Session::Session(const NBufferExamples::Scene& scene, const SessionOptions& options)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(options.Samples);
  this->Window->SetSize(options.Width, options.Height);
  this->Window->AddRenderer(this->Renderer);
  scene.AddTo(this->Renderer);
  scene.GetBounds().GetBounds(this->Bounds);

  // The context now, so that the first frame does not pay for it.
#if VTKNBUFFER_HAS_INITIALIZE
  this->Window->Initialize();
#else
  this->Renderer->DrawOff();
  this->Window->Render();
  this->Renderer->DrawOn();
#endif
  const std::string device = this->GetDevice();
  const char* wanted = GetClassOf(options.Window);
  if (device.empty() || (wanted && !this->Window->IsA(wanted)))
  {
    throw std::runtime_error("no OpenGL by the window system " + options.Window + " (got " +
      this->GetWindowClass() + (device.empty() ? " without a context)" : ")"));
  }
}

Session& Session::New(const NBufferExamples::Scene& scene, const SessionOptions& options)
{
  ChooseWindowSystem(options.Window);
  return *new Session(scene, options);
}

void Session::SetPose(const NBufferExamples::CameraPose& pose)
{
  NBufferExamples::ApplyPose(pose, this->Bounds, this->Renderer);
  this->Renderer->GetActiveCamera()->Modified();
}

double Session::Render()
{
  const auto begin = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  const auto end = std::chrono::steady_clock::now();
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

void Session::ReadPixels(vtkUnsignedCharArray* pixels)
{
  const int* size = this->Window->GetActualSize();
  // The front buffer is the one that was shown, resolved if there are samples.
  this->Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
}

std::string Session::GetDevice()
{
  const char* text = this->Window->ReportCapabilities();
  std::istringstream lines(text ? text : "");
  const std::string key = "OpenGL renderer string:";
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t at = line.find(key);
    if (at != std::string::npos)
    {
      const std::size_t begin = line.find_first_not_of(' ', at + key.size());
      return begin == std::string::npos ? std::string() : line.substr(begin);
    }
  }
  return std::string();
}

std::string Session::GetWindowClass()
{
  return this->Window->GetClassName();
}

std::string Session::GetSize()
{
  const int* size = this->Window->GetActualSize();
  return std::to_string(size[0]) + "x" + std::to_string(size[1]);
}

} // namespace NBufferBench
