// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What the fuzzer's word rests on: scenarios survive their files, runs repeat themselves, and the
// shrinker finds what a failure needs.
#include "Checker.h"
#include "Generator.h"
#include "Messages.h"
#include "NamedScenarios.h"
#include "ScenarioJson.h"
#include "Shrinker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace TestScene;

namespace
{
Json::Value Parse(const std::string& text)
{
  Json::Value value;
  std::istringstream stream(text);
  std::string errors;
  EXPECT_TRUE(Json::parseFromStream(Json::CharReaderBuilder(), stream, &value, &errors)) << errors;
  return value;
}

Scenario PassThroughText(const Scenario& scenario)
{
  return FromJson(Parse(ToText(ToJson(scenario))));
}

class FuzzRuns : public testing::Test
{
protected:
  void SetUp() override
  {
    const std::string fault = FindWindowFault();
    if (!fault.empty())
    {
      GTEST_SKIP() << fault;
    }
  }
};
}

TEST(FuzzScenario, SameSeedSameScenario)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    EXPECT_EQ(ToText(ToJson(MakeScenario(seed))), ToText(ToJson(MakeScenario(seed))));
  }
  EXPECT_NE(ToText(ToJson(MakeScenario(1))), ToText(ToJson(MakeScenario(2))));
}

TEST(FuzzScenario, SurvivesItsFile)
{
  for (std::uint64_t seed = 0; seed < 400; ++seed)
  {
    const Scenario scenario =
      MakeScenario(seed, seed % 2 ? ScenarioKind::Shadows : ScenarioKind::Culling);
    const Scenario read = PassThroughText(scenario);
    ASSERT_EQ(ToText(ToJson(read)), ToText(ToJson(scenario)));
    ASSERT_EQ(read.Seed, scenario.Seed);
    ASSERT_EQ(read.Lights.size(), scenario.Lights.size());
    ASSERT_EQ(read.Props.size(), scenario.Props.size());
    for (std::size_t i = 0; i < read.Props.size(); ++i)
    {
      // Bit by bit, not merely as text.
      ASSERT_EQ(read.Props[i].Shape.Center, scenario.Props[i].Shape.Center);
      ASSERT_EQ(read.Props[i].Shape.Size, scenario.Props[i].Shape.Size);
      ASSERT_EQ(read.Props[i].Color, scenario.Props[i].Color);
    }
  }
}

TEST(FuzzScenario, NumbersOfEveryKindSurvive)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> values = { 0.0, -0.0, 0.1, 1.0 / 3.0, 5e6 + 0.01,
    std::numeric_limits<double>::min(), std::numeric_limits<double>::denorm_min(),
    std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
    std::nextafter(1.0, 2.0), infinity, -infinity, std::nan("") };
  Scenario scenario;
  scenario.Seed = std::numeric_limits<std::uint64_t>::max();
  Change change;
  change.Values = values;
  scenario.Changes.push_back(change);
  const Scenario read = PassThroughText(scenario);
  EXPECT_EQ(read.Seed, scenario.Seed);
  const std::vector<double>& found = read.Changes.at(0).Values;
  ASSERT_EQ(found.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_TRUE(std::isnan(values[i]) ? std::isnan(found[i]) : found[i] == values[i]) << values[i];
    EXPECT_EQ(std::signbit(found[i]), std::signbit(values[i])) << values[i];
  }
}

TEST(FuzzScenario, SaysWhereAFileIsWrong)
{
  const auto getFault = [](const std::string& text)
  { return GetThrownMessage([&text] { FromJson(Parse(text)); }); };
  EXPECT_EQ(getFault("{}"), "");
  EXPECT_EQ(getFault(R"({"frames": "many"})"), "scenario.frames must be an integer");
  EXPECT_EQ(getFault(R"({"props": [{}, {"kind": "Dragon"}]})"),
    "scenario.props[1].kind must be one of the names known here");
  EXPECT_EQ(getFault(R"({"window": {"depth": 3}})"),
    "scenario.window must be without members that are not known here");
  EXPECT_EQ(getFault(R"({"views": [{"position": [1, 2]}]})"),
    "scenario.views[0].position must be 3 numbers");
  EXPECT_THROW(ReadJson("no/such/file.json"), std::runtime_error);
}

