// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Props that show, or read, what the opaque stage has drawn before them: shaders, images, texts
// and labels.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkActor2D.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkLabeledContourMapper.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkSelectVisiblePoints.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkShaderProperty.h"
#include "vtkSkybox.h"
#include "vtkTextActor3D.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#if __has_include("vtkFlagpoleLabel.h")
#define VTKNBUFFER_TEST_HAS_FLAGPOLES 1
#include "vtkFlagpoleLabel.h"
#endif
#if VTKNBUFFER_TEST_HAS_RENDERINGIMAGE
#include "vtkImageResliceMapper.h"
#include "vtkImageStack.h"
#endif
#if VTKNBUFFER_TEST_HAS_RENDERINGLABEL
#include "vtkLabelPlacementMapper.h"
#include "vtkLabeledDataMapper.h"
#include "vtkPointSetToLabelHierarchy.h"
#if __has_include("vtkBatchedLabeledDataMapper.h")
#define VTKNBUFFER_TEST_HAS_BATCHED_LABELS 1
#include "vtkBatchedLabeledDataMapper.h"
#endif
#endif

#include <functional>
#include <string>

using Scenes::Wall;

namespace
{
using Make = std::function<vtkSmartPointer<vtkProp>(vtkRenderer*)>;

struct Ordered : NamedCase
{
  Make MakeProp; ///< Returns nullptr if this VTK has no such class.
  bool NeedsOrder = true;
};

/// An image of 16 x 12 pixels in front of the wall, as large as the wall.
vtkSmartPointer<vtkImageData> MakeImage(int components = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(16, 12, 1);
  image->SetSpacing(0.9, 0.8, 1.0);
  image->SetOrigin(-6.8, -4.4, 6.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 16 * 12 * components; ++i)
  {
    value[i] = static_cast<unsigned char>(7 * i);
  }
  return image;
}

/// A slice that is not in the translucent stage, changed.
Make Slice(const std::function<void(vtkImageSlice*)>& change, int components = 1)
{
  return [change, components](vtkRenderer*)
  {
    vtkNew<vtkImageSliceMapper> mapper;
    mapper->SetInputData(MakeImage(components));
    auto slice = vtkSmartPointer<vtkImageSlice>::New();
    slice->SetMapper(mapper);
    change(slice);
    return slice;
  };
}

/// A pane in front of the wall, changed.
Make Pane(const std::function<void(vtkActor*)>& change)
{
  return [change](vtkRenderer*)
  {
    vtkNew<vtkPlaneSource> pane;
    pane->SetOrigin(-6.0, -4.0, 6.0);
    pane->SetPoint1(6.0, -4.0, 6.0);
    pane->SetPoint2(-6.0, 4.0, 6.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(pane->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    change(actor);
    return actor;
  };
}

/// The pane with shader code of an application at the end of its shading.
Make Shaded(const std::string& code)
{
  return Pane(
    [code](vtkActor* actor)
    {
      actor->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Light::Impl", true, "//VTK::Light::Impl\n" + code + "\n", false);
    });
}

/// The pane with this opacity of its back faces, which are seen.
Make BackFaces(double opacity)
{
  return Pane(
    [opacity](vtkActor* actor)
    {
      actor->RotateY(180.0);
      actor->SetPosition(0.0, 0.0, 12.0);
      vtkNew<vtkProperty> back;
      back->SetOpacity(opacity);
      actor->SetBackfaceProperty(back);
    });
}

/// The pane, selected, with this opacity of what is selected.
Make Selected(double opacity)
{
  return Pane(
    [opacity](vtkActor* actor)
    {
      vtkNew<vtkIdTypeArray> cells;
      cells->InsertNextValue(0);
      vtkNew<vtkSelectionNode> node;
      node->SetFieldType(vtkSelectionNode::CELL);
      node->SetContentType(vtkSelectionNode::INDICES);
      node->SetSelectionList(cells);
      vtkNew<vtkSelection> selection;
      selection->AddNode(node);
      actor->GetMapper()->SetSelection(selection);
      actor->GetProperty()->SetSelectionColor(1.0, 0.0, 0.0, opacity);
    });
}

/// The pane with a texture of this many components, which `set` gives to the actor.
Make Textured(int components, const std::function<void(vtkActor*, vtkTexture*)>& set)
{
  return Pane(
    [components, set](vtkActor* actor)
    {
      vtkNew<vtkTexture> texture;
      texture->SetInputData(MakeImage(components));
      set(actor, texture);
    });
}

/// The pane with such a texture as the color of physically based shading.
Make BaseColor(int components)
{
  return Textured(components,
    [](vtkActor* actor, vtkTexture* texture)
    {
      texture->UseSRGBColorSpaceOn();
      actor->GetProperty()->SetInterpolationToPBR();
      actor->GetProperty()->SetBaseColorTexture(texture);
    });
}

/// The pane with a texture of four components under this name, which VTK multiplies with the color.
Make NamedTexture(const char* name)
{
  return Textured(4,
    [name](vtkActor* actor, vtkTexture* texture)
    { actor->GetProperty()->SetTexture(name, texture); });
}

/// The pane with an opaque texture on its middle. `alpha` is that of the border around it.
Make BorderedTexture(float alpha)
{
  return Textured(3,
    [alpha](vtkActor* actor, vtkTexture* texture)
    {
      texture->SetWrap(vtkTexture::ClampToBorder);
      texture->SetBorderColor(1.0F, 1.0F, 0.0F, alpha);
      vtkNew<vtkTransform> transform;
      transform->Translate(-0.5, -0.5, 0.0);
      transform->Scale(2.0, 2.0, 1.0);
      texture->SetTransform(transform);
      actor->SetTexture(texture);
    });
}

vtkSmartPointer<vtkLookupTable> MakeTable(double leastAlpha = 0.2)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetAlphaRange(leastAlpha, 1.0);
  table->SetRange(0.0, 255.0);
  table->Build();
  return table;
}

/// The pane with a texture that gets its colors from a lookup table with an alpha of its own.
Make MappedTexture(double leastAlpha, double alpha = 1.0)
{
  return Textured(1,
    [=](vtkActor* actor, vtkTexture* texture)
    {
      const auto table = MakeTable(leastAlpha);
      table->SetAlpha(alpha);
      texture->SetLookupTable(table);
      texture->SetColorModeToMapScalars();
      actor->SetTexture(texture);
    });
}

/// A skybox. A floor fades out at the horizon, in front of the lower half of the boxes.
Make Skybox(int projection)
{
  return [projection](vtkRenderer*)
  {
    vtkNew<vtkTexture> texture;
    texture->SetInputData(MakeImage(3));
    auto skybox = vtkSmartPointer<vtkSkybox>::New();
    skybox->SetProjection(projection);
    skybox->SetFloorPlane(0.0F, 1.0F, 0.0F, 0.1F);
    skybox->SetTexture(texture);
    return skybox;
  };
}

/// Such a mapper leaves what is outside of the image transparent.
vtkSmartPointer<vtkProp> MakeReslice(vtkRenderer*)
{
#if VTKNBUFFER_TEST_HAS_RENDERINGIMAGE
  vtkNew<vtkImageResliceMapper> mapper;
  mapper->SetInputData(MakeImage());
  mapper->SliceFacesCameraOn();
  mapper->SliceAtFocalPointOff();
  auto slice = vtkSmartPointer<vtkImageSlice>::New();
  slice->SetMapper(mapper);
  return slice;
#else
  return nullptr;
#endif
}

vtkSmartPointer<vtkProp> MakeStack([[maybe_unused]] vtkRenderer* renderer)
{
#if VTKNBUFFER_TEST_HAS_RENDERINGIMAGE
  auto stack = vtkSmartPointer<vtkImageStack>::New();
  stack->AddImage(vtkImageSlice::SafeDownCast(
    Slice([](vtkImageSlice* slice) { slice->GetProperty()->SetOpacity(0.5); })(renderer)));
  return stack;
#else
  return nullptr;
#endif
}

vtkSmartPointer<vtkProp> MakeImageActor(vtkRenderer*)
{
  auto actor = vtkSmartPointer<vtkImageActor>::New();
  actor->SetInputData(MakeImage(4));
  actor->ForceOpaqueOn();
  return actor;
}

/// A text in space that is forced to be opaque.
template <typename Text>
vtkSmartPointer<Text> MakeText()
{
  auto text = vtkSmartPointer<Text>::New();
  text->SetInput("Boxes");
  text->GetTextProperty()->SetFontSize(30);
  text->ForceOpaqueOn();
  return text;
}

vtkSmartPointer<vtkProp> MakeTextInSpace(vtkRenderer*)
{
  auto text = MakeText<vtkTextActor3D>();
  text->SetPosition(-5.0, -1.0, 6.0);
  text->SetScale(0.1);
  return text;
}

vtkSmartPointer<vtkProp> MakeBillboard(vtkRenderer*)
{
  auto text = MakeText<vtkBillboardTextActor3D>();
  text->SetPosition(-3.0, 0.0, 6.0);
  return text;
}

vtkSmartPointer<vtkProp> MakeFlagpole(vtkRenderer*)
{
#if VTKNBUFFER_TEST_HAS_FLAGPOLES
  auto text = MakeText<vtkFlagpoleLabel>();
  text->SetBasePosition(-1.0, -3.0, 6.0);
  text->SetTopPosition(-1.0, 0.0, 6.0);
  return text;
#else
  return nullptr;
#endif
}

/// Lines with labels, in front of the wall.
vtkSmartPointer<vtkProp> MakeContours(vtkRenderer* renderer)
{
  renderer->GetRenderWindow()->StencilCapableOn();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkFloatArray> values;
  for (int line = 0; line < 3; ++line)
  {
    lines->InsertNextCell(40);
    for (int i = 0; i < 40; ++i)
    {
      lines->InsertCellPoint(points->InsertNextPoint(0.3 * i - 6.0, 2.0 * line - 2.0, 6.0));
      values->InsertNextValue(100.0F + 11.0F * static_cast<float>(line));
    }
  }
  vtkNew<vtkPolyData> contours;
  contours->SetPoints(points);
  contours->SetLines(lines);
  contours->GetPointData()->SetScalars(values);
  vtkNew<vtkTextProperty> text;
  text->SetFontSize(24);
  vtkNew<vtkLabeledContourMapper> mapper;
  mapper->SetInputData(contours);
  mapper->SetTextProperty(text);
  mapper->SetSkipDistance(0.0);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

/// Points among the boxes, some of which are hidden by them.
vtkSmartPointer<vtkPlaneSource> MakePoints()
{
  auto points = vtkSmartPointer<vtkPlaneSource>::New();
  points->SetOrigin(-6.0, -4.0, -3.0);
  points->SetPoint1(6.0, -4.0, -3.0);
  points->SetPoint2(-6.0, 4.0, -3.0);
  points->SetResolution(9, 7);
  return points;
}

#if VTKNBUFFER_TEST_HAS_RENDERINGLABEL
vtkSmartPointer<vtkActor2D> MakeLabels(vtkMapper2D* mapper)
{
  auto labels = vtkSmartPointer<vtkActor2D>::New();
  labels->SetMapper(mapper);
  return labels;
}
#endif

/// Labels of points; if `onlyVisible`, of those that vtkSelectVisiblePoints finds visible.
vtkSmartPointer<vtkProp> MakeLabeledPoints(vtkRenderer* renderer, bool onlyVisible)
{
#if VTKNBUFFER_TEST_HAS_RENDERINGLABEL
  const auto points = MakePoints();
  vtkNew<vtkSelectVisiblePoints> visible;
  visible->SetInputConnection(points->GetOutputPort());
  visible->SetRenderer(renderer);
  vtkNew<vtkLabeledDataMapper> mapper;
  mapper->SetInputConnection(onlyVisible ? visible->GetOutputPort() : points->GetOutputPort());
  mapper->SetLabelModeToLabelIds();
  return MakeLabels(mapper);
#else
  (void)renderer, (void)onlyVisible;
  return nullptr;
#endif
}

/// Labels that are chosen and drawn in the last stage, when all depth is there.
vtkSmartPointer<vtkProp> MakePlacedLabels([[maybe_unused]] vtkRenderer* renderer)
{
#if VTKNBUFFER_TEST_HAS_RENDERINGLABEL
  const auto points = MakePoints();
  vtkNew<vtkSelectVisiblePoints> visible;
  visible->SetInputConnection(points->GetOutputPort());
  visible->SetRenderer(renderer);
  vtkNew<vtkPointSetToLabelHierarchy> hierarchy;
  hierarchy->SetInputConnection(visible->GetOutputPort());
  vtkNew<vtkLabelPlacementMapper> mapper;
  mapper->SetInputConnection(hierarchy->GetOutputPort());
  return MakeLabels(mapper);
#else
  return nullptr;
#endif
}

/// Labels that are drawn in space, in the opaque stage.
vtkSmartPointer<vtkProp> MakeBatchedLabels(vtkRenderer*)
{
#if VTKNBUFFER_TEST_HAS_BATCHED_LABELS
  const auto points = MakePoints();
  points->Update();
  vtkNew<vtkBatchedLabeledDataMapper> mapper;
  mapper->SetInputConnection(points->GetOutputPort());
  mapper->SetLabelModeToLabelIds();
  return MakeLabels(mapper);
#else
  return nullptr;
#endif
}

/// Draws labels that are no props of the renderer, as VTK's class of this name does.
class vtkGridAxesActor3D : public vtkProp
{
public:
  static vtkGridAxesActor3D* New();
  vtkTypeMacro(vtkGridAxesActor3D, vtkProp);
  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    return this->Labels->RenderOpaqueGeometry(viewport);
  }
  void ReleaseGraphicsResources(vtkWindow* w) override
  {
    this->Labels->ReleaseGraphicsResources(w);
  }

  vtkSmartPointer<vtkProp> Labels;
};
vtkStandardNewMacro(vtkGridAxesActor3D);

vtkSmartPointer<vtkProp> MakeGridAxes(vtkRenderer* renderer)
{
  auto axes = vtkSmartPointer<vtkGridAxesActor3D>::New();
  axes->Labels = MakeBatchedLabels(renderer);
  return axes->Labels ? axes : nullptr;
}

using CullerDrawOrder = testing::TestWithParam<Ordered>;
}

// Hazard: a prop that is drawn late, before a prop in the list that blends in the opaque stage or
// reads the depth there.
TEST_P(CullerDrawOrder, IsThatOfTheList)
{
  int last = -1;
  bool isMissing = false;
  Comparison comparison(
    [&](Stage& stage)
    {
      Scenes::BuildWall(stage);
      const vtkSmartPointer<vtkProp> prop = GetParam().MakeProp(stage.GetRenderer());
      isMissing = !prop;
      if (prop)
      {
        stage.Add(prop);
      }
      last = Scenes::AddBox(stage, 0.0, 5.0, -2.0, 9.0, 2.0, 0.5);
      Scenes::SetWallCamera(stage.GetRenderer());
    });
  if (isMissing)
  {
    GTEST_SKIP() << "this VTK comes without such a prop";
  }
  for (int i = 0; i < 8; ++i)
  {
    comparison.Frame(
      [i](Stage& stage)
      {
        Scenes::SetWallCamera(stage.GetRenderer(), i % 2 ? 9.0 : -2.0 * i);
        stage.GetActor(Wall::Index)->SetPosition(4.0 * (i % 3), 0.0, 0.0);
      });
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    EXPECT_GT(comparison.GetHidden(), 0);
    EXPECT_EQ(comparison.GetVerdict(last) == Verdict::Blended, GetParam().NeedsOrder) << i;
  }
}

// Hazard: VTK draws a selection even after the mapper has none any more.
TEST(CullerDrawOrderOnce, MattersAsLongAsASelectionIsDrawn)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      stage.Add(Selected(0.5)(stage.GetRenderer()));
      Scenes::AddBox(stage, 0.0, 5.0, -2.0, 9.0, 2.0, 0.5);
      Scenes::SetWallCamera(stage.GetRenderer());
    });
  const int last = static_cast<int>(comparison.Culled.Props.size()) - 1;
  comparison.Frame();
  comparison.Both(
    [&](Stage& stage) { stage.GetActor(last - 1)->GetMapper()->SetSelection(nullptr); });
  for (int i = 0; i < 3; ++i)
  {
    comparison.Frame(
      [i](Stage& stage)
      {
        Scenes::SetWallCamera(stage.GetRenderer(), i % 2 ? 9.0 : -2.0 * i);
        stage.GetActor(Wall::Index)->SetPosition(4.0 * (i % 3), 0.0, 0.0);
      });
    EXPECT_EQ(comparison.GetVerdict(last), Verdict::Blended) << i;
  }
}

