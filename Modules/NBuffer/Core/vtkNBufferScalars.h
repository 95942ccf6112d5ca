// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferScalars.h
 * @brief Which scalars a mapper maps to colors, and by which lookup table.
 *
 * When VTK draws an actor with scalars (vtkMapper::MapScalars()), it changes objects that others
 * may read, such as a vtkScalarBarActor: if the array has a lookup table of its own, the mapper
 * takes this table over, and unless the mapper uses the range that the table has, the table gets
 * the range of the mapper. An actor that is not drawn leaves both as they are.
 */
#ifndef vtkNBufferScalars_h
#define vtkNBufferScalars_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkMapper;
class vtkScalarsToColors;

namespace vtkNBufferScalars
{
/// The lookup table by which a mapper may map scalars: that of the array, or of the mapper, which
/// may be nullptr. Arrays in composite data are not looked at.
VTKNBUFFER_EXPORT vtkScalarsToColors* GetLookupTable(vtkMapper* mapper);

/// Whether drawing an actor of this mapper would change the mapper's table, or the range of it.
/// Always true if blocks of composite data have tables, or ranges, of their own. If they choose
/// their scalars, it is not looked whether there are any.
VTKNBUFFER_EXPORT bool ChangeTable(vtkMapper* mapper);

/// Whether a mapper maps scalars to colors that have an alpha below 1 although VTK takes them for
/// opaque. VTK looks at the mapper's table even if the array has another one, and not at the
/// colors that a color transfer function has for NaN and for annotated values. Of composite data it
/// looks at nothing, unless a mapper of blocks draws it; tables of arrays are not looked at then.
bool AreFaint(vtkMapper* mapper);
}

VTK_ABI_NAMESPACE_END
#endif
