// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferMeshes
 * @brief The triangles that actors draw, made by VTK's own functions and kept from frame to frame.
 *
 * One mesh for each polydata, whichever actors share it: 24 bytes per point and 12 per triangle.
 * What was not asked for in 256 frames is dropped.
 */
#ifndef vtkNBufferMeshes_h
#define vtkNBufferMeshes_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferSliverTest.h"
#include "vtkType.h"

#include <unordered_map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkPolyData;

class VTKNBUFFER_EXPORT vtkNBufferMeshes
{
public:
  void BeginFrame();

  /**
   * What an actor draws whose mapper is up to date; valid until the next BeginFrame(). Polydata and
   * composite mappers; of dataset mappers those that show polydata. Empty for others, whose
   * triangles are not at hand.
   */
  const std::vector<const vtkNBufferMesh*>& Get(vtkActor* actor);

private:
  struct Entry
  {
    vtkMTimeType Time = 0;
    int Frame = 0;
    vtkNBufferMesh Mesh;
  };

  void Add(vtkPolyData* data);

  std::unordered_map<vtkPolyData*, Entry> Entries;
  std::vector<const vtkNBufferMesh*> Found;
  int Frame = 0;
};

VTK_ABI_NAMESPACE_END
#endif
