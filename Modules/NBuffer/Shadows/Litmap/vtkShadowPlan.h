// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowPlan
 * @brief What has to be drawn of each caster's shadow volume for one light and one view. No OpenGL.
 *
 * ## The footprint
 *
 * In light coordinates (vtkShadowLight.h) a caster takes up a rectangle of rays [p0, p1] x [q0, q1]
 * and a range of depths [near, far]. Whatever it shadows lies on those rays, at depths beyond near.
 * A litmap (vtkShadowLitmap.h) knows an extent of all receivers on them: a range of depths, a box
 * on the screen, occupied bins. So a caster
 *
 *  - without receivers on its rays draws nothing                        (NoReceiver),
 *  - whose receivers all are nearer to the light than itself, too       (BeforeCaster),
 *  - draws into the receivers' box of pixels only otherwise, and, if planes may be added,
 *  - only the part of its volume in the slabs that the receivers take up.
 *
 * Of this box, the tiles of 4 x 4 pixels that the caster's shadow can reach (vtkShadowUmbra.h) are
 * found, and the volume is drawn into few boxes around these (vtkShadowTiles.h): one more where it
 * leaves out more pixels than drawing the triangles once more costs (View::BoxCost). A caster that
 * reaches no tile is one of the two that draw nothing.
 *
 * Leaving out and cutting to a box of pixels change no vertex and with that no fragment: the
 * stencil is bit for bit that of whole volumes wherever there is a receiver. Slabs make new
 * vertices, which the device snaps to its subpixel grid by themselves: samples closer to the edge
 * of a shadow than that may change.
 *
 * A positional light's coordinates mean nothing at and behind its plane s = 0. A caster that is
 * wholly there shadows nothing that a spot of less than 90 degrees reaches (BehindLight); one that
 * reaches through it is drawn whole, into the box of all receivers (ThroughLightPlane), unless the
 * sphere around its bounds lies beside the spot's cone (OutsideCone). Receivers
 * beside the cone (vtkShadowReceivers.h) widen it, and where one may lie behind the light, nothing
 * is BehindLight.
 *
 * A point light has six litmaps, one for each face of a cube around it. A caster whose bounding box
 * lies in the pyramid of one face is as one before a spot: no other face has receivers on its rays,
 * and its volume can be clamped to slabs. The rays of others are looked up in all faces that they
 * meet, for the receivers' boxes of pixels alone: their volumes are never clamped.
 *
 * ## The range of the stencil
 *
 * A receiver is inside of volumes at most as often as the casters that its light ray can meet
 * count. Where the rectangles of rays of all casters bound that by 255, all are counted at once.
 *
 * ## z-pass or z-fail
 *
 * Counting between the eye and the receiver (z-pass) is right if the eye is outside of the piece.
 * Counting behind the receiver (z-fail) is right always. z-pass is taken where the whole piece lies
 * beyond the near plane, which the eye never does. That asks for more than it has to: an eye
 * outside of the piece would do, with depth clamp in the place of near clipping. But what then
 * reaches behind the eye is cut at w = 0, where depths have no bound, and rasterisers that
 * interpolate depth on the screen lose it all over the triangle. For z-fail what lies before the
 * near plane is of no use and is cut off there.
 *
 * With a parallel camera the lines of sight end at infinity, outside of every clamped piece. Whole
 * volumes reach to infinity themselves: for a directional light in its direction alone, for a
 * positional light in all directions in which a triangle counts. Where lines of sight end inside c
 * times, the stencil begins at c instead of 0, everywhere.
 */
#ifndef vtkShadowPlan_h
#define vtkShadowPlan_h

#include "vtkShadowLight.h"
#include "vtkShadowLitmap.h"
#include "vtkShadowOverlap.h"
#include "vtkShadowSilhouette.h"
#include "vtkShadowStatistics.h"
#include "vtkShadowTiles.h"
#include "vtkShadowUmbra.h"
#include "vtkShadowVolume.h"

#include <array>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// What a caster takes up in light coordinates.
struct VTKNBUFFER_EXPORT vtkShadowFootprint
{
  double P[2] = { 0.0, 0.0 }; ///< Undefined if Near <= 0 for a positional light.
  double Q[2] = { 0.0, 0.0 };
  double Near = 0.0;
  double Far = 0.0;
  double Bounds[6] = {}; ///< World.

