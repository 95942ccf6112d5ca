// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The estimated cost of drawing whole volumes, and when litmaps are worth their cost.
#include "Pixels.h"
#include "ShadowCaster.h"

#include "vtkShadowCostModel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr int ViewWidth = 160;
constexpr int ViewHeight = 90;

/// Looks along -z from (0, 0, 3), 90 degrees upwards; near plane 0.1, far plane 100.
constexpr double ViewRows[16] = { 9.0 / 16, 0, 0, 0, 0, 1, 0, 0, 0, 0, -100.1 / 99.9,
  (3 * 100.1 - 20.0) / 99.9, 0, 0, -1, 3 };

const glm::dmat4 Clip = vtkNBufferGLM::ToMatrix(ViewRows);

/// Pixel centres in the triangles of a volume, in which no near plane cuts.
double CountFragments(const vtkShadowVolume& volume)
{
  double fragments = 0.0;
  const auto& indices = volume.GetIndices();
  for (std::size_t t = 0; t < indices.size(); t += 3)
  {
    glm::dvec4 corners[3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      corners[i] = Clip * volume.GetVertices()[indices[t + i]];
    }
    const auto getColumn = [](const glm::dvec4& corner)
    { return glm::dvec3(corner[0], corner[1], corner[3]); };
    const glm::dmat3 columns(getColumn(corners[0]), getColumn(corners[1]), getColumn(corners[2]));
    if (std::abs(glm::determinant(columns)) < 1e-12)
    {
      continue;
    }
    const glm::dmat3 inverse = glm::inverse(columns);
    const glm::dvec3 depths(corners[0][2], corners[1][2], corners[2][2]);
    for (const auto& [x, y] : Pixels(ViewWidth, ViewHeight))
    {
      // Shares of the corners in the point of the triangle's plane on this line of sight.
      const glm::dvec3 line(
        2.0 * (x + 0.5) / ViewWidth - 1.0, 2.0 * (y + 0.5) / ViewHeight - 1.0, 1.0);
      const glm::dvec3 shares = inverse * line;
      fragments += glm::all(glm::greaterThanEqual(shares, glm::dvec3(0.0))) &&
        glm::dot(shares, depths) >= -1.0;
    }
  }
  return fragments;
}

/// The estimate for two draws of a volume, where the eye is given and where it is not.
double EstimateFragments(const vtkShadowVolume& volume)
{
  const auto triangles = static_cast<int>(volume.GetIndices().size() / 3);
  std::vector<vtkShadowDraw> draws(2);
  draws[0].NumberOfIndices = 3 * (triangles / 3);
  draws[1].FirstIndex = draws[0].NumberOfIndices;
  draws[1].NumberOfIndices = 3 * triangles - draws[0].NumberOfIndices;
  vtkShadowDrawList::View view;
  view.Viewport[2] = ViewWidth;
  view.Viewport[3] = ViewHeight;
  view.Eye = { 1.0, 2.0, 3.0 };
  view.EyeToClip = glm::translate(Clip, view.Eye);
  return vtkShadowCostModel::EstimateFragments(volume, draws, view);
}

struct Volume
{
  Volume(const ShadowMesh& mesh, bool positional, int copies = 1)
  {
    const ShadowCaster caster(mesh,
      MakeLight(positional ? vtkShadowLightKind::Point : vtkShadowLightKind::Directional,
        { -3.0, 4.0, 2.5 }));
    for (int i = 0; i < copies; ++i)
    {
      caster.AddWhole(this->Mesh);
    }
    this->Expected = copies * vtkShadowCostModel::CountTriangles(caster.Silhouette, positional);
  }

  long long GetNumberOfTriangles() const
  {
    return static_cast<long long>(this->Mesh.GetIndices().size() / 3);
  }
  double Estimate() const { return EstimateFragments(this->Mesh); }

  vtkShadowVolume Mesh;
  long long Expected = 0;
};
}

