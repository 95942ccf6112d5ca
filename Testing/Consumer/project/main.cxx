// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A project of its own that uses the installed module: spheres in a row, seen along it.

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNBufferCuller.h>
#include <vtkNBufferQuery.h>
#include <vtkNBufferTexture.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#ifdef CONSUMER_HAS_PARALLEL
#include <vtkNBufferParallelDepthExchange.h>
#endif

#include <cstring>
#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkRenderer> renderer;
  for (int i = 0; i < 200; ++i)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(0.0, 0.0, -i);
    renderer->AddActor(actor);
  }
  vtkNew<vtkNBufferCuller> culler;
  renderer->AddCuller(culler);
#ifdef CONSUMER_HAS_PARALLEL
  vtkNew<vtkNBufferParallelDepthExchange> exchange; // Without a controller it does nothing.
  exchange->SetRenderer(renderer);
  culler->SetDepthExchange(exchange);
#endif
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(200, 200);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 4.0);
  renderer->ResetCameraClippingRange();
  window->Render();
  std::cout << culler->GetStatisticsAsJSON() << '\n';
  vtkNew<vtkNBufferTexture> texture;
  if (!std::strstr(vtkNBufferQuery, "NBufferHides") || texture->GetNumberOfLevels() != 0)
  {
    return 1;
  }
  return culler->GetNumberOfHiddenProps() > 100 ? 0 : 1;
}
