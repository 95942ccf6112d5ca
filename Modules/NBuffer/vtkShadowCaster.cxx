// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCaster.h"

#include "vtkCellArray.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// As the mapper makes its index buffer.
std::vector<vtkIdType> GetTriangles(vtkPolyData* mesh)
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
  return std::vector<vtkIdType>(indices.begin(), indices.end());
}

std::shared_ptr<const vtkShadowTopology> MakeTopology(vtkPolyData* mesh)
{
  auto topology = std::make_shared<vtkShadowTopology>();
  const vtkIdType count = mesh->GetNumberOfPoints();
  std::vector<double> points(3 * static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    mesh->GetPoint(i, &points[3 * static_cast<std::size_t>(i)]);
  }
  const std::vector<vtkIdType> triangles = count > 0 ? GetTriangles(mesh) : std::vector<vtkIdType>();
  topology->Build(
    points.data(), count, triangles.data(), static_cast<vtkIdType>(triangles.size() / 3));
  return topology;
}

/// Triangles [begin, end) alone, in coordinates that the caller has.
std::shared_ptr<const vtkShadowTopology> MakeTopology(
  const vtkShadowTopology& whole, const std::vector<double>& points, int begin, int end)
{
  const std::vector<vtkIdType> triangles(
    whole.GetTriangles().begin() + 3 * begin, whole.GetTriangles().begin() + 3 * end);
  auto topology = std::make_shared<vtkShadowTopology>();
  topology->Build(
    points.data(), whole.GetNumberOfPoints(), triangles.data(), end - begin);
  return topology;
}

bool IsSame(const vtkShadowLight& a, const vtkShadowLight& b)
{
  return a.Kind == b.Kind && a.ConeAngle == b.ConeAngle &&
    std::equal(a.Position, a.Position + 3, b.Position) &&
    std::equal(a.Direction, a.Direction + 3, b.Direction);
}
}

bool vtkShadowCaster::Update(vtkPolyData* mesh, vtkMatrix4x4* matrix)
{
  const bool newMesh = this->Mesh != mesh || this->MeshTime != mesh->GetMTime();
  if (newMesh)
  {
    this->Topology = MakeTopology(mesh);
    this->Mesh = mesh;
    this->MeshTime = mesh->GetMTime();
  }
  if (!newMesh && std::equal(this->Matrix.begin(), this->Matrix.end(), matrix->GetData()))
  {
    return false;
  }
  std::copy_n(matrix->GetData(), 16, this->Matrix.begin());
  const std::vector<double>& model = this->Topology->GetPoints();
  this->Points.resize(model.size());
  for (int i = 0; i < 3; ++i)
  {
    this->Bounds[2 * i] = HUGE_VAL;
    this->Bounds[2 * i + 1] = -HUGE_VAL;
  }
  for (std::size_t k = 0; k < model.size(); k += 3)
  {
    double x[4] = { model[k], model[k + 1], model[k + 2], 1.0 };
    matrix->MultiplyPoint(x, x);
    for (int i = 0; i < 3; ++i)
    {
      this->Points[k + i] = x[i] / x[3];
      this->Bounds[2 * i] = std::min(this->Bounds[2 * i], this->Points[k + i]);
      this->Bounds[2 * i + 1] = std::max(this->Bounds[2 * i + 1], this->Points[k + i]);
    }
  }
  this->Slots.clear();
  return true;
}

bool vtkShadowCaster::IsAround(const vtkShadowLight& light) const
{
  const double* x = light.Position;
  const double* b = this->Bounds;
  return light.IsPositional() && x[0] >= b[0] && x[0] <= b[1] && x[1] >= b[2] && x[1] <= b[3] &&
    x[2] >= b[4] && x[2] <= b[5];
}

const std::vector<vtkShadowCaster::Part>& vtkShadowCaster::GetParts(
  std::size_t slot, const vtkShadowLight& light, const vtkShadowFrame& frame, int& built)
{
  if (slot >= this->Slots.size())
  {
    this->Slots.resize(slot + 1);
  }
  Slot& cached = this->Slots[slot];
  if (!cached.Valid || !IsSame(cached.Light, light))
  {
    cached.Parts.clear();
    cached.Light = light;
    cached.Valid = true;
    Part whole;
    whole.Topology = this->Topology;
    // A light in the bounds may be inside the caster, where no triangle faces it.
    this->AddPart(cached, std::move(whole), frame,
      this->IsAround(light) ? vtkShadowCounting::All : vtkShadowCounting::Away);
    ++built;
  }
  return cached.Parts;
}

void vtkShadowCaster::AddPart(
  Slot& slot, Part part, const vtkShadowFrame& frame, vtkShadowCounting counting) const
{
  const double* points = GetPoints(*this, part);
  part.Silhouette.Compute(*part.Topology, points, slot.Light, counting);
  const int triangles = part.Topology->GetNumberOfTriangles();
  if (part.Silhouette.GetMaximumCount() > MaximumCount && triangles > 1)
  {
    const std::vector<double> all(points, points + 3 * part.Topology->GetNumberOfPoints());
    const int middle = triangles / 2;
    for (const auto& [begin, end] : { std::pair(0, middle), std::pair(middle, triangles) })
    {
      Part half;
      half.Topology = MakeTopology(*part.Topology, all, begin, end);
      half.Points = half.Topology->GetPoints();
      this->AddPart(slot, std::move(half), frame, counting);
    }
    return;
  }
  part.Footprint = vtkShadowFootprint::Make(points, part.Topology->GetNumberOfPoints(), frame);
  slot.Parts.push_back(std::move(part));
}
VTK_ABI_NAMESPACE_END
