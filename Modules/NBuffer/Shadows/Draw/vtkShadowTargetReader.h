// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowTargetReader.h
 * @brief Reads back what a vtkShadowTarget holds: depth of the receivers, the masks.
 *
 * Each is of all samples of a pixel: sample by sample, in each row by row, the lowest first.
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

  /// Window depth of each sample.
  const std::vector<float>& GetDepth() const { return this->Depth; }

  /**
   * Read the mask of light `slot`, 0 lit to 255 in shadow: of a sample, or, if it is negative, the
   * mean of all. Returns false, with the cause in `why`, if OpenGL refuses.
   */
  bool ReadMask(vtkOpenGLRenderWindow* window, const vtkShadowTarget& target, std::size_t slot,
    int sample, std::vector<unsigned char>& mask, std::string& why);

  /// Delete the OpenGL objects; the context that made them must be current.
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
