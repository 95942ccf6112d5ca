// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class EarlyDepthPass
 * @brief Draws opaque props twice: their depth alone, then their colours where they are seen.
 *
 * In the second drawing only what is nearest passes the depth test (VTK's is "not farther"), so
 * that a device that tests before it shades does so about once for each pixel. VTK has no shaders
 * for depth alone: the first drawing differs by masked colours only. The image is the same to the
 * bit, because the last of equal depths wins as before, and the same shader gives the same depth
 * again. To be used as the opaque pass of a vtkRenderStepsPass.
 */
#ifndef EarlyDepthPass_h
#define EarlyDepthPass_h

#include "vtkNBufferRenderPassTraits.h"

#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkRenderPass.h"

namespace NBufferPeers
{

class EarlyDepthPass
  : public vtkRenderPass
  , public vtkNBufferRenderPassTraits
{
public:
  static EarlyDepthPass* New();
  vtkTypeMacro(EarlyDepthPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override;

  ///@{
  /// What the culler wants to know.
  std::vector<vtkRenderPass*> GetDelegatePasses() override { return { this->Opaque }; }
  bool DrawsOpaquePropsTwice() const override { return true; }
  ///@}

private:
  vtkNew<vtkOpaquePass> Opaque;
};

} // namespace NBufferPeers

#endif
