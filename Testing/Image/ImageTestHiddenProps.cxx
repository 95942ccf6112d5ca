// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What VTK changes only when it draws a prop, and what an application changes while a prop is
// hidden.
#include "CompositeMapper.h"
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkAbstractMapper.h"
#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkScalarBarActor.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <algorithm>
#include <functional>

#if __has_include("vtkCaptionActor2D.h")
#define VTKNBUFFER_TEST_HAS_CAPTIONS 1
#include "vtkCaptionActor2D.h"
#endif

using Scenes::Wall;

namespace
{
constexpr double Behind = -6.0;

/// The data of a sphere with scalars from 0 to 1.
vtkSmartPointer<vtkPolyData> MakeSphereWithScalars()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.2);
  source->Update();
  vtkSmartPointer<vtkPolyData> data = source->GetOutput();
  vtkNew<vtkFloatArray> scalars;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(i % 7) / 7.0F);
  }
  data->GetPointData()->SetScalars(scalars);
  return data;
}

/// A cube of eight cells with scalars from 0 to 1.
vtkSmartPointer<vtkStructuredGrid> MakeGrid()
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(3, 3, 3);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> scalars;
  for (int i = 0; i < 27; ++i)
  {
    points->InsertNextPoint(i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0);
    scalars->InsertNextValue(static_cast<float>(i) / 26.0F);
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(scalars);
  return grid;
}

/// Adds an actor behind the wall. Returns its index in Stage::Props.
int AddHidden(Stage& stage, vtkMapper* mapper)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(0.0, 0.0, Behind);
  stage.Add(actor);
  return static_cast<int>(stage.Props.size()) - 1;
}

/// What is at the index that AddHidden() returns, if it comes right after the wall scene.
constexpr int Hidden = Wall::Count;

struct Table : NamedCase
{
  std::function<vtkSmartPointer<vtkMapper>(vtkLookupTable*)> MakeMapper;
};

using CullerTables = testing::TestWithParam<Table>;
}

// Hazard: a mapper sets the range of its table, or takes over that of an array, when it is drawn. A
// hidden prop is not drawn, and whatever else shows the table shows another range.
TEST_P(CullerTables, HaveTheRangeOfHiddenProps)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      vtkNew<vtkLookupTable> table;
      table->Build();
      AddHidden(stage, GetParam().MakeMapper(table));
      vtkNew<vtkScalarBarActor> bar;
      bar->SetLookupTable(table);
      stage.Add(bar);
    });
  for (const double end : { 0.7, 0.7, 0.7, 5.0, 5.0, 5.0 })
  {
    comparison.Both(
      [end](Stage& stage) { stage.GetActor(Hidden)->GetMapper()->SetScalarRange(-0.5, end); });
    Scenes::FrameOfWall(comparison, end);
    EXPECT_GT(comparison.GetHidden(), 0);
  }
  EXPECT_EQ(comparison.GetVerdict(Hidden), Verdict::Hidden) << "once the table has the range";
}

namespace
{
/// A mapper of one block with scalars.
vtkSmartPointer<CompositeMapper> MakeBlockMapper(vtkLookupTable* table)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeSphereWithScalars());
  auto mapper = vtkSmartPointer<CompositeMapper>::New();
  mapper->SetInputDataObject(blocks);
  mapper->SetLookupTable(table);
  mapper->SetCompositeDataDisplayAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
  return mapper;
}

#if VTKNBUFFER_HAS_BLOCK_SCALARS
vtkDataSet* GetFirstBlock(vtkMapper* mapper)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  return vtkDataSet::SafeDownCast(blocks->GetBlock(0));
}
#endif

const Table Tables[] = {
  { "OfAMapper",
    [](vtkLookupTable* table)
    {
      auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
      mapper->SetInputData(MakeSphereWithScalars());
      mapper->SetLookupTable(table);
      return mapper;
    } },
  { "OfAnArray",
    [](vtkLookupTable* table)
    {
      const auto data = MakeSphereWithScalars();
      data->GetPointData()->GetScalars()->SetLookupTable(table);
      auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
      mapper->SetInputData(data);
      return mapper;
    } },
  { "OfAGrid",
    [](vtkLookupTable* table)
    {
      auto mapper = vtkSmartPointer<vtkDataSetMapper>::New();
      mapper->SetInputData(MakeGrid());
      mapper->SetLookupTable(table);
      return mapper;
    } },
  { "OfBlocks", [](vtkLookupTable* table) { return MakeBlockMapper(table); } },
#if VTKNBUFFER_HAS_BLOCK_SCALARS
  { "OfABlockThatShowsScalars",
    [](vtkLookupTable* table)
    {
      auto mapper = MakeBlockMapper(table);
      mapper->ScalarVisibilityOff();
      mapper->GetCompositeDataDisplayAttributes()->SetBlockScalarVisibility(
        GetFirstBlock(mapper), true);
      return mapper;
    } },
  { "OfABlockThatNamesAnArray",
    [](vtkLookupTable* table)
    {
      auto mapper = MakeBlockMapper(table);
      vtkDataSet* block = GetFirstBlock(mapper);
      block->GetPointData()->GetScalars()->SetName("values");
      block->GetPointData()->SetActiveScalars(nullptr);
      auto* attributes = mapper->GetCompositeDataDisplayAttributes();
      attributes->SetBlockScalarMode(block, VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
      attributes->SetBlockArrayAccessMode(block, VTK_GET_ARRAY_BY_NAME);
      attributes->SetBlockArrayName(block, "values");
      return mapper;
    } },
#endif
};

/// An image of 8 x 8 pixels with this alpha.
vtkSmartPointer<vtkImageData> MakeImage(unsigned char alpha)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 64; ++i)
  {
    std::fill_n(values + 4 * i, 3, static_cast<unsigned char>(3 * i));
    values[4 * i + 3] = i < 32 ? alpha : 255;
  }
  return image;
}

