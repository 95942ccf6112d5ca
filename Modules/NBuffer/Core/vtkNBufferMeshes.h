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

#include <unordered_map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkPolyData;

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

private:
  struct Entry
  {
    vtkMTimeType Time = 0;
    int Frame = 0; ///< The last frame that requested the mesh.
    vtkNBufferMesh Mesh;
  };

  std::unordered_map<vtkPolyData*, Entry> Entries;
  int Frame = 0;
};

VTK_ABI_NAMESPACE_END
#endif
