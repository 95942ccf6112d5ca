// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VisibleInstances.h
 * @brief The instances of a vtkGlyph3DMapper that own a pixel.
 */
#ifndef VisibleInstances_h
#define VisibleInstances_h

#include "Session.h"

#include "vtkActor.h"
#include "vtkGlyph3DMapper.h"
#include "vtkSmartPointer.h"

#include <set>
#include <vector>

namespace NBufferBench
{

/**
 * Finds the visible instances by drawing each instance in a colour that is its number, and
 * everything else black. A hardware selection would make a draw of each instance, which takes
 * seconds.
 *
 * The scenes of the examples have instances of one source at points, without arrays that scale,
 * turn or color them, and no other prop of their scenes has colors of its own.
 */
class VisibleInstances
{
public:
  /// The actor and its mapper must outlive this object. The points are the input of the mapper.
  VisibleInstances(vtkActor* actor, vtkGlyph3DMapper* mapper);

  /// Returns the instances that own a pixel (without multisampling) from the present pose.
  /// `visible` are the props that own a pixel.
  std::set<vtkIdType> Find(Session& session, const std::vector<vtkProp*>& visible) const;

  /// Makes an actor with its own vtkGlyph3DMapper that draws only these instances, in their order.
  vtkSmartPointer<vtkActor> MakePart(const std::set<vtkIdType>& instances) const;

private:
  vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* points) const;

  vtkActor* Actor;
  vtkGlyph3DMapper* Mapper;
  vtkSmartPointer<vtkActor> Numbered; ///< The instances in the colours of their numbers.
};

} // namespace NBufferBench

#endif
