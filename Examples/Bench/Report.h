// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Report.h
 * @brief Figures as JSON. SCHEMA.md says what each member of a report means.
 */
#ifndef Report_h
#define Report_h

#include "vtk_jsoncpp.h"

#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace NBufferBench
{

/// Returns a quantile of values in any order, linear between neighbours; `share` is in [0, 1].
/// Returns 0 for no values.
double GetQuantile(std::vector<double> values, double share);

/// Rounds to four decimals, because nobody reads seventeen digits.
Json::Value Round(double value);

/// Returns the members `median`, `p10` and `p90`.
Json::Value Summarize(const std::vector<double>& values);

/// Milliseconds by their names in the report.
using NamedTimes = std::map<std::string, std::vector<double>>;

/// Calls measure(times) once for nothing and then `repetitions` times; returns what it measured.
template <typename Measure>
Json::Value Repeat(int repetitions, Measure&& measure)
{
  NamedTimes times;
  measure(times);
  times.clear();
  for (int i = 0; i < repetitions; ++i)
  {
    measure(times);
  }
  Json::Value row;
  for (const auto& [name, milliseconds] : times)
  {
    row[name] = Summarize(milliseconds);
  }
  return row;
}

/// Returns the first twenty places, each as a list of its numbers. A place is a list of ints, such
/// as frame, x and y.
template <typename Places>
Json::Value MakePlaces(const Places& places)
{
  Json::Value result(Json::arrayValue);
  for (std::size_t i = 0; i < places.size() && i < 20; ++i)
  {
    for (int number : places[i])
    {
      result[static_cast<Json::ArrayIndex>(i)].append(number);
    }
  }
  return result;
}

/// Adds `median_ms`, `p10_ms`, `p90_ms` and `frames_ms`, the time of each frame, to a mode.
void AddTimes(Json::Value& mode, const std::vector<double>& milliseconds);

/// Adds `ratios` to the report: for each mode and each of the references the median over the frames
/// of (time of the mode) / (time of the reference), and of its inverse. A mode with settings also
/// has the mode without them as a reference.
void AddRatios(Json::Value& report, const std::vector<std::string>& references);

/// Returns the median, member by member, of at least one value, all of the same shape. Of texts it
/// returns the most frequent one.
Json::Value GetMedian(const std::vector<Json::Value>& values);

/// Throws std::exception if a text is not JSON.
std::vector<Json::Value> ParseAll(const std::vector<std::string>& texts);

/// Does nothing without a file name. Throws std::runtime_error if the file cannot be written.
void WriteJSON(const Json::Value& value, const std::string& fileName);

/// Prints what was rendered where; one line for each mode, with its times and describe(mode); and
/// the ratios.
template <typename Describe>
void PrintModes(const Json::Value& report, const std::vector<std::string>& names, std::ostream& out,
  Describe&& describe)
{
  for (const char* name : { "scene", "path", "size", "renderer" })
  {
    out << report[name].asString() << ", ";
  }
  out << report["frames"].asInt() << " frames, " << report["props"].asInt() << " props, VTK "
      << report["vtk"].asString() << "\n";
  for (const std::string& name : names)
  {
    const Json::Value& mode = report["modes"][name];
    out << name << ": median " << mode["median_ms"].asDouble() << " ms ("
        << mode["p10_ms"].asDouble() << " to " << mode["p90_ms"].asDouble() << ")" << describe(mode)
        << "\n";
  }
  for (const std::string& name : report["ratios"].getMemberNames())
  {
    out << name << ": " << report["ratios"][name].asDouble() << "\n";
  }
}

} // namespace NBufferBench

#endif
