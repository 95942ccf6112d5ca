// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What an actor draws, by kind of mapper.
#include "CompositeMapper.h"
#include "PrintVectors.h"

#include "vtkNBufferKnownClasses.h"
#include "vtkNBufferMeshes.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataSetMapper.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPlane.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRegularPolygonSource.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{
class Subclass : public vtkOpenGLPolyDataMapper
{
public:
  static Subclass* New();
  vtkTypeMacro(Subclass, vtkOpenGLPolyDataMapper);
};
vtkStandardNewMacro(Subclass);

vtkSmartPointer<vtkPolyData> RunSphereSource()
{
  vtkNew<vtkSphereSource> source;
  source->Update();
  return source->GetOutput();
}

/// An actor with VTK's plain mapper.
class NBufferSurface : public testing::Test
{
protected:
  NBufferSurface() { this->Actor->SetMapper(this->Mapper); }

  std::vector<vtkNBufferSurface::Part> GetParts() const
  {
    std::vector<vtkNBufferSurface::Part> parts;
    EXPECT_TRUE(vtkNBufferSurface().GetParts(this->Actor, this->Actor->GetMatrix(), parts));
    return parts;
  }

  vtkNew<vtkOpenGLPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
};
}

TEST_F(NBufferSurface, SubclassesMayDrawAnythingButCast)
{
  EXPECT_EQ(vtkNBufferKnownClasses::GetPlainActor(this->Actor), this->Actor);
  EXPECT_EQ(vtkNBufferKnownClasses::GetPlainActor(vtkNew<vtkFollower>()), nullptr);

  EXPECT_TRUE(vtkNBufferSurface::IsPlain(vtkNew<vtkOpenGLPolyDataMapper>()));
  EXPECT_TRUE(vtkNBufferSurface::IsPlain(vtkNew<vtkDataSetMapper>()));
  EXPECT_TRUE(vtkNBufferSurface::IsPlain(vtkNew<CompositeMapper>()));
  EXPECT_FALSE(vtkNBufferSurface::IsPlain(vtkNew<vtkGlyph3DMapper>()));

  vtkNew<Subclass> mapper;
  mapper->SetInputData(RunSphereSource());
  this->Actor->SetMapper(mapper);
  EXPECT_FALSE(vtkNBufferSurface::IsPlain(mapper));
  EXPECT_EQ(vtkNBufferSurface::GetOnlyPolyData(mapper), nullptr);
  EXPECT_EQ(this->GetParts().size(), 1u);
}

// Hazard: the bounds and the input of a mapper are those of one piece of many, or its polygons are
// not what it draws.
TEST_F(NBufferSurface, MappersThatDrawSomethingElseAreLeftOut)
{
  std::vector<vtkNBufferSurface::Part> parts;
  vtkNew<vtkPointGaussianMapper> splats;
  splats->SetInputData(RunSphereSource());
  this->Actor->SetMapper(splats);
  EXPECT_FALSE(vtkNBufferSurface().GetParts(this->Actor, this->Actor->GetMatrix(), parts));

  this->Mapper->SetInputData(RunSphereSource());
  this->Actor->SetMapper(this->Mapper);
  EXPECT_EQ(this->GetParts().size(), 1u);
  EXPECT_TRUE(vtkNBufferSurface::IsPlain(this->Mapper));
  this->Mapper->SetNumberOfSubPieces(2);
  EXPECT_FALSE(vtkNBufferSurface::IsPlain(this->Mapper));
  EXPECT_FALSE(vtkNBufferSurface().GetParts(this->Actor, this->Actor->GetMatrix(), parts));
}

TEST_F(NBufferSurface, PartsArePlacedInTheWorld)
{
  this->Mapper->SetInputData(RunSphereSource());
  this->Actor->SetPosition(1.0, 2.0, 3.0);
  const std::vector<vtkNBufferSurface::Part> parts = this->GetParts();
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].Mesh, this->Mapper->GetInput());
  EXPECT_EQ(
    parts[0].ToWorld, (std::array<double, 16>{ 1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1 }));
  EXPECT_TRUE(parts[0].IsVisible);
  EXPECT_FALSE(parts[0].IsTranslucent);

  // Without points nothing is drawn, but it is known what.
  this->Mapper->SetInputData(vtkNew<vtkPolyData>());
  ASSERT_EQ(this->GetParts().size(), 1u);
  EXPECT_TRUE(vtkNBufferSurface::GetMesh(this->Mapper->GetInput()).Triangles.empty());
}

TEST_F(NBufferSurface, BlocksInheritAttributes)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> inner;
  for (unsigned int i = 0; i < 2; ++i)
  {
    inner->SetBlock(i, RunSphereSource());
    blocks->SetBlock(i, RunSphereSource());
  }
  blocks->SetBlock(2, inner);
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  this->Actor->SetMapper(mapper);
  attributes->SetBlockVisibility(inner, false);
  attributes->SetBlockVisibility(inner->GetBlock(1), true);
  attributes->SetBlockOpacity(blocks->GetBlock(1), 0.5);
  const std::vector<vtkNBufferSurface::Part> parts = this->GetParts();
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_TRUE(parts[0].IsVisible && !parts[0].IsTranslucent);
  EXPECT_TRUE(parts[1].IsVisible && parts[1].IsTranslucent);
  EXPECT_FALSE(parts[2].IsVisible);
  EXPECT_TRUE(parts[3].IsVisible);
}

