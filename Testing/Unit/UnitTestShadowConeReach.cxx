// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which casters of a spot are left out without a litmap: never one that shadows a receiver, and
// most of those that do not.
#include "ShadowMeshes.h"

#include "vtkShadowLitmapSet.h"
#include "vtkShadowReceiverProjector.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
/// A number of any magnitude from 10^low to 10^high.
double MakeMagnitude(std::mt19937& random, double low, double high)
{
  return std::pow(10.0, MakeUniform(random, low, high));
}
}

// The two conditions of the header are as strict as the rule for all distances, and no stricter.
TEST(ShadowConeReach, ExcludesByTheRuleForAllDistances)
{
  std::mt19937 random(1);
  int excluded = 0;
  for (int i = 0; i < 20000; ++i)
  {
    vtkShadowConeReach reach;
    reach.A0 = MakeMagnitude(random, -6.0, 0.0);
    reach.A1 = MakeMagnitude(random, -6.0, 0.0);
    reach.A2 = MakeMagnitude(random, -8.0, -2.0);
    reach.Farthest = MakeMagnitude(random, 0.0, 3.0);
    reach.EyeToLight = MakeMagnitude(random, -1.0, 3.0);
    const double distance = MakeMagnitude(random, -2.0, 3.0);
    const double angle = MakeUniform(random, -0.5, 3.0);
    const double sine = angle > 1.5707963267948966 ? 1.0 : std::max(std::sin(angle), 0.0);
    double least = 1e300; // by how much the shadow's distance from the cone exceeds E, at least
    for (int k = 0; k <= 1000; ++k)
    {
      const double z = reach.Farthest * k / 1000.0;
      least = std::min(least,
        std::max(distance, z - reach.EyeToLight) * sine -
          (reach.A0 + reach.A1 * z + reach.A2 * z * z));
    }
    const bool isExcluded = reach.Excludes(distance, angle);
    excluded += isExcluded;
    EXPECT_FALSE(isExcluded && least < 0.0) << i;
    // Between two of these distances the rule may fail by a little.
    EXPECT_TRUE(isExcluded || least < 0.01 * reach.Farthest) << i;
    const vtkShadowConeReach rounded = reach.RoundedUp();
    EXPECT_TRUE(rounded.A2 >= reach.A2 && rounded.A2 < 1.1 * reach.A2);
    EXPECT_TRUE(rounded.EyeToLight >= reach.EyeToLight);
    EXPECT_FALSE(rounded.Excludes(distance, angle) && !isExcluded) << i;
  }
  EXPECT_GT(excluded, 2000);
  EXPECT_LT(excluded, 18000);
  EXPECT_FALSE(vtkShadowConeReach().Excludes(1e9, 3.0)) << "nothing is known";
}

