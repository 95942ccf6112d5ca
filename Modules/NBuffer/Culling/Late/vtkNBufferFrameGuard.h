// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferFrameGuard
 * @brief Keeps alive what a frame draws, whatever observers remove while it is drawn.
 *
 * From Cull() to the end of vtkRenderer::Render() the renderer and the culler know the props by
 * plain pointers. An observer (of a mapper, of the window) that removes a prop in between, and
 * drops the last reference to it, would leave both with a dead one. So
 *
 *  - every prop of the renderer is referenced from its first Cull() on. The references go when
 *    props are added or removed: at once, or at the end of the frame that is being drawn. A frame
 *    of an unchanged renderer costs nothing;
 *  - the culler, which owns the proxy in the renderer's list, is referenced for the frame.
 *
 * Nothing is kept between frames that its renderer does not keep as well.
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

  /// Watch a renderer until Detach(). Its observers own the guard as well.
  void Attach(vtkRenderer* renderer);
  void Detach();

  /// The renderer begins to draw a frame that `culler` has a part in.
  void BeginFrame(vtkObject* culler);

  /// The renderer's end of a frame, a change of its props, or its deletion.
  void Execute(vtkObject* caller, unsigned long event, void* data) override;

protected:
  vtkNBufferFrameGuard() = default;
  ~vtkNBufferFrameGuard() override = default;

private:
  void DropProps();

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkPropCollection> Props;
  std::vector<vtkSmartPointer<vtkProp>> References;
  vtkSmartPointer<vtkObject> Culler; ///< Set while a frame is drawn.
  bool Holding = false;              ///< References are those of the renderer's props as they are.
};

VTK_ABI_NAMESPACE_END
#endif
