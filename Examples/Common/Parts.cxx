// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parts.h"

#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkProperty.h"

namespace NBufferExamples
{

vtkSmartPointer<vtkPolyDataMapper> MakePartMapper(vtkPolyData* data)
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  return mapper;
}

vtkSmartPointer<vtkPolyDataMapper> MakePartMapper(vtkPolyDataAlgorithm* source)
{
  source->Update();
  return MakePartMapper(source->GetOutput());
}

void PaintPart(vtkActor* actor, std::size_t number, double value)
{
  const double hue = 0.08 + 0.61803398875 * static_cast<double>(number);
  double color[3];
  vtkMath::HSVToRGB(hue - static_cast<int>(hue), 0.35, value, &color[0], &color[1], &color[2]);
  actor->GetProperty()->SetColor(color);
}

vtkActor* AddPart(Scene& scene, vtkPolyDataMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  PaintPart(actor, scene.Actors.size());
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.65);
  scene.Actors.push_back(actor);
  return actor;
}

vtkActor* AddPart(
  Scene& scene, vtkPolyDataMapper* mapper, const glm::dvec3& place, const glm::dvec3& size)
{
  vtkActor* actor = AddPart(scene, mapper);
  actor->SetPosition(place.x, place.y, place.z);
  actor->SetScale(size.x, size.y, size.z);
  return actor;
}

} // namespace NBufferExamples
