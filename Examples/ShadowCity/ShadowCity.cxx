// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowCity.cxx
 * @brief The shadows of a city on 21 June, from a bird's eye view.
 *
 *     shadow-city [--out FOLDER]
 *
 * Opens a window at 9 in the morning, solar time (Sun.h has the formula); the left and right arrow
 * keys go half an hour back and on. With --out it writes pictures of every second hour from 5 to 19
 * o'clock, FOLDER/shadow-city-05.png and so on.
 */
#include "CameraPath.h"
#include "Scene.h"
#include "Sun.h"

#include "vtkCallbackCommand.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkShadowVolumeClampPass.h"
#include "vtkWindowToImageFilter.h"

#include <vtksys/SystemTools.hxx>

#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  if (argc != 1 && (argc != 3 || std::string(argv[1]) != "--out"))
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
    NBufferExamples::LightGround(scene);
    vtkNew<vtkRenderer> renderer;
    scene.AddTo(renderer);

    NBufferExamples::SunTime time;
    const vtkSmartPointer<vtkLight> sun = NBufferExamples::MakeSun(time);
    renderer->RemoveAllLights();
    renderer->AddLight(sun);

    vtkNew<vtkShadowVolumeClampPass> shadows;
    renderer->SetPass(shadows);

    vtkNew<vtkRenderWindow> window;
    window->SetMultiSamples(0);
    window->SetSize(960, 720);
    window->SetWindowName("shadow-city");
    window->AddRenderer(renderer);
    double bounds[6];
    scene.GetBounds().GetBounds(bounds);
    NBufferExamples::ApplyPose(path.front(), bounds, renderer);
    if (argc == 3)
    {
      vtksys::SystemTools::MakeDirectory(argv[2]);
      window->SetOffScreenRendering(1);
      for (time.Hour = 5.0; time.Hour <= 19.0; time.Hour += 2.0)
      {
        NBufferExamples::SetSun(time, sun);
        window->Render();
        vtkNew<vtkWindowToImageFilter> grab;
        grab->SetInput(window);
        grab->ReadFrontBufferOff();
        char name[32];
        std::snprintf(name, sizeof(name), "/shadow-city-%02d.png", static_cast<int>(time.Hour));
        vtkNew<vtkPNGWriter> writer;
        writer->SetInputConnection(grab->GetOutputPort());
        writer->SetFileName((argv[2] + std::string(name)).c_str());
        writer->Write();
        std::cout << time.Hour << " o'clock: " << shadows->GetStatistics().Casters
                  << " casters, shadows drawn in " << shadows->GetStatistics().Draws << " draws\n";
        if (writer->GetErrorCode() != 0)
        {
          return 1;
        }
      }
      return 0;
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "shadow-city: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
