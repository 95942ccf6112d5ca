// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowTargetReader.h
 * @brief Reads back what a vtkShadowTarget holds: depth of the receivers, their lights, the masks.
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
  /// How many lights the colour of NBufferShadowReceiver (vtkShadowLightDec.glsl) has room for.
  static constexpr std::size_t FilteredLights = 24;

  /// Begin a frame with so many lights in a viewport (x, y, width, height in pixels of the target).
  void Begin(const int viewport[4], std::size_t lights);

  /**
   * Read the depth of the receivers and, if lit, what lights they have. Returns false, with the
   * cause in `why`, if OpenGL refuses. Waits for the device.
   */
  bool ReadReceivers(
    vtkOpenGLRenderWindow* window, vtkShadowTarget& target, bool lit, std::string& why);

  /// Whether ReadReceivers() has succeeded in this frame.
  bool HasReceivers() const { return this->Has; }

  /// Window depth of each sample.
  const std::vector<float>& GetDepth() const { return this->Depth; }

  /**
   * For each sample whether light `slot` can change it; nullptr if that was not read or the colour
   * has no room for the light. IsUnlit() answers for the light from now on.
   */
  const unsigned char* FindLit(std::size_t slot);

  /**
   * Read the mask of light `slot`, 0 lit to 255 in shadow or left out by FindLit(): of a sample,
   * or, if it is negative, the mean of all. Returns false, with the cause in `why`, if OpenGL
   * refuses.
   */
  bool ReadMask(vtkOpenGLRenderWindow* window, const vtkShadowTarget& target, std::size_t slot,
    int sample, std::vector<unsigned char>& mask, std::string& why);

  /// Delete the OpenGL objects; the context that made them must be current.
  void Release() { this->SampleReader.Release(); }

private:
  bool ReadDepth(vtkOpenGLRenderWindow* window, vtkShadowTarget& target, std::string& why);
  bool ReadLights(vtkOpenGLRenderWindow* window, vtkShadowTarget& target, std::string& why);
  bool IsUnlit(std::size_t slot, std::size_t sample) const;
  std::size_t GetNumberOfPixels() const;

  vtkShadowSampleReader SampleReader;
  int Viewport[4] = { 0, 0, 0, 0 };
  bool Has = false;
  std::vector<float> Depth;
  std::vector<unsigned char> LitBits; ///< Four of each sample: bit i for light i, if it is lit.
  std::vector<unsigned char> Lit;     ///< Samples, by the light of FindLit().
  std::vector<bool> Filtered;         ///< Lights that FindLit() was asked for.
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowTargetReader.h