// Every named scenario is a plain one: it survives its file, too.
TEST(FuzzScenario, NamedScenariosSurviveTheirFiles)
{
  for (const auto& part : { GetCullingHazards(), GetLightScenarios(), GetViewScenarios(),
         GetMeshScenarios(), GetLargeScenarios() })
  {
    for (const NamedScenario& named : part)
    {
      EXPECT_EQ(ToText(ToJson(PassThroughText(named.Scenario))), ToText(ToJson(named.Scenario)))
        << named.Name;
    }
  }
}

// A planted fault: two props of a colour, under MSAA, from frame 3 on.
TEST(FuzzShrinker, LeavesWhatTheFailureNeeds)
{
  std::uint64_t seed = 1;
  while (MakeScenario(seed).Props.size() <= 10)
  {
    ++seed;
  }
  Scenario scenario = MakeScenario(seed);
  scenario.Frames = 9;
  scenario.Window.MultiSamples = 4;
  scenario.Props[2].Opacity = 0.125;
  scenario.Props[9].Opacity = 0.125;
  Change change;
  change.Frame = 3;
  change.Kind = ChangeKind::Select;
  scenario.Changes.push_back(change);
  const auto fails = [](const Json::Value& value)
  {
    const Scenario candidate = FromJson(value);
    const auto odd = std::count_if(candidate.Props.begin(), candidate.Props.end(),
      [](const Prop& prop) { return prop.Opacity == 0.125; });
    return odd == 2 && candidate.Window.MultiSamples == 4 &&
      std::any_of(candidate.Changes.begin(), candidate.Changes.end(),
        [&](const Change& c)
        { return c.Kind == ChangeKind::Select && c.Frame < candidate.Frames; });
  };
  const ShrinkResult result = Shrink(ToJson(scenario), fails, 5000);
  const Scenario small = FromJson(result.Value);
  EXPECT_TRUE(fails(result.Value));
  EXPECT_EQ(small.Props.size(), 2u);
  EXPECT_EQ(small.Changes.size(), 1u);
  EXPECT_TRUE(small.Views.empty());
  EXPECT_EQ(small.Frames, 1) << "frames before the one that fails are left out";
  Scenario expected;
  expected.Seed = scenario.Seed;
  expected.Window.MultiSamples = 4;
  expected.Props.resize(2);
  for (int i = 0; i < 2; ++i)
  {
    expected.Props[i].Id = scenario.Props[i == 0 ? 2 : 9].Id;
    expected.Props[i].Opacity = 0.125;
  }
  expected.Changes.resize(1);
  expected.Changes[0].Kind = ChangeKind::Select;
  EXPECT_EQ(ToText(ToJson(small)), ToText(ToJson(expected))) << "all else has its default";
}

TEST(FuzzShrinker, KeepsToItsBudget)
{
  const Json::Value whole = ToJson(MakeScenario(3));
  int questions = 0;
  const auto never = [&questions](const Json::Value&)
  {
    ++questions;
    return false;
  };
  const ShrinkResult result = Shrink(whole, never, 25);
  EXPECT_EQ(questions, 25);
  EXPECT_EQ(result.Questions, 25);
  EXPECT_EQ(ToText(result.Value), ToText(whole)) << "what does not fail is not kept";
}

