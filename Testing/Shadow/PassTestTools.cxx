// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PassTestTools.h"

#include "vtkNBufferVTKVersion.h"
#include VTKNBUFFER_GL_HEADER

#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderStepsPass.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{
/// A light that has cast, as it was.
struct CastingLight
{
  vtkLight* Light;
  double Intensity;
  ShadowMask Mask;
};
}

ShadowImage GetImage(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  const unsigned char* data = pixels->GetPointer(0);
  return ShadowImage(data, data + 4 * static_cast<std::size_t>(pixels->GetNumberOfTuples()));
}

::testing::AssertionResult IsSameImage(
  const ShadowImage& expected, const ShadowImage& actual, vtkRenderWindow* window)
{
  if (expected.size() != actual.size())
  {
    return ::testing::AssertionFailure()
      << "The images have " << expected.size() / 4 << " and " << actual.size() / 4 << " pixels";
  }
  std::size_t different = 0;
  std::size_t first = 0;
  for (std::size_t i = expected.size(); i > 0; i -= 4)
  {
    if (!std::equal(&expected[i - 4], &expected[i - 4] + 4, &actual[i - 4]))
    {
      ++different;
      first = i / 4 - 1;
    }
  }
  if (different == 0)
  {
    return ::testing::AssertionSuccess();
  }
  const std::size_t width = static_cast<std::size_t>(window->GetSize()[0]);
  auto result = ::testing::AssertionFailure();
  result << different << " pixels differ, the first is (" << first % width << ", " << first / width
         << "):";
  for (const ShadowImage* image : { &expected, &actual })
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      result << ' ' << static_cast<int>((*image)[4 * first + i]);
    }
    result << (image == &expected ? " expected," : " drawn");
  }
  return result;
}

::testing::AssertionResult IsSameView(
  const ShadowStage& stage, const ShadowImage& expected, const ShadowImage& actual)
{
  int size[2];
  int origin[2];
  stage.Renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const std::size_t width = static_cast<std::size_t>(stage.Window->GetSize()[0]);
  for (int y = origin[1]; y < origin[1] + size[1]; ++y)
  {
    const std::size_t first = 4 * (y * width + origin[0]);
    if (!std::equal(expected.begin() + first, expected.begin() + first + 4 * std::size_t(size[0]),
          actual.begin() + first))
    {
      return ::testing::AssertionFailure() << "row " << y << " differs";
    }
  }
  return ::testing::AssertionSuccess();
}

vtkSmartPointer<vtkShadowVolumeClampPass> AddPass(const ShadowStage& stage)
{
  auto pass = vtkSmartPointer<vtkShadowVolumeClampPass>::New();
  pass->SetMode(vtkShadowVolumeClampPass::Scissored);
  stage.Renderer->SetPass(pass);
  return pass;
}

std::size_t CountPixels(vtkRenderer* renderer)
{
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  return static_cast<std::size_t>(size[0]) * size[1];
}

std::vector<std::array<double, 2>> GetSamplePlaces(vtkRenderWindow* window)
{
  vtkOpenGLFramebufferObject* framebuffer =
    vtkOpenGLRenderWindow::SafeDownCast(window)->GetRenderFramebuffer();
  window->MakeCurrent();
  int bound = 0;
  int count = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer->GetFBOIndex());
  glGetIntegerv(GL_SAMPLES, &count);
  std::vector<std::array<double, 2>> places;
  for (int i = 0; i < count; ++i)
  {
    float place[2];
    glGetMultisamplefv(GL_SAMPLE_POSITION, i, place);
    places.push_back({ place[0], place[1] });
  }
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound);
  if (places.empty())
  {
    places.push_back({ 0.5, 0.5 });
  }
  return places;
}

