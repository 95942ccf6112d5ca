// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Selecting and picking: an application finds the same props with and without the culler, even
// those that are hidden.
#include "CompositeMapper.h"
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkAreaPicker.h"
#include "vtkCellPicker.h"
#include "vtkDataObject.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointPicker.h"
#include "vtkPolyData.h"
#include "vtkProp3DCollection.h"
#include "vtkPropPicker.h"
#include "vtkProperty.h"
#include "vtkRenderedAreaPicker.h"
#include "vtkSphereSource.h"
#include "vtkWorldPointPicker.h"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

using Scenes::Wall;

namespace
{
using Area = std::array<int, 4>;
constexpr Area WholeWindow = { 0, 0, 300, 172 };

/// Both stages select the same; returns how many props.
int ExpectSameSelection(Comparison& comparison, const Area& area = WholeWindow,
  int field = vtkDataObject::FIELD_ASSOCIATION_CELLS)
{
  const TestScene::Selection expected = TestScene::Select(comparison.Reference, area.data(), field);
  const TestScene::Selection found = TestScene::Select(comparison.Culled, area.data(), field);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.count(-1), 0u) << "a prop that is none of the scene's";
  EXPECT_EQ(comparison.GetDecision(), Decision::Selecting);
  EXPECT_TRUE(DidNoWork(comparison.GetStatistics()));
  EXPECT_EQ(comparison.GetHidden(), 0);
  return static_cast<int>(found.size());
}

std::array<double, 3> GetPosition(vtkAbstractPicker* picker)
{
  std::array<double, 3> position;
  picker->GetPickPosition(position.data());
  return position;
}

/// What is picked in the culled stage at places all over the window; in the reference it is the
/// same.
template <typename Pick>
auto PickEverywhere(Comparison& comparison, int step, Pick pick)
{
  std::vector<decltype(pick(comparison.Culled, 0, 0))> all;
  for (int x = 5; x < 301; x += 4 * step)
  {
    for (int y = 5; y < 173; y += 3 * step)
    {
      all.push_back(pick(comparison.Culled, x, y));
      EXPECT_EQ(pick(comparison.Reference, x, y), all.back()) << x << " " << y;
    }
  }
  return all;
}

/// The props, by index and in order, that the frustum of an area meets, seen or not.
template <typename PickerType>
std::vector<int> PickArea(Stage& stage, const Area& area)
{
  vtkNew<PickerType> picker;
  picker->AreaPick(area[0], area[1], area[2], area[3], stage.GetRenderer());
  std::vector<int> found;
  vtkProp3DCollection* props = picker->GetProp3Ds();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    found.push_back(stage.FindIndex(props->GetItemAsObject(i)));
  }
  std::sort(found.begin(), found.end());
  return found;
}
}

// Hazard: a hardware selector numbers the props in each pass; a proxy in the list, or a missing
// prop, would shift all numbers.
TEST(CullerPicking, HardwareSelectionFindsTheSame)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      stage.GetActor(Wall::FirstInFront)->PickableOff();
    });
  comparison.Frame();
  for (int round = 0; round < 3; ++round)
  {
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    EXPECT_GT(ExpectSameSelection(comparison), 5);
    Scenes::FrameOfWall(comparison, 0.2 * round, "after selecting");
  }
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  // The wall not pickable: what it hides can be selected through it.
  comparison.Frame(
    "wall not pickable", [](Stage& stage) { stage.GetActor(Wall::Index)->PickableOff(); });
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  EXPECT_GT(ExpectSameSelection(comparison), Wall::Behind / 2);
  comparison.Frame("after selecting through the wall");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: a selection of a part of the window, or of points, uses other passes. Those directly
// after a culled frame must not use its list.
TEST(CullerPicking, HardwareSelectionOfPartsOfTheWindow)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      stage.GetActor(Wall::Index)->PickableOff();
    });
  const Area areas[] = { { 150, 86, 150, 86 }, { 100, 50, 200, 120 }, { 0, 0, 80, 172 } };
  int found = 0;
  for (int field :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    for (const Area& area : areas)
    {
      Scenes::FrameOfWall(comparison, 0.1 * found, "before selecting");
      EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
      EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
      found += ExpectSameSelection(comparison, area, field);
    }
  }
  EXPECT_GT(found, Wall::Behind);
}

// Hazard: a selector of points draws the buffers that composite data draws by, and what it makes
// for points stays. VTK has them made before by an ordinary frame.
TEST(CullerPicking, PointSelectionOfHiddenBlocks)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      vtkNew<vtkMultiBlockDataSet> blocks;
      vtkNew<vtkSphereSource> source;
      source->LatLongTessellationOn(); // Quads have other indices as triangles than as points.
      for (unsigned int i = 0; i < 2; ++i)
      {
        source->SetCenter(i, 0.0, 0.0);
        source->Update();
        vtkNew<vtkPolyData> sphere;
        sphere->DeepCopy(source->GetOutput());
        blocks->SetBlock(i, sphere);
      }
      vtkNew<CompositeMapper> mapper;
      mapper->SetInputDataObject(blocks);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->SetPosition(-0.5, 0.3, -3.0);
      actor->SetScale(2.0);
      stage.Add(actor);
    });
  const int hidden = Wall::Count;
  for (const char* when : { "never drawn", "drawn before it changed" })
  {
    Scenes::FramesOfWall(comparison, { 0.0, 0.1, 0.2 });
    EXPECT_EQ(comparison.GetVerdict(hidden), Verdict::Hidden) << when;
    EXPECT_GT(
      ExpectSameSelection(comparison, WholeWindow, vtkDataObject::FIELD_ASSOCIATION_POINTS), 5);
    comparison.Frame(when);
    EXPECT_EQ(comparison.GetVerdict(hidden), Verdict::Hidden) << when;
    const auto moveWall = [&comparison](double z) {
      comparison.Both([z](Stage& stage) { stage.GetActor(Wall::Index)->AddPosition(0.0, 0.0, z); });
    };
    moveWall(100.0);
    comparison.Frame(std::string(when) + ", uncovered");
    EXPECT_EQ(comparison.GetVerdict(hidden), Verdict::Visible) << when;
    moveWall(-100.0);
    Scenes::FramesOfWall(comparison, { 0.0, 0.1 });
    comparison.Both(
      [hidden](Stage& stage) { stage.GetActor(hidden)->GetProperty()->SetColor(0.1, 0.9, 0.2); });
  }
}

