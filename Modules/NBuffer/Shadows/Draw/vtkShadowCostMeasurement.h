// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowCostMeasurement.h
 * @brief Measures the costs of vtkShadowCostModel on the current device.
 *
 * The depth of the receivers is read, the litmaps of a light are made, with receivers and without
 * any, and about 16,384 triangles of its volumes are drawn, into the viewport and into one pixel of
 * it. Each is done three times, and the shortest time counts, because OpenGL may compile programs
 * at first. For these times the calling thread waits until the device has drawn. No image changes:
 * the volumes are drawn into the stencil buffer alone, which is cleared before it is used.
 */
#ifndef vtkShadowCostMeasurement_h
#define vtkShadowCostMeasurement_h

#include "vtkShadowCostModel.h"
#include "vtkShadowPlan.h"
#include "vtkShadowReceiverProjector.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShadowCounter;
class vtkShadowTarget;

namespace vtkShadowCostMeasurement
{
/// How often each piece of work is done.
constexpr int Repetitions = 3;

/// The light and the frame in which the costs are measured.
struct Subject
{
  vtkOpenGLRenderWindow* Window;
  vtkShadowTarget& Target;   ///< Its depth is that of the receivers.
  vtkShadowCounter& Counter; ///< A vtkShadowCounter::Scope must be alive.
  const vtkShadowLight& Light;
  std::vector<vtkShadowLightSpace> Spaces;        ///< Of the light's litmaps.
  const std::vector<const vtkShadowPart*>& Parts; ///< Of all casters.
  vtkShadowPlan::View View;                       ///< For plans of whole volumes.
  vtkShadowView Receivers;                        ///< The camera of the depth.
  int Resolution;                                 ///< Of a litmap.
};

/// Measures all costs. Returns false, with the cause in `why`, if an OpenGL call fails. Costs that
/// were not measured yet stay as they are then.
bool Measure(const Subject& subject, vtkShadowCostModel::Costs& costs, std::string& why);
}

VTK_ABI_NAMESPACE_END
#endif
