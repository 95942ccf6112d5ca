// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "CityScene.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstdlib>

namespace NBufferExamples
{
namespace
{
/// In world coordinates: the user's matrix comes after the position.
void Move(vtkActor* actor, const double way[3])
{
  vtkMatrix4x4* shared = actor->GetUserMatrix();
  if (!shared)
  {
    actor->AddPosition(way[0], way[1], way[2]);
    return;
  }
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(shared);
  for (int i = 0; i < 3; ++i)
  {
    matrix->SetElement(i, 3, matrix->GetElement(i, 3) + way[i]);
  }
  actor->SetUserMatrix(matrix);
}
}

std::string Scene::GetPartName(std::size_t actor) const
{
  if (actor < this->PartNames.size() && !this->PartNames[actor].empty())
  {
    return this->PartNames[actor];
  }
  const bool isBuilding = this->Plan && actor < this->Plan->Buildings.size();
  return (isBuilding ? "building " : "part ") + std::to_string(actor + 1);
}

vtkBoundingBox Scene::GetBounds() const
{
  vtkBoundingBox box;
  for (vtkActor* actor : this->Actors)
  {
    const double* bounds = actor->GetBounds();
    if (bounds && bounds[0] <= bounds[1])
    {
      box.AddBounds(bounds);
    }
  }
  return box;
}

void Scene::Tile(int count)
{
  const vtkBoundingBox bounds = this->GetBounds();
  const int axes[2] = { this->UpAxis == 0 ? 1 : 0, this->UpAxis == 2 ? 1 : 2 };
  const std::size_t originals = this->Actors.size();
  const auto wanted = static_cast<std::size_t>(std::max(count, 0));
  for (int ring = 1; originals > 0 && this->Actors.size() < wanted; ++ring)
  {
    for (int place = 0; place < (2 * ring + 1) * (2 * ring + 1); ++place)
    {
      const int tile[2] = { place % (2 * ring + 1) - ring, place / (2 * ring + 1) - ring };
      if (std::max(std::abs(tile[0]), std::abs(tile[1])) < ring)
      {
        continue;
      }
      for (std::size_t i = 0; i < originals && this->Actors.size() < wanted; ++i)
      {
        vtkActor* original = this->Actors[i];
        auto copy = vtkSmartPointer<vtkActor>::New();
        copy->ShallowCopy(original);
        double way[3] = { 0.0, 0.0, 0.0 };
        for (int j = 0; j < 2; ++j)
        {
          way[axes[j]] = tile[j] * bounds.GetLength(axes[j]);
        }
        Move(copy, way);
        this->Actors.push_back(copy);
        if (i < this->PartNames.size())
        {
          this->PartNames.push_back(std::string(this->PartNames[i]));
        }
      }
    }
  }
}

void Scene::AddTo(vtkRenderer* renderer) const
{
  for (vtkActor* actor : this->Actors)
  {
    // AddActor() looks through all props for each one, and these are all different.
    renderer->GetViewProps()->AddItem(actor);
    actor->AddConsumer(renderer);
  }
  if (this->Plan)
  {
    LightCity(renderer);
  }
  else
  {
    // VTK adds a headlight by itself.
    renderer->SetBackground(0.85, 0.88, 0.91);
  }
}

} // namespace NBufferExamples
