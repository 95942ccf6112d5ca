// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowErrors.h
 * @brief What is wrong with a sample whose shadow differs from the ray's, in the words that are
 * used of shadow maps.
 *
 *  - Outline: within 2 pixels rays find what was drawn here; the border of a shadow is displaced.
 *  - Acne: anything else that was drawn in shadow and is lit by the rays.
 *  - Peter-panning: it was drawn lit, and rays find a caster less than 10 pixels' widths away; the
 *    shadow has come off its caster.
 *  - Leak: it was drawn lit, and rays find casters that are farther away.
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
