// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudySettingsTables.h"

#include "StudyChart.h"
#include "StudyTable.h"

#include "vtkPlotPoints.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <vector>

namespace NBufferBench
{
namespace
{
struct Look
{
  const char* Label; ///< The setting, of shadows with the mode.
  unsigned char Color[3];
  int Marker;
};
// Okabe and Ito.
constexpr Look Looks[] = { { "RoundSize", { 230, 159, 0 }, vtkPlotPoints::SQUARE },
  { "MaximumNumberOfRounds", { 0, 114, 178 }, vtkPlotPoints::SQUARE },
  { "BaseFactor", { 0, 158, 115 }, vtkPlotPoints::DIAMOND },
  { "MaximumNumberOfPieces", { 204, 121, 167 }, vtkPlotPoints::CIRCLE },
  { "TestPixels", { 0, 0, 0 }, vtkPlotPoints::CROSS },
  { "BackOff", { 213, 94, 0 }, vtkPlotPoints::PLUS },
  { "TakeOverFrustumCulling", { 86, 180, 233 }, vtkPlotPoints::PLUS },
  { "auto, BoxCost", { 0, 158, 115 }, vtkPlotPoints::DIAMOND },
  { "exact, BoxCost", { 0, 114, 178 }, vtkPlotPoints::SQUARE },
  { "slabs, BoxCost", { 204, 121, 167 }, vtkPlotPoints::DIAMOND },
  { "slabslit, BoxCost", { 213, 94, 0 }, vtkPlotPoints::CROSS },
  { "slabs, SlabGap", { 230, 159, 0 }, vtkPlotPoints::CIRCLE } };

std::string PrintRange(const Json::Value& times)
{
  return Print(times["median"].asDouble()) + " (" + Print(times["p10"].asDouble()) + " to " +
    Print(times["p90"].asDouble()) + ")";
}

bool IsShadow(const Json::Value& point)
{
  return point.isMember("fragments_percent");
}

double GetTime(const Json::Value& point)
{
  return point["ms"]["median"].asDouble();
}

double GetError(const Json::Value& point)
{
  return point[IsShadow(point) ? "fragments_percent" : "kept_percent"].asDouble();
}

/// Whether its setting is that of the mode that users get without asking.
bool IsOfUsualMode(const Json::Value& point)
{
  const std::string kind = point["kind"].asString();
  return kind == "nbuffer" || kind == "auto";
}

std::string GetLabel(const Json::Value& point)
{
  const std::string setting = point["setting"].asString();
  return IsShadow(point) ? point["kind"].asString() + ", " + setting : setting;
}

std::string GetChartName(const std::string& part, const Json::Value& scene)
{
  std::string name = scene["scene"].asString();
  name = name.substr(0, name.find(' ')); // Without what is said of it.
  return "settings-" + name + (part == "shadows" ? "" : "-" + scene["path"].asString());
}

void ForEachScene(const Json::Value& settings,
  const std::function<void(const std::string&, const Json::Value&)>& function)
{
  for (const char* part : { "culler", "still", "shadows" })
  {
    for (const Json::Value& scene : settings[part])
    {
      function(part, scene);
    }
  }
}
}

std::string MakeSettingTable(const Json::Value& settings, const std::string& setting)
{
  // Rows by title, cells by value.
  struct Row
  {
    std::string Title;
    std::map<int, std::string> Cells;
    std::string Default;
    std::string Again;
  };
  std::vector<Row> rows;
  std::map<int, bool> values; // Whether it is the default.
  bool ofShadows = false;
  ForEachScene(settings,
    [&](const std::string& part, const Json::Value& scene)
    {
      for (const Json::Value& point : scene["points"])
      {
        if (point["setting"].asString() != setting)
        {
          continue;
        }
        ofShadows = part == "shadows";
        const std::string title =
          ofShadows ? scene["scene"].asString() + ", " + point["kind"].asString() : GetTitle(scene);
        if (rows.empty() || rows.back().Title != title)
        {
          rows.push_back({ title, {}, "", "" });
          rows.back().Again = IsOfUsualMode(point) ? Print(scene["again_ratio"].asDouble()) : "";
        }
        const int value = point["value"].asInt();
        const bool isDefault = point["is_default"].asBool();
        values[value] = isDefault;
        rows.back().Cells[value] = (isDefault ? "1" : Print(point["ratio"].asDouble())) +
          (part == "still" ? "" : "; " + PrintShare(GetError(point)) + " %");
        if (isDefault)
        {
          rows.back().Default = PrintRange(point["ms"]);
        }
      }
    });
  if (rows.empty())
  {
    return "Not measured in this run.\n";
  }
  Cells head = { ofShadows ? "scene, mode" : "path", "default: ms (p10 to p90)", "default again" };
  for (const auto& [value, isDefault] : values)
  {
    head.push_back(std::to_string(value) + (isDefault ? " (default)" : ""));
  }
  Table table(head);
  for (const Row& row : rows)
  {
    Cells cells = { row.Title, row.Default, row.Again };
    for (const auto& [value, isDefault] : values)
    {
      const auto cell = row.Cells.find(value);
      cells.push_back(cell == row.Cells.end() ? "" : cell->second);
    }
    table.Add(cells);
  }
  return table.Get();
}

std::string MakeFewTable(const Json::Value& settings)
{
  Table table({ "path", "props in view", "drawn by the culler", "stock ms (p10 to p90)",
    "default / stock", "from 1 on / stock", "from 1 on, never backing off / stock" });
  for (const Json::Value& scene : settings["few"])
  {
    for (const Json::Value& entry : scene["entries"])
    {
      Cells cells = { GetTitle(scene), Print(entry["props"].asDouble()),
        Print(entry["drawn"].asDouble()), PrintRange(entry["stock_ms"]) };
      for (const Json::Value& point : entry["points"])
      {
        cells.push_back(Print(point["ratio"].asDouble()));
      }
      table.Add(cells);
    }
  }
  return table.Get();
}

void WriteSettingsCharts(const Json::Value& settings, const std::string& folder)
{
  ForEachScene(settings,
    [&folder](const std::string& part, const Json::Value& scene)
    {
      if (part == "still")
      {
        return;
      }
      const bool ofShadows = part == "shadows";
      ErrorChart chart;
      chart.Bottom = "milliseconds of a frame";
      chart.Left = ofShadows ? "fragments of volumes, % of whole ones" : "hidden props drawn, %";
      chart.Bound = ofShadows ? "pixels that shadows change" : "oracle: 0 %";
      chart.Least = ofShadows ? scene["shadowed_percent"].asDouble() : 0.0;
      for (const Look& look : Looks)
      {
        chart.Groups.push_back(
          { look.Label, { look.Color[0], look.Color[1], look.Color[2] }, look.Marker, {} });
        for (const Json::Value& point : scene["points"])
        {
          if (GetLabel(point) == look.Label)
          {
            chart.Groups.back().Points.emplace_back(GetTime(point), GetError(point));
          }
        }
      }
      for (const Json::Value& point : scene["points"])
      {
        if (point["is_default"].asBool() && IsOfUsualMode(point))
        {
          chart.Default = { { GetTime(point), GetError(point) } };
        }
      }
      WriteErrorChart(chart,
        scene["scene"].asString() + ", " + scene["path"].asString() +
          (ofShadows ? ", shadows" : "") + ", one setting varied at a time",
        folder + "/" + GetChartName(part, scene));
    });
}

bool HasSettingsChart(const Json::Value& settings, const std::string& name)
{
  bool found = false;
  ForEachScene(settings, [&](const std::string& part, const Json::Value& scene)
    { found = found || (part != "still" && GetChartName(part, scene) == name); });
  return found;
}

void WriteSettingsCSV(const Json::Value& settings, const std::string& fileName)
{
  std::ofstream file(fileName);
  file << "part,scene,path,props,mode,setting,value,default,ms,ms_p10,ms_p90,ratio,rounds,drawn,"
          "kept_percent,fragments_percent\n";
  const auto write = [&file](const std::string& part, const Json::Value& scene,
                       const std::string& props, const Json::Value& point)
  {
    file << part << ',' << scene["scene"].asString() << ',' << scene["path"].asString() << ','
         << props << ',' << point["mode"].asString() << ',' << point["setting"].asString() << ','
         << point["value"].asString() << ',' << point["is_default"].asBool() << ','
         << GetTime(point) << ',' << point["ms"]["p10"].asDouble() << ','
         << point["ms"]["p90"].asDouble() << ',' << point["ratio"].asDouble();
    for (const char* name : { "rounds", "drawn", "kept_percent", "fragments_percent" })
    {
      file << ',' << point[name].asString();
    }
    file << '\n';
  };
  ForEachScene(settings,
    [&](const std::string& part, const Json::Value& scene)
    {
      for (const Json::Value& point : scene["points"])
      {
        write(part, scene, "", point);
      }
    });
  for (const Json::Value& scene : settings["few"])
  {
    for (const Json::Value& entry : scene["entries"])
    {
      for (const Json::Value& point : entry["points"])
      {
        write("few", scene, entry["props"].asString(), point);
      }
    }
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

} // namespace NBufferBench
