// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Plant.h
 * @brief A synthetic plant: racks of pipes, tanks, vessels and steel, every part an actor.
 *
 * The plant is invented: a stress test of many thin parts that hide each other by their number,
 * where no single part hides much.
 */
#ifndef Plant_h
#define Plant_h

#include "Scene.h"

#include <cstdint>

namespace NBufferExamples
{

/**
 * Makes a plant of 120 m by 70 m, z up, in metres. The same seed gives the same plant. The scene
 * has the paths "inside", along the aisle under the pipes at 1.7 m, and "around", once around the
 * plant at 25 m.
 */
Scene MakePlant(std::uint64_t seed);

} // namespace NBufferExamples

#endif
