// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferScalars.h"

#include "vtkNBufferForEachChild.h"
#include "vtkNBufferProtectedMembers.h"

#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkScalarsToColors.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The scalars that a mapper maps, or nullptr; of composite data those of the first block with any.
vtkAbstractArray* GetScalars(vtkMapper* mapper, vtkDataObject* data)
{
  if (!mapper->GetScalarVisibility())
  {
    return nullptr;
  }
  vtkAbstractArray* scalars = nullptr;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    vtkNBufferForEachChild(tree,
      [&](vtkDataObject* child)
      {
        scalars = GetScalars(mapper, child);
        return scalars == nullptr;
      });
    return scalars;
  }
  int isCellArray = 0;
  return vtkAbstractMapper::GetAbstractScalars(vtkDataSet::SafeDownCast(data),
    mapper->GetScalarMode(), mapper->GetArrayAccessMode(), mapper->GetArrayId(),
    mapper->GetArrayName(), isCellArray);
}

/// Whether blocks of composite data have tables, or ranges, of their own.
bool HasBlocksWithTables(vtkMapper* mapper)
{
#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
  static_cast<void>(mapper);
  return false;
#else
  auto* composite = vtkCompositePolyDataMapper::SafeDownCast(mapper);
  auto* attributes = composite ? composite->GetCompositeDataDisplayAttributes() : nullptr;
  return attributes && (attributes->HasBlockLookupTables() || attributes->HasBlockScalarRanges());
#endif
}

vtkScalarsToColors* GetTable(vtkMapper* mapper, vtkAbstractArray* scalars)
{
  auto* array = vtkDataArray::SafeDownCast(scalars);
  return array && array->GetLookupTable() ? array->GetLookupTable()
                                          : vtkNBufferProtectedMembers::GetLookupTable(mapper);
}
}

vtkScalarsToColors* vtkNBufferScalars::GetLookupTable(vtkMapper* mapper)
{
  return GetTable(mapper, GetScalars(mapper, mapper->GetInput()));
}

bool vtkNBufferScalars::ChangeTable(vtkMapper* mapper)
{
  if (!mapper->GetScalarVisibility())
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
    GetScalars(mapper, mapper->GetInputDataObject(0, 0));
}

bool vtkNBufferScalars::AreFaint(vtkMapper* mapper)
{
  vtkAbstractArray* scalars = GetScalars(mapper, mapper->GetInput());
  vtkScalarsToColors* table = scalars ? GetTable(mapper, scalars) : nullptr;
  if (!table)
  {
    return false;
  }
  auto* function = vtkColorTransferFunction::SafeDownCast(table);
  bool isFaint = function && function->GetNanOpacity() < 1.0;
  for (vtkIdType i = 0; function && i < function->GetNumberOfAnnotatedValues(); ++i)
  {
    double color[4];
    function->GetIndexedColor(i, color);
    isFaint = isFaint || color[3] < 1.0;
  }
  return isFaint ||
    (table != vtkNBufferProtectedMembers::GetLookupTable(mapper) &&
      !table->IsOpaque(scalars, mapper->GetColorMode(), mapper->GetArrayComponent()));
}
VTK_ABI_NAMESPACE_END