ShadowMask GetMask(vtkShadowVolumeClampPass* pass, vtkLight* light, std::size_t pixels, int sample)
{
  int width = 0;
  int height = 0;
  ShadowMask mask = pass->GetMask(light, width, height, sample);
  if (mask.empty())
  {
    mask.assign(pixels, 0);
  }
  EXPECT_EQ(mask.size(), pixels);
  return mask;
}

void ExpectMatchesOracle(const ShadowStage& stage, vtkShadowVolumeClampPass* pass)
{
  stage.Window->Render();
  Oracle oracle(stage.Renderer);
  int sample = 0;
  for (const std::array<double, 2>& place : GetSamplePlaces(stage.Window))
  {
    oracle.SetSample(place[0], place[1]);
    for (vtkLight* light : stage.Lights)
    {
      const ShadowMask mask = GetMask(pass, light, CountPixels(stage.Renderer), sample);
      EXPECT_TRUE(MatchesOracle(mask, oracle.Cast(OracleLight(light))))
        << "sample " << sample << ", " << pass->GetStatistics().GetAsJSON();
    }
    ++sample;
  }
}

int ExpectComposedOfDimmed(const ShadowStage& stage, vtkShadowVolumeClampPass* pass)
{
  vtkRenderer* renderer = stage.Renderer;
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  stage.Window->Render();
  const ShadowImage actual = GetImage(stage.Window);
  std::vector<CastingLight> casting;
  int shadowed = 0;
  for (vtkLight* light : stage.Lights)
  {
    int width = 0;
    int height = 0;
    ShadowMask mask = pass->GetMask(light, width, height);
    if (mask.empty())
    {
      continue;
    }
    EXPECT_EQ(width, size[0]);
    EXPECT_EQ(height, size[1]);
    const auto full = std::count(mask.begin(), mask.end(), 255);
    if (pass->GetStatistics().Samples == 1)
    {
      EXPECT_EQ(full + std::count(mask.begin(), mask.end(), 0), static_cast<long>(mask.size()));
    }
    shadowed += static_cast<int>(full);
    casting.push_back({ light, light->GetIntensity(), std::move(mask) });
  }

  std::vector<ShadowImage> dimmed;
  for (unsigned int dim = 0; dim < 1u << casting.size(); ++dim)
  {
    for (std::size_t i = 0; i < casting.size(); ++i)
    {
      const double attenuation = (dim >> i & 1u) ? casting[i].Light->GetShadowAttenuation() : 0.0;
      casting[i].Light->SetIntensity(casting[i].Intensity * (1.0 - attenuation));
    }
    dimmed.push_back(GetPlainImage(stage.Window, renderer));
  }
  for (const CastingLight& light : casting)
  {
    light.Light->SetIntensity(light.Intensity);
  }
  ShadowImage expected = dimmed.front();
  const std::size_t windowWidth = static_cast<std::size_t>(stage.Window->GetSize()[0]);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const std::size_t inMask = static_cast<std::size_t>(y) * size[0] + x;
      std::size_t dim = 0;
      bool partly = false;
      for (std::size_t i = 0; i < casting.size(); ++i)
      {
        const unsigned char value = casting[i].Mask[inMask];
        dim |= static_cast<std::size_t>(value != 0) << i;
        partly = partly || (value > 0 && value < 255);
      }
      const std::size_t pixel = 4 * ((y + origin[1]) * windowWidth + x + origin[0]);
      std::copy_n(partly ? &actual[pixel] : &dimmed[dim][pixel], 4, &expected[pixel]);
    }
  }
  EXPECT_TRUE(IsSameImage(expected, actual, stage.Window)) << pass->GetStatistics().GetAsJSON();
  return shadowed;
}

ShadowImage GetPlainImage(vtkRenderWindow* window, vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkRenderPass> pass = renderer->GetPass();
  vtkNew<vtkRenderStepsPass> steps;
  renderer->SetPass(steps);
  window->Render();
  ShadowImage result = GetImage(window);
  steps->ReleaseGraphicsResources(window);
  renderer->SetPass(pass);
  return result;
}
