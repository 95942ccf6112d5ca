// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Props of every kind: who is tested, who is drawn as usual, and under which verdict.
#include "CompositeMapper.h"
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkAssembly.h"
#include "vtkAxesActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataSetMapper.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkImageProperty.h"
#include "vtkLODProp3D.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropAssembly.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <limits>

using Verdict = vtkNBufferVerdict;
using Decision = vtkNBufferDecision;
using Scenes::Wall;

namespace
{
/// A box behind the wall, which the camera cannot see.
vtkSmartPointer<vtkPolyData> MakeHiddenBox()
{
  return Scenes::MakeBox({ 1.0, 0.5, -3.0 }, { 1.0, 1.0, 1.0 });
}

vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 0.8, 0.1);
  return actor;
}

vtkSmartPointer<vtkActor> MakeHidden()
{
  return MakeActor(MakeHiddenBox());
}

vtkSmartPointer<vtkImageData> MakeVolumeData()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(9, 8, 7);
  image->SetSpacing(0.25, 0.25, 0.25);
  image->SetOrigin(-1.0, -1.0, -3.5);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 9 * 8 * 7; ++i)
  {
    voxels[i] = static_cast<unsigned char>(37 * i);
  }
  return image;
}

struct Kind
{
  const char* Name;
  std::function<vtkSmartPointer<vtkProp>()> Make;
  Verdict Expected;
  /// Something of it shows although it stands behind the wall (overlays, depth offsets).
  bool StockReference = false;
};

void PrintTo(const Kind& kind, std::ostream* os)
{
  *os << kind.Name;
}

/// An actor behind the wall with one thing changed.
std::function<vtkSmartPointer<vtkProp>()> With(const std::function<void(vtkActor*)>& change)
{
  return [change]
  {
    vtkSmartPointer<vtkActor> actor = MakeHidden();
    change(actor);
    return actor;
  };
}

class CullerKinds : public testing::TestWithParam<Kind>
{
protected:
  void TearDown() override { vtkMapper::SetResolveCoincidentTopologyToDefault(); }
};
}

// Hazard: a prop whose picture is not that of its bounds is culled because of its bounds; or a
// plain one is kept, and nobody is told why.
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
    comparison.Both(
      [i](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer(), i < 3 ? 0.1 * i : 9.0); });
    comparison.Frame();
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
  comparison.Both([](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer()); });
  comparison.Frame("without the wall");
  EXPECT_NE(comparison.GetVerdict(Wall::Count), Verdict::Hidden);
}

namespace
{
vtkSmartPointer<vtkProp> MakeComposite(bool translucentBlock)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 3; ++i)
  {
    blocks->SetBlock(i, Scenes::MakeBox({ i - 1.0, 0.0, -3.0 }, { 0.5, 0.5, 0.5 }));
  }
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetBlockColor(1, 1.0, 0.0, 0.0);
  mapper->SetBlockVisibility(2, false);
  if (translucentBlock)
  {
    mapper->SetBlockOpacity(3, 0.5);
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkProp> MakeDataSetActor()
{
  vtkSmartPointer<vtkPolyData> box = MakeHiddenBox();
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

vtkSmartPointer<vtkProp> MakeVolume()
{
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputData(MakeVolumeData());
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.0, 0.2, 1.0);
  colors->AddRGBPoint(255.0, 1.0, 0.5, 0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.1);
  opacity->AddPoint(255.0, 0.9);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(opacity);
  return volume;
}

template <typename MapperType>
vtkSmartPointer<vtkProp> MakeWithMapper()
{
  vtkNew<MapperType> mapper;
  mapper->SetInputData(MakeHiddenBox());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkProp> MakeLOD()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeHiddenBox());
  auto lod = vtkSmartPointer<vtkLODProp3D>::New();
  lod->AddLOD(mapper, 0.0);
  return lod;
}

vtkSmartPointer<vtkProp> MakeAssembly()
{
  auto assembly = vtkSmartPointer<vtkAssembly>::New();
  assembly->AddPart(MakeHidden());
  assembly->SetPosition(-2.0, 0.0, 0.0);
  return assembly;
}

vtkSmartPointer<vtkProp> MakeText()
{
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->SetInput("2D");
  text->SetPosition(20, 20);
  text->GetTextProperty()->SetFontSize(24);
  return text;
}

vtkSmartPointer<vtkProp> MakeBillboard()
{
  auto text = vtkSmartPointer<vtkBillboardTextActor3D>::New();
  text->SetInput("3D");
  text->SetPosition(0.0, 0.0, -3.0);
  return text;
}