// Triangles at infinity, behind the eye and outside of the view are cut as the device does it.
TEST(ShadowCostModel, EstimateIsTheNumberOfFragments)
{
  for (const ShadowMesh& mesh : { MakeTetrahedron(), MakeCube(), MakeOpenRectangle(), MakeEll(),
         MakeCube().Translate(0.0, 0.0, 2.5), MakeCube().Translate(1.5, 0.7, 1.0) })
  {
    for (const bool positional : { false, true })
    {
      SCOPED_TRACE(mesh.Name + (positional ? ", point light" : ", sun"));
      const Volume volume(mesh, positional);
      EXPECT_EQ(volume.Expected, volume.GetNumberOfTriangles());
      const double fragments = CountFragments(volume.Mesh);
      EXPECT_GT(fragments, 100.0);
      EXPECT_NEAR(volume.Estimate(), fragments, 0.02 * fragments + 20.0);
    }
  }
}

// The number of fragments of a large volume is estimated from some of its triangles.
TEST(ShadowCostModel, SomeTrianglesStandForAll)
{
  const Volume one(MakeTorus(12, 9), true);
  const Volume many(MakeTorus(12, 9), true, 101);
  ASSERT_GT(many.GetNumberOfTriangles(), 3 * 4096);
  EXPECT_NEAR(many.Estimate(), 101.0 * one.Estimate(), 5.0 * one.Estimate());
}

TEST(ShadowCostModel, NothingAndBesideTheView)
{
  EXPECT_EQ(EstimateFragments(vtkShadowVolume()), 0.0);
  EXPECT_EQ(Volume(MakeOpenRectangle().Translate(0.0, 0.0, 30.0), false).Estimate(), 0.0)
    << "behind";
}

// Litmaps are worth their cost or not: with much or little to draw, with many samples, with six
// faces.
TEST(ShadowCostModel, LitmapsPayWhereTheySaveMoreThanTheyCost)
{
  constexpr long long vga = 640 * 480;
  constexpr long long lexels = 256 * 256;
  const vtkShadowCostModel::Costs costs;
  const auto pays =
    [&costs](const vtkShadowCostModel::Volumes& volumes, const vtkShadowCostModel::Litmaps& litmaps)
  { return vtkShadowCostModel::IsLitmapWorthIt(costs.Estimate(volumes), costs.Estimate(litmaps)); };
  EXPECT_FALSE(pays({ 0.0, 0 }, { vga, vga, lexels, 1 }));
  EXPECT_FALSE(pays({ 0.9e6, 2000 }, { vga, vga, lexels, 1 })) << "a few parts";
  EXPECT_TRUE(pays({ 13e6, 250000 }, { vga, vga, lexels, 1 })) << "a city";
  EXPECT_TRUE(pays({ 5e6, 0 }, { vga, vga, lexels, 1 })) << "few triangles that cover much";
  EXPECT_TRUE(pays({ 0.0, 100000 }, { vga, vga, lexels, 1 }))
    << "many triangles that cover nothing";
  EXPECT_FALSE(pays({ 5e6, 0 }, { vga, vga, lexels, 6 })) << "of a point light";
  EXPECT_FALSE(pays({ 5e6, 0 }, { 4 * vga, 4 * vga, lexels, 1 }))
    << "with four samples for each pixel";
  EXPECT_FALSE(pays({ 1e6, 40000 }, { 2 * vga, 2 * vga, lexels, 1 }));
  EXPECT_TRUE(pays({ 1e6, 40000 }, { 2 * vga, vga / 4, lexels, 1 }))
    << "what is sky costs next to nothing";
  EXPECT_TRUE(pays({ 0.0, 5000 }, { 1000, 1000, 64 * 64, 1 })) << "an icon";
  EXPECT_FALSE(pays({ 0.0, 5000 }, { 1000, 1000, lexels, 1 }))
    << "lexels cost what they cost, however few samples";
}

