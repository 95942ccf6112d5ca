// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowSampleReader.h
 * @brief Reads multisampled textures back, sample by sample.
 *
 * OpenGL reads only what it has reduced to one sample for each pixel before: of depth any one, of
 * colour the mean. Here a shader fetches a sample of each pixel into a float texture of ours, which
 * is read. Objects grow and never shrink until released.
 */
#ifndef vtkShadowSampleReader_h
#define vtkShadowSampleReader_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include "vtkSmartPointer.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class VTKNBUFFER_EXPORT vtkShadowSampleReader
{
public:
  /**
   * Read a channel of a sample of a GL_TEXTURE_2D_MULTISAMPLE with depth (channel 0) or normalised
   * colour: `values` takes as many floats in [0, 1] as `rectangle`, x, y, width and height in
   * texels, has texels, row by row, the lowest first. Depth of 24 bits is at most one unit in the
   * last place of a float off; 0 and 1 are exact. Returns false, with the cause in `why`, if OpenGL
   * refuses. The state of OpenGL is left as it was. Waits for the device.
   */
  bool Read(vtkOpenGLRenderWindow* window, unsigned int texture, int sample, int channel,
    const int rectangle[4], float* values, std::string& why);

  /// Delete everything; the context that made it must be current.
  void Release();

private:
  bool Reserve(int width, int height, std::string& why);

  int Width = 0;
  int Height = 0;
  unsigned int Texture = 0;
  unsigned int Framebuffer = 0;
  unsigned int VertexArray = 0;
  vtkSmartPointer<vtkShaderProgram> Program;
};
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowSampleReader.h
