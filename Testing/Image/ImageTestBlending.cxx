// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Props that are blended: they hide nothing, and the image depends on the order of drawing.
#include "CompositeMapper.h"
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <functional>

using Scenes::Wall;

// Hazard: a translucent wall, which writes depth in some passes, hides what is seen through it.
TEST(CullerProps, TranslucentPropsNeverHide)
{
  for (int mode = 0; mode < 3; ++mode)
  {
    SCOPED_TRACE(mode);
    Comparison comparison(
      [mode](Stage& stage)
      {
        Scenes::BuildWall(stage);
        stage.GetActor(Wall::Index)->GetProperty()->SetOpacity(0.6);
        SetUseOIT(stage.GetRenderer(), mode == 0);
        stage.GetRenderer()->SetUseDepthPeeling(mode == 2);
      });
    for (int i = 0; i < 4; ++i)
    {
      Scenes::FrameOfWall(comparison, 0.1 * i);
      // Boxes behind the wall hide each other, here and there.
      EXPECT_LT(comparison.GetHidden(), Wall::Behind / 4);
      EXPECT_EQ(comparison.GetVerdict(Wall::Index), Verdict::Translucent);
    }
  }
}

// Hazard: translucent props must blend in the order of the renderer's list.
TEST(CullerProps, TranslucentPropsBetweenHeldBackOnesKeepTheirOrder)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      SetUseOIT(stage.GetRenderer(), false);
      for (int i = 0; i < 20; ++i)
      {
        Scenes::AddBox(stage, 0.2 * i - 2.0, 0.1 * i - 1.0, -2.0 - 0.1 * i, 0.4, 0.4, 0.4);
        const int glass = Scenes::AddBox(
          stage, 0.3 * i - 3.0, 0.1 * i - 1.0, 2.0 + 0.1 * (i * 7 % 20), 1.5, 1.5, 0.1);
        stage.GetActor(glass)->GetProperty()->SetOpacity(0.5);
      }
    });
  Scenes::ExpectFramesOfWall(comparison, { 0.0, 3.0, 6.0, 9.0 }, 21);
}

namespace
{
/// A table that VTK takes for opaque, although the color of all values but 1 is not.
vtkSmartPointer<vtkScalarsToColors> MakeTableWithFaintNaN()
{
  auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  function->AddRGBPoint(1.0, 1.0, 0.0, 0.0);
  function->SetAnnotation(vtkVariant(1.0), "one");
  function->IndexedLookupOn();
  function->SetNanOpacity(0.4);
  return function;
}

/// Gives the wall scalars from 1 to its number of points.
vtkSmartPointer<vtkFloatArray> AddScalars(Stage& stage)
{
  vtkMapper* mapper = stage.GetActor(Wall::Index)->GetMapper();
  auto scalars = vtkSmartPointer<vtkFloatArray>::New();
  for (vtkIdType i = 1; i <= mapper->GetInput()->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(i));
  }
  mapper->GetInput()->GetPointData()->SetScalars(scalars);
  return scalars;
}
}

// Hazard: VTK takes colors for opaque that have an alpha below 1, and blends them in the opaque
// stage: those that a color transfer function has for unknown values, and those of a table that the
// mapper has not taken over from the array before it has drawn.
TEST(CullerProps, BlendedColorsThatVTKTakesForOpaque)
{
  for (const bool isFunction : { true, false })
  {
    SCOPED_TRACE(isFunction);
    Comparison comparison(
      [isFunction](Stage& stage)
      {
        Scenes::BuildWall(stage);
        const auto scalars = AddScalars(stage);
        if (isFunction)
        {
          stage.GetActor(Wall::Index)->GetMapper()->SetLookupTable(MakeTableWithFaintNaN());
          return;
        }
        vtkNew<vtkLookupTable> table;
        table->SetAlphaRange(0.2, 0.9);
        table->Build();
        scalars->SetLookupTable(table);
      });
    for (int i = 0; i < 4; ++i)
    {
      Scenes::FrameOfWall(comparison, 0.1 * i);
      EXPECT_LT(comparison.GetHidden(), Wall::Behind / 4) << "the wall hides nothing";
    }
  }
}

