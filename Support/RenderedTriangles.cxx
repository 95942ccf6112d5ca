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
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

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
    if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
    {
      this->AddGlyphs(glyphs, matrix);
      return;
    }
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

  /// The array of a glyph mapper with this index, by its name or as an attribute of the points.
  static vtkDataArray* GetArray(vtkGlyph3DMapper* mapper, int index)
  {
    vtkInformation* which = mapper->GetInputArrayInformation(index);
    vtkPointData* data = vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0))->GetPointData();
    return which->Has(vtkDataObject::FIELD_NAME())
      ? data->GetArray(which->Get(vtkDataObject::FIELD_NAME()))
      : vtkArrayDownCast<vtkDataArray>(
          data->GetAbstractAttribute(which->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE())));
  }

  /// One source, in the place of each point.
  void AddGlyphs(vtkGlyph3DMapper* mapper, vtkMatrix4x4* actorToWorld)
  {
    auto* data = vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
    if (!data || mapper->GetNumberOfInputConnections(1) != 1 || mapper->GetUseSourceTableTree())
    {
      throw std::invalid_argument("The triangles of these glyphs are not known.");
    }
    vtkDataArray* masks = mapper->GetMasking() ? GetArray(mapper, vtkGlyph3DMapper::MASK) : nullptr;
    vtkDataArray* turns =
      mapper->GetOrient() ? GetArray(mapper, vtkGlyph3DMapper::ORIENTATION) : nullptr;
    vtkDataArray* sizes =
      mapper->GetScaling() && mapper->GetScaleMode() != vtkGlyph3DMapper::NO_DATA_SCALING
      ? GetArray(mapper, vtkGlyph3DMapper::SCALE)
      : nullptr;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      if (masks && masks->GetComponent(i, 0) == 0.0)
      {
        continue;
      }
      vtkNew<vtkTransform> place;
      place->SetMatrix(actorToWorld);
      place->Translate(data->GetPoint(i));
      if (turns)
      {
        Turn(place, turns->GetTuple(i), mapper->GetOrientationMode());
      }
      double size[3] = { 1.0, 1.0, 1.0 };
      for (int k = 0; k < 3 && sizes; ++k)
      {
        size[k] = mapper->GetScaleMode() == vtkGlyph3DMapper::SCALE_BY_COMPONENTS
          ? sizes->GetComponent(i, k)
          : vtkMath::Norm(sizes->GetTuple(i), sizes->GetNumberOfComponents());
        if (mapper->GetClamping())
        {
          const double* range = mapper->GetRange();
          size[k] = (std::clamp(size[k], range[0], range[1]) - range[0]) / (range[1] - range[0]);
        }
      }
      for (double& value : size)
      {
        value *= mapper->GetScaling() ? mapper->GetScaleFactor() : 1.0;
        value = value == 0.0 ? 1e-10 : value;
      }
      place->Scale(size);
      this->Matrix = place->GetMatrix();
      this->AddMesh(vtkPolyData::SafeDownCast(mapper->GetInputDataObject(1, 0)));
    }
  }

  static void Turn(vtkTransform* place, const double* values, int mode)
  {
    if (mode == vtkGlyph3DMapper::ROTATION)
    {
      place->RotateZ(values[2]);
      place->RotateX(values[0]);
      place->RotateY(values[1]);
    }
    else if (mode == vtkGlyph3DMapper::DIRECTION)
    {
      // Half a turn about the middle between the x axis and the direction, or none at all.
      if (values[1] != 0.0 || values[2] != 0.0)
      {
        place->RotateWXYZ(180.0, values[0] + vtkMath::Norm(values), values[1], values[2]);
      }
      else if (values[0] < 0.0)
      {
        place->RotateY(180.0);
      }
    }
    else
    {
      place->RotateWXYZ(
        2.0 * vtkMath::DegreesFromRadians(std::acos(values[0])), values[1], values[2], values[3]);
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
