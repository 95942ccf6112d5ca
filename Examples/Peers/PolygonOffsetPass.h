// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class PolygonOffsetPass
 * @brief Draws another pass with a polygon offset: the bias of a shadow map whose baker has none.
 */
#ifndef PolygonOffsetPass_h
#define PolygonOffsetPass_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

namespace NBufferPeers
{

class PolygonOffsetPass : public vtkRenderPass
{
public:
  static PolygonOffsetPass* New();
  vtkTypeMacro(PolygonOffsetPass, vtkRenderPass);

  /// Sets the pass that draws, and the parameters of glPolygonOffset() for it.
  void Set(vtkRenderPass* delegate, double factor, double units);

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  vtkSmartPointer<vtkRenderPass> Delegate;
  double Factor = 0.0;
  double Units = 0.0;
};

} // namespace NBufferPeers

#endif
