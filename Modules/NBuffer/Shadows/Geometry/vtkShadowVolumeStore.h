// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowVolumeStore
 * @brief The volumes of a light's casters, which are kept from frame to frame. No OpenGL.
 *
 * The whole volume of a caster stays the same while its silhouette does, that is, until its mesh,
 * its matrix or the light changes. It is made when it is first needed. Two kinds of pieces depend
 * on more and are made anew in each frame that draws them: those clamped to slabs, which depend on
 * the receivers, and the volumes that end beyond the view of a parallel camera.
 *
 * All pieces are added to the end of one vtkShadowVolume, so that what has been sent to the device
 * stays valid there (vtkShadowVolumeBuffer.h):
 *
 *     frame 1   | A | B | C |
 *     frame 2   | A | B | C | B' |           B has moved
 *     frame 3   | A | B | C | B' | B" |      B has moved again: two pieces are useless now
 *
 * The store is cleared at the start of a frame if the last frame added pieces, and if the store
 * holds more than 65,536 indices and, besides these, more than four times the indices of the pieces
 * that the last frame used. So the store stays small, and the pieces that have to be made again
 * cost less than a quarter of those made since it was last cleared. After a frame that adds nothing
 * the store is not cleared, even if the frame draws little or nothing.
 */
#ifndef vtkShadowVolumeStore_h
#define vtkShadowVolumeStore_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowFootprint.h"
#include "vtkShadowVolume.h"

#include "vtkTimeStamp.h"

#include <cstddef>
#include <unordered_map>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkShadowVolumeStore
{
public:
  vtkShadowVolumeStore() { this->Clear(); }

  /// Begins a frame. All pieces of earlier frames become invalid.
  void BeginFrame();

  /// The whole volume of a caster, kept or new. The arguments are those of
  /// vtkShadowVolume::AddWhole().
  vtkShadowPiece GetWhole(
    const vtkShadowPart& caster, const vtkShadowLight& light, const vtkShadowBlock* view);

  /// A new piece of the volume of a caster. The arguments are those of
  /// vtkShadowVolume::AddClamped().
  vtkShadowPiece AddClamped(const vtkShadowPart& caster, const vtkShadowLightSpace& space,
    const vtkShadowSlab& slab, double casterFar);

  const vtkShadowVolume& GetVolume() const { return this->Volume; }

  /// The time when the store was last cleared. While it is the same, the volume has only grown.
  vtkMTimeType GetTime() const { return this->Time.GetMTime(); }

  /// The number of pieces that were made since the frame began.
  int GetNumberOfPiecesMade() const { return this->PiecesMade; }

private:
  void Clear();
  vtkShadowPiece Use(const vtkShadowPiece& piece);

  vtkShadowVolume Volume;
  std::unordered_map<vtkMTimeType, vtkShadowPiece> Whole; ///< By vtkShadowSilhouette::GetMTime().
  vtkTimeStamp Time;
  std::size_t UsedIndices = 0; ///< The indices of the pieces that were returned in this frame.
  int PiecesMade = 0;
};

VTK_ABI_NAMESPACE_END
#endif
