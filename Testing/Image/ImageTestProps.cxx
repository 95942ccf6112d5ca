// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Props of every kind: which are tested, which are drawn as usual, and with which verdict.
#include "CompositeMapper.h"
#include "CullerTest.h"
#include "SceneProps.h"
#include "Scenes.h"

#include "vtkAxesActor.h"
#include "vtkDataSetMapper.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPropAssembly.h"
#include "vtkProperty.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

using Scenes::Wall;
using namespace TestScene;

namespace
{
/// A box behind the wall, which the camera cannot see, with something changed.
vtkSmartPointer<vtkProp> MakeHidden(const std::function<void(Prop&)>& change = [](Prop&) {})
{
  TestScene::SceneBuilder scene;
  Prop& prop = scene.Box({ 1.0, 0.5, -3.0 }, { 1.0, 1.0, 1.0 });
  change(prop);
  return TestScene::MakeProp(prop, nullptr);
}

struct Kind : NamedCase
{
  std::function<vtkSmartPointer<vtkProp>()> Make;
  Verdict Expected;
  /// Something of it shows although it stands behind the wall (overlays, depth offsets).
  bool StockReference = false;
};

using Make = std::function<vtkSmartPointer<vtkProp>()>;

/// The box as a scenario describes it, changed.
Make As(const std::function<void(Prop&)>& change)
{
  return [change] { return MakeHidden(change); };
}

Make As(PropKind kind)
{
  return As([kind](Prop& prop) { prop.Kind = kind; });
}

/// The box, whose actor is changed.
Make With(const std::function<void(vtkActor*)>& change, PropKind kind = PropKind::Actor)
{
  return [change, kind]
  {
    vtkSmartPointer<vtkProp> prop = As(kind)();
    change(vtkActor::SafeDownCast(prop));
    return prop;
  };
}

class CullerKinds : public testing::TestWithParam<Kind>
{
protected:
  void TearDown() override { vtkMapper::SetResolveCoincidentTopologyToDefault(); }
};
}

// Hazard: a prop that draws outside of its bounds is culled because of its bounds; or a plain one
// is not culled, and its verdict does not say why.
TEST_P(CullerKinds, BehindTheWall)
{
  const Kind& kind = this->GetParam();
  ComparisonOptions options;
  options.StockReference = kind.StockReference;
  Comparison comparison(
    [&kind](Stage& stage)
    {
      Scenes::BuildWall(stage);
      // Before and after others in the list: in its slot nothing may be lost.
      stage.Add(kind.Make());
      Scenes::AddBox(stage, 0.0, 0.5, -5.0, 0.5, 0.5, 0.5);
      stage.Add(kind.Make());
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    options);
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(comparison, i < 3 ? 0.1 * i : 9.0);
    // In the first frame the default culler ran before ours and dropped what has no bounds.
    if (i == 1 || i == 2)
    {
      EXPECT_EQ(comparison.GetVerdict(Wall::Count), kind.Expected);
      EXPECT_EQ(comparison.GetVerdict(Wall::Count + 2), kind.Expected);
      EXPECT_EQ(comparison.GetStatistics().GetCount(kind.Expected) >= 2, true);
      EXPECT_GE(comparison.GetHidden(), Wall::Hidden) << "the others are hidden as ever";
    }
  }
  // And the wall away: now it must show.
  comparison.Both([](Stage& stage) { stage.Props[Wall::Index]->VisibilityOff(); });
  comparison.Frame(
    "without the wall", [](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer()); });
  EXPECT_NE(comparison.GetVerdict(Wall::Count), Verdict::Hidden);
}

// Hazard: VTK draws selected cells nearer to the eye than they are, and goes on to do so after the
// mapper has lost its selection.
TEST(CullerSelections, AreDrawnUntilTheMapperForgetsThem)
{
  const auto build = [](Stage& stage)
  {
    Scenes::BuildWall(stage);
    stage.Add(MakeHidden());
    Scenes::SetWallCamera(stage.GetRenderer());
  };
  Comparison comparison(build);
  const auto mark = [&comparison](double cells)
  {
    comparison.Both(
      [cells](Stage& stage) {
        ChangeProp(stage.Props[Wall::Count], Prop(), { 0, ChangeKind::MarkedCells, 0, { cells } });
      });
  };
  const auto renderThrice = [&]
  {
    Scenes::FramesOfWall(comparison, { 0.0, 0.1, 0.2 });
    return comparison.GetVerdict(Wall::Count);
  };
  EXPECT_EQ(renderThrice(), Verdict::Hidden);
  mark(6.0);
  EXPECT_EQ(renderThrice(), Verdict::NotASurface);
  mark(0.0);
  EXPECT_EQ(renderThrice(), Verdict::NotASurface);
}

