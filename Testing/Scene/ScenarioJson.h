// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenarioJson.h
 * @brief Scenarios as JSON and back, exact to the bit.
 *
 * Finite numbers are written with 17 significant digits, which every double survives. JSON has no
 * others: they are the strings "nan", "inf" and "-inf" (the payload of a NaN is not kept).
 */
#ifndef ScenarioJson_h
#define ScenarioJson_h

#include "Scenario.h"

#include "vtk_jsoncpp.h"

#include <string>

namespace TestScene
{
/// Without the members that have their defaults.
Json::Value ToJson(const Scenario& scenario);

/// Throws std::runtime_error, with the place, for what is no scenario.
Scenario FromJson(const Json::Value& value);

std::string ToText(const Json::Value& value);

///@{
/// Throw std::runtime_error with the reason and the file's name.
Json::Value ReadJson(const std::string& fileName);
void WriteJson(const std::string& fileName, const Json::Value& value);
///@}
}

#endif
