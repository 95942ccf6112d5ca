// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The named scenarios of hazards (NamedScenarios.h), as they are.
#include "CullerTest.h"

#include "Checker.h"
#include "NamedScenarios.h"
#include "ScenarioJson.h"

#include <cstdlib>
#include <iostream>

using TestScene::Expectation;
using TestScene::NamedScenario;

namespace
{
void CheckExpectations(const NamedScenario& hazard, const TestScene::Player& tested, int frame)
{
  SCOPED_TRACE("frame " + std::to_string(frame));
  vtkNBufferCuller* culler = tested.GetCuller();
  ASSERT_NE(culler, nullptr);
  const vtkNBufferStatistics& statistics = culler->GetStatistics(tested.GetRenderer());
  for (const Expectation& expectation : hazard.Expectations)
  {
    if (frame < expectation.FirstFrame || frame > expectation.LastFrame)
    {
      continue;
    }
    const int hidden = statistics.GetCount(vtkNBufferVerdict::Hidden);
    EXPECT_GE(hidden, expectation.MinimumHidden);
    EXPECT_LE(hidden, expectation.MaximumHidden);
    for (const int prop : expectation.Props)
    {
      const vtkNBufferVerdict verdict =
        culler->GetVerdict(tested.Props.at(prop), tested.GetRenderer());
      EXPECT_EQ(verdict == expectation.Verdict, expectation.HasVerdict)
        << "prop " << prop << " is " << vtkNBufferStatistics::GetName(verdict) << ", not "
        << vtkNBufferStatistics::GetName(expectation.Verdict);
    }
  }
}

/// Plays all variants of a hazard.
void PlayHazard(const std::string& name)
{
  int variants = 0;
  for (const NamedScenario& hazard : TestScene::GetCullingHazards())
  {
    if (hazard.Name != name)
    {
      continue;
    }
    SCOPED_TRACE("variant " + std::to_string(variants++));
    TestScene::Checker checker;
    checker.AfterFrame = [&hazard](const TestScene::Player& tested, int frame)
    { CheckExpectations(hazard, tested, frame); };
    const TestScene::Outcome outcome = checker.Run(hazard.Scenario, true);
    EXPECT_EQ(outcome.Failure, "") << "in frame " << outcome.Frame;
  }
  EXPECT_GT(variants, 0);
}
}

#define SCENARIO_TEST(suite, name)                                                                 \
  TEST(suite, name)                                                                                \
  {                                                                                                \
    PlayHazard(#name);                                                                             \
  }

SCENARIO_TEST(CullerHazards, AbuttingTilesAndBoxes)
SCENARIO_TEST(CullerHazards, BoxesBehindTheEyeAndBesideIt)
SCENARIO_TEST(CullerHazards, BoxesSmallerThanAPixel)
SCENARIO_TEST(CullerHazards, DecalsOnFaces)
SCENARIO_TEST(CullerHazards, ExtremeClippingRanges)
SCENARIO_TEST(CullerHazards, EyeInsideABox)
SCENARIO_TEST(CullerHazards, FarFromTheOrigin)
SCENARIO_TEST(CullerHazards, FenceWithNarrowGaps)
SCENARIO_TEST(CullerHazards, FlyingThroughBoxes)
SCENARIO_TEST(CullerHazards, LargeMatricesAndScales)
SCENARIO_TEST(CullerHazards, NearPlaneCutsTheOccluder)
SCENARIO_TEST(CullerHazards, NearPlaneThroughABox)
SCENARIO_TEST(CullerHazards, Specks)
SCENARIO_TEST(CullerHazards, TheCameraJumpsBackAndForth)
SCENARIO_TEST(CullerHazards, TheSameQuadFiftyTimes)
