// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CompositeMapper.h"
#include "ShadowScenes.h"

#include "ShadowShapes.h"

#include "vtkNBufferVTKVersion.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"

#include <cmath>
#include <limits>

using namespace ShadowShapes;

namespace
{
/// What the casters of this file stand on or float above, with a light from above.
void Prepare(vtkRenderer* renderer)
{
  AddFloor(renderer, 5.0);
  AddDirectional(renderer, { 0.6, 0.35, -0.7 });
}

void LookAtCasters(vtkRenderer* renderer)
{
  Look(renderer, { 3.0, -6.0, 4.0 }, { 0.4, 0.2, 0.5 });
}

/// A rectangle in the plane of two directions.
vtkSmartPointer<vtkPolyData> MakeSheet(const Point& corner, const Point& u, const Point& v)
{
  Point a = corner;
  Point b = corner;
  Point c = corner;
  for (int i = 0; i < 3; ++i)
  {
    a[i] += u[i];
    b[i] += u[i] + v[i];
    c[i] += v[i];
  }
  return MakeMesh({ corner, a, b, c }, { { 0, 1, 2, 3 } });
}

void ThinWall(vtkRenderer* renderer)
{
  Prepare(renderer);
  AddBox(renderer, { 0.0, 0.0, 0.75 }, { 2.0, 1e-4, 1.5 });
  AddBox(renderer, { 0.5, -1.2, 0.5 }, { 1e-4, 1.0, 1.0 });
  LookAtCasters(renderer);
}

void PaperSheets(vtkRenderer* renderer)
{
  Prepare(renderer);
  AddMesh(renderer, MakeSheet({ -1.0, 0.0, 0.0 }, { 2.0, 0.5, 0.0 }, { 0.0, 0.0, 1.5 }));
  AddMesh(renderer, MakeSheet({ -1.0, -1.5, 1.0 }, { 1.0, 0.0, 0.2 }, { 0.0, 1.0, 0.1 }));
  LookAtCasters(renderer);
}

/// One long edge beside two short ones whose common point is not on it exactly.
void TJunctions(vtkRenderer* renderer)
{
  Prepare(renderer);
  const auto at = [](double x, double y) { return Point{ x, y, 1.0 + 0.1 * x + 0.07 * y }; };
  AddMesh(renderer,
    MakeMesh({ at(-1.1, -0.9), at(0.0, -0.9), at(0.0, 0.7), at(-1.1, 0.7), at(0.0, 0.1),
               at(1.3, -0.9), at(1.3, 0.1), at(1.3, 0.7) },
      { { 0, 1, 2, 3 }, { 1, 5, 6, 4 }, { 4, 6, 7, 2 } }));
  LookAtCasters(renderer);
}

/// A picture on the floor and boxes that share faces: what coincides does not shadow.
void Coplanar(vtkRenderer* renderer)
{
  Prepare(renderer);
  AddMesh(renderer, MakeSheet({ -0.5, -1.5, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.5, 0.0 }));
  AddBox(renderer, { -0.5, 0.0, 0.25 }, { 0.5, 0.5, 0.5 });
  AddBox(renderer, { -0.5, 0.0, 0.75 }, { 0.5, 0.5, 0.5 });
  AddBox(renderer, { 0.0, 0.0, 0.25 }, { 0.5, 0.5, 0.5 });
  LookAtCasters(renderer);
}

/// So many sheets above each other: a count that a stencil of eight bits cannot hold.
void Sheets(vtkRenderer* renderer, int count)
{
  Prepare(renderer);
  std::vector<Point> points;
  std::vector<Polygon> quads;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double z = 1.0 + static_cast<double>(i) / count;
    points.insert(
      points.end(), { { -0.5, -0.5, z }, { 0.5, -0.5, z }, { 0.5, 0.5, z }, { -0.5, 0.5, z } });
    quads.push_back({ 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3 });
  }
  AddMesh(renderer, MakeMesh(points, quads));
  LookAtCasters(renderer);
}

