// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What VTK leaves for the next prop in objects that props share (ImageTestSharedMappers.cxx is
// about the shaders of shared mappers).
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp3DCollection.h"
#include "vtkProperty.h"
#include "vtkScalarBarActor.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"

#include <functional>

namespace
{
/// Where floats are multiples of 2.
constexpr double FarAway = 3e7;

/// A sphere with texture coordinates, and with scalars from 0 to 1.
vtkSmartPointer<vtkPolyData> MakeScalarSphere(double x = 0.0)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(12);
  source->SetPhiResolution(9);
  source->SetCenter(x, 0.0, 0.0);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkSmartPointer<vtkPolyData> data = source->GetOutput();
  vtkNew<vtkFloatArray> scalars;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(i % 7) / 7.0F);
    coordinates->InsertNextTuple2(0.37 * static_cast<double>(i), 0.11 * static_cast<double>(i));
  }
  data->GetPointData()->SetScalars(scalars);
  data->GetPointData()->SetTCoords(coordinates);
  return data;
}

vtkSmartPointer<vtkPolyDataMapper> MakeMapper(vtkPolyData* data)
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  return mapper;
}

/// Three places for actors: before the wall, in this order, and behind it.
enum class Place
{
  Far,
  Near,
  Hidden
};

vtkSmartPointer<vtkActor> MakeActor(vtkMapper* mapper, Place place)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetScale(2.5);
  switch (place)
  {
    case Place::Far:
      actor->SetPosition(-1.5, 0.3, 4.0);
      break;
    case Place::Near:
      actor->SetPosition(1.5, 0.3, 9.0);
      break;
    case Place::Hidden:
      actor->SetPosition(0.0, 0.0, -6.0);
      break;
  }
  return actor;
}

/// A mapper that sets the range of a table, or one that maps by the range that it finds.
void AddColored(Stage& stage, Place place, vtkLookupTable* table, bool setsRange, double end = 0.7)
{
  auto mapper = MakeMapper(MakeScalarSphere());
  mapper->SetLookupTable(table);
  mapper->SetUseLookupTableScalarRange(!setsRange);
  mapper->SetScalarRange(-0.5, end);
  stage.Add(MakeActor(mapper, place));
}

vtkSmartPointer<vtkTexture> MakeTexture(vtkLookupTable* table)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int i = 0; i < 64; ++i)
  {
    static_cast<float*>(image->GetScalarPointer())[i] = static_cast<float>(i % 5) / 5.0F;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetLookupTable(table);
  return texture;
}

void AddShifted(Stage& stage, Place place, vtkPolyData* data, int method)
{
  auto mapper = MakeMapper(data);
  mapper->ScalarVisibilityOff();
  vtkOpenGLPolyDataMapper::SafeDownCast(mapper)->SetVBOShiftScaleMethod(method);
  auto actor = MakeActor(mapper, place);
  actor->SetScale(1.0);
  actor->AddPosition(-FarAway, 0.0, 0.0);
  stage.Add(actor);
}

void AddPart(Stage& stage, Place place, vtkMapper* mapper, int interpolation)
{
  auto actor = MakeActor(mapper, place);
  actor->GetProperty()->SetInterpolation(interpolation);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(actor);
  stage.Add(assembly);
}

/// Props of which some share an object, besides the wall and what is behind it. The nearest prop is
/// drawn first, and what is hidden is not drawn at all.
struct Sharing : NamedCase
{
  std::function<void(Stage&)> Build;
  bool Matters = true; ///< False if all of a renderer use the object in the same way.
};

using CullerSharedState = testing::TestWithParam<Sharing>;

void ExpectOrderIsKept(Comparison& comparison, bool isKept)
{
  EXPECT_EQ(comparison.GetDecision(), isKept ? Decision::Blending : Decision::Culled);
}

ComparisonOptions GetOptions()
{
  ComparisonOptions options;
  options.Tuning.RoundSize = 1;
  return options;
}
}

// Hazard: the culler draws actors in another order than the renderer, or not at all. Where VTK
// stores something in an object that actors share, other actors get wrong colours or a wrong place.
TEST_P(CullerSharedState, IsLeftInTheSameOrder)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      GetParam().Build(stage);
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    GetOptions());
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.2 * i);
    ExpectOrderIsKept(comparison, GetParam().Matters);
  }
}

// Hazard: the parts of an assembly change without anything that the culler could notice.
TEST(CullerSharedStateOnce, PartsAreReadInEachFrame)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      auto mapper = MakeMapper(MakeScalarSphere());
      AddPart(stage, Place::Far, mapper, VTK_GOURAUD);
      stage.Add(MakeActor(mapper, Place::Near));
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    GetOptions());
  for (const int interpolation : { VTK_GOURAUD, VTK_FLAT, VTK_GOURAUD })
  {
    comparison.Both(
      [interpolation](Stage& stage)
      {
        auto* assembly = vtkAssembly::SafeDownCast(stage.Props[stage.Props.size() - 2]);
        auto* part = vtkActor::SafeDownCast(assembly->GetParts()->GetItemAsObject(0));
        part->GetProperty()->SetInterpolation(interpolation);
      });
    comparison.Frame();
    comparison.Frame();
    ExpectOrderIsKept(comparison, interpolation == VTK_FLAT);
  }
}

