// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowPlan
 * @brief Which part of each caster's shadow volume is drawn for one light and one view. No OpenGL.
 *
 * Whatever a caster shadows lies on its rays, beyond its nearest depth (vtkShadowFootprint.h). For
 * the receivers on these rays, the litmaps (vtkShadowLitmapSet.h) know the range of depths, the box
 * on the screen, and the occupied bins of depth. An example with the receivers r1, r2 and r3:
 *
 *        light
 *          |  |  |  |
 *          | (r1)   |                    r1 is before the caster, which cannot shadow it
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
 * vtkShadowVerdict (vtkShadowStatistics.h) lists the verdicts about a caster. The most common ones
 * are NoReceiver, BeforeCaster, Boxed and, in mode Clamped, Clamped.
 *
 * The boxes are found in the receivers' box on the screen: they enclose the tiles of 4 x 4 pixels
 * that the caster's shadow can reach (vtkShadowUmbra.h, vtkShadowTiles.h). A box is divided if that
 * leaves out more pixels than it costs to draw the triangles once more (vtkShadowTuning::BoxCost).
 * If the shadow reaches no tile, the verdict is NoReceiver or BeforeCaster.
 *
 * Leaving out casters and drawing into boxes change no vertex and so no fragment: the stencil is
 * bit for bit that of whole volumes wherever there is a receiver. Slabs make new vertices, which
 * the device snaps to its own subpixel grid, independently of the others. So samples closer than
 * one step of this grid to the edge of a shadow may change.
 *
 * A positional light's coordinates mean nothing at and behind its plane s = 0:
 *
 *           [a]                   a is behind the plane: BehindLight, not drawn. It shadows nothing
 *      ----- L ----[b]---- s = 0    that a spot of less than 90 degrees reaches.
 *           / \                   b is in the plane: ThroughLightPlane, drawn whole into boxes
 *          /   \                    around all receivers; or OutsideCone, not drawn, if the sphere
 *         /cone \                   around its bounds lies outside of the spot's cone.
 *
 * Receivers outside of the cone (vtkShadowReceiverProjector.h) widen it. If one of them may lie
 * behind the light, the verdict is never BehindLight. Without litmaps a caster is OutsideCone if
 * that follows from its place and the camera's alone (vtkShadowConeReach.h).
 *
 * With the six litmaps of a point light, the volumes of casters whose rays are all in one face can
 * be clamped to slabs; the volumes of others are never clamped.
 */
#ifndef vtkShadowPlan_h
#define vtkShadowPlan_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowDrawList.h"
#include "vtkShadowFootprint.h"
#include "vtkShadowLitmapSet.h"
#include "vtkShadowStatistics.h"
#include "vtkShadowTuning.h"

#include <array>
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

  /// The decision about a caster, with all that Draw() needs.
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
   * Makes a plan without casters. `litmaps` has the litmap of the light, or the six of a point
   * light, with their levels built. If it is empty, or with mode Unclamped, all volumes are drawn
   * whole, except for those that View::ConeReach excludes. The litmaps and their light spaces must
   * outlive the plan.
   */
  vtkShadowPlan(const vtkShadowLight& light, const View& view, vtkShadowMode mode,
    std::vector<Face> litmaps, const vtkShadowTuning& tuning);

  /// Changes the view of a plan without litmaps; see vtkShadowDrawList::SetView(). Returns false if
  /// View::ConeReach differs.
  bool SetView(const View& view)
  {
    return view.ConeReach == this->ConeReach && this->Draws.SetView(view);
  }

  /// Decides about a caster. It changes nothing and may be called in parallel.
  Choice Decide(const vtkShadowPart& caster) const;

  /// Returns the verdict if the caster's footprint and one lookup prove that it is not drawn, else
  /// nothing. Decide() begins with this test, because the test does not read the caster's points,
  /// which take long to fetch from memory if there are many casters.
  std::optional<vtkShadowVerdict> EarlyOut(const vtkShadowPart& caster) const;

  /// Counts the decision about a caster and carries it out: adds its draws to GetDraws(). Their
  /// triangles are in `store`.
  void Draw(const Choice& choice, const vtkShadowPart& caster, vtkShadowVolumeStore& store);

  /// The draws of all casters.
  const std::vector<vtkShadowDraw>& GetDraws() const { return this->Draws.GetDraws(); }

  /// The number of casters with each verdict.
  const std::array<int, vtkShadowStatistics::NumberOfVerdicts>& GetVerdicts() const
  {
    return this->Verdicts;
  }

  /// The number of slabs that are drawn.
  int GetNumberOfSlabs() const { return this->Slabs; }

  /// See vtkShadowDrawList::GetNumberOfTriangles().
  long long GetNumberOfTriangles() const { return this->Draws.GetNumberOfTriangles(); }

  /// Returns true if no receiver can have a stencil count above `limit` when all volumes are drawn.
  bool IsCountWithin(int limit) const { return this->Draws.IsCountWithin(limit); }

private:
  using Lookup = vtkShadowLitmapSet::Lookup;

  static std::optional<vtkShadowVerdict> EarlyOutByReceivers(const Lookup& lookup);
  /// Returns the boxes of pixels to draw into. `isOnRays` becomes true if any receiver is on the
  /// caster's rays, at any depth; otherwise it stays as it is.
  Boxes FindBoxes(const Lookup& lookup, const vtkShadowPart& caster, bool& isOnRays) const;
  std::vector<vtkShadowSlab> GetSlabs(const Lookup& lookup) const;

  vtkShadowLitmapSet Litmaps;
  vtkShadowDrawList Draws;
  bool IsClamped; ///< True in mode Clamped.
  double BoxCost; ///< In pixels; infinite if boxes are not used.
  vtkShadowConeReach ConeReach;
  int SlabGap;
  std::array<int, vtkShadowStatistics::NumberOfVerdicts> Verdicts = {};
  int Slabs = 0;
};

VTK_ABI_NAMESPACE_END
#endif
