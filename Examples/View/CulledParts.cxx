// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CulledParts.h"

#include "vtkCommand.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyDataMapper.h"

namespace NBufferView
{

CulledParts::CulledParts(View& view, Comparison& comparison, const NBufferExamples::Scene& scene)
  : Where(view)
  , Culling(comparison)
  , Parts(scene)
  , Marks(scene.Actors.size())
{
  this->Red->SetColor(0.90, 0.10, 0.08);
  this->Red->SetAmbient(0.35);
  this->Red->SetDiffuse(0.65);
  this->Where.GetMarks()->AddObserver(vtkCommand::StartEvent, this, &CulledParts::Update);
}

void CulledParts::SetShown(bool shown)
{
  this->Shown = shown;
}

void CulledParts::Update()
{
  const bool isFrozen = this->Culling.GetCuller()->GetFreeze();
  // From the view that was tested the hidden parts are seen only through the others. From elsewhere
  // they are seen as what is missing.
  this->Red->SetOpacity(isFrozen ? 1.0 : 0.4);
  this->Where.GetMarks()->SetPreserveDepthBuffer(isFrozen);
  this->Count = 0;
  const bool isOn = this->Shown && this->Culling.IsCulling();
  for (std::size_t part = 0; part < this->Marks.size(); ++part)
  {
    const bool isHidden = isOn &&
      this->Culling.GetCuller()->GetVerdict(this->Parts.Actors[part], this->Where.GetScene()) ==
        vtkNBufferVerdict::Hidden;
    if (isHidden)
    {
      this->GetMark(part)->VisibilityOn();
      ++this->Count;
    }
    else if (this->Marks[part])
    {
      this->Marks[part]->VisibilityOff();
    }
  }
}

vtkActor* CulledParts::GetMark(std::size_t part)
{
  vtkSmartPointer<vtkActor>& mark = this->Marks[part];
  if (!mark)
  {
    // A mapper of its own, because colours of the data would cover the red.
    vtkActor* original = this->Parts.Actors[part];
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputDataObject(original->GetMapper()->GetInputDataObject(0, 0));
    mapper->ScalarVisibilityOff();
    mark = vtkSmartPointer<vtkActor>::New();
    mark->SetMapper(mapper);
    mark->SetProperty(this->Red);
    vtkNew<vtkMatrix4x4> matrix;
    matrix->DeepCopy(original->GetMatrix());
    mark->SetUserMatrix(matrix);
    this->Where.GetMarks()->AddActor(mark);
  }
  return mark;
}

} // namespace NBufferView
