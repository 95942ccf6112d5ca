// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DrawStage
 * @brief A prop that takes the place of others in a renderer's list and calls a function to draw
 * them.
 */
#ifndef DrawStage_h
#define DrawStage_h

#include "vtkProp.h"

#include <functional>

class vtkRenderer;

namespace NBufferPeers
{

class DrawStage : public vtkProp
{
public:
  static DrawStage* New();
  vtkTypeMacro(DrawStage, vtkProp);

  /// The function that draws. It returns how many props it drew.
  std::function<int(vtkRenderer*)> Function;

  /// Returns no bounds, so that no other culler removes this prop.
  double* GetBounds() VTK_SIZEHINT(6) override { return nullptr; }
  vtkTypeBool HasOpaqueGeometry() override { return 1; }
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
};

} // namespace NBufferPeers

#endif
