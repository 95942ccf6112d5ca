// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Multisampling: masks and pictures, sample by sample.
#include "PassTestTools.h"

#include "vtkShadowTarget.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{
using PassSamples = OffscreenFixture;

/// Boxes on a floor, all faces flat and diffuse, one directional light.
void AddBoxes(SceneBuilder& scene)
{
  scene.Floor(5.0);
  scene.Box({ -1.0, 0.0, 0.75 }, { 1.0, 1.0, 1.5 });
  scene.Box({ 1.0, 0.5, 0.3 }, { 0.5, 1.5, 0.6 });
  scene.Box({ 0.3, -1.2, 1.1 }, { 0.7, 0.1, 0.4 });
  scene.Directional({ 0.6, 0.35, -0.7 });
  scene.Look({ 3.0, -7.0, 5.0 }, { 0.3, 0.0, 0.3 });
}

/// RGB, 0 to 1, of what the oracle sees at a sample, shaded by itself.
glm::dvec3 Shade(
  const Oracle& oracle, int x, int y, vtkRenderer* renderer, vtkLight* light, OracleSample sample)
{
  Oracle::Receiver receiver;
  if (!oracle.GetReceiver(x, y, 0.0, 0.0, receiver))
  {
    return glm::make_vec3(renderer->GetBackground());
  }
  if (sample != OracleSample::Lit)
  {
    return glm::dvec3(0.0);
  }
  const RenderedTriangles& triangles = oracle.GetTriangles();
  vtkActor* actor = triangles.Actors[triangles.Owners[receiver.Triangle]].Actor;
  const double cosine = -vtkMath::Dot(receiver.Normal, OracleLight(light).Direction);
  return glm::min(
    glm::make_vec3(actor->GetProperty()->GetDiffuseColor()) * cosine * light->GetIntensity(), 1.0);
}

using Colors = std::vector<glm::dvec3>;

/// Of the pixels of a renderer, the means of the samples of the window's framebuffer. (What VTK
/// shows is another mean, of colours to the power of 2.2.)
Colors GetMeans(const Stage& stage)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(stage.Window);
  vtkTextureObject* texture = window->GetRenderFramebuffer()->GetColorAttachmentAsTextureObject(0);
  const int samples = static_cast<int>(GetSamplePlaces(stage.Window).size());
  int box[4];
  stage.GetRenderer()->GetTiledSizeAndOrigin(&box[2], &box[3], &box[0], &box[1]);
  Colors means(CountPixels(stage.GetRenderer()));
  std::vector<float> values(means.size());
  vtkShadowSampleReader reader;
  std::string why;
  for (int sample = 0; sample < samples; ++sample)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      EXPECT_TRUE(
        reader.Read(window, texture->GetHandle(), sample, channel, box, values.data(), why))
        << why;
      for (std::size_t i = 0; i < means.size(); ++i)
      {
        means[i][channel] += static_cast<double>(values[i]) / samples;
      }
    }
  }
  reader.Release();
  return means;
}

struct PictureComparison
{
  int Compared = 0; ///< Pixels without ambiguous samples.
  int Mixed = 0;    ///< Of these, with samples lit and in shadow.
  int Wrong = 0;    ///< Of these, off by more than rounding.
  int First[2] = { -1, -1 };
  glm::dvec3 Error = glm::dvec3(0.0); ///< The largest error, in steps of 8 bits.
};

std::ostream& operator<<(std::ostream& stream, const PictureComparison& comparison)
{
  return stream << comparison.Compared << " pixels, " << comparison.Mixed << " mixed, "
                << comparison.Wrong << " wrong, the first (" << comparison.First[0] << ", "
                << comparison.First[1] << "), off by up to " << comparison.Error.x << ", "
                << comparison.Error.y << ", " << comparison.Error.z;
}

/// The picture of the last frame with the means of samples that are shaded one by one.
PictureComparison ComparePicture(const Stage& stage, vtkLight* light)
{
  const Colors actual = GetMeans(stage);
  Oracle oracle(stage.GetRenderer());
  const int width = oracle.GetWidth();
  const std::size_t pixels = actual.size();
  Colors means(pixels);
  std::vector<unsigned char> ambiguous(pixels, 0);
  std::vector<unsigned char> kinds(pixels, 0); // 1 lit, 2 shadowed, 3 both
  const std::vector<std::array<double, 2>> places = GetSamplePlaces(stage.Window);
  for (const std::array<double, 2>& place : places)
  {
    oracle.SetSample(place[0], place[1]);
    const OracleImage expected = oracle.Cast(OracleLight(light));
    for (std::size_t i = 0; i < pixels; ++i)
    {
      const OracleSample sample = expected.Samples[i];
      means[i] += Shade(oracle, static_cast<int>(i) % width, static_cast<int>(i) / width,
                    stage.GetRenderer(), light, sample) /
        static_cast<double>(places.size());
      ambiguous[i] |= expected.Ambiguous[i];
      kinds[i] |= sample == OracleSample::Lit ? 1 : sample == OracleSample::Shadowed ? 2 : 0;
    }
  }
  // A fragment's colour is rounded to eight bits. Before that it is calculated in floats, whose
  // error OpenGL does not bound: on an NVIDIA H200 it is 0.003 steps.
  constexpr double rounding = 0.51 / 255.0;
  PictureComparison result;
  for (std::size_t i = 0; i < pixels; ++i)
  {
    if (ambiguous[i])
    {
      continue;
    }
    ++result.Compared;
    result.Mixed += kinds[i] == 3;
    const glm::dvec3 error = glm::abs(means[i] - actual[i]);
    result.Error = glm::max(result.Error, 255.0 * error);
    const bool right = glm::all(glm::lessThanEqual(error, glm::dvec3(rounding)));
    if (!right && result.Wrong++ == 0)
    {
      result.First[0] = static_cast<int>(i) % width;
      result.First[1] = static_cast<int>(i) / width;
    }
  }
  return result;
}
}

