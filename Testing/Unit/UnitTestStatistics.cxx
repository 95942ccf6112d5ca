// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The structs of counts, of the culler and of the shadows: names, sums and JSON.
#include "vtkNBufferStatistics.h"
#include "vtkShadowStatistics.h"

#include "vtk_jsoncpp.h"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

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

/// Every enumerator has a name, and no two the same; the number of them and -1 have none.
template <typename Statistics, typename Enum>
void ExpectNames(Enum count)
{
  std::set<std::string> names;
  for (int i = 0; i < static_cast<int>(count); ++i)
  {
    const std::string name = Statistics::GetName(static_cast<Enum>(i));
    EXPECT_NE(name, "Invalid") << i;
    EXPECT_TRUE(names.insert(name).second) << name << " twice";
  }
  EXPECT_STREQ(Statistics::GetName(count), "Invalid");
  EXPECT_STREQ(Statistics::GetName(static_cast<Enum>(-1)), "Invalid");
}

/// The fields that are single numbers, with their names in JSON.
template <typename Statistics>
struct Fields
{
  std::vector<std::pair<const char*, int Statistics::*>> Ints;
  std::vector<std::pair<const char*, long long Statistics::*>> Longs;
  std::vector<std::pair<const char*, double Statistics::*>> Times; ///< In "milliseconds".

  /// A value of its own in every field, so that two fields mixed up show.
  void Fill(Statistics& statistics) const
  {
    int next = 0;
    for (const auto& [name, field] : this->Ints)
    {
      statistics.*field = ++next;
    }
    for (const auto& [name, field] : this->Longs)
    {
      statistics.*field = 5000000000LL + ++next;
    }
    for (const auto& [name, field] : this->Times)
    {
      statistics.*field = 0.125 * ++next;
    }
  }

  void ExpectIn(const Json::Value& json) const
  {
    int next = 0;
    for (const auto& [name, field] : this->Ints)
    {
      EXPECT_EQ(json[name].asInt(), ++next) << name;
    }
    for (const auto& [name, field] : this->Longs)
    {
      EXPECT_EQ(json[name].asInt64(), 5000000000LL + ++next) << name;
    }
    for (const auto& [name, field] : this->Times)
    {
      EXPECT_EQ(json["milliseconds"][name].asDouble(), 0.125 * ++next) << name;
    }
    EXPECT_EQ(json["milliseconds"].size(), this->Times.size());
  }
};

/// Numbers by enumerator: `first`, the one after it, and so on.
template <typename Statistics, typename Enum, typename Counts>
void ExpectCounts(const Json::Value& json, const Counts& counts, int first)
{
  ASSERT_EQ(json.size(), counts.size());
  for (int i = 0; i < static_cast<int>(counts.size()); ++i)
  {
    const char* name = Statistics::GetName(static_cast<Enum>(i));
    EXPECT_EQ(json[name].asInt(), first + i) << name;
  }
}

using Culling = vtkNBufferStatistics;
const Fields<Culling> CullingFields = {
  { { "candidates", &Culling::Candidates }, { "tested", &Culling::Tested },
    { "passed_coarse_test", &Culling::PassedCoarseTest }, { "held_back", &Culling::HeldBack },
    { "redrawn", &Culling::Redrawn }, { "refreshed", &Culling::Refreshed },
    { "rounds", &Culling::Rounds }, { "levels", &Culling::Levels },
    { "read_backs", &Culling::ReadBacks }, { "failed_frames", &Culling::FailedFrames },
    { "hidden_by_triangles", &Culling::HiddenByTriangles }, { "slivers", &Culling::Slivers },
    { "refits", &Culling::Refits }, { "builds", &Culling::Builds }, { "units", &Culling::Units },
    { "units_outside", &Culling::UnitsOutside }, { "units_kept", &Culling::UnitsKept },
    { "units_fresh", &Culling::UnitsFresh }, { "units_hidden", &Culling::UnitsHidden },
    { "units_on_device", &Culling::UnitsOnDevice }, { "fresh_draws", &Culling::FreshDraws },
    { "tie_queries", &Culling::TieQueries } },
  { { "texels", &Culling::Texels }, { "queries", &Culling::Queries },
    { "lookups", &Culling::Lookups }, { "bytes_read", &Culling::BytesRead },
    { "nodes", &Culling::Nodes } },
  { { "cull", &Culling::CullTime }, { "refresh", &Culling::RefreshTime },
    { "frustum", &Culling::FrustumTime }, { "read", &Culling::ReadTime },
    { "build", &Culling::BuildTime }, { "test", &Culling::TestTime },
    { "pixel_test", &Culling::PixelTestTime }, { "sliver_test", &Culling::SliverTestTime },
    { "draw", &Culling::DrawTime }, { "device_build", &Culling::DeviceBuildTime } }
};

