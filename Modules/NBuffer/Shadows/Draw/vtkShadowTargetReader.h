// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowTargetReader.h
 * @brief Reads the depth of the receivers and the masks of a vtkShadowTarget back.
 *
 * Depth has an image for each sample of a pixel, one after the other, and each image is row by row,
 * the lowest first.
 */
#ifndef vtkShadowTargetReader_h
#define vtkShadowTargetReader_h

#include "vtkShadowSampleReader.h"
#include "vtkShadowTarget.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class vtkShadowTargetReader
{
public:
  /// Begin a frame in a viewport: x, y, width and height in pixels of the target.
  void Begin(const int viewport[4]);

  /**
   * Read the depth of the receivers. Returns false, with the cause in `why`, if OpenGL refuses.
   * Waits for the device.
   */
  bool ReadReceivers(vtkOpenGLRenderWindow* window, vtkShadowTarget& target, std::string& why);

  /// Whether ReadReceivers() has succeeded in this frame.
  bool HasReceivers() const { return this->Has; }

  /// The window depth of each sample, after ReadReceivers().
  const std::vector<float>& GetDepth() const { return this->Depth; }

  /**
   * Read the mask of a light, by its number in the frame: 0 is lit, 255 is in shadow. `sample` is
   * the number of a sample; a negative number gives the mean of all samples. Returns false, with
   * the cause in `why`, if OpenGL refuses. Waits for the device.
   */
  bool ReadMask(vtkOpenGLRenderWindow* window, const vtkShadowTarget& target, std::size_t light,
    int sample, std::vector<unsigned char>& mask, std::string& why);

  /// Delete the OpenGL objects. Their context must be current.
  void Release() { this->SampleReader.Release(); }

private:
  bool ReadDepth(vtkOpenGLRenderWindow* window, vtkShadowTarget& target, std::string& why);
  std::size_t GetNumberOfPixels() const;

  vtkShadowSampleReader SampleReader;
  int Viewport[4] = { 0, 0, 0, 0 };
  bool Has = false;
  std::vector<float> Depth;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowTargetReader.h
