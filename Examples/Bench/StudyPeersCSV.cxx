// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyPeersCSV.h"

#include "StudyPeers.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
class File
{
public:
  explicit File(const std::string& name)
    : Name(name)
    , Out(name)
  {
  }

  template <typename... Names>
  void Add(const Json::Value& object, Names... names)
  {
    for (const char* name : { names... })
    {
      const Json::Value& value = object.isObject() ? object[name] : Json::Value::nullSingleton();
      this->Cell(value.isObject() ? value["median"] : value);
    }
  }

  void Cell(const Json::Value& value)
  {
    this->Out << (this->IsFirst ? "" : ",");
    this->IsFirst = false;
    if (value.isString())
    {
      this->Out << value.asString();
    }
    else if (value.isNumeric() && std::floor(value.asDouble()) == value.asDouble())
    {
      this->Out << static_cast<long long>(value.asDouble());
    }
    else if (value.isNumeric())
    {
      this->Out << value.asDouble();
    }
  }

  void End()
  {
    this->Out << '\n';
    this->IsFirst = true;
    if (!this->Out.flush())
    {
      throw std::runtime_error("cannot write " + this->Name);
    }
  }

private:
  std::string Name;
  std::ofstream Out;
  bool IsFirst = true;
};
}

void WritePeersCSV(const Json::Value& report, const std::string& folder)
{
  File peers(folder + "/peers.csv");
  for (const char* name : { "scene", "path", "mode", "median_ms", "p10_ms", "p90_ms", "drawn",
         "differing_bytes", "queries", "waits", "wait_ms", "visits", "hidden", "redrawn",
         "fragments", "shown", "wasted", "of_hidden", "again" })
  {
    peers.Cell(name);
  }
  peers.End();
  for (const Json::Value& scene : report["scenes"])
  {
    for (const std::string& name : GetPeerNames())
    {
      const Json::Value& mode = scene["frames_by_mode"]["modes"][name];
      if (mode.isObject())
      {
        peers.Add(scene, "scene", "path");
        peers.Cell(name);
        peers.Add(mode, "median_ms", "p10_ms", "p90_ms", "drawn", "differing_bytes");
        peers.Add(mode["queries"], "queries", "waits", "wait_ms", "visits", "hidden", "redrawn");
        peers.Add(scene["fragments"][name], "passed", "shown", "wasted", "of_hidden", "again");
        peers.End();
      }
    }
  }
  File device(folder + "/device.csv");
  for (const char* name : { "width", "height", "name", "factor", "levels", "texels", "build_ms",
         "device_ms", "read_ms", "skipped" })
  {
    device.Cell(name);
  }
  device.End();
  for (const Json::Value& entry : report["device"])
  {
    Json::Value frame = entry;
    frame["name"] = "drawing and all depth";
    frame["build_ms"] = entry["draw_ms"];
    frame["device_ms"] = entry["draw_device_ms"];
    const auto add = [&](const Json::Value& row)
    {
      device.Add(entry, "width", "height");
      std::string name = row["name"].asString();
      name.erase(std::remove(name.begin(), name.end(), ','), name.end());
      device.Cell(name);
      device.Add(row, "factor", "levels", "texels", "build_ms", "device_ms", "read_ms", "skipped");
      device.End();
    };
    add(frame);
    for (const Json::Value& row : entry["rows"])
    {
      add(row);
    }
  }
}

} // namespace NBufferBench