namespace
{
/// Compares frames of the wall scene in which the wall and the camera move, with culling in each.
void CompareOrder(Comparison& comparison, const std::function<void()>& check)
{
  for (int i = 0; i < 8; ++i)
  {
    comparison.Frame(
      [i](Stage& stage)
      {
        Scenes::SetWallCamera(stage.GetRenderer(), i % 2 ? 9.0 : -2.0 * i);
        stage.GetActor(Wall::Index)->SetPosition(i % 3, 0.0, 0.0);
      });
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    EXPECT_GT(comparison.GetHidden(), 0);
    check();
  }
}
}

// Hazard: a prop that is forced to be opaque, with an opacity below 1, is blended in the opaque
// stage, so that the image depends on what was drawn before it, and on how often it is drawn. It
// also hides what is drawn after it. Props before it in the list are culled, the others are not.
TEST(CullerProps, BlendedInTheOpaqueStage)
{
  int last = -1;
  Comparison comparison(
    [&last](Stage& stage)
    {
      Scenes::BuildWall(stage);
      for (int i = 0; i < 6; ++i)
      {
        const int glass = Scenes::AddBox(stage, 2.4 * i - 6.0, 0.0, 6.0 + 0.1 * i, 2.0, 9.0, 0.1);
        stage.GetActor(glass)->GetProperty()->SetOpacity(0.5);
        stage.GetActor(glass)->ForceOpaqueOn();
      }
      last = Scenes::AddBox(stage, 0.0, 5.0, -2.0, 9.0, 2.0, 0.5);
      Scenes::SetWallCamera(stage.GetRenderer());
    });
  CompareOrder(comparison,
    [&]
    {
      for (int blended = Wall::Count; blended <= last; ++blended)
      {
        const Verdict verdict = comparison.GetVerdict(blended);
        EXPECT_TRUE(verdict == Verdict::Blended || verdict == Verdict::Outside) << blended;
      }
    });
}

namespace
{
/// How composite data with scalars is drawn.
struct BlendedBlocks : NamedCase
{
  std::function<vtkSmartPointer<vtkMapper>(vtkMultiBlockDataSet*)> MakeMapper;
  bool IsBlended = true;
};

using CullerBlendedBlocks = testing::TestWithParam<BlendedBlocks>;

/// Two blocks with scalars before the wall.
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks()
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int i = 0; i < 2; ++i)
  {
    const auto box = Scenes::MakeBox({ 6.0 * i - 3.0, 0.0, 6.0 }, { 5.0, 8.0, 0.1 });
    vtkNew<vtkFloatArray> scalars;
    scalars->SetNumberOfTuples(box->GetNumberOfPoints());
    scalars->FillValue(1.0F + static_cast<float>(i));
    box->GetPointData()->SetScalars(scalars);
    blocks->SetBlock(i, box);
  }
  return blocks;
}
}

// Hazard: VTK takes blocks for opaque that it blends in the opaque stage.
TEST_P(CullerBlendedBlocks, BlendedInTheOpaqueStage)
{
  int last = -1;
  Comparison comparison(
    [&last](Stage& stage)
    {
      Scenes::BuildWall(stage);
      vtkNew<vtkActor> actor;
      actor->SetMapper(GetParam().MakeMapper(MakeBlocks()));
      stage.Add(actor);
      last = Scenes::AddBox(stage, 0.0, 5.0, -2.0, 9.0, 2.0, 0.5);
    });
  CompareOrder(comparison,
    [&] { EXPECT_EQ(comparison.GetVerdict(last) == Verdict::Blended, GetParam().IsBlended); });
}

namespace
{
vtkSmartPointer<CompositeMapper> MakeCompositeMapper(vtkMultiBlockDataSet* blocks)
{
  auto mapper = vtkSmartPointer<CompositeMapper>::New();
  mapper->SetInputDataObject(blocks);
  mapper->SetCompositeDataDisplayAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
  return mapper;
}

vtkSmartPointer<vtkGlyph3DMapper> MakeGlyphs(vtkMultiBlockDataSet* blocks)
{
  auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetInputDataObject(blocks);
  mapper->SetSourceData(Scenes::MakeBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 0.1 }));
  mapper->ScalingOff();
  mapper->SetBlockAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
  return mapper;
}