// Hazard: a receiver is farther outside of the cone than the bound says, so that a caster that
// shadows it is left out.
TEST(ShadowConeReach, NoReceiverIsFartherFromTheCone)
{
  std::mt19937 random(2);
  int outside = 0;
  double largest = 0.0; // share of the bound
  for (int i = 0; i < 400; ++i)
  {
    vtkNew<vtkCamera> camera;
    const bool isParallel = i % 4 == 0;
    const double far = MakeMagnitude(random, 0.0, 4.0);
    const double near = far * MakeMagnitude(random, -5.0, -1.0);
    const glm::dvec3 focus = MakePoint(random, 1.0);
    camera->SetPosition(0.0, 0.0, 0.0);
    camera->SetFocalPoint(focus.x, focus.y, focus.z);
    camera->SetViewUp(0.1, 0.2, 1.0);
    camera->SetViewAngle(MakeUniform(random, 20.0, 100.0));
    camera->SetParallelProjection(isParallel);
    camera->SetParallelScale(0.3 * far);
    camera->SetClippingRange(near, far);
    vtkShadowView view;
    view.Width = 160;
    view.Height = 120;
    view.Origin = MakePoint(random, MakeMagnitude(random, 0.0, 6.0));
    view.LightingMargin = i % 3 == 0 ? 1.5 : 0.0;
    view.Push = i % 5 == 0 ? MakeMagnitude(random, -3.0, -0.5) * (isParallel ? 1.0 : near) : 0.0;
    view.ClipToWorld = vtkNBufferGLM::Invert(vtkNBufferGLM::ToMatrix(
      camera->GetCompositeProjectionTransformMatrix(4.0 / 3.0, -1.0, 1.0)->GetData()));
    vtkShadowLight light;
    light.Kind = vtkShadowLightKind::Spot;
    light.Position = view.Origin + MakePoint(random, far);
    light.Direction = glm::normalize(MakePoint(random, 1.0));
    light.ConeAngle = MakeUniform(random, 5.0, 80.0);
    const vtkShadowLightSpace space(light);
    vtkShadowReceiverProjector projector(view, light, space);
    const vtkShadowConeReach reach = projector.GetConeReach();
    for (int k = 0; k < 300; ++k)
    {
      projector.SetRow({ 0.5, 0.5 }, static_cast<int>(MakeUniform(random, 0.0, 120.0)));
      const double depth = MakeUniform(random, 0.0, 1.0);
      const auto receiver =
        projector.Project(static_cast<int>(MakeUniform(random, 0.0, 160.0)), depth);
      if (!receiver || std::isinf(receiver->Radius))
      {
        continue;
      }
      // Back from p, q and s to places relative to the light.
      const auto getPlace = [&space](const glm::dvec3& x)
      { return x.z * (x.x * space.GetU() + x.y * space.GetV() + space.GetAxis()); };
      const glm::dvec3 place = 0.5 * (getPlace(receiver->A) + getPlace(receiver->B));
      const double angle =
        std::acos(std::clamp(glm::dot(glm::normalize(place), light.Direction), -1.0, 1.0)) -
        vtkMath::RadiansFromDegrees(light.ConeAngle) - 1e-3;
      if (angle <= 0.0)
      {
        continue;
      }
      ++outside;
      const double z =
        std::min(std::max(glm::distance(getPlace(receiver->A) + light.Position, view.Origin),
                   glm::distance(getPlace(receiver->B) + light.Position, view.Origin)),
          reach.Farthest);
      const double beside = glm::length(place) * std::sin(std::min(angle, 0.5 * vtkMath::Pi()));
      const double bound = reach.A0 + reach.A1 * z + reach.A2 * z * z;
      EXPECT_LE(beside, bound) << "view " << i;
      largest = std::max(largest, beside / bound);
    }
  }
  EXPECT_GT(outside, 100);
  EXPECT_GT(largest, 0.2) << "the bound is loose";
  vtkShadowView samples;
  samples.Width = samples.Height = 10;
  samples.Samples.resize(2);
  vtkShadowLight light;
  light.Kind = vtkShadowLightKind::Spot;
  light.ConeAngle = 20.0;
  const vtkShadowReceiverProjector projector(samples, light, vtkShadowLightSpace(light));
  EXPECT_TRUE(std::isinf(projector.GetConeReach().A0)) << "multisampling";
}

// Hazard: a caster beside the cone is left out although it shadows a place near the cone, or
// casters behind a spot are drawn.
TEST(ShadowConeReach, CastersAreExcludedByTheirBounds)
{
  vtkShadowLight light;
  light.Kind = vtkShadowLightKind::Spot;
  light.Position = { 0.0, 0.0, 10.0 };
  light.Direction = { 0.0, 0.0, -1.0 };
  light.ConeAngle = 30.0;
  vtkShadowConeReach reach;
  reach.A0 = 0.5;
  reach.Farthest = 100.0;
  reach.EyeToLight = 10.0;
  const vtkShadowLitmapSet set(light, {});
  const auto isExcluded = [&](const glm::dvec3& middle, double side)
  {
    vtkShadowFootprint footprint;
    footprint.Bounds.Add(middle - 0.5 * side, middle + 0.5 * side);
    return set.IsBeyondReach(footprint, reach);
  };
  EXPECT_FALSE(isExcluded({ 0.0, 0.0, 5.0 }, 1.0)) << "in the cone";
  EXPECT_FALSE(isExcluded({ 3.5, 0.0, 5.0 }, 1.0)) << "its sphere touches the cone";
  EXPECT_TRUE(isExcluded({ 8.0, 0.0, 5.0 }, 1.0)) << "beside it";
  EXPECT_TRUE(isExcluded({ 0.0, 0.0, 15.0 }, 1.0)) << "behind the light";
  EXPECT_FALSE(isExcluded({ 0.0, 0.0, 10.2 }, 1.0)) << "around the light";
  EXPECT_FALSE(isExcluded({ 0.8, 0.0, 10.0 }, 0.5)) << "beside the light, too near";
  EXPECT_TRUE(isExcluded({ 2.0, 0.0, 10.0 }, 0.5)) << "beside the light";
  light.Kind = vtkShadowLightKind::Directional;
  EXPECT_FALSE(vtkShadowLitmapSet(light, {}).IsBeyondReach({}, reach));
}
