// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMeshes.h"

#include "vtkMath.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>

void ShadowMesh::AddFace(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
{
  this->Triangles.insert(this->Triangles.end(), { a, b, c, a, c, d });
}

void ShadowMesh::Append(const ShadowMesh& other)
{
  const vtkIdType first = this->GetNumberOfPoints();
  this->Points.insert(this->Points.end(), other.Points.begin(), other.Points.end());
  for (const vtkIdType index : other.Triangles)
  {
    this->Triangles.push_back(first + index);
  }
}

ShadowMesh ShadowMesh::Translate(double x, double y, double z) const
{
  return this->Move([=](const Point& point) { return point + Point(x, y, z); });
}

ShadowMesh ShadowMesh::Reverse() const
{
  ShadowMesh result = *this;
  for (std::size_t i = 0; i < this->Triangles.size(); i += 3)
  {
    std::swap(result.Triangles[i + 1], result.Triangles[i + 2]);
  }
  return result;
}

ShadowMesh ShadowMesh::Flip(std::mt19937& random) const
{
  ShadowMesh result = *this;
  for (std::size_t i = 0; i < this->Triangles.size(); i += 3)
  {
    if (random() % 2)
    {
      std::swap(result.Triangles[i + 1], result.Triangles[i + 2]);
    }
  }
  return result;
}

ShadowMesh ShadowMesh::Unshare() const
{
  ShadowMesh result = { this->Name + ", unshared" };
  for (const vtkIdType index : this->Triangles)
  {
    result.Triangles.push_back(result.GetNumberOfPoints());
    result.Points.push_back(this->Points[index]);
  }
  return result;
}

ShadowMesh Join(const std::string& name, const std::vector<ShadowMesh>& parts)
{
  ShadowMesh result = { name };
  for (const ShadowMesh& part : parts)
  {
    result.Append(part);
  }
  return result;
}

ShadowMesh MakeTetrahedron()
{
  return { "tetrahedron", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 } };
}

ShadowMesh MakeCube()
{
  ShadowMesh mesh = { "cube" };
  for (int i = 0; i < 8; ++i)
  {
    mesh.Points.push_back({ (i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5 });
  }
  mesh.AddFace(0, 2, 3, 1); // below
  mesh.AddFace(0, 1, 5, 4);
  mesh.AddFace(1, 3, 7, 5);
  mesh.AddFace(3, 2, 6, 7);
  mesh.AddFace(2, 0, 4, 6);
  mesh.AddFace(4, 5, 7, 6); // above
  return mesh;
}

ShadowMesh MakeCubeOf24()
{
  const ShadowMesh cube = MakeCube();
  ShadowMesh mesh = { "cube with 24 points" };
  for (std::size_t face = 0; face < cube.Triangles.size(); face += 6)
  {
    const vtkIdType first = mesh.GetNumberOfPoints();
    for (const int corner : { 0, 1, 2, 5 })
    {
      mesh.Points.push_back(cube.Points[cube.Triangles[face + corner]]);
    }
    mesh.AddFace(first, first + 1, first + 2, first + 3);
  }
  return mesh;
}

ShadowMesh MakeSphere(int rows, int columns)
{
  ShadowMesh mesh = { "sphere" };
  for (int i = 0; i <= rows; ++i)
  {
    for (int j = 0; j <= columns; ++j)
    {
      const bool pole = i == 0 || i == rows;
      const double theta = vtkMath::Pi() * i / rows;
      const double phi = 2.0 * vtkMath::Pi() * (j % columns) / columns;
      const double radius = pole ? 0.0 : std::sin(theta);
      mesh.Points.push_back({ radius * std::cos(phi), radius * std::sin(phi),
        pole ? (i ? -1.0 : 1.0) : std::cos(theta) });
    }
  }
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      const int a = i * (columns + 1) + j;
      const int b = a + columns + 1;
      if (i > 0)
      {
        mesh.Triangles.insert(mesh.Triangles.end(), { a, b, a + 1 });
      }
      if (i < rows - 1)
      {
        mesh.Triangles.insert(mesh.Triangles.end(), { a + 1, b, b + 1 });
      }
    }
  }
  return mesh;
}

ShadowMesh MakeEll()
{
  ShadowMesh mesh = { "L" };
  const double outline[6][2] = { { -1, -1 }, { 1, -1 }, { 1, 0 }, { 0, 0 }, { 0, 1 }, { -1, 1 } };
  for (const double z : { -0.5, 0.5 })
  {
    for (const auto& corner : outline)
    {
      mesh.Points.push_back({ corner[0], corner[1], z });
    }
  }
  for (int i = 0; i < 6; ++i)
  {
    const int j = (i + 1) % 6;
    mesh.AddFace(i, j, j + 6, i + 6);
  }
  mesh.AddFace(6, 7, 8, 9);
  mesh.AddFace(6, 9, 10, 11);
  mesh.AddFace(0, 3, 2, 1);
  mesh.AddFace(0, 5, 4, 3);
  return mesh;
}

ShadowMesh MakeTorus(int rows, int columns)
{
  ShadowMesh mesh = { "torus" };
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      const double theta = 2.0 * vtkMath::Pi() * i / rows;
      const double phi = 2.0 * vtkMath::Pi() * j / columns;
      const double radius = 0.8 + 0.3 * std::cos(theta);
      mesh.Points.push_back(
        { radius * std::cos(phi), radius * std::sin(phi), 0.3 * std::sin(theta) });
    }
  }
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      const int i1 = (i + 1) % rows;
      const int j1 = (j + 1) % columns;
      mesh.AddFace(i * columns + j, i * columns + j1, i1 * columns + j1, i1 * columns + j);
    }
  }
  return mesh;
}

