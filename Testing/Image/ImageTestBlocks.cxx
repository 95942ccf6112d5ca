// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Composite data, of which only the blocks that can be seen are drawn.
#include "BlockMeshes.h"
#include "CompositeMapper.h"
#include "LargeProps.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkStripper.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <functional>
#include <random>
#include <vector>

using LargeProps::AddWalls;
using LargeProps::MakeOptionsWithoutDraws;
using LargeProps::Walk;

namespace
{
using Blocks = vtkSmartPointer<vtkMultiBlockDataSet>;

/// How the n-th block is changed before it is added.
using Finish = std::function<vtkSmartPointer<vtkPolyData>(vtkPolyData* block, unsigned int n)>;

/// Houses on a ground, each a block.
Blocks MakeBlockCity(int count, const Finish& finish = nullptr)
{
  auto blocks = Blocks::New();
  const auto meshes = TestScene::MakeBlockMeshes(static_cast<std::size_t>(count * count + 1));
  std::minstd_rand random(5);
  const auto add = [&](const glm::dvec3& center, const glm::dvec3& size)
  {
    const unsigned int n = blocks->GetNumberOfBlocks();
    vtkSmartPointer<vtkPolyData> box = Scenes::MakeBox(center, size);
    meshes[n]->ShallowCopy(finish ? finish(box, n) : box);
    blocks->SetBlock(n, meshes[n]);
  };
  add({ 0.0, 0.0, -0.5 }, { 4.0 * count, 4.0 * count, 1.0 });
  for (int x = 0; x < count; ++x)
  {
    for (int y = 0; y < count; ++y)
    {
      const double height = std::uniform_real_distribution<>(1.0, 6.0)(random);
      add({ 4.0 * x - 2.0 * count, 4.0 * y - 2.0 * count, 0.5 * height }, { 2.5, 2.5, height });
    }
  }
  return blocks;
}

/// A color for each cell.
vtkSmartPointer<vtkPolyData> ColorCellsOfBlock(vtkPolyData* block, unsigned int n)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < block->GetNumberOfCells(); ++i)
  {
    colors->InsertNextTuple3((40 * i) % 256, (n * 31) % 256, (n * 7 + 90 * i) % 256);
  }
  block->GetCellData()->SetScalars(colors);
  return block;
}

/// Blocks with different arrays, some of them of strips, are drawn by several mappers of blocks.
vtkSmartPointer<vtkPolyData> MakeDifferent(vtkPolyData* block, unsigned int n)
{
  switch (n % 4)
  {
    case 0:
      return ColorCellsOfBlock(block, n);
    case 1:
    {
      vtkNew<vtkPolyDataNormals> normals;
      normals->SetInputData(block);
      normals->Update();
      return normals->GetOutput();
    }
    case 2:
    {
      vtkNew<vtkStripper> stripper;
      stripper->SetInputData(block);
      stripper->Update();
      return stripper->GetOutput();
    }
    default:
      return block;
  }
}

CompositeMapper* GetBlockMapper(Stage& stage)
{
  return static_cast<CompositeMapper*>(stage.GetActor(0)->GetMapper());
}

vtkMultiBlockDataSet* GetBlocks(Stage& stage)
{
  return static_cast<vtkMultiBlockDataSet*>(GetBlockMapper(stage)->GetInputDataObject(0, 0));
}

/// The n-th block, which has the flat index n + 1.
vtkPolyData* GetBlock(Stage& stage, unsigned int n)
{
  return static_cast<vtkPolyData*>(GetBlocks(stage)->GetBlock(n));
}

void AddBlocks(Stage& stage, vtkDataObject* blocks)
{
  const double white[3] = { 1.0, 1.0, 1.0 };
  stage.AddActor(Scenes::MakeBox({}, { 1.0, 1.0, 1.0 }), white);
  vtkNew<CompositeMapper> mapper;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetInputDataObject(blocks);
  mapper->SetCompositeDataDisplayAttributes(attributes);
  stage.GetActor(static_cast<int>(stage.Props.size()) - 1)->SetMapper(mapper);
}

