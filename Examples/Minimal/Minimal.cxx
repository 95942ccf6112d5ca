// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkNBufferCuller.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <iostream>

int main(int argc, char*[])
{
  vtkNew<vtkConeSource> cone;
  cone->SetDirection(0.0, 0.0, 1.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkRenderer> renderer;
  for (int i = 0; i < 10000; ++i) // A field of cones, each an actor.
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(i % 100, i / 100, 0.0);
    renderer->AddActor(actor);
  }
  renderer->GetActiveCamera()->SetPosition(-3.0, -3.0, 0.2);
  renderer->GetActiveCamera()->SetFocalPoint(50.0, 50.0, 0.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkNBufferCuller> culler;
  renderer->AddCuller(culler); // Nothing else: the image stays the same, to the bit.

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  window->Render();
  std::cout << culler->GetNumberOfPropsDrawn() << " of 10000 cones drawn, "
            << culler->GetNumberOfHiddenProps() << " hidden\n";
  if (argc == 1) // With an argument the program ends after the first frame.
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    interactor->Start();
  }
}
