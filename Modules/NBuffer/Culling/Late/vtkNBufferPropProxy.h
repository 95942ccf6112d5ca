// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferPropProxy
 * @brief Represents one prop, in the place of that prop in the renderer's list: a translucent prop,
 * or a large one of which only some units are drawn.
 *
 * The proxy of a translucent prop draws it in the translucent stage only while it is open. It is
 * open when a frame with a test begins, and the culler closes it when this frame's depth shows that
 * the prop is hidden. Without a test it is as the last test has left it. A closed proxy still says
 * that it has translucent geometry, so that the renderer takes the same way through its render
 * passes as without the culler. README.md of this folder describes the whole frame.
 */
#ifndef vtkNBufferPropProxy_h
#define vtkNBufferPropProxy_h

#include "vtkNBufferStandIn.h"

#include <functional>

VTK_ABI_NAMESPACE_BEGIN

class vtkNBufferPropProxy : public vtkNBufferStandIn
{
public:
  static vtkNBufferPropProxy* New();
  vtkTypeMacro(vtkNBufferPropProxy, vtkNBufferStandIn);

  /// Represent a prop for one frame, without a reference. `place` is that of the prop in the list
  /// of candidates. The caller knows whether the prop is translucent; to find it out here would
  /// take long for a prop with many blocks. `drawer` draws the prop.
  void SetProp(int place, vtkProp* prop, bool isTranslucent, Drawer drawer);

  /// A closed proxy draws nothing in the translucent stage.
  void SetOpen(bool open) { this->Open = open; }

  int GetPlace() const { return this->Place; }

  /// Whether the prop has been drawn in the translucent stage of this frame. A render pass that
  /// draws translucent props before opaque ones does so while the proxy is still open.
  bool HasDrawn() const { return this->Drawn; }

  double* GetBounds() VTK_SIZEHINT(6) override { return this->Prop->GetBounds(); }
  bool HasKeys(vtkInformation* keys) override { return this->Prop->HasKeys(keys); }
  vtkTypeBool HasOpaqueGeometry() override
  {
    return !this->IsTranslucent || this->Prop->HasOpaqueGeometry();
  }
  vtkTypeBool HasTranslucentPolygonalGeometry() override
  {
    return this->IsTranslucent && this->Prop->HasTranslucentPolygonalGeometry();
  }
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;

  /// Forwarded to the prop.
  void SetAllocatedRenderTime(double time, vtkViewport* viewport) override;

protected:
  vtkNBufferPropProxy() = default;
  ~vtkNBufferPropProxy() override = default;

private:
  vtkNBufferPropProxy(const vtkNBufferPropProxy&) = delete;
  void operator=(const vtkNBufferPropProxy&) = delete;

  int Place = -1;
  vtkProp* Prop = nullptr; ///< It is not counted as a reference.
  Drawer DrawProp;
  bool IsTranslucent = false;
  bool Open = true;
  bool Drawn = false;
};

VTK_ABI_NAMESPACE_END
#endif
