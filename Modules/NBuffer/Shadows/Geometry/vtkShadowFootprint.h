// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowFootprint
 * @brief What a caster takes up in light coordinates and in the world. No OpenGL.
 *
 *            light                    The rays p0 <= p <= p1, q0 <= q <= q1 hold whatever
 *           /  :  \                   the caster shadows, at depths beyond near.
 *      ----/---:---\-----  near
 *         /  +---+  \
 *        /   |   |   \                (vtkShadowLight.h explains p, q and s.)
 *       /    +---+    \
 *      --------------------  far
 *     p0               p1
 */
#ifndef vtkShadowFootprint_h
#define vtkShadowFootprint_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowBlock.h"
#include "vtkShadowLight.h"
#include "vtkShadowPoints.h"
#include "vtkShadowSilhouette.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN

struct VTKNBUFFER_EXPORT vtkShadowFootprint
{
  /// The footprint of all points.
  static vtkShadowFootprint Make(vtkShadowPoints points, const vtkShadowLightSpace& space);

  /// The footprint of the triangles that count alone. `points` must be those that the silhouette
  /// was computed with.
  static vtkShadowFootprint Make(const vtkShadowSilhouette& silhouette, vtkShadowPoints points,
    const vtkShadowLightSpace& space);

  /// The eight corners of Bounds.
  std::array<glm::dvec3, 8> GetCorners() const;

  double GetNear() const { return this->Block.Low[2]; }
  double GetFar() const { return this->Block.High[2]; }

  vtkShadowBlock Block;  ///< p, q and s. For a positional light p and q mean nothing if near <= 0.
  vtkShadowBlock Bounds; ///< The box around the points in the world.
};

VTK_ABI_NAMESPACE_END
#endif
