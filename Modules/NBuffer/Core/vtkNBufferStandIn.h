// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferStandIn
 * @brief Base class of the props that vtkNBufferCuller puts into a renderer's list in the place of
 * the renderer's own props.
 *
 * A renderer and its passes treat a stand-in as any other prop. Render passes speak to props
 * through vtkProp::GetPropertyKeys(): vtkOpenGLRenderPass::RenderPasses() lets a pass change the
 * shaders of the mappers, and vtkOpenGLActor::GLDepthMaskOverride() switches the writing of depth
 * while depth peeling draws. A ForwardedKeys object copies both from a stand-in to a prop that it
 * represents, for the time in which that prop is drawn.
 *
 * Code outside the culler recognises stand-ins by this class and needs to know nothing else about
 * the culler.
 */
#ifndef vtkNBufferStandIn_h
#define vtkNBufferStandIn_h

#include "vtkNBufferVTKVersion.h"
#include "vtkProp.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;

class vtkNBufferStandIn : public vtkProp
{
public:
  vtkTypeMacro(vtkNBufferStandIn, vtkProp);

  /// Draws a prop, or some of its units, by calling `drawWhole`; or draws nothing. Returns the
  /// number of props drawn.
  using Drawer = std::function<int(const std::function<int()>& drawWhole)>;

protected:
  vtkNBufferStandIn() = default;
  ~vtkNBufferStandIn() override = default;

  /**
   * Lends the property keys of a stand-in to a prop: the prop has them from the construction of
   * this object to its destruction. Keys that the prop has already, because it is in the renderer's
   * list, stay as they are. The prop's own vtkInformation is changed where the prop has one,
   * because vtkProp::SetPropertyKeys() marks a prop as modified.
   */
  class ForwardedKeys
  {
  public:
    ForwardedKeys(vtkNBufferStandIn* from, vtkProp* to);
    ~ForwardedKeys();
    ForwardedKeys(const ForwardedKeys&) = delete;
    void operator=(const ForwardedKeys&) = delete;

  private:
    vtkInformation* To = nullptr;      ///< The prop's keys, or nullptr if nothing is forwarded.
    std::vector<vtkObjectBase*> Added; ///< The passes that the prop did not have before.
    bool SetsDepthMask = false;        ///< Whether the depth mask key was added to the prop.
  };

private:
  vtkNBufferStandIn(const vtkNBufferStandIn&) = delete;
  void operator=(const vtkNBufferStandIn&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
