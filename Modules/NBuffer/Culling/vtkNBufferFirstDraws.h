// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferFirstDraws.h
 * @brief Which props must be drawn once before they may be left out, for the sake of the shaders of
 * a mapper that they share.
 *
 * VTK makes the shader property of an actor at its first draw, and the actor's mapper makes its
 * shaders anew if the property is newer than these. If a hidden actor were drawn much later than
 * other actors of its mapper, perhaps because it has changed, its changes would get into the
 * shaders that draw all of them. VTK crashes if these shaders read a backface property that the
 * next actor does not have. Therefore:
 *
 * - As long as none of the actors that share a mapper, and use it in the same way, has been drawn,
 *   their shader properties are made before the first of them is drawn, so that the shaders are
 *   newer than all of them. (Those that use it in several ways are all drawn, in their order.)
 * - If one of them has been drawn already, those that are added later are drawn once, even if they
 *   are hidden or outside of the view. Whether an actor has been drawn, its shader property tells.
 */
#ifndef vtkNBufferFirstDraws_h
#define vtkNBufferFirstDraws_h

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <unordered_set>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkMapper;
class vtkNBufferCandidate;
class vtkProp;
struct vtkNBufferState;

namespace vtkNBufferFirstDraws
{
/// Find the candidates whose first draw is due, and make the shader properties of others. To be
/// called when the uses of candidates have changed, after it is known which are mixed
/// (vtkNBufferSharedState). `mappersOfParts` are the mappers of parts of assemblies, which may have
/// been drawn.
void Find(const std::vector<vtkNBufferCandidate>& candidates,
  const std::unordered_set<const vtkMapper*>& mappersOfParts, std::vector<vtkNBufferState>& states);

/// Whether the first draw of a prop with this state is due: no draw has been made since Find().
bool IsDue(const vtkNBufferState& state, const vtkProp* prop);
}

VTK_ABI_NAMESPACE_END
#endif