// Hazard: frozen verdicts are those of another camera; a selection needs all props in view of the
// present one.
TEST(CullerPicking, HardwareSelectionWhileFrozen)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame();
  comparison.GetCuller()->FreezeOn();
  Scenes::MoveWallCamera(comparison, 9.0);
  comparison.Culled.Window->Render();
  EXPECT_EQ(comparison.GetDecision(), Decision::Frozen);
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  EXPECT_GT(ExpectSameSelection(comparison), 5);
  EXPECT_GT(ExpectSameSelection(comparison, { 100, 50, 200, 120 }), 1);
  comparison.GetCuller()->FreezeOff();
  comparison.Frame("thawed");
}

// Hazard: picking a prop by rendering uses a hardware selection.
TEST(CullerPicking, PropPickerPicksTheSame)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame();
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  PickEverywhere(comparison, 10,
    [](Stage& stage, int x, int y)
    {
      vtkNew<vtkPropPicker> picker;
      picker->PickProp(x, y, stage.GetRenderer());
      return stage.FindIndex(picker->GetViewProp());
    });
  comparison.Frame("after picking");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: a picker that reads the depth of the last frame must find the depth that VTK would have
// drawn.
TEST(CullerPicking, WorldPointPickerPicksTheSame)
{
  Comparison comparison(Scenes::BuildWall);
  for (int round = 0; round < 3; ++round)
  {
    Scenes::FrameOfWall(comparison, 0.3 * round);
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    PickEverywhere(comparison, 10,
      [](Stage& stage, int x, int y)
      {
        vtkNew<vtkWorldPointPicker> picker;
        picker->Pick(x, y, 0.0, stage.GetRenderer());
        return GetPosition(picker);
      });
  }
}

// Hazard: a picker that casts rays must find props of the renderer that were not drawn, too.
TEST(CullerPicking, CellAndPointPickersPickTheSame)
{
  Comparison comparison(Scenes::BuildWall);
  int behind = 0;
  for (bool wallPickable : { true, false })
  {
    comparison.Both(
      [wallPickable](Stage& stage) { stage.GetActor(Wall::Index)->SetPickable(wallPickable); });
    Scenes::FrameOfWall(comparison, 0.2);
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    const auto pick = [](Stage& stage, int x, int y)
    {
      vtkNew<vtkCellPicker> cells;
      cells->Pick(x, y, 0.0, stage.GetRenderer());
      vtkNew<vtkPointPicker> vertices;
      vertices->Pick(x, y, 0.0, stage.GetRenderer());
      return std::tuple(stage.FindIndex(cells->GetViewProp()), cells->GetCellId(),
        GetPosition(cells), stage.FindIndex(vertices->GetViewProp()), vertices->GetPointId(),
        GetPosition(vertices));
    };
    for (const auto& found : PickEverywhere(comparison, 5, pick))
    {
      const int picked = std::get<0>(found);
      behind += picked >= Wall::FirstBehind && picked < Wall::FirstInFront &&
        comparison.GetVerdict(picked) == Verdict::Hidden;
    }
  }
  EXPECT_GT(behind, 5) << "hidden props picked through the wall";
}

// Hazard: selecting through finds every prop in a frustum, hidden or not.
TEST(CullerPicking, AreaPickersFindWhatIsHidden)
{
  Comparison comparison(Scenes::BuildWall);
  const Area areas[] = { WholeWindow, { 100, 50, 200, 120 }, { 130, 70, 170, 100 } };
  for (bool frozen : { false, true })
  {
    for (const Area& area : areas)
    {
      Scenes::FrameOfWall(comparison, 0.2);
      EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
      comparison.GetCuller()->SetFreeze(frozen);
      comparison.Culled.Window->Render();
      EXPECT_EQ(comparison.GetDecision() == Decision::Frozen, frozen);
      const std::vector<int> through = PickArea<vtkAreaPicker>(comparison.Culled, area);
      EXPECT_EQ(PickArea<vtkAreaPicker>(comparison.Reference, area), through);
      const auto hidden = std::count_if(through.begin(), through.end(),
        [&](int prop) { return comparison.GetVerdict(prop) == Verdict::Hidden; });
      EXPECT_GT(hidden, area == WholeWindow ? Wall::Hidden - 1 : 0);
      EXPECT_EQ(PickArea<vtkRenderedAreaPicker>(comparison.Reference, area),
        PickArea<vtkRenderedAreaPicker>(comparison.Culled, area));
      comparison.GetCuller()->FreezeOff();
    }
  }
}
