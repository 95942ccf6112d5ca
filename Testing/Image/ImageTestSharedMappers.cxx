// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Actors that share a mapper: VTK makes the shaders of a mapper for the actor that it draws first.
#include "CompositeMapper.h"
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkCellData.h"
#include "vtkDataSetMapper.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"

#include <functional>
#include <string>
#include <tuple>

namespace
{
/// A sphere with all that shaders read: normals and texture coordinates of points, colours of
/// cells.
vtkSmartPointer<vtkPolyData> MakeColoredSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(12);
  source->SetPhiResolution(9);
  source->Update();
  vtkSmartPointer<vtkPolyData> data = source->GetOutput();
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    coordinates->InsertNextTuple2(0.37 * static_cast<double>(i), 0.11 * static_cast<double>(i));
  }
  data->GetPointData()->SetTCoords(coordinates);
  vtkNew<vtkFloatArray> scalars;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(i % 7) / 7.0F);
  }
  data->GetCellData()->SetScalars(scalars);
  return data;
}

template <typename MapperType>
vtkSmartPointer<vtkMapper> MakeMapper()
{
  vtkNew<MapperType> mapper;
  mapper->SetInputData(MakeColoredSphere());
  return mapper.Get();
}

vtkSmartPointer<vtkMapper> MakeCompositeMapper()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeColoredSphere());
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  return mapper.Get();
}

vtkSmartPointer<vtkTexture> MakeTexture(bool isRed)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* colors = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 48; ++i)
  {
    colors[i] = static_cast<unsigned char>((i % 3 == 0) == isRed ? 255 - 5 * i : 0);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

struct SharedWay : NamedCase
{
  std::function<void(vtkActor*)> Change;
  bool Matters = true; ///< False for what VTK sets anew for each actor.
  bool All = false;    ///< All props are drawn: other parameters of the shaders are set.
};

struct MapperKind : NamedCase
{
  vtkSmartPointer<vtkMapper> (*Make)();
};

/// An actor of a class of the application.
class OwnSharedActor : public vtkOpenGLActor
{
public:
  static OwnSharedActor* New();
  vtkTypeMacro(OwnSharedActor, vtkOpenGLActor);
};
vtkStandardNewMacro(OwnSharedActor);

/// A far and a near actor with one mapper, in this order, side by side among other props. The
/// nearest prop is drawn first, so that what the culler holds back is drawn in the other order.
template <typename NearActor = vtkActor>
void BuildPair(Stage& stage, const MapperKind& kind, const std::function<void(vtkActor*)>& change)
{
  Scenes::BuildWall(stage);
  const vtkSmartPointer<vtkMapper> mapper = kind.Make();
  for (const bool isNear : { false, true })
  {
    const auto actor = vtkSmartPointer<vtkActor>::Take(
      isNear ? static_cast<vtkActor*>(NearActor::New()) : vtkActor::New());
    actor->SetMapper(mapper);
    actor->SetScale(2.5);
    actor->SetPosition(isNear ? 1.5 : -1.5, 0.3, isNear ? 9.0 : 4.0);
    if (isNear)
    {
      change(actor);
    }
    stage.Add(actor);
  }
  Scenes::SetWallCamera(stage.GetRenderer());
}

using CullerSharedMappers = testing::TestWithParam<std::tuple<SharedWay, MapperKind>>;
}

