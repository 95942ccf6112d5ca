// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSurface.h"

#include "vtkNBufferForEachChild.h"
#include "vtkNBufferKnownClasses.h"
#include "vtkNBufferProtectedMembers.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellTypes.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSetMapper.h"
#include "vtkGenericCell.h"
#include "vtkGeometryFilter.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkTrivialProducer.h"

#include VTKNBUFFER_COMPOSITE_MAPPER_HEADER

#include <algorithm>
#include <limits>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
using vtkNBufferKnownClasses::GetKind;
using Kind = vtkNBufferKnownClasses::MapperKind;

namespace
{
using CompositeMapper = VTKNBUFFER_COMPOSITE_MAPPER;

/// The filters and sources that make the inputs of a mapper or texture.
std::vector<vtkAlgorithm*> GetProducers(vtkAlgorithm* algorithm)
{
  std::vector<vtkAlgorithm*> producers;
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      vtkAlgorithm* producer = algorithm->GetInputAlgorithm(port, i);
      if (producer && typeid(*producer) != typeid(vtkTrivialProducer))
      {
        producers.push_back(producer);
      }
    }
  }
  return producers;
}

bool HasLineCells(vtkDataSet* data)
{
  vtkNew<vtkCellTypes> types;
  data->VTKNBUFFER_GET_CELL_TYPES(types);
  vtkNew<vtkGenericCell> cell;
  for (int i = 0; i < types->GetNumberOfTypes(); ++i)
  {
    cell->SetCellType(types->GetCellType(i));
    if (cell->GetCellDimension() == 1)
    {
      return true;
    }
  }
  return false;
}

/// Whether a polydata, or a block of composite data that is one, has lines (or vertices).
bool HasLines(vtkDataObject* data, bool orVertices)
{
  return vtkNBufferAnyNode(data,
    [orVertices](vtkDataObject* node)
    {
      auto* mesh = vtkPolyData::SafeDownCast(node);
      return mesh && (mesh->GetNumberOfLines() > 0 || (orVertices && mesh->GetNumberOfVerts() > 0));
    });
}

/// Add a part for the data or, if it is composite, for each block. `part` has the attributes that
/// these inherit.
void AddBlocks(vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* data,
  vtkNBufferSurface::Part part, std::vector<vtkNBufferSurface::Part>& parts)
{
  if (data && attributes && attributes->HasBlockVisibility(data))
  {
    part.IsVisible = attributes->GetBlockVisibility(data);
  }
  if (data && attributes && attributes->HasBlockOpacity(data))
  {
    part.IsTranslucent = attributes->GetBlockOpacity(data) < 1.0;
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    vtkNBufferForEachChild(tree,
      [&](vtkDataObject* child)
      {
        AddBlocks(attributes, child, part, parts);
        return true;
      });
  }
  else if ((part.Mesh = vtkPolyData::SafeDownCast(data)))
  {
    parts.push_back(part);
  }
}

vtkNBufferSurface::Part MakePart(vtkMatrix4x4* toWorld)
{
  vtkNBufferSurface::Part part;
  std::copy_n(toWorld->GetData(), 16, part.ToWorld.begin());
  return part;
}
}

bool vtkNBufferSurface::IsPlain(vtkMapper* mapper)
{
  return GetKind(mapper) != Kind::Other;
}

bool vtkNBufferSurface::IsComposite(vtkMapper* mapper)
{
  return GetKind(mapper) == Kind::Composite;
}

bool vtkNBufferSurface::HasReplacedShaders(vtkActor* actor)
{
  vtkShaderProperty* shaders = vtkNBufferProtectedMembers::GetShaderProperty(actor);
  return shaders &&
    (shaders->HasVertexShaderCode() || shaders->HasFragmentShaderCode() ||
      shaders->HasGeometryShaderCode() || shaders->GetNumberOfShaderReplacements() > 0);
}

bool vtkNBufferSurface::DrawsAsSurface(vtkProperty* property, bool linesOrPoints)
{
  const bool mayHaveEdges = VTKNBUFFER_EDGES_KEEP_TRIANGLES && !linesOrPoints;
  return property->GetRepresentation() == VTK_SURFACE &&
    (mayHaveEdges || !property->GetEdgeVisibility()) && !property->GetVertexVisibility() &&
    !(linesOrPoints && (property->GetRenderPointsAsSpheres() || property->GetRenderLinesAsTubes()));
}