TEST_F(NBufferSurface, OtherDataIsExtracted)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(image);
  this->Actor->SetMapper(mapper);
  vtkNBufferSurface surface;
  std::vector<vtkNBufferSurface::Part> parts;
  EXPECT_FALSE(vtkNBufferSurface::GetPartsAtHand(this->Actor, this->Actor->GetMatrix(), parts));
  EXPECT_TRUE(surface.GetParts(this->Actor, this->Actor->GetMatrix(), parts));
  EXPECT_EQ(vtkNBufferSurface::GetMesh(parts.at(0).Mesh).Triangles.size(), 6u * 4u * 2u);
  vtkNBufferMeshes::OfProp kept;
  EXPECT_TRUE(vtkNBufferMeshes().Get(this->Actor, 1000, kept).empty());

  this->Actor->SetMapper(vtkNew<vtkOpenGLPolyDataMapper>());
  EXPECT_FALSE(vtkNBufferSurface().GetParts(this->Actor, this->Actor->GetMatrix(), parts))
    << "has no input";
  this->Actor->SetMapper(vtkNew<vtkGlyph3DMapper>());
  EXPECT_FALSE(vtkNBufferSurface().GetParts(this->Actor, this->Actor->GetMatrix(), parts));
}

// Hazard: the image changes because the shadow pass runs a pipeline that VTK would not run.
TEST_F(NBufferSurface, PipelinesOfStaticMappersAreNotRun)
{
  vtkNew<vtkSphereSource> source;
  this->Mapper->SetInputConnection(source->GetOutputPort());
  vtkNBufferSurface::UpdatePipeline(this->Actor);
  const vtkIdType count = this->Mapper->GetInput()->GetNumberOfPoints();
  EXPECT_GT(count, 0);
  this->Mapper->StaticOn();
  source->SetThetaResolution(20);
  vtkNBufferSurface::UpdatePipeline(this->Actor);
  EXPECT_EQ(this->Mapper->GetInput()->GetNumberOfPoints(), count);
  this->Mapper->StaticOff();
  vtkNBufferSurface::UpdatePipeline(this->Actor);
  EXPECT_GT(this->Mapper->GetInput()->GetNumberOfPoints(), count);
}

TEST_F(NBufferSurface, PolygonsAndStripsBecomeTriangles)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i % 2, i / 2, 0.0);
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 3, 2 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polys);
  data->SetStrips(strips);
  const vtkNBufferMesh mesh = vtkNBufferSurface::GetMesh(data);
  EXPECT_EQ(mesh.Points.size(), 4u);
  EXPECT_EQ(mesh.Points[3], glm::dvec3(1.0, 1.0, 0.0));
  EXPECT_EQ(mesh.Triangles.size(), 4u);
}

// Hazard: the triangles of a prop are those of its former data, or copying them takes more time
// than they save.
TEST_F(NBufferSurface, SmallMeshesAreCopiedAFewInAFrame)
{
  vtkNBufferMeshes meshes;
  std::vector<vtkNBufferMeshes::OfProp> none;
  vtkNBufferMeshes::OfProp kept;
  vtkNew<vtkSphereSource> source;
  this->Mapper->SetInputConnection(source->GetOutputPort());
  this->Mapper->Update();
  EXPECT_FALSE(meshes.FindSmall(this->Actor, kept)) << "no frame has begun";
  meshes.BeginFrame(none);
  ASSERT_TRUE(meshes.FindSmall(this->Actor, kept));
  EXPECT_EQ(kept.Small->Triangles.size(), 96u);
  kept.First = 5;
  ASSERT_TRUE(meshes.FindSmall(this->Actor, kept));
  EXPECT_EQ(kept.First, 5u);

  source->SetThetaResolution(20);
  this->Mapper->Update();
  kept = {};
  ASSERT_TRUE(meshes.FindSmall(this->Actor, kept));
  EXPECT_EQ(kept.Small->Triangles.size(), 240u);
  source->SetThetaResolution(40);
  this->Mapper->Update();
  kept = {};
  EXPECT_FALSE(meshes.FindSmall(this->Actor, kept)) << "too many triangles";

  // A mapper goes on with its triangles of larger polygons when their points move.
  vtkNew<vtkRegularPolygonSource> polygon;
  polygon->SetNumberOfSides(5);
  polygon->Update();
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(polygon->GetOutput());
  this->Mapper->SetInputData(data);
  data->GetPolys()->Modified();
  kept = {};
  EXPECT_TRUE(meshes.FindSmall(this->Actor, kept));
  data->GetPoints()->Modified();
  kept = {};
  EXPECT_FALSE(meshes.FindSmall(this->Actor, kept)) << "triangles of the former points";

  std::vector<vtkSmartPointer<vtkActor>> actors;
  std::vector<vtkNBufferMeshes::OfProp> keptOfActors(150);
  const auto countCopies = [&]
  {
    meshes.BeginFrame(none);
    int count = 0;
    for (std::size_t i = 0; i < actors.size(); ++i)
    {
      count += meshes.FindSmall(actors[i], keptOfActors[i]) ? 1 : 0;
    }
    return count;
  };
  for (int i = 0; i < 150; ++i)
  {
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    mapper->SetInputData(RunSphereSource());
    actors.push_back(vtkSmartPointer<vtkActor>::New());
    actors.back()->SetMapper(mapper);
  }
  EXPECT_EQ(countCopies(), 64);
  EXPECT_EQ(countCopies(), 128);
  EXPECT_EQ(countCopies(), 150);
}

