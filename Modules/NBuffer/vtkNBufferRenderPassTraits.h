// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferRenderPassTraits
 * @brief What a render pass may say about itself, so that vtkNBufferCuller culls with it.
 *
 * vtkNBufferCuller knows which of VTK's own passes it can work with. If a renderer has a pass of
 * another class, the culler draws everything, with the decision vtkNBufferDecision::RenderPass. A
 * pass of your own becomes known if it also derives from this class:
 *
 * @code
 * class MyPass : public vtkRenderPass, public vtkNBufferRenderPassTraits
 * {
 *   // ...
 *   void Render(const vtkRenderState* s) override { this->Steps->Render(s); }
 *   std::vector<vtkRenderPass*> GetDelegatePasses() override { return { this->Steps }; }
 *   vtkNew<vtkRenderStepsPass> Steps;
 * };
 * @endcode
 *
 * For a pass whose source you cannot change see vtkNBufferCuller::AddKnownPass().
 *
 * By deriving from this class a pass promises that
 *
 *  - it draws props of the list in its vtkRenderState only, in the order of that list, and calls
 *    the virtual functions of vtkProp for it. The list contains stand-ins of the culler, which are
 *    not actors;
 *  - the image depends only on props that the renderer's active camera sees. A pass that renders
 *    shadow maps or reflections, for instance, needs other props, too;
 *  - the depth of the opaque props is there when the translucent ones are drawn, unless its
 *    delegates erase it;
 *  - a prop does not change pixels beyond those that it covers. A pass that blurs, for instance,
 *    may draw on a margin around the viewport, which shows props outside of the camera's frustum.
 *
 * The culler itself checks camera, viewport and framebuffer when its proxy is drawn, and draws
 * everything if they are not the renderer's.
 */
#ifndef vtkNBufferRenderPassTraits_h
#define vtkNBufferRenderPassTraits_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <vector> // For the return value

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderPass;

class VTKNBUFFER_EXPORT vtkNBufferRenderPassTraits
{
public:
  /// Get the passes that this pass calls. The culler looks at each of them in the same way.
  /// Elements may be nullptr. A pass that draws everything itself returns an empty list. Called
  /// once or a few times per frame.
  virtual std::vector<vtkRenderPass*> GetDelegatePasses() = 0;

  /**
   * Whether this pass may draw the same opaque props twice in a frame: first to find out what is
   * visible, then for the image. Both framebuffers must have the same samples, and the second at
   * least as many bits of depth. The culler tests props in the first drawing and repeats the same
   * draws in the second one, because what is hidden in the first is hidden in the second. The
   * first may leave out polygon offsets, which push surfaces away from the eye
   * (vtkMapper::SetResolveCoincidentTopology(), visible edges): if any prop may have one, the
   * culler tests what is hidden in the second drawing, too. If a pass draws twice without saying
   * so, the second drawing has all props. Default: false.
   */
  virtual bool DrawsOpaquePropsTwice() const { return false; }

protected:
  vtkNBufferRenderPassTraits() = default;
  ~vtkNBufferRenderPassTraits() = default;
};

VTK_ABI_NAMESPACE_END
#endif
