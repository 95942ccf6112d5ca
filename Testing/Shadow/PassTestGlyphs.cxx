// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The instances of a glyph cast, each as a caster of its own.
#include "PassTestTools.h"

#include "vtkNBufferGlyphs.h"
#include "vtkNBufferProtectedGlyphs.h"
#include VTKNBUFFER_GL_HEADER

#include "vtkActor.h"
#include "vtkBitArray.h"
#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace
{
constexpr int Count = 24;

/// Points over a floor, with arrays for each instance.
vtkSmartPointer<vtkPolyData> MakeData()
{
  std::minstd_rand random(11);
  const auto between = [&random](double low, double high)
  { return low + (high - low) * (static_cast<double>(random() % 10000) / 9999.0); };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  vtkNew<vtkBitArray> masks;
  masks->SetName("masks");
  data->GetPointData()->AddArray(masks);
  for (const auto& [name, components] :
    { std::pair("sizes", 1), { "vectors", 3 }, { "quaternions", 4 } })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    data->GetPointData()->AddArray(array);
  }
  for (int i = 0; i < Count; ++i)
  {
    const double x = between(-2.5, 2.5);
    const double y = between(-2.5, 2.5);
    points->InsertNextPoint(x, y, between(0.6, 2.0));
    masks->InsertNextValue(i % 4 != 0);
    const double values[4] = { between(-1.0, 1.0), between(-1.0, 1.0),
      i == 5 ? 0.0 : between(-1.0, 1.0), 1.0 };
    vtkArrayDownCast<vtkDoubleArray>(data->GetPointData()->GetArray("sizes"))
      ->InsertNextTuple1(between(0.3, 1.5));
    vtkArrayDownCast<vtkDoubleArray>(data->GetPointData()->GetArray("vectors"))
      ->InsertNextTuple(values);
    vtkArrayDownCast<vtkDoubleArray>(data->GetPointData()->GetArray("quaternions"))
      ->InsertNextTuple(values);
  }
  return data;
}

vtkGlyph3DMapper* AddGlyphs(const Stage& stage, vtkPolyData* data, vtkPolyData* source)
{
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceData(source);
  AddMesh(stage.GetRenderer(), source)->SetMapper(mapper);
  return mapper;
}

void PrepareGlyphs(SceneBuilder& scene)
{
  scene.Floor(5.0);
  scene.Directional({ 0.6, 0.35, -0.7 });
  scene.Look({ 3.0, -8.0, 6.0 }, { 0.4, 0.2, 0.5 });
}

/// Reads the matrices that VTK has uploaded for the instances of a prop.
class MatrixReader : public vtkOpenGLRenderPass
{
public:
  static MatrixReader* New();
  vtkTypeMacro(MatrixReader, vtkOpenGLRenderPass);

  void Render(const vtkRenderState*) override {}
  bool SetShaderParameters(
    vtkShaderProgram*, vtkAbstractMapper* mapper, vtkProp*, vtkOpenGLVertexArrayObject*) override
  {
    const auto buffers =
      vtkNBufferProtectedMembers::GetInstanceBuffers(vtkOpenGLGlyph3DHelper::SafeDownCast(mapper));
    GLint bytes = 0;
    buffers->Matrices->Bind();
    glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &bytes);
    this->Matrices.resize(static_cast<std::size_t>(bytes) / sizeof(float));
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, bytes, this->Matrices.data());
    buffers->Matrices->Release();
    return true;
  }

  std::vector<float> Matrices;
};
vtkStandardNewMacro(MatrixReader);
}

//------------------------------------------------------------------------------------------------
// Hazard: instances cast from another place than where VTK draws them.
using PassGlyphs = OffscreenFixture;

