// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowSampleReader.h
 * @brief Reads multisampled textures back, sample by sample.
 *
 * glReadPixels() does not return samples: OpenGL first reduces the samples of a pixel to one value,
 * which is any one of them for depth and their mean for colours. A shader here copies one sample of
 * each pixel into a float texture of this class, which is then read.
 */
#ifndef vtkShadowSampleReader_h
#define vtkShadowSampleReader_h

#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferModule.h" // For export macro

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class VTKNBUFFER_EXPORT vtkShadowSampleReader
{
public:
  vtkShadowSampleReader();

  /**
   * Read one channel of one sample of a GL_TEXTURE_2D_MULTISAMPLE that holds depth (in channel 0)
   * or normalised colours. `rectangle` is x, y, width and height in texels. `values` receives one
   * float in [0, 1] for each of its texels, row by row, the lowest first. Depth of 24 bits differs
   * by at most one unit in the last place of a float; 0 and 1 are exact. Returns false, with the
   * cause in `why`, if OpenGL refuses. Restores the state of OpenGL. Waits for the device.
   */
  bool Read(vtkOpenGLRenderWindow* window, unsigned int texture, int sample, int channel,
    const int rectangle[4], float* values, std::string& why);

  /// Delete the OpenGL objects. Their context must be current.
  void Release();

private:
  vtkNBufferGL::GrowingTexture Image;
  vtkNBufferGL::FullScreenPass Pass;
};
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowSampleReader.h
