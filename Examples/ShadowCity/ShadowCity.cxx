// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowCity.cxx
 * @brief `shadow-city [--out FOLDER]`: the shadows of a city at 9 in the morning of 21 June.
 *
 * Opens a window; with --out it writes a picture for every second hour from 5 to 19 o'clock to
 * FOLDER/shadow-city-05.png and so on. Solar time; Sun.h has the formula.
 */
#include "CameraPath.h"
#include "Scene.h"
#include "Sun.h"

#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkShadowVolumeClampPass.h"
#include "vtkWindowToImageFilter.h"

#include <vtksys/SystemTools.hxx>

#include <exception>
#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  const bool toFiles = argc == 3 && std::string(argv[1]) == "--out";
  if (argc != 1 && !toFiles)
  {
    std::cerr << "usage: shadow-city [--out FOLDER]\n";
    return 1;
  }
  try
  {
    NBufferExamples::SceneOptions options;
    options.DefaultCity = NBufferExamples::FindDefaultCity(argv[0]);
    const NBufferExamples::Scene scene = NBufferExamples::LoadScene({ "city" }, options);
    const NBufferExamples::CameraPath path = NBufferExamples::MakePath(scene, "rooftop", 1, 1);
    vtkNew<vtkRenderer> renderer;
    scene.AddTo(renderer);
    NBufferExamples::LightGround(scene);
    NBufferExamples::SunTime time;
    const vtkSmartPointer<vtkLight> sun = NBufferExamples::MakeSun(time);
    renderer->RemoveAllLights();
    renderer->AddLight(sun);

    vtkNew<vtkShadowVolumeClampPass> shadows;
    renderer->SetPass(shadows);

    vtkNew<vtkRenderWindow> window;
    window->SetMultiSamples(0);
    window->SetSize(960, 720);
    window->AddRenderer(renderer);
    double bounds[6];
    scene.GetBounds().GetBounds(bounds);
    NBufferExamples::ApplyPose(path.front(), bounds, renderer);
    if (!toFiles)
    {
      vtkNew<vtkRenderWindowInteractor> interactor;
      interactor->SetRenderWindow(window);
      window->Render();
      interactor->Start();
      return 0;
    }
    vtksys::SystemTools::MakeDirectory(argv[2]);
    window->SetOffScreenRendering(1);
    for (int hour = 5; hour < 20; hour += 2)
    {
      time.Hour = hour;
      NBufferExamples::SetSun(time, sun);
      window->Render();
      vtkNew<vtkWindowToImageFilter> grab;
      grab->SetInput(window);
      grab->ReadFrontBufferOff();
      vtkNew<vtkPNGWriter> writer;
      const std::string name =
        (hour < 10 ? "/shadow-city-0" : "/shadow-city-") + std::to_string(hour);
      writer->SetInputConnection(grab->GetOutputPort());
      writer->SetFileName((argv[2] + name + ".png").c_str());
      writer->Write();
      const vtkShadowStatistics& statistics = shadows->GetStatistics();
      std::cout << hour << " o'clock: the shadows of " << statistics.Draws << " of "
                << statistics.Casters << " casters drawn\n";
      if (writer->GetErrorCode() != 0 || statistics.Decision != vtkShadowDecision::Drawn)
      {
        return 1;
      }
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "shadow-city: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
