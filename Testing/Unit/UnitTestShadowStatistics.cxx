// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The one struct of the shadows' counts: names and JSON.
#include "vtkShadowStatistics.h"

#include "vtk_jsoncpp.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>

namespace
{
Json::Value Parse(const std::string& text)
{
  Json::CharReaderBuilder builder;
  builder["failIfExtra"] = true;
  builder["rejectDupKeys"] = true;
  const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
  Json::Value value;
  std::string errors;
  EXPECT_TRUE(reader->parse(text.data(), text.data() + text.size(), &value, &errors))
    << errors << text;
  return value;
}

/// Every enumerator has a name, and no two the same; the number of them has none.
template <typename Enum>
void ExpectNames(int count)
{
  std::set<std::string> names;
  for (int i = 0; i < count; ++i)
  {
    const std::string name = vtkShadowStatistics::GetName(static_cast<Enum>(i));
    EXPECT_NE(name, "Invalid") << i;
    EXPECT_TRUE(names.insert(name).second) << name << " twice";
  }
  EXPECT_STREQ(vtkShadowStatistics::GetName(static_cast<Enum>(count)), "Invalid");
}
}

TEST(ShadowStatistics, EveryEnumeratorHasItsOwnName)
{
  ExpectNames<vtkShadowVerdict>(vtkShadowStatistics::NumberOfVerdicts);
  ExpectNames<vtkShadowSkip>(NumberOfShadowSkips);
  ExpectNames<vtkShadowDecision>(static_cast<int>(vtkShadowDecision::NumberOfDecisions));
  ExpectNames<vtkShadowStage>(NumberOfShadowStages);
}

// What was not measured must not look like what took no time.
TEST(ShadowStatistics, NothingIsMeasuredAtFirst)
{
  const Json::Value json = Parse(vtkShadowStatistics().GetAsJSON());
  EXPECT_EQ(json["decision"].asString(), "None");
  EXPECT_EQ(json["fragments"].asInt(), -1);
  EXPECT_EQ(json["draws"].asInt(), 0);
  for (const char* stage : { "depth", "draw", "color" })
  {
    EXPECT_EQ(json["device_milliseconds"][stage].asDouble(), -1.0) << stage;
  }
}

// Hazard: a field forgotten, mixed up, or cut to 32 bits in JSON.
TEST(ShadowStatistics, JSONHoldsEveryField)
{
  vtkShadowStatistics statistics;
  statistics.Decision = vtkShadowDecision::Drawn;
  int next = 1;
  for (int* field : { &statistics.Lights, &statistics.Casters, &statistics.Updates,
         &statistics.Silhouettes, &statistics.Draws, &statistics.ZPass, &statistics.Boxes,
         &statistics.StencilClears, &statistics.Slabs, &statistics.Litmaps,
         &statistics.UnclampedLights, &statistics.ReadBacks, &statistics.FailedFrames,
         &statistics.DebugDraws, &statistics.Samples, &statistics.PixelFrames })
  {
    *field = next++;
  }
  for (int& verdict : statistics.Verdicts)
  {
    verdict = next++;
  }
  for (int& skipped : statistics.Skipped)
  {
    skipped = next++;
  }
  statistics.Triangles = 5000000000LL;
  statistics.Receivers = 6000000000LL;
  statistics.Fragments = 7000000000LL;
  statistics.DeviceTimes = { 0.25, 0.5, 0.75 };
  statistics.CasterTime = 1.25;
  statistics.DepthTime = 1.5;
  statistics.ReadTime = 1.75;
  statistics.LitmapTime = 2.25;
  statistics.PlanTime = 2.5;
  statistics.DrawTime = 2.75;

  const Json::Value json = Parse(statistics.GetAsJSON());
  EXPECT_EQ(json["decision"].asString(), "Drawn");
  next = 1;
  for (const char* name : { "lights", "casters", "updates", "silhouettes", "draws", "z_pass",
         "boxes", "stencil_clears", "slabs", "litmaps", "unclamped_lights", "read_backs",
         "failed_frames", "debug_draws", "samples", "pixel_frames" })
  {
    EXPECT_EQ(json[name].asInt(), next++) << name;
  }
  EXPECT_EQ(json["verdicts"].size(), statistics.Verdicts.size());
  for (int i = 0; i < vtkShadowStatistics::NumberOfVerdicts; ++i)
  {
    const char* name = vtkShadowStatistics::GetName(static_cast<vtkShadowVerdict>(i));
    EXPECT_EQ(json["verdicts"][name].asInt(), next++) << name;
  }
  EXPECT_EQ(json["skipped"].size(), statistics.Skipped.size());
  for (int i = 0; i < NumberOfShadowSkips; ++i)
  {
    const char* name = vtkShadowStatistics::GetName(static_cast<vtkShadowSkip>(i));
    EXPECT_EQ(json["skipped"][name].asInt(), next++) << name;
  }
  EXPECT_EQ(json["triangles"].asInt64(), 5000000000LL);
  EXPECT_EQ(json["receivers"].asInt64(), 6000000000LL);
  EXPECT_EQ(json["fragments"].asInt64(), 7000000000LL);
  const Json::Value& device = json["device_milliseconds"];
  EXPECT_EQ(device["depth"].asDouble(), 0.25);
  EXPECT_EQ(device["draw"].asDouble(), 0.5);
  EXPECT_EQ(device["color"].asDouble(), 0.75);
  EXPECT_EQ(statistics.GetDeviceTime(vtkShadowStage::Draw), 0.5);
  double time = 1.25;
  for (const char* name : { "casters", "depth", "read", "litmaps", "plan", "draw" })
  {
    EXPECT_EQ(json["milliseconds"][name].asDouble(), time) << name;
    time += time == 1.75 ? 0.5 : 0.25;
  }
}
