// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What an actor draws, by kind of mapper.
#include "CompositeMapper.h"

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
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

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

std::vector<vtkNBufferSurface::Part> GetParts(vtkActor* actor)
{
  std::vector<vtkNBufferSurface::Part> parts;
  EXPECT_TRUE(vtkNBufferSurface().GetParts(actor, actor->GetMatrix(), parts));
  return parts;
}
}

TEST(NBufferSurface, SubclassesMayDrawAnythingButCast)
{
  vtkNew<vtkActor> actor;
  EXPECT_EQ(vtkNBufferSurface::GetPlainActor(actor), actor);
  EXPECT_EQ(vtkNBufferSurface::GetPlainActor(vtkNew<vtkFollower>()), nullptr);

  EXPECT_TRUE(vtkNBufferSurface::IsPlain(vtkNew<vtkOpenGLPolyDataMapper>()));
  EXPECT_TRUE(vtkNBufferSurface::IsPlain(vtkNew<vtkDataSetMapper>()));
  EXPECT_TRUE(vtkNBufferSurface::IsPlain(vtkNew<CompositeMapper>()));
  EXPECT_FALSE(vtkNBufferSurface::IsPlain(vtkNew<vtkGlyph3DMapper>()));

  vtkNew<Subclass> mapper;
  mapper->SetInputData(RunSphereSource());
  actor->SetMapper(mapper);
  EXPECT_FALSE(vtkNBufferSurface::IsPlain(mapper));
  EXPECT_EQ(vtkNBufferSurface::GetOnlyPolyData(mapper), nullptr);
  EXPECT_EQ(GetParts(actor).size(), 1u);
}

TEST(NBufferSurface, PartsArePlacedInTheWorld)
{
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputData(RunSphereSource());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(1.0, 2.0, 3.0);
  const std::vector<vtkNBufferSurface::Part> parts = GetParts(actor);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].Mesh, mapper->GetInput());
  EXPECT_EQ(
    parts[0].ToWorld, (std::array<double, 16>{ 1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1 }));
  EXPECT_TRUE(parts[0].IsVisible);
  EXPECT_FALSE(parts[0].IsTranslucent);

  // Without points nothing is drawn, but it is known what.
  mapper->SetInputData(vtkNew<vtkPolyData>());
  ASSERT_EQ(GetParts(actor).size(), 1u);
  EXPECT_TRUE(vtkNBufferSurface::GetMesh(mapper->GetInput()).Triangles.empty());
}

TEST(NBufferSurface, BlocksInheritAttributes)
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
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  attributes->SetBlockVisibility(inner, false);
  attributes->SetBlockVisibility(inner->GetBlock(1), true);
  attributes->SetBlockOpacity(blocks->GetBlock(1), 0.5);
  const std::vector<vtkNBufferSurface::Part> parts = GetParts(actor);
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_TRUE(parts[0].IsVisible && !parts[0].IsTranslucent);
  EXPECT_TRUE(parts[1].IsVisible && parts[1].IsTranslucent);
  EXPECT_FALSE(parts[2].IsVisible);
  EXPECT_TRUE(parts[3].IsVisible);
}

TEST(NBufferSurface, OtherDataIsExtracted)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const vtkNBufferMesh mesh = [&]()
  {
    vtkNBufferSurface surface;
    std::vector<vtkNBufferSurface::Part> parts;
    EXPECT_FALSE(vtkNBufferSurface::GetPartsAtHand(actor, actor->GetMatrix(), parts));
    EXPECT_TRUE(surface.GetParts(actor, actor->GetMatrix(), parts));
    return vtkNBufferSurface::GetMesh(parts.at(0).Mesh);
  }();
  EXPECT_EQ(mesh.Triangles.size(), 6u * 4u * 2u);
  EXPECT_TRUE(vtkNBufferMeshes().Get(actor).empty());

  std::vector<vtkNBufferSurface::Part> parts;
  actor->SetMapper(vtkNew<vtkOpenGLPolyDataMapper>());
  EXPECT_FALSE(vtkNBufferSurface().GetParts(actor, actor->GetMatrix(), parts)) << "has no input";
  actor->SetMapper(vtkNew<vtkGlyph3DMapper>());
  EXPECT_FALSE(vtkNBufferSurface().GetParts(actor, actor->GetMatrix(), parts));
}

// Hazard: the image changes because the shadow pass runs a pipeline that VTK would not run.
TEST(NBufferSurface, PipelinesOfStaticMappersAreNotRun)
{
  vtkNew<vtkSphereSource> source;
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNBufferSurface::UpdatePipeline(actor);
  const vtkIdType count = mapper->GetInput()->GetNumberOfPoints();
  EXPECT_GT(count, 0);
  mapper->StaticOn();
  source->SetThetaResolution(20);
  vtkNBufferSurface::UpdatePipeline(actor);
  EXPECT_EQ(mapper->GetInput()->GetNumberOfPoints(), count);
  mapper->StaticOff();
  vtkNBufferSurface::UpdatePipeline(actor);
  EXPECT_GT(mapper->GetInput()->GetNumberOfPoints(), count);
}

TEST(NBufferSurface, PolygonsAndStripsBecomeTriangles)
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

TEST(NBufferSurface, PlanesKeepTheSideOfTheirNormal)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 1.0, 0.0);
  plane->SetOrigin(5.0, 2.0, 0.0);
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  EXPECT_TRUE(vtkNBufferSurface::GetClippingPlanes(mapper).empty());
  mapper->AddClippingPlane(plane);
  const auto planes = vtkNBufferSurface::GetClippingPlanes(mapper);
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_EQ(planes[0], (vtkNBufferSurface::Plane{ 0.0, 1.0, 0.0, -2.0 }));
}

TEST(NBufferSurface, WideLinesAndPointsHaveAMargin)
{
  const vtkSmartPointer<vtkPolyData> sphere = RunSphereSource();
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputData(sphere);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLineWidth(6.0);
  EXPECT_EQ(vtkNBufferSurface::GetMargin(actor), 0.0);
  EXPECT_FALSE(vtkNBufferSurface::DrawsLines(mapper));
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  sphere->SetLines(lines);
  EXPECT_EQ(vtkNBufferSurface::GetMargin(actor), 4.0);
  EXPECT_TRUE(vtkNBufferSurface::DrawsLines(mapper));
}
