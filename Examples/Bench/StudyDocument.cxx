// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyDocument.h"

#include "StudyPeersTables.h"
#include "StudySettingsTables.h"
#include "StudyTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace NBufferBench
{
namespace
{
/// The entry of a list whose title is this one; null if there is none.
const Json::Value& Find(const Json::Value& list, const std::string& path)
{
  for (const Json::Value& entry : list)
  {
    if (GetTitle(entry) == path)
    {
      return entry;
    }
  }
  return Json::Value::nullSingleton();
}

std::vector<Json::Value> Sort(
  const Json::Value& points, const std::function<double(const Json::Value&)>& key)
{
  std::vector<Json::Value> sorted(points.begin(), points.end());
  std::stable_sort(sorted.begin(), sorted.end(),
    [&key](const Json::Value& a, const Json::Value& b) { return key(a) < key(b); });
  return sorted;
}

double GetTotal(const Json::Value& point)
{
  return point["total_ms"]["median"].asDouble();
}

const Cells PointHead = { "", "structure", "hidden props kept, %", "covered too much, %",
  "build ms", "query ms", "both: p10 to p90", "lookups", "MB", "loss ms" };

Cells MakePointRow(const std::string& number, const Json::Value& point)
{
  return { number, point["name"].asString() + (point["is_default"].asBool() ? " (default)" : ""),
    Print(point["false_visible_percent"].asDouble()),
    PrintShare(point["over_covered_percent"].asDouble()),
    Print(point["build_ms"]["median"].asDouble()), Print(point["query_ms"]["median"].asDouble()),
    Print(point["total_ms"]["p10"].asDouble()) + " to " +
      Print(point["total_ms"]["p90"].asDouble()),
    Print(point["lookups"].asDouble()), Print(1e-6 * point["bytes"].asDouble()),
    Print(point["loss_ms"].asDouble()) };
}

std::string MakeMachine(const Json::Value& report)
{
  std::ostringstream text;
  text << report["renderer"].asString() << ", VTK " << report["vtk"].asString() << ", "
       << report["size"].asString() << ", " << report["effort"].asString() << " run, "
       << report["seconds"].asInt() << " s.\n";
  return text.str();
}

const char* const NotMeasured =
  "Not measured in this run: left out of quick runs, or the scene was not there.\n";

std::string MakePareto(const Json::Value& report, const std::string& path)
{
  const Json::Value& scene = Find(report["scenes"], path);
  if (scene.isNull())
  {
    return NotMeasured;
  }
  Table table(PointHead);
  int number = 0;
  for (const Json::Value& point : Sort(scene["points"], GetTotal))
  {
    if (point["pareto"].asBool())
    {
      table.Add(MakePointRow(std::to_string(++number), point));
    }
    else if (point["is_default"].asBool())
    {
      table.Add(MakePointRow("", point));
    }
  }
  return Print(scene["in_view"].asDouble()) + " props in view, " +
    Print(scene["hidden"].asDouble()) + " of them hidden (means over " +
    scene["frames"].asString() + " frames); " + std::to_string(scene["points"].size()) +
    " structures.\n\n" + table.Get();
}

std::string MakeBest(const Json::Value& report, const std::string& path)
{
  if (Find(report["scenes"], path).isNull())
  {
    return std::string();
  }
  Table table(PointHead);
  int number = 0;
  for (const Json::Value& point : Sort(Find(report["scenes"], path)["points"],
         [](const Json::Value& p) { return p["loss_ms"].asDouble(); }))
  {
    ++number;
    if (number <= 6 || point["is_default"].asBool())
    {
      table.Add(MakePointRow(std::to_string(number) + ".", point));
    }
  }
  return table.Get();
}

/// Nothing for charts of scenes that were not measured.
std::string MakeImage(
  const Json::Value& report, const std::string& links, const std::string& argument)
{
  const std::size_t end = argument.find(' ');
  const std::string name = argument.substr(0, end);
  const auto isOf = [&name](
                      const Json::Value& list, const std::function<bool(const Json::Value&)>& is)
  { return std::any_of(list.begin(), list.end(), is); };
  const bool isPareto = name.rfind("pareto-", 0) == 0;
  const bool isShadow = name.rfind("shadow", 0) == 0;
  const bool isSetting = name.rfind("settings-", 0) == 0;
  if ((isSetting && !HasSettingsChart(report["settings"], name)) ||
    (isPareto &&
      !isOf(report["scenes"], [&name](const Json::Value& s) { return s["chart"] == name; })) ||
    (isShadow &&
      !isOf(report["shadows"],
        [&name](const Json::Value& s)
        {
          const std::string scene = s["scene"].asString();
          return name == "shadows-" + scene || name == "shadow-errors-" + scene;
        })))
  {
    return std::string();
  }
  return "![" + argument.substr(std::min(end, argument.size() - 1) + 1) + "](" + links + "/" +
    name + ".png)\n";
}

std::string MakeLeftOut(const Json::Value& report)
{
  if (report["left_out"].empty())
  {
    return std::string();
  }
  std::string names;
  for (const Json::Value& name : report["left_out"])
  {
    names += (names.empty() ? "`" : ", `") + name.asString() + "`";
  }
  return "Not there in this run and left out: " + names + ".\n";
}

std::string MakeKnown(const Json::Value& report)
{
  Table table({ "scene", "props in view", "left in by the table", "kept by the culler",
    "own a pixel", "pixels checked", "outside the table", "of these through undrawn walls" });
  for (const Json::Value& scene : report["scenes"])
  {
    const Json::Value& known = scene["table"];
    if (known.isNull())
    {
      continue;
    }
    double kept = 0.0;
    for (const Json::Value& point : scene["points"])
    {
      if (point["is_default"].asBool())
      {
        kept = known["visible"].asDouble() +
          0.01 * point["false_visible_percent"].asDouble() * scene["hidden"].asDouble();
      }
    }
    table.Add(
      { GetTitle(scene), Print(known["in_view"].asDouble()), Print(known["table"].asDouble()),
        Print(kept), Print(known["visible"].asDouble()), Print(known["pixels"].asDouble()),
        Print(known["undrawn_pixels"].asDouble() + known["contradictions"].asDouble()),
        Print(known["undrawn_pixels"].asDouble()) });
  }
  return table.Get();
}

std::string MakeShadows(const Json::Value& report, const std::string& name)
{
  Table table({ "", "mode@litmap", "ms (p10 to p90)", "fragments, %", "wrong samples",
    "differ and are ambiguous" });
  for (const Json::Value& scene : report["shadows"])
  {
    if (scene["scene"].asString() != name)
    {
      continue;
    }
    int number = 0;
    for (const Json::Value& point :
      Sort(scene["points"], [](const Json::Value& p) { return p["ms"]["median"].asDouble(); }))
    {
      const std::string mode = point["name"].asString();
      const bool isPareto = point["pareto"].asBool();
      if (isPareto || point["is_default"].asBool() || point["wrong"].asInt64() > 0 ||
        mode == "unclamped")
      {
        table.Add({ isPareto ? std::to_string(++number) : "",
          mode + (point["is_default"].asBool() ? " (default)" : ""),
          Print(point["ms"]["median"].asDouble()) + " (" + Print(point["ms"]["p10"].asDouble()) +
            " to " + Print(point["ms"]["p90"].asDouble()) + ")",
          PrintShare(point["fragments_percent"].asDouble()),
          Print(point["wrong"].asDouble()) + " of " + Print(point["samples"].asDouble()),
          Print(point["ambiguous"].asDouble()) });
      }
    }
    return "Without shadows " + Print(scene["none_ms"]["median"].asDouble()) +
      " ms; pixels that shadows "
      "change: " +
      Print(scene["shadowed_percent"].asDouble()) + " % of the fragments of whole volumes; " +
      std::to_string(scene["points"].size()) + " modes.\n\n" + table.Get();
  }
  return NotMeasured;
}

/// Section 4.4 of the paper.
std::string MakeFill(const Json::Value& report)
{
  Table table({ "scene", "fragments of whole volumes, a frame", "litmap 256: exact, %",
    "clamped to one slab, %", "to several, %", "the paper's litmap, %" });
  table.Add({ "the paper, city", "", "", "2.5", "", "" });
  table.Add({ "the paper, simple scenes", "", "", "20", "", "" });
  for (const Json::Value& scene : report["shadows"])
  {
    std::map<std::string, const Json::Value*> points;
    for (const Json::Value& point : scene["points"])
    {
      points[point["name"].asString()] = &point;
    }
    const auto print = [&points](const char* name)
    {
      const auto point = points.find(name);
      return point == points.end() ? std::string()
                                   : Print((*point->second)["fragments_percent"].asDouble());
    };
    table.Add({ scene["scene"].asString(), Print((*points.at("unclamped"))["fragments"].asDouble()),
      print("exact@256"), print("clamp@256"), print("slabs@256"), print("paper@256") });
  }
  return table.Get();
}

std::string MakeChain(const Json::Value& report, const std::string& path)
{
  Table table(PointHead);
  for (const char* name : { "one level 1/4", "one level 1/8", "one level 1/16", "mips 2x2 1/4",
         "fat mips 2x2 1/4", "mips 4x4 1/4", "fat mips 4x4 1/4", "squares x1 1/4",
         "squares s=2 x4 1/4", "squares x4 1/4", "squares x4 1/8", "squares x4 1/16" })
  {
    for (const Json::Value& point : Find(report["scenes"], path)["points"])
    {
      if (point["name"].asString() == name)
      {
        table.Add(MakePointRow("", point));
      }
    }
  }
  return table.Get();
}

std::string MakeFrames(const Json::Value& report)
{
  Table table({ "path", "stock ms", "nbuffer ms", "oracle ms", "drawn: stock / nbuffer / oracle",
    "stock / nbuffer", "nbuffer / oracle", "a prop more, µs" });
  for (const Json::Value& scene : report["scenes"])
  {
    const Json::Value& frames = scene["frames_by_mode"];
    const Json::Value& modes = frames["modes"];
    table.Add({ GetTitle(scene), Print(modes["stock"]["median_ms"].asDouble()),
      Print(modes["nbuffer"]["median_ms"].asDouble()),
      Print(modes["oracle"]["median_ms"].asDouble()),
      Print(modes["stock"]["drawn"].asDouble()) + " / " +
        Print(modes["nbuffer"]["drawn"].asDouble()) + " / " +
        Print(modes["oracle"]["drawn"].asDouble()),
      Print(frames["ratios"]["stock/nbuffer"].asDouble()),
      Print(frames["ratios"]["nbuffer/oracle"].asDouble()), Print(frames["draw_us"].asDouble()) });
  }
  return table.Get();
}

std::string MakeLatent(const Json::Value& report)
{
  Table table({ "path", "poses ago", "frames", "frames with wrong pixels", "visible props missing",
    "wrong pixels", "most in a frame", "hidden props left out, %" });
  for (const Json::Value& scene : report["scenes"])
  {
    for (const Json::Value& entry : scene["latent"])
    {
      table.Add({ GetTitle(scene), entry["step"].asString(), entry["frames"].asString(),
        entry["popping_frames"].asString(), entry["missing_props"].asString(),
        entry["wrong_pixels"].asString(), entry["most_wrong_pixels"].asString(),
        Print(entry["hidden_share_percent"].asDouble()) });
    }
  }
  return table.Get();
}

std::string MakeHierarchy(const Json::Value& report, const std::string& path)
{
  Table table({ "props", "kept", "boxes tested: flat", "tree", "nodes looked at", "flat ms",
    "tree ms", "flat / tree", "refit ms", "build ms" });
  for (const Json::Value& entry : Find(report["hierarchy"], path)["entries"])
  {
    const double flat = entry["flat"]["ms"]["median"].asDouble();
    const double tree = entry["tree"]["ms"]["median"].asDouble();
    table.Add({ Print(entry["props"].asDouble()), Print(entry["flat"]["kept"].asDouble()),
      Print(entry["flat"]["tests"].asDouble()), Print(entry["tree"]["tests"].asDouble()),
      Print(entry["tree"]["nodes"].asDouble()), Print(flat), Print(tree),
      Print(tree > 0.0 ? flat / tree : 0.0), Print(entry["refit_ms"]["median"].asDouble()),
      Print(entry["build_ms"]["median"].asDouble()) });
  }
  return table.Get();
}

std::string MakeFormats(const Json::Value& report)
{
  const Json::Value& entries = report["formats"]["entries"];
  Cells head = { "far / near" };
  std::map<double, Cells> rows;
  for (const Json::Value& entry : entries)
  {
    const std::string format = entry["format"].asString();
    if (std::find(head.begin(), head.end(), format) == head.end())
    {
      head.push_back(format);
    }
    char text[64];
    std::snprintf(text, sizeof(text), "%.3g m, %.1f %%", entry["slack"]["median"].asDouble(),
      entry["false_visible_percent"].asDouble());
    rows[entry["ratio"].asDouble()].push_back(text);
  }
  Table table(head);
  for (const auto& [ratio, cells] : rows)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.0e", ratio);
    Cells row = { text };
    row.insert(row.end(), cells.begin(), cells.end());
    table.Add(row);
  }
  return table.Get();
}

std::string MakeTable1(const Json::Value& report)
{
  Table table({ "size", "levels", "the paper's: levels", "the paper's ms", "CPU ms",
    "OpenGL ms (p10 to p90)" });
  for (const Json::Value& row : report["table1"])
  {
    table.Add({ row["width"].asString() + " x " + row["height"].asString(),
      row["levels"].asString(), row["paper_levels"].asString(), Print(row["paper_ms"].asDouble()),
      Print(row["cpu_ms"]["median"].asDouble()),
      Print(row["opengl_ms"]["median"].asDouble()) + " (" +
        Print(row["opengl_ms"]["p10"].asDouble()) + " to " +
        Print(row["opengl_ms"]["p90"].asDouble()) + ")" });
  }
  return table.Get();
}

std::string MakeTable2(const Json::Value& report)
{
  Table table({ "depth tests of a frame", "queries over a hierarchy", "queries",
    "N-buffer over a hierarchy", "N-buffer" });
  const Json::Value& all = report["table2"];
  for (const char* source : { "paper", "tests" })
  {
    const Json::Value& row = all[source];
    table.Add({ source == std::string("paper") ? "the paper" : "here",
      Print(row["oq_hierarchy"].asDouble()), Print(row["oq"].asDouble()),
      Print(row["nb_hierarchy"].asDouble()), Print(row["nb"].asDouble()) });
  }
  return Print(all["boxes"].asDouble()) + " boxes in view, " + Print(all["visible"].asDouble()) +
    " visible.\n\n" + table.Get();
}

std::string MakeFigure4(const Json::Value& report)
{
  Table table(
    { "", "all pixels too many / all asked for, %", "mean over sizes, %", "median, %", "most, %" });
  for (const Json::Value& entry : report["figure4"])
  {
    table.Add({ entry["caption"].asString(), Print(entry["area_percent"].asDouble()),
      Print(entry["mean_percent"].asDouble()), Print(entry["median_percent"].asDouble()),
      Print(entry["most_percent"].asDouble()) });
  }
  return table.Get();
}

/// What a field, a line between two @, stands for.
std::string Fill(const std::string& words, const Json::Value& report, const std::string& links)
{
  const std::size_t space = words.find(' ');
  const std::string name = words.substr(0, space);
  const std::string argument = space == std::string::npos ? "" : words.substr(space + 1);
  using Maker = std::function<std::string()>;
  const std::map<std::string, Maker> makers = {
    { "machine", [&]() { return MakeMachine(report); } },
    { "settings_machine", [&]() { return MakeMachine(report["settings"]); } },
    { "frames", [&]() { return MakeFrames(report); } },
    { "peers", [&]() { return MakePeersTable(report); } },
    { "fragments", [&]() { return MakeFragmentsTable(report); } },
    { "device", [&]() { return MakeDeviceTable(report); } },
    { "single", [&]() { return MakeSingleTable(report); } },
    { "latent", [&]() { return MakeLatent(report); } },
    { "pareto", [&]() { return MakePareto(report, argument); } },
    { "best", [&]() { return MakeBest(report, argument); } },
    { "chain", [&]() { return MakeChain(report, argument); } },
    { "hierarchy", [&]() { return MakeHierarchy(report, argument); } },
    { "formats", [&]() { return MakeFormats(report); } },
    { "table1", [&]() { return MakeTable1(report); } },
    { "table2", [&]() { return MakeTable2(report); } },
    { "figure4", [&]() { return MakeFigure4(report); } },
    { "left_out", [&]() { return MakeLeftOut(report); } },
    { "known", [&]() { return MakeKnown(report); } },
    { "shadows", [&]() { return MakeShadows(report, argument); } },
    { "fill", [&]() { return MakeFill(report); } },
    { "setting", [&]() { return MakeSettingTable(report["settings"], argument); } },
    { "few", [&]() { return MakeFewTable(report["settings"]); } },
    { "image", [&]() { return MakeImage(report, links, argument); } },
  };
  const auto maker = makers.find(name);
  if (maker == makers.end())
  {
    throw std::runtime_error("the document has an unknown field @" + words + "@");
  }
  return maker->second();
}
}

std::string FillDocument(
  const std::string& text, const Json::Value& report, const std::string& links)
{
  std::istringstream lines(text);
  std::ostringstream document;
  for (std::string line; std::getline(lines, line);)
  {
    const bool isField = line.size() > 2 && line.front() == '@' && line.back() == '@';
    document << (isField ? Fill(line.substr(1, line.size() - 2), report, links) : line + "\n");
  }
  return document.str();
}

} // namespace NBufferBench
