// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferScalars.h"

#include "vtkNBufferForEachChild.h"
#include "vtkNBufferProtectedMembers.h"
#include "vtkNBufferSurface.h"

#include "vtkAbstractArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkScalarsToColors.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The scalars that a mapper maps of a data set, or nullptr.
vtkAbstractArray* GetScalars(vtkMapper* mapper, vtkDataObject* data)
{
  int isCellArray = 0;
  return mapper->GetScalarVisibility()
    ? vtkAbstractMapper::GetAbstractScalars(vtkDataSet::SafeDownCast(data), mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), isCellArray)
    : nullptr;
}

#if VTKNBUFFER_HAS_BLOCK_SCALARS
/// The attributes of the blocks of composite data, or nullptr.
vtkCompositeDataDisplayAttributes* GetAttributes(vtkMapper* mapper)
{
  auto* composite = vtkCompositePolyDataMapper::SafeDownCast(mapper);
  return composite ? composite->GetCompositeDataDisplayAttributes() : nullptr;
}

/// Whether blocks of composite data have tables, or ranges, of their own.
bool HasBlocksWithTables(vtkMapper* mapper)
{
  auto* attributes = GetAttributes(mapper);
  return attributes &&
    (attributes->HasBlockLookupTables() || attributes->HasBlockScalarRanges() ||
      attributes->HasBlockUseLookupTableScalarRanges());
}

/// Whether blocks of composite data choose their scalars, which GetScalars() does not find then.
bool HasBlocksWithScalars(vtkMapper* mapper)
{
  auto* attributes = GetAttributes(mapper);
  return attributes &&
    (attributes->HasBlockScalarVisibilities() || attributes->HasBlockScalarModes() ||
      attributes->HasBlockArrayAccessModes() || attributes->HasBlockArrayIds() ||
      attributes->HasBlockArrayNames());
}

/// The table of a block of its own, or nullptr.
vtkScalarsToColors* GetBlockTable(vtkMapper* mapper, vtkDataObject* block)
{
  auto* attributes = GetAttributes(mapper);
  return attributes ? attributes->GetBlockLookupTable(block).Get() : nullptr;
}
#else
bool HasBlocksWithTables(vtkMapper*)
{
  return false;
}

bool HasBlocksWithScalars(vtkMapper*)
{
  return false;
}

vtkScalarsToColors* GetBlockTable(vtkMapper*, vtkDataObject*)
{
  return nullptr;
}
#endif

vtkScalarsToColors* GetTable(vtkMapper* mapper, vtkAbstractArray* scalars)
{
  auto* array = vtkDataArray::SafeDownCast(scalars);
  return array && array->GetLookupTable() ? array->GetLookupTable()
                                          : vtkNBufferProtectedMembers::GetLookupTable(mapper);
}

/// Whether a mapper may map scalars.
bool MapsScalars(vtkMapper* mapper)
{
  return mapper->GetScalarVisibility() || HasBlocksWithScalars(mapper);
}

/// Whether a table has colors with an alpha below 1 that its IsOpaque() does not look at.
bool HasFaintColors(vtkScalarsToColors* table)
{
  auto* function = vtkColorTransferFunction::SafeDownCast(table);
  bool isFaint = function && function->GetNanOpacity() < 1.0;
  for (vtkIdType i = 0; function && i < function->GetNumberOfAnnotatedValues(); ++i)
  {
    double color[4];
    function->GetIndexedColor(i, color);
    isFaint = isFaint || color[3] < 1.0;
  }
  return isFaint;
}
}

vtkScalarsToColors* vtkNBufferScalars::GetLookupTable(vtkMapper* mapper)
{
  return MapsScalars(mapper) ? GetTable(mapper, GetScalars(mapper, mapper->GetInput())) : nullptr;
}

bool vtkNBufferScalars::ChangeTable(vtkMapper* mapper)
{
  if (!MapsScalars(mapper))
  {
    return false;
  }
  vtkScalarsToColors* table = GetLookupTable(mapper);
  if (table != vtkNBufferProtectedMembers::GetLookupTable(mapper) || HasBlocksWithTables(mapper))
  {
    return true;
  }
  // Without a table, VTK makes one that no other object can know. A color transfer function has the
  // range of its nodes.
  return table && !mapper->GetUseLookupTableScalarRange() &&
    !vtkColorTransferFunction::SafeDownCast(table) &&
    !std::equal(table->GetRange(), table->GetRange() + 2, mapper->GetScalarRange()) &&
    (HasBlocksWithScalars(mapper) ||
      vtkNBufferAnyNode(mapper->GetInputDataObject(0, 0),
        [mapper](vtkDataObject* data) { return GetScalars(mapper, data) != nullptr; }));
}

bool vtkNBufferScalars::AreFaint(vtkMapper* mapper)
{
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  vtkScalarsToColors* own = vtkNBufferProtectedMembers::GetLookupTable(mapper);
  if (vtkNBufferSurface::IsComposite(mapper))
  {
    // VTK asks the tables of the mapper and of all blocks whether they are opaque.
    return MapsScalars(mapper) &&
      (HasFaintColors(own) ||
        (HasBlocksWithTables(mapper) &&
          vtkNBufferAnyNode(input,
            [mapper](vtkDataObject* data)
            { return HasFaintColors(GetBlockTable(mapper, data)); })));
  }
  // Of other composite data it asks nothing: neither the table of the mapper, which it would make
  // and build when it draws, nor colors in the arrays.
  const bool isAsked = mapper->GetInput();
  if (input && !isAsked && mapper->GetScalarVisibility())
  {
    own = mapper->GetLookupTable();
    own->Build();
  }
  return vtkNBufferAnyNode(input,
    [=](vtkDataObject* data)
    {
      vtkAbstractArray* scalars = GetScalars(mapper, data);
      vtkScalarsToColors* table = scalars ? GetTable(mapper, scalars) : nullptr;
      return table &&
        (HasFaintColors(table) ||
          (!(isAsked && table == own) &&
            !table->IsOpaque(scalars, mapper->GetColorMode(), mapper->GetArrayComponent())));
    });
}
VTK_ABI_NAMESPACE_END
