// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferTranslucentProxy
 * @brief Stands for one translucent prop, in its place, and draws it only while the gate is open.
 *
 * Translucent props are blended in the renderer's order, so that none may be held back behind
 * another one. They are drawn after all opaque ones, though, when this frame's verdicts are known:
 * each keeps its place and is left out there if it is hidden. It still says that it has
 * translucent geometry, so that the renderer goes the same way through its passes as without it.
 */
#ifndef vtkNBufferGatedProp_h
#define vtkNBufferGatedProp_h

#include "vtkNBufferVTKVersion.h"
#include "vtkProp.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkNBufferTranslucentProxy : public vtkProp
{
public:
  static vtkNBufferTranslucentProxy* New();
  vtkTypeMacro(vtkNBufferTranslucentProxy, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The prop behind the gate, which is open then; not counted as a reference, for one frame.
  void SetProp(vtkProp* prop);
  vtkProp* GetProp() const { return this->Prop; }

  /// A closed gate draws nothing in the translucent stage.
  void SetOpen(bool open) { this->Open = open; }

  /// Whether the prop has been drawn in the translucent stage, by a pass that draws that one first.
  bool HasDrawn() const { return this->Drawn; }

  double* GetBounds() VTK_SIZEHINT(6) override { return this->Prop->GetBounds(); }
  bool HasKeys(vtkInformation* keys) override { return this->Prop->HasKeys(keys); }
  vtkTypeBool HasOpaqueGeometry() override { return this->Prop->HasOpaqueGeometry(); }
  vtkTypeBool HasTranslucentPolygonalGeometry() override
  {
    return this->Prop->HasTranslucentPolygonalGeometry();
  }
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;

  ///@{
  /// As if the renderer spoke to the prop itself.
  void SetAllocatedRenderTime(double time, vtkViewport* viewport) override;
  void RestoreEstimatedRenderTime() override { this->Prop->RestoreEstimatedRenderTime(); }
  void AddEstimatedRenderTime(double time, vtkViewport* viewport) override
  {
    this->Prop->AddEstimatedRenderTime(time, viewport);
  }
  double GetEstimatedRenderTime(vtkViewport* viewport) override
  {
    return this->Prop->GetEstimatedRenderTime(viewport);
  }
  double GetEstimatedRenderTime() override { return this->Prop->GetEstimatedRenderTime(); }
  ///@}

protected:
  vtkNBufferTranslucentProxy() = default;
  ~vtkNBufferTranslucentProxy() override = default;

private:
  vtkNBufferTranslucentProxy(const vtkNBufferTranslucentProxy&) = delete;
  void operator=(const vtkNBufferTranslucentProxy&) = delete;

  vtkProp* Prop = nullptr;
  bool Open = true;
  bool Drawn = false;
};

VTK_ABI_NAMESPACE_END
#endif
