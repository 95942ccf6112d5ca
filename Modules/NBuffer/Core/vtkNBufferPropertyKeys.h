// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferPropertyKeys.h
 * @brief Render passes among the property keys of a prop (vtkOpenGLRenderPass::RenderPasses()).
 * The mapper of the prop lets these passes change its shaders.
 */
#ifndef vtkNBufferPropertyKeys_h
#define vtkNBufferPropertyKeys_h

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

/// Append a pass if it is missing, and return whether it was. Props may share their keys.
bool AddPass(vtkInformation* keys, vtkObjectBase* pass);

/// Remove a pass from these keys, which may be nullptr.
void RemovePass(vtkInformation* keys, vtkObjectBase* pass);
}

VTK_ABI_NAMESPACE_END
#endif
