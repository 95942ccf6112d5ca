// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferCompatibility.h
 * @brief When the culler must draw everything: the one place that knows VTK's ways of drawing a
 * frame.
 *
 * The culler may hold props back only if the renderer draws its opaque props once, from its active
 * camera, into a framebuffer with depth, and if nothing needs the props that the camera does not
 * see. Of VTK's own render passes this file knows which of them do that. All other passes can say
 * so themselves (vtkNBufferRenderPassTraits); the culler draws everything for those that do not.
 */
#ifndef vtkNBufferCompatibility_h
#define vtkNBufferCompatibility_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferStatistics.h"

#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
struct vtkNBufferDepthSource;
class vtkRenderPass;
class vtkRenderer;
struct vtkNBufferViewKey;

namespace vtkNBufferCompatibility
{
/// Get the reason why the culler must not cull the next frame of `renderer`, or None if it may.
VTKNBUFFER_EXPORT vtkNBufferDecision WhyNot(vtkRenderer* renderer);

/**
 * Get the reason why the depth drawn so far must not be used to test what was held back, or None if
 * it may be used. To be called when the proxy is drawn: only then is the framebuffer known. `key`
 * is the view that the culler has placed the props in. Describes the framebuffer in `source`. After
 * a failure `why` says its cause and remedy; otherwise it stays empty.
 */
vtkNBufferDecision WhyNotHere(vtkRenderer* renderer, const vtkNBufferViewKey& key,
  vtkNBufferDepthSource& source, std::string& why);

/// Whether the renderer processes the image after drawing its props (FXAA, SSAO), the image of
/// layers below included. VTK does so only if the renderer's list contains a prop, even if that
/// prop draws nothing.
VTKNBUFFER_EXPORT bool ProcessesImage(vtkRenderer* renderer);

/// Whether one of the renderer's passes says that it may draw the same opaque props twice in a
/// frame (vtkNBufferRenderPassTraits::DrawsOpaquePropsTwice).
VTKNBUFFER_EXPORT bool DrawsOpaquePropsTwice(vtkRenderer* renderer);

/**
 * How a renderer draws its props. The verdicts of a frame serve for the next one only if both are
 * drawn with the same settings.
 */
struct DrawingSettings
{
  /// The passes, by address and class. They are only compared, never used. Another pass may draw
  /// into other samples.
  std::vector<std::pair<const vtkRenderPass*, const std::type_info*>> Passes;
  ///@{
  /// Whether the renderer or its window may blend in the opaque stage. Then the image depends on
  /// what has been drawn below a prop and in which order. With screen-space ambient occlusion, a
  /// prop without normals (an unlit one) leaves the positions and normals of what lies below it.
  /// Smooth lines and points are blended at their edges.
  bool AmbientOcclusion = false;
  bool SmoothLines = false;
  ///@}

  bool operator==(const DrawingSettings& other) const
  {
    return this->Passes == other.Passes && this->AmbientOcclusion == other.AmbientOcclusion &&
      this->SmoothLines == other.SmoothLines;
  }
};

DrawingSettings GetDrawingSettings(vtkRenderer* renderer);
}

VTK_ABI_NAMESPACE_END
#endif