vtkSmartPointer<vtkProp> MakeImageActor()
{
  auto actor = vtkSmartPointer<vtkImageActor>::New();
  actor->SetInputData(MakeVolumeData());
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
  vtkSmartPointer<vtkActor> Actor = MakeHidden();
};
vtkStandardNewMacro(PropWithoutBounds);

/// A cut-out: half of its texels are transparent.
void AddTextureWithAlpha(vtkActor* actor)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 16; ++i)
  {
    pixels[i] = static_cast<unsigned char>(i < 8 ? 255 : 0);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  actor->SetTexture(texture);
}

void AddClippingPlane(vtkActor* actor)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(1.0, 0.5, -3.0);
  plane->SetNormal(1.0, 0.5, 0.0);
  actor->GetMapper()->AddClippingPlane(plane);
}

vtkSmartPointer<vtkProp> MakeEmpty()
{
  return MakeActor(vtkSmartPointer<vtkPolyData>::New());
}

vtkSmartPointer<vtkProp> MakeWithCoordinate(double value)
{
  vtkSmartPointer<vtkPolyData> data = MakeHiddenBox();
  data->GetPoints()->SetPoint(0, value, 0.0, -3.0);
  return MakeActor(data);
}

const Kind Kinds[] = {
  { "PlainActor", [] { return MakeHidden(); }, Verdict::Hidden },
  // Hazard: a mirroring matrix swaps the corners of the box.
  { "MirroredActor", With([](vtkActor* a) { a->SetScale(-1.0, 1.0, 1.0); }), Verdict::Hidden },
  // Hazard: the box of a sheared prop is larger than the prop's own.
  { "ShearedActor",
    With(
      [](vtkActor* a)
      {
        vtkNew<vtkMatrix4x4> shear;
        shear->SetElement(0, 1, 0.7);
        a->SetUserMatrix(shear);
      }),
    Verdict::Hidden },
  { "FlatShading", With([](vtkActor* a) { a->GetProperty()->SetInterpolationToFlat(); }),
    Verdict::Hidden },
  { "BackfaceProperty",
    With([](vtkActor* a) { a->SetBackfaceProperty(vtkSmartPointer<vtkProperty>::New()); }),
    Verdict::Hidden },
  { "DataSetMapper", MakeDataSetActor, Verdict::Hidden },
  // Hazard: one prop is many blocks, some of them invisible.
  { "CompositeMapper", [] { return MakeComposite(false); }, Verdict::Hidden },
  // Hazard: one prop is drawn in the opaque and in the translucent stage.
  { "CompositeWithTranslucentBlock", [] { return MakeComposite(true); }, Verdict::Hidden },
  // Hazard: what a clipping plane leaves is smaller than the bounds.
  { "ClippingPlane", With(AddClippingPlane), Verdict::Hidden },
  // Hazard: the texels alone make a prop translucent.
  { "TextureWithAlpha", With(AddTextureWithAlpha), Verdict::Hidden },
  { "Opacity", With([](vtkActor* a) { a->GetProperty()->SetOpacity(0.4); }), Verdict::Hidden },
  { "ForceTranslucent", With([](vtkActor* a) { a->ForceTranslucentOn(); }), Verdict::Hidden },
  { "TranslucentScalars",
    With(
      [](vtkActor* a)
      {
        auto* data = vtkPolyData::SafeDownCast(a->GetMapper()->GetInput());
        vtkNew<vtkUnsignedCharArray> colors;
        colors->SetNumberOfComponents(4);
        for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
        {
          colors->InsertNextTuple4(200, 100, 50, 90);
        }
        data->GetPointData()->SetScalars(colors);
      }),
    Verdict::Hidden },
  { "Wireframe", With([](vtkActor* a) { a->GetProperty()->SetRepresentationToWireframe(); }),
    Verdict::NotASurface },
  { "Points", With([](vtkActor* a) { a->GetProperty()->SetRepresentationToPoints(); }),
    Verdict::NotASurface },
  { "EdgeVisibility", With([](vtkActor* a) { a->GetProperty()->EdgeVisibilityOn(); }),
    Verdict::NotASurface },
  { "VertexVisibility", With([](vtkActor* a) { a->GetProperty()->VertexVisibilityOn(); }),
    Verdict::NotASurface },
  { "SpheresForPoints",
    With(
      [](vtkActor* a)
      {
        a->GetProperty()->RenderPointsAsSpheresOn();
        a->GetProperty()->SetRepresentationToPoints();
        a->GetProperty()->SetPointSize(20.0);
      }),
    Verdict::NotASurface },
  { "TubesForLines",
    With(
      [](vtkActor* a)
      {
        a->GetProperty()->RenderLinesAsTubesOn();
        a->GetProperty()->SetRepresentationToWireframe();
        a->GetProperty()->SetLineWidth(10.0);
      }),
    Verdict::NotASurface },
  { "DepthOffset",
    With(
      [](vtkActor* a)
      {
        vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
        a->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, -9000.0);
      }),
    Verdict::DepthOffset },
  { "VertexShaderReplaced",
    With(
      [](vtkActor* a)
      {
        a->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
          "//VTK::PositionVC::Impl\n gl_Position.y += 0.7 * gl_Position.w;\n", false);
      }),
    Verdict::ShaderReplaced },
  { "FragmentShaderReplaced",
    With(
      [](vtkActor* a)
      {
        a->GetShaderProperty()->AddFragmentShaderReplacement(
          "//VTK::Light::Impl", true, "//VTK::Light::Impl\n gl_FragDepth = 0.0;\n", false);
      }),
    Verdict::ShaderReplaced },
