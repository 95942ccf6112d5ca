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

std::string FindDifferenceInView(const Stage& stage, const Picture& expected, const Picture& actual)
{
  int region[4];
  stage.GetRenderer()->GetTiledSizeAndOrigin(&region[2], &region[3], &region[0], &region[1]);
  return FindDifference(expected, actual, region);
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

void ExpectMatchesOracle(const Stage& stage, vtkShadowVolumeClampPass* pass)
{
  stage.Window->Render();
  Oracle oracle(stage.GetRenderer());
  int sample = 0;
  for (const std::array<double, 2>& place : GetSamplePlaces(stage.Window))
  {
    oracle.SetSample(place[0], place[1]);
    for (vtkLight* light : stage.Lights)
    {
      const ShadowMask mask = GetMask(pass, light, CountPixels(stage.GetRenderer()), sample);
      EXPECT_TRUE(MatchesOracle(mask, oracle.Cast(OracleLight(light))))
        << "sample " << sample << ", " << pass->GetStatistics().GetAsJSON();
    }
    ++sample;
  }
}

int ExpectComposedOfDimmed(const Stage& stage, vtkShadowVolumeClampPass* pass)
{
  vtkRenderer* renderer = stage.GetRenderer();
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  stage.Window->Render();
  const Picture actual = TakePicture(stage.Window);
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
      const std::size_t pixel = (y + origin[1]) * windowWidth + x + origin[0];
      std::copy_n((partly ? actual : dimmed[dim]).GetColor(pixel), 4, &expected.Colors[4 * pixel]);
    }
  }
  EXPECT_EQ(FindDifference(expected, actual), "") << pass->GetStatistics().GetAsJSON();
  return shadowed;
}

Picture GetPlainImage(vtkRenderWindow* window, vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkRenderPass> pass = renderer->GetPass();
  vtkNew<vtkRenderStepsPass> steps;
  renderer->SetPass(steps);
  window->Render();
  Picture result = TakePicture(window);
  steps->ReleaseGraphicsResources(window);
  renderer->SetPass(pass);
  return result;
}
