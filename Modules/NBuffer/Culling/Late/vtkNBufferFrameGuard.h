// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferFrameGuard
 * @brief Keeps the props of a renderer, and the culler, alive until the end of a frame.
 *
 * From Cull() to the end of vtkRenderer::Render() the renderer and the culler know the props by
 * plain pointers. An observer of a mapper or of the window may remove a prop in between. If that
 * removes the last reference to the prop, both would use a deleted prop. Therefore
 *
 *  - the guard holds a reference to every prop of the renderer from the first Cull() on. It
 *    releases the references when props are added or removed: immediately, or at the end of the
 *    frame if a frame is being drawn. For a renderer whose props stay the same, a frame costs
 *    nothing;
 *  - the guard holds a reference to the culler for the duration of a frame, because the culler owns
 *    the proxies in the renderer's list.
 *
 * Between two frames the guard keeps nothing alive that the renderer does not keep alive itself.
 * README.md of this folder describes the whole frame.
 */
#ifndef vtkNBufferFrameGuard_h
#define vtkNBufferFrameGuard_h

#include "vtkNBufferVTKVersion.h"

#include "vtkCommand.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkPropCollection;
class vtkRenderer;

class vtkNBufferFrameGuard : public vtkCommand
{
public:
  static vtkNBufferFrameGuard* New() { return new vtkNBufferFrameGuard; }
  vtkTypeMacro(vtkNBufferFrameGuard, vtkCommand);

  ///@{
  /// Observe a renderer until Detach() is called. The renderer's list of observers owns the guard,
  /// too.
  void Attach(vtkRenderer* renderer);
  void Detach();
  ///@}

  /// To be called when the renderer begins to draw a frame that `culler` culls.
  void BeginFrame(vtkObject* culler);

  /// Called by the renderer at the end of a frame and when it is deleted, and by the renderer's
  /// collection of props when it changes.
  void Execute(vtkObject* caller, unsigned long event, void* data) override;

protected:
  vtkNBufferFrameGuard() = default;
  ~vtkNBufferFrameGuard() override = default;

private:
  void ReleaseProps();

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkPropCollection> Props;
  std::vector<vtkSmartPointer<vtkProp>> References;
  vtkSmartPointer<vtkObject> Culler; ///< This is set while a frame is drawn.
  bool IsComplete = false;           ///< References has all props that the renderer has now.
};

VTK_ABI_NAMESPACE_END
#endif
