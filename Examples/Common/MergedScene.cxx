// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene as one prop.
#include "CompositeMapper.h"
#include "Random.h"
#include "Scene.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkMatrixToLinearTransform.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTransformFilter.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace NBufferExamples
{
namespace
{
/// The polygons of an actor with their normals, in world coordinates.
vtkSmartPointer<vtkPolyData> MakePart(vtkActor* actor, const std::string& scene)
{
  auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  if (!data)
  {
    throw std::runtime_error(
      scene + " has parts other than polygons, so that its parts cannot be merged");
  }
  vtkNew<vtkMatrixToLinearTransform> transform;
  transform->SetInput(actor->GetMatrix());
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(data->GetPoints());
  bare->SetPolys(data->GetPolys());
  bare->SetStrips(data->GetStrips());
  bare->GetPointData()->SetNormals(data->GetPointData()->GetNormals());
  vtkNew<vtkTransformFilter> move;
  move->SetTransform(transform);
  move->SetInputData(bare);
  move->Update();
  return move->GetPolyDataOutput();
}

vtkSmartPointer<vtkMapper> MergeToMesh(const Scene& scene)
{
  vtkNew<vtkAppendPolyData> append;
  for (vtkActor* actor : scene.Actors)
  {
    const vtkSmartPointer<vtkPolyData> part = MakePart(actor, scene.Name);
    const double* color = actor->GetProperty()->GetColor();
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("color");
    colors->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      colors->InsertNextTuple3(255.0 * color[0], 255.0 * color[1], 255.0 * color[2]);
    }
    part->GetPointData()->SetScalars(colors);
    append->AddInputData(part);
  }
  // A mesh of triangles and strips is not divided.
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(append->GetOutputPort());
  triangles->Update();
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(triangles->GetOutput());
  return mapper;
}

vtkSmartPointer<vtkMapper> MergeToBlocks(const Scene& scene)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  for (vtkActor* actor : scene.Actors)
  {
    const vtkSmartPointer<vtkPolyData> part = MakePart(actor, scene.Name);
    blocks->SetBlock(blocks->GetNumberOfBlocks(), part);
    attributes->SetBlockColor(part, actor->GetProperty()->GetColor());
  }
  auto mapper = vtkSmartPointer<CompositeMapper>::New();
  mapper->SetInputDataObject(blocks);
  mapper->SetCompositeDataDisplayAttributes(attributes);
  return mapper;
}
}

void Scene::Merge(bool toBlocks)
{
  const vtkSmartPointer<vtkMapper> mapper = toBlocks ? MergeToBlocks(*this) : MergeToMesh(*this);
  mapper->SetStatic(true);
  vtkNew<vtkActor> merged;
  merged->SetMapper(mapper);
  merged->GetProperty()->SetInterpolation(this->Actors.front()->GetProperty()->GetInterpolation());
  this->Actors = { merged };
  this->PartNames.clear();
}

void Scene::Shuffle()
{
  vtkActor* actor = this->Actors.size() == 1 ? this->Actors.front() : nullptr;
  auto* mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  auto* data = mapper ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) : nullptr;
  if (!data || data->GetNumberOfCells() != data->GetNumberOfPolys())
  {
    throw std::runtime_error(
      this->Name + " is not one mesh of polygons, the order of which could be shuffled");
  }
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(data);
  triangulate->Update();
  vtkPolyData* triangles = triangulate->GetOutput();
  std::vector<vtkIdType> order(static_cast<std::size_t>(triangles->GetNumberOfCells()));
  std::iota(order.begin(), order.end(), 0);
  Random random(1);
  for (std::size_t i = order.size(); i > 1; --i)
  {
    std::swap(order[i - 1], order[random.Index(i)]);
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkPolyData> shuffled;
  shuffled->SetPoints(triangles->GetPoints());
  shuffled->GetPointData()->ShallowCopy(triangles->GetPointData());
  shuffled->GetCellData()->CopyAllocate(triangles->GetCellData());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    triangles->GetPolys()->GetCellAtId(order[i], size, points);
    cells->InsertNextCell(size, points);
    shuffled->GetCellData()->CopyData(
      triangles->GetCellData(), order[i], static_cast<vtkIdType>(i));
  }
  shuffled->SetPolys(cells);
  mapper->SetInputData(shuffled);
}

} // namespace NBufferExamples