// Hazard: the culler draws actors in another order than the renderer. Where actors with one mapper
// need different shaders, whole faces change.
TEST_P(CullerSharedMappers, KeepTheirOrder)
{
  const auto& [way, kind] = this->GetParam();
  ComparisonOptions options;
  options.Tuning.RoundSize = 1;
  Comparison comparison(
    [&way = way, &kind = kind](Stage& stage) { BuildPair(stage, kind, way.Change); }, options);
  const int first = static_cast<int>(comparison.Culled.Props.size()) - 2;
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.1 * i);
    EXPECT_EQ(comparison.GetVerdict(first), way.Matters ? Verdict::SharedMapper : Verdict::Visible);
    // Drawing for the first time changes mappers.
    const bool hasChanged = way.Matters && i < 2;
    EXPECT_EQ(
      comparison.GetDecision(), way.All || hasChanged ? Decision::Blending : Decision::Culled);
    EXPECT_EQ(comparison.GetVerdict(0),
      way.All        ? Verdict::SharedMapper
        : hasChanged ? Verdict::Untested
                     : Verdict::Visible);
  }
  comparison.Frame("alike again",
    [](Stage& stage)
    {
      auto* actor = stage.GetActor(static_cast<int>(stage.Props.size()) - 1);
      vtkNew<vtkProperty> plain;
      actor->SetProperty(plain);
      actor->SetBackfaceProperty(nullptr);
    });
  // The second actor has a new property, so that the frame before has made the shaders anew. (Those
  // of vertices are only made where VTK draws vertices, and of composite data nothing is known.)
  Scenes::FrameOfWall(comparison, 0.6, "shaders made");
  const bool isUnknown = way.Matters && kind.Name == std::string("Composite");
  if (way.Name != std::string("Vertices"))
  {
    EXPECT_EQ(comparison.GetVerdict(first), isUnknown ? Verdict::SharedMapper : Verdict::Visible);
    EXPECT_EQ(
      comparison.GetDecision(), isUnknown && way.All ? Decision::Blending : Decision::Culled);
  }
}

// Hazard: an actor of another class begins to draw the mapper of a plain one in another way.
TEST(CullerOwnActors, ThatShareAMapperAreFollowed)
{
  const MapperKind kind = { { "PolyData" }, MakeMapper<vtkPolyDataMapper> };
  ComparisonOptions options;
  options.Tuning.RoundSize = 1;
  options.CompareDraws = false; // They are counted by mapper.
  Comparison comparison(
    [&kind](Stage& stage) { BuildPair<OwnSharedActor>(stage, kind, [](vtkActor*) {}); }, options);
  const int first = static_cast<int>(comparison.Culled.Props.size()) - 2;
  Scenes::FrameOfWall(comparison, 0.0, "first draw");
  EXPECT_EQ(comparison.GetVerdict(first), Verdict::SharedMapper) << "the other one may be older";
  Scenes::FrameOfWall(comparison, 0.1, "alike");
  EXPECT_EQ(comparison.GetVerdict(first), Verdict::Visible);
  const auto getLast = [](Stage& stage)
  { return stage.GetActor(static_cast<int>(stage.Props.size()) - 1); };
  comparison.Both([&](Stage& stage) { getLast(stage)->GetProperty()->SetInterpolationToFlat(); });
  Scenes::FrameOfWall(comparison, 0.2, "another property");
  EXPECT_EQ(comparison.GetVerdict(first), Verdict::SharedMapper);
  comparison.Both(
    [&](Stage& stage) { getLast(stage)->SetMapper(MakeMapper<vtkPolyDataMapper>()); });
  Scenes::FrameOfWall(comparison, 0.4, "another mapper");
  EXPECT_EQ(comparison.GetVerdict(first), Verdict::SharedMapper) << "its shaders may be flat";
  comparison.Both([first](Stage& stage) { stage.GetActor(first)->GetProperty()->Modified(); });
  Scenes::FrameOfWall(comparison, 0.6, "shaders made");
  Scenes::FrameOfWall(comparison, 0.8);
  EXPECT_EQ(comparison.GetVerdict(first), Verdict::Visible);
}

// A prop whose first draw is due says why it would be drawn anyway.
TEST(CullerOwnActors, FirstDrawsHideNoOtherReason)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      vtkNew<vtkActor> actor;
      actor->SetMapper(MakeMapper<vtkPolyDataMapper>());
      actor->SetPosition(0.0, 0.3, 6.0);
      stage.Add(actor);
      Scenes::SetWallCamera(stage.GetRenderer());
    });
  const int first = static_cast<int>(comparison.Culled.Props.size()) - 1;
  Scenes::FrameOfWall(comparison, 0.0);
  comparison.Both(
    [first](Stage& stage)
    {
      vtkNew<vtkActor> actor;
      actor->SetMapper(stage.GetActor(first)->GetMapper());
      actor->GetProperty()->SetRepresentationToWireframe();
      stage.Add(actor);
    });
  Scenes::FrameOfWall(comparison, 0.1);
  EXPECT_EQ(comparison.GetVerdict(first), Verdict::SharedMapper);
  EXPECT_EQ(comparison.GetVerdict(first + 1), Verdict::NotASurface);
}

