// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "ModeSettings.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <memory>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace NBufferBench
{
Json::Value Round(double value)
{
  return std::round(value * 1e4) / 1e4;
}

Json::Value Parse(const std::string& text)
{
  Json::Value value;
  std::string errors;
  const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
  if (!reader->parse(text.data(), text.data() + text.size(), &value, &errors))
  {
    throw std::runtime_error("the statistics are no JSON: " + errors);
  }
  return value;
}

Json::Value GetMedian(const std::vector<Json::Value>& values)
{
  const Json::Value& first = values.front();
  Json::Value result(first.type());
  if (first.isObject())
  {
    for (const std::string& name : first.getMemberNames())
    {
      std::vector<Json::Value> members;
      for (const Json::Value& value : values)
      {
        members.push_back(value[name]);
      }
      result[name] = GetMedian(members);
    }
  }
  else if (first.isArray())
  {
    for (Json::ArrayIndex i = 0; i < first.size(); ++i)
    {
      std::vector<Json::Value> items;
      for (const Json::Value& value : values)
      {
        items.push_back(value.get(i, Json::Value(0)));
      }
      result.append(GetMedian(items));
    }
  }
  else if (first.isNumeric() && !first.isBool())
  {
    std::vector<double> numbers;
    for (const Json::Value& value : values)
    {
      numbers.push_back(value.asDouble());
    }
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

double GetMedianRatio(const ModeResult& a, const ModeResult& b)
{
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.Milliseconds.size(); ++i)
  {
    ratios.push_back(a.Milliseconds[i] / b.Milliseconds[i]);
  }
  return GetQuantile(ratios, 0.5);
}

Json::Value SummarizeTimes(const ModeResult& mode)
{
  Json::Value result;
  result["median_ms"] = Round(GetQuantile(mode.Milliseconds, 0.5));
  result["p10_ms"] = Round(GetQuantile(mode.Milliseconds, 0.1));
  result["p90_ms"] = Round(GetQuantile(mode.Milliseconds, 0.9));
  Json::Value& each = result["frames_ms"] = Json::Value(Json::arrayValue);
  for (double milliseconds : mode.Milliseconds)
  {
    each.append(Round(milliseconds));
  }
  return result;
}

namespace
{
Json::Value SummarizeStatistics(const std::vector<std::string>& texts)
{
  std::vector<Json::Value> frames;
  std::vector<Json::Value> tested;
  std::vector<double> perProp;
  Json::Value decisions(Json::objectValue);
  for (const std::string& text : texts)
  {
    frames.push_back(Parse(text));
    const Json::Value& frame = frames.back();
    const std::string decision = frame["decision"].asString();
    decisions[decision] = decisions.get(decision, 0).asInt() + 1;
    const double count = frame["tested"].asDouble();
    if (count > 0.0)
    {
      tested.push_back(frame["milliseconds"]);
      perProp.push_back(1000.0 * frame["milliseconds"]["test"].asDouble() / count);
    }
  }
  Json::Value result = GetMedian(frames);
  result["decisions"] = decisions;
  if (!tested.empty())
  {
    Json::Value& stages = result["when_tested"];
    stages["frames"] = static_cast<Json::UInt64>(tested.size());
    stages["milliseconds"] = GetMedian(tested);
    stages["test_microseconds_per_prop"] = Round(GetQuantile(perProp, 0.5));
  }
  return result;
}

Json::Value SummarizeQueries(const std::vector<NBufferPeers::QueryStatistics>& all)
{
  std::vector<Json::Value> frames;
  for (const NBufferPeers::QueryStatistics& statistics : all)
  {
    Json::Value frame;
    frame["in_view"] = statistics.InView;
    frame["queries"] = statistics.Queries;
    frame["waits"] = statistics.Waits;
    frame["wait_ms"] = statistics.WaitTime;
    frame["nodes"] = statistics.Nodes;
    frame["visits"] = statistics.Visits;
    frame["drawn"] = statistics.Drawn;
    frame["hidden"] = statistics.Hidden;
    frame["redrawn"] = statistics.Redrawn;
    frames.push_back(frame);
  }
  return GetMedian(frames);
}

Json::Value SummarizeMode(const ModeResult& mode)
{
  Json::Value result = SummarizeTimes(mode);
  result["drawn"] = GetQuantile(std::vector<double>(mode.Drawn.begin(), mode.Drawn.end()), 0.5);
  if (!mode.DifferingBytes.empty())
  {
    Json::Value& frames = result["differing_frames"] = Json::Value(Json::arrayValue);
    long long bytes = 0;
    for (std::size_t frame = 0; frame < mode.DifferingBytes.size(); ++frame)
    {
      bytes += mode.DifferingBytes[frame];
      if (mode.DifferingBytes[frame] > 0)
      {
        frames.append(static_cast<Json::UInt64>(frame));
      }
    }
    result["differing_bytes"] = static_cast<Json::Int64>(bytes);
  }
  if (!mode.Statistics.empty())
  {
    result["backend"] = mode.Backend;
    result["statistics"] = SummarizeStatistics(mode.Statistics);
  }
  if (!mode.Queries.empty())
  {
    result["queries"] = SummarizeQueries(mode.Queries);
  }
  return result;
}

long long Sum(const std::vector<long long>& values)
{
  return std::accumulate(values.begin(), values.end(), 0LL);
}
}

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

long long GetDifferingBytes(const WalkResult& result)
{
  long long bytes = 0;
  for (const auto& [name, mode] : result.Modes)
  {
    bytes += name == "oracle" ? 0 : Sum(mode.DifferingBytes);
  }
  return bytes;
}

Json::Value MakeReport(const WalkResult& result)
{
  Json::Value report;
  report["frames"] = static_cast<Json::UInt64>(result.Frames);
  report["props"] = static_cast<Json::UInt64>(result.Props);
  for (const std::string& name : result.Names)
  {
    report["modes"][name] = SummarizeMode(result.Modes.at(name));
  }
  report["ratios"] = Json::Value(Json::objectValue);
  const char* const pairs[][2] = { { "stock", "nbuffer" }, { "nbuffer", "stock" },
    { "nbuffer", "oracle" }, { "none", "stock" }, { "stock", "oracle" } };
  for (const auto& pair : pairs)
  {
    const auto a = result.Modes.find(pair[0]);
    const auto b = result.Modes.find(pair[1]);
    if (a != result.Modes.end() && b != result.Modes.end())
    {
      report["ratios"][a->first + "/" + b->first] = Round(GetMedianRatio(a->second, b->second));
    }
  }
  if (result.Modes.count("nbuffer") > 0)
  {
    for (const std::string& name : result.Names)
    {
      if (name != "nbuffer" && GetModeKind(name) == "nbuffer")
      {
        report["ratios"][name + "/nbuffer"] =
          Round(GetMedianRatio(result.Modes.at(name), result.Modes.at("nbuffer")));
      }
    }
  }
  report["verified_frames"] = static_cast<Json::UInt64>(result.VerifiedFrames);
  report["differing_bytes"] = static_cast<Json::Int64>(GetDifferingBytes(result));
  return report;
}

void PrintTable(const Json::Value& report, std::ostream& out)
{
  const auto getWidth = [](const std::vector<std::string>& names, std::size_t least)
  {
    for (const std::string& name : names)
    {
      least = std::max(least, name.size() + 1);
    }
    return static_cast<int>(least);
  };
  std::ostringstream text;
  text << std::fixed << std::setprecision(2);
  const int modeWidth = getWidth(report["modes"].getMemberNames(), 10);
  text << std::left << std::setw(modeWidth) << "mode" << std::right << std::setw(10) << "median ms"
       << std::setw(10) << "p10" << std::setw(10) << "p90" << std::setw(10) << "drawn\n";
  for (const std::string& name : report["modes"].getMemberNames())
  {
    const Json::Value& mode = report["modes"][name];
    text << std::left << std::setw(modeWidth) << name << std::right;
    for (const char* value : { "median_ms", "p10_ms", "p90_ms" })
    {
      text << std::setw(10) << mode[value].asDouble();
    }
    text << std::setw(9) << mode["drawn"].asInt64();
    if (mode.isMember("differing_bytes") && name != "none")
    {
      text << "   " << mode["differing_bytes"].asInt64() << " bytes differ";
    }
    text << "\n";
  }
  const int ratioWidth = getWidth(report["ratios"].getMemberNames(), 16);
  for (const std::string& name : report["ratios"].getMemberNames())
  {
    text << std::left << std::setw(ratioWidth) << name << std::right << std::setw(8)
         << report["ratios"][name].asDouble() << "\n";
  }
  out << text.str();
}

void WriteJSON(const Json::Value& value, const std::string& fileName)
{
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