// Odd sizes, viewports away from the corner of the window, and all kinds of lights.
TEST_F(PassSamples, MasksMatchRays)
{
  for (const char* name : { "Directional", "Spot", "Point", "Inset" })
  {
    SCOPED_TRACE(name);
    Stage stage = SetNamedStage(name);
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    stage.Window->SetSize(161, 123);
    stage.GetRenderer()->SetViewport(0.11, 0.23, 0.9, 0.97);
    std::vector<std::array<double, 2>> places;
    for (const int samples : { 2, 4, 8 })
    {
      SCOPED_TRACE(std::to_string(samples) + " samples");
      stage.Window->SetMultiSamples(samples);
      stage.Window->Render();
      // Drivers give what they have.
      if (places == GetSamplePlaces(stage.Window))
      {
        continue;
      }
      places = GetSamplePlaces(stage.Window);
      ExpectAllModesMatchOracle(stage, pass);
      EXPECT_EQ(pass->GetStatistics().Samples, static_cast<int>(places.size()));
    }
  }
}

// The masks of samples must differ from what rays find at the centres of the pixels.
TEST_F(PassSamples, MasksAreNotThoseOfCentres)
{
  Stage stage = SetNamedStage("Directional");
  stage.Window->SetMultiSamples(4);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  stage.Window->Render();
  const OracleImage centres = Cast(stage.GetRenderer(), stage.Lights[0]);
  for (int i = 0; i < pass->GetStatistics().Samples; ++i)
  {
    EXPECT_FALSE(MatchesOracle(GetMask(stage, pass, 0, i), centres));
  }
}

TEST_F(PassSamples, TheMeanIsOfAllSamples)
{
  Stage stage = SetNamedStage("ManyLights");
  stage.Window->SetMultiSamples(4);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  stage.Window->Render();
  const int samples = pass->GetStatistics().Samples;
  ASSERT_GT(samples, 1);
  const std::size_t pixels = CountPixels(stage.GetRenderer());
  for (vtkLight* light : stage.Lights)
  {
    std::vector<int> sums(pixels, 0);
    for (int i = 0; i < samples; ++i)
    {
      const ShadowMask mask = GetMask(pass, light, pixels, i);
      std::transform(mask.begin(), mask.end(), sums.begin(), sums.begin(), std::plus<int>());
    }
    const ShadowMask mean = GetMask(pass, light, pixels);
    for (std::size_t i = 0; i < pixels; ++i)
    {
      ASSERT_EQ(static_cast<int>(mean[i]), (2 * sums[i] + samples) / (2 * samples)) << i;
    }
    int width = -1;
    int height = -1;
    EXPECT_TRUE(pass->GetMask(light, width, height, samples).empty());
    EXPECT_EQ(width, 0);
    EXPECT_EQ(height, 0);
  }
}

// The picture is the mean of samples that are shaded one by one.
TEST_F(PassSamples, PictureIsTheMeanOfItsSamples)
{
  const Stage stage = SetStage(AddBoxes, 200, 150, 4);
  stage.GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  stage.Window->SetSize(203, 151);
  stage.GetRenderer()->SetViewport(0.04, 0.06, 0.93, 0.97);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  for (const int mode : ShadowModes)
  {
    SCOPED_TRACE("mode " + std::to_string(mode));
    pass->SetMode(mode);
    stage.Window->Render();
    const PictureComparison comparison = ComparePicture(stage, stage.Lights[0]);
    EXPECT_EQ(comparison.Wrong, 0) << comparison;
    EXPECT_GT(comparison.Mixed, 100);
  }
}

// A plate is so thin that one sample of each pixel sees it, and no centre does.
TEST_F(PassSamples, SliverThatNoCentreSees)
{
  Stage first = SetNamedStage("Directional");
  first.Window->SetMultiSamples(4);
  first.Window->Render();
  const std::vector<std::array<double, 2>> places = GetSamplePlaces(first.Window);
  for (const std::array<double, 2>& place : places)
  {
    // A pixel is 0.1 wide; the upper half of the plate is in the shadow of a box above the view.
    const Stage stage = SetStage(
      [x = 0.1 * (20 + place[0]) - 1.65](SceneBuilder& scene)
      {
        scene.Sheet({ x - 0.005, 0.0, -0.75 }, { 0.01, 0.0, 0.0 }, { 0.0, 0.0, 1.5 });
        scene.Box({ x, -3.0, 3.55 }, { 1.0, 0.2, 1.0 });
        scene.Directional({ 0.0, 1.0, -1.0 });
        scene.LookParallel({ 0.0, -10.0, 0.0 }, { 0.0, 0.0, 0.0 }, 1.0);
      },
      33, 20, 4);
    stage.GetRenderer()->SetBackground(1.0, 1.0, 1.0);
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    for (const int mode : ShadowModes)
    {
      SCOPED_TRACE("mode " + std::to_string(mode));
      pass->SetMode(mode);
      ExpectMatchesOracle(stage, pass);
      EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
      const PictureComparison comparison = ComparePicture(stage, stage.Lights[0]);
      EXPECT_EQ(comparison.Wrong, 0) << comparison;
      // In shadow, and lit.
      const Colors means = GetMeans(stage);
      EXPECT_EQ(means[33 * 15 + 20][0], 0.75);
      EXPECT_NEAR(means[33 * 5 + 20][0], 0.75 + 0.25 * 0.4 * std::sqrt(0.5), 0.5 / 255.0);
    }
    stage.Window->SetMultiSamples(0);
    stage.Window->Render();
    EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::NoReceiver);
  }
}
