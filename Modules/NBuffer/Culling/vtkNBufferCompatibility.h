// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferCompatibility.h
 * @brief Finds out when the culler must draw everything. No other file knows the ways in which VTK
 * draws a frame.
 *
 * The culler may hold props back only if the renderer draws its opaque props once, from its active
 * camera, into a framebuffer with depth, and if nothing needs the props that the camera does not
 * see. vtkNBufferKnownClasses knows which of VTK's own render passes meet these conditions. Any
 * other pass can declare that it does (vtkNBufferRenderPassTraits), or the application can vouch
 * for it (vtkNBufferCuller::AddKnownPass()); otherwise the culler draws everything.
 */
#ifndef vtkNBufferCompatibility_h
#define vtkNBufferCompatibility_h

#include "vtkNBufferBackend.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferStatistics.h"

#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCuller;
class vtkCullerCollection;
class vtkNBufferCandidateList;
struct vtkNBufferDepthSource;
class vtkProp;
class vtkRenderPass;
class vtkRenderer;
struct vtkNBufferViewKey;

namespace vtkNBufferCompatibility
{
/// Get the reason why `self` must not cull the next frame of `renderer`, or None if it may. `props`
/// are those in the renderer's list.
VTKNBUFFER_EXPORT vtkNBufferDecision WhyNot(
  vtkRenderer* renderer, vtkCuller* self, vtkProp** props, int count);

/// Move the frustum cullers that have default settings and run before `self` to the end of the
/// collection, so that they run last: the frustum test of vtkNBufferView does everything that they
/// do. If `self` was the last culler, they do not run again in this frame, because the renderer's
/// iterator is at its end already.
VTKNBUFFER_EXPORT void MoveFrustumCullersBehind(vtkCullerCollection* cullers, vtkCuller* self);

/**
 * Get the reason why the depth drawn so far must not be used to test the props that are held back,
 * or None if it may be used. Call it when the proxy is drawn, because the framebuffer is not known
 * earlier. `key` is the view for which the culler has placed the props, and `wanted` the back-end
 * that the application has set. Reversed depth may not be used if VTK draws any of `props` in a way
 * that is meant for its own depth alone. The function writes the properties of the framebuffer to
 * `source`; its Places are all of a pixel if what is drawn later may have other samples. If the
 * result is a failure, it writes the cause and a remedy to `why`, which otherwise stays empty.
 */
vtkNBufferDecision WhyNotHere(vtkRenderer* renderer, const vtkNBufferCandidateList& props,
  const vtkNBufferViewKey& key, vtkNBufferBackend::Kind wanted, vtkNBufferDepthSource& source,
  std::string& why);

/// Whether the renderer erases depth before it draws its props. With a render pass, vtkCameraPass
/// does that.
bool ErasesDepth(vtkRenderer* renderer);

/// Whether translucent props are drawn over the depth of the opaque ones. Render passes may erase
/// it before (vtkCameraPass, vtkClearZPass), or draw opaque props into a framebuffer whose depth
/// they do not hand on to the passes that follow (vtkToneMappingPass, and vtkFramebufferPass of
/// VTK 9.1).
bool KeepsOpaqueDepth(vtkRenderer* renderer);

/// Whether the renderer processes the image (FXAA, SSAO) after it has drawn its props. This also
/// changes what renderers of lower layers have drawn. VTK does it if the renderer's list of props
/// is not empty, even if these props draw nothing.
VTKNBUFFER_EXPORT bool ProcessesImage(vtkRenderer* renderer);

/// Whether the depth that this renderer draws may be used to cull props of other ranks, and theirs
/// to cull its props. The colour of each pixel must depend on that pixel alone; otherwise a prop
/// that another rank hides might change a pixel beside it. And the depth that is drawn must be the
/// depth that is composited, which is certain only without render passes.
VTKNBUFFER_EXPORT bool CanShareDepth(vtkRenderer* renderer);

/// Whether one of the renderer's passes says that it may draw the same opaque props twice in a
/// frame (vtkNBufferRenderPassTraits::DrawsOpaquePropsTwice).
VTKNBUFFER_EXPORT bool DrawsOpaquePropsTwice(vtkRenderer* renderer);

/**
 * How a renderer draws its props. The next frame can reuse the verdicts of a frame only if both are
 * drawn with the same settings.
 */
struct DrawingSettings
{
  /// The renderer's pass and all passes that it calls, by address and class. The addresses are only
  /// compared, never dereferenced. Another pass may draw with another number of samples.
  std::vector<std::pair<const vtkRenderPass*, const std::type_info*>> Passes;
  ///@{
  /// Whether screen-space ambient occlusion is on, and whether smooth lines, points or polygons
  /// are. With either, the image may depend on the order of drawing and on what is drawn behind a
  /// prop: an unlit prop, which has no normals, leaves the positions and normals of what is behind
  /// it in place for the ambient occlusion; smooth primitives are blended at their edges.
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