const LargeProps::Case BlockCases[] = {
  { "City", [](Stage& stage) { AddBlocks(stage, MakeBlockCity(14)); } },
  { "CellColors", [](Stage& stage) { AddBlocks(stage, MakeBlockCity(14, ColorCellsOfBlock)); } },
  { "DifferentArrays",
    [](Stage& stage)
    {
      AddBlocks(stage, MakeBlockCity(14, MakeDifferent));
      AddWalls(stage);
    } },
  { "ColorsOfBlocks",
    [](Stage& stage)
    {
      AddBlocks(stage, MakeBlockCity(14));
      for (unsigned int i = 1; i < 190; i += 3)
      {
        const double color[3] = { 0.005 * i, 0.3, 1.0 - 0.005 * i };
        GetBlockMapper(stage)->SetBlockColor(i, color);
      }
      AddWalls(stage);
    } },
  { "Nested",
    [](Stage& stage)
    {
      const Blocks first = MakeBlockCity(14);
      vtkNew<vtkMultiBlockDataSet> all;
      vtkNew<vtkMultiBlockDataSet> half;
      for (unsigned int i = 0; i < first->GetNumberOfBlocks(); ++i)
      {
        (i % 2 ? all.Get() : half.Get())->SetBlock(i / 2, first->GetBlock(i));
      }
      all->SetBlock(all->GetNumberOfBlocks(), half);
      all->SetBlock(all->GetNumberOfBlocks() + 2, nullptr);
      AddBlocks(stage, all);
    } },
  { "SharedMeshes",
    [](Stage& stage)
    {
      const Blocks blocks = MakeBlockCity(14);
      for (unsigned int i = 0; i < 40; ++i)
      {
        blocks->SetBlock(blocks->GetNumberOfBlocks(), blocks->GetBlock(3 * i));
      }
      AddBlocks(stage, blocks);
    } },
  { "InvisibleBlocks",
    [](Stage& stage)
    {
      AddBlocks(stage, MakeBlockCity(14));
      for (unsigned int i = 2; i < 190; i += 5)
      {
        GetBlockMapper(stage)->SetBlockVisibility(i, false);
      }
    } },
  { "MovedActor",
    [](Stage& stage)
    {
      AddBlocks(stage, MakeBlockCity(14));
      stage.GetActor(0)->SetPosition(1.0, 0.5, 0.0);
      stage.GetActor(0)->RotateZ(30.0);
      stage.GetActor(0)->SetScale(1.0, 0.7, 1.3);
      AddWalls(stage);
    } },
  { "ClippingPlane",
    [](Stage& stage)
    {
      AddBlocks(stage, MakeBlockCity(14));
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.6, 0.0, 0.8);
      GetBlockMapper(stage)->AddClippingPlane(plane);
    } },
  { "TwoCities",
    [](Stage& stage)
    {
      AddBlocks(stage, MakeBlockCity(10));
      AddBlocks(stage, MakeBlockCity(14));
    } },
};
}

using CullerBlocks = testing::TestWithParam<LargeProps::Case>;
INSTANTIATE_TEST_SUITE_P(Each, CullerBlocks, testing::ValuesIn(BlockCases), GetCaseName);

// Hazard: the boxes of units are too small, blocks are drawn in another order than VTK's, or the
// culler's list of blocks stays in the mapper.
TEST_P(CullerBlocks, SameImage)
{
  LargeProps::CompareWalks(this->GetParam().Build, MakeOptionsWithoutDraws(), 8, Walk, { 40, 10 },
    [](Comparison& comparison)
    {
      // The mapper names all blocks as drawn.
      std::vector<std::size_t> listed;
      comparison.Both([&listed](Stage& stage)
        { listed.push_back(GetBlockMapper(stage)->GetRenderedList().size()); });
      EXPECT_EQ(listed.at(0), listed.at(1));
    });
}

// Hazard: VTK scales the vertices of all blocks together, those that are switched off as well. Far
// from the others they make the vertices inexact, up to several pixels here.
TEST(CullerBlocksRounding, CountsInvisibleBlocks)
{
  Comparison comparison(
    [](Stage& stage)
    {
      const Blocks city = MakeBlockCity(14);
      city->SetBlock(
        city->GetNumberOfBlocks(), Scenes::MakeBox({ 3.0e7, 1.0e7, 2.0e7 }, { 1.0, 1.0, 1.0 }));
      AddBlocks(stage, city);
      GetBlockMapper(stage)->SetBlockVisibility(city->GetNumberOfBlocks(), false);
      AddWalls(stage);
    },
    MakeOptionsWithoutDraws());
  LargeProps::CompareWalk(comparison, Walk);
}

