// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSharedState
 * @brief Which props share an object in which VTK leaves something from one draw to the next.
 *
 *     object            what VTK leaves in it                       the way of an actor
 *
 *     mapper            the shaders for the actor drawn first       all that decides about shaders
 *     lookup table      the range that was set by the last mapper   the range, or none to set
 *     array of points   a vertex buffer, made by the first mapper   how it shifts coordinates
 *
 * If all actors use such an object in the same way, the order of drawing does not matter. If not,
 * the image depends on the order and on which actors are drawn at all, so that none of them may be
 * held back or left out.
 */
#ifndef vtkNBufferSharedState_h
#define vtkNBufferSharedState_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <array>
#include <cstddef>
#include <unordered_map>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;

class VTKNBUFFER_EXPORT vtkNBufferSharedState
{
public:
  /// How an actor uses an object. The object is only compared, and may be deleted already.
  struct Use
  {
    const void* Object = nullptr; ///< nullptr if there is none.
    std::size_t Way = 0;          ///< Two actors with the same number use the object alike.
    bool operator==(const Use& other) const
    {
      return this->Object == other.Object && this->Way == other.Way;
    }
  };

  /// What one actor uses: its mapper, a lookup table, and an array of points.
  using Uses = std::array<Use, 3>;

  /// The uses of an actor whose pipeline is up to date.
  static Uses GetUses(vtkActor* actor);

  ///@{
  /// Collects what all actors use, in two turns: first call Add() for all uses, and then
  /// AddCommon() for all of them.
  void Add(const Uses& uses);
  void AddCommon(const Uses& uses);
  ///@}

  /// Whether another actor uses one of these objects in another way.
  bool IsMixed(const Uses& uses) const;

  /// Whether any object is used in several ways.
  bool HasMixed() const;

private:
  struct Entry
  {
    std::size_t Way;
    bool IsMixed;
  };

  /// The first use of each kind. Most actors use their objects in the same way. Only objects that
  /// are used in another way are kept in the table.
  Uses Common;
  std::unordered_map<const void*, Entry> Uncommon;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferSharedState.h
