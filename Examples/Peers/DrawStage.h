// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DrawStage
 * @brief A prop that takes the place of others in a renderer's list and calls a function to draw
 * them.
 */
#ifndef DrawStage_h
#define DrawStage_h

#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

#include <functional>

namespace NBufferPeers
{

class DrawStage : public vtkProp
{
public:
  static DrawStage* New() { VTK_STANDARD_NEW_BODY(DrawStage); }
  vtkTypeMacro(DrawStage, vtkProp);

  /// The function that draws. It returns how many props it drew.
  std::function<int(vtkRenderer*)> Function;

  /// Returns no bounds, so that no other culler removes this prop.
  double* GetBounds() VTK_SIZEHINT(6) override { return nullptr; }
  vtkTypeBool HasOpaqueGeometry() override { return 1; }
  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    auto* renderer = vtkRenderer::SafeDownCast(viewport);
    return renderer && this->Function ? this->Function(renderer) : 0;
  }
};

} // namespace NBufferPeers

#endif
