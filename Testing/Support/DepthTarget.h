// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthTarget.h
 * @brief A framebuffer object with a depth attachment of a chosen format, filled with noise.
 */
#ifndef DepthTarget_h
#define DepthTarget_h

#include <vector>

struct TargetFormat
{
  const char* Name;
  unsigned int InternalFormat; ///< The sized format of OpenGL, with or without stencil.
};

/// Returns the formats with 16, 24 and 32 bits, with floats, and with 24 bits and floats packed
/// with stencil.
const std::vector<TargetFormat>& GetTargetFormats();

/// Makes a program of two shaders, and expects that they compile and fit together.
unsigned int LinkProgram(const char* vertexSource, const char* fragmentSource);

/// An OpenGL context must be current for all functions, the destructor included.
class DepthTarget
{
public:
  /// With `samples` 0 there is no multisampling. The attachment is a texture if `texture` is true,
  /// else a renderbuffer.
  DepthTarget(const TargetFormat& format, int width, int height, bool texture, int samples = 0);
  ~DepthTarget();
  DepthTarget(const DepthTarget&) = delete;
  void operator=(const DepthTarget&) = delete;

  /// Returns false if the driver refuses this format or number of samples.
  bool IsComplete() const { return this->Complete; }

  /// Returns the samples per pixel that the driver chose; 0 without multisampling.
  int GetSamples() const { return this->Samples; }

  /// Binds the framebuffer for drawing and reading, with this rectangle as the viewport.
  void Bind(int x, int y, int width, int height) const;

  /**
   * Writes noise that differs in each pixel and sample. By turns, runs of five pixels have uniform
   * depths, depths crowded at 0, depths crowded at 1, and depths of exactly 0 or 1.
   */
  void Fill(unsigned int seed) const;

  /**
   * Returns the depth of one sample of each pixel as a shader reads it: width * height floats, the
   * lowest row first. The attachment must be a texture.
   */
  std::vector<float> Fetch(int sample = 0) const;

private:
  bool Complete = false;
  bool Texture = false;
  bool Stencil = false;
  int Width = 0;
  int Height = 0;
  int Samples = 0;
  unsigned int Attachment = 0;
  unsigned int Framebuffer = 0;
};

#endif
