// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowRoom.cxx
 * @brief A room lit by one point light in its middle: shadows on walls, floor and ceiling.
 *
 * Metres, z up. There is no front wall, so that one can look in.
 */
#include "Example.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkShadowVolumeClampPass.h"

int main(int argc, char* argv[])
{
  NBufferExamples::Example example("A room with furniture and one point light", "shadows");
  using Triple = NBufferExamples::Example::Triple;
  using Boxes = NBufferExamples::Example::Boxes;
  const auto show = [&]()
  {
    const Triple plaster = { 0.90, 0.86, 0.78 }, oak = { 0.68, 0.48, 0.30 };
    example.AddCuboids({ 0.72, 0.56, 0.40 }, { { { 0.0, 0.0, -0.05 }, { 5.2, 4.2, 0.1 } } });
    example.AddCuboids(plaster,
      { { { 0.0, 0.0, 2.75 }, { 5.2, 4.2, 0.1 } }, { { 0.0, 2.1, 1.35 }, { 5.2, 0.2, 2.9 } },
        { { -2.6, 0.0, 1.35 }, { 0.2, 4.2, 2.9 } }, { { 2.6, 0.0, 1.35 }, { 0.2, 4.2, 2.9 } } });
    const Boxes table = { { { 0.0, 0.0, 0.72 }, { 1.5, 0.9, 0.04 } },
      { { -0.7, -0.4, 0.35 }, { 0.05, 0.05, 0.7 } }, { { 0.7, -0.4, 0.35 }, { 0.05, 0.05, 0.7 } },
      { { -0.7, 0.4, 0.35 }, { 0.05, 0.05, 0.7 } }, { { 0.7, 0.4, 0.35 }, { 0.05, 0.05, 0.7 } } };
    example.AddCuboids(oak, table);
    const Boxes chair = { { { 0.0, 0.0, 0.45 }, { 0.42, 0.42, 0.04 } },
      { { -0.19, -0.19, 0.22 }, { 0.04, 0.04, 0.44 } },
      { { 0.19, -0.19, 0.22 }, { 0.04, 0.04, 0.44 } },
      { { -0.19, 0.19, 0.5 }, { 0.04, 0.04, 1.0 } }, { { 0.19, 0.19, 0.5 }, { 0.04, 0.04, 1.0 } },
      { { 0.0, 0.19, 0.92 }, { 0.34, 0.03, 0.12 } },
      { { 0.0, 0.19, 0.70 }, { 0.34, 0.03, 0.06 } } };
    example.AddCuboids({ 0.35, 0.53, 0.70 }, chair, -1.2, 0.1, 80.0);
    example.AddCuboids({ 0.35, 0.53, 0.70 }, chair, 1.2, -0.1, -100.0);
    example.AddCuboids({ 0.35, 0.53, 0.70 }, chair, 0.3, 0.85, 5.0);
    Boxes shelf = { { { -0.5, 0.0, 1.0 }, { 0.04, 0.3, 2.0 } },
      { { 0.5, 0.0, 1.0 }, { 0.04, 0.3, 2.0 } } };
    Boxes books;
    for (int i = 0; i < 5; ++i)
    {
      shelf.push_back({ { 0.0, 0.0, 0.1 + 0.45 * i }, { 1.0, 0.3, 0.03 } });
      books.push_back({ { 0.1 * i - 0.25, 0.0, 0.26 + 0.45 * (i % 4) }, { 0.3, 0.2, 0.28 } });
    }
    example.AddCuboids(oak, shelf, -1.4, 1.5);
    example.AddCuboids({ 0.75, 0.36, 0.30 }, books, -1.4, 1.5);
    Boxes ladder = { { { 0.0, -0.2, 1.0 }, { 0.05, 0.05, 2.0 } },
      { { 0.0, 0.2, 1.0 }, { 0.05, 0.05, 2.0 } } };
    for (int i = 1; i < 8; ++i)
    {
      ladder.push_back({ { 0.0, 0.0, 0.25 * i }, { 0.04, 0.4, 0.04 } });
    }
    example.AddCuboids({ 0.80, 0.70, 0.45 }, ladder, -2.1, -0.5, -10.0);
    // A plant, and balloons under the ceiling.
    const Triple leaf = { 0.42, 0.62, 0.36 };
    example.AddCuboids({ 0.75, 0.45, 0.32 },
      { { { 1.7, 1.2, 0.2 }, { 0.4, 0.4, 0.4 } }, { { 1.7, 1.2, 0.6 }, { 0.04, 0.04, 0.8 } } });
    example.AddGlobe({ 1.7, 1.2, 1.0 }, 0.24, leaf);
    example.AddGlobe({ 1.5, 1.2, 1.25 }, 0.16, leaf);
    example.AddGlobe({ 1.85, 1.1, 1.32 }, 0.18, leaf);
    example.AddGlobe({ 0.75, 0.5, 2.35 }, 0.16, { 0.85, 0.35, 0.30 });
    example.AddGlobe({ 1.1, 0.2, 2.2 }, 0.16, { 0.95, 0.75, 0.25 });
    example.AddGlobe({ -0.9, 0.3, 2.3 }, 0.16, { 0.40, 0.60, 0.80 });

    const Triple lamp = { 0.0, 0.0, 1.6 };
    // Translucent, because such props cast no shadow.
    vtkProperty* bulb = example.AddGlobe(lamp, 0.07, { 1.0, 1.0, 0.85 })->GetProperty();
    bulb->SetOpacity(0.99);
    bulb->LightingOff();
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->PositionalOn();
    light->SetConeAngle(180.0); // In all directions.
    light->SetPosition(lamp.data());
    light->SetColor(0.75, 0.70, 0.62);
    vtkRenderer* renderer = example.GetRenderer();
    renderer->AddLight(light);
    example.AddFill(0.2);

    vtkNew<vtkShadowVolumeClampPass> shadows;
    shadows->SetLightCasts(light, example.IsOn());
    renderer->SetPass(shadows);

    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0.0, -7.4, 1.6);
    camera->SetFocalPoint(0.0, 0.0, 1.3);
    camera->SetViewUp(0.0, 0.0, 1.0);
    renderer->ResetCameraClippingRange();
    example.Show("shadow-room", shadows);
  };
  return example.Run(argc, argv, show);
}
