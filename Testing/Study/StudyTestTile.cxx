// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies of a scene beside it.
#include "LoadScene.h"

#include <gtest/gtest.h>

#include <cstddef>

// Hazard: what the user's matrix of an actor does to the place of its copy.
TEST(StudyTile, CopiesLieBesideTheirOriginals)
{
  NBufferExamples::Scene scene =
    NBufferExamples::LoadScene({ "plant" }, NBufferExamples::SceneOptions());
  const vtkBoundingBox bounds = scene.GetBounds();
  const std::size_t originals = scene.Actors.size();
  scene.Tile(static_cast<int>(2 * originals + 7));
  ASSERT_EQ(scene.Actors.size(), 2 * originals + 7);
  int matrices = 0;
  for (std::size_t i = originals; i < scene.Actors.size(); ++i)
  {
    // The first ring begins in its lower left corner; z is up.
    const double way[3] = { i < 2 * originals ? -bounds.GetLength(0) : 0.0, -bounds.GetLength(1),
      0.0 };
    vtkActor* original = scene.Actors[i % originals];
    EXPECT_EQ(scene.Actors[i]->GetMapper(), original->GetMapper());
    matrices += original->GetUserMatrix() ? 1 : 0;
    for (int j = 0; j < 6; ++j)
    {
      ASSERT_NEAR(scene.Actors[i]->GetBounds()[j], original->GetBounds()[j] + way[j / 2], 1e-9)
        << i;
    }
  }
  EXPECT_GT(matrices, 0);
}