#if VTKNBUFFER_HAS_COORDINATE_SYSTEMS
  { "DeviceCoordinates", With([](vtkActor* a) { a->SetCoordinateSystemToDevice(); }),
    Verdict::OtherCoordinates },
#endif
  // Hazard: the bounds of a glyph mapper need not hold its glyphs.
  { "GlyphMapper",
    []
    {
      vtkNew<vtkGlyph3DMapper> mapper;
      mapper->SetInputData(MakeHiddenBox());
      mapper->SetSourceData(MakeHiddenBox());
      auto actor = vtkSmartPointer<vtkActor>::New();
      actor->SetMapper(mapper);
      return actor;
    },
    Verdict::NotAPlainMapper },
  { "PointGaussianMapper",
    []
    {
      vtkSmartPointer<vtkProp> prop = MakeWithMapper<vtkPointGaussianMapper>();
      auto* actor = vtkActor::SafeDownCast(prop);
      vtkPointGaussianMapper::SafeDownCast(actor->GetMapper())->SetScaleFactor(0.0);
      return prop;
    },
    Verdict::NotAPlainMapper },
  { "NoMapper", [] { return vtkSmartPointer<vtkActor>::New(); }, Verdict::NotAPlainMapper },
  // Hazard: a follower has turned since its bounds were asked.
  { "Follower",
    []
    {
      auto follower = vtkSmartPointer<vtkFollower>::New();
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(MakeHiddenBox());
      follower->SetMapper(mapper);
      return follower;
    },
    Verdict::NotAPlainActor },
  // Hazard: an assembly draws its parts with a matrix that they do not know.
  { "Assembly", MakeAssembly, Verdict::NotAPlainActor },
  // Hazard: an assembly that is no vtkProp3D.
  { "PropAssembly", MakePropAssembly, Verdict::NotAPlainActor },
  // Hazard: the bounds are those of the level drawn last.
  { "LODProp", MakeLOD, Verdict::NotAPlainActor },
  { "AxesActor", [] { return vtkSmartPointer<vtkAxesActor>::New(); }, Verdict::NotAPlainActor },
  // Hazard: a volume is blended and writes no depth.
  { "Volume", MakeVolume, Verdict::NotAPlainActor },
  { "ImageActor", MakeImageActor, Verdict::NotAPlainActor },
  // Hazard: a text in space is as large as its pixels, whatever its bounds.
  { "Billboard", MakeBillboard, Verdict::NotAPlainActor },
  // Hazard: a 2-D actor has no bounds and no depth.
  { "Text2D", MakeText, Verdict::NotAPlainActor },
  // Hazard: a prop that has no bounds at all.
  { "NullBounds", [] { return vtkSmartPointer<PropWithoutBounds>::New(); },
    Verdict::NotAPlainActor },
  // Hazard: the bounds of a mapper without points are not initialised.
  { "EmptyData", MakeEmpty, Verdict::NoBounds, true },
  // VTK's bounds leave NaN out, as does the device: a face with such a point is not drawn.
  { "NaNPoint", [] { return MakeWithCoordinate(std::nan("")); }, Verdict::Hidden, true },
  { "InfinitePoint", [] { return MakeWithCoordinate(std::numeric_limits<double>::infinity()); },
    Verdict::NoBounds, true },
};
}

INSTANTIATE_TEST_SUITE_P(Each, CullerKinds, testing::ValuesIn(Kinds),
  [](const testing::TestParamInfo<Kind>& info) { return std::string(info.param.Name); });
