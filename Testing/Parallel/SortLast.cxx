// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SortLast.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <ctime>

double GetProcessTime()
{
  return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void SortLast::Attach(vtkRenderer* renderer, vtkMultiProcessController* controller)
{
  this->Renderer = renderer;
  this->Controller = controller;
  renderer->AddObserver(vtkCommand::StartEvent, this);
  renderer->AddObserver(vtkCommand::EndEvent, this);
}

void SortLast::Execute(vtkObject*, unsigned long event, void*)
{
  if (!this->ParallelRendering)
  {
    return;
  }
  if (event == vtkCommand::StartEvent)
  {
    this->SendCamera();
    this->Time = GetProcessTime();
  }
  else
  {
    this->Renderer->GetRenderWindow()->WaitForCompletion();
    this->Time = GetProcessTime() - this->Time;
    this->Composite();
  }
}

void SortLast::SendCamera()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  double values[12];
  camera->GetPosition(values);
  camera->GetFocalPoint(values + 3);
  camera->GetViewUp(values + 6);
  camera->GetClippingRange(values + 9);
  values[11] = camera->GetViewAngle();
  this->Controller->Broadcast(values, 12, 0);
  camera->SetPosition(values);
  camera->SetFocalPoint(values + 3);
  camera->SetViewUp(values + 6);
  camera->SetClippingRange(values + 9);
  camera->SetViewAngle(values[11]);
}

void SortLast::Composite()
{
  vtkRenderWindow* window = this->Renderer->GetRenderWindow();
  const int* size = window->GetSize();
  const vtkIdType pixels = static_cast<vtkIdType>(size[0]) * size[1];
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkFloatArray> depths;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, colors);
  window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths);
  const int ranks = this->Controller->GetNumberOfProcesses();
  const bool isFirst = this->Controller->GetLocalProcessId() == 0;
  std::vector<unsigned char> allColors(isFirst ? 4 * pixels * ranks : 0);
  std::vector<float> allDepths(isFirst ? pixels * ranks : 0);
  this->Controller->Gather(colors->GetPointer(0), allColors.data(), 4 * pixels, 0);
  this->Controller->Gather(depths->GetPointer(0), allDepths.data(), pixels, 0);
  if (!isFirst)
  {
    return;
  }
  std::copy(size, size + 2, this->Picture.Size);
  this->Picture.Colors.assign(allColors.begin(), allColors.begin() + 4 * pixels);
  this->Picture.Depths.assign(allDepths.begin(), allDepths.begin() + pixels);
  for (int rank = 1; rank < ranks; ++rank)
  {
    for (vtkIdType i = 0; i < pixels; ++i)
    {
      const vtkIdType other = rank * pixels + i;
      if (allDepths[other] < this->Picture.Depths[i])
      {
        this->Picture.Depths[i] = allDepths[other];
        std::copy_n(&allColors[4 * other], 4, &this->Picture.Colors[4 * i]);
      }
    }
  }
}
