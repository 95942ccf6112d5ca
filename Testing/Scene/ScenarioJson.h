// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenarioJson.h
 * @brief Scenarios as JSON and back, exact to the bit.
 *
 * Finite numbers are written with 17 significant digits, enough to restore every double. Other
 * numbers, which JSON does not have, are the strings "nan", "inf" and "-inf". (The payload of a NaN
 * is lost.)
 */
#ifndef ScenarioJson_h
#define ScenarioJson_h

#include "Scenario.h"

#include "vtk_jsoncpp.h"

#include <string>

namespace TestScene
{
/// Returns a scenario as JSON, without the members that have their defaults.
Json::Value ToJson(const Scenario& scenario);

/// Returns the scenario. Throws std::runtime_error, with the place of the error, if the value is
/// not one.
Scenario FromJson(const Json::Value& value);

std::string ToText(const Json::Value& value);

///@{
/// Throw std::runtime_error, with the name of the file and the cause, if that is not possible.
Json::Value ReadJson(const std::string& fileName);
void WriteJson(const std::string& fileName, const Json::Value& value);
///@}
}

#endif
