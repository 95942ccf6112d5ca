// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDeferredProxy
 * @brief The prop that stands in a renderer's list for all props held back.
 *
 * It comes last in the list, so that when the renderer draws it, the depth of everything else is
 * in the framebuffer. It then asks its view which of the held props to draw. Held props are plain
 * opaque actors (vtkNBufferCandidate), hence it has nothing to draw in the other stages.
 *
 * What the renderer and its passes tell a prop reaches the held ones: the render passes among the
 * property keys (they inject shader code into the mappers), required keys, allocated and estimated
 * render times.
 */
#ifndef vtkNBufferHeldProps_h
#define vtkNBufferHeldProps_h

#include "vtkNBufferVTKVersion.h"
#include "vtkProp.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferView;
class vtkRenderer;

class vtkNBufferDeferredProxy : public vtkProp
{
public:
  static vtkNBufferDeferredProxy* New();
  vtkTypeMacro(vtkNBufferDeferredProxy, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The view that decides; not counted as a reference. nullptr: nothing is drawn.
  void SetView(vtkNBufferView* view) { this->View = view; }

  /// None, so that no culler behind ours drops the proxy.
  double* GetBounds() VTK_SIZEHINT(6) override { return nullptr; }

  bool HasKeys(vtkInformation* requiredKeys) override;
  vtkTypeBool HasOpaqueGeometry() override { return 1; }
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  bool RenderFilteredOpaqueGeometry(vtkViewport* viewport, vtkInformation* requiredKeys) override;

  ///@{
  /// Each held prop that is drawn is given an equal share.
  void RestoreEstimatedRenderTime() override;
  double GetEstimatedRenderTime(vtkViewport* viewport) override;
  double GetEstimatedRenderTime() override;
  ///@}

  /// Draw one held prop with this prop's render passes and `time` seconds allocated to it.
  int Draw(vtkProp* prop, vtkRenderer* renderer, double time);

protected:
  vtkNBufferDeferredProxy() = default;
  ~vtkNBufferDeferredProxy() override = default;

private:
  vtkNBufferDeferredProxy(const vtkNBufferDeferredProxy&) = delete;
  void operator=(const vtkNBufferDeferredProxy&) = delete;

  vtkNBufferView* View = nullptr;
};

VTK_ABI_NAMESPACE_END
#endif
