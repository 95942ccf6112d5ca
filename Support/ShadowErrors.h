// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowErrors.h
 * @brief What is wrong with a sample whose shadow differs from the ray's, in the words that are
 * used of shadow maps.
 *
 *     outline        within 2 pixels there is a sample that the rays classify as this one was
 * drawn: the border of a shadow is displaced acne           drawn in shadow, and lit by the rays,
 * as all around it peter-panning  drawn lit, and in shadow by the rays, of a caster that is less
 * than 10 pixels' widths away: the shadow has come off its caster leak           drawn lit, and in
 * shadow by the rays, of casters that are farther away
 */
#ifndef ShadowErrors_h
#define ShadowErrors_h

#include "RayOracle.h"

enum class ShadowError
{
  Outline,
  Acne,
  PeterPanning,
  Leak
};

/// Classifies a sample that is wrong: `expected` has Lit there and it was drawn in shadow, or it
/// has Shadowed and it was drawn lit.
ShadowError ClassifyShadowError(
  const Oracle& oracle, const OracleLight& light, const OracleImage& expected, int x, int y);

#endif
