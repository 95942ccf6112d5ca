// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyFiles.h"

#include "Images.h"
#include "Report.h"
#include "StudyChart.h"
#include "StudyDocument.h"
#include "StudyReport.h"
#include "StudySettingsTables.h"
#include "StudyShadows.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
std::string ReadFile(const std::string& name)
{
  std::ifstream file(name);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file)
  {
    throw std::runtime_error("cannot read " + name);
  }
  return text.str();
}
}

void WriteDocuments(const StudyOptions& options, const Json::Value& report)
{
  for (const char* document : { "accuracy.md", "accuracy-scenes.md", "accuracy-settings.md" })
  {
    const std::string name =
      NBufferExamples::FindData(options.View.Program, document + std::string(".in"));
    if (name.empty())
    {
      continue;
    }
    const std::string fileName = options.Folder + "/" + document;
    std::ofstream file(fileName);
    file << FillDocument(ReadFile(name), report, options.Links);
    if (!file.flush())
    {
      throw std::runtime_error("cannot write " + fileName);
    }
  }
}

void WriteSceneChart(const Json::Value& scene, const std::string& folder)
{
  WriteParetoChart(scene,
    scene["scene"].asString() + ", " + scene["path"].asString() + ", " + scene["size"].asString(),
    folder + "/" + scene["chart"].asString());
}

void RewriteStudy(const StudyOptions& options, const std::vector<std::string>& fileNames)
{
  MakeFolder(options.Folder);
  Json::Value report = Parse(ReadFile(fileNames.front()));
  for (const std::string& name : fileNames)
  {
    const Json::Value other = Parse(ReadFile(name));
    if (other.isMember("shadows"))
    {
      report["shadows"] = other["shadows"];
    }
    // A study of a part has nothing of the others; what is no list describes the run.
    for (const std::string& part : other["settings"].getMemberNames())
    {
      const Json::Value& value = other["settings"][part];
      if (value.isArray() || !report["settings"].isMember(part))
      {
        report["settings"][part] = value;
      }
    }
  }
  ChooseWindowSystem(options.View.Window.Window);
  for (const Json::Value& scene : report["scenes"])
  {
    WriteSceneChart(scene, options.Folder);
  }
  for (const Json::Value& scene : report["shadows"])
  {
    WriteShadowCharts(scene, options.Folder);
  }
  WriteSettingsCharts(report["settings"], options.Folder);
  WriteDocuments(options, report);
}

} // namespace NBufferBench
