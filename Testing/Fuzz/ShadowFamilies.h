// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowFamilies.h
 * @brief The families of random scenes around hazards of shadow volumes, and random lights.
 */
#ifndef ShadowFamilies_h
#define ShadowFamilies_h

#include "Families.h"

namespace TestScene
{
const std::vector<NamedFamily>& GetShadowFamilies();

/// Adds lights, shadow passes and their changes to a scene that has everything else.
void AddShadows(Writer& writer);
}

#endif
