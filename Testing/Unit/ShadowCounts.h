// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowCounts.h
 * @brief What a shadow volume counts at a point, and what it should count there.
 */
#ifndef ShadowCounts_h
#define ShadowCounts_h

#include "ShadowMeshes.h"
#include "vtkShadowVolume.h"

#include <optional>
#include <random>

/// Triangles that the open segment from the light to x crosses: all, or the ones that face the
/// light as they are wound. None if that is not certain.
std::optional<int> CountByBruteForce(
  const ShadowMesh& mesh, const vtkShadowLight& light, const Point& x, bool awayOnly);

/// Signed crossings of the triangles of a volume on the way from x to infinity.
int CountInVolume(
  const vtkShadowVolume& volume, const Point& origin, const Point& x, std::mt19937& random);

/// Every directed edge is met by as many of the opposite direction.
bool IsWatertight(const vtkShadowVolume& volume);

#endif
