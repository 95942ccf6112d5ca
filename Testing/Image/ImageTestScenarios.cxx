// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The named scenarios of hazards (NamedScenarios.h), as they are.
#include "CullerTest.h"

#include "Checker.h"
#include "NamedScenarios.h"
#include "TestedBackend.h"

#include <algorithm>
#include <set>

using TestScene::Expectation;
using TestScene::NamedScenario;
using TestScene::Player;

namespace
{
/// How many pixels of the window have exactly this colour.
int CountPixels(const Player& stage, const glm::dvec3& color)
{
  const TestScene::Picture picture = TestScene::TakePicture(stage.Window);
  int count = 0;
  for (std::size_t i = 0; i < picture.Colors.size() / 4; ++i)
  {
    const unsigned char* p = picture.GetColor(i);
    count += glm::dvec3(p[0], p[1], p[2]) == 255.0 * color;
  }
  return count;
}

/// The indices of the props that are hidden in the first renderer.
std::set<int> FindHidden(const Player& tested)
{
  std::set<int> hidden;
  for (int i = 0; i < static_cast<int>(tested.Props.size()) && tested.GetCuller(); ++i)
  {
    if (tested.GetCuller()->GetVerdict(tested.Props[i], tested.GetRenderer(0)) ==
      vtkNBufferVerdict::Hidden)
    {
      hidden.insert(i);
    }
  }
  return hidden;
}

/// `before`: the props that the last frame found hidden.
void CheckExpectation(
  const Expectation& expectation, const Player& tested, const std::set<int>& before)
{
  vtkNBufferCuller* culler = tested.GetCuller(expectation.Renderer);
  vtkRenderer* renderer = tested.GetRenderer(expectation.Renderer);
  SCOPED_TRACE("renderer " + std::to_string(expectation.Renderer));
  if ((expectation.NeedsSamples && tested.Window->GetMultiSamples() == 0) ||
    (expectation.NeedsPixels && !TestsAllPixels(culler)))
  {
    return;
  }
  const vtkNBufferStatistics& statistics = culler->GetStatistics(renderer);
  EXPECT_TRUE(!expectation.Statistics || expectation.Statistics(statistics))
    << statistics.GetAsJSON();
  const int hidden = statistics.GetCount(vtkNBufferVerdict::Hidden);
  EXPECT_GE(hidden, expectation.MinimumHidden);
  EXPECT_LE(hidden, expectation.MaximumHidden);
  EXPECT_GE(hidden + statistics.GetCount(vtkNBufferVerdict::Outside), expectation.MinimumCulled);
  EXPECT_TRUE(expectation.MinimumPixels == 0 ||
    CountPixels(tested, expectation.Color) >= expectation.MinimumPixels);
  EXPECT_EQ(statistics.Decision, expectation.Decision.value_or(statistics.Decision));
  int hiddenProps = 0;
  for (const int prop : expectation.Props)
  {
    const vtkNBufferVerdict verdict = culler->GetVerdict(tested.Props.at(prop), renderer);
    const std::vector<vtkNBufferVerdict>& allowed = expectation.Allowed;
    const auto isAllowed = [&allowed](vtkNBufferVerdict v)
    { return std::count(allowed.begin(), allowed.end(), v) > 0; };
    EXPECT_TRUE(isAllowed(verdict) ||
      (verdict == vtkNBufferVerdict::Visible && isAllowed(vtkNBufferVerdict::Hidden) &&
        !TestsAllPixels(culler)))
      << "prop " << prop << " is " << vtkNBufferStatistics::GetName(verdict) << ", and not "
      << testing::PrintToString(allowed);
    hiddenProps += verdict == vtkNBufferVerdict::Hidden;
  }
  EXPECT_GE(hiddenProps, expectation.MinimumHiddenOfProps);
  for (const int prop : expectation.StayHidden)
  {
    EXPECT_TRUE(before.count(prop) == 0 ||
      culler->GetVerdict(tested.Props.at(prop), renderer) == vtkNBufferVerdict::Hidden)
      << "prop " << prop;
  }
}

void CheckFrame(const NamedScenario& hazard, const Player& reference, const Player& tested,
  int frame, const std::string& failure, std::set<int>& hidden)
{
  const std::string name = "frame " + std::to_string(frame);
  SCOPED_TRACE(name);
  PrintStatistics(tested, name);
  EXPECT_EQ(failure, "");
  if (!failure.empty())
  {
    WritePictures(reference, tested, name);
  }
  ASSERT_NE(tested.GetCuller(), nullptr);
  EXPECT_EQ(TestScene::FindWrongDraws(reference, tested, TestScene::MustBeDrawn::Tested, true), "");
  for (const Expectation& expectation : hazard.Expectations)
  {
    if (expectation.Frame == frame)
    {
      CheckExpectation(expectation, tested, hidden);
    }
  }
  hidden = FindHidden(tested);
}

const std::vector<NamedScenario>& GetHazards()
{
  static const std::vector<NamedScenario> hazards = TestScene::GetCullingHazards();
  return hazards;
}

/// Plays all variants of a hazard.
class HazardTest : public testing::Test
{
public:
  explicit HazardTest(const std::string& name)
    : Name(name)
  {
  }

  void TestBody() override
  {
    int variants = 0;
    for (const NamedScenario& hazard : GetHazards())
    {
      if (hazard.Name != this->Name)
      {
        continue;
      }
      SCOPED_TRACE("variant " + std::to_string(variants++));
      TestScene::Checker checker;
      std::set<int> hidden;
      checker.AfterFrame =
        [&](const Player& reference, const Player& tested, int frame, const std::string& failure)
      { CheckFrame(hazard, reference, tested, frame, failure, hidden); };
      TestScene::Tally tally;
      checker.Run(hazard.Scenario, true, &tally);
      EXPECT_EQ(tally.Frames, hazard.Scenario.Frames);
      EXPECT_EQ(tally.ReferenceFaults, 0) << "VTK alone";
    }
  }

private:
  const std::string Name;
};

/// One test for each name, so that no hazard is left out.
[[maybe_unused]] const bool AreRegistered = []
{
  std::set<std::string> names;
  for (const NamedScenario& hazard : GetHazards())
  {
    if (names.insert(hazard.Name).second)
    {
      const std::size_t dot = hazard.Name.find('.');
      const bool hasSuite = dot != std::string::npos;
      const std::string suite = hasSuite ? hazard.Name.substr(0, dot) : "CullerHazards";
      const std::string test = hasSuite ? hazard.Name.substr(dot + 1) : hazard.Name;
      testing::RegisterTest(suite.c_str(), test.c_str(), nullptr, nullptr, __FILE__, __LINE__,
        [name = hazard.Name]() -> testing::Test* { return new HazardTest(name); });
    }
  }
  return true;
}();
}
