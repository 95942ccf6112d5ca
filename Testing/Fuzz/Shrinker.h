// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Shrinker.h
 * @brief From a scenario that fails to a small one that still does.
 *
 * Works on JSON, where it knows of two things only: elements of arrays can be left out, and members
 * of objects, which then have their defaults. Arrays are thinned by delta debugging (A. Zeller,
 * R. Hildebrandt, "Simplifying and isolating failure-inducing input", 2002).
 */
#ifndef Shrinker_h
#define Shrinker_h

#include "vtk_jsoncpp.h"

#include <functional>

namespace TestScene
{
/// Whether something still fails. Shrink() calls it at most `budget` times.
using Oracle = std::function<bool(const Json::Value&)>;

struct ShrinkResult
{
  Json::Value Value;
  int Questions = 0;
};

/**
 * `value` must fail. Nothing can be taken out of the result without its ceasing to, unless the
 * budget was spent. Members whose names are in `keep` are not touched.
 */
ShrinkResult Shrink(const Json::Value& value, const Oracle& fails, int budget);
}

#endif
