// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferForwardedKeys
 * @brief Lends what render passes tell one prop to another while that is drawn.
 *
 * Passes speak to props through their property keys: vtkOpenGLRenderPass::RenderPasses lets them
 * change the mappers' shaders, vtkOpenGLActor::GLDepthMaskOverride rules depth writing while
 * peeling. The other prop's own information object is used where it has one: SetPropertyKeys()
 * marks a prop as modified.
 */
#ifndef vtkNBufferForwardedKeys_h
#define vtkNBufferForwardedKeys_h

#include "vtkNBufferVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
class vtkProp;

class vtkNBufferForwardedKeys
{
public:
  /// Until the end of its life, what `from` holds (it may be nullptr) also holds for `to`.
  vtkNBufferForwardedKeys(vtkInformation* from, vtkProp* to);
  ~vtkNBufferForwardedKeys();
  vtkNBufferForwardedKeys(const vtkNBufferForwardedKeys&) = delete;
  void operator=(const vtkNBufferForwardedKeys&) = delete;

private:
  vtkInformation* From = nullptr;
  vtkInformation* To = nullptr;
  bool DepthMask = false;
};

VTK_ABI_NAMESPACE_END
#endif
