// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The one struct of counts: names, sums and JSON.
#include "vtkNBufferStatistics.h"

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

/// A value of its own in every field, so that two fields mixed up show.
vtkNBufferStatistics Fill()
{
  vtkNBufferStatistics statistics;
  statistics.Decision = vtkNBufferDecision::Culled;
  for (int i = 0; i < vtkNBufferStatistics::NumberOfVerdicts; ++i)
  {
    statistics.Verdicts[i] = 100 + i;
    statistics.Props += 100 + i;
  }
  statistics.Candidates = 1;
  statistics.Tested = 2;
  statistics.PassedCoarseTest = 13;
  statistics.HeldBack = 3;
  statistics.Redrawn = 4;
  statistics.Refreshed = 5;
  statistics.Rounds = 6;
  for (int i = 0; i <= vtkNBufferStatistics::MaximumNumberOfRounds; ++i)
  {
    statistics.DrawnInRound[i] = 10 + i;
  }
  statistics.Levels = 7;
  statistics.Texels = 8000000000LL;
  statistics.Queries = 9000000000LL;
  statistics.Lookups = 10000000000LL;
  statistics.ReadBacks = 11;
  statistics.BytesRead = 12000000000LL;
  statistics.FailedFrames = 14;
  statistics.Slivers = 18;
  statistics.Nodes = 15000000000LL;
  statistics.Refits = 16;
  statistics.Builds = 17;
  statistics.CullTime = 0.125;
  statistics.RefreshTime = 0.25;
  statistics.FrustumTime = 0.375;
  statistics.ReadTime = 0.5;
  statistics.BuildTime = 0.625;
  statistics.TestTime = 0.75;
  statistics.PixelTestTime = 1.25;
  statistics.SliverTestTime = 1.375;
  statistics.DrawTime = 0.875;
  statistics.DeviceBuildTime = 1.125;
  return statistics;
}
}

// Hazard: a new enumerator without a name, or two with the same, makes JSON and overlays lie.
TEST(NBufferStatistics, EveryVerdictAndDecisionHasItsOwnName)
{
  std::set<std::string> names;
  for (int i = 0; i < vtkNBufferStatistics::NumberOfVerdicts; ++i)
  {
    const std::string name = vtkNBufferStatistics::GetName(static_cast<vtkNBufferVerdict>(i));
    EXPECT_NE(name, "Invalid") << i;
    EXPECT_TRUE(names.insert(name).second) << name << " twice";
  }
  names.clear();
  for (int i = 0; i < static_cast<int>(vtkNBufferDecision::NumberOfDecisions); ++i)
  {
    const std::string name = vtkNBufferStatistics::GetName(static_cast<vtkNBufferDecision>(i));
    EXPECT_NE(name, "Invalid") << i;
    EXPECT_TRUE(names.insert(name).second) << name << " twice";
  }
  EXPECT_STREQ(vtkNBufferStatistics::GetName(vtkNBufferVerdict::NumberOfVerdicts), "Invalid");
  EXPECT_STREQ(vtkNBufferStatistics::GetName(vtkNBufferDecision::NumberOfDecisions), "Invalid");
  EXPECT_STREQ(vtkNBufferStatistics::GetName(static_cast<vtkNBufferVerdict>(-1)), "Invalid");
}

// Hazard: a frame that nothing is known of must not look like a frame that culled.
TEST(NBufferStatistics, StartsAtZero)
{
  const vtkNBufferStatistics statistics;
  EXPECT_EQ(statistics.Decision, vtkNBufferDecision::None);
  const Json::Value json = Parse(statistics.GetAsJSON());
  for (const std::string& name : json.getMemberNames())
  {
    if (json[name].isNumeric())
    {
      EXPECT_EQ(json[name].asDouble(), 0.0) << name;
    }
  }
}

