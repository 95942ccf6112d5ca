// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RenderedTriangles.h"
#include "CompositeMapper.h"

#include "vtkNBufferVTKVersion.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace
{
using Point = std::array<double, 3>;

/// The part of a convex polygon on the plane's positive side.
std::vector<Point> Clip(const std::vector<Point>& polygon, vtkPlane* plane)
{
  std::vector<Point> result;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    Point a = polygon[i];
    Point b = polygon[(i + 1) % polygon.size()];
    const double sideA = plane->EvaluateFunction(a.data());
    const double sideB = plane->EvaluateFunction(b.data());
    if (sideA >= 0.0)
    {
      result.push_back(a);
    }
    if ((sideA >= 0.0) != (sideB >= 0.0))
    {
      const double t = sideA / (sideA - sideB);
      result.push_back(
        { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) });
    }
  }
  return result;
}

class Collector
{
public:
  RenderedTriangles Result;

  void AddActor(vtkProp* prop, vtkActor* actor, vtkMatrix4x4* matrix)
  {
    vtkMapper* mapper = actor->GetMapper();
    if (!mapper || actor->GetProperty()->GetRepresentation() != VTK_SURFACE ||
      !actor->HasOpaqueGeometry())
    {
      return;
    }
    mapper->Update();
    this->Matrix = matrix;
    this->Planes = mapper->GetClippingPlanes();
    this->Attributes = nullptr;
    this->Result.Actors.push_back({ prop, actor });
    if (auto* composite = CompositeMapper::SafeDownCast(mapper))
    {
      this->Attributes = composite->GetCompositeDataDisplayAttributes();
    }
    this->AddData(mapper->GetInputDataObject(0, 0), true);
  }

private:
  void AddData(vtkDataObject* data, bool visible)
  {
    if (this->Attributes && this->Attributes->HasBlockVisibility(data))
    {
      visible = this->Attributes->GetBlockVisibility(data);
    }
    if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
    {
      for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
      {
        this->AddData(child, visible);
      }
    }
    else if (auto* mesh = vtkPolyData::SafeDownCast(data))
    {
      if (visible)
      {
        this->AddMesh(mesh);
      }
    }
    else
    {
      throw std::invalid_argument("The triangles of this mapper's input are not known.");
    }
  }

  void AddMesh(vtkPolyData* mesh)
  {
    std::vector<unsigned int> indices;
    if (mesh->GetNumberOfPolys() > 0)
    {
      vtkOpenGLIndexBufferObject::AppendTriangleIndexBuffer(
        indices, mesh->GetPolys(), mesh->GetPoints(), 0, nullptr, nullptr);
    }
    if (mesh->GetNumberOfStrips() > 0)
    {
      vtkOpenGLIndexBufferObject::AppendStripIndexBuffer(indices, mesh->GetStrips(), 0, false);
    }
    for (std::size_t i = 0; i < indices.size(); i += 3)
    {
      this->AddTriangle(mesh, &indices[i]);
    }
  }

  void AddTriangle(vtkPolyData* mesh, const unsigned int* indices)
  {
    std::vector<Point> polygon;
    for (int i = 0; i < 3; ++i)
    {
      double x[4] = { 0.0, 0.0, 0.0, 1.0 };
      mesh->GetPoint(indices[i], x);
      this->Matrix->MultiplyPoint(x, x);
      polygon.push_back({ x[0] / x[3], x[1] / x[3], x[2] / x[3] });
    }
    for (int i = 0; this->Planes && i < this->Planes->GetNumberOfItems(); ++i)
    {
      polygon = Clip(polygon, this->Planes->GetItem(i));
    }
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      this->Append(polygon[0], polygon[i - 1], polygon[i]);
    }
  }

  void Append(const Point& a, const Point& b, const Point& c)
  {
    std::vector<double>& corners = this->Result.Corners;
    const std::size_t size = corners.size();
    for (const Point* point : { &a, &b, &c })
    {
      corners.insert(corners.end(), point->begin(), point->end());
    }
    if (!std::all_of(
          corners.begin() + size, corners.end(), [](double value) { return std::isfinite(value); }))
    {
      corners.resize(size);
      return;
    }
    this->Result.Owners.push_back(static_cast<int>(this->Result.Actors.size()) - 1);
  }

  vtkMatrix4x4* Matrix = nullptr;
  vtkPlaneCollection* Planes = nullptr;
  vtkCompositeDataDisplayAttributes* Attributes = nullptr;
};
}

RenderedTriangles CollectRenderedTriangles(vtkRenderer* renderer)
{
  Collector collector;
  vtkCollectionSimpleIterator cookie;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      auto* actor = vtkActor::SafeDownCast(node->GetViewProp());
      if (actor && actor->GetVisibility())
      {
        collector.AddActor(prop, actor, node->GetMatrix());
      }
    }
  }
  return std::move(collector.Result);
}
