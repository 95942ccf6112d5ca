// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneProps.h"

#include "BlockMeshes.h"
#include "CompositeMapper.h"
#include "LightRig.h"
#include "Shapes.h"

#include "vtkNBufferVTKVersion.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkBitArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataSetMapper.h"
#include "vtkDoubleArray.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkLODProp3D.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace TestScene
{
vtkSmartPointer<vtkTexture> MakeTexture(Translucency translucency)
{
  constexpr int side = 4;
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < side * side; ++i)
  {
    pixels[4 * i] = static_cast<unsigned char>(16 * i);
    pixels[4 * i + 1] = pixels[4 * i + 2] = 128;
    pixels[4 * i + 3] = translucency == Translucency::Some && i % 2 ? 40 : 255;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

void SetInput(vtkPolyDataMapper* mapper, const Prop& prop, bool reversePoints)
{
  vtkSmartPointer<vtkPolyData> data = MakeShape(prop.Shape, prop.Scalars);
  if (reversePoints)
  {
    ReversePoints(data);
  }
  if (prop.Kind != PropKind::Piped)
  {
    mapper->SetInputData(data);
    return;
  }
  vtkNew<vtkTransformFilter> filter;
  vtkNew<vtkTransform> transform;
  filter->SetTransform(transform);
  filter->SetInputData(data);
  mapper->SetInputConnection(filter->GetOutputPort());
}

void SetMatrix(vtkProp3D* prop, const std::vector<double>& elements)
{
  if (elements.size() == 16)
  {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->DeepCopy(elements.data());
    prop->SetUserMatrix(matrix);
  }
}

namespace
{
class PropWithoutBounds : public vtkProp
{
public:
  static PropWithoutBounds* New();
  vtkTypeMacro(PropWithoutBounds, vtkProp);
  double* GetBounds() override { return nullptr; }
};
vtkStandardNewMacro(PropWithoutBounds);

/// The shape beside itself, for props with two parts.
Shape GetSecondPart(const Shape& shape)
{
  Shape second = shape;
  second.Center[0] += 1.25 * shape.Size[0];
  second.Seed += 1;
  return second;
}

/// Each instance gets a size and an orientation of its own; with every other seed a third of them
/// is masked.
void ScatterGlyphs(vtkPolyData* points, vtkGlyph3DMapper* mapper, int seed)
{
  std::minstd_rand random(static_cast<unsigned int>(seed) + 1);
  const auto between = [&random](double low, double high)
  { return low + (high - low) * (static_cast<double>(random() % 1000) / 999.0); };
  vtkNew<vtkDoubleArray> sizes;
  vtkNew<vtkDoubleArray> turns;
  vtkNew<vtkBitArray> masks;
  const int mode = seed % 3; // DIRECTION, ROTATION or QUATERNION
  sizes->SetNumberOfComponents(3);
  turns->SetNumberOfComponents(mode == vtkGlyph3DMapper::QUATERNION ? 4 : 3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double x = between(0.5, 2.0);
    const double y = between(0.5, 2.0);
    sizes->InsertNextTuple3(x, y, between(0.5, 2.0));
    double turn[4];
    for (double& value : turn)
    {
      value = mode == vtkGlyph3DMapper::ROTATION ? between(-180.0, 180.0) : between(-0.5, 0.5);
    }
    const double length = std::sqrt(
      turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3] + 1e-9);
    for (double& value : turn)
    {
      value /= mode == vtkGlyph3DMapper::QUATERNION ? length : 1.0;
    }
    turns->InsertNextTuple(turn);
    masks->InsertNextValue(random() % 3 != 0);
  }
  sizes->SetName("sizes");
  turns->SetName("turns");
  masks->SetName("masks");
  points->GetPointData()->AddArray(sizes);
  points->GetPointData()->AddArray(turns);
  points->GetPointData()->AddArray(masks);
  mapper->SetScaleArray("sizes");
  mapper->SetScaleMode(
    seed % 2 ? vtkGlyph3DMapper::SCALE_BY_COMPONENTS : vtkGlyph3DMapper::SCALE_BY_MAGNITUDE);
  mapper->SetOrientationArray("turns");
  mapper->SetOrientationMode(mode);
  mapper->SetMaskArray("masks");
  mapper->SetMasking(seed % 2 != 0);
}

/// The points get the first source and two others by turns.
void AddSources(vtkPolyData* points, vtkGlyph3DMapper* mapper, Shape shape)
{
  vtkNew<vtkDoubleArray> sources;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    sources->InsertNextValue(static_cast<double>(i % 3));
  }
  sources->SetName("sources");
  points->GetPointData()->AddArray(sources);
  for (const ShapeKind kind : { ShapeKind::Box, ShapeKind::Quad })
  {
    shape.Kind = kind;
    mapper->SetSourceData(mapper->GetNumberOfInputConnections(1), MakeShape(shape));
  }
  mapper->SetSourceIndexArray("sources");
  mapper->SourceIndexingOn();
}

vtkSmartPointer<vtkMapper> MakeMapper(const Prop& prop)
{
  if (prop.Kind == PropKind::DataSet)
  {
    vtkNew<vtkDataSetMapper> mapper;
    mapper->SetInputData(MakeShape(prop.Shape, prop.Scalars));
    return mapper;
  }
  if (prop.Kind == PropKind::Glyphs)
  {
    Shape small = prop.Shape;
    small.Center = { 0.0, 0.0, 0.0 };
    small.Size *= 0.2;
    vtkNew<vtkGlyph3DMapper> mapper;
    Shape places = prop.Shape;
    places.CellValues =
      false; // VTK would read the color of each point from the fewer ones of cells.
    vtkSmartPointer<vtkPolyData> points = MakeShape(places);
    mapper->SetInputData(points);
    mapper->SetSourceData(MakeShape(small));
    if (prop.Shape.Seed % 2)
    {
      ScatterGlyphs(points, mapper, prop.Shape.Seed / 2);
    }
    if (HasSeveralSources(prop))
    {
      AddSources(points, mapper, small);
    }
    return mapper;
  }
  if (prop.Kind == PropKind::Splats)
  {
    vtkNew<vtkPointGaussianMapper> mapper;
    mapper->SetInputData(MakeShape(prop.Shape, prop.Scalars));
    // One in four blends, with which the culler steps aside.
    mapper->SetScaleFactor(prop.Shape.Seed % 4 == 0 ? 0.1 * prop.Shape.Size[0] : 0.0);
    mapper->EmissiveOff();
    return mapper;
  }
  if (prop.Kind == PropKind::Composite)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    const std::vector<vtkSmartPointer<vtkPolyData>> meshes = MakeBlockMeshes(2);
    meshes[0]->ShallowCopy(MakeShape(prop.Shape, prop.Scalars));
    meshes[1]->ShallowCopy(MakeShape(GetSecondPart(prop.Shape), prop.Scalars));
    blocks->SetBlock(0, meshes[0]);
    vtkSmartPointer<vtkDataObject> second = meshes[1];
    if (prop.Shape.Seed % 2)
    {
      vtkNew<vtkMultiBlockDataSet> inner;
      inner->SetBlock(0, second);
      second = inner;
    }
    blocks->SetBlock(1, second);
    vtkNew<CompositeMapper> mapper;
    mapper->SetInputDataObject(blocks);
    vtkNew<vtkCompositeDataDisplayAttributes> attributes;
    mapper->SetCompositeDataDisplayAttributes(attributes);
    mapper->SetBlockColor(1, 1.0 - prop.Color[0], prop.Color[2], prop.Color[1]);
    return mapper;
  }
  vtkNew<vtkPolyDataMapper> mapper;
  SetInput(mapper, prop, false);
  auto* openGL = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  if (openGL && !prop.ShiftCoordinates)
  {
    openGL->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  }
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(prop.OffsetFactor, prop.OffsetUnits);
  return mapper;
}

