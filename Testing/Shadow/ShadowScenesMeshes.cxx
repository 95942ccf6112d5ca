// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CompositeMapper.h"
#include "ShadowScenes.h"

#include "ShadowShapes.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCylinderSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <limits>

using namespace ShadowShapes;

namespace
{
/// One triangle of a sphere has a point that is no number.
void NotANumber(vtkRenderer* renderer)
{
  AddMesh(renderer, MakeGlobe({ 0.0, 0.0, 1.0 }, 0.7, 16));
  vtkSmartPointer<vtkPolyData> mesh = MakeBox({ 0.8, -0.8, 0.5 }, { 0.5, 0.5, 0.5 });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mesh->GetPoints()->SetPoint(5, nan, nan, nan);
  // Bounds as they are without that point.
  vtkActor* actor = AddMesh(renderer, mesh);
  actor->UseBoundsOff();
}

/// Points repeated at the seams, and for every face where normals differ.
void RepeatedPoints(vtkRenderer* renderer)
{
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetCenter(-0.8, 0.0, 1.0);
  cylinder->SetResolution(9);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(cylinder->GetOutputPort());
  normals->SetFeatureAngle(10.0);
  normals->SplittingOn();
  normals->Update();
  AddMesh(renderer, normals->GetOutput());
  AddMesh(renderer, MakeGlobe({ 0.8, 0.3, 0.8 }, 0.6, 16));
}

void HalfSphere(vtkRenderer* renderer)
{
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
}

void Assembly(vtkRenderer* renderer)
{
  vtkActor* box = AddMesh(renderer, MakeBox({ 0.0, 0.0, 0.0 }, { 0.8, 0.8, 0.8 }, VTK_DOUBLE));
  vtkActor* sphere = AddMesh(renderer, MakeGlobe({ 0.0, 0.0, 0.9 }, 0.4, 16));
  vtkActor* hidden = AddMesh(renderer, MakeGlobe({ 1.5, 0.0, 0.9 }, 0.4, 16));
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
}

/// Blocks within blocks, one of them hidden.
void Composite(vtkRenderer* renderer)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, MakeBox({ 0.6, 0.0, 0.8 }, { 0.5, 0.5, 0.5 }));
  inner->SetBlock(1, MakeBox({ 0.6, 1.0, 0.8 }, { 0.5, 0.5, 0.5 }));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeGlobe({ -0.7, 0.0, 0.9 }, 0.5, 12));
  blocks->SetBlock(1, inner);
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  attributes->SetBlockVisibility(inner->GetBlock(1), false);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

/// The second prop is the box whose points move under the actor.
void ChangingData(vtkRenderer* renderer)
{
  SceneBuilder scene;
  scene.UsesDoubles = true;
  AddMesh(renderer,
    TestScene::MakeShape(
      scene.Add(TestScene::ShapeKind::SharedBox, { -0.5, 0.0, 0.8 }, { 0.8, 0.8, 0.8 }).Shape));
  AddMesh(renderer, MakeGlobe({ 1.0, 0.5, 0.6 }, 0.5, 16));
}

void ChangeData(vtkRenderer* renderer)
{
  auto* actor = vtkActor::SafeDownCast(renderer->GetViewProps()->GetItemAsObject(1));
  auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Point x = vtkNBufferGLM::ToVector(mesh->GetPoint(i));
    mesh->GetPoints()->SetPoint(i, x[0] + 0.7 * x[2], x[1] - 0.5, x[2] + 0.2);
  }
  mesh->GetPoints()->Modified();
  mesh->Modified();
}
}

namespace ShadowScenes
{
std::vector<NamedScene> GetHandmadeScenes()
{
  using Add = std::function<void(vtkRenderer*)>;
  // What the casters stand on or float above, with a light from above.
  const auto make = [](const char* name, const Add& add, const Add& change = {})
  {
    const auto build = [add](vtkRenderer* renderer)
    {
      Fill(renderer,
        [](SceneBuilder& scene)
        {
          scene.Floor(5.0);
          scene.Directional({ 0.6, 0.35, -0.7 });
        });
      add(renderer);
      Look(renderer, { 3.0, -6.0, 4.0 }, { 0.4, 0.2, 0.5 });
    };
    return NamedScene{ name, build, 200, 150, 0, change };
  };
  return {
    make("NotANumber", NotANumber),
    make("RepeatedPoints", RepeatedPoints),
    make("HalfSphere", HalfSphere),
    make("Assembly", Assembly),
    make("Composite", Composite),
    make("ChangingData", ChangingData, ChangeData),
  };
}
}