//------------------------------------------------------------------------------------------------
// A run is worth reporting only if it can be repeated.
TEST_F(FuzzRuns, RepeatThemselvesFromTheirFiles)
{
  for (std::uint64_t seed = 0; seed < 3; ++seed)
  {
    Scenario scenario = MakeScenario(seed);
    scenario.Frames = 3;
    Tally tallies[2];
    Checker checker;
    const Outcome first = checker.Run(scenario, true, &tallies[0]);
    const Outcome second = checker.Run(PassThroughText(scenario), true, &tallies[1]);
    EXPECT_EQ(first.Failure, "");
    EXPECT_EQ(second.Failure, "");
    EXPECT_EQ(tallies[0].Frames, 3);
    EXPECT_EQ(tallies[0].Verdicts, tallies[1].Verdicts);
    EXPECT_EQ(tallies[0].Decisions, tallies[1].Decisions);
    EXPECT_EQ(tallies[0].Hidden, tallies[1].Hidden);
  }
}

// A checker that compares nothing finds nothing. VTK's own culler drops a prop below the window
// although its shader lifts it into the picture.
TEST_F(FuzzRuns, SeeWhatACullerDropsWrongly)
{
  Scenario scenario;
  scenario.Frames = 2;
  scenario.Culler.DefaultCuller = DefaultCuller::Before;
  scenario.Props.resize(1);
  scenario.Props[0].Shape.Center = { 0.0, -1.2, 0.0 };
  scenario.Props[0].Shape.Size = { 0.2, 0.2, 0.2 };
  scenario.Props[0].Shader = Shader::MovesVertices;
  scenario.Views.resize(1);
  scenario.Views[0].Parallel = true;
  scenario.Views[0].Near = 1.0;
  scenario.Views[0].Far = 20.0;
  EXPECT_EQ(Checker(Role::Reference).Run(scenario, true).Failure, "");
  const Outcome outcome = Checker(Role::Stock).Run(scenario, true);
  EXPECT_EQ(outcome.Frame, 0);
  EXPECT_EQ(outcome.Failure.find("The image differs in "), 0u) << outcome.Failure;
}

TEST_F(FuzzRuns, CountWhatIsHidden)
{
  Scenario scenario;
  scenario.Frames = 3;
  scenario.Culler.RoundSize = 1;
  for (int i = 0; i < 6; ++i)
  {
    Prop prop;
    prop.Id = i;
    prop.Shape.Center = { 0.0, 0.0, -2.0 * i };
    prop.Shape.Size = { 2.0, 2.0, i == 0 ? 0.1 : 1.0 };
    scenario.Props.push_back(prop);
  }
  scenario.Views.resize(1);
  Tally tally;
  EXPECT_EQ(Checker().Run(scenario, true, &tally).Failure, "");
  EXPECT_EQ(tally.Scenarios, 1);
  EXPECT_EQ(tally.Frames, 3);
  EXPECT_EQ(tally.Props, 18);
  EXPECT_GE(tally.Hidden, 3 * 3);
  EXPECT_EQ(tally.FramesWithHidden, 3);
  EXPECT_EQ(tally.GLErrors, 0);
}

// Where the names of what is deleted belong to the other window, that one loses what it still has.
TEST_F(FuzzRuns, StagesActInTheirOwnContext)
{
  Scenario scenario;
  scenario.Props.resize(1);
  scenario.Views.resize(1);
  Player stages[2] = { Player(Role::Reference), Player(Role::Culled) };
  for (Player& stage : stages)
  {
    stage.Begin(scenario);
    stage.Prepare(0);
    stage.UsePasses();
    stage.Window->Render();
  }
  for (Player& stage : stages)
  {
    Player& other = &stage == stages ? stages[1] : stages[0];
    other.Window->MakeCurrent();
    stage.Prepare(0);
    EXPECT_TRUE(stage.Window->IsCurrent());
    other.Window->MakeCurrent();
    stage.End();
    EXPECT_TRUE(stage.Window->IsCurrent());
  }
}

