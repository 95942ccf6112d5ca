// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Selecting and picking: what an application finds under the cursor is what it finds without the
// culler, also where nothing is seen of it.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkAreaPicker.h"
#include "vtkCellPicker.h"
#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkPointPicker.h"
#include "vtkProp3DCollection.h"
#include "vtkPropPicker.h"
#include "vtkRenderedAreaPicker.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkWorldPointPicker.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

using Scenes::Wall;

namespace
{
/// Index of a prop in the stage, or -1.
int FindIndex(const Stage& stage, const vtkObjectBase* prop)
{
  const auto at = std::find(stage.Props.begin(), stage.Props.end(), prop);
  return at == stage.Props.end() ? -1 : static_cast<int>(at - stage.Props.begin());
}

using Area = std::array<int, 4>;
constexpr Area WholeWindow = { 0, 0, 300, 172 };

/// What a selector finds of one prop: pixels and the numbers of the cells or points.
struct Found
{
  int Pixels = 0;
  std::vector<vtkIdType> Elements;
  bool operator==(const Found& other) const
  {
    return this->Pixels == other.Pixels && this->Elements == other.Elements;
  }
};

void PrintTo(const Found& found, std::ostream* os)
{
  *os << found.Pixels << " pixels, " << found.Elements.size() << " elements";
}

/// The props, by index, that a selector finds in an area.
std::map<int, Found> Select(
  Stage& stage, const Area& area = WholeWindow, int field = vtkDataObject::FIELD_ASSOCIATION_CELLS)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.GetRenderer());
  selector->SetFieldAssociation(field);
  selector->SetArea(area[0], area[1], area[2], area[3]);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  std::map<int, Found> result;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    Found& found = result[FindIndex(stage, node->GetProperties()->Get(vtkSelectionNode::PROP()))];
    found.Pixels += node->GetProperties()->Get(vtkSelectionNode::PIXEL_COUNT());
    vtkDataArray* elements = vtkDataArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType k = 0; elements && k < elements->GetNumberOfTuples(); ++k)
    {
      found.Elements.push_back(static_cast<vtkIdType>(elements->GetTuple1(k)));
    }
  }
  return result;
}

/// Both stages select the same; returns how many props.
int ExpectSameSelection(Comparison& comparison, const Area& area = WholeWindow,
  int field = vtkDataObject::FIELD_ASSOCIATION_CELLS)
{
  const std::map<int, Found> expected = Select(comparison.Reference, area, field);
  const std::map<int, Found> found = Select(comparison.Culled, area, field);
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
    found.push_back(FindIndex(stage, props->GetItemAsObject(i)));
  }
  std::sort(found.begin(), found.end());
  return found;
}
}

// Hazard: a hardware selector numbers the props of each pass; a proxy or a gap confuses all.
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
  comparison.Both([](Stage& stage) { stage.GetActor(Wall::Index)->PickableOff(); });
  comparison.Frame("wall not pickable");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  EXPECT_GT(ExpectSameSelection(comparison), Wall::Behind / 2);
  comparison.Frame("after selecting through the wall");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: a selection of a part of the window, or of points, takes other passes; those right after
// a culled frame must not see its list.
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

// Hazard: frozen verdicts are those of another camera; a selection wants all props of this one.
TEST(CullerPicking, HardwareSelectionWhileFrozen)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
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

// Hazard: picking a prop by rendering goes the way of selection.
TEST(CullerPicking, PropPickerPicksTheSame)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  comparison.Frame();
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  for (int x = 5; x < 301; x += 40)
  {
    for (int y = 5; y < 173; y += 30)
    {
      const auto pick = [x, y](Stage& stage)
      {
        vtkNew<vtkPropPicker> picker;
        picker->PickProp(x, y, stage.GetRenderer());
        return FindIndex(stage, picker->GetViewProp());
      };
      EXPECT_EQ(pick(comparison.Reference), pick(comparison.Culled)) << x << " " << y;
    }
  }
  comparison.Frame("after picking");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: a picker that reads the depth of the last frame finds what was drawn in it.
TEST(CullerPicking, WorldPointPickerPicksTheSame)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  for (int round = 0; round < 3; ++round)
  {
    Scenes::FrameOfWall(comparison, 0.3 * round);
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    for (int x = 5; x < 301; x += 40)
    {
      for (int y = 5; y < 173; y += 30)
      {
        const auto pick = [x, y](Stage& stage)
        {
          vtkNew<vtkWorldPointPicker> picker;
          picker->Pick(x, y, 0.0, stage.GetRenderer());
          return GetPosition(picker);
        };
        EXPECT_EQ(pick(comparison.Reference), pick(comparison.Culled)) << x << " " << y;
      }
    }
  }
}

// Hazard: a picker that casts rays asks all props of the renderer, also those that were not drawn.
TEST(CullerPicking, CellAndPointPickersPickTheSame)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  int behind = 0;
  for (bool wallPickable : { true, false })
  {
    comparison.Both(
      [wallPickable](Stage& stage) { stage.GetActor(Wall::Index)->SetPickable(wallPickable); });
    Scenes::FrameOfWall(comparison, 0.2);
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    for (int x = 5; x < 301; x += 20)
    {
      for (int y = 5; y < 173; y += 15)
      {
        const auto pick = [x, y](Stage& stage)
        {
          vtkNew<vtkCellPicker> cells;
          cells->Pick(x, y, 0.0, stage.GetRenderer());
          vtkNew<vtkPointPicker> vertices;
          vertices->Pick(x, y, 0.0, stage.GetRenderer());
          return std::tuple(FindIndex(stage, cells->GetViewProp()), cells->GetCellId(),
            GetPosition(cells), FindIndex(stage, vertices->GetViewProp()), vertices->GetPointId(),
            GetPosition(vertices));
        };
        const auto found = pick(comparison.Culled);
        EXPECT_EQ(pick(comparison.Reference), found) << x << " " << y;
        const int picked = std::get<0>(found);
        behind += picked >= Wall::FirstBehind && picked < Wall::FirstInFront &&
          comparison.GetVerdict(picked) == Verdict::Hidden;
      }
    }
  }
  EXPECT_GT(behind, 5) << "hidden props picked through the wall";
}

// Hazard: selecting through takes every prop in a frustum, hidden or not.
TEST(CullerPicking, AreaPickersFindWhatIsHidden)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
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
