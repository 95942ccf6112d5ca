// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DrawStage
 * @brief A prop that stands in a renderer's list for others and calls a function to draw them.
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

  /// Draws, and says how many props that were.
  std::function<int(vtkRenderer*)> Function;

  /// None, so that no culler behind drops it.
  double* GetBounds() VTK_SIZEHINT(6) override { return nullptr; }
  vtkTypeBool HasOpaqueGeometry() override { return 1; }
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
};

} // namespace NBufferPeers

#endif
