// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowLitmapSource
 * @brief The seam through which an experiment fills litmaps in its own way.
 *
 * The pass scatters the depth of the receivers into litmaps (vtkShadowReceivers.h). With a source
 * in vtkShadowTuning::LitmapSource it calls the source instead, so that two ways to fill a litmap
 * can be compared in whole frames. Examples/Study has one, the paper's.
 */
#ifndef vtkShadowLitmapSource_h
#define vtkShadowLitmapSource_h

#include "vtkShadowBlock.h"
#include "vtkShadowLight.h"
#include "vtkShadowLitmap.h"
#include "vtkShadowReceivers.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

class vtkShadowLitmapSource
{
public:
  virtual ~vtkShadowLitmapSource() = default;

  /// The depth of the receivers of a frame has been read: `depth` as vtkShadowReceivers::Scatter()
  /// describes it. Returns false, with the cause in `why`, if the source cannot work.
  virtual bool BeginFrame(
    vtkRenderer* renderer, const float* depth, const vtkShadowView& view, std::string& why) = 0;

  /// Fills `litmap` with what the light sees over a range of p, q and depth, as
  /// vtkShadowReceivers::GetRange() gives it. The caller builds the levels of the litmap
  /// afterwards. Returns false, with the cause in `why`, if the source cannot work.
  virtual bool Fill(const vtkShadowLightSpace& space, const vtkShadowBlock& range, int resolution,
    vtkShadowLitmap& litmap, std::string& why) = 0;

  /// Deletes the OpenGL objects; the context that made them is current.
  virtual void Release() = 0;
};

VTK_ABI_NAMESPACE_END
#endif