bool vtkNBufferSurface::HasOtherCoordinates(vtkActor* actor)
{
#if VTKNBUFFER_HAS_COORDINATE_SYSTEMS
  return actor->GetCoordinateSystem() != vtkProp3D::WORLD;
#else
  (void)actor;
  return false;
#endif
}

vtkPolyData* vtkNBufferSurface::GetOnlyPolyData(vtkMapper* mapper)
{
  const Kind kind = GetKind(mapper);
  if ((kind != Kind::PolyData && kind != Kind::DataSet) ||
    mapper->GetNumberOfInputConnections(0) != 1)
  {
    return nullptr;
  }
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  return input && typeid(*input) == typeid(vtkPolyData) ? static_cast<vtkPolyData*>(input)
                                                        : nullptr;
}

vtkOpenGLPolyDataMapper* vtkNBufferSurface::GetDrawingMapper(vtkMapper* mapper)
{
  auto* extracts = vtkDataSetMapper::SafeDownCast(mapper);
  return vtkOpenGLPolyDataMapper::SafeDownCast(extracts ? extracts->GetPolyDataMapper() : mapper);
}

std::vector<vtkTexture*> vtkNBufferSurface::GetTextures(vtkActor* actor)
{
  std::vector<vtkTexture*> textures;
  if (actor->GetTexture())
  {
    textures.push_back(actor->GetTexture());
  }
  for (const auto& [name, texture] : actor->GetProperty()->GetAllTextures())
  {
    if (texture)
    {
      textures.push_back(texture);
    }
  }
  return textures;
}

void vtkNBufferSurface::UpdatePipeline(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  if (mapper && !mapper->GetStatic() && !GetProducers(mapper).empty())
  {
    mapper->Update(); // This requests the piece that the mapper shows.
  }
  for (vtkTexture* texture : GetTextures(actor))
  {
    for (vtkAlgorithm* producer : GetProducers(texture))
    {
      producer->Update();
    }
  }
}

double vtkNBufferSurface::GetMargin(vtkActor* actor)
{
  vtkDataObject* input = actor->GetMapper()->GetInputDataObject(0, 0);
  const bool isRead = vtkPolyData::SafeDownCast(input) || vtkDataObjectTree::SafeDownCast(input);
  return isRead && !HasLines(input, true) ? 0.0 : GetMarginOfLines(actor->GetProperty());
}

double vtkNBufferSurface::GetMarginOfLines(vtkProperty* property)
{
  return 0.5 * std::max(property->GetLineWidth(), property->GetPointSize()) + 1.0;
}

double vtkNBufferSurface::GetLightingMargin(vtkActor* actor)
{
  if (HasReplacedShaders(actor) || HasOffset(actor))
  {
    return std::numeric_limits<double>::infinity();
  }
  const double margin = GetMargin(actor);
  vtkProperty* property = actor->GetProperty();
  return DrawsAsSurface(property, margin > 0.0) ? margin : GetMarginOfLines(property);
}

bool vtkNBufferSurface::DrawsLines(vtkMapper* mapper)
{
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  auto* data = vtkPolyData::SafeDownCast(input) ? nullptr : vtkDataSet::SafeDownCast(input);
  return data ? HasLineCells(data) : HasLines(input, false);
}

bool vtkNBufferSurface::HasOffset(vtkActor* actor)
{
  // Without global resolution only visible edges switch the mapper's parameters on.
  return vtkMapper::GetResolveCoincidentTopology() != VTK_RESOLVE_OFF ||
    actor->GetProperty()->GetEdgeVisibility();
}

bool vtkNBufferSurface::HasOffsetTowardsEye(vtkActor* actor, bool linesOrPoints)
{
  const int resolution = vtkMapper::GetResolveCoincidentTopology();
  if (resolution != VTK_RESOLVE_OFF && resolution != VTK_RESOLVE_POLYGON_OFFSET)
  {
    return true;
  }
  if (!HasOffset(actor))
  {
    return false;
  }
  double factor = 0.0;
  double units = 0.0;
  actor->GetMapper()->GetCoincidentTopologyPolygonOffsetParameters(factor, units);
  // With parameters, VTK's fragment shader writes the depth at the middle of the pixel. With
  // multisampling the middle may lie outside of the triangle, by half a pixel's diagonal at most,
  // and so nearer to the eye by less than the slope. A factor of 1 makes up for that.
  return linesOrPoints || ((factor != 0.0 || units != 0.0) && (factor < 1.0 || units < 0.0));
}

