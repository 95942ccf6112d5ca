// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudySettingsTables.h
 * @brief The figures of StudySettings.h as tables, charts and CSV.
 */
#ifndef StudySettingsTables_h
#define StudySettingsTables_h

#include "vtk_jsoncpp.h"

#include <string>

namespace NBufferBench
{

/// A row for each path, or scene and mode, a column for each value of the setting.
std::string MakeSettingTable(const Json::Value& settings, const std::string& setting);

/// Few props in view, by number.
std::string MakeFewTable(const Json::Value& settings);

/// `folder`/settings-SCENE-PATH of the culler, `folder`/settings-SCENE of shadows, .png and .svg:
/// error against time of every point.
void WriteSettingsCharts(const Json::Value& settings, const std::string& folder);

/// Whether there is a chart of this name.
bool HasSettingsChart(const Json::Value& settings, const std::string& name);

/// Every point, one a line. Throws std::runtime_error when it cannot be written.
void WriteSettingsCSV(const Json::Value& settings, const std::string& fileName);

} // namespace NBufferBench

#endif
