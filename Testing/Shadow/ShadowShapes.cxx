// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowShapes.h"

#include "Fill.h"
#include "NamedScenarios.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace ShadowShapes
{
vtkSmartPointer<vtkPolyData> MakeGlobe(const Point& centre, double radius, int resolution)
{
  SceneBuilder scene;
  scene.UsesDoubles = true;
  return TestScene::MakeShape(scene.Sphere(centre, radius, resolution).Shape);
}

vtkActor* AddMesh(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const int number = renderer->GetActors()->GetNumberOfItems();
  actor->GetProperty()->SetColor(
    0.4 + 0.1 * (number % 7), 0.4 + 0.1 * (number % 5), 0.4 + 0.2 * (number % 3));
  renderer->AddActor(actor);
  return actor;
}

void Fill(vtkRenderer* renderer, const std::function<void(SceneBuilder&)>& build)
{
  TestScene::Scenario scenario = TestScene::MakeShadowScenario("", build).Scenario;
  std::copy_n(renderer->GetViewport(), 4, scenario.Renderers[0].Viewport.begin());
  TestScene::Fill(renderer, scenario);
}
}