namespace
{
/// A device on which all costs differ from those that are assumed, each by a factor of its own.
vtkShadowCostModel::Costs MakeDevice()
{
  vtkShadowCostModel::Costs device;
  device.Fragment *= 0.01;
  device.Triangle *= 0.02;
  device.Sample *= 3.0;
  device.Lexel *= 0.5;
  device.Covered *= 0.7;
  return device;
}

/// The costs that are measured on a device, from what it draws and makes.
vtkShadowCostModel::Costs MeasureCosts(const vtkShadowCostModel::Costs& device,
  const vtkShadowCostModel::Volumes& volumes, const vtkShadowCostModel::Litmaps& litmaps)
{
  vtkShadowCostModel::Costs costs;
  const double readTime = device.Estimate({ litmaps.Samples, 0, 0, litmaps.Faces });
  const double time = device.Estimate(litmaps) - readTime;
  costs.SetFromLitmaps(
    litmaps, readTime, time, device.Estimate({ 0, 0, litmaps.Lexels, litmaps.Faces }));
  costs.SetFromVolumes(volumes, litmaps.Samples, device.Estimate(volumes),
    device.Estimate(vtkShadowCostModel::Volumes{ 0.0, volumes.Triangles }));
  return costs;
}
}

TEST(ShadowCostModel, CostsAreThoseOfTheDevice)
{
  const vtkShadowCostModel::Costs device = MakeDevice();
  for (const int faces : { 1, 6 })
  {
    SCOPED_TRACE(faces);
    const vtkShadowCostModel::Costs costs =
      MeasureCosts(device, { 3e6, 4096 }, { 640 * 480, 200000, 256 * 256, faces });
    EXPECT_NEAR(costs.Fragment, device.Fragment, 1e-9);
    EXPECT_NEAR(costs.Triangle, device.Triangle, 1e-9);
    EXPECT_NEAR(costs.Sample, device.Sample, 1e-9);
    EXPECT_NEAR(costs.Lexel, device.Lexel, 1e-9);
    EXPECT_NEAR(costs.Covered, device.Covered, 1e-9);
  }
}

// Hazard: the difference of two times is noise if it stands for few fragments or few samples, and
// one fragment gets the cost of the noise.
TEST(ShadowCostModel, WhatIsTooLittleToBeMeasuredFollowsWhatIsMeasured)
{
  const vtkShadowCostModel::Costs assumed;
  const vtkShadowCostModel::Costs device = MakeDevice();
  vtkShadowCostModel::Costs costs =
    MeasureCosts(device, { 19199.0, 4096 }, { 307200, 19199, 65536, 1 });
  EXPECT_NEAR(costs.Fragment / assumed.Fragment, device.Triangle / assumed.Triangle, 1e-9);
  EXPECT_NEAR(costs.Covered / assumed.Covered, device.Lexel / assumed.Lexel, 1e-9);
  costs = MeasureCosts(device, { 19200.0, 4096 }, { 307200, 19200, 65536, 1 });
  EXPECT_NEAR(costs.Fragment, device.Fragment, 1e-9);
  EXPECT_NEAR(costs.Covered, device.Covered, 1e-9);
}

// A time may be measured to be longer than one that includes it.
TEST(ShadowCostModel, NoCostIsNegative)
{
  vtkShadowCostModel::Costs costs;
  costs.SetFromVolumes({ 1e6, 4096 }, 307200, 1.0, 1.1);
  EXPECT_EQ(costs.Fragment, 0.0);
  costs.SetFromLitmaps({ 307200, 307200, 65536, 1 }, 1.0, 5.0, 5.1);
  EXPECT_EQ(costs.Covered, 0.0);
}

TEST(ShadowCostModel, MeasurementIsDueOnceAndWhereItMatters)
{
  vtkShadowCostModel::Costs costs;
  EXPECT_FALSE(costs.IsMeasurementDue(0.99));
  EXPECT_TRUE(costs.IsMeasurementDue(1.0));
  costs.AreMeasured = true;
  EXPECT_FALSE(costs.IsMeasurementDue(1000.0));
}
