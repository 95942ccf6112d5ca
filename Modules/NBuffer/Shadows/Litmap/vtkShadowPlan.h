// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowPlan
 * @brief Which part of each caster's shadow volume is drawn for one light and one view. No OpenGL.
 *
 * Whatever a caster shadows lies on its rays, beyond its nearest depth (vtkShadowFootprint.h). The
 * litmaps (vtkShadowLitmapSet.h) know all receivers on these rays: a range of depths, a box on the
 * screen, and which bins of depth they occupy. So
 *
 *        light                           a caster is ...
 *          |  |  |  |
 *          | (r1)   |                    r1 before it: BeforeCaster, not drawn if that is all
 *       ---+--------+--- near
 *          | caster |
 *       ---+--------+--- far
 *          :        :                    nothing is drawn here
 *       ---+--------+---  \
 *          | (r2)   |      > slab 1      drawn, into the receivers' box of pixels
 *       ---+--------+---  /
 *          :        :                    a gap of empty bins: nothing is drawn here
 *       ---+--------+---  \
 *          | (r3)   |      > slab 2      drawn
 *       ---+--------+---  /
 *
 *  - a caster without receivers on its rays is not drawn (NoReceiver);
 *  - a caster whose receivers all are nearer to the light than itself is not drawn (BeforeCaster);
 *  - otherwise its volume is drawn into the receivers' box of pixels (Boxed),
 *  - and in mode Clamped only the part of it in the slabs that the receivers take up (Clamped).
 *
 * In this box, the tiles of 4 x 4 pixels that the caster's shadow can reach (vtkShadowUmbra.h) are
 * found, and the volume is drawn into a few boxes around these (vtkShadowTiles.h). There is one
 * more box where it leaves out more pixels than drawing the triangles once more costs
 * (vtkShadowTuning::BoxCost). If no tile is reached, the verdict is NoReceiver or BeforeCaster.
 *
 * Leaving out casters and drawing into boxes change no vertex and so no fragment: the stencil is
 * bit for bit that of whole volumes wherever there is a receiver. Slabs make new vertices, which
 * the device snaps to its subpixel grid by themselves: samples closer to the edge of a shadow than
 * that may change.
 *
 * A positional light's coordinates mean nothing at and behind its plane s = 0:
 *
 *           [a]                   a behind the plane: BehindLight, not drawn. It shadows nothing
 *      ----- L ----[b]---- s = 0    that a spot of less than 90 degrees reaches.
 *           / \                   b through the plane: ThroughLightPlane, drawn whole into the
 *          /   \                    box of all receivers; or OutsideCone, not drawn, if the sphere
 *         /cone \                   around its bounds lies outside of the spot's cone.
 *
 * Receivers outside of the cone (vtkShadowReceiverProjector.h) widen it. If one of them may lie
 * behind the light, no caster is BehindLight.
 *
 * With the six litmaps of a point light, casters whose rays are in one face can be clamped to
 * slabs; the volumes of others are never clamped.
 */
#ifndef vtkShadowPlan_h
#define vtkShadowPlan_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowDrawList.h"
#include "vtkShadowFootprint.h"
#include "vtkShadowLitmapSet.h"
#include "vtkShadowStatistics.h"
#include "vtkShadowTuning.h"

#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkShadowPlan
{
public:
  using Face = vtkShadowLitmapSet::Face;
  using View = vtkShadowDrawList::View;
  using Boxes = vtkShadowDrawList::Boxes;

  /// A slab, and the boxes of pixels of its receivers.
  struct BoxedSlab
  {
    vtkShadowSlab Slab;
    Boxes Pixels;
  };

  /// The decision about a caster, and what follows from it.
  struct Choice
  {
    bool IsDrawn() const
    {
      return this->Verdict == vtkShadowVerdict::Whole || !this->Pixels.empty() ||
        !this->Slabs.empty();
    }

    vtkShadowVerdict Verdict = vtkShadowVerdict::Empty;

    /// The boxes into which the whole volume is drawn. With verdict Whole it is empty and the
    /// volume is drawn everywhere.
    Boxes Pixels;

    std::vector<BoxedSlab> Slabs;               ///< The slabs of a volume that is clamped.
    const vtkShadowLightSpace* Space = nullptr; ///< The light space of the slabs.
    double Far = 0.0; ///< The depth of the caster's farthest point in Space.
  };

  /**
   * A plan without casters. `litmaps` has the litmap of the light, or the six of a point light,
   * with their levels built. Without any, as with mode Unclamped, nothing is known of the
   * receivers. The light, the litmaps and their light spaces must outlive the plan.
   */
  vtkShadowPlan(const vtkShadowLight& light, const View& view, vtkShadowMode mode,
    std::vector<Face> litmaps, const vtkShadowTuning& tuning);

  /// Decides about a caster. It changes nothing and may be called in parallel.
  Choice Decide(const vtkShadowPart& caster) const;

  /// The reason why a caster is not drawn, as far as its boxes and one lookup say; nothing if that
  /// is not enough. Decide() begins with it: it does not read the caster's points, which the
  /// processor has to fetch from memory for each of many casters.
  std::optional<vtkShadowVerdict> EarlyOut(const vtkShadowPart& caster) const;

  /// Adds what was chosen for a caster: its triangles to `volume`, its draws to GetDraws().
  void Draw(const Choice& choice, const vtkShadowPart& caster, vtkShadowVolume& volume);

  /// The draws of all casters.
  const std::vector<vtkShadowDraw>& GetDraws() const { return this->Draws.GetDraws(); }

  /// Returns true if no receiver is inside of all volumes drawn more often than this.
  bool IsCountBelow(int limit) const { return this->Draws.IsCountBelow(limit); }

  /// The number of slabs drawn.
  int GetNumberOfSlabs() const { return this->Slabs; }

private:
  using Lookup = vtkShadowLitmapSet::Lookup;

  bool HasLitmaps() const;
  static std::optional<vtkShadowVerdict> EarlyOutByReceivers(const Lookup& lookup);
  /// The boxes of pixels to draw into. `isOnRays` becomes true if any receiver at all is on the
  /// caster's rays.
  Boxes FindBoxes(const Lookup& lookup, const vtkShadowPart& caster, bool& isOnRays) const;
  std::vector<vtkShadowSlab> GetSlabs(const Lookup& lookup) const;

  vtkShadowLitmapSet Litmaps;
  vtkShadowDrawList Draws;
  vtkShadowMode Mode;
  double BoxCost; ///< In pixels; infinite if boxes are not used.
  int SlabGap;
  int Slabs = 0;
};

VTK_ABI_NAMESPACE_END
#endif