  static vtkShadowFootprint Make(
    const double* points, int numberOfPoints, const vtkShadowLightSpace& frame);

  /// Of the triangles that count alone; `points`: those that the silhouette was computed with.
  static vtkShadowFootprint Make(
    const vtkShadowSilhouette& silhouette, const double* points, const vtkShadowLightSpace& frame);
};

/// A run of a volume's triangles that are drawn in the same way.
struct vtkShadowDraw
{
  int FirstIndex = 0;
  int NumberOfIndices = 0;
  bool ZPass = false;
  int Box[4] = { 0, 0, 0, 0 }; ///< Pixels of the framebuffer to draw into: x, y, width, height.
  int MaximumCount = 0;        ///< No receiver is inside more often.
  int Start = 0;               ///< What the stencil has to begin with beside.
  bool Offset = false;         ///< Has caps in surfaces that may be lit: push it away a little.
  bool Again = false; ///< The triangles of the draw before, in a box apart from its: count as one.
};

class VTKNBUFFER_EXPORT vtkShadowPlan
{
public:
  struct View
  {
    /// z + w of the clip coordinates of (x, y, z, w) relative to the volume's origin, which is
    /// positive beyond the near plane.
    double NearPlane[4] = { 0.0, 0.0, 0.0, 1.0 };
    double Direction[3] = { 0.0, 0.0, -1.0 }; ///< World: where the camera looks.
    bool Parallel = false;
    int Viewport[4] = { 0, 0, 0, 0 }; ///< Of the framebuffer: x, y, width, height.
    /// Whether to draw in boxes of pixels; not all devices keep to them
    /// (vtkNBufferGL::KeepsToScissor).
    bool Boxes = true;
    /// What one more box is worth, in pixels left out, and 1/32 of it for each triangle that it has
    /// set up again. The default is a compromise: software renderers fill in a few nanoseconds for
    /// each pixel and set up a triangle in some tenths of a microsecond, devices are limited by
    /// what they fill.
    double BoxCost = 256.0;
  };

  /**
   * `litmap` has its levels built and must outlive the plan; nullptr: nothing is known of the
   * receivers, as with the mode Unclamped. `gap`: empty bins of 64 that part two slabs.
   */
  vtkShadowPlan(const vtkShadowLight& light, const vtkShadowLightSpace& frame, const View& view,
    vtkShadowMode mode, const vtkShadowLitmap* litmap, int gap = 4);

  /// One of the six litmaps of a point light, with its frame; both must outlive the plan.
  void AddFace(const vtkShadowLightSpace& frame, const vtkShadowLitmap& litmap);

  using Boxes = std::vector<vtkNBufferRectangle>; ///< Of pixels of the viewport.

  struct BoxedSlab
  {
    vtkShadowSlab Slab;
    Boxes Where;
  };

  /// A decision about a caster, and what follows from it.
  struct Choice
  {
    bool IsDrawn() const
    {
      return this->Verdict == vtkShadowVerdict::Whole || !this->Where.empty() ||
        !this->Slabs.empty();
    }

    vtkShadowVerdict Verdict = vtkShadowVerdict::Empty;
    Boxes Where;                  ///< Of its whole volume; empty and Whole: everywhere.
    std::vector<BoxedSlab> Slabs; ///< Of a volume that is clamped; along an axis
    const vtkShadowLightSpace* Frame = nullptr; ///< of this frame, in which
    double Far = 0.0;                           ///< the caster ends here.
  };

  /**
   * Why a caster is not drawn, as far as its box and one lookup tell: nothing if that is not
   * enough. Decide() comes to the same, but reads the caster's points, which the processor has to
   * fetch for each of many casters. Only reads: safe in parallel.
   */
  std::optional<vtkShadowVerdict> EarlyOut(
    const vtkShadowSilhouette& silhouette, const vtkShadowFootprint& footprint) const;

  /// Decide about a caster. Only reads: safe in parallel.
  Choice Decide(const vtkShadowSilhouette& silhouette, const double* points, int numberOfPoints,
    const vtkShadowFootprint& footprint) const;

