// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferInstanceStream
 * @brief The instances of a vtkGlyph3DMapper: reads what VTK draws, and draws some of them.
 *
 * vtkOpenGLGlyph3DMapper draws all instances of a source by one call of a vtkOpenGLGlyph3DHelper,
 * one source after the other. A matrix, a matrix of normals and a color for each instance are in
 * buffers of that mapper. This class reads the matrices, so that it need not know how VTK makes
 * them, and copies the records of chosen instances from buffer to buffer.
 *
 * VTK passes the number of instances to OpenGL itself, which cannot be changed. In the place of
 * VTK's draw (vtkNBufferOwnDraw), this class therefore attaches buffers with the chosen instances
 * alone to the vertex array, draws them, and attaches VTK's buffers again. The instances keep their
 * order.
 *
 * Here, a unit of vtkNBufferUnits is a group of instances. The units are made from a mesh with two
 * points for each instance: two opposite corners of its box. Instances are numbered in the order in
 * which they are drawn, those of the first source first.
 *
 * A mapper is not divided if it has a tree of sources, composite data, a mask, or VTK's own culling
 * of instances, or if a source does not consist of triangles alone. The instances are read again if
 * actor, mapper, data or a source change.
 */
#ifndef vtkNBufferInstanceStream_h
#define vtkNBufferInstanceStream_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferUnitDevice.h"
#include "vtkNBufferUnits.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkActor;
class vtkGlyph3DMapper;
class vtkOpenGLGlyph3DHelper;
class vtkOpenGLHelper;

class vtkNBufferInstanceStream
{
public:
  /// Makes a list of the chosen primitives of a part by copying their records, and says how to draw
  /// it. `indices` is the number of indices of a primitive. Returns false if it cannot be made.
  using Maker = std::function<bool(const vtkNBufferUnits::Range& part,
    const std::vector<vtkNBufferUnitDevice::Records>& records, std::size_t indices,
    vtkNBufferUnitDevice::List& list)>;

  vtkNBufferInstanceStream() = default;
  vtkNBufferInstanceStream(const vtkNBufferInstanceStream&) = delete;
  void operator=(const vtkNBufferInstanceStream&) = delete;

  /// The mapper if it is the internal one that draws the instances, otherwise nullptr.
  static vtkOpenGLGlyph3DHelper* GetHelper(vtkAbstractMapper* mapper);

  /// Whether the actor has a vtkGlyph3DMapper, and it is known what that draws: a surface, opaque
  /// or translucent, in the actor's place and at its own depths, by one call for each source.
  static bool MayBeDivided(vtkActor* actor, bool isTranslucent);

  /// The number of polygons in all instances of an actor that may be divided; at most VTK_INT_MAX.
  static vtkIdType CountPolygons(vtkActor* actor);

  /// Forget all instances. The window's context must be current.
  void Clear();

  /// Read the instances of one source, which a mapper is about to draw from `stream`, and add their
  /// boxes to the mesh. If it is not known which of them the mapper draws, the mesh gets and keeps
  /// 0 corners. `stream` may be nullptr, because then it is not known.
  void Read(vtkActor* actor, vtkOpenGLGlyph3DHelper* mapper, vtkOpenGLHelper* stream,
    vtkNBufferUnits::Mesh& boxes);

  /// The number of the instance at a point; the largest std::size_t if there is none.
  std::size_t FindInstance(std::size_t point) const;

  /// vtkNBufferBox::Magnitude of the boxes that were read since Clear(), in their coordinates.
  const glm::dvec3& GetMagnitude() const { return this->Magnitude; }

  /// Let list 0 or 1 be made when it is drawn.
  void SetPending(int list);

  /// The bytes of the largest buffer that was read since Clear().
  std::size_t GetLargestBuffer() const;

  /// Whether a mapper is about to draw what was read. `stream` may be nullptr.
  bool IsAsRead(vtkOpenGLGlyph3DHelper* mapper, vtkOpenGLHelper* stream) const;

  /// Draw the part of a list that `mapper`, for whose draw VTK has bound everything, has of it. If
  /// the list is pending, `make` makes it (vtkNBufferDrawHook::MakeList()). Returns false, and
  /// draws nothing, if VTK has yet to attach its buffers, or if the list cannot be made.
  bool Draw(int list, vtkOpenGLGlyph3DHelper* mapper, vtkOpenGLHelper* stream, const Maker& make);

  void ReleaseGraphicsResources();

private:
  struct List
  {
    vtkNew<vtkOpenGLBufferObject> Matrices;
    vtkNew<vtkOpenGLBufferObject> NormalMatrices;
    vtkNew<vtkOpenGLBufferObject> Colors;
    vtkNBufferUnitDevice::List Draw;
    bool IsPending = false; ///< Whether the list has yet to be made.
  };

  /// The mapper of a source, and when it uploaded what it draws. Two draws with equal keys draw the
  /// same.
  struct Key
  {
    const void* Mapper = nullptr; ///< Only compared, never dereferenced.
    vtkMTimeType SourceTime = 0;
    vtkMTimeType BuildTime = 0;
    std::size_t IndexCount = 0;

    bool operator==(const Key& other) const
    {
      return this->Mapper == other.Mapper && this->SourceTime == other.SourceTime &&
        this->BuildTime == other.BuildTime && this->IndexCount == other.IndexCount;
    }
  };

  /// The instances of one source.
  struct Batch
  {
    Key Drawn;
    std::size_t First = 0; ///< The number of its first instance.
    std::size_t Size = 0;
    bool HasNormals = false; ///< Whether the instances have matrices of normals.
    std::array<List, 2> Lists;
  };

  static Key GetKey(vtkOpenGLGlyph3DHelper* mapper, vtkOpenGLHelper* stream);
  void ReadOrder(vtkGlyph3DMapper* mapper);
  bool ReadBatch(vtkOpenGLGlyph3DHelper* mapper, Batch& batch, vtkNBufferUnits::Mesh& boxes);
  Batch* Find(const Key& key) const;
  static bool MakeList(Batch& batch, int list, vtkOpenGLGlyph3DHelper* mapper,
    vtkOpenGLHelper* stream, const Maker& make);
  static void Attach(vtkOpenGLHelper* stream, bool withNormals, vtkOpenGLBufferObject* matrices,
    vtkOpenGLBufferObject* normalMatrices, vtkOpenGLBufferObject* colors);

  std::vector<std::unique_ptr<Batch>> Batches; ///< In the order of drawing.
  std::vector<unsigned int> Numbers;           ///< The number of the instance at each point.
  std::vector<std::size_t> Ends; ///< For each source, the number of its last instance plus 1.
  glm::dvec3 Magnitude = glm::dvec3(0.0);
};

VTK_ABI_NAMESPACE_END
#endif
