// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneChanges.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp3D.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

namespace
{
std::vector<vtkSmartPointer<vtkProp3D>> GetProps(vtkRenderer* renderer)
{
  std::vector<vtkSmartPointer<vtkProp3D>> result;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (auto* prop3D = vtkProp3D::SafeDownCast(prop))
    {
      result.push_back(prop3D);
    }
  }
  return result;
}

struct Mesh
{
  vtkActor* Actor;
  vtkSmartPointer<vtkPolyDataMapper> Mapper;
  vtkSmartPointer<vtkPolyData> Data;
};

/// Gives each actor a mapper and mesh of its own. The clipping planes stay shared.
std::vector<Mesh> GetOwnMeshes(vtkRenderer* renderer)
{
  std::vector<Mesh> result;
  for (vtkProp3D* prop : GetProps(renderer))
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    auto* shared = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
    auto* data = shared ? vtkPolyData::SafeDownCast(shared->GetInputDataObject(0, 0)) : nullptr;
    if (!data)
    {
      continue;
    }
    Mesh mesh{ actor, vtkSmartPointer<vtkPolyDataMapper>::New(),
      vtkSmartPointer<vtkPolyData>::New() };
    mesh.Data->DeepCopy(data);
    mesh.Mapper->SetInputData(mesh.Data);
    mesh.Mapper->SetClippingPlanes(shared->GetClippingPlanes());
    actor->SetMapper(mesh.Mapper);
    result.push_back(mesh);
  }
  return result;
}

vtkSmartPointer<vtkCellArray> GetRange(vtkCellArray* cells, vtkIdType first, vtkIdType last)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = first; i < last; ++i)
  {
    cells->GetCellAtId(i, ids);
    result->InsertNextCell(ids);
  }
  return result;
}
}

namespace SceneChanges
{
void FlipWindings(vtkRenderer* renderer)
{
  for (const Mesh& mesh : GetOwnMeshes(renderer))
  {
    vtkCellArray* cells = mesh.Data->GetPolys();
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); i += 2)
    {
      cells->GetCellAtId(i, ids);
      if (ids->GetNumberOfIds() > 0)
      {
        std::reverse(ids->GetPointer(1), ids->GetPointer(0) + ids->GetNumberOfIds());
        cells->ReplaceCellAtId(i, ids);
      }
    }
  }
}

void UnsharePoints(vtkRenderer* renderer)
{
  for (const Mesh& mesh : GetOwnMeshes(renderer))
  {
    if (mesh.Data->GetNumberOfStrips() > 0)
    {
      continue;
    }
    vtkNew<vtkPoints> points;
    points->SetDataType(mesh.Data->GetPoints()->GetDataType());
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < mesh.Data->GetNumberOfPolys(); ++i)
    {
      mesh.Data->GetPolys()->GetCellAtId(i, ids);
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        ids->SetId(k, points->InsertNextPoint(mesh.Data->GetPoint(ids->GetId(k))));
      }
      cells->InsertNextCell(ids);
    }
    vtkNew<vtkPolyData> unshared;
    unshared->SetPoints(points);
    unshared->SetPolys(cells);
    mesh.Mapper->SetInputData(unshared);
  }
}

void SplitActors(vtkRenderer* renderer)
{
  for (const Mesh& mesh : GetOwnMeshes(renderer))
  {
    const vtkIdType count = mesh.Data->GetNumberOfPolys();
    vtkNew<vtkPolyData> second;
    second->SetPoints(mesh.Data->GetPoints());
    second->SetPolys(GetRange(mesh.Data->GetPolys(), count / 2, count));
    mesh.Data->SetPolys(GetRange(mesh.Data->GetPolys(), 0, count / 2));
    mesh.Data->GetCellData()->Initialize();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(second);
    mapper->SetClippingPlanes(mesh.Mapper->GetClippingPlanes());
    vtkNew<vtkActor> actor;
    actor->ShallowCopy(mesh.Actor);
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
  }
}

void ReverseProps(vtkRenderer* renderer)
{
  std::vector<vtkSmartPointer<vtkProp3D>> props = GetProps(renderer);
  std::reverse(props.begin(), props.end());
  for (vtkProp3D* prop : props)
  {
    renderer->RemoveViewProp(prop);
    renderer->AddViewProp(prop);
  }
}

void Move(vtkRenderer* renderer, const glm::dvec3& offset)
{
  for (vtkProp3D* prop : GetProps(renderer))
  {
    // The user's matrix comes last.
    vtkNew<vtkMatrix4x4> matrix;
    if (prop->GetUserMatrix())
    {
      matrix->DeepCopy(prop->GetUserMatrix());
    }
    for (int i = 0; i < 3; ++i)
    {
      matrix->SetElement(i, 3, matrix->GetElement(i, 3) + offset[i]);
    }
    prop->SetUserMatrix(matrix);
    auto* actor = vtkActor::SafeDownCast(prop);
    vtkPlaneCollection* planes = actor ? actor->GetMapper()->GetClippingPlanes() : nullptr;
    for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
    {
      vtkPlane* plane = planes->GetItem(i);
      const glm::dvec3 origin = glm::make_vec3(plane->GetOrigin()) + offset;
      plane->SetOrigin(origin.x, origin.y, origin.z);
    }
  }
  const auto moveView = [&offset](auto* view)
  {
    const glm::dvec3 position = glm::make_vec3(view->GetPosition()) + offset;
    view->SetPosition(position.x, position.y, position.z);
    const glm::dvec3 focalPoint = glm::make_vec3(view->GetFocalPoint()) + offset;
    view->SetFocalPoint(focalPoint.x, focalPoint.y, focalPoint.z);
  };
  vtkCollectionSimpleIterator cookie;
  renderer->GetLights()->InitTraversal(cookie);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(cookie))
  {
    moveView(light);
  }
  moveView(renderer->GetActiveCamera());
}

std::vector<Change> GetChanges()
{
  return { { "windings", FlipWindings }, { "points", UnsharePoints }, { "actors", SplitActors },
    { "order", ReverseProps }, { "place", [](vtkRenderer* renderer) {
                                  Move(renderer, { 12.0, -7.0, 3.0 });
                                } } };
}
}
