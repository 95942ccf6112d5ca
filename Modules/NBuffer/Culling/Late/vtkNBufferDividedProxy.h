// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDividedProxy
 * @brief Represents one opaque prop of which only some units are drawn, in the place of that prop
 * in the renderer's list.
 *
 * README.md of this folder describes the whole frame.
 */
#ifndef vtkNBufferDividedProxy_h
#define vtkNBufferDividedProxy_h

#include "vtkNBufferStandIn.h"

#include <functional>

VTK_ABI_NAMESPACE_BEGIN

class vtkNBufferDividedProxy : public vtkNBufferStandIn
{
public:
  static vtkNBufferDividedProxy* New();
  vtkTypeMacro(vtkNBufferDividedProxy, vtkNBufferStandIn);

  /// Let the proxy represent `prop`, without a reference.
  void SetProp(vtkProp* prop, Drawer drawer)
  {
    this->Prop = prop;
    this->DrawProp = std::move(drawer);
  }

  double* GetBounds() VTK_SIZEHINT(6) override { return this->Prop->GetBounds(); }
  bool HasKeys(vtkInformation* keys) override { return this->Prop->HasKeys(keys); }
  vtkTypeBool HasOpaqueGeometry() override { return 1; }
  int RenderOpaqueGeometry(vtkViewport* viewport) override;

  ///@{
  /// Forwarded to the prop.
  void SetAllocatedRenderTime(double time, vtkViewport* viewport) override;
  void AddEstimatedRenderTime(double time, vtkViewport* viewport) override;
  ///@}

protected:
  vtkNBufferDividedProxy() = default;
  ~vtkNBufferDividedProxy() override = default;

  void ForEachDrawnProp(const std::function<void(vtkProp*)>& visit) override { visit(this->Prop); }

private:
  vtkNBufferDividedProxy(const vtkNBufferDividedProxy&) = delete;
  void operator=(const vtkNBufferDividedProxy&) = delete;

  vtkProp* Prop = nullptr;
  Drawer DrawProp;
};

VTK_ABI_NAMESPACE_END
#endif
