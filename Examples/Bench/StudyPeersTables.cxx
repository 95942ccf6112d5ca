// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyPeersTables.h"

#include "StudyPeers.h"
#include "StudyTable.h"

namespace NBufferBench
{
namespace
{
std::string PrintRange(const Json::Value& times)
{
  return times.isObject() ? Print(times["median"].asDouble()) + " (" +
      Print(times["p10"].asDouble()) + " to " + Print(times["p90"].asDouble()) + ")"
                          : "";
}

std::string PrintMedian(const Json::Value& times)
{
  return times.isObject() ? Print(times["median"].asDouble()) : "";
}

std::string PrintCount(const Json::Value& queries, const char* name)
{
  return queries.isObject() ? Print(queries[name].asDouble()) : "";
}

std::string PrintSize(const Json::Value& entry)
{
  return entry["width"].asString() + " x " + entry["height"].asString();
}

const Json::Value& FindRow(const Json::Value& entry, const std::string& name, int factor)
{
  for (const Json::Value& row : entry["rows"])
  {
    if (row["name"].asString() == name && row["factor"].asInt() == factor)
    {
      return row;
    }
  }
  return Json::Value::nullSingleton();
}

/// Reasons, once each.
std::string ListSkipped(const Json::Value& skipped)
{
  std::string text;
  for (const std::string& mode : skipped.getMemberNames())
  {
    text += "\nSkipped: " + mode + ", " + skipped[mode].asString() + ".\n";
  }
  return text;
}
}

std::string MakePeersTable(const Json::Value& report)
{
  Table table({ "path", "mode", "ms (p10 to p90)", "props drawn", "hidden props kept, %", "queries",
    "waited for", "waiting ms", "drawn again", "wrong bytes" });
  std::string skipped;
  for (const Json::Value& scene : report["scenes"])
  {
    const Json::Value& frames = scene["frames_by_mode"];
    if (!frames["modes"].isMember("queries") && !frames["modes"].isMember("chc"))
    {
      continue; // The table of whole frames has it.
    }
    const double seen = frames["modes"]["oracle"]["drawn"].asDouble();
    const double hidden = frames["modes"]["stock"]["drawn"].asDouble() - seen;
    for (const std::string& name : GetPeerNames())
    {
      const Json::Value& mode = frames["modes"][name];
      if (!mode.isObject())
      {
        continue;
      }
      const Json::Value& queries = mode["queries"];
      table.Add({ GetTitle(scene), name,
        Print(mode["median_ms"].asDouble()) + " (" + Print(mode["p10_ms"].asDouble()) + " to " +
          Print(mode["p90_ms"].asDouble()) + ")",
        Print(mode["drawn"].asDouble()),
        Print(hidden > 0.0 ? 100.0 * (mode["drawn"].asDouble() - seen) / hidden : 0.0),
        PrintCount(queries, "queries"), PrintCount(queries, "waits"),
        PrintCount(queries, "wait_ms"), PrintCount(queries, "redrawn"),
        Print(mode["differing_bytes"].asDouble()) });
    }
    skipped = ListSkipped(frames["skipped"]);
  }
  return table.Get() + skipped;
}

std::string MakeFragmentsTable(const Json::Value& report)
{
  Table table({ "path", "mode", "draws", "fragments", "shown", "wasted", "wasted, % of fragments",
    "by hidden props", "by drawing again" });
  for (const Json::Value& scene : report["scenes"])
  {
    for (const std::string& name : GetPeerNames())
    {
      const Json::Value& entry = scene["fragments"][name];
      if (entry.isObject())
      {
        const double passed = entry["passed"].asDouble();
        table.Add({ GetTitle(scene), name, Print(entry["draws"].asDouble()), Print(passed),
          Print(entry["shown"].asDouble()), Print(entry["wasted"].asDouble()),
          Print(passed > 0.0 ? 100.0 * entry["wasted"].asDouble() / passed : 0.0),
          Print(entry["of_hidden"].asDouble()), Print(entry["again"].asDouble()) });
      }
    }
  }
  return table.Get();
}

std::string MakeDeviceTable(const Json::Value& report)
{
  Table table({ "size", "drawing ms", "reading depth ms", "OpenGL: all levels ms",
    "reading them ms", "all on 1/4 ms", "one 1/4 ms", "reading it ms", "CPU: all levels ms",
    "all on 1/4 ms", "one 1/4 ms" });
  for (const Json::Value& entry : report["device"])
  {
    const Json::Value& all = FindRow(entry, "module, all levels", 1);
    const Json::Value& one = FindRow(entry, "module, one level", 4);
    table.Add({ PrintSize(entry), PrintRange(entry["draw_ms"]), PrintMedian(entry["read_ms"]),
      PrintRange(all["build_ms"]), PrintMedian(all["read_ms"]),
      PrintRange(FindRow(entry, "module, all levels", 4)["build_ms"]), PrintRange(one["build_ms"]),
      PrintMedian(one["read_ms"]), PrintMedian(FindRow(entry, "CPU, all levels", 1)["build_ms"]),
      PrintMedian(FindRow(entry, "CPU, all levels", 4)["build_ms"]),
      PrintMedian(FindRow(entry, "CPU, one level", 4)["build_ms"]) });
  }
  return table.Get();
}

std::string MakeSingleTable(const Json::Value& report)
{
  Table table({ "size", "1/N", "one pass ms", "device ms", "passes of 2 x 2 ms", "device ms",
    "compute ms", "device ms", "reading it ms", "CPU ms" });
  std::string skipped;
  for (const Json::Value& entry : report["device"])
  {
    for (int factor : { 4, 8, 16 })
    {
      Cells cells = { PrintSize(entry), "1/" + std::to_string(factor) };
      for (const char* name : { "pass", "passes", "compute" })
      {
        const Json::Value& row = FindRow(entry, name, factor);
        cells.push_back(PrintRange(row["build_ms"]));
        cells.push_back(PrintMedian(row["device_ms"]));
        if (row.isMember("skipped"))
        {
          skipped = std::string("\nSkipped: ") + name + ", " + row["skipped"].asString() + ".\n";
        }
      }
      cells.push_back(PrintMedian(FindRow(entry, "pass", factor)["read_ms"]));
      cells.push_back(PrintMedian(FindRow(entry, "CPU, one level", factor)["build_ms"]));
      table.Add(cells);
    }
  }
  return table.Get() + skipped;
}

} // namespace NBufferBench
