// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SceneChanges.h
 * @brief Changes of a scene that must not change its shadows. Changes of meshes apply to actors of
 * the renderer with polydata, and not to parts of assemblies or composite data.
 */
#ifndef SceneChanges_h
#define SceneChanges_h

#include "vtkNBufferGLM.h"

#include <functional>
#include <vector>

class vtkRenderer;

namespace SceneChanges
{
/// Reverses the winding of every second polygon. Its first point stays the first one, so that quads
/// are cut along the same diagonal. Strips are not changed.
void FlipWindings(vtkRenderer* renderer);

/// Gives every polygon its own points. Meshes with strips are not changed.
void UnsharePoints(vtkRenderer* renderer);

/// Moves the second half of each actor's polygons to another actor. Strips stay in the first one.
void SplitActors(vtkRenderer* renderer);

/// Reverses the order of the props in the renderer.
void ReverseProps(vtkRenderer* renderer);

/// Moves everything by the offset: props, their clipping planes, lights and the camera.
void Move(vtkRenderer* renderer, const glm::dvec3& offset);

struct Change
{
  const char* Name;
  std::function<void(vtkRenderer*)> Make;
};

/// Returns all of these changes. The last one moves everything by about 14 units.
std::vector<Change> GetChanges();
}

#endif