const BlendedBlocks BlendedCases[] = {
  { "UnknownValues",
    [](vtkMultiBlockDataSet* blocks)
    {
      auto mapper = MakeCompositeMapper(blocks);
      mapper->SetLookupTable(MakeTableWithFaintNaN());
      return mapper;
    } },
  { "NoValues",
    [](vtkMultiBlockDataSet* blocks)
    {
      auto mapper = MakeCompositeMapper(blocks);
      mapper->SetLookupTable(MakeTableWithFaintNaN());
      mapper->ScalarVisibilityOff();
      return mapper;
    },
    false },
#if VTKNBUFFER_HAS_BLOCK_SCALARS
  { "UnknownValuesOfOneBlock",
    [](vtkMultiBlockDataSet* blocks)
    {
      auto mapper = MakeCompositeMapper(blocks);
      mapper->SetLookupTable(MakeTableWithFaintNaN());
      mapper->ScalarVisibilityOff();
      mapper->GetCompositeDataDisplayAttributes()->SetBlockScalarVisibility(
        blocks->GetBlock(1), true);
      return mapper;
    } },
  { "TableOfOneBlock",
    [](vtkMultiBlockDataSet* blocks)
    {
      auto mapper = MakeCompositeMapper(blocks);
      mapper->GetCompositeDataDisplayAttributes()->SetBlockLookupTable(
        blocks->GetBlock(1), MakeTableWithFaintNaN());
      return mapper;
    } },
#endif
  { "OpaqueGlyphs", &MakeGlyphs, false },
  { "GlyphsOfAFaintBlock",
    [](vtkMultiBlockDataSet* blocks)
    {
      auto mapper = MakeGlyphs(blocks);
      mapper->GetBlockAttributes()->SetBlockOpacity(blocks->GetBlock(1), 0.4);
      return mapper;
    } },
  { "GlyphsOfATableWithAlpha",
    [](vtkMultiBlockDataSet* blocks)
    {
      vtkNew<vtkLookupTable> table;
      table->SetAlphaRange(0.4, 0.4);
      auto mapper = MakeGlyphs(blocks);
      mapper->SetLookupTable(table);
      return mapper;
    } },
  { "GlyphsWithColors",
    [](vtkMultiBlockDataSet* blocks)
    {
      auto* block = vtkDataSet::SafeDownCast(blocks->GetBlock(1));
      vtkNew<vtkUnsignedCharArray> colors;
      colors->SetNumberOfComponents(4);
      colors->SetNumberOfTuples(block->GetNumberOfPoints());
      colors->FillValue(100);
      block->GetPointData()->SetScalars(colors);
      return MakeGlyphs(blocks);
    } },
};
}

INSTANTIATE_TEST_SUITE_P(Each, CullerBlendedBlocks, testing::ValuesIn(BlendedCases), GetCaseName);

// Hazard: a part of an assembly is blended in the opaque stage, which the assembly itself does not
// show.
TEST(CullerProps, BlendedPartOfAnAssembly)
{
  int last = -1; // comes after the assembly
  Comparison comparison(
    [&last](Stage& stage)
    {
      Scenes::BuildWall(stage);
      const int glass = Scenes::AddBox(stage, 0.0, 0.0, 6.0, 12.0, 9.0, 0.1);
      vtkNew<vtkAssembly> assembly;
      assembly->AddPart(stage.GetActor(glass));
      stage.GetRenderer()->RemoveActor(stage.GetActor(glass));
      stage.Add(assembly);
      last = Scenes::AddBox(stage, 0.0, 0.0, 5.0, 1.0, 1.0, 0.5);
      Scenes::SetWallCamera(stage.GetRenderer());
    });
  for (const bool blended : { false, true, false, true })
  {
    comparison.Both(
      [blended](Stage& stage)
      {
        vtkActor* glass = stage.GetActor(Wall::Count);
        glass->GetProperty()->SetOpacity(blended ? 0.5 : 1.0);
        glass->SetForceOpaque(blended);
      });
    for (int i = 0; i < 3; ++i)
    {
      Scenes::FrameOfWall(comparison, 2.0 * i);
      EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
      EXPECT_EQ(comparison.GetVerdict(last) == Verdict::Blended, blended);
    }
    EXPECT_GT(comparison.GetHidden(), 0);
  }
}

