// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which shadow volumes are kept from frame to frame, and how much memory they take.
#include "ShadowCaster.h"
#include "vtkShadowVolumeStore.h"

#include <gtest/gtest.h>

#include <deque>

namespace
{
/// Casters of one light, and a store of their volumes.
struct Frames
{
  explicit Frames(vtkShadowLightKind kind = vtkShadowLightKind::Directional)
    : Light(MakeLight(kind, { 0.0, 0.0, 9.0 }))
  {
  }

  void Add(double x)
  {
    this->Casters.emplace_back(MakeCube().Translate(x, 0.0, 0.0), this->Light);
    this->Parts.push_back(this->Casters.back().MakePart());
  }

  /// Computes the silhouette of a caster again, as after it has moved.
  void Move(std::size_t caster)
  {
    this->Casters[caster] =
      ShadowCaster(this->Casters[caster].Mesh.Translate(0.1, 0.0, 0.0), this->Light);
    this->Parts[caster] = this->Casters[caster].MakePart();
  }

  /// Draws the first casters whole. Returns how many pieces were made.
  int Draw(std::size_t casters)
  {
    this->Store.BeginFrame();
    for (std::size_t i = 0; i < casters; ++i)
    {
      const vtkShadowPiece piece = this->Store.GetWhole(this->Parts[i], this->Light, this->View);
      this->ExpectWhole(i, piece);
    }
    return this->Store.GetNumberOfPiecesMade();
  }

  /// The piece has the triangles of the caster's volume as it is now.
  void ExpectWhole(std::size_t caster, const vtkShadowPiece& piece) const
  {
    vtkShadowVolume expected;
    this->Casters[caster].AddWhole(expected, this->View);
    const vtkShadowVolume& volume = this->Store.GetVolume();
    ASSERT_EQ(piece.GetNumberOfIndices(), expected.GetIndices().size());
    ASSERT_LE(piece.EndIndex, volume.GetIndices().size());
    vtkShadowBlock corners;
    for (std::size_t i = 0; i < piece.GetNumberOfIndices(); ++i)
    {
      const unsigned int vertex = volume.GetIndices()[piece.FirstIndex + i];
      const glm::dvec4 place = volume.GetVertices()[vertex];
      ASSERT_EQ(place, expected.GetVertices()[expected.GetIndices()[i]]);
      const vtkShadowBlock& box = place.w != 0.0 ? piece.Points : piece.Directions;
      ASSERT_TRUE(box.Meets({ glm::dvec3(place), glm::dvec3(place) }));
      corners.Add(place);
    }
    // The boxes are as small as can be.
    vtkShadowBlock both = piece.Points;
    both.Add(piece.Directions.Low, piece.Directions.High);
    ASSERT_EQ(both.Low, corners.Low);
    ASSERT_EQ(both.High, corners.High);
  }

  vtkShadowLight Light;
  std::deque<ShadowCaster> Casters;
  std::vector<vtkShadowPart> Parts;
  vtkShadowVolumeStore Store;
  const vtkShadowBlock* View = nullptr;
};
}

TEST(ShadowVolumeStore, MakesOnlyWhatHasChanged)
{
  for (const auto kind : { vtkShadowLightKind::Directional, vtkShadowLightKind::Point })
  {
    Frames frames(kind);
    frames.Add(0.0);
    frames.Add(2.0);
    frames.Add(4.0);
    EXPECT_EQ(frames.Draw(2), 2);
    const std::size_t size = frames.Store.GetVolume().GetIndices().size();
    const vtkMTimeType time = frames.Store.GetTime();
    EXPECT_EQ(frames.Draw(2), 0);
    EXPECT_EQ(frames.Draw(1), 0) << "a caster less";
    EXPECT_EQ(frames.Draw(2), 0) << "and again, though it was not drawn in the frame before";
    EXPECT_EQ(frames.Store.GetVolume().GetIndices().size(), size);
    EXPECT_EQ(frames.Draw(3), 1) << "a new caster";
    frames.Move(1);
    EXPECT_EQ(frames.Draw(3), 1) << "one has moved";
    EXPECT_EQ(frames.Draw(3), 0);
    EXPECT_EQ(frames.Store.GetTime(), time) << "it has only grown";
  }
}

// Volumes that depend on the receivers, or on the view of a parallel camera, are made in each
// frame.
TEST(ShadowVolumeStore, MakesWhatDependsOnMoreInEachFrame)
{
  const vtkShadowBlock view = { { -5.0, -5.0, -5.0 }, { 5.0, 5.0, 5.0 } };
  for (const auto kind : { vtkShadowLightKind::Directional, vtkShadowLightKind::Spot })
  {
    Frames frames(kind);
    frames.View = &view;
    frames.Add(0.0);
    EXPECT_EQ(frames.Draw(1), 1);
    EXPECT_EQ(frames.Draw(1), 1);
  }
  Frames sun;
  sun.Add(0.0);
  EXPECT_EQ(sun.Draw(1), 1);
  EXPECT_EQ(sun.Draw(1), 0);
  const vtkShadowLightSpace space(sun.Light);
  for (int i = 0; i < 2; ++i)
  {
    sun.Store.BeginFrame();
    const vtkShadowPiece piece = sun.Store.AddClamped(
      sun.Parts[0], space, { 1.0, 2.0 }, sun.Casters[0].GetDepths(space).second);
    EXPECT_EQ(piece.EndIndex, sun.Store.GetVolume().GetIndices().size());
    EXPECT_GT(piece.GetNumberOfIndices(), 0u);
    EXPECT_EQ(sun.Store.GetNumberOfPiecesMade(), 1);
  }
}

// If everything moves, the size of the store stays in proportion to what is drawn.
TEST(ShadowVolumeStore, BeginsAgainBeforeItIsMostlyUseless)
{
  Frames frames;
  constexpr std::size_t count = 4000;
  for (std::size_t i = 0; i < count; ++i)
  {
    frames.Add(2.0 * static_cast<double>(i));
  }
  EXPECT_EQ(frames.Draw(count), static_cast<int>(count));
  const std::size_t used = frames.Store.GetVolume().GetIndices().size();
  ASSERT_GT(used, 1u << 16) << "more than a store may hold that is hardly used";
  const vtkMTimeType time = frames.Store.GetTime();
  // Looking away loses nothing.
  EXPECT_EQ(frames.Draw(0), 0);
  EXPECT_EQ(frames.Draw(0), 0);
  EXPECT_EQ(frames.Draw(count), 0);
  EXPECT_EQ(frames.Store.GetTime(), time);
  for (int frame = 0; frame < 10; ++frame)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      frames.Move(i);
    }
    EXPECT_EQ(frames.Draw(count), static_cast<int>(count));
    EXPECT_LE(frames.Store.GetVolume().GetIndices().size(), 5 * used + (1 << 16));
  }
  EXPECT_GT(frames.Store.GetTime(), time);
}