Culling FillCulling()
{
  Culling statistics;
  CullingFields.Fill(statistics);
  statistics.Decision = vtkNBufferDecision::Culled;
  std::iota(statistics.Verdicts.begin(), statistics.Verdicts.end(), 100);
  statistics.Props = std::accumulate(statistics.Verdicts.begin(), statistics.Verdicts.end(), 0);
  std::iota(statistics.DrawnInRound.begin(), statistics.DrawnInRound.end(), 10);
  return statistics;
}

using Shadows = vtkShadowStatistics;
const Fields<Shadows> ShadowFields = {
  { { "lights", &Shadows::Lights }, { "casters", &Shadows::Casters },
    { "updates", &Shadows::Updates }, { "silhouettes", &Shadows::Silhouettes },
    { "pieces", &Shadows::Pieces }, { "draws", &Shadows::Draws }, { "z_pass", &Shadows::ZPass },
    { "boxes", &Shadows::Boxes }, { "stencil_clears", &Shadows::StencilClears },
    { "slabs", &Shadows::Slabs }, { "litmaps", &Shadows::Litmaps },
    { "unclamped_lights", &Shadows::UnclampedLights }, { "read_backs", &Shadows::ReadBacks },
    { "failed_frames", &Shadows::FailedFrames }, { "debug_draws", &Shadows::DebugDraws },
    { "samples", &Shadows::Samples }, { "pixel_frames", &Shadows::PixelFrames } },
  { { "triangles", &Shadows::Triangles }, { "receivers", &Shadows::Receivers },
    { "fragments", &Shadows::Fragments } },
  { { "casters", &Shadows::CasterTime }, { "depth", &Shadows::DepthTime },
    { "read", &Shadows::ReadTime }, { "litmaps", &Shadows::LitmapTime },
    { "plan", &Shadows::PlanTime }, { "draw", &Shadows::DrawTime },
    { "measure", &Shadows::MeasureTime } }
};
}

// Hazard: a new enumerator has no name, or the name of another one, and JSON and overlays show a
// wrong word.
TEST(NBufferStatistics, EveryVerdictAndDecisionHasItsOwnName)
{
  ExpectNames<Culling>(vtkNBufferVerdict::NumberOfVerdicts);
  ExpectNames<Culling>(vtkNBufferDecision::NumberOfDecisions);
}

// Hazard: statistics without a frame look like those of a culled frame.
TEST(NBufferStatistics, StartsAtZero)
{
  const Culling statistics;
  EXPECT_EQ(statistics.Decision, vtkNBufferDecision::None);
  const Json::Value json = Parse(statistics.GetAsJSON());
  for (const std::string& name : json.getMemberNames())
  {
    EXPECT_TRUE(!json[name].isNumeric() || json[name].asDouble() == 0.0) << name;
  }
}

// Hazard: drawn + hidden + outside must be all props, in every frame.
TEST(NBufferStatistics, DrawnHiddenAndOutsideAreAllProps)
{
  const Culling statistics = FillCulling();
  EXPECT_EQ(statistics.GetCount(vtkNBufferVerdict::Outside), 101);
  EXPECT_EQ(statistics.GetCount(vtkNBufferVerdict::Hidden), 102);
  EXPECT_EQ(statistics.GetNumberOfPropsNotDrawn(), 203);
  EXPECT_EQ(
    statistics.GetNumberOfPropsDrawn() + statistics.GetNumberOfPropsNotDrawn(), statistics.Props);
}

// Hazard: scripts pass any number for a verdict, and what lies beside the counts is read.
TEST(NBufferStatistics, NumbersThatAreNoVerdictsCountNothing)
{
  Culling culling;
  culling.Verdicts.fill(7);
  Shadows shadows;
  shadows.Verdicts.fill(7);
  shadows.DeviceTimes.fill(7.0);
  for (const int number : { -1, 1000 })
  {
    EXPECT_EQ(culling.GetCount(static_cast<vtkNBufferVerdict>(number)), 0);
    EXPECT_EQ(shadows.GetCount(static_cast<vtkShadowVerdict>(number)), 0);
    EXPECT_EQ(shadows.GetDeviceTime(static_cast<vtkShadowStage>(number)), -1.0);
  }
  EXPECT_EQ(culling.GetCount(vtkNBufferVerdict::NumberOfVerdicts), 0);
  EXPECT_EQ(shadows.GetCount(vtkShadowVerdict::NumberOfVerdicts), 0);
  EXPECT_EQ(shadows.GetDeviceTime(vtkShadowStage::NumberOfStages), -1.0);
}