TEST_F(PassGlyphs, MatricesAreThoseThatVTKUploads)
{
  const vtkSmartPointer<vtkPolyData> data = MakeData();
  const Stage stage = SetStage(PrepareGlyphs);
  vtkGlyph3DMapper* mapper = AddGlyphs(stage, data, MakeBox({ 0, 0, 0 }, { 0.4, 0.3, 0.2 }));
  vtkNew<MatrixReader> reader;
  vtkNew<vtkInformation> keys;
  keys->Append(vtkOpenGLRenderPass::RenderPasses(), reader);
  GetActors(stage.GetRenderer()).back()->SetPropertyKeys(keys);
  mapper->SetMaskArray("masks");
  mapper->SetRange(0.2, 0.9);
  // Along the x axis there is a special case in each direction.
  vtkDataArray* vectors = data->GetPointData()->GetArray("vectors");
  vectors->SetTuple3(1, 2.0, 0.0, 0.0);
  vectors->SetTuple3(2, -2.0, 0.0, 0.0);
  int cases = 0;
  int lines = 0;
  const auto compare = [&]()
  {
    ++cases;
    reader->Matrices.clear();
    stage.Window->Render();
    ASSERT_EQ(vtkNBufferGlyphs::GetMapper(mapper), mapper);
    const auto matrices = vtkNBufferGlyphs::GetMatrices(mapper);
    // With a mask VTK leaves the end of the buffer to what is not drawn.
    const std::size_t drawn = mapper->GetMasking() ? Count - Count / 4 : Count;
    ASSERT_LE(16 * drawn, reader->Matrices.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < drawn; ++i)
    {
      const float* columns = &reader->Matrices[16 * i];
      const auto isThin = [columns](int k)
      { return std::hypot(columns[4 * k], columns[4 * k + 1], columns[4 * k + 2]) < 1e-9; };
      if (isThin(0) + isThin(1) + isThin(2) > 1)
      {
        ++lines;
        continue;
      }
      ASSERT_LT(next, matrices.size());
      for (std::size_t k = 0; k < 16; ++k)
      {
        ASSERT_EQ(matrices[next][k % 4 * 4 + k / 4], columns[k]) << i << ", " << k;
      }
      ++next;
    }
    EXPECT_EQ(next, matrices.size());
  };
  for (const auto& [orientation, mode] :
    { std::pair("vectors", vtkGlyph3DMapper::DIRECTION), { "vectors", vtkGlyph3DMapper::ROTATION },
      { "quaternions", vtkGlyph3DMapper::QUATERNION } })
  {
    mapper->SetOrientationArray(orientation);
    mapper->SetOrientationMode(mode);
    for (const auto& [sizes, scaleMode] :
      { std::pair("sizes", vtkGlyph3DMapper::SCALE_BY_MAGNITUDE),
        { "vectors", vtkGlyph3DMapper::SCALE_BY_MAGNITUDE },
        { "vectors", vtkGlyph3DMapper::SCALE_BY_COMPONENTS },
        { "sizes", vtkGlyph3DMapper::NO_DATA_SCALING } })
    {
      mapper->SetScaleArray(sizes);
      mapper->SetScaleMode(scaleMode);
      for (int flags = 0; flags < 8; ++flags)
      {
        SCOPED_TRACE(std::string(orientation) + " " + std::to_string(mode) + ", " + sizes + " " +
          std::to_string(scaleMode) + ", flags " + std::to_string(flags));
        mapper->SetClamping((flags & 1) != 0);
        mapper->SetMasking((flags & 2) != 0);
        mapper->SetScaleFactor((flags & 4) != 0 ? 0.37 : 1.0);
        compare();
      }
    }
  }
  mapper->OrientOff();
  mapper->ScalingOff();
  compare();
  EXPECT_EQ(cases, 97);
  EXPECT_GT(lines, 0);
}

// Hazard: a coordinate of one instance is not finite, and the shadows of the others are wrong; or
// the volume of an instance without an extent is drawn somewhere.
TEST_F(PassGlyphs, InstancesThatAreNowhereCastNothing)
{
  const vtkSmartPointer<vtkPolyData> data = MakeData();
  const Stage stage = SetStage(PrepareGlyphs);
  vtkGlyph3DMapper* mapper = AddGlyphs(stage, data, MakeBox({ 0, 0, 0 }, { 0.4, 0.3, 0.2 }));
  mapper->SetScaleArray("sizes");
  mapper->SetScaleMode(vtkGlyph3DMapper::SCALE_BY_MAGNITUDE);
  mapper->SetOrientationArray("vectors");
  constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
  data->GetPointData()->GetArray("sizes")->SetTuple1(3, notANumber);
  data->GetPointData()->GetArray("sizes")->SetTuple1(5, 0.0);
  data->GetPointData()->GetArray("vectors")->SetTuple3(4, 0.0, notANumber, 0.0);
  const auto pass = AddPass(stage);
  ExpectMatchesOracle(stage, pass);
  EXPECT_EQ(pass->GetStatistics().Casters, 1 + Count - 3);
}

