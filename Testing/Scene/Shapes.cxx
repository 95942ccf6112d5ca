// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

#include "Random.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TestScene
{
namespace
{
constexpr int LargestDetail = 64;

/// Collects points given as shares of a box, -0.5 to 0.5, and cells of them.
class Builder
{
public:
  explicit Builder(const Shape& shape)
    : Box(shape)
  {
  }

  vtkIdType Point(double x, double y, double z)
  {
    const glm::dvec3& c = this->Box.Center;
    const glm::dvec3& s = this->Box.Size;
    return this->Points->InsertNextPoint(c[0] + x * s[0], c[1] + y * s[1], c[2] + z * s[2]);
  }
  /// A point of a corner of its own for each face, with the face's normal.
  vtkIdType Point(double x, double y, double z, const glm::dvec3& normal)
  {
    this->Normals->InsertNextTuple3(normal[0], normal[1], normal[2]);
    return this->Point(x, y, z);
  }
  vtkIdType AnyPoint(NBufferExamples::Random& random)
  {
    const double x = random.Between(-0.5, 0.5);
    const double y = random.Between(-0.5, 0.5);
    return this->Point(x, y, random.Between(-0.5, 0.5));
  }
  void Polygon(std::initializer_list<vtkIdType> points) { this->Polygons->InsertNextCell(points); }
  void UprightQuad(double x0, double y0, double x1, double y1)
  {
    const vtkIdType first = this->Point(x0, y0, 0.0);
    this->Point(x1, y0, 0.0);
    this->Point(x1, y1, 0.0);
    this->Point(x0, y1, 0.0);
    this->Polygon({ first, first + 1, first + 2, first + 3 });
  }

  vtkSmartPointer<vtkPolyData> Finish()
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    if (this->Polygons->GetNumberOfCells() > 0)
    {
      data->SetPolys(this->Polygons);
    }
    if (this->Strips->GetNumberOfCells() > 0)
    {
      data->SetStrips(this->Strips);
    }
    if (this->Lines->GetNumberOfCells() > 0)
    {
      data->SetLines(this->Lines);
    }
    if (this->Verts->GetNumberOfCells() > 0)
    {
      data->SetVerts(this->Verts);
    }
    if (this->Normals->GetNumberOfTuples() > 0)
    {
      data->GetPointData()->SetNormals(this->Normals);
    }
    return data;
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polygons;
  vtkNew<vtkCellArray> Strips;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Verts;

  Builder(const Builder&) = delete;
  void operator=(const Builder&) = delete;

  void InitializeNormals()
  {
    this->Normals->SetNumberOfComponents(3);
    this->Normals->SetName("Normals");
  }

private:
  const Shape& Box;
  vtkNew<vtkFloatArray> Normals;
};

void AddRings(Builder& builder, int detail)
{
  builder.InitializeNormals();
  const int columns = 6 + 2 * detail;
  const int rows = 3 + detail;
  for (int row = 0; row <= rows; ++row)
  {
    const double latitude = vtkMath::Pi() * (static_cast<double>(row) / rows - 0.5);
    for (int column = 0; column < columns; ++column)
    {
      const double longitude = 2.0 * vtkMath::Pi() * column / columns;
      const glm::dvec3 n = { std::cos(latitude) * std::cos(longitude),
        std::cos(latitude) * std::sin(longitude), std::sin(latitude) };
      builder.Point(0.5 * n[0], 0.5 * n[1], 0.5 * n[2], n);
      if (row > 0)
      {
        const vtkIdType below = static_cast<vtkIdType>(row - 1) * columns;
        const vtkIdType next = (column + 1) % columns;
        builder.Polygon(
          { below + column, below + next, below + columns + next, below + columns + column });
      }
    }
  }
}

void AddTerrain(Builder& builder, int detail, NBufferExamples::Random& random)
{
  for (int j = 0; j <= detail; ++j)
  {
    for (int i = 0; i <= detail; ++i)
    {
      const vtkIdType id = builder.Point(static_cast<double>(i) / detail - 0.5,
        static_cast<double>(j) / detail - 0.5, random.Between(-0.5, 0.5));
      if (i > 0 && j > 0)
      {
        builder.Polygon({ id - detail - 2, id - detail - 1, id });
        builder.Polygon({ id - detail - 2, id, id - 1 });
      }
    }
  }
}

void AddLattice(Builder& builder, const Shape& shape, int detail, NBufferExamples::Random& random)
{
  for (int j = 0; j < detail; ++j)
  {
    for (int i = 0; i < detail; ++i)
    {
      if (random.Between(0.0, 1.0) < shape.Fill)
      {
        builder.UprightQuad(static_cast<double>(i) / detail - 0.5,
          static_cast<double>(j) / detail - 0.5, (i + 1.0) / detail - 0.5,
          (j + 1.0) / detail - 0.5);
      }
    }
  }
}

void AddBook(Builder& builder, int leaves)
{
  const vtkIdType bottom = builder.Point(0.0, -0.5, 0.0);
  const vtkIdType top = builder.Point(0.0, 0.5, 0.0);
  for (int i = 0; i < leaves; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / leaves;
    const double x = 0.5 * std::cos(angle);
    const double z = 0.5 * std::sin(angle);
    const vtkIdType low = builder.Point(x, -0.5, z);
    const vtkIdType high = builder.Point(x, 0.5, z);
    if (i % 2)
    {
      builder.Polygon({ bottom, low, high, top });
    }
    else
    {
      builder.Polygon({ bottom, top, high, low });
    }
  }
}

void AddStack(Builder& builder, int sheets)
{
  for (int i = 0; i < sheets; ++i)
  {
    const double y = (i + 0.5) / sheets - 0.5;
    const vtkIdType first = builder.Point(-0.5, y, -0.5);
    builder.Point(-0.5, y, 0.5);
    builder.Point(0.5, y, 0.5);
    builder.Point(0.5, y, -0.5);
    builder.Polygon({ first, first + 1, first + 2, first + 3 });
  }
}

void AddStrip(Builder& builder, int detail, NBufferExamples::Random& random)
{
  builder.Strips->InsertNextCell(2 * (detail + 1));
  for (int i = 0; i <= detail; ++i)
  {
    for (double y : { -0.5, 0.5 })
    {
      builder.Strips->InsertCellPoint(
        builder.Point(static_cast<double>(i) / detail - 0.5, y, random.Between(-0.5, 0.5)));
    }
  }
}

void AddSharedBox(Builder& builder)
{
  for (int i = 0; i < 8; ++i)
  {
    builder.Point(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
  }
  for (const auto& face : { std::initializer_list<vtkIdType>{ 0, 2, 3, 1 }, { 4, 5, 7, 6 },
         { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } })
  {
    builder.Polygon(face);
  }
}

void AddTiles(Builder& builder, int detail)
{
  for (int j = 0; j <= detail; ++j)
  {
    for (int i = 0; i <= detail; ++i)
    {
      const vtkIdType id = builder.Point(
        static_cast<double>(i) / detail - 0.5, static_cast<double>(j) / detail - 0.5, 0.0);
      if (i > 0 && j > 0)
      {
        builder.Polygon({ id - detail - 2, id - detail - 1, id, id - 1 });
      }
    }
  }
}

void AddScraps(Builder& builder, int detail, bool asStrips, NBufferExamples::Random& random)
{
  for (int i = 0; i < detail; ++i)
  {
    const double width = random.Between(0.03, 0.3);
    const double height = random.Between(0.03, 0.3);
    const double x = random.Between(-0.5, 0.5 - width);
    const double y = random.Between(-0.5, 0.5 - height);
    const double z = 0.5 * static_cast<double>(random.Index(3)) - 0.5;
    const glm::dvec3 normal =
      glm::normalize(glm::dvec3(random.Between(-1.0, 1.0), random.Between(-1.0, 1.0), 0.5));
    const vtkIdType first = builder.Point(x, y, z, normal);
    builder.Point(x + width, y, z, normal);
    builder.Point(x + width, y + height, z, normal);
    builder.Point(x, y + height, z, normal);
    if (asStrips)
    {
      builder.Strips->InsertNextCell({ first, first + 1, first + 3, first + 2 });
    }
    else
    {
      builder.Polygon({ first, first + 1, first + 2, first + 3 });
    }
  }
}

/// What refers to a point that is not there is left out.
void AddMesh(Builder& builder, const Shape& shape)
{
  const std::vector<double>& points = shape.Points;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3)
  {
    builder.Point(points[i], points[i + 1], points[i + 2]);
  }
  const auto count = static_cast<double>(builder.Points->GetNumberOfPoints());
  std::vector<vtkIdType> polygon;
  for (std::size_t i = 0; i < shape.Polygons.size();)
  {
    const double corners = shape.Polygons[i++];
    polygon.clear();
    for (; i < shape.Polygons.size() && polygon.size() < corners; ++i)
    {
      if (shape.Polygons[i] >= 0.0 && shape.Polygons[i] < count)
      {
        polygon.push_back(static_cast<vtkIdType>(shape.Polygons[i]));
      }
    }
    vtkCellArray* cells = polygon.size() > 2 ? builder.Polygons
      : polygon.size() == 2                  ? builder.Lines
                                             : builder.Verts;
    if (!polygon.empty())
    {
      cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
    }
  }
}

/// A shape that VTK has a source for.
template <typename Source>
vtkSmartPointer<vtkPolyData> Finish(Source* source, int precision)
{
  source->SetOutputPointsPrecision(
    precision == VTK_DOUBLE ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::SINGLE_PRECISION);
  source->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(source->GetOutput());
  return data;
}

/// nullptr if it is one of those that AddCells() makes.
vtkSmartPointer<vtkPolyData> MakeFromSource(const Shape& shape, int precision)
{
  const auto setRound = [&shape](auto* source)
  {
    source->SetCenter(shape.Center[0], shape.Center[1], shape.Center[2]);
    source->SetRadius(0.5 * shape.Size[0]);
  };
  const int detail = std::clamp(shape.Detail, 3, LargestDetail);
  switch (shape.Kind)
  {
    case ShapeKind::Empty:
      return shape.Seed % 2 ? vtkSmartPointer<vtkPolyData>::New() : nullptr;
    case ShapeKind::Box:
    case ShapeKind::NaNPoint:
      return MakeBox(shape.Center, shape.Size, precision);
    case ShapeKind::Globe:
    {
      vtkNew<vtkSphereSource> source;
      setRound(source.Get());
      source->SetThetaResolution(detail);
      source->SetPhiResolution(detail);
      return Finish(source.Get(), precision);
    }
    case ShapeKind::Cylinder:
    {
      vtkNew<vtkCylinderSource> source;
      setRound(source.Get());
      source->SetHeight(shape.Size[1]);
      source->SetResolution(detail);
      return Finish(source.Get(), precision);
    }
    case ShapeKind::Cone:
    {
      vtkNew<vtkConeSource> source;
      setRound(source.Get());
      source->SetHeight(shape.Size[1]);
      source->SetResolution(detail);
      return Finish(source.Get(), precision);
    }
    default:
      return nullptr;
  }
}

void AddCells(Builder& builder, const Shape& shape, int detail)
{
  NBufferExamples::Random random(static_cast<std::uint64_t>(shape.Seed) + 1);
  switch (shape.Kind)
  {
    case ShapeKind::Sphere:
      AddRings(builder, std::min(detail, 8));
      break;
    case ShapeKind::Quad:
      builder.UprightQuad(-0.5, -0.5, 0.5, 0.5);
      break;
    case ShapeKind::Grating:
      for (int i = 0; i < detail; ++i)
      {
        builder.UprightQuad(static_cast<double>(i) / detail - 0.5, -0.5,
          (i + std::min(std::max(shape.Fill, 0.0), 1.0)) / detail - 0.5, 0.5);
      }
      break;
    case ShapeKind::Lattice:
      AddLattice(builder, shape, std::min(detail, 16), random);
      break;
    case ShapeKind::Terrain:
      AddTerrain(builder, std::min(detail, 16), random);
      break;
    case ShapeKind::Soup:
      for (int i = 0; i < detail; ++i)
      {
        const vtkIdType a = builder.AnyPoint(random);
        const vtkIdType b = builder.AnyPoint(random);
        builder.Polygon({ a, b, builder.AnyPoint(random) });
      }
      break;
    case ShapeKind::Lines:
      for (int i = 0; i < detail; ++i)
      {
        const vtkIdType a = builder.AnyPoint(random);
        builder.Lines->InsertNextCell({ a, builder.AnyPoint(random) });
      }
      break;
    case ShapeKind::Points:
      for (int i = 0; i < detail; ++i)
      {
        builder.Verts->InsertNextCell({ builder.AnyPoint(random) });
      }
      break;
    case ShapeKind::Book:
      AddBook(builder, detail);
      break;
    case ShapeKind::Strip:
      AddStrip(builder, detail, random);
      break;
    case ShapeKind::Stack:
      AddStack(builder, detail);
      break;
    case ShapeKind::SharedBox:
      AddSharedBox(builder);
      break;
    case ShapeKind::Tiles:
      AddTiles(builder, detail);
      break;
    case ShapeKind::Scraps:
    case ShapeKind::Ribbons:
      AddScraps(builder, detail, shape.Kind == ShapeKind::Ribbons, random);
      break;
    case ShapeKind::Mesh:
      AddMesh(builder, shape);
      break;
    default:
      break;
  }
}

void AddScalars(vtkPolyData* data, Translucency translucency)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double alpha = translucency == Translucency::Some && i % 3 == 0 ? 90.0 : 255.0;
    colors->InsertNextTuple4(
      static_cast<double>(80 * i % 256), 200.0, static_cast<double>(255 - 40 * i % 256), alpha);
  }
  data->GetPointData()->SetScalars(colors);
}