// Hazard: a field is missing in JSON, exchanged with another one, or cut to 32 bits.
TEST(NBufferStatistics, JSONHoldsEveryField)
{
  const Culling statistics = FillCulling();
  const Json::Value json = Parse(statistics.GetAsJSON());
  CullingFields.ExpectIn(json);
  EXPECT_EQ(json["decision"].asString(), "Culled");
  EXPECT_EQ(json["props"].asInt(), statistics.Props);
  EXPECT_EQ(json["drawn"].asInt(), statistics.GetNumberOfPropsDrawn());
  ExpectCounts<Culling, vtkNBufferVerdict>(json["verdicts"], statistics.Verdicts, 100);
  ASSERT_EQ(json["drawn_in_round"].size(), statistics.DrawnInRound.size());
  for (int i = 0; i <= Culling::MaximumNumberOfRounds; ++i)
  {
    EXPECT_EQ(json["drawn_in_round"][i].asInt(), 10 + i);
  }
  EXPECT_EQ(json.size(), 33u) << "a new field wants its line here";
}

TEST(ShadowStatistics, EveryEnumeratorHasItsOwnName)
{
  ExpectNames<Shadows>(vtkShadowVerdict::NumberOfVerdicts);
  ExpectNames<Shadows>(vtkShadowSkip::NumberOfSkips);
  ExpectNames<Shadows>(vtkShadowDecision::NumberOfDecisions);
  ExpectNames<Shadows>(vtkShadowStage::NumberOfStages);
}

// A time that was not measured must not look like a time of 0.
TEST(ShadowStatistics, NothingIsMeasuredAtFirst)
{
  const Json::Value json = Parse(Shadows().GetAsJSON());
  EXPECT_EQ(json["decision"].asString(), "None");
  EXPECT_EQ(json["fragments"].asInt(), -1);
  EXPECT_EQ(json["draws"].asInt(), 0);
  for (const char* stage : { "depth", "draw", "color" })
  {
    EXPECT_EQ(json["device_milliseconds"][stage].asDouble(), -1.0) << stage;
  }
}

// Hazard: a field is missing in JSON, exchanged with another one, or cut to 32 bits.
TEST(ShadowStatistics, JSONHoldsEveryField)
{
  Shadows statistics;
  ShadowFields.Fill(statistics);
  statistics.Decision = vtkShadowDecision::Drawn;
  std::iota(statistics.Verdicts.begin(), statistics.Verdicts.end(), 100);
  std::iota(statistics.Skipped.begin(), statistics.Skipped.end(), 200);
  statistics.DeviceTimes = { 0.25, 0.5, 0.75 };
  statistics.LightCosts = { {}, { true, 1.5, 2.5, 3.5 } };
  const Json::Value json = Parse(statistics.GetAsJSON());
  ShadowFields.ExpectIn(json);
  EXPECT_EQ(json["decision"].asString(), "Drawn");
  ExpectCounts<Shadows, vtkShadowVerdict>(json["verdicts"], statistics.Verdicts, 100);
  ExpectCounts<Shadows, vtkShadowSkip>(json["skipped"], statistics.Skipped, 200);
  ASSERT_EQ(json["light_costs"].size(), 2u);
  EXPECT_EQ(json["light_costs"][0]["whole_estimate"].asDouble(), -1.0) << "not estimated";
  const Json::Value& light = json["light_costs"][1];
  EXPECT_TRUE(light["has_litmaps"].asBool());
  EXPECT_EQ(light["whole_estimate"].asDouble(), 1.5);
  EXPECT_EQ(light["litmap_estimate"].asDouble(), 2.5);
  EXPECT_EQ(light["time"].asDouble(), 3.5);
  const Json::Value& device = json["device_milliseconds"];
  EXPECT_EQ(device["depth"].asDouble(), 0.25);
  EXPECT_EQ(device["draw"].asDouble(), 0.5);
  EXPECT_EQ(device["color"].asDouble(), 0.75);
  EXPECT_EQ(statistics.GetDeviceTime(vtkShadowStage::Draw), 0.5);
}