// Hazard: drawn + hidden + outside must be all props, in every frame.
TEST(NBufferStatistics, DrawnHiddenAndOutsideAreAllProps)
{
  const vtkNBufferStatistics statistics = Fill();
  EXPECT_EQ(statistics.GetCount(vtkNBufferVerdict::Outside), 101);
  EXPECT_EQ(statistics.GetCount(vtkNBufferVerdict::Hidden), 102);
  EXPECT_EQ(statistics.GetNumberOfPropsNotDrawn(), 203);
  EXPECT_EQ(
    statistics.GetNumberOfPropsDrawn() + statistics.GetNumberOfPropsNotDrawn(), statistics.Props);
}

// Hazard: a field forgotten, mixed up, or cut to 32 bits in JSON.
TEST(NBufferStatistics, JSONHoldsEveryField)
{
  const vtkNBufferStatistics statistics = Fill();
  const Json::Value json = Parse(statistics.GetAsJSON());
  EXPECT_EQ(json["decision"].asString(), "Culled");
  EXPECT_EQ(json["props"].asInt(), statistics.Props);
  EXPECT_EQ(json["drawn"].asInt(), statistics.GetNumberOfPropsDrawn());
  EXPECT_EQ(json["candidates"].asInt(), 1);
  EXPECT_EQ(json["tested"].asInt(), 2);
  EXPECT_EQ(json["passed_coarse_test"].asInt(), 13);
  EXPECT_EQ(json["held_back"].asInt(), 3);
  EXPECT_EQ(json["redrawn"].asInt(), 4);
  EXPECT_EQ(json["refreshed"].asInt(), 5);
  EXPECT_EQ(json["rounds"].asInt(), 6);
  EXPECT_EQ(json["levels"].asInt(), 7);
  EXPECT_EQ(json["texels"].asInt64(), 8000000000LL);
  EXPECT_EQ(json["queries"].asInt64(), 9000000000LL);
  EXPECT_EQ(json["lookups"].asInt64(), 10000000000LL);
  EXPECT_EQ(json["read_backs"].asInt(), 11);
  EXPECT_EQ(json["bytes_read"].asInt64(), 12000000000LL);
  EXPECT_EQ(json["failed_frames"].asInt(), 14);
  EXPECT_EQ(json["slivers"].asInt(), 18);
  EXPECT_EQ(json["nodes"].asInt64(), 15000000000LL);
  EXPECT_EQ(json["refits"].asInt(), 16);
  EXPECT_EQ(json["builds"].asInt(), 17);
  ASSERT_EQ(static_cast<int>(json["verdicts"].size()), vtkNBufferStatistics::NumberOfVerdicts);
  for (int i = 0; i < vtkNBufferStatistics::NumberOfVerdicts; ++i)
  {
    const char* name = vtkNBufferStatistics::GetName(static_cast<vtkNBufferVerdict>(i));
    EXPECT_EQ(json["verdicts"][name].asInt(), 100 + i) << name;
  }
  ASSERT_EQ(static_cast<int>(json["drawn_in_round"].size()),
    vtkNBufferStatistics::MaximumNumberOfRounds + 1);
  for (int i = 0; i <= vtkNBufferStatistics::MaximumNumberOfRounds; ++i)
  {
    EXPECT_EQ(json["drawn_in_round"][i].asInt(), 10 + i);
  }
  const Json::Value& times = json["milliseconds"];
  EXPECT_EQ(times["cull"].asDouble(), 0.125);
  EXPECT_EQ(times["refresh"].asDouble(), 0.25);
  EXPECT_EQ(times["frustum"].asDouble(), 0.375);
  EXPECT_EQ(times["read"].asDouble(), 0.5);
  EXPECT_EQ(times["build"].asDouble(), 0.625);
  EXPECT_EQ(times["test"].asDouble(), 0.75);
  EXPECT_EQ(times["pixel_test"].asDouble(), 1.25);
  EXPECT_EQ(times["sliver_test"].asDouble(), 1.375);
  EXPECT_EQ(times["draw"].asDouble(), 0.875);
  EXPECT_EQ(times["device_build"].asDouble(), 1.125);
  EXPECT_EQ(times.size(), 10u);
  EXPECT_EQ(json.size(), 24u) << "a new field wants its line here";
}