void SetProperty(vtkProperty* property, const Prop& prop)
{
  property->SetColor(prop.Color[0], prop.Color[1], prop.Color[2]);
  property->SetOpacity(prop.Opacity);
  property->SetLighting(prop.Lighting);
  if (prop.Flat)
  {
    property->SetInterpolationToFlat();
  }
  property->SetRepresentation(static_cast<int>(prop.Representation));
  property->SetEdgeVisibility(prop.Edges);
  property->SetVertexVisibility(prop.Vertices);
  property->SetRenderPointsAsSpheres(prop.Spheres);
  property->SetRenderLinesAsTubes(prop.Tubes);
  property->SetLineWidth(static_cast<float>(prop.LineWidth));
  property->SetPointSize(static_cast<float>(prop.PointSize));
  property->SetFrontfaceCulling(prop.CulledFaces == 1);
  property->SetBackfaceCulling(prop.CulledFaces == 2);
}

void SetShader(vtkActor* actor, Shader shader)
{
  if (shader == Shader::MovesVertices)
  {
    actor->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
      "//VTK::PositionVC::Impl\n gl_Position.y += 0.4 * gl_Position.w;\n", false);
  }
  else if (shader == Shader::WritesDepth)
  {
    actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true, "//VTK::Light::Impl\n gl_FragDepth = 0.25;\n", false);
  }
}

void SetActor(vtkActor* actor, const Prop& prop)
{
  vtkSmartPointer<vtkMapper> mapper = MakeMapper(prop);
  if (prop.ClippingPlane.size() == 6)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(prop.ClippingPlane[0], prop.ClippingPlane[1], prop.ClippingPlane[2]);
    plane->SetNormal(prop.ClippingPlane[3], prop.ClippingPlane[4], prop.ClippingPlane[5]);
    mapper->AddClippingPlane(plane);
  }
  if (prop.Kind != PropKind::NoMapper)
  {
    actor->SetMapper(mapper);
  }
  SetProperty(actor->GetProperty(), prop);
  if (prop.BackOpacity < 1.0)
  {
    vtkNew<vtkProperty> back;
    SetProperty(back, prop);
    back->SetOpacity(prop.BackOpacity);
    actor->SetBackfaceProperty(back);
  }
  actor->SetForceOpaque(prop.ForceOpaque);
  actor->SetForceTranslucent(prop.ForceTranslucent);
  if (prop.Texture != Translucency::None)
  {
    actor->SetTexture(MakeTexture(prop.Texture));
  }
  SetShader(actor, prop.Shader);
}

