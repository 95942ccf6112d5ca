// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleInstances.h"

#include "VisibleProps.h"

#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <cstddef>

namespace NBufferBench
{
namespace
{
/// Lets an actor have one color everywhere, whatever the lights are.
void SetUnlit(vtkActor* actor)
{
  vtkNew<vtkProperty> property;
  property->DeepCopy(actor->GetProperty());
  property->LightingOff();
  property->SetColor(0.0, 0.0, 0.0);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  actor->SetProperty(property);
}

vtkPolyData* GetPoints(vtkGlyph3DMapper* mapper)
{
  return vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
}
}

VisibleInstances::VisibleInstances(vtkActor* actor, vtkGlyph3DMapper* mapper)
  : Actor(actor)
  , Mapper(mapper)
{
  vtkNew<vtkPolyData> numbered;
  numbered->ShallowCopy(GetPoints(mapper));
  const vtkIdType count = numbered->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("number");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType number = i + 1; // The background is 0.
    for (int k = 0; k < 3; ++k)
    {
      colors->SetTypedComponent(i, k, static_cast<unsigned char>(number >> (8 * k) & 255));
    }
  }
  numbered->GetPointData()->SetScalars(colors);
  this->Numbered = this->MakeActor(numbered);
  this->Numbered->GetMapper()->ScalarVisibilityOn();
  this->Numbered->GetMapper()->SetScalarModeToUsePointData();
  SetUnlit(this->Numbered);
}

vtkSmartPointer<vtkActor> VisibleInstances::MakeActor(vtkPolyData* points) const
{
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetSourceData(this->Mapper->GetSource());
  mapper->SetScaling(this->Mapper->GetScaling());
  mapper->SetScaleFactor(this->Mapper->GetScaleFactor());
  mapper->SetScaleMode(this->Mapper->GetScaleMode());
  mapper->SetOrient(this->Mapper->GetOrient());
  mapper->ScalarVisibilityOff();
  mapper->SetStatic(true);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->ShallowCopy(this->Actor);
  actor->SetMapper(mapper);
  return actor;
}

std::set<vtkIdType> VisibleInstances::Find(
  Session& session, const std::vector<vtkProp*>& visible) const
{
  std::vector<vtkSmartPointer<vtkActor>> copies;
  std::vector<vtkProp*> drawn;
  for (vtkProp* prop : visible)
  {
    if (prop == this->Actor)
    {
      drawn.push_back(this->Numbered);
    }
    else if (auto* actor = vtkActor::SafeDownCast(prop))
    {
      copies.push_back(vtkSmartPointer<vtkActor>::New());
      copies.back()->ShallowCopy(actor);
      SetUnlit(copies.back());
      drawn.push_back(copies.back());
    }
  }
  double background[3];
  session.GetRenderer()->GetBackground(background);
  const int samples = session.GetWindow()->GetMultiSamples();
  session.GetRenderer()->SetBackground(0.0, 0.0, 0.0);
  session.GetWindow()->SetMultiSamples(0);
  RenderOnly(session, drawn);
  const vtkSmartPointer<vtkUnsignedCharArray> pixels = session.ReadPixels();
  session.GetWindow()->SetMultiSamples(samples);
  session.GetRenderer()->SetBackground(background);

  std::set<vtkIdType> numbers;
  const unsigned char* rgba = pixels->GetPointer(0);
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i, rgba += 4)
  {
    numbers.insert(rgba[0] | rgba[1] << 8 | rgba[2] << 16);
  }
  numbers.erase(0);
  std::set<vtkIdType> instances;
  for (vtkIdType number : numbers)
  {
    instances.insert(number - 1);
  }
  return instances;
}

vtkSmartPointer<vtkActor> VisibleInstances::MakePart(const std::set<vtkIdType>& instances) const
{
  vtkPoints* all = GetPoints(this->Mapper)->GetPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(all->GetDataType());
  for (vtkIdType instance : instances)
  {
    points->InsertNextPoint(all->GetPoint(instance));
  }
  vtkNew<vtkPolyData> part;
  part->SetPoints(points);
  return this->MakeActor(part);
}

} // namespace NBufferBench