/// Triangles without area, and every face twice.
void Degenerates(vtkRenderer* renderer)
{
  Prepare(renderer);
  AddMesh(renderer,
    MakeMesh({ { 0.0, 0.0, 1.5 }, { 1.0, 0.0, 0.5 }, { -0.5, 0.75, 0.5 }, { -0.5, -0.75, 0.5 },
               { 0.5, 0.0, 1.0 }, { 1.0, 0.0, 0.5 } },
      { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 0, 1 }, { 0, 4, 1 }, { 1, 5, 2 },
        { 3, 3, 3 }, { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } }));
  LookAtCasters(renderer);
}

/// One triangle of a sphere has a point that is no number.
void NotANumber(vtkRenderer* renderer)
{
  Prepare(renderer);
  AddSphere(renderer, { 0.0, 0.0, 1.0 }, 0.7);
  vtkSmartPointer<vtkPolyData> mesh = MakeBox({ 0.8, -0.8, 0.5 }, { 0.5, 0.5, 0.5 });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mesh->GetPoints()->SetPoint(5, nan, nan, nan);
  // Bounds as they are without that point.
  vtkActor* actor = AddMesh(renderer, mesh);
  actor->UseBoundsOff();
  LookAtCasters(renderer);
}

/// Points repeated at the seams, and for every face where normals differ.
void RepeatedPoints(vtkRenderer* renderer)
{
  Prepare(renderer);
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetCenter(-0.8, 0.0, 1.0);
  cylinder->SetResolution(9);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(cylinder->GetOutputPort());
  normals->SetFeatureAngle(10.0);
  normals->SplittingOn();
  normals->Update();
  AddMesh(renderer, normals->GetOutput());
  AddSphere(renderer, { 0.8, 0.3, 0.8 }, 0.6);
  LookAtCasters(renderer);
}

/// Quads whose corners are in no plane, strips, and polygons of many corners.
void QuadsStripsPolygons(vtkRenderer* renderer)
{
  Prepare(renderer);
  AddMesh(renderer,
    MakeMesh({ { -1.5, -1.0, 1.4 }, { -0.5, -1.0, 0.6 }, { 0.5, -1.0, 1.4 }, { -1.5, 0.2, 0.6 },
               { -0.5, 0.2, 1.4 }, { 0.5, 0.2, 0.6 } },
      { { 0, 1, 4, 3 }, { 2, 5, 4, 1 } }));
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.9, 0.8, 0.8);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(sphere->GetOutputPort());
  stripper->Update();
  AddMesh(renderer, stripper->GetOutput());
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetCenter(0.9, -0.8, 0.6);
  cylinder->SetRadius(0.4);
  cylinder->SetResolution(7);
  cylinder->Update();
  AddMesh(renderer, cylinder->GetOutput());
  LookAtCasters(renderer);
}

void HalfSphere(vtkRenderer* renderer)
{
  Prepare(renderer);
  for (const double x : { -0.8, 0.8 })
  {
    vtkNew<vtkSphereSource> source;
    source->SetRadius(0.7);
    source->SetThetaResolution(16);
    source->SetPhiResolution(8);
    source->SetEndPhi(90.0);
    source->Update();
    vtkActor* actor = AddMesh(renderer, source->GetOutput());
    actor->SetPosition(x, 0.0, 1.0);
    actor->RotateX(x < 0.0 ? 200.0 : -30.0);
  }
  LookAtCasters(renderer);
}

void MoebiusStrip(vtkRenderer* renderer)
{
  Prepare(renderer);
  constexpr vtkIdType count = 40;
  std::vector<Point> points;
  std::vector<Polygon> quads;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / count;
    for (const double side : { -0.3, 0.3 })
    {
      const double radius = 1.0 + side * std::cos(0.5 * angle);
      points.push_back(
        { radius * std::cos(angle), radius * std::sin(angle), 1.0 + side * std::sin(0.5 * angle) });
    }
    const bool last = i == count - 1;
    const vtkIdType next = last ? 0 : 2 * i + 2;
    quads.push_back({ 2 * i, 2 * i + 1, next + (last ? 0 : 1), next + (last ? 1 : 0) });
  }
  AddMesh(renderer, MakeMesh(points, quads));
  LookAtCasters(renderer);
}