//------------------------------------------------------------------------------------------------
namespace
{
/// A box over a floor, in the light of a lamp.
Scenario MakeShadowScene(ShadowMode mode)
{
  Scenario scenario;
  scenario.Frames = 3;
  scenario.Shadows.Mode = mode;
  scenario.Shadows.CompareRays = true;
  scenario.Lights.resize(1);
  scenario.Renderers[0].Pass = PassKind::ShadowVolumes;
  scenario.Props.resize(2);
  scenario.Props[0].Shape.Size = { 6.0, 0.1, 6.0 };
  scenario.Props[1].Id = 1;
  scenario.Props[1].Shape.Center = { 0.0, 1.0, 0.0 };
  scenario.Views.resize(1);
  scenario.Views[0].Position = { 0.0, 5.0, 10.0 };
  return scenario;
}
}

TEST_F(FuzzRuns, CompareShadows)
{
  const std::vector<Scenario> scenarios = { MakeShadowScene(ShadowMode::Unclamped),
    MakeShadowScene(ShadowMode::Scissored), MakeShadowScene(ShadowMode::Clamped),
    MakeShadowScene(ShadowMode::Automatic), MakeShadowScene(ShadowMode::Culled) };
  for (const Scenario& scenario : scenarios)
  {
    Tally tally;
    EXPECT_EQ(Checker().Run(scenario, true, &tally).Failure, "");
    EXPECT_EQ(tally.ShadowFrames, 3);
    EXPECT_EQ(tally.ShadowDecisions["Drawn"] + tally.ShadowDecisions["Still"], 3);
    EXPECT_GE(tally.ShadowDecisions["Still"], 1);
    EXPECT_GT(tally.Shadows.Samples, 3 * 1000);
    EXPECT_GT(tally.Shadows.Shadowed, 3 * 50);
    EXPECT_GT(tally.Shadows.Rays, 1000) << "of the last frame";
  }
}

// Hazard of the shadow pass: with multisampling a fragment asks whether it is in a spot's cone
// where its surface is at the pixel's centre. A sample that lies beside the cone is then shaded
// with its own mask, of a caster that shadows nothing in the cone. As the fuzzer found it.
TEST_F(FuzzRuns, ConesOfMultisampledPixels)
{
  const Scenario scenario = FromJson(Parse(R"(
    {"changes": [{"kind": "LightPosition",
       "values": [-2.7423202109150484, 3.5264679819438687, -0.057150995465871546]}],
     "frames": 1,
     "lights": [{"cone_angle": 10.0, "kind": "Spot"}],
     "props": [
       {"id": 13, "shape": {
         "center": [-1.471187804409133, 1.3291382835716572, -0.7811930567548471],
         "detail": 4, "kind": "Sphere",
         "size": [0.5222990174044354, 0.5222990174044354, 0.11326893076647807]}},
       {"shape": {"detail": 33, "kind": "Grating", "size": [11.0, 11.0, 0.0]}}],
     "renderers": [{"pass": "ShadowVolumesInSequence"}],
     "seed": 1732826749382466,
     "views": [{"position": [0.0, 0.0, 20.0]}],
     "window": {"height": 117, "multi_samples": 8, "width": 77}})"));
  EXPECT_EQ(Checker().Run(scenario, true).Failure, "");
}

// Hazard of the shadow pass: where depth puts a sample beside a spot's cone and VTK lights it for
// another place: in the middle of a line, of a point, or where the shader that sets its depth would
// have drawn it. As the fuzzer found them.
TEST_F(FuzzRuns, ConesOfWhatIsLitElsewhere)
{
  const char* scenes[] = {
    R"("lights": [{"cone_angle": 89.9, "kind": "Spot",
         "focal_point": [0.092105746377238451, 0.18398554342725637, -1.8264376958540549],
         "position": [0.67539424863268183, 1.8818752234269405, -2.267462042274988]}],
       "props": [
         {"id": 20, "representation": "Wireframe", "shape": {
           "center": [-3.3368618838341826, 2.9164354805330293, -3.5020703760441583],
           "size": [0.97486761503039332, 1.6949398988059685, 0.25346833725194828]}},
         {"id": 4, "shape": {
           "center": [-0.085684970656753734, 3.5118712274780934, -2.4265060953948971],
           "size": [1.8688380814872583, 3.0890479604345904, 1.9434898319174068]}}],
       "views": [{"position": [-2.6076783249487372, 4.0121413442878122, 8.6602540378443873],
         "view_angle": 60.0}],
       "window": {"height": 59, "width": 121}})",
    R"("lights": [{"kind": "Spot",
         "position": [-2.401587485967172, 0.49042558212741016, 1.7345690302361281]}],
       "props": [
         {"shape": {"size": [9.0, 7.0, 0.5]}},
         {"id": 18, "point_size": 3.854868219115871, "representation": "Points", "shape": {
           "center": [3.4845592174169688, 2.3953420140195059, -5.6197356667546696]}}],
       "views": [{"position": [0.0, 0.0, 12.071067811865476], "view_angle": 45.0}],
       "window": {"height": 1}})",
    R"("lights": [{"kind": "Spot",
         "position": [-9.0648407266925233, -5.6526117571578247, 5.2254226506148642]}],
       "props": [{"id": 53, "shader": "WritesDepth", "shape": {
         "center": [-5.9556323921675824, -5.2682061967872524, 1.0790134123606272],
         "size": [5.2450786456002385, 0.3028356001452992, 2.6711656411646896]}}],
       "views": [{"far": 10000000.0, "near": 1.0, "view_angle": 100.0,
         "focal_point": [-5.479387480109267, -5.1626728830212922, 0.44674443283884124],
         "position": [-5.2099081439167989, -6.1256790550499387, 0.2]}]})",
  };
  for (const std::string scene : scenes)
  {
    const Scenario scenario = FromJson(
      Parse("{\"frames\": 1, \"renderers\": [{\"pass\": \"ShadowVolumes\"}], " + scene + "}"));
    EXPECT_EQ(Checker().Run(scenario, true).Failure, "") << scene;
  }
}

