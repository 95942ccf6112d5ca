// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowCity.cxx
 * @brief The shadows of a city at 9 in the morning of 21 June, or at any other time of the year.
 *
 *     shadow-city --out pictures --hour 5 --until 19 --step 2
 *
 * writes pictures/shadow-city-0500.png, shadow-city-0700.png and so on. Hours are those of the sun,
 * which stands in the south at 12; Sun.h has the formula.
 */
#include "CameraPath.h"
#include "Example.h"
#include "LoadScene.h"
#include "Sun.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkShadowVolumeClampPass.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

int main(int argc, char* argv[])
{
  NBufferExamples::Example example("The shadows of a city through a day", "shadows");
  NBufferExamples::SunTime time;
  double until = 0.0;
  double step = 1.0;
  example.AddOption("--hour", time.Hour, "Of the first picture, solar time", 0.0, 24.0);
  example.AddOption("--until", until, "Hour of the last picture; 0 for only one", 0.0, 24.0);
  example.AddOption("--step", step, "Hours from picture to picture", 1.0 / 60.0, 24.0);
  example.AddOption("--day", time.Day, "Of the year; 172 is 21 June", 1, 366);
  const auto show = [&]()
  {
    std::vector<NBufferExamples::SunTime> times = { time };
    while (time.Hour + step <= until + 1e-4) // Half a second for rounding.
    {
      time.Hour += step;
      times.push_back(time);
    }
    for (const NBufferExamples::SunTime& each : times)
    {
      if (NBufferExamples::GetDirectionToSun(each).z <= 0.0)
      {
        throw std::runtime_error("the sun is below the horizon; take other hours");
      }
    }

    const NBufferExamples::Scene city = NBufferExamples::LoadScene({ "city" }, { argv[0] });
    vtkRenderer* renderer = example.GetRenderer();
    city.AddTo(renderer);
    NBufferExamples::LightGround(city);

    renderer->RemoveAllLights();
    const vtkSmartPointer<vtkLight> sun = NBufferExamples::MakeSun(times.front());
    renderer->AddLight(sun);
    example.AddFill(0.2);

    // The ground and the streets, which have nothing below them, need not cast.
    vtkInformationIntegerKey* casts = vtkInformationIntegerKey::MakeKey("Casts", "ShadowCity");
    for (std::size_t i = 0; i < city.Plan->Buildings.size(); ++i)
    {
      vtkNew<vtkInformation> keys;
      keys->Set(casts, 1);
      city.Actors[i]->SetPropertyKeys(keys);
    }
    vtkNew<vtkInformation> required;
    required->Set(casts, 1);

    vtkNew<vtkShadowVolumeClampPass> shadows;
    shadows->SetCasterKeys(required);
    shadows->SetLightCasts(sun, example.IsOn());
    renderer->SetPass(shadows);

    double bounds[6];
    city.GetBounds().GetBounds(bounds);
    const NBufferExamples::CameraPose overTheOldTown{ { -120.0, 3720.0, 230.0 },
      { 260.0, 3400.0, 20.0 }, { 0.0, 0.0, 1.0 } };
    NBufferExamples::ApplyPose(overTheOldTown, bounds, renderer);
    for (const NBufferExamples::SunTime& each : times)
    {
      NBufferExamples::SetSun(each, sun);
      const long minutes = std::lround(60.0 * each.Hour);
      char name[40];
      std::snprintf(name, sizeof(name), "shadow-city-%02ld%02ld", minutes / 60, minutes % 60);
      example.Show(name, shadows);
    }
  };
  return example.Run(argc, argv, show);
}
