// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "ModeSettings.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

namespace NBufferBench
{

double GetQuantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (place - static_cast<double>(low)) * (values[high] - values[low]);
}

Json::Value Round(double value)
{
  return std::round(value * 1e4) / 1e4;
}

Json::Value Summarize(const std::vector<double>& values)
{
  Json::Value summary;
  summary["median"] = Round(GetQuantile(values, 0.5));
  summary["p10"] = Round(GetQuantile(values, 0.1));
  summary["p90"] = Round(GetQuantile(values, 0.9));
  return summary;
}

void AddTimes(Json::Value& mode, const std::vector<double>& milliseconds)
{
  const Json::Value summary = Summarize(milliseconds);
  for (const std::string& name : summary.getMemberNames())
  {
    mode[name + "_ms"] = summary[name];
  }
  mode["frames_ms"] = Json::Value(Json::arrayValue);
  for (double value : milliseconds)
  {
    mode["frames_ms"].append(Round(value));
  }
}

void AddRatios(Json::Value& report, const std::vector<std::string>& references)
{
  const Json::Value& modes = report["modes"];
  const auto add = [&](const std::string& a, const std::string& b)
  {
    if (a == b || !modes.isMember(a) || !modes.isMember(b))
    {
      return;
    }
    std::vector<double> ratios;
    for (Json::ArrayIndex i = 0; i < modes[a]["frames_ms"].size(); ++i)
    {
      ratios.push_back(modes[a]["frames_ms"][i].asDouble() / modes[b]["frames_ms"][i].asDouble());
    }
    report["ratios"][a + "/" + b] = Round(GetQuantile(ratios, 0.5));
  };
  report["ratios"] = Json::Value(Json::objectValue);
  for (const std::string& mode : modes.getMemberNames())
  {
    add(mode, GetModeKind(mode));
    for (const std::string& reference : references)
    {
      add(mode, reference);
      add(reference, mode);
    }
  }
}

Json::Value GetMedian(const std::vector<Json::Value>& values)
{
  const Json::Value& first = values.front();
  const auto getMembers = [&values](const auto& key)
  {
    std::vector<Json::Value> members;
    std::transform(values.begin(), values.end(), std::back_inserter(members),
      [&key](const Json::Value& value) { return value.isNull() ? Json::Value(0) : value[key]; });
    return GetMedian(members);
  };
  Json::Value result(first.type());
  if (first.isObject())
  {
    for (const std::string& name : first.getMemberNames())
    {
      result[name] = getMembers(name);
    }
  }
  else if (first.isArray())
  {
    for (Json::ArrayIndex i = 0; i < first.size(); ++i)
    {
      result.append(getMembers(i));
    }
  }
  else if (first.isNumeric() && !first.isBool())
  {
    std::vector<double> numbers;
    std::transform(values.begin(), values.end(), std::back_inserter(numbers),
      [](const Json::Value& value) { return value.asDouble(); });
    result = Round(GetQuantile(numbers, 0.5));
  }
  else if (first.isString())
  {
    std::map<std::string, int> counts;
    for (const Json::Value& value : values)
    {
      ++counts[value.asString()];
    }
    result = std::max_element(counts.begin(), counts.end(),
      [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
  }
  else
  {
    result = first;
  }
  return result;
}

std::vector<Json::Value> ParseAll(const std::vector<std::string>& texts)
{
  std::vector<Json::Value> values(texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i)
  {
    std::istringstream(texts[i]) >> values[i];
  }
  return values;
}

void WriteJSON(const Json::Value& value, const std::string& fileName)
{
  if (fileName.empty())
  {
    return;
  }
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "  ";
  builder["precision"] = 8;
  std::ofstream file(fileName);
  file << Json::writeString(builder, value) << "\n";
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

} // namespace NBufferBench