// Hazard: of blocks with equal depth, the last one in VTK's order has to stay visible.
TEST(CullerBlocksTies, LastOneStays)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::SetPixelCamera(stage.GetRenderer(), 301, 173);
      vtkNew<vtkMultiBlockDataSet> quads;
      const std::vector<vtkSmartPointer<vtkPolyData>> meshes = TestScene::MakeBlockMeshes(200);
      std::minstd_rand random(11);
      for (unsigned int i = 0; i < 200; ++i)
      {
        const double x = random() % 280;
        const double y = random() % 160;
        const double z = -10.0 * static_cast<double>(random() % 3);
        const double size = 10.0 + random() % 40;
        vtkSmartPointer<vtkPolyData> quad =
          Scenes::MakeBox({ x, y, z - 0.5 * size }, { size, size, size });
        meshes[i]->ShallowCopy(ColorCellsOfBlock(quad, i));
        quads->SetBlock(i, meshes[i]);
      }
      AddBlocks(stage, quads);
      stage.GetActor(0)->GetProperty()->LightingOff();
      Scenes::AddQuad(stage, 0, 0, 120, 173, 50.0); // the door
    },
    MakeOptionsWithoutDraws());
  int fresh = 0;
  int queries = 0;
  for (int i = 0; i < 30; ++i)
  {
    comparison.Frame([i](Stage& stage) { stage.GetActor(1)->SetPosition((i * 47) % 180, 0, 0); });
    fresh += comparison.GetStatistics().UnitsFresh;
    queries += comparison.GetStatistics().TieQueries;
  }
  EXPECT_GT(fresh, 300);
  EXPECT_GT(queries, 10);
}

//------------------------------------------------------------------------------------------------
namespace
{
/// Move points without a newer time of the tree of blocks.
void Move(Stage& stage, unsigned int n, const glm::dvec3& by)
{
  TestScene::MovePoints(GetBlock(stage, n)->GetPoints(), by, 0.0);
  GetBlock(stage, n)->Modified();
}

const std::vector<LargeProps::Change> BlockChanges = LargeProps::AndCommonChanges({
  { "Points",
    [](Stage& stage)
    {
      for (unsigned int i = 1; i < 150; ++i)
      {
        Move(stage, i, { 0.5, -1.0, 1.2 });
      }
    } },
  { "Block",
    [](Stage& stage) {
      GetBlocks(stage)->SetBlock(20, Scenes::MakeBox({ -18.0, 3.0, 2.1 }, { 1.0, 1.0, 4.0 }));
    } },
  { "BlockAdded",
    [](Stage& stage)
    {
      GetBlocks(stage)->SetBlock(GetBlocks(stage)->GetNumberOfBlocks(),
        Scenes::MakeBox({ -12.0, 3.0, 4.6 }, { 1.0, 1.0, 9.0 }));
    } },
  { "BlockRemoved", [](Stage& stage) { GetBlocks(stage)->RemoveBlock(30); } },
  { "OrderOfBlocks",
    [](Stage& stage)
    {
      const vtkSmartPointer<vtkPolyData> first = GetBlock(stage, 40);
      GetBlocks(stage)->SetBlock(40, GetBlock(stage, 80));
      GetBlocks(stage)->SetBlock(80, first);
    } },
  { "Data", [](Stage& stage) { GetBlockMapper(stage)->SetInputDataObject(MakeBlockCity(9)); } },
  { "BlockColor",
    [](Stage& stage)
    {
      const double red[3] = { 1.0, 0.1, 0.0 };
      GetBlockMapper(stage)->SetBlockColor(50, red);
    } },
  { "BlockVisibility",
    [](Stage& stage)
    {
      for (unsigned int i = 2; i < 150; ++i)
      {
        GetBlockMapper(stage)->SetBlockVisibility(i, i % 3 != 0);
      }
    } },
  { "BlockOpacity", [](Stage& stage) { GetBlockMapper(stage)->SetBlockOpacity(40, 0.5); }, false },
  { "Selection",
    [](Stage& stage)
    {
      vtkNew<vtkIdTypeArray> ids;
      ids->InsertNextValue(3);
      vtkNew<vtkSelectionNode> node;
      node->SetContentType(vtkSelectionNode::INDICES);
      node->SetFieldType(vtkSelectionNode::CELL);
      node->SetSelectionList(ids);
      node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 33);
      vtkNew<vtkSelection> selection;
      selection->AddNode(node);
      GetBlockMapper(stage)->SetSelection(selection);
    },
    false },
  // VTK shows arbitrary colors on blocks without a texture if others have one. (Before 9.6 blocks
  // cannot have textures of their own.)
  { "Textures",
    [](Stage& stage)
    {
      vtkSmartPointer<vtkTexture> textures[2];
      for (int n = 0; n < 2; ++n)
      {
        vtkNew<vtkImageData> image;
        image->SetDimensions(2, 2, 1);
        image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
        for (int i = 0; i < 12; ++i)
        {
          static_cast<unsigned char*>(image->GetScalarPointer())[i] = 20 * i + 15 * n;
        }
        textures[n] = vtkSmartPointer<vtkTexture>::New();
        textures[n]->SetInputData(image);
      }
      for (unsigned int i = 0; i < GetBlocks(stage)->GetNumberOfBlocks(); ++i)
      {
        vtkPointData* values = GetBlock(stage, i)->GetPointData();
        values->SetTCoords(LargeProps::AddRandomArray<vtkFloatArray>(
          values, GetBlock(stage, i)->GetNumberOfPoints(), "places", 2, 0.0, 1.0));
#if VTKNBUFFER_HAS_BLOCK_TEXTURES
        GetBlockMapper(stage)->SetBlockTexture(i + 1, textures[i % 2]);
#endif
      }
      GetBlocks(stage)->Modified();
    } },
  { "Opacity", [](Stage& stage) { stage.GetActor(0)->GetProperty()->SetOpacity(0.5); }, false },
});
}