  /// Add what was chosen for a caster: its triangles to `volume`, its draws to GetDraws().
  void Draw(const Choice& choice, const vtkShadowSilhouette& silhouette, const double* points,
    int numberOfPoints, const vtkShadowFootprint& footprint, vtkShadowVolume& volume);

  const std::vector<vtkShadowDraw>& GetDraws() const { return this->Draws; }

  /// True if no receiver is inside of all volumes drawn more often than this.
  bool IsCountBelow(int limit) const;
  int GetNumberOfSlabs() const { return this->Slabs; }

private:
  struct Face
  {
    const vtkShadowLightSpace* Frame = nullptr;
    const vtkShadowLitmap* Litmap = nullptr;
  };
  /// A caster as it is looked up in a litmap.
  struct FaceQuery
  {
    Face Map;
    vtkShadowBlock Rays; ///< Depths from its nearest corner on.
  };
  /// A caster in all litmaps into which it may cast, and the receivers on its rays there.
  struct Lookup
  {
    const FaceQuery* begin() const { return this->Queries.data(); }
    const FaceQuery* end() const { return this->Queries.data() + this->Count; }
    void Add(const FaceQuery& query) { this->Queries[this->Count++] = query; }

    std::array<FaceQuery, 6> Queries; ///< As many as a cube has faces.
    std::size_t Count = 0;
    vtkShadowExtent Extent;
    bool IsInOneFace = false; ///< All its rays are in the first one, where the caster
    double Near = 0.0;        ///< begins
    double Far = 0.0;         ///< and ends.
  };

  /// Where all of a caster's rays are; nullptr: in no one face, or through the light's plane.
  const Face* FindContainingFace(const vtkShadowFootprint& footprint) const;
  FaceQuery MakeFaceQuery(const Face& face, const vtkShadowFootprint& footprint) const;
  void AddFaces(const vtkShadowFootprint& footprint, Lookup& lookup) const;
  /// `points`: of the caster, or of a hull around it.
  Lookup LookUp(
    const vtkShadowFootprint& footprint, const double* points, int numberOfPoints) const;
  std::optional<vtkShadowVerdict> EarlyOutByPlace(
    const vtkShadowSilhouette& silhouette, const vtkShadowFootprint& footprint) const;
  static std::optional<vtkShadowVerdict> EarlyOutByReceivers(const Lookup& lookup);
  Boxes FindBoxes(const Lookup& lookup, const vtkShadowSilhouette& silhouette, const double* points,
    bool& isOnRays) const;
  std::vector<vtkShadowSlab> GetSlabs(const Lookup& lookup) const;
  std::vector<BoxedSlab> ChooseSlabs(const Lookup& lookup, const vtkShadowSilhouette& silhouette,
    const double* points, bool& isOnRays) const;
  void AddSlab(const Choice& choice, const BoxedSlab& slab, const vtkShadowSilhouette& silhouette,
    const double* points, int numberOfPoints, vtkShadowVolume& volume);
  bool IsThroughLightPlane(const vtkShadowFootprint& footprint) const;
  bool HasLitmaps() const;
  double GetWidestAngle() const; ///< Of a spot, radians.
  bool IsOutsideCone(const vtkShadowFootprint& footprint) const;
  bool IsBeyondNearPlane(const vtkShadowVolume& volume, std::size_t firstVertex) const;
  void AddWhole(const vtkShadowSilhouette& silhouette, const double* points, int numberOfPoints,
    const Boxes& boxes, vtkShadowVolume& volume);
  void AddRectangle(const vtkShadowSilhouette& silhouette, const vtkShadowFootprint& footprint);
  void AddDraw(const vtkShadowVolume& volume, const Boxes& boxes, vtkShadowDraw draw);

  const vtkShadowLight& Light;
  const vtkShadowLightSpace& Frame;
  View Camera;
  vtkShadowMode Mode;
  Face Whole; ///< Of lights that are not points; without a litmap: Unclamped.
  std::vector<Face> Faces;
  std::vector<vtkShadowRectangle> Rectangles; ///< Of the casters drawn, weighted by their counts.
  int Gap;
  int Slabs = 0;
  std::vector<vtkShadowDraw> Draws;
};

VTK_ABI_NAMESPACE_END
#endif