// Hazard: the verdicts of a frame are used again for one in which a slice begins to blend. (Only
// the input of its mapper changes, which the slice's own time does not show.)
TEST(CullerDrawOrderOnce, BeginsToMatterWhileTheCameraStandsStill)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      stage.Add(Slice([](vtkImageSlice*) {})(stage.GetRenderer()));
      Scenes::AddBox(stage, 0.0, 5.0, -2.0, 9.0, 2.0, 0.5);
      Scenes::SetWallCamera(stage.GetRenderer());
    });
  const int last = static_cast<int>(comparison.Culled.Props.size()) - 1;
  for (const int components : { 1, 4, 1 })
  {
    comparison.Both(
      [&](Stage& stage)
      {
        auto* slice = vtkImageSlice::SafeDownCast(stage.Props[last - 1]);
        vtkImageSliceMapper::SafeDownCast(slice->GetMapper())->SetInputData(MakeImage(components));
      });
    for (int i = 0; i < 3; ++i)
    {
      comparison.Frame();
      EXPECT_EQ(comparison.GetVerdict(last) == Verdict::Blended, components == 4) << i;
    }
  }
}

namespace
{
const Ordered Cases[] = {
  { "OpaquePane", Pane([](vtkActor*) {}), false },
  { "FaintBackFaces", BackFaces(0.5) },
  { "OpaqueBackFaces", BackFaces(1.0), false },
  { "FaintSelection", Selected(0.5) },
  { "OpaqueSelection", Selected(1.0), false },
  { "FaintBaseColor", BaseColor(4) },
  { "OpaqueBaseColor", BaseColor(3), false },
  { "MappedTexture", MappedTexture(0.2) },
  { "MappedTextureOfATableWithAlpha", MappedTexture(1.0, 0.5) },
  { "OpaqueMappedTexture", MappedTexture(1.0), false },
  { "FaintDecal", NamedTexture("decal") },
  { "Normals", NamedTexture("normalTex"), false },
  { "FaintBorder", BorderedTexture(0.3F) },
  { "OpaqueBorder", BorderedTexture(1.0F), false },
  { "ShaderWithOpacity", Shaded("  fragOutput0.a = 0.5;") },
  { "ShaderWithDepth", Shaded("  gl_FragDepth = 0.1;"), false },
  { "SkyboxFloor", Skybox(vtkSkybox::Floor) },
  { "SkyboxSphere", Skybox(vtkSkybox::Sphere), false },
  { "OpaqueSlice", Slice([](vtkImageSlice*) {}), false },
  { "FaintSlice", Slice([](vtkImageSlice* slice) { slice->GetProperty()->SetOpacity(0.5); }) },
  { "FaintSliceInTheTranslucentStage",
    Slice(
      [](vtkImageSlice* slice)
      {
        slice->GetProperty()->SetOpacity(0.5);
        slice->ForceTranslucentOn();
      }),
    false },
  { "SliceWithAlpha", Slice([](vtkImageSlice*) {}, 4) },
  { "SliceWithColors", Slice([](vtkImageSlice*) {}, 3), false },
  { "SliceWithLookupTable",
    Slice([](vtkImageSlice* slice) { slice->GetProperty()->SetLookupTable(MakeTable()); }) },
  { "Reslice", MakeReslice },
  { "Stack", MakeStack },
  { "ImageActor", MakeImageActor },
  { "Text", MakeTextInSpace },
  { "Billboard", MakeBillboard },
  { "Flagpole", MakeFlagpole },
  { "Contours", MakeContours },
  { "Labels", [](vtkRenderer* renderer) { return MakeLabeledPoints(renderer, false); }, false },
  { "LabelsOfVisiblePoints",
    [](vtkRenderer* renderer) { return MakeLabeledPoints(renderer, true); } },
  { "PlacedLabels", MakePlacedLabels, false },
  { "BatchedLabels", MakeBatchedLabels },
  { "GridAxes", MakeGridAxes },
};
}

INSTANTIATE_TEST_SUITE_P(Each, CullerDrawOrder, testing::ValuesIn(Cases), GetCaseName);
