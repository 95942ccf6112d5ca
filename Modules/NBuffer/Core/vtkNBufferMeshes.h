// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferMeshes
 * @brief A cache of the triangles of polydata.
 *
 * Actors that show the same polydata share one mesh, which takes 24 bytes per point and 12 per
 * triangle. A mesh that was not requested in the last 256 frames is released.
 */
#ifndef vtkNBufferMeshes_h
#define vtkNBufferMeshes_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferSurface.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <memory>
#include <unordered_map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkPolyData;
class vtkProp;

class VTKNBUFFER_EXPORT vtkNBufferMeshes
{
public:
  /// A mesh and its place in the world.
  struct Placed
  {
    const vtkNBufferMesh* Mesh;
    std::array<double, 16> ToWorld; ///< From the coordinates of the mesh, row by row.
  };

  /// Count a frame, and release what was not requested for a long time.
  void BeginFrame();

  /**
   * The meshes of an actor whose pipeline is up to date. They are valid until the next
   * BeginFrame(). Empty for nullptr, and for data that vtkDataSetMapper extracts a surface from.
   */
  std::vector<Placed> Get(vtkActor* actor);

  /// The triangles of one actor, and the one with which vtkNBufferPixelTest::MayBeSeen() begins.
  struct Small
  {
    std::shared_ptr<const vtkNBufferMesh> Mesh; ///< Null before it is copied.
    std::size_t First = 0;
    int Requests = 0; ///< The calls so far that were meant to copy it.
    bool IsTooLarge = false;
    int Frame = 0;
  };

  /**
   * The triangles of an actor of a polydata of at most MaximumNumberOfPolygons polygons, without
   * strips. Null for other actors, and where the triangles are not in the cache. To triangulate
   * polygons may take a tenth of a millisecond, so that they are copied at call number `copyAfter`
   * with the same actor, and for at most CopiesPerFrame actors in a frame; never if it is 0.
   * Whoever changes the data has to call Forget().
   */
  Small* FindSmall(vtkActor* actor, int copyAfter);

  /// Find the triangles of a prop anew.
  void Forget(vtkProp* prop) { this->SmallMeshes.erase(prop); }

private:
  static constexpr vtkIdType MaximumNumberOfPolygons = 256;
  static constexpr int CopiesPerFrame = 8;

  struct Entry
  {
    vtkMTimeType Time = 0;
    int Frame = 0; ///< The last frame that requested the mesh.
    std::shared_ptr<const vtkNBufferMesh> Mesh;
  };

  const Entry& Update(vtkPolyData* data);

  std::unordered_map<vtkPolyData*, Entry> Entries;
  std::unordered_map<vtkProp*, Small> SmallMeshes;
  int Frame = 0;
  int CopiesLeft = 0; ///< In this frame, for FindSmall().
};

VTK_ABI_NAMESPACE_END
#endif