namespace
{
vtkSmartPointer<vtkProp> MakeDataSetActor()
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, -3.0);
  points->InsertNextPoint(1.0, 0.0, -3.0);
  points->InsertNextPoint(0.0, 1.0, -3.0);
  points->InsertNextPoint(0.0, 0.0, -4.0);
  grid->SetPoints(points);
  const vtkIdType corners[4] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(grid);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkProp> MakePointGaussian()
{
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(Scenes::MakeBox({ 1.0, 0.5, -3.0 }, { 1.0, 1.0, 1.0 }));
  mapper->SetScaleFactor(0.0);
  mapper->EmissiveOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkProp> MakeImageActor()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(9, 8, 1);
  image->SetSpacing(0.25, 0.25, 0.25);
  image->SetOrigin(-1.0, -1.0, -3.5);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 9 * 8, '\x80');
  auto actor = vtkSmartPointer<vtkImageActor>::New();
  actor->SetInputData(image);
  return actor;
}

vtkSmartPointer<vtkProp> MakePropAssembly()
{
  auto assembly = vtkSmartPointer<vtkPropAssembly>::New();
  assembly->AddPart(MakeHidden());
  return assembly;
}

/// Draws an actor, but says nothing about where.
class PropWithoutBounds : public vtkProp
{
public:
  static PropWithoutBounds* New();
  vtkTypeMacro(PropWithoutBounds, vtkProp);
  double* GetBounds() override { return nullptr; }
  vtkTypeBool HasOpaqueGeometry() override { return 1; }
  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    return this->Actor->RenderOpaqueGeometry(viewport);
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Actor->ReleaseGraphicsResources(window);
  }

private:
  vtkSmartPointer<vtkProp> Actor = MakeHidden();
};
vtkStandardNewMacro(PropWithoutBounds);

