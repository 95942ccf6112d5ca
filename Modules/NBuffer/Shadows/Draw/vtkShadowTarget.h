// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowTarget.h
 * @brief The framebuffers in which shadows are counted, and the masks that result.
 *
 * Before VTK 9.7, VTK's own framebuffers have no stencil buffer. OpenGL reports no error then, but
 * the stencil test always passes. So this class has its own depth and stencil (24 and 8 bits), in a
 * texture that several framebuffers share:
 *
 *     framebuffer   colour     depth and stencil
 *     depth         none       shared      receivers and shadow volumes are drawn into it
 *     mask i        mask i     shared      the masks of the lights 4 i to 4 i + 3 are made in it
 *
 * A mask is an RGBA8 texture with a channel for each light: 0 where the light shines, 255 where it
 * does not.
 *
 *     light      0   1   2   3   4   5   6  ...
 *     mask       0   0   0   0   1   1   1  ...
 *     channel    r   g   b   a   r   g   b  ...
 *
 * All textures have as many samples as the framebuffer for which the shadows are made, at the same
 * places in a pixel. With several samples they are GL_TEXTURE_2D_MULTISAMPLE with fixed sample
 * locations, else GL_TEXTURE_2D. The objects grow and never shrink until Release().
 */
#ifndef vtkShadowTarget_h
#define vtkShadowTarget_h

#include "Shaders/vtkNBufferShared.h"
#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferGLObject.h"
#include "vtkNBufferModule.h" // For export macro

#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

/**
 * Reads multisampled textures back, sample by sample. glReadPixels() does not return samples:
 * OpenGL first reduces the samples of a pixel to one value, which is any one of them for depth and
 * their mean for colours. A shader here copies one sample of each pixel into a float texture of
 * this class, which is then read.
 */
class VTKNBUFFER_EXPORT vtkShadowSampleReader
{
public:
  vtkShadowSampleReader();

  /**
   * Reads one channel of one sample of a GL_TEXTURE_2D_MULTISAMPLE that holds depth (in channel 0)
   * or normalised colours. `rectangle` is x, y, width and height in texels. `values` receives one
   * float in [0, 1] for each of its texels, row by row, the lowest first. Depth of 24 bits differs
   * by at most one unit in the last place of a float; 0 and 1 are exact. Returns false, with the
   * cause in `why`, if an OpenGL call fails. Restores the state of OpenGL. Waits for the device.
   */
  bool Read(vtkOpenGLRenderWindow* window, unsigned int texture, int sample, int channel,
    const int rectangle[4], float* values, std::string& why);

  /// Deletes the OpenGL objects. Their context must be current.
  void Release();

private:
  vtkNBufferGL::GrowingTexture Image;
  vtkNBufferGL::FullScreenPass Pass;
};

/// The framebuffers in which shadows are counted, and their masks.
class VTKNBUFFER_EXPORT vtkShadowTarget
{
public:
  static constexpr int LightsPerMask = NBUFFER_SHADOW_LIGHTS_PER_MASK;

  ///@{
  /// The mask of a light and its channel there, and the number of masks for a number of lights.
  static int GetMaskIndex(std::size_t light) { return static_cast<int>(light) / LightsPerMask; }
  static int GetChannel(std::size_t light) { return static_cast<int>(light) % LightsPerMask; }
  static int CountMasks(std::size_t lights) { return GetMaskIndex(lights + LightsPerMask - 1); }
  ///@}

  using SamplePlaces = vtkNBufferGL::SamplePlaces;

  /**
   * Makes room for images of at least this size in pixels, for this many masks, with these samples
   * of a pixel. If textures on this device cannot have these samples, they get one for each pixel,
   * HasRefusedSamples() is true, and the cause is in `why`. Returns false, with the cause and a
   * remedy in `why`, if that fails, too, or if the window has too few texture units for so many
   * masks. Restores the draw and read framebuffer.
   */
  bool Reserve(vtkOpenGLRenderWindow* window, int width, int height, int masks,
    const SamplePlaces& samples, std::string& why);

  ///@{
  /// The samples that the textures have, and whether the device refused those for Reserve().
  const SamplePlaces& GetSamples() const { return this->Samples; }
  bool IsMultisampled() const { return this->Samples.size() > 1; }
  bool HasRefusedSamples() const { return !this->RefusedSamples.empty(); }
  ///@}

  ///@{
  /// Size of the textures in pixels, and the number of masks; all are 0 before Reserve().
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  int GetNumberOfMasks() const { return static_cast<int>(this->Masks.size()); }
  ///@}

  ///@{
  /// GL names of the framebuffers; 0 before Reserve().
  unsigned int GetDepthFramebuffer() const { return this->DepthFramebuffer.GetName(); }
  unsigned int GetMaskFramebuffer(int mask) const
  {
    return this->Masks[mask].Framebuffer.GetName();
  }
  ///@}

  ///@{
  /// The textures for shaders. Depth is nullptr without multisampling, where no shader needs it.
  vtkTextureObject* GetMask(int mask) const { return this->Masks[mask].Texture; }
  vtkTextureObject* GetDepth() const { return this->IsMultisampled() ? this->Depth : nullptr; }
  ///@}

  /**
   * Reads the depth of the receivers in a viewport (x, y, width and height in pixels): an image for
   * each sample, one after the other. Images are row by row, the lowest first. Returns false, with
   * the cause in `why`, if an OpenGL call fails. Waits for the device.
   */
  bool ReadDepth(vtkOpenGLRenderWindow* window, const int viewport[4], std::vector<float>& depth,
    std::string& why);

  /// Reads the mask of a light, given by its number, in the same way: 0 is lit, 255 is in shadow.
  /// `sample` is the number of a sample; a negative number gives the mean of all samples.
  bool ReadMask(vtkOpenGLRenderWindow* window, const int viewport[4], std::size_t light, int sample,
    std::vector<unsigned char>& mask, std::string& why);

  /// How often memory was requested from OpenGL since construction.
  int GetNumberOfAllocations() const { return this->Allocations; }

  /// Deletes the OpenGL objects. Their context must be current.
  void Release();

private:
  struct Mask
  {
    vtkNBufferGL::Framebuffer Framebuffer;
    vtkSmartPointer<vtkTextureObject> Texture;
  };

  bool Allocate(vtkOpenGLRenderWindow* window, int width, int height, int masks, std::string& why);
  vtkSmartPointer<vtkTextureObject> NewTexture(vtkOpenGLRenderWindow* window);
  bool Attach(vtkNBufferGL::Framebuffer& framebuffer, vtkTextureObject* color, std::string& why);
  void Free();

  SamplePlaces Samples = { { { 0.5, 0.5 } } };
  SamplePlaces RefusedSamples; ///< The samples that Reserve() could not provide, or empty.
  int Width = 0;
  int Height = 0;
  int Allocations = 0;
  vtkSmartPointer<vtkTextureObject> Depth; ///< Depth and stencil.
  vtkNBufferGL::Framebuffer DepthFramebuffer;
  std::vector<Mask> Masks;
  vtkShadowSampleReader SampleReader;
};
VTK_ABI_NAMESPACE_END
#endif