namespace
{
/// Two mappers with one table, the second of which may set its range.
std::function<void(Stage&)> Tables(Place first, bool firstSets, Place second, bool secondSets)
{
  return [=](Stage& stage)
  {
    vtkNew<vtkLookupTable> table;
    AddColored(stage, first, table, firstSets);
    AddColored(stage, second, table, secondSets);
  };
}

/// A hidden actor, and one of another renderer, a layer above, with the same mapper.
std::function<void(Stage&)> Layer(int interpolation, int interpolationAbove)
{
  return [=](Stage& stage)
  {
    const auto mapper = MakeMapper(MakeScalarSphere());
    auto hidden = MakeActor(mapper, Place::Hidden);
    hidden->GetProperty()->SetInterpolation(interpolation);
    stage.Add(hidden);
    auto above = MakeActor(mapper, Place::Near);
    above->GetProperty()->SetInterpolation(interpolationAbove);
    stage.Window->SetNumberOfLayers(2);
    vtkRenderer* layer = stage.AddRenderer(0.0, 0.0, 1.0, 1.0, 1);
    layer->SetActiveCamera(stage.GetRenderer()->GetActiveCamera());
    stage.Add(above, layer);
  };
}

/// Two mappers that show the same points.
std::function<void(Stage&)> Points(int first, int second)
{
  return [=](Stage& stage)
  {
    const auto data = MakeScalarSphere(FarAway);
    AddShifted(stage, Place::Far, data, first);
    AddShifted(stage, Place::Near, data, second);
  };
}

/// A part of an assembly and an actor with the same mapper.
std::function<void(Stage&)> Part(Place part, int interpolation, Place actor)
{
  return [=](Stage& stage)
  {
    const auto mapper = MakeMapper(MakeScalarSphere());
    AddPart(stage, part, mapper, interpolation);
    stage.Add(MakeActor(mapper, actor));
  };
}

const Sharing Sharings[] = {
  { "RangeOfTheFirst", Tables(Place::Far, true, Place::Near, false) },
  { "RangeOfTheSecond", Tables(Place::Far, false, Place::Near, true) },
  { "RangeOfAHiddenProp", Tables(Place::Hidden, true, Place::Near, false) },
  { "EqualRanges", Tables(Place::Far, true, Place::Near, true), false },
  { "RangeOfTheTable", Tables(Place::Far, false, Place::Near, false), false },
  { "TableOfAnArray",
    [](Stage& stage)
    {
      const auto data = MakeScalarSphere();
      vtkNew<vtkLookupTable> table;
      table->Build();
      data->GetPointData()->GetScalars()->SetLookupTable(table);
      for (const bool isNear : { false, true })
      {
        auto mapper = MakeMapper(data);
        mapper->SetUseLookupTableScalarRange(!isNear);
        mapper->SetScalarRange(-0.5, 0.7);
        stage.Add(MakeActor(mapper, isNear ? Place::Near : Place::Far));
      }
    } },
#if VTKNBUFFER_HAS_BLOCK_SCALARS
  { "TableOfABlock",
    [](Stage& stage)
    {
      vtkNew<vtkLookupTable> table;
      AddColored(stage, Place::Far, table, false);
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, MakeScalarSphere());
      vtkNew<vtkCompositeDataDisplayAttributes> attributes;
      attributes->SetBlockScalarVisibility(blocks->GetBlock(0), true);
      vtkNew<vtkCompositePolyDataMapper> mapper;
      mapper->SetInputDataObject(blocks);
      mapper->SetCompositeDataDisplayAttributes(attributes);
      mapper->ScalarVisibilityOff();
      mapper->SetLookupTable(table);
      mapper->SetScalarRange(-0.5, 0.7);
      stage.Add(MakeActor(mapper, Place::Near));
    } },
#endif
  { "TableOfATexture",
    [](Stage& stage)
    {
      vtkNew<vtkLookupTable> table;
      AddColored(stage, Place::Hidden, table, true);
      auto mapper = MakeMapper(MakeScalarSphere());
      mapper->ScalarVisibilityOff();
      auto actor = MakeActor(mapper, Place::Near);
      actor->SetTexture(MakeTexture(table));
      stage.Add(actor);
    } },
  { "ScalarBar",
    [](Stage& stage)
    {
      vtkNew<vtkLookupTable> table;
      AddColored(stage, Place::Near, table, true);
      AddColored(stage, Place::Hidden, table, true, 7.0);
      vtkNew<vtkScalarBarActor> bar;
      bar->SetLookupTable(table);
      stage.Add(bar);
    } },
  { "PointsShiftedByTheSecond",
    Points(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE,
      vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE) },
  { "PointsShiftedByTheFirst",
    Points(vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE,
      vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE) },
  { "PointsShiftedByBoth",
    Points(
      vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE, vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE),
    false },
  { "NearPart", Part(Place::Near, VTK_FLAT, Place::Far) },
  { "FarPart", Part(Place::Far, VTK_FLAT, Place::Near) },
  { "LikePart", Part(Place::Far, VTK_GOURAUD, Place::Near), false },
  { "PartsOfOneAssembly",
    [](Stage& stage)
    {
      // Drawn once more for the order of equal depths, the first part follows the last one.
      const auto mapper = MakeMapper(MakeScalarSphere());
      vtkNew<vtkAssembly> assembly;
      for (const bool isNear : { false, true })
      {
        auto actor = MakeActor(mapper, isNear ? Place::Near : Place::Far);
        actor->GetProperty()->SetInterpolation(isNear ? VTK_FLAT : VTK_GOURAUD);
        assembly->AddPart(actor);
      }
      stage.Add(assembly);
    } },
  { "FlatLayer", Layer(VTK_GOURAUD, VTK_FLAT), false },
  { "FlatBelowALayer", Layer(VTK_FLAT, VTK_GOURAUD), false },
};
}

INSTANTIATE_TEST_SUITE_P(Each, CullerSharedState, testing::ValuesIn(Sharings), GetCaseName);
