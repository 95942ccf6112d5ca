// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowLitmapSource
 * @brief Interface of an experiment that fills litmaps in its own way.
 *
 * The pass scatters the depth of the receivers into litmaps (vtkShadowReceivers.h). If
 * vtkShadowTuning::LitmapSource is set, the pass calls this source instead, so that two ways to
 * fill a litmap can be compared in whole frames. Examples/Peers has a source that fills litmaps as
 * Decoret's paper does (vtkShadowLitmap.h).
 */
#ifndef vtkShadowLitmapSource_h
#define vtkShadowLitmapSource_h

#include "vtkShadowBlock.h"
#include "vtkShadowLight.h"
#include "vtkShadowLitmap.h"
#include "vtkShadowReceiverProjector.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

class vtkShadowLitmapSource
{
public:
  virtual ~vtkShadowLitmapSource() = default;

  /// Called when the depth of the receivers of a frame has been read. `depth` is as
  /// vtkShadowReceivers::Scatter() describes it, but view.Samples does not list the samples of a
  /// pixel. Returns false, with the cause in `why`, if the source cannot work.
  virtual bool BeginFrame(
    vtkRenderer* renderer, const float* depth, const vtkShadowView& view, std::string& why) = 0;

  /// Fills `litmap`, beginning with vtkShadowLitmap::Begin(), with the receivers in a range of p, q
  /// and s that vtkShadowReceivers::GetRange() has found. The caller builds the levels of the
  /// litmap afterwards. Returns false, with the cause in `why`, if the source cannot work.
  virtual bool Fill(const vtkShadowLightSpace& space, const vtkShadowBlock& range, int resolution,
    vtkShadowLitmap& litmap, std::string& why) = 0;

  /// Deletes the OpenGL objects. Their context is current.
  virtual void Release() = 0;
};

VTK_ABI_NAMESPACE_END
#endif
