// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What the ranks of a parallel program exchange: the reduction never hides what is seen, and all
// ranks compute the same plan.
#include "vtkNBufferExchangeMessage.h"
#include "vtkNBufferExchangePlan.h"
#include "vtkNBufferLevels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace
{
constexpr int Width = 37;
constexpr int Height = 23;
constexpr int Tile = 4;

/// Depth images of ranks: near rectangles before the far plane.
std::vector<std::vector<float>> MakeDepths(int ranks, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<std::vector<float>> depths(ranks, std::vector<float>(Width * Height, 1.0F));
  for (std::vector<float>& depth : depths)
  {
    for (int n = 0; n < 3; ++n)
    {
      const int x0 = static_cast<int>(random() % Width);
      const int y0 = static_cast<int>(random() % Height);
      const int x1 = std::min<int>(x0 + 1 + random() % 20, Width);
      const int y1 = std::min<int>(y0 + 1 + random() % 20, Height);
      const float z = 0.01F * static_cast<float>(random() % 100);
      for (int y = y0; y < y1; ++y)
      {
        for (int x = x0; x < x1; ++x)
        {
          depth[y * Width + x] = std::min(depth[y * Width + x], z);
        }
      }
    }
  }
  return depths;
}

std::vector<float> GetMinima(const std::vector<std::vector<float>>& all)
{
  std::vector<float> minima = all.front();
  for (const std::vector<float>& values : all)
  {
    std::transform(values.begin(), values.end(), minima.begin(), minima.begin(),
      [](float a, float b) { return std::min(a, b); });
  }
  return minima;
}

std::vector<float> ReduceByTiles(const std::vector<float>& depth, vtkNBufferExtremum extremum)
{
  vtkNBufferLevels levels;
  levels.BuildBase(depth.data(), Width, Height, Tile, extremum);
  const float* base = levels.GetLevelData(0);
  return std::vector<float>(base, base + levels.GetWidth() * levels.GetHeight());
}

vtkNBufferRankReport MakeReport(float view)
{
  vtkNBufferRankReport report;
  report.View.fill(view);
  report.Step = 0x1p-24;
  return report;
}

std::vector<vtkNBufferRankReply> Exchange(const std::vector<vtkNBufferRankReport>& reports)
{
  const int ranks = static_cast<int>(reports.size());
  std::vector<vtkNBufferExchangeMessage> messages;
  std::vector<std::vector<float>> values;
  for (int rank = 0; rank < ranks; ++rank)
  {
    messages.emplace_back(6, ranks, rank);
    messages.back().SetReport(reports[rank]);
    values.push_back(messages.back().GetValues());
  }
  std::vector<vtkNBufferRankReply> replies;
  for (const vtkNBufferExchangeMessage& message : messages)
  {
    replies.push_back(message.GetReply(GetMinima(values)));
  }
  return replies;
}
}

TEST(Exchange, FarthestOfTileThenMinimumOverRanksIsNeverNearerThanTheImage)
{
  int wrong = 0;
  for (unsigned int seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE(seed);
    const std::vector<std::vector<float>> depths = MakeDepths(1 + seed % 7, seed);
    const std::vector<float> image = ReduceByTiles(GetMinima(depths), vtkNBufferExtremum::Maximum);
    std::vector<std::vector<float>> farthest;
    std::vector<std::vector<float>> nearest;
    for (const std::vector<float>& depth : depths)
    {
      farthest.push_back(ReduceByTiles(depth, vtkNBufferExtremum::Maximum));
      nearest.push_back(ReduceByTiles(depth, vtkNBufferExtremum::Minimum));
    }
    const std::vector<float> shared = GetMinima(farthest);
    const std::vector<float> control = GetMinima(nearest);
    for (std::size_t i = 0; i < image.size(); ++i)
    {
      EXPECT_GE(shared[i], image[i]);
      wrong += control[i] < image[i];
    }
    if (depths.size() == 1)
    {
      EXPECT_EQ(shared, image);
    }
  }
  // The negative control: the nearest depth of a tile would hide what is seen.
  EXPECT_GT(wrong, 1000);
}