// Hazard: VTK's own culler, which came first in the first frame, has removed a translucent prop
// from the list; its opaque block is then missing in the order of equal depths.
TEST(CullerProps, OpaqueBlockOfATranslucentPropThatComesIntoView)
{
  ComparisonOptions options;
  options.Tuning.RoundSize = 1;
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      vtkActor* box = stage.GetActor(Scenes::AddBox(stage, 0.0, 0.0, 4.0, 3.0, 3.0, 1.0));
      const vtkSmartPointer<vtkActor> actor =
        Scenes::MakeTwoBlocks(box->GetMapper()->GetInputDataObject(0, 0),
          TestScene::MakeBox({ 4.0, 0.0, 4.0 }, { 1.0, 1.0, 1.0 }), 0.5);
      actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
      stage.Add(actor);
      for (vtkActor* moved : { box, actor.Get() })
      {
        moved->AddPosition(1000.0, 0.0, 0.0);
      }
    },
    options);
  comparison.Frame("outside");
  comparison.Both(
    [](Stage& stage)
    {
      const int size = static_cast<int>(stage.Props.size());
      for (int i = size - 2; i < size; ++i)
      {
        stage.GetActor(i)->AddPosition(-1000.0, 0.0, 0.0);
      }
    });
  comparison.Frame("inside");
  EXPECT_EQ(comparison.GetVerdict(static_cast<int>(comparison.Culled.Props.size()) - 1),
    Verdict::Translucent);
}

// Hazard: the verdicts of a frame without blending are used again for one with blending.
TEST(CullerProps, BlendingThatBeginsWhileTheCameraStandsStill)
{
  const std::function<void(Stage&)> changes[] = {
    [](Stage& stage) { stage.GetRenderer()->SetUseSSAO(true); },
    [](Stage& stage) { stage.Window->LineSmoothingOn(); },
    [](Stage& stage) { stage.Window->PolygonSmoothingOn(); },
  };
  for (const auto& change : changes)
  {
    Comparison comparison(
      [](Stage& stage)
      {
        Scenes::BuildWall(stage);
        stage.GetActor(2)->GetProperty()->SetRepresentationToWireframe();
        stage.GetActor(2)->GetProperty()->LightingOff();
      });
    for (int i = 0; i < 4; ++i)
    {
      comparison.Frame();
    }
    EXPECT_EQ(comparison.GetDecision(), Decision::Still);
    comparison.Both(change);
    comparison.Frame("blending");
    EXPECT_EQ(comparison.GetDecision(), Decision::Blending);
  }
}

// Hazard: smooth lines are blended at their edges in the opaque stage.
TEST(CullerProps, SmoothLines)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      for (int i = 2; i < Wall::Count; i += 5)
      {
        stage.GetActor(i)->GetProperty()->SetRepresentationToWireframe();
        stage.GetActor(i)->GetProperty()->RenderLinesAsTubesOff();
        stage.GetActor(i)->GetProperty()->SetLineWidth(3.0);
      }
      stage.Window->LineSmoothingOn();
    });
  for (int i = 0; i < 6; ++i)
  {
    comparison.Frame(
      [i](Stage& stage)
      {
        Scenes::SetWallCamera(stage.GetRenderer(), i % 2 ? 7.0 : -2.0 * i);
        stage.GetActor(Wall::Index)->SetPosition(2.0 * (i % 3), 0.0, 0.0);
      });
    EXPECT_EQ(comparison.GetDecision(), Decision::Blending);
    EXPECT_EQ(comparison.GetHidden(), 0);
  }
}