vtkBoundingBox vtkNBufferSurface::GetBoundsOfPoints(vtkMapper* mapper, bool visibleOnly)
{
  vtkBoundingBox box(mapper->GetBounds());
  std::vector<Part> parts;
  auto* composite = visibleOnly ? CompositeMapper::SafeDownCast(mapper) : nullptr;
  AddBlocks(composite ? composite->GetCompositeDataDisplayAttributes() : nullptr,
    mapper->GetInputDataObject(0, 0), {}, parts);
  for (const Part& part : parts)
  {
    if (part.IsVisible && part.Mesh->GetNumberOfPoints() > 0)
    {
      box.AddBounds(part.Mesh->GetPoints()->GetBounds());
    }
  }
  return box;
}

std::vector<vtkNBufferSurface::Plane> vtkNBufferSurface::GetClippingPlanes(vtkMapper* mapper)
{
  constexpr int mostPlanes = 6; // of which VTK's shaders know
  std::vector<Plane> result;
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < std::min(planes->GetNumberOfItems(), mostPlanes); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    const double* normal = plane->GetNormal();
    result.push_back(
      { normal[0], normal[1], normal[2], -vtkMath::Dot(normal, plane->GetOrigin()) });
  }
  return result;
}

bool vtkNBufferSurface::GetPartsAtHand(
  vtkActor* actor, vtkMatrix4x4* toWorld, std::vector<Part>& parts)
{
  parts.clear();
  vtkMapper* mapper = actor->GetMapper();
  auto* composite = CompositeMapper::SafeDownCast(mapper);
  if (!composite && !vtkNBufferKnownClasses::DrawsPolygons(mapper) &&
    !vtkDataSetMapper::SafeDownCast(mapper) && !IsComposite(mapper))
  {
    return false;
  }
  AddBlocks(composite ? composite->GetCompositeDataDisplayAttributes() : nullptr,
    mapper->GetInputDataObject(0, 0), MakePart(toWorld), parts);
  return composite || !parts.empty();
}

bool vtkNBufferSurface::GetParts(vtkActor* actor, vtkMatrix4x4* toWorld, std::vector<Part>& parts)
{
  if (GetPartsAtHand(actor, toWorld, parts))
  {
    return true;
  }
  auto* mapper = vtkDataSetMapper::SafeDownCast(actor->GetMapper());
  vtkDataObject* input = mapper ? mapper->GetInputDataObject(0, 0) : nullptr;
  if (!input)
  {
    return false;
  }
  if (!this->Extractor)
  {
    this->Extractor = vtkSmartPointer<vtkGeometryFilter>::New();
  }
  this->Extractor->SetInputData(input);
  this->Extractor->Update();
  parts.push_back(MakePart(toWorld));
  parts.back().Mesh = this->Extractor->GetOutput();
  return true;
}

vtkNBufferMesh vtkNBufferSurface::GetMesh(vtkPolyData* data)
{
  vtkNBufferMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), glm::value_ptr(mesh.Points[i]));
  }
  std::vector<unsigned int> indices;
  if (!mesh.Points.empty() && data->GetNumberOfPolys() > 0)
  {
    vtkOpenGLIndexBufferObject::AppendTriangleIndexBuffer(
      indices, data->GetPolys(), data->GetPoints(), 0, nullptr, nullptr);
  }
  if (!mesh.Points.empty() && data->GetNumberOfStrips() > 0)
  {
    vtkOpenGLIndexBufferObject::AppendStripIndexBuffer(indices, data->GetStrips(), 0, false);
  }
  mesh.Triangles.resize(indices.size() / 3);
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    mesh.Triangles[i] = { indices[3 * i], indices[3 * i + 1], indices[3 * i + 2] };
  }
  return mesh;
}
VTK_ABI_NAMESPACE_END
