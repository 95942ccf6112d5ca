// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Very many small props, and occluders that are mostly gaps.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using Verdict = vtkNBufferVerdict;
using Decision = vtkNBufferDecision;
using Scenes::AddQuad;

namespace
{
/// Actors that share one mapper and one property, some of them behind a wall of 5 by 3.
void BuildSpecks(Stage& stage, int count)
{
  Scenes::AddBox(stage, 0.0, 0.0, 0.0, 5.0, 3.0, 0.2);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(Scenes::MakeBox({ 0.0, 0.0, 0.0 }, { 0.02, 0.02, 0.02 }));
  vtkNew<vtkProperty> property;
  property->SetColor(1.0, 0.8, 0.2);
  std::mt19937 random(5);
  const auto uniform = [&random](double a, double b)
  { return a + (b - a) * static_cast<double>(random() % 100000) / 100000.0; };
  for (int i = 0; i < count; ++i)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetProperty(property);
    // Made at the first draw it would modify the actor, and have the shared buffers made anew.
    actor->GetShaderProperty();
    // Nine of ten behind the wall, some before it, the others beside it.
    if (i % 10)
    {
      actor->SetPosition(uniform(-2.0, 2.0), uniform(-1.0, 1.0), uniform(-2.0, -0.5));
    }
    else
    {
      actor->SetPosition(
        uniform(-6.0, 6.0), uniform(-4.0, 4.0), i % 2000 ? uniform(-3.0, -0.5) : 0.5);
    }
    // AddViewProp() would look for it in the whole list first.
    stage.GetRenderer()->GetViewProps()->AddItem(actor);
    actor->AddConsumer(stage.GetRenderer());
  }
}

void LookAtSpecks(Comparison& comparison, double shift)
{
  comparison.Both(
    [shift](Stage& stage)
    {
      vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
      camera->SetPosition(shift, 0.0, 16.0);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetClippingRange(5.0, 30.0);
    });
}

/// How many pixels of the window have exactly this colour.
int CountPixels(Stage& stage, const std::array<int, 3>& color)
{
  const int* size = stage.Window->GetActualSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  stage.Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  int count = 0;
  for (vtkIdType i = 0; i + 3 < pixels->GetNumberOfValues(); i += 4)
  {
    const unsigned char* p = pixels->GetPointer(i);
    count += p[0] == color[0] && p[1] == color[1] && p[2] == color[2];
  }
  return count;
}
}

// Hazard: a hundred thousand specks smaller than a pixel: none in view may vanish, and indices,
// counts and the list of props must hold that many.
TEST(CullerHazards, OneHundredThousandSpecks)
{
  constexpr int Count = 100000;
  ComparisonOptions options;
  options.KeepDefaultCuller = false;
  options.CompareDraws = false; // a shared mapper does not tell for whom it draws
  options.RoundSize = 0;        // the culler's own
  Comparison comparison([](Stage& stage) { BuildSpecks(stage, Count); }, options);
  for (int i = 0; i < 2; ++i)
  {
    LookAtSpecks(comparison, 0.1 * i);
    comparison.Frame();
    EXPECT_EQ(comparison.GetStatistics().Props, Count + 1);
    EXPECT_GE(comparison.GetHidden(), Count * 8 / 10);
  }
}

//------------------------------------------------------------------------------------------------
namespace
{
constexpr int FenceWidth = 301;
constexpr int FenceHeight = 201;
const double Red[3] = { 1.0, 0.0, 0.0 };

/// A wire: a strip at 45 degrees, `rising` or falling, its lower edge through (x, 0).
void AddWire(Stage& stage, double x, double wide, double z, bool rising)
{
  const double dx = rising ? FenceHeight : -FenceHeight;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(x, 0.0, z);
  points->InsertNextPoint(x + wide, 0.0, z);
  points->InsertNextPoint(x + wide + dx, FenceHeight, z);
  points->InsertNextPoint(x + dx, FenceHeight, z);
  vtkNew<vtkCellArray> quad;
  quad->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(quad);
  const double grey[3] = { 0.5, 0.5, 0.5 };
  stage.AddActor(data, grey)->GetProperty()->LightingOff();
}
}

