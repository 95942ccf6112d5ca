// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes that are none.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTextActor.h"

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

using Scenes::Wall;

//------------------------------------------------------------------------------------------------
namespace
{
/// Draws nothing and has no bounds.
class PropWithoutBounds : public vtkProp
{
public:
  static PropWithoutBounds* New();
  vtkTypeMacro(PropWithoutBounds, vtkProp);
  double* GetBounds() override { return nullptr; }
};
vtkStandardNewMacro(PropWithoutBounds);

struct OddBounds : NamedCase
{
  /// Adds one prop.
  std::function<void(Stage&)> Add;
};
class CullerOddBounds : public testing::TestWithParam<OddBounds>
{
};

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A box behind the wall whose points are changed.
std::function<void(Stage&)> Points(const std::function<void(vtkPoints*)>& change)
{
  return [change](Stage& stage)
  {
    vtkSmartPointer<vtkPolyData> data = Scenes::MakeBox({ 0.0, 0.0, -4.0 }, { 0.5, 0.5, 0.5 });
    change(data->GetPoints());
    data->GetPoints()->Modified();
    const double red[3] = { 1.0, 0.0, 0.0 };
    stage.AddActor(data, red);
  };
}

/// A box behind the wall whose actor is changed.
std::function<void(Stage&)> Actor(const std::function<void(vtkActor*)>& change)
{
  return [change](Stage& stage)
  { change(stage.GetActor(Scenes::AddBox(stage, 0.0, 0.0, -4.0, 0.5, 0.5, 0.5))); };
}

std::function<void(vtkActor*)> MatrixElement(int row, int column, double value)
{
  return [row, column, value](vtkActor* actor)
  {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->SetElement(row, column, value);
    actor->SetUserMatrix(matrix);
  };
}
}

// Hazard: comparisons with NaN are false, infinite and uninitialised bounds are in no order, and a
// prop may have none at all: nothing that they say may cull anything, and the others stay hidden.
TEST_P(CullerOddBounds, AmongTheOthers)
{
  ComparisonOptions options = Scenes::MakeExactOptions(301, 173, 4);
  Comparison comparison(
    [this](Stage& stage)
    {
      Scenes::BuildWall(stage);
      this->GetParam().Add(stage);
      Scenes::AddBox(stage, 0.0, 0.5, -5.0, 0.5, 0.5, 0.5);
      this->GetParam().Add(stage);
      Scenes::SetWallCamera(stage.GetRenderer());
      stage.GetRenderer()->GetActiveCamera()->SetClippingRange(1.0, 60.0);
    },
    options);
  for (int i = 0; i < 5; ++i)
  {
    comparison.Both([i](Stage& stage)
      { stage.GetRenderer()->GetActiveCamera()->SetPosition(0.1 * i, 0.0, 20.0); });
    comparison.Frame();
  }
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  for (int prop : { Wall::Count, Wall::Count + 2 })
  {
    EXPECT_NE(comparison.GetVerdict(prop), Verdict::Hidden);
    EXPECT_NE(comparison.GetVerdict(prop), Verdict::Outside);
    EXPECT_NE(comparison.GetVerdict(prop), Verdict::Unknown);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, CullerOddBounds,
  testing::Values(
    OddBounds{ "Null", [](Stage& stage) { stage.Add(vtkSmartPointer<PropWithoutBounds>::New()); } },
    OddBounds{ "NullOf2D",
      [](Stage& stage)
      {
        vtkNew<vtkTextActor> text;
        text->SetInput("2D");
        stage.Add(text);
      } },
    OddBounds{ "UninitialisedWithoutPoints",
      [](Stage& stage)
      {
        const double red[3] = { 1.0, 0.0, 0.0 };
        stage.AddActor(vtkSmartPointer<vtkPolyData>::New(), red);
      } },
    OddBounds{ "UninitialisedWithoutMapper",
      [](Stage& stage) { stage.Add(vtkSmartPointer<vtkActor>::New()); } },
    OddBounds{ "InfinitePoint", Points([](vtkPoints* p) { p->SetPoint(0, Infinity, 0.0, -4.0); }) },
    OddBounds{ "InfinitePoints",
      Points(
        [](vtkPoints* p)
        {
          for (vtkIdType i = 0; i < p->GetNumberOfPoints(); ++i)
          {
            p->SetPoint(i, 0.0, i % 2 ? Infinity : -Infinity, -4.0);
          }
        }) },
    OddBounds{ "OnlyNaNPoints",
      Points(
        [](vtkPoints* p)
        {
          for (vtkIdType i = 0; i < p->GetNumberOfPoints(); ++i)
          {
            p->SetPoint(i, NaN, NaN, NaN);
          }
        }) },
    OddBounds{ "LargestFloat",
      Points([](vtkPoints* p) { p->SetPoint(0, std::numeric_limits<float>::max(), 0.0, -4.0); }) },
    OddBounds{ "NaNMatrix", Actor(MatrixElement(0, 0, NaN)) },
    OddBounds{ "NaNTranslation", Actor(MatrixElement(1, 3, NaN)) },
    OddBounds{ "InfiniteTranslation", Actor(MatrixElement(2, 3, -Infinity)) },
    OddBounds{ "InfiniteScale", Actor(MatrixElement(0, 0, Infinity)) },
    OddBounds{ "HugeScale", Actor(MatrixElement(0, 0, 1e300)) }),
  GetCaseName);