// Large props that tie, drawn twice in a frame: by a pass of which that is not known, and by one of
// which it is.
TEST_F(FuzzRuns, LargePropsDrawnTwice)
{
  const char* scenes[] = {
    R"("culler": {"minimum_number_of_primitives": 2, "unit_size": 1},
       "props": [
         {"from": 1, "id": 19, "shape": {"center": [2.0, -1.0, -0.25], "size": [1.0, 1.0, 0.5]}},
         {"color": [0.26, 0.64, 0.49], "id": 34, "position": [2.0, -1.0, 0.0],
          "shape": {"size": [1.0, 1.0, 0.0]}}],
       "renderers": [{"pass": "OpaqueTwice"}],
       "views": [{}])",
    R"("culler": {"backend": 1, "minimum_number_of_primitives": 2, "unit_size": 5},
       "lights": [{}],
       "props": [
         {"id": 21, "lighting": false,
          "position": [2.3476532153820546, 2.4581524653482223, 0.3333333333333333],
          "shape": {"size": [3.3500924238037624, 3.3500924238037624, 0.0]}},
         {"id": 47, "shape": {"center": [3.9376663767061517, 0.4315671917532349, 0.3333333333333333],
          "size": [3.113391472906648, 3.113391472906648, 0.0]}}],
       "renderers": [{"pass": "ShadowVolumes"}],
       "views": [{}, {"frame": 2, "view_angle": 45.0}, {"frame": 3,
         "position": [17.72225197229073, 5.606002743863855, 11.649614229389915]}],
       "window": {"width": 49})",
  };
  for (const std::string scene : scenes)
  {
    const Scenario scenario = FromJson(Parse("{\"frames\": 4, " + scene + "}"));
    EXPECT_EQ(Checker().Run(scenario, true).Failure, "") << scene;
  }
}