// Hazard: large meshes are read again in each frame, or meshes are kept for ever.
TEST_F(NBufferSurface, MeshesOfPropsAreKeptWhileTheyAreRequested)
{
  vtkNBufferMeshes meshes;
  std::vector<vtkNBufferMeshes::OfProp> kept(2);
  this->Mapper->SetInputData(RunSphereSource());
  EXPECT_TRUE(meshes.Get(this->Actor, 96, kept[0]).empty()) << "too large";
  ASSERT_EQ(meshes.Get(this->Actor, 97, kept[0]).size(), 1u);
  EXPECT_EQ(kept[0].Meshes[0].Mesh->Triangles.size(), 96u);
  EXPECT_EQ(meshes.Get(nullptr, 97, kept[0]).size(), 1u) << "known";
  EXPECT_TRUE(meshes.Get(nullptr, 98, kept[0]).empty());

  kept[0] = {};
  meshes.Get(this->Actor, 97, kept[0]);
  meshes.Get(this->Actor, 97, kept[1]);
  EXPECT_EQ(kept[0].Meshes[0].Mesh, kept[1].Meshes[0].Mesh);
  for (int frame = 0; frame < 600; ++frame)
  {
    meshes.BeginFrame(kept);
    meshes.Get(nullptr, 97, kept[0]);
  }
  EXPECT_EQ(kept[0].Meshes.size(), 1u);
  EXPECT_TRUE(kept[1].Meshes.empty());
}

TEST_F(NBufferSurface, PlanesKeepTheSideOfTheirNormal)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 1.0, 0.0);
  plane->SetOrigin(5.0, 2.0, 0.0);
  EXPECT_TRUE(vtkNBufferSurface::GetClippingPlanes(this->Mapper).empty());
  this->Mapper->AddClippingPlane(plane);
  const auto planes = vtkNBufferSurface::GetClippingPlanes(this->Mapper);
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_EQ(planes[0], (vtkNBufferSurface::Plane{ 0.0, 1.0, 0.0, -2.0 }));
  for (int i = 1; i < 8; ++i)
  {
    this->Mapper->AddClippingPlane(vtkNew<vtkPlane>());
  }
  EXPECT_EQ(vtkNBufferSurface::GetClippingPlanes(this->Mapper).size(), 6u);
}

// Hazard: a source is updated, but not for the piece that the mapper shows.
TEST_F(NBufferSurface, PipelinesMakeThePieceOfTheMapper)
{
  vtkNew<vtkSphereSource> source;
  this->Mapper->SetInputConnection(source->GetOutputPort());
  vtkNBufferSurface::UpdatePipeline(this->Actor);
  const vtkIdType all = this->Mapper->GetInput()->GetNumberOfPolys();
  this->Mapper->SetNumberOfPieces(4);
  this->Mapper->SetPiece(1);
  vtkNBufferSurface::UpdatePipeline(this->Actor);
  EXPECT_EQ(this->Mapper->GetInput()->GetNumberOfPolys(), all / 4);
}

TEST_F(NBufferSurface, WideLinesAndPointsHaveAMargin)
{
  const vtkSmartPointer<vtkPolyData> sphere = RunSphereSource();
  this->Mapper->SetInputData(sphere);
  this->Actor->GetProperty()->SetLineWidth(6.0);
  EXPECT_EQ(vtkNBufferSurface::GetMargin(this->Actor), 0.0);
  EXPECT_FALSE(vtkNBufferSurface::DrawsLines(this->Mapper));
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  sphere->SetLines(lines);
  EXPECT_EQ(vtkNBufferSurface::GetMargin(this->Actor), 4.0);
  EXPECT_TRUE(vtkNBufferSurface::DrawsLines(this->Mapper));

  // Blocks are searched for lines, too.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, RunSphereSource());
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  this->Actor->SetMapper(mapper);
  EXPECT_EQ(vtkNBufferSurface::GetMargin(this->Actor), 0.0);
  blocks->SetBlock(2, sphere);
  EXPECT_EQ(vtkNBufferSurface::GetMargin(this->Actor), 4.0);
}