// Hazard: an actor that has lost its texture is drawn by the shaders that read it, and shows what
// another prop has left in the texture unit.
TEST(CullerOwnActors, LostTexture)
{
  ComparisonOptions options;
  options.Tuning.RoundSize = 1;
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      for (const bool isHidden : { true, false })
      {
        vtkNew<vtkActor> actor;
        actor->SetMapper(MakeMapper<vtkPolyDataMapper>());
        actor->GetMapper()->ScalarVisibilityOff();
        actor->SetScale(isHidden ? 1.0 : 2.5);
        actor->SetPosition(0.0, 0.3, isHidden ? -8.0 : 6.0);
        actor->SetTexture(MakeTexture(isHidden));
        stage.Add(actor);
      }
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    options);
  const int last = static_cast<int>(comparison.Culled.Props.size()) - 1;
  const auto walk = [&comparison, last](Verdict verdict, const char* name)
  {
    for (int i = 0; i < 3; ++i)
    {
      Scenes::FrameOfWall(comparison, 0.02 * i, name);
    }
    EXPECT_EQ(comparison.GetVerdict(last - 1), verdict) << name;
  };
  walk(Verdict::Hidden, "textures");
  comparison.Both([last](Stage& stage) { stage.GetActor(last)->SetTexture(MakeTexture(true)); });
  walk(Verdict::Hidden, "another texture");
  comparison.Both([last](Stage& stage) { stage.GetActor(last)->SetTexture(nullptr); });
  walk(Verdict::SharedMapper, "lost texture");
  comparison.Both([last](Stage& stage) { stage.GetActor(last)->GetProperty()->Modified(); });
  walk(Verdict::Hidden, "shaders made");
}

namespace
{
// Textures and visible edges are missing: where only one of two actors with a mapper has them, VTK
// itself makes OpenGL errors.
const SharedWay SharedWays[] = {
  { "Wireframe", [](vtkActor* a) { a->GetProperty()->SetRepresentationToWireframe(); } },
  { "Points", [](vtkActor* a) { a->GetProperty()->SetRepresentationToPoints(); } },
  { "Vertices", [](vtkActor* a) { a->GetProperty()->VertexVisibilityOn(); } },
  { "Flat", [](vtkActor* a) { a->GetProperty()->SetInterpolationToFlat(); } },
  { "Physical", [](vtkActor* a) { a->GetProperty()->SetInterpolationToPBR(); }, true, true },
  { "WideLines", [](vtkActor* a) { a->GetProperty()->SetLineWidth(3.0F); }, true, true },
  { "Unlit", [](vtkActor* a) { a->GetProperty()->LightingOff(); } },
  { "Backface",
    [](vtkActor* a)
    {
      vtkNew<vtkProperty> property;
      property->SetColor(1.0, 0.0, 0.0);
      a->SetBackfaceProperty(property);
      a->GetProperty()->FrontfaceCullingOn();
    } },
  { "Color", [](vtkActor* a) { a->GetProperty()->SetColor(0.9, 0.2, 0.1); }, false },
  { "Specular", [](vtkActor* a) { a->GetProperty()->SetSpecular(0.7); }, false },
  { "Place", [](vtkActor* a) { a->SetOrientation(10.0, 20.0, 30.0); }, false },
};

const MapperKind MapperKinds[] = { { "PolyData", MakeMapper<vtkPolyDataMapper> },
  { "DataSet", MakeMapper<vtkDataSetMapper> }, { "Composite", MakeCompositeMapper } };
}

struct HiddenSharer : NamedCase
{
  bool IsAddedLater;
  double X; ///< 0 behind the wall.
};