// Hazard: shadows stay where instances have been, or are made again although nothing has changed.
TEST_F(PassGlyphs, ChangesAreNoticed)
{
  const vtkSmartPointer<vtkPolyData> data = MakeData();
  const vtkSmartPointer<vtkPolyData> source = MakeBox({ 0, 0, 0 }, { 0.4, 0.3, 0.2 });
  const Stage stage = SetStage(PrepareGlyphs);
  vtkGlyph3DMapper* mapper = AddGlyphs(stage, data, source);
  vtkActor* actor = GetActors(stage.GetRenderer()).back();
  const auto pass = AddPass(stage);
  const auto expect = [&](const char* what, int updates, int casters = Count + 1)
  {
    SCOPED_TRACE(what);
    ExpectMatchesOracle(stage, pass);
    const vtkShadowStatistics& statistics = pass->GetStatistics();
    EXPECT_EQ(statistics.Updates, updates);
    EXPECT_EQ(statistics.Silhouettes, updates);
    EXPECT_EQ(statistics.Casters, casters);
    EXPECT_EQ(statistics.Decision, vtkShadowDecision::Drawn);
    stage.Window->Render(); // In its first frame VTK changes props that it draws.
    stage.Window->Render();
    EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Still);
  };
  expect("first frame", Count + 1);
  stage.GetRenderer()->GetActiveCamera()->Azimuth(7.0);
  expect("only the camera moves", 0);
  data->GetPoints()->SetPoint(7, 0.0, 0.0, 2.5);
  data->GetPoints()->Modified();
  expect("one instance moves", 1);
  mapper->SetScaleArray("sizes");
  mapper->SetScaleMode(vtkGlyph3DMapper::SCALE_BY_MAGNITUDE);
  expect("sizes", Count);
  mapper->SetOrientationArray("vectors");
  expect("directions", Count);
  data->GetPointData()->GetArray("sizes")->SetTuple1(9, 2.0);
  data->GetPointData()->GetArray("sizes")->Modified();
  expect("one size", 1);
  actor->SetPosition(0.2, 0.1, 0.0);
  expect("the actor moves", Count);
  TestScene::MovePoints(source->GetPoints(), { 0.05, 0.0, 0.02 }, 0.3);
  expect("the source changes", Count);
  mapper->SetSourceData(MakeGlobe({ 0, 0, 0 }, 0.25, 6));
  expect("another source", Count);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 1.4);
  plane->SetNormal(0.3, 0.1, -1.0);
  mapper->AddClippingPlane(plane);
  ExpectMatchesOracle(stage, pass);
  EXPECT_EQ(pass->GetStatistics().Updates, Count) << "a clipping plane";
  mapper->RemoveAllClippingPlanes();
  ExpectMatchesOracle(stage, pass);
  EXPECT_EQ(pass->GetStatistics().Updates, Count) << "no clipping plane";
  mapper->SetMaskArray("masks");
  mapper->SetMasking(true);
  ExpectMatchesOracle(stage, pass);
  EXPECT_EQ(pass->GetStatistics().Casters, Count + 1 - Count / 4) << "masked";
  mapper->SetMasking(false);
  ExpectMatchesOracle(stage, pass);
  EXPECT_EQ(pass->GetStatistics().Casters, Count + 1) << "not masked";
  actor->VisibilityOff();
  ExpectMatchesOracle(stage, pass);
  EXPECT_EQ(pass->GetStatistics().Casters, 1);
}

// Hazard: instances cast other shadows than actors with the same places. (Masks may differ where
// the light does not shine.)
TEST_F(PassGlyphs, CastAsActorsInTheirPlaces)
{
  const vtkSmartPointer<vtkPolyData> source = MakeBox({ 0, 0, 0 }, { 0.4, 0.3, 0.2 });
  const Stage stage = SetStage(PrepareGlyphs);
  vtkGlyph3DMapper* mapper = AddGlyphs(stage, MakeData(), source);
  mapper->SetScaleArray("vectors");
  mapper->SetScaleMode(vtkGlyph3DMapper::SCALE_BY_COMPONENTS); // some of them mirrored
  mapper->SetOrientationArray("vectors");
  const Stage actors = SetStage(PrepareGlyphs);
  for (const std::array<double, 16>& place : vtkNBufferGlyphs::GetMatrices(mapper))
  {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->DeepCopy(place.data());
    AddMesh(actors.GetRenderer(), source)->SetUserMatrix(matrix);
  }
  const auto pass = AddPass(stage);
  const auto other = AddPass(actors);
  for (const int mode : ShadowModes)
  {
    pass->SetMode(mode);
    other->SetMode(mode);
    ExpectMatchesOracle(stage, pass);
    ExpectMatchesOracle(actors, other);
    EXPECT_EQ(pass->GetStatistics().Casters, other->GetStatistics().Casters);
    EXPECT_EQ(pass->GetStatistics().Verdicts, other->GetStatistics().Verdicts);
  }
}

// Hazard: because one instance has a receiver, the volumes of all instances are drawn.
TEST_F(PassGlyphs, InstancesAreCulledOneByOne)
{
  const vtkSmartPointer<vtkPolyData> data = MakeData();
  for (int i = 0; i < Count / 2; ++i)
  {
    data->GetPoints()->SetPoint(i, 100.0 + i, 0.0, 1.0);
  }
  const Stage stage = SetStage(PrepareGlyphs);
  AddGlyphs(stage, data, MakeBox({ 0, 0, 0 }, { 0.4, 0.3, 0.2 }));
  const auto pass = AddPass(stage);
  for (const int mode : { vtkShadowVolumeClampPass::Scissored, vtkShadowVolumeClampPass::Clamped })
  {
    pass->SetMode(mode);
    ExpectMatchesOracle(stage, pass);
    const vtkShadowStatistics& statistics = pass->GetStatistics();
    EXPECT_GE(statistics.GetCount(vtkShadowVerdict::NoReceiver), Count / 2);
    EXPECT_GE(
      statistics.GetCount(mode == vtkShadowVolumeClampPass::Clamped ? vtkShadowVerdict::Clamped
                                                                    : vtkShadowVerdict::Boxed),
      Count / 4);
  }
}
