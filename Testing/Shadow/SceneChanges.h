// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SceneChanges.h
 * @brief Changes of a scene that leave its shadows as they are. Those of meshes are for actors of
 * the renderer with polydata; parts of assemblies and composite data stay as they are.
 */
#ifndef SceneChanges_h
#define SceneChanges_h

#include "vtkNBufferGLM.h"

#include <functional>
#include <vector>

class vtkRenderer;

namespace SceneChanges
{
/// Turn every second polygon round. Its first point stays the first, so that quads are cut along
/// the same diagonal. Strips stay as they are.
void FlipWindings(vtkRenderer* renderer);

/// Give every polygon its own points; strips stay as they are.
void UnsharePoints(vtkRenderer* renderer);

/// Two actors for each: one has the first half of the polygons, the other the second. Strips stay
/// in the first.
void SplitActors(vtkRenderer* renderer);

void ReverseProps(vtkRenderer* renderer);

/// Move props, lights, camera and clipping planes of actors.
void Move(vtkRenderer* renderer, const glm::dvec3& offset);

struct Change
{
  const char* Name;
  std::function<void(vtkRenderer*)> Make;
};

/// All of them; the last one moves by a few units.
std::vector<Change> GetChanges();
}

#endif
