// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LargeProps.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace LargeProps
{
ComparisonOptions MakeOptions(int unitSize)
{
  ComparisonOptions options;
  options.Tuning.MinimumNumberOfCandidates = 1;
  options.Tuning.MinimumNumberOfPrimitives = 100;
  options.Tuning.UnitSize = unitSize;
  options.Tuning.DivideAfter = 0;
  options.Tuning.DivideInBackground = false;
  return options;
}

void AddWalls(Stage& stage)
{
  Scenes::AddBox(stage, 6.0, 2.0, 1.0, 0.3, 12.0, 6.0);
  Scenes::AddBox(stage, -8.0, 12.0, 1.0, 10.0, 0.3, 6.0);
}

void Walk(vtkRenderer* renderer, int frame, double start, double above)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double t = 0.3 * frame;
  camera->SetPosition(
    frame < 8 ? start + 3.0 * frame : above, frame < 8 ? 2.0 : -50.0, frame < 8 ? 1.7 : 30.0);
  camera->SetFocalPoint(20.0 * std::cos(t), 20.0 * std::sin(t), 1.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetClippingRange(0.05, 200.0);
}

Units CompareWalk(Comparison& comparison, const std::function<void(vtkRenderer*, int)>& walk)
{
  Units units;
  for (int i = 0; i < 14; ++i)
  {
    comparison.Frame([&walk, i](Stage& stage) { walk(stage.GetRenderer(), i); });
    units.Hidden += comparison.GetStatistics().UnitsHidden;
    units.Fresh += i > 2 ? comparison.GetStatistics().UnitsFresh : 0;
    EXPECT_TRUE(i < 2 || comparison.GetStatistics().Units > 0)
      << i << comparison.GetCuller()->GetStatisticsAsJSON();
  }
  return units;
}

void ExpectSamePicks(Comparison& comparison)
{
  using Pick = std::pair<int, vtkIdType>; // A block, 0 without composite data, and a cell.
  std::vector<std::vector<Pick>> picked;
  comparison.Both(
    [&picked](Stage& stage)
    {
      vtkNew<vtkHardwareSelector> selector;
      selector->SetRenderer(stage.GetRenderer());
      selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
      selector->SetArea(0, 0, 300, 172);
      const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
      picked.emplace_back();
      for (unsigned int n = 0; n < selection->GetNumberOfNodes(); ++n)
      {
        vtkSelectionNode* node = selection->GetNode(n);
        auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
        const int block = node->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX());
        for (vtkIdType k = 0; ids && k < ids->GetNumberOfTuples(); ++k)
        {
          picked.back().emplace_back(block, ids->GetValue(k));
        }
      }
      std::sort(picked.back().begin(), picked.back().end());
    });
  ASSERT_EQ(picked.size(), 2U);
  EXPECT_GT(picked[0].size(), 0U);
  EXPECT_EQ(picked[0], picked[1]);
}
}
