// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowFrameKey.h
 * @brief All that the masks of a frame depend on: where two keys are equal, masks are as they were.
 *
 * Renderer and context, viewport, samples and camera matrix, lights, settings, the renderer's props
 * as vtkShadowCasterList has looked at them, and, unless vtkNBufferCuller chooses them, which of
 * them are drawn. Where others are drawn, too, whose changes nobody looks at, the key equals none,
 * not even itself.
 */
#ifndef vtkShadowFrameKey_h
#define vtkShadowFrameKey_h

#include "vtkShadowLightList.h"

#include "vtkType.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderState;
class vtkShadowCasterList;

class vtkShadowFrameKey
{
public:
  vtkShadowFrameKey() = default;

  /// `settingsTime`: of the last change of a setting.
  vtkShadowFrameKey(const vtkRenderState* state, const std::vector<vtkShadowLightSource>& lights,
    const vtkShadowCasterList& props, vtkMTimeType settingsTime);

  bool operator==(const vtkShadowFrameKey& other) const;

private:
  bool Complete = false;
  const void* Renderer = nullptr;
  vtkMTimeType ContextTime = 0;
  vtkMTimeType SettingsTime = 0;
  std::array<int, 4> Viewport = {};
  int Samples = 0; ///< Of the framebuffer that is drawn.
  std::array<double, 16> WorldToClip = {};
  std::vector<vtkShadowLightSource> Lights;
  vtkMTimeType PropsVersion = 0;
  std::vector<vtkProp*> Drawn; ///< To compare only.
};
VTK_ABI_NAMESPACE_END
#endif
