// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkPropCollection.h"

#include <chrono>
#include <filesystem>
#include <iostream>

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
  NBufferExamples::PrepareWindow(this->Window);
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

std::string Session::GetSize()
{
  const int* size = this->Window->GetActualSize();
  return std::to_string(size[0]) + "x" + std::to_string(size[1]);
}

void MakeFolder(const std::string& folder)
{
  std::filesystem::create_directories(folder);
}

} // namespace NBufferBench
