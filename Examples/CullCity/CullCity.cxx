// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CullCity.cxx
 * @brief The smallest program that culls: a city of 15,328 actors, seen from a street.
 *
 *     cull-city [picture.png]
 *
 * With a name it writes one picture and says what was drawn; without one it opens a window.
 */
#include "CameraPath.h"
#include "Scene.h"

#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkNBufferCuller.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <exception>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc > 2 || (argc == 2 && argv[1][0] == '-'))
  {
    std::cerr << "usage: cull-city [picture.png]\n";
    return 1;
  }
  try
  {
    NBufferExamples::SceneOptions options;
    options.DefaultCity = NBufferExamples::FindDefaultCity(argv[0]);
    const NBufferExamples::Scene scene = NBufferExamples::LoadScene({ "city" }, options);
    const NBufferExamples::CameraPath path = NBufferExamples::MakePath(scene, "street", 1, 1);

    vtkNew<vtkRenderer> renderer;
    scene.AddTo(renderer);

    vtkNew<vtkNBufferCuller> culler;
    renderer->AddCuller(culler);

    vtkNew<vtkRenderWindow> window;
    window->SetMultiSamples(0);
    window->SetSize(960, 720);
    window->SetWindowName("cull-city");
    window->AddRenderer(renderer);
    double bounds[6];
    scene.GetBounds().GetBounds(bounds);
    NBufferExamples::ApplyPose(path.front(), bounds, renderer);
    if (argc == 2)
    {
      window->SetOffScreenRendering(1);
      window->Render();
      vtkNew<vtkWindowToImageFilter> grab;
      grab->SetInput(window);
      grab->ReadFrontBufferOff();
      vtkNew<vtkPNGWriter> writer;
      writer->SetInputConnection(grab->GetOutputPort());
      writer->SetFileName(argv[1]);
      writer->Write();
      std::cout << culler->GetNumberOfPropsDrawn() << " of " << culler->GetNumberOfProps()
                << " props drawn, " << culler->GetNumberOfHiddenProps() << " hidden, "
                << culler->GetNumberOfPropsOutside() << " outside the view\n";
      return writer->GetErrorCode() == 0 ? 0 : 1;
    }
    vtkNew<vtkRenderWindowInteractor> interactor;
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(style);
    window->Render();
    interactor->Start();
  }
  catch (const std::exception& error)
  {
    std::cerr << "cull-city: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
