// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDeferredProxy
 * @brief Represents all opaque props that are held back, at the end of the renderer's list or
 * before the first prop that blends in the opaque stage.
 *
 * When the renderer draws the proxy, the depth of all opaque props before it is in the framebuffer.
 * The proxy then lets its owner test the props that are held back and draw those that may be
 * visible. They are plain opaque actors (vtkNBufferCandidate), so the proxy draws nothing in the
 * stages for translucent, volumetric and overlay geometry. README.md of this folder describes the
 * whole frame.
 */
#ifndef vtkNBufferDeferredProxy_h
#define vtkNBufferDeferredProxy_h

#include "vtkNBufferStandIn.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

class vtkNBufferDeferredProxy : public vtkNBufferStandIn
{
public:
  static vtkNBufferDeferredProxy* New();
  vtkTypeMacro(vtkNBufferDeferredProxy, vtkNBufferStandIn);

  /**
   * The owner of a proxy knows the props that are held back and decides which of them are drawn.
   */
  class Owner
  {
  public:
    /// Draw the props that are held back and that may be visible. With `requiredKeys`, draw only
    /// props that have these keys (see vtkProp::HasKeys). Returns the number of props drawn.
    virtual int DrawHeldProps(vtkRenderer* renderer, vtkInformation* requiredKeys) = 0;

    /// Whether any prop that is held back has these keys.
    virtual bool HasHeldPropWithKeys(vtkInformation* requiredKeys) const = 0;

  protected:
    ~Owner() = default;
  };

  /// Set the owner. It is not counted as a reference and must reset this to nullptr before it is
  /// deleted. A proxy without an owner, which is the default, draws nothing.
  void SetOwner(Owner* owner) { this->TheOwner = owner; }

  /// Call `draw` while a prop has the property keys of this proxy. Returns what `draw` returns.
  int Draw(vtkProp* prop, const std::function<int()>& draw);

  /// Returns nullptr, so that no culler that runs later removes the proxy.
  double* GetBounds() VTK_SIZEHINT(6) override { return nullptr; }

  bool HasKeys(vtkInformation* requiredKeys) override;
  vtkTypeBool HasOpaqueGeometry() override { return 1; }
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  bool RenderFilteredOpaqueGeometry(vtkViewport* viewport, vtkInformation* requiredKeys) override;

protected:
  vtkNBufferDeferredProxy() = default;
  ~vtkNBufferDeferredProxy() override = default;

private:
  vtkNBufferDeferredProxy(const vtkNBufferDeferredProxy&) = delete;
  void operator=(const vtkNBufferDeferredProxy&) = delete;

  Owner* TheOwner = nullptr;
};

VTK_ABI_NAMESPACE_END
#endif
