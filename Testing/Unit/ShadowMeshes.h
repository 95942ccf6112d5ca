// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowMeshes.h
 * @brief Meshes of all kinds, to use as casters. They lie around the origin and are about one unit
 * in size.
 */
#ifndef ShadowMeshes_h
#define ShadowMeshes_h

#include "PrintVectors.h"

#include "vtkType.h"

#include <functional>
#include <random>
#include <string>
#include <vector>

using Point = glm::dvec3;

struct ShadowMesh
{
  std::string Name; ///< For messages of failures.
  std::vector<Point> Points = {};
  std::vector<vtkIdType> Triangles = {};

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Points.size()); }
  vtkIdType GetNumberOfTriangles() const
  {
    return static_cast<vtkIdType>(this->Triangles.size() / 3);
  }

  /// Adds a quad as two triangles.
  void AddFace(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d);
  void Append(const ShadowMesh& other);

  /// Returns the mesh with the points move(point).
  template <typename Function>
  ShadowMesh Move(Function move) const
  {
    ShadowMesh result = *this;
    for (Point& point : result.Points)
    {
      point = move(point);
    }
    return result;
  }

  ShadowMesh Translate(double x, double y, double z) const;
  /// Returns the mesh with the opposite winding of all triangles.
  ShadowMesh Reverse() const;
  /// Returns the mesh with the opposite winding of random triangles, about half of them.
  ShadowMesh Flip(std::mt19937& random) const;
  /// Returns the mesh with three points of its own for each triangle.
  ShadowMesh Unshare() const;
};

/// Returns several meshes as one.
ShadowMesh Join(const std::string& name, const std::vector<ShadowMesh>& parts);

// Closed meshes of one component, wound so that their triangles face outwards.
ShadowMesh MakeTetrahedron();
ShadowMesh MakeCube();     ///< 8 points.
ShadowMesh MakeCubeOf24(); ///< Four points for each face.
ShadowMesh MakeSphere(
  int rows, int columns); ///< The points of the poles and the seam are repeated.
ShadowMesh MakeEll();     ///< A prism over an L, which is not convex.
ShadowMesh MakeTorus(int rows, int columns);
/// A bipyramid over a pentagram: no edge is concave, Euler's characteristic is 2, and yet it is not
/// convex.
ShadowMesh MakePentagram();

// Meshes that are open or not manifold.
ShadowMesh MakeOpenRectangle();
ShadowMesh MakeOpenCube(); ///< Without its upper face.
ShadowMesh MakeMoebius(int segments);
ShadowMesh MakeThreePages(); ///< Three rectangles that share one edge.
ShadowMesh MakeTwoSided();   ///< A quad, and the same quad with the opposite winding.
/// Makes triangles between random points that they share, wound at random.
ShadowMesh MakeSoup(std::mt19937& random, int points, int triangles);

/// Returns all of these meshes, and some with duplicate triangles, several bodies or wrong winding.
std::vector<ShadowMesh> MakeShadowMeshes(unsigned int seed);

/// Returns a random rotation followed by a translation of up to `distance` along each axis.
std::function<Point(const Point&)> MakeRigidMotion(std::mt19937& random, double distance);

/// Returns a number in [a, b).
double MakeUniform(std::mt19937& random, double a, double b);
/// Returns a point with coordinates in [-extent, extent).
Point MakePoint(std::mt19937& random, double extent);

#endif
