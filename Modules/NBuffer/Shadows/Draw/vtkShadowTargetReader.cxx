// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTargetReader.h"

#include "vtkNBufferDepthSource.h"
#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
void vtkShadowTargetReader::Begin(const int viewport[4])
{
  std::copy_n(viewport, 4, this->Viewport);
  this->Has = false;
}

std::size_t vtkShadowTargetReader::GetNumberOfPixels() const
{
  return static_cast<std::size_t>(this->Viewport[2]) * this->Viewport[3];
}

bool vtkShadowTargetReader::ReadReceivers(
  vtkOpenGLRenderWindow* window, vtkShadowTarget& target, std::string& why)
{
  this->Has = this->ReadDepth(window, target, why);
  return this->Has;
}

bool vtkShadowTargetReader::ReadDepth(
  vtkOpenGLRenderWindow* window, vtkShadowTarget& target, std::string& why)
{
  const int* viewport = this->Viewport;
  if (target.IsMultisampled())
  {
    const std::size_t pixels = this->GetNumberOfPixels();
    const std::size_t samples = target.GetSamples().size();
    this->Depth.resize(samples * pixels);
    bool done = true;
    for (std::size_t i = 0; i < samples && done; ++i)
    {
      done = this->SampleReader.Read(window, target.GetDepth()->GetHandle(), static_cast<int>(i), 0,
        viewport, this->Depth.data() + i * pixels, why);
    }
    return done;
  }
  const vtkNBufferGL::ScopedFramebuffers bindings;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.GetDepthFramebuffer());
  vtkNBufferDepthSource source;
  return source.Inspect(window, why) &&
    source.Read(window, viewport[0], viewport[1], viewport[2], viewport[3], this->Depth, why);
}

bool vtkShadowTargetReader::ReadMask(vtkOpenGLRenderWindow* window, const vtkShadowTarget& target,
  std::size_t light, int sample, std::vector<unsigned char>& mask, std::string& why)
{
  constexpr std::size_t each = vtkShadowTarget::LightsPerMask;
  const int number = vtkShadowTarget::GetMaskIndex(light);
  const int channel = vtkShadowTarget::GetChannel(light);
  const int* viewport = this->Viewport;
  mask.resize(this->GetNumberOfPixels());
  if (!target.IsMultisampled())
  {
    std::vector<unsigned char> pixels(each * mask.size());
    vtkNBufferGL::ClearErrors();
    const vtkNBufferGL::ScopedReadback readback(target.GetMaskFramebuffer(number));
    glReadPixels(
      viewport[0], viewport[1], viewport[2], viewport[3], GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      mask[i] = pixels[each * i + channel];
    }
    return vtkNBufferGL::CheckErrors("Reading a shadow mask", why);
  }
  const int samples = static_cast<int>(target.GetSamples().size());
  const int first = std::max(sample, 0);
  const int last = sample < 0 ? samples : sample + 1;
  std::vector<float> values(mask.size());
  std::vector<float> sums(mask.size(), 0.0f);
  for (int i = first; i < last; ++i)
  {
    if (!this->SampleReader.Read(
          window, target.GetMask(number)->GetHandle(), i, channel, viewport, values.data(), why))
    {
      return false;
    }
    for (std::size_t k = 0; k < mask.size(); ++k)
    {
      sums[k] += values[k];
    }
  }
  std::transform(sums.begin(), sums.end(), mask.begin(),
    [&](float sum)
    { return static_cast<unsigned char>(255.0f * sum / static_cast<float>(last - first) + 0.5f); });
  return true;
}
VTK_ABI_NAMESPACE_END