/// Gives the wall a texture, as its own or, with a name, as one of its property.
void SetTexture(Stage& stage, unsigned char alpha, const char* name)
{
  vtkActor* wall = stage.GetActor(Wall::Index);
  auto* data = vtkPolyData::SafeDownCast(wall->GetMapper()->GetInput());
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    coordinates->InsertNextTuple2(point[0] / 12.0 + 0.5, point[1] / 8.0 + 0.5);
  }
  data->GetPointData()->SetTCoords(coordinates);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(MakeImage(alpha));
  if (name)
  {
    texture->UseSRGBColorSpaceOn();
    wall->GetProperty()->SetTexture(name, texture);
  }
  else
  {
    wall->SetTexture(texture);
  }
}

vtkTexture* GetTexture(Stage& stage)
{
  vtkActor* wall = stage.GetActor(Wall::Index);
  return wall->GetTexture() ? wall->GetTexture() : wall->GetProperty()->GetTexture("albedoTex");
}

/// Moves points in place, to the front of the wall, without a newer time of them.
void MoveToTheFront(vtkPointSet* data)
{
  auto* values = vtkFloatArray::SafeDownCast(data->GetPoints()->GetData())->GetPointer(0);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    values[3 * i + 2] += 14.0F;
  }
}

struct Change : NamedCase
{
  std::function<void(Stage&)> Prepare;
  std::function<void(Stage&)> Apply;
};

using CullerHiddenProps = testing::TestWithParam<Change>;
}

INSTANTIATE_TEST_SUITE_P(Each, CullerTables, testing::ValuesIn(Tables), GetCaseName);

// Hazard: what VTK notices when it draws is not noticed if it does not draw.
TEST_P(CullerHiddenProps, ChangesAreSeen)
{
  for (const bool still : { true, false })
  {
    SCOPED_TRACE(still);
    Comparison comparison(
      [](Stage& stage)
      {
        Scenes::BuildWall(stage);
        GetParam().Prepare(stage);
      });
    for (int i = 0; i < 3; ++i)
    {
      Scenes::FrameOfWall(comparison, still ? 0.0 : 0.05 * i, "before");
    }
    comparison.Both(GetParam().Apply);
    for (int i = 3; i < 6; ++i)
    {
      Scenes::FrameOfWall(comparison, still ? 0.0 : 0.05 * i, "after");
    }
    EXPECT_GT(comparison.GetHidden(), 0);
  }
}

namespace
{
const Change Changes[] = {
  { "PointsOfAGridInPlace",
    [](Stage& stage)
    {
      vtkNew<vtkDataSetMapper> mapper;
      mapper->SetInputData(MakeGrid());
      AddHidden(stage, mapper);
    },
    [](Stage& stage)
    {
      auto* grid = vtkPointSet::SafeDownCast(stage.GetActor(Hidden)->GetMapper()->GetInput());
      MoveToTheFront(grid);
      grid->Modified();
    } },
  { "ImageOfTheBaseColor",
    [](Stage& stage)
    {
      SetTexture(stage, 255, "albedoTex");
      stage.GetActor(Wall::Index)->GetProperty()->SetInterpolationToPBR();
    },
    [](Stage& stage) { GetTexture(stage)->SetInputData(MakeImage(0)); } },
  { "TransformOfATexture",
    [](Stage& stage)
    {
      SetTexture(stage, 0, nullptr);
      vtkNew<vtkTransform> transform;
      GetTexture(stage)->SetTransform(transform);
    },
    [](Stage& stage) { GetTexture(stage)->GetTransform()->Translate(0.0, 0.3, 0.0); } },
#if VTKNBUFFER_TEST_HAS_CAPTIONS
  { "LeaderOfACaption",
    [](Stage& stage)
    {
      vtkNew<vtkCaptionActor2D> caption;
      caption->SetCaption("behind");
      caption->SetAttachmentPoint(-3.0, 0.0, 4.0);
      caption->ThreeDimensionalLeaderOn();
      vtkNew<vtkSphereSource> glyph;
      glyph->SetRadius(3.0);
      glyph->Update();
      caption->SetLeaderGlyphData(glyph->GetOutput());
      caption->SetMaximumLeaderGlyphSize(200);
      caption->SetLeaderGlyphSize(0.2);
      stage.Add(caption);
    },
    [](Stage& stage)
    { vtkCaptionActor2D::SafeDownCast(stage.Props.back())->SetAttachmentPoint(4.0, 3.0, 4.0); } },
#endif
};
}

INSTANTIATE_TEST_SUITE_P(Each, CullerHiddenProps, testing::ValuesIn(Changes), GetCaseName);

// Hazard: an application removes its own observers of a renderer, and with them those by which the
// culler lets props go.
TEST(CullerHiddenPropsOnce, PropsAreReleasedWithoutObservers)
{
  Comparison comparison(&Scenes::BuildWall);
  comparison.Frame();
  const int references = comparison.Culled.GetActor(Wall::Index)->GetReferenceCount();
  for (int i = 0; i < 6; ++i)
  {
    vtkRenderer* renderer = comparison.Culled.GetRenderer();
    i % 2 ? renderer->RemoveAllObservers() : renderer->RemoveObservers(vtkCommand::EndEvent);
    comparison.Both([](Stage& stage) { Scenes::AddBox(stage, 0.0, 0.0, Behind, 1.0, 1.0, 1.0); });
    comparison.Frame();
    EXPECT_EQ(comparison.Culled.GetActor(Wall::Index)->GetReferenceCount(), references);
  }
}