TEST(Exchange, AMessageBeginsWithTheFarPlane)
{
  vtkNBufferExchangeMessage message(6, 3, 1);
  EXPECT_TRUE(std::all_of(
    message.GetTexels(), message.GetTexels() + 6, [](float texel) { return texel == 1.0F; }));
}

TEST(Exchange, EachRankGetsTheReportsOfAll)
{
  std::vector<vtkNBufferRankReport> reports(5, MakeReport(0.25F));
  for (int i = 0; i < 5; ++i)
  {
    reports[i].Candidates = 1000 + i;
    reports[i].Gain = i;
    reports[i].Unhidden = 10 * i;
  }
  reports[1].Step = 0x1p-16;
  reports[2].NewProps = 300;
  for (const vtkNBufferRankReply& reply : Exchange(reports))
  {
    EXPECT_TRUE(reply.SameView);
    EXPECT_EQ(reply.Step, 0x1p-16);
    EXPECT_FALSE(reply.Changed);
    EXPECT_EQ(reply.NewProps, 300);
    EXPECT_EQ(reply.Candidates, 5010);
    EXPECT_EQ(reply.Gain, 10);
    EXPECT_EQ(reply.Unhidden, 100);
  }
  EXPECT_FALSE(Exchange(reports)[0].Misfit);
  reports[4].Changed = true;
  reports[2].Misfit = true;
  reports[3].View[7] = 0.2500001F;
  for (const vtkNBufferRankReply& reply : Exchange(reports))
  {
    EXPECT_FALSE(reply.SameView);
    EXPECT_TRUE(reply.Changed);
    EXPECT_TRUE(reply.Misfit);
  }
}

TEST(Exchange, AStepThatIsNoFloatIsRoundedUp)
{
  std::vector<vtkNBufferRankReport> reports(2, MakeReport(0.0F));
  reports[0].Step = 0.1;
  EXPECT_GE(Exchange(reports)[1].Step, 0.1);
}

namespace
{
vtkNBufferRankReply MakeReply(bool changed)
{
  vtkNBufferRankReply reply;
  reply.Changed = changed;
  return reply;
}
}

TEST(ExchangePlan, OneExchangePerFrameAndNoPollWhileAnythingChanges)
{
  vtkNBufferExchangePlan plan;
  for (int i = 0; i < 100; ++i)
  {
    plan.BeginFrame(false);
    EXPECT_FALSE(plan.HasPoll()) << i;
    EXPECT_EQ(plan.GetNumberOfExchanges(), 1) << i;
    plan.Learn(MakeReply(true), 0);
    EXPECT_EQ(plan.GetNumberOfExchanges(), 1) << i;
  }
}

TEST(ExchangePlan, TwoExchangesWhereARankHasANewView)
{
  vtkNBufferExchangePlan plan;
  plan.BeginFrame(true);
  vtkNBufferRankReply reply = MakeReply(true);
  reply.NewProps = vtkNBufferExchangePlan::FewNewProps;
  plan.Learn(reply, 0);
  EXPECT_EQ(plan.GetNumberOfExchanges(), 1);
  plan.BeginFrame(true);
  ++reply.NewProps;
  plan.Learn(reply, 0);
  EXPECT_EQ(plan.GetNumberOfExchanges(), 2);
  plan.Learn(reply, 1);
  EXPECT_EQ(plan.GetNumberOfExchanges(), 2);
}

TEST(ExchangePlan, OnlyAPollWhileNothingChanges)
{
  vtkNBufferExchangePlan plan;
  plan.BeginFrame(false);
  plan.Learn(MakeReply(false), 0);
  for (int i = 0; i < 50; ++i)
  {
    plan.BeginFrame(false);
    ASSERT_TRUE(plan.HasPoll()) << i;
    EXPECT_EQ(plan.GetNumberOfExchanges(), 1) << i;
    plan.LearnPoll(false);
    EXPECT_EQ(plan.GetNumberOfExchanges(), 0) << i;
    EXPECT_FALSE(plan.HasPoll()) << i;
  }
}

