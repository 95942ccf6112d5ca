// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowTarget.h
 * @brief The OpenGL objects that shadows are counted in: depth and stencil of the receivers, masks.
 *
 * VTK's own framebuffers have no stencil before 9.7, and nothing tells: without one the stencil
 * test passes. So depth and stencil (24 and 8 bits) are a texture of ours, in two framebuffers:
 *
 *     depth     depth and stencil alone, without colour: receivers and volumes are drawn into it
 *     mask i    depth and stencil with mask i as colour
 *
 * A mask is an RGBA8 texture: channel c of mask i belongs to the light 4 i + c, 0 where it shines
 * and 255 where it does not. Objects grow and never shrink until released.
 *
 * All have the samples of the framebuffer that shadows are for, at the same places in a pixel. With
 * more than one they are GL_TEXTURE_2D_MULTISAMPLE with fixed sample locations, else GL_TEXTURE_2D.
 */
#ifndef vtkShadowTarget_h
#define vtkShadowTarget_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;

class VTKNBUFFER_EXPORT vtkShadowTarget
{
public:
  static constexpr int LightsPerMask = 4;

  /// Places of the samples in a pixel, in [0, 1] from its lower left corner; one: its centre.
  using SamplePlaces = std::vector<std::array<double, 2>>;

  /// Those of the framebuffer that is bound for drawing.
  static SamplePlaces GetBoundSamples();

  /**
   * Room for images of at least this size and this many masks, with these samples. Where the device
   * has no such samples for textures, there is one for each pixel, and HasRefusedSamples() says so.
   * Returns false, with the cause and a remedy in `why`, if OpenGL refuses that, too. Leaves the
   * draw and read framebuffer bound as they were.
   */
  bool Reserve(vtkOpenGLRenderWindow* window, int width, int height, int masks,
    const SamplePlaces& samples, std::string& why);

  const SamplePlaces& GetSamples() const { return this->Samples; }
  bool IsMultisampled() const { return this->Samples.size() > 1; }
  bool HasRefusedSamples() const { return !this->RefusedSamples.empty(); }

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  int GetNumberOfMasks() const { return static_cast<int>(this->Masks.size()); }

  /// GL names of the framebuffers; 0 before Reserve().
  unsigned int GetDepthFramebuffer() const { return this->DepthFramebuffer; }
  unsigned int GetMaskFramebuffer(int mask) const { return this->Masks[mask].Framebuffer; }

  vtkTextureObject* GetMask(int mask) const { return this->Masks[mask].Texture; }
  /// To sample; nullptr without multisampling.
  vtkTextureObject* GetDepth() const { return this->Depth; }

  /// Times that OpenGL was asked for memory since construction.
  int GetNumberOfAllocations() const { return this->Allocations; }

  /// Delete everything; the context that made it must be current.
  void Release();

private:
  struct Mask
  {
    unsigned int Framebuffer = 0;
    vtkSmartPointer<vtkTextureObject> Texture;
  };

  bool Allocate(vtkOpenGLRenderWindow* window, int width, int height, int masks, std::string& why);
  bool AllocateDepth(vtkOpenGLRenderWindow* window, std::string& why);
  vtkSmartPointer<vtkTextureObject> NewTexture(vtkOpenGLRenderWindow* window) const;
  bool AllocateMask(vtkOpenGLRenderWindow* window, Mask& mask, std::string& why);
  static void FreeMask(Mask& mask);
  bool Attach(unsigned int framebuffer, unsigned int color, std::string& why);
  unsigned int GetTextureTarget() const;
  void Free();

  SamplePlaces Samples = { { { 0.5, 0.5 } } };
  SamplePlaces RefusedSamples; ///< Empty, or those that Reserve() asked for in vain.
  int Width = 0;
  int Height = 0;
  int Allocations = 0;
  unsigned int DepthStencil = 0;
  vtkSmartPointer<vtkTextureObject> Depth; ///< The same, if it is multisampled.
  unsigned int DepthFramebuffer = 0;
  std::vector<Mask> Masks;
};
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowTarget.h
