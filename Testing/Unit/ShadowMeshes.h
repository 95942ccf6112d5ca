// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowMeshes.h
 * @brief Small meshes of all kinds as casters, about a unit in size around the origin.
 */
#ifndef ShadowMeshes_h
#define ShadowMeshes_h

#include "vtkNBufferGLM.h"

#include "vtkType.h"

#include <ostream>
#include <random>
#include <string>
#include <vector>

using Point = glm::dvec3;

namespace glm
{
/// How GoogleTest shows a point: with all digits.
void PrintTo(const dvec3& x, std::ostream* os);
}

struct ShadowMesh
{
  std::string Name; ///< For failures.
  std::vector<Point> Points;
  std::vector<vtkIdType> Triangles;

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Points.size()); }
  vtkIdType GetNumberOfTriangles() const
  {
    return static_cast<vtkIdType>(this->Triangles.size() / 3);
  }

  void AddFace(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d);
  void Append(const ShadowMesh& other);

  /// Points moved by the function, for all points.
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
  /// Every triangle wound the other way round.
  ShadowMesh Reverse() const;
  /// Every triangle with three points of its own.
  ShadowMesh Unshare() const;
};

// Closed, wound outwards, one component.
ShadowMesh MakeTetrahedron();
ShadowMesh MakeCube();                        ///< 8 points.
ShadowMesh MakeCubeOf24();                    ///< Four points for each face.
ShadowMesh MakeSphere(int rows, int columns); ///< Points of poles and seam repeated.
ShadowMesh MakeEll();                         ///< A prism over an L, not convex.
ShadowMesh MakeTorus(int rows, int columns);
/// A bipyramid over a pentagram: no edge is concave, Euler's characteristic is 2, and yet it is not
/// convex.
ShadowMesh MakePentagram();

// Others.
ShadowMesh MakeOpenRectangle();
ShadowMesh MakeOpenCube(); ///< Without its upper face.
ShadowMesh MakeMoebius(int segments);
ShadowMesh MakeThreePages(); ///< Three squares on one edge.
ShadowMesh MakeTwoSided();   ///< A quad and the same turned round.
/// Triangles between random points of which each is used several times, wound at random.
ShadowMesh MakeSoup(std::mt19937& random, int points, int triangles);

/// All of these, and closed ones with duplicates, holes, reversed parts.
std::vector<ShadowMesh> MakeShadowMeshes(unsigned int seed);

/// A rotation and a translation by up to `distance`.
class RigidMotion
{
public:
  RigidMotion(std::mt19937& random, double distance);
  Point operator()(const Point& x) const;

private:
  glm::dmat3 Rotation = glm::dmat3(1.0);
  Point Offset = Point(0.0);
};

double MakeUniform(std::mt19937& random, double a, double b);
Point MakePoint(std::mt19937& random, double extent); ///< In a cube of +-extent.

#endif
