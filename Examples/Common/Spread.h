// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Spread.h
 * @brief Spreads the actors of a scene over the ranks of a parallel program.
 */
#ifndef Spread_h
#define Spread_h

#include "Scene.h"

#include <string>
#include <vector>

namespace NBufferExamples
{

/**
 * Returns the rank of each actor, from 0 to `ranks` - 1, in the order of the scene's list.
 * "random": any, the same ones in each call. "kd": the space is divided in two along the longer
 * side of what is in it, with equally many actors on both sides, again and again, until there is a
 * part for each rank. Throws std::runtime_error for another name.
 */
std::vector<int> SpreadActors(const Scene& scene, const std::string& how, int ranks);

} // namespace NBufferExamples

#endif