/// Three faces at one edge, and four at another.
void SharedEdges(vtkRenderer* renderer)
{
  Prepare(renderer);
  AddMesh(renderer,
    MakeMesh({ { -1.0, 0.0, 1.2 }, { 1.0, 0.0, 1.2 }, { -1.0, -0.8, 1.3 }, { 1.0, -0.8, 1.3 },
               { -1.0, 0.7, 1.0 }, { 1.0, 0.7, 1.0 }, { -1.0, 0.1, 0.4 }, { 1.0, 0.1, 0.4 },
               { -1.0, 1.2, 0.5 }, { 1.0, 1.2, 0.5 }, { -1.0, 0.7, 0.3 }, { 1.0, 0.7, 0.3 },
               { -1.0, 1.0, 1.5 }, { 1.0, 1.0, 1.5 } },
      { { 0, 1, 3, 2 }, { 0, 1, 5, 4 }, { 0, 1, 7, 6 }, { 4, 5, 9, 8 }, { 5, 4, 10, 11 },
        { 4, 5, 13, 12 } }));
  LookAtCasters(renderer);
}

/// Actors whose matrices turn meshes inside out, shear and squeeze them.
void Matrices(vtkRenderer* renderer)
{
  Prepare(renderer);
  vtkSmartPointer<vtkPolyData> box = MakeSharedBox({ 0.0, 0.0, 0.0 }, { 0.8, 0.8, 0.8 });
  vtkActor* mirrored = AddMesh(renderer, box);
  mirrored->SetPosition(-0.8, 0.0, 0.9);
  mirrored->SetScale(-1.0, 1.2, 0.7);
  mirrored->RotateWXYZ(35.0, 1.0, 2.0, 3.0);
  vtkActor* sheared = AddMesh(renderer, box);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 2, 0.7);
  matrix->SetElement(1, 0, -0.3);
  matrix->SetElement(2, 2, -1.5);
  matrix->SetElement(0, 3, 0.8);
  matrix->SetElement(2, 3, 0.9);
  sheared->SetUserMatrix(matrix);
  LookAtCasters(renderer);
}

void Assembly(vtkRenderer* renderer)
{
  Prepare(renderer);
  vtkActor* box = AddBox(renderer, { 0.0, 0.0, 0.0 }, { 0.8, 0.8, 0.8 });
  vtkActor* sphere = AddSphere(renderer, { 0.0, 0.0, 0.9 }, 0.4);
  vtkActor* hidden = AddSphere(renderer, { 1.5, 0.0, 0.9 }, 0.4);
  hidden->VisibilityOff();
  vtkNew<vtkAssembly> inner;
  vtkNew<vtkAssembly> outer;
  inner->AddPart(sphere);
  inner->AddPart(hidden);
  inner->RotateX(40.0);
  outer->AddPart(box);
  outer->AddPart(inner);
  outer->SetPosition(0.0, 0.0, 0.6);
  outer->RotateY(20.0);
  for (vtkActor* actor : { box, sphere, hidden })
  {
    renderer->RemoveActor(actor);
  }
  renderer->AddActor(outer);
  LookAtCasters(renderer);
}

/// Blocks within blocks, one of them hidden.
void Composite(vtkRenderer* renderer)
{
  Prepare(renderer);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, MakeBox({ 0.6, 0.0, 0.8 }, { 0.5, 0.5, 0.5 }));
  inner->SetBlock(1, MakeBox({ 0.6, 1.0, 0.8 }, { 0.5, 0.5, 0.5 }));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeSphere({ -0.7, 0.0, 0.9 }, 0.5, 12));
  blocks->SetBlock(1, inner);
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  attributes->SetBlockVisibility(inner->GetBlock(1), false);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  LookAtCasters(renderer);
}