const Kind Kinds[] = {
  { "PlainActor", As(PropKind::Actor), Verdict::Hidden },
  // Hazard: a mirroring matrix swaps the corners of the box.
  { "MirroredActor", As([](Prop& p) { p.Scale.x = -1.0; }), Verdict::Hidden },
  // Hazard: the box of a sheared prop is larger than the prop's own.
  { "ShearedActor",
    As(
      [](Prop& p) {
        p.UserMatrix = { 1, 0.7, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
      }),
    Verdict::Hidden },
  { "FlatShading", As([](Prop& p) { p.Flat = true; }), Verdict::Hidden },
  { "BackfaceProperty",
    With([](vtkActor* a) { a->SetBackfaceProperty(vtkSmartPointer<vtkProperty>::New()); }),
    Verdict::Hidden },
  { "DataSetMapper", MakeDataSetActor, Verdict::Hidden },
  // Hazard: one prop is many blocks, some of them invisible.
  { "CompositeMapper",
    With([](vtkActor* a)
      { CompositeMapper::SafeDownCast(a->GetMapper())->SetBlockVisibility(2, false); },
      PropKind::Composite),
    Verdict::Hidden },
  // Hazard: one prop is drawn in the opaque and in the translucent stage.
  { "CompositeWithTranslucentBlock",
    With([](vtkActor* a)
      { CompositeMapper::SafeDownCast(a->GetMapper())->SetBlockOpacity(2, 0.5); },
      PropKind::Composite),
    Verdict::Hidden },
  // Hazard: what a clipping plane leaves is smaller than the bounds.
  { "ClippingPlane",
    As(
      [](Prop& p) {
        p.ClippingPlane = { 1.0, 0.5, -3.0, 1.0, 0.5, 0.0 };
      }),
    Verdict::Hidden },
  // Hazard: the texels alone make a prop translucent.
  { "TextureWithAlpha", As([](Prop& p) { p.Texture = Translucency::Some; }), Verdict::Hidden },
  { "Opacity", As([](Prop& p) { p.Opacity = 0.4; }), Verdict::Hidden },
  { "ForceTranslucent", As([](Prop& p) { p.ForceTranslucent = true; }), Verdict::Hidden },
  { "TranslucentScalars", As([](Prop& p) { p.Scalars = Translucency::Some; }), Verdict::Hidden },
  { "Wireframe", As([](Prop& p) { p.Representation = Representation::Wireframe; }),
    Verdict::NotASurface },
  { "Points", As([](Prop& p) { p.Representation = Representation::Points; }),
    Verdict::NotASurface },
  { "EdgeVisibility", As([](Prop& p) { p.Edges = true; }),
    VTKNBUFFER_EDGES_KEEP_TRIANGLES ? Verdict::Hidden : Verdict::NotASurface },
  { "VertexVisibility", As([](Prop& p) { p.Vertices = true; }), Verdict::NotASurface },
  { "SpheresForPoints",
    As(
      [](Prop& p)
      {
        p.Spheres = true;
        p.Representation = Representation::Points;
        p.PointSize = 20.0;
      }),
    Verdict::NotASurface },
  { "TubesForLines",
    As(
      [](Prop& p)
      {
        p.Tubes = true;
        p.Representation = Representation::Wireframe;
        p.LineWidth = 10.0;
      }),
    Verdict::NotASurface },
  // vedo gives all its meshes spheres for points. A surface without points has none to draw.
  { "SpheresAndTubesWithoutPointsAndLines", As([](Prop& p) { p.Spheres = p.Tubes = true; }),
    Verdict::Hidden },
  // Hazard: points in the data stick out of its bounds as spheres, and lines as tubes.
  { "SpheresForPointsInTheData",
    As(
      [](Prop& p)
      {
        p.Shape.Kind = ShapeKind::Points;
        p.Spheres = true;
        p.PointSize = 20.0;
      }),
    Verdict::NotASurface },
  { "TubesForLinesInTheData",
    As(
      [](Prop& p)
      {
        p.Shape.Kind = ShapeKind::Lines;
        p.Tubes = true;
        p.LineWidth = 10.0;
      }),
    Verdict::NotASurface },
  { "DepthOffset",
    As(
      [](Prop& p)
      {
        vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
        p.OffsetUnits = -9000.0;
      }),
    Verdict::DepthOffset },
  // ParaView pushes all surfaces away from the eye like this. No block has lines, which VTK would
  // pull towards it.
  { "CompositeWithOffsetAwayFromTheEye",
    With([](vtkActor*) { vtkMapper::SetResolveCoincidentTopologyToPolygonOffset(); },
      PropKind::Composite),
    Verdict::Hidden },
  { "VertexShaderReplaced", As([](Prop& p) { p.Shader = Shader::MovesVertices; }),
    Verdict::ShaderReplaced },
  { "FragmentShaderReplaced", As([](Prop& p) { p.Shader = Shader::WritesDepth; }),
    Verdict::ShaderReplaced },
#if VTKNBUFFER_HAS_COORDINATE_SYSTEMS
  { "DeviceCoordinates", With([](vtkActor* a) { a->SetCoordinateSystemToDevice(); }),
    Verdict::OtherCoordinates },
#endif
  // Hazard: the bounds of a glyph mapper need not hold its glyphs.
  { "GlyphMapper", As(PropKind::Glyphs), Verdict::NotAPlainMapper },
  { "PointGaussianMapper", MakePointGaussian, Verdict::NotAPlainMapper },
  { "NoMapper", As(PropKind::NoMapper), Verdict::NotAPlainMapper },
  // Hazard: a follower has turned since its bounds were computed.
  { "Follower", As(PropKind::Follower), Verdict::NotAPlainActor },
  // Hazard: an assembly draws its parts with a matrix that they do not know.
  { "Assembly",
    As(
      [](Prop& p)
      {
        p.Kind = PropKind::Assembly;
        p.Position.x = -2.0;
      }),
    Verdict::NotAPlainActor },
  // Hazard: an assembly that is no vtkProp3D.
  { "PropAssembly", MakePropAssembly, Verdict::NotAPlainActor },
  // Hazard: the bounds are those of the level drawn last.
  { "LODProp", As(PropKind::LOD), Verdict::NotAPlainActor },
  { "AxesActor", [] { return vtkSmartPointer<vtkAxesActor>::New(); }, Verdict::NotAPlainActor },
  // Hazard: a volume is blended and writes no depth.
  { "Volume", As(PropKind::Volume), Verdict::NotAPlainActor },
  { "ImageActor", MakeImageActor, Verdict::NotAPlainActor },
  // Hazard: a text in space is as large as its pixels, whatever its bounds.
  { "Billboard",
    As(
      [](Prop& p)
      {
        p.Kind = PropKind::Billboard;
        p.Position.z = -3.0;
      }),
    Verdict::NotAPlainActor },
  // Hazard: a 2-D actor has no bounds and no depth.
  { "Text2D", As(PropKind::Text), Verdict::NotAPlainActor },
  // Hazard: a prop that has no bounds at all.
  { "NullBounds", [] { return vtkSmartPointer<PropWithoutBounds>::New(); },
    Verdict::NotAPlainActor },
  // Hazard: the bounds of a mapper without points are not initialised.
  { "EmptyData", As([](Prop& p) { p.Shape.Kind = ShapeKind::Empty; }), Verdict::NoBounds, true },
  // VTK's bounds leave NaN out, as does the device: a face with such a point is not drawn.
  { "NaNPoint", As([](Prop& p) { p.Shape.Kind = ShapeKind::NaNPoint; }), Verdict::Hidden, true },
  { "InfinitePoint",
    As(
      [](Prop& p)
      {
        p.Shape.Kind = ShapeKind::NaNPoint;
        p.Shape.Seed = 1;
      }),
    Verdict::NoBounds, true },
};
}

INSTANTIATE_TEST_SUITE_P(Each, CullerKinds, testing::ValuesIn(Kinds), GetCaseName);
