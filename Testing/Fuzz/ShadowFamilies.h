// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowFamilies.h
 * @brief Scenes around the hazards of shadow volumes, and the lights in them and in other scenes.
 */
#ifndef ShadowFamilies_h
#define ShadowFamilies_h

#include "Families.h"

namespace TestScene
{
const std::vector<NamedFamily>& GetShadowFamilies();

/// Lights, passes with shadow volumes and their changes for a scene that is complete otherwise.
void AddShadows(Writer& writer);
}

#endif