using CullerBlocksChanges = testing::TestWithParam<LargeProps::Change>;
INSTANTIATE_TEST_SUITE_P(Each, CullerBlocksChanges, testing::ValuesIn(BlockChanges), GetCaseName);

// Hazard: blocks have changed, and their former boxes are tested.
TEST_P(CullerBlocksChanges, SameImage)
{
  Comparison comparison(
    [](Stage& stage)
    {
      AddBlocks(stage, MakeBlockCity(14));
      AddWalls(stage);
    },
    MakeOptionsWithoutDraws());
  LargeProps::CompareChange(comparison, this->GetParam().Apply, Walk);
  EXPECT_EQ(comparison.GetStatistics().Units > 0, this->GetParam().IsDividedAfterwards);
}

// Hazard: a block moves into view while no other block of the prop is drawn. Only the modification
// time of the block shows that.
TEST(CullerBlocksChanges, AreNoticedWhileNothingIsDrawn)
{
  for (const bool behindTheWall : { true, false })
  {
    Comparison comparison(
      [](Stage& stage)
      {
        // Two groups of blocks with a gap between them, where the camera looks.
        AddBlocks(stage, MakeBlockCity(5));
        for (unsigned int i = 0; i < 26; ++i)
        {
          Move(stage, i, { i % 2 ? 40.0 : -40.0, 0.0, 0.0 });
        }
        Scenes::AddBox(stage, 0.0, 0.0, 0.0, 2.0, 2.0, 2.0);
      },
      MakeOptionsWithoutDraws());
    for (int i = 0; i < 6; ++i)
    {
      comparison.Frame(
        [i, behindTheWall](Stage& stage)
        {
          vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
          camera->SetPosition(0.02 * i, -8.0, 0.0);
          camera->SetFocalPoint(0.02 * i, 0.0, 0.0);
          camera->SetViewUp(0.0, 0.0, 1.0);
          camera->SetClippingRange(0.1, 100.0);
          if (behindTheWall)
          {
            stage.GetActor(1)->SetScale(60.0, 1.0, 60.0);
          }
        });
    }
    comparison.Frame("moved", [](Stage& stage) { Move(stage, 4, { 50.0, -4.0, 0.0 }); });
    comparison.Frame("after");
    comparison.Frame("after");
  }
}

// Hazard: a block comes out from behind a wall, and leaves the time of its tree as it is. VTK knows
// of it when it draws the block, and the culler does not draw it.
TEST(CullerBlocksChanges, AHiddenBlockComesInFront)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      vtkNew<vtkCubeSource> cube;
      cube->SetCenter(0.0, 0.0, -6.0);
      cube->Update();
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, cube->GetOutput());
      AddBlocks(stage, blocks);
    });
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.02 * i, "behind");
  }
  EXPECT_EQ(comparison.GetVerdict(Scenes::Wall::Count), Verdict::Hidden);
  comparison.Both(
    [](Stage& stage)
    {
      vtkDataObject* blocks =
        stage.GetActor(Scenes::Wall::Count)->GetMapper()->GetInputDataObject(0, 0);
      auto* cube =
        vtkPolyData::SafeDownCast(static_cast<vtkMultiBlockDataSet*>(blocks)->GetBlock(0));
      TestScene::MovePoints(cube->GetPoints(), { 0.0, 0.0, 9.0 });
    });
  Scenes::FrameOfWall(comparison, 0.1, "in front");
  EXPECT_EQ(comparison.GetVerdict(Scenes::Wall::Count), Verdict::Visible);
}

// Hazard: a selection draws only the culler's list of blocks, so that hidden blocks cannot be
// picked.
TEST(CullerBlocksPicking, SameBlocks)
{
  Comparison comparison(
    [](Stage& stage) { AddBlocks(stage, MakeBlockCity(14)); }, MakeOptionsWithoutDraws());
  LargeProps::ComparePicks(comparison, Walk);
}