/// The second prop is the box whose points move under the actor.
void ChangingData(vtkRenderer* renderer)
{
  Prepare(renderer);
  AddMesh(renderer, MakeSharedBox({ -0.5, 0.0, 0.8 }, { 0.8, 0.8, 0.8 }));
  AddSphere(renderer, { 1.0, 0.5, 0.6 }, 0.5);
  LookAtCasters(renderer);
}

void ChangeData(vtkRenderer* renderer)
{
  auto* actor = vtkActor::SafeDownCast(renderer->GetViewProps()->GetItemAsObject(1));
  auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    mesh->GetPoints()->SetPoint(i, x[0] + 0.7 * x[2], x[1] - 0.5, x[2] + 0.2);
  }
  mesh->GetPoints()->Modified();
  mesh->Modified();
}

/// The cut is open: light falls in.
void ClippingPlanes(vtkRenderer* renderer)
{
  Prepare(renderer);
  vtkActor* actor = AddSphere(renderer, { 0.0, 0.0, 1.0 }, 0.8);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.1, 0.0, 1.1);
  plane->SetNormal(0.6, -0.3, -0.8);
  actor->GetMapper()->AddClippingPlane(plane);
  LookAtCasters(renderer);
}

/// What is not drawn as surfaces casts nothing. It is out of view, because it would be seen.
void NotSurfaces(vtkRenderer* renderer)
{
  Prepare(renderer);
  AddBox(renderer, { 0.5, 0.5, 0.3 }, { 0.6, 0.6, 0.6 });
  AddSphere(renderer, { -2.4, -1.4, 3.0 }, 0.6)->GetProperty()->SetRepresentationToWireframe();
  AddSphere(renderer, { -3.0, -1.0, 3.0 }, 0.6)->GetProperty()->SetRepresentationToPoints();
  Look(renderer, { 2.0, -4.0, 2.5 }, { 0.4, 0.2, 0.2 });
}

/// Not to be seen, hence no casters: an actor, and an assembly whose part is switched on.
void HiddenActor(vtkRenderer* renderer)
{
  Prepare(renderer);
  AddBox(renderer, { 0.5, 0.5, 0.3 }, { 0.6, 0.6, 0.6 });
  AddSphere(renderer, { -0.5, 0.0, 1.0 }, 0.6)->VisibilityOff();
  vtkActor* part = AddSphere(renderer, { 0.8, -0.8, 1.0 }, 0.4);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(part);
  assembly->VisibilityOff();
  renderer->RemoveActor(part);
  renderer->AddActor(assembly);
  LookAtCasters(renderer);
}
}

namespace ShadowScenes
{
std::vector<NamedScene> GetMeshScenes()
{
  NamedScene changing = { "ChangingData", ChangingData };
  changing.Change = ChangeData;
  return {
    { "ThinWall", ThinWall },
    { "PaperSheets", PaperSheets },
    { "TJunctions", TJunctions },
    { "Coplanar", Coplanar },
    { "Sheets256", [](vtkRenderer* renderer) { Sheets(renderer, 256); } },
    { "Sheets512", [](vtkRenderer* renderer) { Sheets(renderer, 512); } },
    { "Degenerates", Degenerates },
    { "NotANumber", NotANumber },
    { "RepeatedPoints", RepeatedPoints },
    { "QuadsStripsPolygons", QuadsStripsPolygons },
    { "HalfSphere", HalfSphere },
    { "MoebiusStrip", MoebiusStrip },
    { "SharedEdges", SharedEdges },
    { "Matrices", Matrices },
    { "Assembly", Assembly },
    { "Composite", Composite },
    changing,
    { "ClippingPlanes", ClippingPlanes },
    { "NotSurfaces", NotSurfaces },
    { "HiddenActor", HiddenActor },
  };
}
}
