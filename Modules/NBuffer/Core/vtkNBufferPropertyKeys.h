// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferPropertyKeys.h
 * @brief Render passes among the property keys of a prop (vtkOpenGLRenderPass::RenderPasses()).
 * The mapper of the prop lets these passes change its shaders.
 */
#ifndef vtkNBufferPropertyKeys_h
#define vtkNBufferPropertyKeys_h

#include "vtkNBufferModule.h"     // For export macro
#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
class vtkObjectBase;
class vtkProp;

namespace vtkNBufferPropertyKeys
{
/// The keys of a prop, which are created if it has none.
vtkInformation* Get(vtkProp* prop);

/// Whether a pass is among these keys, which may be nullptr.
bool HasPass(vtkInformation* keys, const vtkObjectBase* pass);

/// The number of passes among these keys, which may be nullptr.
VTKNBUFFER_EXPORT int CountPasses(vtkInformation* keys);

/// Append a pass if it is missing, and return whether it was. Props may share their keys.
VTKNBUFFER_EXPORT bool AddPass(vtkInformation* keys, vtkObjectBase* pass);

/// Remove a pass from these keys, which may be nullptr.
VTKNBUFFER_EXPORT void RemovePass(vtkInformation* keys, vtkObjectBase* pass);

///@{
/// Insert a pass after the first `place` passes, or after all if there are fewer, and remove it
/// again. These are for copies that VTK has made of the keys of a prop. (VTK references a pass
/// twice where it is appended, and releases it twice where it is removed, but not in copies.)
VTKNBUFFER_EXPORT void AddPassToCopy(vtkInformation* copy, vtkObjectBase* pass, int place);
VTKNBUFFER_EXPORT void RemovePassFromCopy(vtkInformation* copy, vtkObjectBase* pass);
///@}
}

VTK_ABI_NAMESPACE_END
#endif
