// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferMeshes
 * @brief A cache of the triangles of polydata.
 *
 * Actors that show the same polydata share one mesh, which takes 24 bytes per point and 12 per
 * triangle. The owner keeps the meshes of each prop (OfProp): getting the data of an actor and
 * their time from VTK takes longer than testing a mesh of 20 points. Those that have not been
 * requested for more than 256 frames are released; this is checked in every 256th frame.
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
class vtkPolyData;
class vtkProp;

class VTKNBUFFER_EXPORT vtkNBufferMeshes
{
public:
  /// A mesh and its place in the world.
  struct Placed
  {
    std::shared_ptr<const vtkNBufferMesh> Mesh;
    std::array<double, 16> ToWorld; ///< From the coordinates of the mesh, row by row.
  };

  /// The meshes of a prop.
  struct OfProp
  {
    std::vector<Placed> Meshes;
    vtkIdType Limit = -1; ///< The `limit` of the last Get(), or -1 if Get() has to read the meshes.
    int Frame = 0;        ///< The last frame that requested any of this.
    ///@{
    /// What FindSmall() knows: the triangles, or nullptr before they are copied; whether they are
    /// never copied, because the data has too many polygons, has strips, or is no polydata; and
    /// with which triangle vtkNBufferPixelTest::MayBeSeen() begins.
    std::shared_ptr<const vtkNBufferMesh> Small;
    bool IsTooLarge = false;
    std::size_t First = 0;
    ///@}
  };

  /// Count a frame. In every 256th frame, release the meshes in `kept` that have not been requested
  /// for more than 256 frames.
  void BeginFrame(std::vector<OfProp>& kept);

  /// Forget the polydata whose meshes have been released.
  void ReleaseUnused();

  /**
   * The meshes of an actor whose pipeline is up to date. The result is empty for other props, for
   * actors with `limit` polygons and strips or more, and for data from which vtkDataSetMapper
   * extracts a surface. The meshes are copied to `kept`. If the actor or its data changes, `kept`
   * must be replaced by an empty one.
   */
  const std::vector<Placed>& Get(vtkProp* prop, vtkIdType limit, OfProp& kept);

  /**
   * Set `kept.Small` to the triangles of an actor whose data is a polydata with at most
   * MaximumNumberOfPolygons polygons and without strips, unless polygons of more than four points
   * are older than the points: VTK may still draw their old triangles. Returns whether the
   * triangles are known now. Copying them takes about 10 microseconds, because polygons have to be
   * triangulated, and much more where VTK wakes threads for that
   * (vtkNBufferForEachProp::RunInOneThread). They are copied for at most CopiesPerFrame actors in a
   * frame. As for Get(), `kept` must be replaced by an empty one if the actor or its data changes.
   */
  bool FindSmall(vtkProp* prop, OfProp& kept);

private:
  static constexpr vtkIdType MaximumNumberOfPolygons = 256;
  static constexpr int CopiesPerFrame = 64;

  struct Entry
  {
    vtkMTimeType Time = 0;
    std::weak_ptr<const vtkNBufferMesh> Mesh;
  };

  std::shared_ptr<const vtkNBufferMesh> Update(vtkPolyData* data);

  std::unordered_map<vtkPolyData*, Entry> Entries;
  int Frame = 0;
  int CopiesLeft = 0; ///< How many meshes FindSmall() may still copy in this frame.
};

VTK_ABI_NAMESPACE_END
#endif