TEST(ExchangePlan, AChangeIsExchangedInTheFrameInWhichThePollFindsIt)
{
  vtkNBufferExchangePlan plan;
  plan.BeginFrame(false);
  plan.Learn(MakeReply(false), 0);
  plan.BeginFrame(false);
  plan.LearnPoll(true);
  EXPECT_FALSE(plan.HasPoll());
  EXPECT_EQ(plan.GetNumberOfExchanges(), 1);
  plan.Learn(MakeReply(true), 0);
  plan.BeginFrame(false);
  EXPECT_FALSE(plan.HasPoll());
  EXPECT_EQ(plan.GetNumberOfExchanges(), 1);
}

TEST(ExchangePlan, PausesWhereTrialsGainNothing)
{
  for (int gain : { 0, 500 })
  {
    vtkNBufferExchangePlan plan;
    int exchanges = 0;
    bool hadTrial = false;
    for (int i = 0; i < 400; ++i)
    {
      plan.BeginFrame(true);
      if (plan.GetNumberOfExchanges() > 0)
      {
        vtkNBufferRankReply reply = MakeReply(true);
        reply.Unhidden = 1000;
        reply.Gain = hadTrial ? gain : 0;
        hadTrial = plan.IsTrial();
        plan.Learn(reply, 0);
        ++exchanges;
      }
    }
    EXPECT_EQ(exchanges == 400, gain > 0) << exchanges;
    EXPECT_TRUE(gain > 0 || exchanges < 40) << exchanges;
  }
}

TEST(ExchangePlan, TrialsAreRareWhereTheyGain)
{
  vtkNBufferExchangePlan plan;
  std::vector<int> trials;
  for (int i = -3; i < 60; ++i)
  {
    plan.BeginFrame(i >= 0);
    if (plan.IsTrial())
    {
      trials.push_back(i);
    }
    vtkNBufferRankReply reply = MakeReply(true);
    reply.Unhidden = 1000;
    reply.Gain = i < 45 ? 500 : 0; // The fourth trial is the last one with a gain.
    plan.Learn(reply, 0);
  }
  EXPECT_EQ(trials, (std::vector<int>{ 0, 4, 21, 38, 55, 59 }));
}

TEST(ExchangePlan, PoorTrialsInNewViewsDoNotCount)
{
  // Every other trial is in a new view.
  for (int gainOfNew : { 0, 500 })
  {
    vtkNBufferExchangePlan plan;
    int exchanges = 0;
    bool hadTrial = false;
    bool wasNew = false;
    for (int i = 0; i < 400; ++i)
    {
      plan.BeginFrame(true);
      if (plan.GetNumberOfExchanges() == 0)
      {
        continue;
      }
      vtkNBufferRankReply reply = MakeReply(true);
      reply.Unhidden = 1000;
      reply.Gain = hadTrial && wasNew ? gainOfNew : 0;
      wasNew = exchanges++ % 8 < 4;
      reply.NewProps = wasNew ? vtkNBufferExchangePlan::FewNewProps + 1 : 0;
      hadTrial = plan.IsTrial();
      plan.Learn(reply, 0);
      EXPECT_EQ(plan.GetNumberOfExchanges(), wasNew ? 2 : 1) << i;
    }
    EXPECT_EQ(exchanges == 400, gainOfNew > 0) << exchanges;
  }
}

TEST(ExchangePlan, ARankThatCutsAgainAndAgainNeverPauses)
{
  vtkNBufferExchangePlan plan;
  for (int i = 0; i < 400; ++i)
  {
    plan.BeginFrame(true);
    ASSERT_EQ(plan.GetNumberOfExchanges(), 1) << i;
    vtkNBufferRankReply reply = MakeReply(true);
    reply.Unhidden = 1000;
    reply.NewProps = vtkNBufferExchangePlan::FewNewProps + 1;
    plan.Learn(reply, 0);
  }
}