// Hazard: a chain-link fence whose gaps are a pixel wide: a depth reduced by anything but the
// farthest, or drawn at a lower resolution, closes them and hides what shows through.
TEST(CullerHazards, ChainLinkFence)
{
  constexpr double Pitch = 5.0; // of the wires, in pixels along x
  constexpr double Wide = 3.6;  // of a wire there: the gaps are a pixel from edge to edge
  constexpr int Columns = 18;
  constexpr int Rows = 8;
  for (int factor : { 1, 4, 8 })
  {
    SCOPED_TRACE(factor);
    int firstBehind = 0;
    Comparison comparison(
      [&firstBehind](Stage& stage)
      {
        // A post of the fence, solid, and wires both ways.
        AddQuad(stage, 120.0, 0.0, 180.0, FenceHeight, 50.5);
        for (double x = -FenceHeight; x < FenceWidth + FenceHeight; x += Pitch)
        {
          AddWire(stage, x, Wide, 50.0, true);
          AddWire(stage, x, Wide, 49.5, false);
        }
        firstBehind = static_cast<int>(stage.Props.size());
        for (int i = 0; i < Columns * Rows; ++i)
        {
          const int prop = Scenes::AddBox(
            stage, 16.0 * (i % Columns) + 14.5, 24.0 * (i / Columns) + 15.0, 10.0, 9.0, 9.0, 9.0);
          stage.GetActor(prop)->GetProperty()->LightingOff();
          stage.GetActor(prop)->GetProperty()->SetColor(Red[0], Red[1], Red[2]);
        }
        Scenes::SetPixelCamera(stage.GetRenderer(), FenceWidth, FenceHeight);
      },
      Scenes::MakeExactOptions(FenceWidth, FenceHeight, factor));
    Scenes::Settle(comparison);
    for (double shift : { 0.0, 0.3, 0.5 })
    {
      comparison.Both([shift](Stage& stage)
        { Scenes::SetPixelCamera(stage.GetRenderer(), FenceWidth, FenceHeight, shift, shift); });
      comparison.Frame("shifted by " + std::to_string(shift));
      EXPECT_GT(CountPixels(comparison.Reference, { 255, 0, 0 }), 100) << "gaps to see through";
      for (int i = 0; i < Columns * Rows; ++i)
      {
        const double left = 16.0 * (i % Columns) + 10.0;
        const Verdict verdict = comparison.GetVerdict(firstBehind + i);
        // A box of nine pixels is larger than a mesh of the fence.
        const bool behindPost = left > 129.0 && left + 9.0 < 171.0;
        EXPECT_TRUE(!behindPost || verdict == Verdict::Hidden) << i;
        EXPECT_TRUE((left + 9.0 > 119.0 && left < 181.0) || verdict == Verdict::Visible) << i;
      }
    }
    // At an angle, where the gaps narrow towards the far end and close.
    for (int i = 0; i < 3; ++i)
    {
      comparison.Both(
        [i](Stage& stage)
        {
          vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
          camera->ParallelProjectionOff();
          camera->SetPosition(-150.0 - 10.0 * i, 100.0, 350.0);
          camera->SetFocalPoint(150.0, 100.0 + i, 30.0);
          camera->SetViewAngle(40.0);
          camera->SetClippingRange(10.0, 1500.0);
        });
      comparison.Frame("at an angle");
      EXPECT_GT(comparison.GetHidden(), 0);
    }
  }
}

// Hazard: in a row of parts that touch, drawing one of them late has all others drawn again.
TEST(CullerHazards, PartsThatTouchAreDrawnAgainWhereTheyTouch)
{
  constexpr int Parts = 50;
  constexpr int Door = Parts;
  Comparison comparison(
    [](Stage& stage)
    {
      // From the far end to the near one, and a door before the first.
      for (int i = 0; i < Parts; ++i)
      {
        Scenes::AddBox(stage, 0.2 * i - 5.0, 0.0, 0.0, 0.2, 0.6, 0.2);
      }
      Scenes::AddBox(stage, -5.0, 0.0, 1.0, 0.3, 1.2, 0.05);
      stage.GetRenderer()->GetActiveCamera()->SetPosition(-5.0, 0.0, 25.0);
      stage.GetRenderer()->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
      stage.GetRenderer()->ResetCameraClippingRange();
    });
  for (int i = 0; i < 3; ++i)
  {
    comparison.Frame("door shut");
  }
  EXPECT_EQ(comparison.GetHidden(), 1);
  comparison.Both([](Stage& stage) { stage.GetActor(Door)->SetPosition(0.0, 2.0, 0.0); });
  comparison.Frame("door open");
  const vtkNBufferStatistics& statistics = comparison.GetStatistics();
  EXPECT_EQ(statistics.GetCount(Verdict::Hidden), 0);
  EXPECT_EQ(statistics.DrawnInRound[1], 1);
  // The second part, where it touches the first; not the 48 that follow.
  EXPECT_EQ(statistics.Redrawn, 1);
}
