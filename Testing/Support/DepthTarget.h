// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthTarget.h
 * @brief A framebuffer object with a depth attachment of a chosen kind, filled with known noise.
 */
#ifndef DepthTarget_h
#define DepthTarget_h

#include <vector>

struct DepthFormat
{
  const char* Name;
  unsigned int InternalFormat; ///< Sized GL format, with or without stencil.
};

/// 16, 24 and 32 bits, float, and packed with stencil.
const std::vector<DepthFormat>& GetDepthFormats();

/// An OpenGL context must be current for all of it.
class DepthTarget
{
public:
  /// `samples` 0: not multisampled. The attachment is a texture or a renderbuffer.
  DepthTarget(const DepthFormat& format, int width, int height, bool texture, int samples = 0);
  ~DepthTarget();
  DepthTarget(const DepthTarget&) = delete;
  void operator=(const DepthTarget&) = delete;

  /// False if the driver refuses this format or number of samples.
  bool IsComplete() const { return this->Complete; }

  /// Samples per pixel that the driver gave, 0 without multisampling.
  int GetSamples() const { return this->Samples; }

  /// Bind for drawing and reading, with a viewport of this rectangle.
  void Bind(int x, int y, int width, int height) const;

  /**
   * Write noise that differs in each pixel and sample: uniform, crowded at 0 and crowded at 1 in
   * turn, with some exact 0 and 1.
   */
  void Fill(unsigned int seed) const;

  /**
   * The depth of one sample as a shader sees it, width * height floats; it must be a texture.
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