vtkSmartPointer<vtkProp3D> MakeVolume(const Prop& prop)
{
  constexpr int side = 6;
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, side);
  const glm::dvec3& size = prop.Shape.Size;
  const auto spacing = [&size](int i) { return std::max(size[i], 1e-3) / (side - 1); };
  image->SetSpacing(spacing(0), spacing(1), spacing(2));
  image->SetOrigin(prop.Shape.Center[0] - 0.5 * size[0], prop.Shape.Center[1] - 0.5 * size[1],
    prop.Shape.Center[2] - 0.5 * size[2]);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < side * side * side; ++i)
  {
    voxels[i] = static_cast<unsigned char>(37 * i);
  }
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputData(image);
  // Its sampling would depend on the time that the frames before have taken.
  mapper->AutoAdjustSampleDistancesOff();
  mapper->InteractiveAdjustSampleDistancesOff();
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, prop.Color[0], prop.Color[1], prop.Color[2]);
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

vtkSmartPointer<vtkProp3D> MakeAssembly(const Prop& prop)
{
  auto assembly = vtkSmartPointer<vtkAssembly>::New();
  Prop part = prop;
  part.Kind = PropKind::Actor;
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkActor> actor;
    SetActor(actor, part);
    assembly->AddPart(actor);
    part.Shape = GetSecondPart(prop.Shape);
  }
  return assembly;
}

vtkSmartPointer<vtkProp3D> MakeLOD(const Prop& prop)
{
  auto lod = vtkSmartPointer<vtkLODProp3D>::New();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeShape(prop.Shape));
  vtkNew<vtkProperty> property;
  SetProperty(property, prop);
  lod->AddLOD(mapper, property, 0.0);
  return lod;
}

vtkSmartPointer<vtkProp3D> MakeSlice(const Prop& prop)
{
  constexpr int side = 8;
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, 1);
  const glm::dvec3 spacing = prop.Shape.Size / static_cast<double>(side);
  image->SetSpacing(spacing.x, spacing.y, 1.0);
  const glm::dvec3 corner = prop.Shape.Center - 0.5 * prop.Shape.Size;
  image->SetOrigin(corner.x, corner.y, prop.Shape.Center.z);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < side * side; ++i)
  {
    value[i] = static_cast<unsigned char>(29 * (i + prop.Id));
  }
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(image);
  auto slice = vtkSmartPointer<vtkImageSlice>::New();
  slice->SetMapper(mapper);
  slice->GetProperty()->SetOpacity(0.5);
  return slice;
}

vtkSmartPointer<vtkProp3D> MakeProp3D(const Prop& prop, vtkCamera* camera)
{
  switch (prop.Kind)
  {
    case PropKind::Assembly:
      return MakeAssembly(prop);
    case PropKind::LOD:
      return MakeLOD(prop);
    case PropKind::Volume:
      return MakeVolume(prop);
    case PropKind::Slice:
      return MakeSlice(prop);
    case PropKind::Billboard:
    {
      auto text = vtkSmartPointer<vtkBillboardTextActor3D>::New();
      text->SetInput("N");
      return text;
    }
    case PropKind::Follower:
    {
      auto follower = vtkSmartPointer<vtkFollower>::New();
      follower->SetCamera(camera);
      SetActor(follower, prop);
      return follower;
    }
    default:
    {
      auto actor = vtkSmartPointer<vtkActor>::New();
      SetActor(actor, prop);
      return actor;
    }
  }
}
}

vtkSmartPointer<vtkProp> MakeProp(const Prop& prop, vtkCamera* camera)
{
  if (prop.Kind == PropKind::Text)
  {
    auto text = vtkSmartPointer<vtkTextActor>::New();
    text->SetInput("2D");
    text->SetPosition(3, 3);
    text->GetTextProperty()->SetFontSize(10);
    return text;
  }
  if (prop.Kind == PropKind::NoBounds)
  {
    return vtkSmartPointer<PropWithoutBounds>::New();
  }
  vtkSmartPointer<vtkProp3D> result = MakeProp3D(prop, camera);
  result->SetPosition(prop.Position[0], prop.Position[1], prop.Position[2]);
  result->SetOrientation(prop.Orientation[0], prop.Orientation[1], prop.Orientation[2]);
  result->SetScale(prop.Scale[0], prop.Scale[1], prop.Scale[2]);
  SetMatrix(result, prop.UserMatrix);
  result->SetVisibility(prop.Visible);
  result->SetUseBounds(prop.UseBounds);
  return result;
}
}
