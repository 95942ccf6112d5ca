// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferFaces
 * @brief The faces of the triangles of props, for vtkNBufferFaceTest. No OpenGL.
 *
 * A face is a sequence of triangles of a mesh in one plane. Let n be its unit normal, a one of its
 * points, and h the smallest height of its triangles over their longest sides. What is kept of a
 * face is (h n, -h n . a), 16 bytes.
 *
 * The faces of a mesh form pieces of TrianglesOfPiece triangles, each with its box, and a is
 * relative to the center of the piece. A piece takes 80 bytes. Pieces and faces of all props lie in
 * one block of memory each: where thousands of props are tested in a frame, most of the time is
 * spent waiting for memory.
 */
#ifndef vtkNBufferFaces_h
#define vtkNBufferFaces_h

#include "vtkNBufferBox.h"
#include "vtkNBufferMeshes.h"
#include "vtkNBufferModule.h" // For export macro

#include <array>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKNBUFFER_EXPORT vtkNBufferFaces
{
public:
  /// A corner may be this share of the longest side of its triangle away from the plane of its
  /// face.
  static constexpr double Flatness = 1.0 / (1 << 20);

  static constexpr std::size_t TrianglesOfPiece = 32;

  using Face = glm::vec4;

  struct Piece
  {
    glm::dvec3 Center;
    ///@{
    /// Those of vtkNBufferBox. Origin, which is relative to Center, and Magnitude are those of the
    /// prop.
    glm::vec3 HalfSize;
    glm::vec3 Origin;
    glm::vec3 Magnitude;
    ///@}
    unsigned int Begin;    ///< The first face,
    unsigned int End;      ///< and the one after the last.
    unsigned int Mesh;     ///< The number of the mesh among those of the prop.
    unsigned int Triangle; ///< The first triangle of this mesh.

    vtkNBufferBox GetBox() const
    {
      vtkNBufferBox box;
      box.Center = this->Center;
      box.HalfSize = this->HalfSize;
      box.Origin = this->Center + glm::dvec3(this->Origin);
      box.Magnitude = this->Magnitude;
      return box;
    }
  };

  /// The pieces of a prop. The owner keeps these, and replaces them by none if the prop changes.
  struct OfProp
  {
    unsigned int Begin = 0;
    unsigned int End = 0;
    vtkIdType Limit = -1; ///< That of vtkNBufferMeshes::OfProp when the pieces were set.
  };

  /// Set the pieces of a prop to those of its meshes. `box` is the box of the prop. Takes about 30
  /// ns per triangle.
  void Set(
    OfProp& ofProp, const std::vector<vtkNBufferMeshes::Placed>& meshes, const vtkNBufferBox& box);

  /// Release the memory of pieces that no prop has any more, if they are more than `share` of those
  /// that some prop has. `ofProps` are all props. Moves all pieces.
  void ReleaseUnused(std::vector<OfProp>& ofProps, double share);

  const std::vector<Piece>& GetPieces() const { return this->Pieces; }
  const std::vector<Face>& GetFaces() const { return this->Items; }

private:
  using Corners = std::array<glm::dvec3, 3>;
  /// Add the faces of a sequence of triangles. The planes are relative to `origin`.
  void Add(const std::vector<Corners>& triangles, const glm::dvec3& origin);

  std::vector<Piece> Pieces;
  std::vector<Face> Items;
};

VTK_ABI_NAMESPACE_END
#endif