using CullerHiddenSharers = testing::TestWithParam<std::tuple<HiddenSharer, MapperKind>>;

// Hazard: VTK makes the shader property of an actor at its first draw, and a new one makes the
// mapper rebuild its shaders. If a hidden actor is drawn for the first time because it has just got
// a backface, the next actor of the mapper lacks the property that these shaders need, and VTK
// crashes.
TEST_P(CullerHiddenSharers, GetABackface)
{
  const auto& [sharer, kind] = this->GetParam();
  const auto add = [x = sharer.X](Stage& stage, vtkMapper* mapper, bool isHidden)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetScale(isHidden ? 1.0 : 2.5);
    actor->SetPosition(isHidden ? x : 0.0, 0.3, isHidden ? -8.0 : 6.0);
    stage.Add(actor);
  };
  ComparisonOptions options;
  options.Tuning.RoundSize = 1;
  options.CompareDraws = false;      // They are counted by mapper.
  options.KeepDefaultCuller = false; // It leaves out what is outside.
  Comparison comparison(
    [&, isAddedLater = sharer.IsAddedLater, &kind = kind](Stage& stage)
    {
      Scenes::BuildWall(stage);
      const vtkSmartPointer<vtkMapper> mapper = kind.Make();
      mapper->ScalarVisibilityOff(); // Scalars replace the colors of backfaces.
      if (!isAddedLater)
      {
        add(stage, mapper, true);
      }
      add(stage, mapper, false);
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    options);
  Scenes::FramesOfWall(comparison, { 0.0, 0.1, 0.2 });
  int hidden = static_cast<int>(comparison.Culled.Props.size()) - 2;
  if (sharer.IsAddedLater)
  {
    comparison.Both([&, last = hidden + 1](Stage& stage)
      { add(stage, stage.GetActor(last)->GetMapper(), true); });
    hidden += 2;
    Scenes::FrameOfWall(comparison, 0.3, "first draw");
    EXPECT_EQ(comparison.GetVerdict(hidden), Verdict::SharedMapper);
    Scenes::FramesOfWall(comparison, { 0.4, 0.5 });
  }
  EXPECT_EQ(comparison.GetVerdict(hidden), sharer.X == 0.0 ? Verdict::Hidden : Verdict::Outside);
  comparison.Both(
    [hidden](Stage& stage)
    {
      vtkNew<vtkProperty> property;
      property->SetColor(1.0, 0.0, 0.0);
      stage.GetActor(hidden)->SetBackfaceProperty(property);
    });
  Scenes::FramesOfWall(comparison, { 0.5, 0.6 });
  EXPECT_EQ(comparison.GetVerdict(hidden), Verdict::SharedMapper);
  comparison.Both(
    [hidden](Stage& stage)
    {
      stage.GetActor(hidden)->SetPosition(0.0, 0.3, -8.0);
      stage.GetActor(Scenes::Wall::Index)->VisibilityOff();
    });
  Scenes::FramesOfWall(comparison, { 0.6, 0.7 });
}

const HiddenSharer HiddenSharers[] = { { { "BehindTheWall" }, false, 0.0 },
  { { "Outside" }, false, 1000.0 }, { { "AddedBehindTheWall" }, true, 0.0 },
  { { "AddedOutside" }, true, 1000.0 } };

INSTANTIATE_TEST_SUITE_P(Each, CullerHiddenSharers,
  testing::Combine(testing::ValuesIn(HiddenSharers), testing::ValuesIn(MapperKinds)),
  [](const testing::TestParamInfo<CullerHiddenSharers::ParamType>& info)
  { return std::string(std::get<0>(info.param).Name) + std::get<1>(info.param).Name; });

INSTANTIATE_TEST_SUITE_P(Each, CullerSharedMappers,
  testing::Combine(testing::ValuesIn(SharedWays), testing::ValuesIn(MapperKinds)),
  [](const testing::TestParamInfo<CullerSharedMappers::ParamType>& info)
  { return std::string(std::get<0>(info.param).Name) + std::get<1>(info.param).Name; });
