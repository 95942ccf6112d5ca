// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CulledParts.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <functional>

namespace NBufferView
{
namespace
{
constexpr const char* MaskName = "hidden";

/// Whether a part of a prop, given by its number, is hidden.
using Test = std::function<bool(int)>;

/// A mapper that draws the instances of another one for which its input has a mask of 1.
vtkSmartPointer<vtkMapper> MakeMaskedGlyphs(vtkGlyph3DMapper* original)
{
  auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetSourceData(vtkPolyData::SafeDownCast(original->GetInputDataObject(1, 0)));
  mapper->SetScaling(original->GetScaling());
  mapper->SetScaleMode(original->GetScaleMode());
  mapper->SetScaleFactor(original->GetScaleFactor());
  mapper->SetClamping(original->GetClamping());
  mapper->SetRange(original->GetRange());
  mapper->SetOrient(original->GetOrient());
  mapper->SetOrientationMode(original->GetOrientationMode());
  for (const int array : { vtkGlyph3DMapper::SCALE, vtkGlyph3DMapper::ORIENTATION })
  {
    mapper->SetInputArrayToProcess(array, original->GetInputArrayInformation(array));
  }
  mapper->SetMaskArray(MaskName);
  mapper->MaskingOn();
  return mapper;
}

/// Give a mapper of masked glyphs the points of `data`. Returns how many are hidden.
int MarkInstances(vtkDataSet* data, const Test& isHidden, vtkMapper* mapper)
{
  vtkNew<vtkBitArray> mask;
  mask->SetName(MaskName);
  int count = 0;
  for (int point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    const bool hidden = isHidden(point);
    mask->InsertNextValue(hidden ? 1 : 0);
    count += hidden;
  }
  const auto masked = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  masked->ShallowCopy(data);
  masked->GetPointData()->AddArray(mask);
  mapper->SetInputDataObject(0, masked);
  return count;
}

/// Give a mapper the cells of `data` that are hidden. Returns their number. The culler numbers the
/// triangles of which a polygon is made, and the points of a cell of vertices.
int MarkCells(vtkPolyData* data, const Test& isHidden, vtkMapper* mapper)
{
  const bool isSurface = data->GetNumberOfPolys() > 0;
  vtkCellArray* cells = isSurface ? data->GetPolys() : data->GetVerts();
  vtkNew<vtkCellArray> marked;
  int begin = 0;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(cell, size, points);
    const int end = begin + static_cast<int>(std::max<vtkIdType>(isSurface ? size - 2 : size, 0));
    bool hidden = begin < end;
    for (; begin < end; ++begin)
    {
      hidden = hidden && isHidden(begin);
    }
    if (hidden)
    {
      marked->InsertNextCell(size, points);
    }
  }
  vtkNew<vtkPolyData> part;
  part->SetPoints(data->GetPoints());
  part->GetPointData()->SetNormals(data->GetPointData()->GetNormals());
  part->SetPolys(isSurface ? marked.Get() : nullptr);
  part->SetVerts(isSurface ? nullptr : marked.Get());
  mapper->SetInputDataObject(0, part);
  return static_cast<int>(marked->GetNumberOfCells());
}
}

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
    const int count = isOn ? this->Mark(part) : 0;
    if (this->Marks[part])
    {
      this->Marks[part]->SetVisibility(count > 0);
    }
    this->Count += count;
  }
}

int CulledParts::Mark(std::size_t part)
{
  vtkNBufferCuller* culler = this->Culling.GetCuller();
  vtkActor* original = this->Parts.Actors[part];
  vtkDataObject* input = original->GetMapper()->GetInputDataObject(0, 0);
  const bool isGlyphs = original->GetMapper()->IsA("vtkGlyph3DMapper");
  auto* mesh = isGlyphs ? nullptr : vtkPolyData::SafeDownCast(input);
  const bool isLarge =
    mesh && mesh->GetNumberOfCells() >= culler->GetTuning().MinimumNumberOfPrimitives;
  if (isGlyphs || isLarge)
  {
    vtkMapper* mapper = this->GetMark(part)->GetMapper();
    const auto isHidden = [&](int number)
    {
      return culler->GetVerdict(original, number, this->Where.GetScene()) ==
        vtkNBufferVerdict::Hidden;
    };
    return isLarge ? MarkCells(mesh, isHidden, mapper)
                   : MarkInstances(vtkDataSet::SafeDownCast(input), isHidden, mapper);
  }
  if (culler->GetVerdict(original, this->Where.GetScene()) != vtkNBufferVerdict::Hidden)
  {
    return 0;
  }
  this->GetMark(part);
  return 1;
}

vtkActor* CulledParts::GetMark(std::size_t part)
{
  vtkSmartPointer<vtkActor>& mark = this->Marks[part];
  if (!mark)
  {
    // A mapper of its own, because colours of the data would cover the red.
    vtkActor* original = this->Parts.Actors[part];
    auto* glyphs = vtkGlyph3DMapper::SafeDownCast(original->GetMapper());
    vtkSmartPointer<vtkMapper> mapper = glyphs
      ? MakeMaskedGlyphs(glyphs)
      : vtkSmartPointer<vtkMapper>(vtkSmartPointer<vtkPolyDataMapper>::New());
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