// The passes in the keys of actors that share a mapper decide when VTK makes the shaders: actors of
// two renderers, and an actor that shares no more when the other one is hidden.
TEST_F(FuzzRuns, SharedMappers)
{
  const char* scenes[] = {
    R"("changes": [{"frame": 1, "kind": "Edges", "values": [1.0, 0.5, 0.5]}],
       "props": [{"lighting": false}, {"from": 1, "id": 13, "lighting": false, "mapper_of": 0}],
       "renderers": [{}, {"shares_props": true}])",
    R"("changes": [{"frame": 1, "kind": "Visible", "target": 1}],
       "props": [{"shape": {"detail": 48, "kind": "Scraps"}},
         {"id": 1, "mapper_of": 0, "representation": "Wireframe"}],
       "views": [{"position": [58.39031072528671, 19.319374522965372, 86.602540378443877]}])",
    R"("changes": [{"kind": "Visible", "target": 1, "values": [0.0]},
         {"frame": 1, "kind": "Visible", "target": 1, "values": [1.0]},
         {"frame": 2, "kind": "Visible", "target": 1, "values": [0.0]}],
       "props": [{"shape": {"detail": 48, "kind": "Scraps"}},
         {"id": 1, "kind": "Follower", "mapper_of": 0, "representation": "Wireframe"}],
       "views": [{"position": [58.39031072528671, 19.319374522965372, 86.602540378443877]}])",
    R"("changes": [{"frame": 1, "kind": "Representation", "values": [1.0]}],
       "props": [{"shape": {"detail": 53, "kind": "Grating", "size": [11.0, 11.0, 0.0]}},
         {"id": 2, "kind": "Assembly"}, {"id": 3, "mapper_of": 0, "part_of": 2}],
       "views": [{"position": [6.0, -0.4, -20.0]}])",
  };
  for (const std::string scene : scenes)
  {
    const Scenario scenario = FromJson(
      Parse(R"({"culler": {"minimum_number_of_primitives": 2}, "frames": 3, )" + scene + "}"));
    EXPECT_EQ(Checker().Run(scenario, true).Failure, "") << scene;
  }
}

// The only prop of a layer lies between the middles of pixels and is hidden while nothing moves.
// VTK does not process the image of a renderer without props.
TEST_F(FuzzRuns, LayerWithNothingToDraw)
{
  const Scenario scenario = FromJson(Parse(
    R"({"frames": 3, "props": [{"id": 13},
          {"id": 14, "shape": {"center": [-0.58, -2.71, -7.44]}},
          {"id": 16, "renderer": 1, "shape": {"center": [1.41, 2.75, -2.3]}}],
        "renderers": [{}, {"fxaa": true, "layer": 1, "shares_camera": true}],
        "views": [{"position": [0.0, 0.0, 20.0]}], "window": {"height": 5, "width": 3}})"));
  EXPECT_EQ(Checker().Run(scenario, true).Failure, "");
}

// The edges make the shader number the triangles, so that the prop is read again while nothing else
// changes. In the frame before that all of its units are drawn, also after another prop in the same
// plane.
TEST_F(FuzzRuns, EdgesOfALargeProp)
{
  const char* scenes[] = {
    R"("changes": [{"frame": 3, "kind": "Edges", "values": [1.0, 0.5, 0.5]}], "props": [{}])",
    R"("changes": [{"frame": 2, "target": 3, "values": [1.777, 0.597, 1.0]},
         {"frame": 3, "kind": "Edges", "target": 2, "values": [1.0, 0.5, 0.5]}],
       "props": [{"id": 2, "shape": {"detail": 57, "kind": "Scraps", "size": [7.484, 6.976, 0.0]}},
         {"shape": {"size": [7.299, 8.58, 0.0]}},
         {"id": 3, "shape": {"center": [-0.193, -1.09, 2.0], "size": [2.378, 4.011, 0.2]}}],
       "views": [{}])",
  };
  for (const std::string scene : scenes)
  {
    const Scenario scenario = FromJson(
      Parse(R"({"culler": {"minimum_number_of_primitives": 2, "unit_size": 1}, "frames": 6, )" +
        scene + "}"));
    EXPECT_EQ(Checker().Run(scenario, true).Failure, "") << scene;
  }
}

