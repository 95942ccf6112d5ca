// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkErrorCode.h"
#include "vtkImageExtractComponents.h"
#include "vtkNBufferVTKVersion.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"

#include <chrono>
#include <filesystem>
#include <iostream>
#include <regex>
#include <stdexcept>

namespace NBufferBench
{

void ShowProgress(const std::string& text)
{
  static std::chrono::steady_clock::time_point last;
  const auto now = std::chrono::steady_clock::now();
  if (now - last > std::chrono::seconds(5))
  {
    std::cerr << text << std::endl;
    last = now;
  }
}

Session::Session(const NBufferExamples::Scene& scene, const SessionOptions& options)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(options.Samples);
  this->Window->SetSize(options.Size[0], options.Size[1]);
  this->Window->AddRenderer(this->Renderer);
  scene.AddTo(this->Renderer);
  scene.GetBounds().GetBounds(this->Bounds);

  // The context is made now, so that its time is not part of the first frame.
#if VTKNBUFFER_HAS_INITIALIZE
  this->Window->Initialize();
#else
  this->Renderer->DrawOff();
  this->Window->Render();
  this->Renderer->DrawOn();
#endif
  if (this->GetDevice().empty())
  {
    throw std::runtime_error("no OpenGL in a " + this->GetWindowClass() +
      "; VTK_DEFAULT_OPENGL_WINDOW may name another class of windows");
  }
}

Session& Session::New(const NBufferExamples::Scene& scene, const SessionOptions& options)
{
  return *new Session(scene, options);
}

std::vector<vtkProp*> Session::GetProps()
{
  std::vector<vtkProp*> props;
  vtkPropCollection* list = this->Renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  list->InitTraversal(iterator);
  while (vtkProp* prop = list->GetNextProp(iterator))
  {
    props.push_back(prop);
  }
  return props;
}

void Session::SetCuller(vtkCuller* culler)
{
  this->Renderer->GetCullers()->RemoveAllItems();
  if (culler)
  {
    this->Renderer->AddCuller(culler);
  }
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

vtkSmartPointer<vtkUnsignedCharArray> Session::ReadPixels()
{
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  const int* size = this->Window->GetActualSize();
  // The front buffer was shown, so that its samples, if there are any, are resolved.
  this->Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  return pixels;
}

vtkSmartPointer<vtkImageData> Session::MakeImage(vtkUnsignedCharArray* rgba)
{
  const int* size = this->Window->GetActualSize();
  vtkNew<vtkImageData> image;
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->SetScalars(rgba);
  vtkNew<vtkImageExtractComponents> colors;
  colors->SetInputData(image);
  colors->SetComponents(0, 1, 2);
  colors->Update();
  return colors->GetOutput();
}

std::string Session::GetDevice()
{
  const char* text = this->Window->ReportCapabilities();
  std::cmatch found;
  const bool isNamed =
    text && std::regex_search(text, found, std::regex("OpenGL renderer string: *(.*)"));
  return isNamed ? found[1].str() : std::string();
}

std::string Session::GetSize()
{
  const int* size = this->Window->GetActualSize();
  return std::to_string(size[0]) + "x" + std::to_string(size[1]);
}

void WritePNG(vtkImageData* image, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(image);
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

void MakeFolder(const std::string& folder)
{
  std::filesystem::create_directories(folder);
}

} // namespace NBufferBench
