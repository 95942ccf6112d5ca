// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Shrinker.h
 * @brief Finds a small scenario that still fails, from a larger one.
 *
 * The shrinker works on JSON and does three things: it leaves out elements of arrays, it leaves out
 * members of objects, which then have their defaults, and it lowers the number of frames. Arrays
 * are thinned by delta debugging (A. Zeller, R. Hildebrandt, "Simplifying and isolating
 * failure-inducing input", 2002).
 */
#ifndef Shrinker_h
#define Shrinker_h

#include "vtk_jsoncpp.h"

#include <functional>

namespace TestScene
{
/// Returns whether a scenario still fails.
using Oracle = std::function<bool(const Json::Value&)>;

struct ShrinkResult
{
  Json::Value Value;
  int Questions = 0; ///< How often the oracle was called.
};

/**
 * Shrinks a scenario that fails. Without any one more of its elements or members the result would
 * no longer fail, unless `budget` calls of `fails` were not enough to find that out. Ids and the
 * seed are kept.
 */
ShrinkResult Shrink(const Json::Value& value, const Oracle& fails, int budget);
}

#endif