ShadowMesh MakePentagram()
{
  ShadowMesh mesh = { "bipyramid over a pentagram" };
  for (int i = 0; i < 5; ++i)
  {
    const double phi = 4.0 * vtkMath::Pi() * i / 5.0;
    mesh.Points.push_back({ std::cos(phi), std::sin(phi), 0.0 });
  }
  mesh.Points.push_back({ 0.0, 0.0, 1.0 });
  mesh.Points.push_back({ 0.0, 0.0, -1.0 });
  for (int i = 0; i < 5; ++i)
  {
    const int j = (i + 1) % 5;
    mesh.Triangles.insert(mesh.Triangles.end(), { i, j, 5, j, i, 6 });
  }
  return mesh;
}

ShadowMesh MakeOpenRectangle()
{
  ShadowMesh mesh = { "quad" };
  mesh.Points = { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 } };
  mesh.AddFace(0, 1, 2, 3);
  return mesh;
}

ShadowMesh MakeOpenCube()
{
  ShadowMesh mesh = MakeCube();
  mesh.Name = "open cube";
  mesh.Triangles.resize(mesh.Triangles.size() - 6);
  return mesh;
}

ShadowMesh MakeMoebius(int segments)
{
  ShadowMesh mesh = { "Moebius strip" };
  for (int i = 0; i < segments; ++i)
  {
    const double phi = 2.0 * vtkMath::Pi() * i / segments;
    for (const double width : { -0.3, 0.3 })
    {
      const double radius = 1.0 + width * std::cos(phi / 2.0);
      mesh.Points.push_back(
        { radius * std::cos(phi), radius * std::sin(phi), width * std::sin(phi / 2.0) });
    }
  }
  for (int i = 0; i < segments; ++i)
  {
    const int a = 2 * i;
    const bool last = i == segments - 1;
    mesh.AddFace(a, a + 1, last ? 0 : a + 3, last ? 1 : a + 2);
  }
  return mesh;
}

ShadowMesh MakeThreePages()
{
  ShadowMesh mesh = { "three pages" };
  mesh.Points = { { 0, 0, -1 }, { 0, 0, 1 }, { 1, 0, -1 }, { 1, 0, 1 }, { -0.5, 0.75, -1 },
    { -0.5, 0.75, 1 }, { -0.5, -0.75, -1 }, { -0.5, -0.75, 1 } };
  for (int page = 2; page < 8; page += 2)
  {
    mesh.AddFace(0, page, page + 1, 1);
  }
  return mesh;
}

ShadowMesh MakeTwoSided()
{
  return Join("two-sided quad", { MakeOpenRectangle(), MakeOpenRectangle().Reverse() });
}

ShadowMesh MakeSoup(std::mt19937& random, int points, int triangles)
{
  ShadowMesh mesh = { "soup" };
  for (int i = 0; i < points; ++i)
  {
    mesh.Points.push_back(MakePoint(random, 1.0));
  }
  while (mesh.GetNumberOfTriangles() < triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      mesh.Triangles.push_back(static_cast<vtkIdType>(random() % points));
    }
  }
  return mesh;
}

std::vector<ShadowMesh> MakeShadowMeshes(unsigned int seed)
{
  std::mt19937 random(seed);
  ShadowMesh duplicates = Join("cube with duplicate triangles", { MakeCube(), MakeTetrahedron() });
  duplicates.Triangles.insert(duplicates.Triangles.end(), { 4, 5, 7, 4, 5, 7, 0, 2, 3 });
  std::vector<ShadowMesh> meshes = { MakeTetrahedron(), MakeCube(), MakeCubeOf24(),
    MakeSphere(5, 7), MakeEll(), MakeTorus(4, 6), MakePentagram(), MakeOpenRectangle(),
    MakeOpenCube(), MakeMoebius(9), MakeThreePages(), MakeTwoSided(), MakeSoup(random, 8, 25),
    MakeSoup(random, 30, 20), duplicates, Join("cube twice", { MakeCube(), MakeCube() }),
    Join("cubes that share an edge", { MakeCube(), MakeCube().Translate(1, 1, 0) }),
    Join("two bodies, one of them inside out",
      { MakeCube().Translate(-0.7, 0, 0), MakeTetrahedron().Reverse().Translate(0.4, 0, 0) }) };
  meshes.push_back(MakeSphere(4, 5).Flip(random));
  meshes.back().Name = "badly wound sphere";
  return meshes;
}

std::function<Point(const Point&)> MakeRigidMotion(std::mt19937& random, double distance)
{
  const double real = MakeUniform(random, -1.0, 1.0);
  const glm::dquat quaternion(real, MakePoint(random, 1.0));
  const glm::dmat3 rotation = glm::mat3_cast(glm::normalize(quaternion));
  const Point offset = MakePoint(random, distance);
  return [=](const Point& x) { return rotation * x + offset; };
}

double MakeUniform(std::mt19937& random, double a, double b)
{
  return a + (b - a) * (static_cast<double>(random()) / 4294967296.0);
}

Point MakePoint(std::mt19937& random, double extent)
{
  Point point;
  for (int i = 0; i < 3; ++i)
  {
    point[i] = MakeUniform(random, -extent, extent);
  }
  return point;
}
