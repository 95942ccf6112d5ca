// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferFaces.h"

#include "vtkNBufferSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A vector of floats that are not less than those of a vector without negative components.
glm::vec3 RoundUp(const glm::dvec3& x)
{
  return glm::vec3(x * (1.0 + 0x1p-23));
}
}

void vtkNBufferFaces::ReleaseUnused(std::vector<OfProp>& ofProps, double share)
{
  std::size_t used = 0;
  std::size_t usedFaces = 0;
  for (const OfProp& ofProp : ofProps)
  {
    used += ofProp.End - ofProp.Begin;
    usedFaces += ofProp.Begin < ofProp.End
      ? this->Pieces[ofProp.End - 1].End - this->Pieces[ofProp.Begin].Begin
      : 0;
  }
  if (static_cast<double>(this->Pieces.size() - used) <= share * static_cast<double>(used))
  {
    return;
  }
  std::vector<Piece> pieces;
  std::vector<Face> faces;
  pieces.reserve(used);
  faces.reserve(usedFaces);
  for (OfProp& ofProp : ofProps)
  {
    const auto begin = static_cast<unsigned int>(pieces.size());
    for (; ofProp.Begin < ofProp.End; ++ofProp.Begin)
    {
      Piece piece = this->Pieces[ofProp.Begin];
      const auto first = static_cast<unsigned int>(faces.size());
      faces.insert(faces.end(), this->Items.begin() + piece.Begin, this->Items.begin() + piece.End);
      piece.Begin = first;
      piece.End = static_cast<unsigned int>(faces.size());
      pieces.push_back(piece);
    }
    ofProp.Begin = begin;
    ofProp.End = static_cast<unsigned int>(pieces.size());
  }
  this->Pieces.swap(pieces);
  this->Items.swap(faces);
}

void vtkNBufferFaces::Set(
  OfProp& ofProp, const std::vector<vtkNBufferMeshes::Placed>& meshes, const vtkNBufferBox& box)
{
  ofProp.Begin = static_cast<unsigned int>(this->Pieces.size());
  std::vector<Corners> triangles;
  for (std::size_t number = 0; number < meshes.size(); ++number)
  {
    const vtkNBufferMesh& mesh = *meshes[number].Mesh;
    const glm::dmat4 toWorld = vtkNBufferGLM::ToMatrix(meshes[number].ToWorld.data());
    for (std::size_t begin = 0; begin < mesh.Triangles.size(); begin += TrianglesOfPiece)
    {
      const std::size_t end = std::min(begin + TrianglesOfPiece, mesh.Triangles.size());
      glm::dvec3 low(std::numeric_limits<double>::infinity());
      glm::dvec3 high = -low;
      triangles.resize(end - begin);
      for (std::size_t i = begin; i < end; ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          const glm::dvec4 point(mesh.Points[mesh.Triangles[i][k]], 1.0);
          const glm::dvec3 corner(toWorld * point);
          triangles[i - begin][k] = corner;
          low = glm::min(low, corner);
          high = glm::max(high, corner);
        }
      }
      Piece piece;
      piece.Center = 0.5 * (low + high);
      piece.HalfSize = RoundUp(0.5 * (high - low) + 0x1p-48 * vtkNBufferGLM::Abs(piece.Center));
      piece.Origin = glm::vec3(box.Origin - piece.Center);
      piece.Magnitude = RoundUp(box.Magnitude);
      piece.Begin = static_cast<unsigned int>(this->Items.size());
      this->Add(triangles, piece.Center);
      piece.End = static_cast<unsigned int>(this->Items.size());
      piece.Mesh = static_cast<unsigned int>(number);
      piece.Triangle = static_cast<unsigned int>(begin);
      this->Pieces.push_back(piece);
    }
  }
  ofProp.End = static_cast<unsigned int>(this->Pieces.size());
}

void vtkNBufferFaces::Add(const std::vector<Corners>& triangles, const glm::dvec3& origin)
{
  // The last face that was added.
  glm::dvec3 normal(0.0);
  double offset = 0.0;
  double height = 0.0;
  for (const Corners& p : triangles)
  {
    const auto [shortest, longest] = std::minmax(
      { glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0]) });
    if (shortest == 0.0)
    {
      continue; // No device draws a triangle with two corners in one place.
    }
    const double tolerance = Flatness * longest;
    const bool isInPlane = height > 0.0 &&
      std::all_of(p.begin(), p.end(),
        [&](const glm::dvec3& corner)
        { return std::abs(glm::dot(normal, corner - origin) - offset) <= tolerance; });
    const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    if (!isInPlane)
    {
      const double size = glm::length(cross);
      normal = size > 0.0 ? cross / size : glm::dvec3(0.0);
      offset = glm::dot(normal, p[0] - origin);
      height = std::numeric_limits<double>::infinity();
      this->Items.emplace_back();
    }
    // The height of what the triangle covers in the plane of the face. It is NaN, and the face is
    // never ruled out, if a point is not finite.
    const double own = std::abs(glm::dot(normal, cross)) / longest;
    if (!(own >= height))
    {
      height = own;
      this->Items.back() = glm::dvec4(normal, -offset) * height;
    }
  }
}
VTK_ABI_NAMESPACE_END
