// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include <vtkActor.h>
#include <vtkConeSource.h>
#include <vtkNBufferCuller.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <iostream>

int main()
{
  vtkNew<vtkConeSource> cone;
  cone->SetDirection(0.0, 0.0, 1.0);
  cone->SetRadius(0.8);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkRenderer> renderer;
  for (int i = 0; i < 10000; ++i) // 16 walls of cones, one behind the other.
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(i % 25, i / 25 % 25, i / 625 * -2);
    renderer->AddActor(actor);
  }
  vtkNew<vtkNBufferCuller> culler;
  renderer->AddCuller(culler); // Nothing else: the image stays the same, to the bit.
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  window->Render();
  std::cout << culler->GetNumberOfPropsDrawn() << " of 10000 cones drawn, "
            << culler->GetNumberOfHiddenProps() << " hidden\n";
}
