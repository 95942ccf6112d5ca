// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReversedDepth.h
 * @brief Reversed depth, 1 near and 0 far, as an application lets VTK draw it: a camera that
 * projects to it, and a pass that sets the state of OpenGL for it.
 */
#ifndef ReversedDepth_h
#define ReversedDepth_h

#include "vtkNBufferRenderPassTraits.h"

#include "vtkOpenGLCamera.h"
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkRenderer;

namespace TestScene
{
/// A camera whose z in clip coordinates is w on the near plane, and 0 on the far plane or, with
/// InfiniteFar, in the infinite.
class ReversedCamera : public vtkOpenGLCamera
{
public:
  static ReversedCamera* New();
  vtkTypeMacro(ReversedCamera, vtkOpenGLCamera);

  void SetInfiniteFar(bool infinite)
  {
    this->InfiniteFar = infinite;
    this->Modified();
  }

protected:
  void ComputeProjectionTransform(double aspect, double nearz, double farz) override;

private:
  bool InfiniteFar = false;
};

/// A pass, inside of a camera pass, that clears the depth to 0 and lets another pass draw reversed
/// depth.
class ReversedDepthPass
  : public vtkRenderPass
  , public vtkNBufferRenderPassTraits
{
public:
  static ReversedDepthPass* New();
  vtkTypeMacro(ReversedDepthPass, vtkRenderPass);

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::vector<vtkRenderPass*> GetDelegatePasses() override { return { this->Delegate }; }
  bool DrawsOpaquePropsTwice() const override { return this->DrawsTwice; }

  vtkSmartPointer<vtkRenderPass> Delegate;
  unsigned int DepthFunction = 0x0206; ///< The argument of glDepthFunc(), GL_GEQUAL.
  bool DrawsTwice = false;             ///< Whether another pass draws the same props.
};

/// Lets a renderer without a pass draw reversed depth: sets the camera, and the state when a frame
/// of the renderer begins and ends.
void ReverseByObservers(vtkRenderer* renderer);
}

#endif
