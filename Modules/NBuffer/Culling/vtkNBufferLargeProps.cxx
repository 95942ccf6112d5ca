// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferLargeProps.h"

#include "vtkNBufferBlockStream.h"
#include "vtkNBufferCandidate.h"
#include "vtkNBufferDrawPass.h"
#include "vtkNBufferForEachChild.h"
#include "vtkNBufferInstanceStream.h"
#include "vtkNBufferKnownClasses.h"
#include "vtkNBufferSplatStream.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkMapper.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Whether a plain mapper can be made to draw only some of its primitives or, for composite data,
/// only some of its blocks.
bool HasUnits(vtkMapper* mapper)
{
  return !vtkNBufferSurface::IsComposite(mapper) || vtkNBufferBlockStream::MayBeDivided(mapper);
}

/// Whether data has at least `minimum` cells. (GetNumberOfElements() of composite data counts the
/// cells of all blocks in each call, which takes milliseconds, where the first blocks may be
/// enough.)
bool HasCells(vtkDataObject* data, vtkIdType minimum)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return data->GetNumberOfElements(vtkDataObject::CELL) >= minimum;
  }
  vtkNBufferForEachChild(tree,
    [&minimum](vtkDataObject* child)
    {
      minimum -= child->GetNumberOfElements(vtkDataObject::CELL);
      return minimum > 0;
    });
  return minimum <= 0;
}
}

bool vtkNBufferLargeProps::IsLarge(vtkProp* prop, int minimum)
{
  vtkActor* actor = vtkNBufferKnownClasses::GetPlainActor(prop);
  if (actor &&
    (vtkNBufferInstanceStream::MayBeDivided(actor, false) ||
      vtkNBufferInstanceStream::MayBeDivided(actor, true)))
  {
    return vtkNBufferInstanceStream::CountPolygons(actor) >= minimum;
  }
  if (actor && vtkNBufferSplatStream::DrawsSplats(actor))
  {
    return vtkNBufferSplatStream::GetData(actor)->GetNumberOfPoints() >= minimum;
  }
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper || !vtkNBufferKnownClasses::HaveKnownTimes(actor) ||
    mapper->GetNumberOfInputConnections(0) == 0 || !HasUnits(mapper))
  {
    return false;
  }
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  return data && HasCells(data, minimum);
}

bool vtkNBufferLargeProps::MayBeDivided(const vtkNBufferCandidate& candidate)
{
  vtkActor* actor = vtkNBufferKnownClasses::GetPlainActor(candidate.GetProp());
  if (!actor || !actor->GetMapper() || vtkNBufferDrawPass::IsKeptWhole(actor->GetMapper()))
  {
    return false;
  }
  // VTK does not know the bounds of instances and splats.
  if (candidate.GetVerdict() == vtkNBufferVerdict::NotAPlainMapper)
  {
    return vtkNBufferInstanceStream::MayBeDivided(actor, false) ||
      vtkNBufferSplatStream::MayBeDivided(actor);
  }
  // Translucent composite data may have opaque blocks.
  return (candidate.IsCandidate() || candidate.IsTranslucent()) && HasUnits(actor->GetMapper()) &&
    !(candidate.IsTranslucent() && vtkNBufferSurface::IsComposite(actor->GetMapper()));
}
VTK_ABI_NAMESPACE_END
