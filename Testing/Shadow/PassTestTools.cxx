// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PassTestTools.h"

#include "vtkNBufferGL.h"

#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <map>

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

vtkSmartPointer<vtkShadowVolumeClampPass> AddPass(const Stage& stage)
{
  auto pass = vtkSmartPointer<vtkShadowVolumeClampPass>::New();
  pass->SetMode(vtkShadowVolumeClampPass::Scissored);
  stage.GetRenderer()->SetPass(pass);
  return pass;
}

std::size_t CountPixels(vtkRenderer* renderer)
{
  const vtkNBufferRectangle pixels = GetPixels(renderer);
  return static_cast<std::size_t>(pixels.GetWidth()) * pixels.GetHeight();
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

ShadowMask GetMask(
  const Stage& stage, vtkShadowVolumeClampPass* pass, std::size_t light, int sample)
{
  stage.MakeCurrent();
  return GetMask(pass, stage.Lights[light], CountPixels(stage.GetRenderer()), sample);
}

std::vector<ShadowMask> GetMasks(const Stage& stage, vtkShadowVolumeClampPass* pass)
{
  std::vector<ShadowMask> masks;
  for (std::size_t i = 0; i < stage.Lights.size(); ++i)
  {
    masks.push_back(GetMask(stage, pass, i));
  }
  return masks;
}

int CountShadowed(const ShadowMask& mask)
{
  return static_cast<int>(std::count(mask.begin(), mask.end(), 255));
}

GLStateSnapshot CaptureFrame(const Stage& stage)
{
  GLStateSnapshot result;
  OffscreenFixture::WhileDrawing(stage.Window, stage.GetRenderer(),
    [&] { result = GLStateSnapshot::Capture(vtkOpenGLRenderWindow::SafeDownCast(stage.Window)); });
  return result;
}

GLObjects::Counts CountObjects(const Stage& stage)
{
  stage.MakeCurrent();
  return GLObjects::Count();
}

GLObjects::Counts CountObjectsWithoutPrograms(const Stage& stage)
{
  GLObjects::Counts counts = CountObjects(stage);
  counts.erase("programs");
  counts.erase("shaders");
  return counts;
}

Picture RenderPicture(const Stage& stage)
{
  stage.Window->Render();
  return TakePicture(stage.Window);
}

void ExpectMatchesOracle(const Stage& stage, vtkShadowVolumeClampPass* pass)
{
  stage.Window->Render();
  Oracle oracle(stage.GetRenderer());
  int sample = 0;
  for (const std::array<double, 2>& place : GetSamplePlaces(stage.Window))
  {
    oracle.SetSample(place[0], place[1]);
    for (std::size_t i = 0; i < stage.Lights.size(); ++i)
    {
      const OracleImage rays = oracle.Cast(OracleLight(stage.Lights[i]));
      EXPECT_TRUE(MatchesOracle(GetMask(stage, pass, i, sample), rays))
        << "sample " << sample << ", " << pass->GetStatistics().GetAsJSON();
    }
    ++sample;
  }
}

void ExpectAllModesMatchOracle(const Stage& stage, vtkShadowVolumeClampPass* pass)
{
  stage.Window->Render();
  const std::vector<std::array<double, 2>> places = GetSamplePlaces(stage.Window);
  using Masks = std::map<int, ShadowMask>; // by mode
  std::vector<Masks> all(places.size() * stage.Lights.size());
  for (const int mode : ShadowModes)
  {
    pass->SetMode(mode);
    stage.Window->Render();
    EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
    EXPECT_EQ(pass->GetStatistics().PixelFrames, 0);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      const int sample = static_cast<int>(i % places.size());
      all[i][mode] = GetMask(stage, pass, i / places.size(), sample);
    }
  }
  Oracle oracle(stage.GetRenderer());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const std::size_t light = i / places.size();
    const std::array<double, 2>& place = places[i % places.size()];
    SCOPED_TRACE(
      "light " + std::to_string(light) + ", sample " + std::to_string(i % places.size()));
    oracle.SetSample(place[0], place[1]);
    const OracleImage rays = oracle.Cast(OracleLight(stage.Lights[light]));
    for (const auto& [mode, mask] : all[i])
    {
      EXPECT_TRUE(MatchesOracle(mask, rays)) << "mode " << mode;
    }
    const ShadowMask& unclamped = all[i][vtkShadowVolumeClampPass::Unclamped];
    const ShadowMask& scissored = all[i][vtkShadowVolumeClampPass::Scissored];
    int differing = 0;
    for (std::size_t k = 0; k < rays.Samples.size(); ++k)
    {
      differing += IsLitOrShadowed(rays, k) && unclamped[k] != scissored[k];
    }
    EXPECT_EQ(differing, 0) << "Scissored differs from Unclamped";
  }
}

int ExpectComposedOfDimmed(const Stage& stage, vtkShadowVolumeClampPass* pass)
{
  vtkRenderer* renderer = stage.GetRenderer();
  const vtkNBufferRectangle view = GetPixels(renderer);
  const Picture actual = RenderPicture(stage);
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
    EXPECT_EQ(width, view.GetWidth());
    EXPECT_EQ(height, view.GetHeight());
    const int full = CountShadowed(mask);
    if (pass->GetStatistics().Samples == 1)
    {
      EXPECT_EQ(full + std::count(mask.begin(), mask.end(), 0), static_cast<long>(mask.size()));
    }
    shadowed += full;
    casting.push_back({ light, light->GetIntensity(), std::move(mask) });
  }

  std::vector<Picture> dimmed;
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
  Picture expected = dimmed.front();
  const std::size_t windowWidth = static_cast<std::size_t>(actual.Size[0]);
  std::size_t inMask = 0;
  for (const auto& [x, y] : Pixels(view))
  {
    std::size_t dim = 0;
    bool partly = false;
    for (std::size_t i = 0; i < casting.size(); ++i)
    {
      const unsigned char value = casting[i].Mask[inMask];
      dim |= static_cast<std::size_t>(value != 0) << i;
      partly = partly || (value > 0 && value < 255);
    }
    ++inMask;
    const std::size_t pixel = y * windowWidth + x;
    std::copy_n((partly ? actual : dimmed[dim]).GetColor(pixel), 4, &expected.Colors[4 * pixel]);
  }
  EXPECT_EQ(FindDifference(expected, actual), "") << pass->GetStatistics().GetAsJSON();
  return shadowed;
}

Picture GetPlainImage(vtkRenderWindow* window, vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkRenderPass> pass = renderer->GetPass();
  renderer->SetPass(nullptr);
  window->Render();
  Picture result = TakePicture(window);
  renderer->SetPass(pass);
  return result;
}
