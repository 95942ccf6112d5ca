// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferCullerOrder.h
 * @brief The cullers of a renderer that run before and after ours. The order of the collection is
 * the order in which cullers run.
 */
#ifndef vtkNBufferCullerOrder_h
#define vtkNBufferCullerOrder_h

#include "vtkNBufferVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkCuller;
class vtkCullerCollection;

namespace vtkNBufferCullerOrder
{
/// Move the frustum cullers with default settings before `self` to the end of the collection: the
/// frustum test of vtkNBufferView does everything that they do. If `self` is the last culler, they
/// do not run again in this frame, because the renderer's iterator is at its end already.
void MoveFrustumCullersBehind(vtkCuller* self, vtkCullerCollection* cullers);

/// Whether a culler comes after `self` that may remove props. It would not see the props that are
/// held back.
bool IsOtherBehind(vtkCuller* self, vtkCullerCollection* cullers);
}

VTK_ABI_NAMESPACE_END
#endif
