// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowFrameKey.h
 * @brief All that the masks of a frame depend on: where two keys are equal, masks are as they were.
 *
 * Renderer and context, viewport and camera matrix, lights, settings, casters (whose own changes
 * the caller looks at), and the props that are drawn, each with the time of its last change. What
 * other props than plain actors draw may change without a trace: keys of frames with such props
 * equal none, not even themselves.
 */
#ifndef vtkShadowFrameKey_h
#define vtkShadowFrameKey_h

#include "vtkShadowLightList.h"

#include "vtkType.h"

#include <array>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderState;
class vtkShadowCaster;

class vtkShadowFrameKey
{
public:
  vtkShadowFrameKey() = default;

  /// `settingsTime`: of the last change of a setting.
  vtkShadowFrameKey(const vtkRenderState* state, const std::vector<vtkShadowLightSource>& lights,
    const std::vector<vtkShadowCaster*>& casters, vtkMTimeType settingsTime);

  bool operator==(const vtkShadowFrameKey& other) const;

private:
  bool Complete = false; ///< All props show their changes.
  const void* Renderer = nullptr;
  vtkMTimeType ContextTime = 0;
  vtkMTimeType SettingsTime = 0;
  std::array<int, 4> Viewport = {};
  std::array<double, 16> WorldToClip = {};
  std::vector<vtkShadowLightSource> Lights;
  std::vector<vtkShadowCaster*> Casters; ///< To compare only.
  std::vector<std::pair<const void*, vtkMTimeType>> Props;
};
VTK_ABI_NAMESPACE_END
#endif
