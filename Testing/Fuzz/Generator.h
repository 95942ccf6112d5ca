// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Generator.h
 * @brief Makes random scenarios from seeds.
 *
 * A family (Families.h) builds a scene around one hazard. Window, passes, culler,
 * materials and changes are random in addition, so that hazards meet each other. One in ten
 * scenarios begins with a named scenario (NamedScenarios.h) instead of a family.
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

/// Makes a scenario. The same seed and kind give the same scenario on every machine.
Scenario MakeScenario(std::uint64_t seed, ScenarioKind kind = ScenarioKind::Culling);
}

#endif