// The shader that pushes the box behind the wall away writes the depth at the middle of a pixel for
// samples of a steep face that does not cover the middle.
TEST_F(FuzzRuns, OffsetsOfMultisampledFaces)
{
  const Scenario scenario = FromJson(Parse(
    R"({"changes": [{"kind": "PolygonOffset", "values": [1.0]}], "frames": 1,
        "props": [
          {"id": 104, "offset_units": 4000.0, "shape": {
            "center": [-2.9563903808, -11.0864639282, -3.695487976],
            "size": [2.956390380859375, 2.956390380859375, 2.956390380859375]}},
          {"shape": {"size": [88.69171142578125, 44.345855712890625, 3.6954879760742188]}}],
        "views": [{"position": [0.0, 0.0, 147.819519043]}],
        "window": {"height": 117, "multi_samples": 4}})"));
  EXPECT_EQ(Checker().Run(scenario, true).Failure, "");
}

// VTK culls the first frame after stereo by the frustum of an eye.
TEST_F(FuzzRuns, ShadowsAfterStereo)
{
  const Scenario scenario = FromJson(Parse(
    R"({"changes": [{"frame": 2, "kind": "Stereo", "values": [-1]}], "frames": 3,
        "props": [{"id": 6}], "renderers": [{"pass": "ShadowVolumes"}],
        "window": {"height": 42, "stereo": 4, "width": 159}})"));
  EXPECT_EQ(Checker().Run(scenario, true).Failure, "");
}

// An actor begins to share the mapper of a large prop while the culler steps aside.
TEST_F(FuzzRuns, MapperSharedInAFrameWithoutCulling)
{
  for (const std::string change : { R"("kind": "Stereo")", R"("kind": "CullerEnabled")" })
  {
    const Scenario scenario =
      FromJson(Parse(R"({"changes": [{"frame": 1, )" + change + R"(}], "frames": 3,
        "culler": {"minimum_number_of_primitives": 6},
        "props": [{}, {"flat": true, "from": 1, "id": 7, "mapper_of": 0,
          "representation": "Wireframe"}],
        "views": [{"position": [22.235864, 9.213120, 4.304691]}]})"));
    EXPECT_EQ(Checker().Run(scenario, true).Failure, "") << change;
  }
}

// Nothing is in the view when the window is switched to stereo.
TEST_F(FuzzRuns, StereoOfAnEmptyView)
{
  const Scenario scenario = FromJson(Parse(
    R"({"changes": [
          {"frame": 1, "kind": "Orientation", "target": 22, "values": [0.0, 0.0, 86.736025858764194]},
          {"frame": 1, "kind": "Stereo", "values": [2.0]}],
        "frames": 2,
        "props": [{"id": 22, "shape": {
          "center": [0.10081721259975213, -3.3306577205381109, -1.7114388440836377]}}],
        "views": [{"focal_point": [6.0, 0.0, 0.0], "position": [6.0, 0.0, 15.3014083110324]}],
        "window": {"width": 49}})"));
  EXPECT_EQ(Checker().Run(scenario, true).Failure, "");
}

// After a cut all units of the sphere are outside, but its box is not.
TEST_F(FuzzRuns, LargePropWithoutUnitsInTheView)
{
  const Scenario scenario = FromJson(Parse(
    R"({"culler": {"minimum_number_of_primitives": 50}, "frames": 3,
        "props": [{"id": 2, "shape": {
          "center": [3.1999483716327113, -0.4901569729224695, -1.5010324093728724],
          "detail": 7, "kind": "Sphere",
          "size": [0.2181856718541766, 0.2181856718541766, 0.2810388498213275]}}],
        "views": [
          {"position": [0.0, 0.0, 12.071067811865476], "view_angle": 45.0},
          {"frame": 2, "position": [6.776425215174617, -4.574649073400581, 12.071067811865476],
            "view_angle": 45.0}],
        "window": {"height": 94, "width": 54}})"));
  EXPECT_EQ(Checker().Run(scenario, true).Failure, "");
}