void AddCellValues(vtkPolyData* data, int seed)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  NBufferExamples::Random random(static_cast<std::uint64_t>(seed));
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    colors->InsertNextTuple3(random.Index(256), random.Index(256), random.Index(256));
    const glm::dvec3 normal =
      glm::normalize(glm::dvec3(random.Between(-1.0, 1.0), random.Between(-1.0, 1.0), 0.5));
    normals->InsertNextTuple(glm::value_ptr(normal));
  }
  data->GetCellData()->SetScalars(colors);
  data->GetCellData()->SetNormals(normals);
}
}

vtkSmartPointer<vtkPolyData> MakeBox(
  const glm::dvec3& center, const glm::dvec3& size, int precision)
{
  vtkNew<vtkCubeSource> source;
  source->SetCenter(center[0], center[1], center[2]);
  source->SetXLength(size[0]);
  source->SetYLength(size[1]);
  source->SetZLength(size[2]);
  return Finish(source.Get(), precision);
}

void MovePoints(vtkPoints* points, const glm::dvec3& way, double shear)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, p[0] + way.x + shear * p[2], p[1] + way.y, p[2] + way.z);
  }
  points->Modified();
}

void ReversePoints(vtkPolyData* data)
{
  const vtkIdType size = data->GetNumberOfPoints();
  if (size == 0)
  {
    return;
  }
  vtkNew<vtkIdList> before;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < size; ++i)
  {
    before->InsertNextId(size - 1 - i);
    ids->InsertNextId(i);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(data->GetPoints()->GetDataType());
  points->SetNumberOfPoints(size);
  data->GetPoints()->GetPoints(before, points);
  data->SetPoints(points);
  vtkNew<vtkPointData> values;
  values->CopyAllOn();
  values->CopyAllocate(data->GetPointData(), size);
  values->CopyData(data->GetPointData(), before, ids);
  data->GetPointData()->ShallowCopy(values);
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      cells->GetCellAtId(i, ids);
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        ids->SetId(k, size - 1 - ids->GetId(k));
      }
      cells->ReplaceCellAtId(i, ids);
    }
  }
}

vtkSmartPointer<vtkPolyData> MakeShape(const Shape& shape, Translucency scalars)
{
  // Large coordinates would lose their shape as floats before VTK moves them.
  const bool large = glm::any(glm::greaterThan(glm::abs(shape.Center), glm::dvec3(1e3)));
  const int precision = large || shape.Seed % 2 ? VTK_DOUBLE : VTK_FLOAT;
  vtkSmartPointer<vtkPolyData> data = MakeFromSource(shape, precision);
  if (!data)
  {
    Builder builder(shape);
    builder.Points->SetDataType(precision);
    AddCells(builder, shape, std::min(std::max(shape.Detail, 1), LargestDetail));
    data = builder.Finish();
  }
  if (shape.Kind == ShapeKind::NaNPoint)
  {
    const double value = shape.Seed % 2 ? std::numeric_limits<double>::infinity()
                                        : std::numeric_limits<double>::quiet_NaN();
    data->GetPoints()->SetPoint(0, value, shape.Center[1], shape.Center[2]);
  }
  if (shape.CellValues)
  {
    AddCellValues(data, shape.Seed);
  }
  if (scalars != Translucency::None)
  {
    AddScalars(data, scalars);
  }
  return data;
}
}
