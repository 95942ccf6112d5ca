// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Generator.h
 * @brief Scenarios from seeds.
 *
 * A family lays out a scene that is built around one hazard; what is random of window, passes,
 * culler, materials and changes comes on top of it, so that hazards meet each other. One in ten
 * scenarios begins as a named one (NamedScenarios.h) instead.
 */
#ifndef Generator_h
#define Generator_h

#include "Scenario.h"

#include <cstdint>

namespace TestScene
{
enum class ScenarioKind
{
  Culling,
  Shadows ///< With vtkShadowVolumeClampPass.
};

/// The same for the same seed and kind, on every machine.
Scenario MakeScenario(std::uint64_t seed, ScenarioKind kind = ScenarioKind::Culling);
}

#endif
