// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferInstanceStream
 * @brief The instances of a vtkGlyph3DMapper: reads what VTK draws, and draws some of them.
 *
 * vtkOpenGLGlyph3DMapper draws all instances of a source by one call of vtkOpenGLGlyph3DHelper. A
 * matrix, a matrix of normals and a color for each instance are in buffers of that mapper. This
 * class reads the buffers, so that it need not know how VTK makes them.
 *
 * VTK passes the number of instances to OpenGL itself, which cannot be changed. In the place of
 * VTK's draw (vtkNBufferOwnDraw), this class therefore attaches buffers with the chosen instances
 * alone to the vertex array, draws them, and attaches VTK's buffers again. The instances keep their
 * order.
 *
 * Here, a unit of vtkNBufferUnits is a group of instances. The units are made from a mesh with two
 * points for each instance: two opposite corners of its box.
 *
 * A mapper is not divided if it has several sources, a tree of sources, composite data, a mask, or
 * VTK's own culling of instances, or if its source does not consist of triangles alone. The
 * instances are read again if actor, mapper, data or source change. The copy in host memory takes
 * 104 bytes for each instance.
 */
#ifndef vtkNBufferInstanceStream_h
#define vtkNBufferInstanceStream_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferUnits.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkActor;
class vtkOpenGLGlyph3DHelper;
class vtkOpenGLHelper;

class vtkNBufferInstanceStream
{
public:
  vtkNBufferInstanceStream() = default;
  vtkNBufferInstanceStream(const vtkNBufferInstanceStream&) = delete;
  void operator=(const vtkNBufferInstanceStream&) = delete;

  /// The mapper if it is the internal one that draws the instances, otherwise nullptr.
  static vtkOpenGLGlyph3DHelper* GetHelper(vtkAbstractMapper* mapper);

  /// Whether the actor has a vtkGlyph3DMapper, and it is known what that draws: an opaque surface
  /// in the actor's place and at its own depths, by one call.
  static bool MayBeDivided(vtkActor* actor);

  /// The number of polygons in all instances of an actor that may be divided; at most VTK_INT_MAX.
  static vtkIdType CountPolygons(vtkActor* actor);

  /// How many instances make a unit, if the triangles of the source have `indices` indices and a
  /// unit of a mesh has `unitSize` triangles.
  static std::size_t GetUnitSize(std::size_t indices, std::size_t unitSize);

  /// Copy the instances that a mapper is about to draw, and make the mesh of their boxes. Returns
  /// false if it is not known which of them the mapper draws.
  bool Read(vtkActor* actor, vtkOpenGLGlyph3DHelper* mapper, vtkNBufferUnits::Mesh& boxes);

  /// vtkNBufferBox::Magnitude of the boxes that were read last, in their coordinates.
  const glm::dvec3& GetMagnitude() const { return this->Magnitude; }

  /// Let list 0 or 1 consist of the instances whose corners have these indices in the mesh of
  /// boxes, in ascending order.
  void Upload(int list, const std::vector<unsigned int>& corners);

  /// Draw a list in the place of `mapper`, for whose draw VTK has bound everything. Returns false,
  /// and draws nothing, if the list is empty or if VTK has yet to attach its buffers.
  bool Draw(int list, vtkOpenGLGlyph3DHelper* mapper, vtkOpenGLHelper* stream);

  void ReleaseGraphicsResources();

private:
  struct List
  {
    vtkNew<vtkOpenGLBufferObject> Matrices;
    vtkNew<vtkOpenGLBufferObject> NormalMatrices;
    vtkNew<vtkOpenGLBufferObject> Colors;
    std::size_t Size = 0;
  };

  void Attach(vtkOpenGLHelper* stream, vtkOpenGLBufferObject* matrices,
    vtkOpenGLBufferObject* normalMatrices, vtkOpenGLBufferObject* colors);

  std::vector<float> Matrices;       ///< 16 for each instance, column by column.
  std::vector<float> NormalMatrices; ///< 9 for each instance, or none.
  std::vector<unsigned char> Colors; ///< 4 for each instance.
  glm::dvec3 Magnitude = glm::dvec3(0.0);
  std::array<List, 2> Lists;
};

VTK_ABI_NAMESPACE_END
#endif
