// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowFrameKey
 * @brief Everything on which the shadow masks of a frame depend. If the keys of two frames are
 * equal, their masks are equal, too.
 *
 * A key holds the renderer and its context, the viewport, the number of samples, the camera's
 * matrix, the lights, the settings of the pass and of the cullers, and the renderer's props, whose
 * changes vtkShadowCasterList finds. Which of the props are drawn belongs to the key as well,
 * unless the cullers remove only props that show in no pixel (vtkNBufferCullerTraits).
 *
 * The list of drawn props may contain props that are not the renderer's. Nothing finds the changes
 * of these, so the key of such a frame is equal to no key, not even to itself. Stand-ins for the
 * renderer's own props (vtkNBufferStandIn) are allowed.
 */
#ifndef vtkShadowFrameKey_h
#define vtkShadowFrameKey_h

#include "vtkNBufferCamera.h"
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

  /// Makes the key of a frame. `settingsTime` is the time of the last change of the pass's
  /// settings.
  vtkShadowFrameKey(const vtkRenderState* state, const std::vector<vtkShadowLightSource>& lights,
    const vtkShadowCasterList& props, vtkMTimeType settingsTime);

  bool operator==(const vtkShadowFrameKey& other) const;

private:
  bool Complete = false; ///< True if the renderer's props, in order, and stand-ins are drawn.
  const void* Renderer = nullptr;
  vtkMTimeType SettingsTime = 0;
  std::array<int, 4> Viewport = {};
  int Samples = 0; ///< The samples of a pixel of the framebuffer to draw to.
  vtkNBufferViewKey View;
  std::vector<vtkShadowLightSource> Lights;
  vtkMTimeType PropsVersion = 0;
  std::vector<vtkProp*> Drawn; ///< The drawn props, where they matter. Pointers are only compared.
};
VTK_ABI_NAMESPACE_END
#endif
