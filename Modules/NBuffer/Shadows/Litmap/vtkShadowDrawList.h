// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowDrawList
 * @brief The draws of shadow volumes for one light and one view: boxes of pixels, z-pass or z-fail,
 * and what the stencil has to hold. No OpenGL.
 *
 * ## z-pass or z-fail
 *
 * The stencil counts the faces of volumes on the line of sight: +1 where the line enters a volume,
 * -1 where it leaves one. There are two ways to count for receiver R:
 *
 *            enters           leaves          z-pass: the sum of the faces before R, here +1
 *      eye ----(+1)-----R-----(-1)---->       z-fail: minus the sum of those behind R, here -(-1)
 *                                             Both are 1: R is in shadow.
 *
 * z-pass is right if the eye is outside of the piece of volume: if the eye is inside, the face with
 * the (+1) is not before R. z-fail is always right. z-pass is used if the box around the piece lies
 * beyond the near plane, where the eye never is. This condition is stricter than necessary: it
 * would suffice that the eye is outside of the piece, if depth clamp replaced clipping at the near
 * plane. But then a triangle that reaches behind the eye is clipped at w = 0, where depths have no
 * bound, and rasterisers that interpolate depth on the screen lose the depth of the whole triangle.
 *
 * z-fail assumes that lines of sight end outside of all volumes, and that all faces behind the
 * receiver are drawn. For a parallel camera volumes of positional lights therefore end at finite
 * places (vtkShadowVolume.h). So do those of a directional light along which the camera looks: it
 * sees all sides of an infinite volume edge-on, and no face would be behind the receivers.
 *
 * ## The range of the stencil
 *
 * The stencil count of a receiver is at most the sum of the largest counts of the casters that its
 * light ray can meet (vtkShadowSilhouette::GetMaximumCount). The casters' rectangles in p and q
 * bound this sum (vtkShadowOverlap.h). If it is at most 255, all casters are counted at once.
 */
#ifndef vtkShadowDrawList_h
#define vtkShadowDrawList_h

#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowConeReach.h"
#include "vtkShadowFootprint.h"
#include "vtkShadowLight.h"
#include "vtkShadowOverlap.h"
#include "vtkShadowSilhouette.h"
#include "vtkShadowVolumeStore.h"

#include <algorithm>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// A run of a volume's triangles that are drawn in the same way.
struct vtkShadowDraw
{
  int FirstIndex = 0;      ///< Where it begins in vtkShadowVolume::GetIndices().
  int NumberOfIndices = 0; ///< The number of its indices there.
  bool ZPass = false;      ///< True for z-pass, false for z-fail.
  vtkNBufferRectangle Box; ///< The pixels of the viewport to draw into.
  int MaximumCount = 0;    ///< The largest stencil count that a receiver can get from it.
  /// How many of its indices, the first ones, are of triangles that are offset away from the eye,
  /// because the near cap lies in the caster's own surface (vtkShadowCounter.h).
  int NumberOfOffsetIndices = 0;
  /// For how much rounding all triangles are pushed in addition: vtkShadowPart::Rounding, rounded
  /// up to a power of two so that there are few values.
  float Rounding = 0.0f;
  /// True if it draws the triangles of the draw before it in another box. Both count as one draw.
  bool Again = false;
};

class VTKNBUFFER_EXPORT vtkShadowDrawList
{
public:
  /// Boxes of pixels of the viewport, which share no pixel.
  using Boxes = std::vector<vtkNBufferRectangle>;

  /// What the draws depend on besides light and casters.
  struct View
  {
    /// A vertex in world coordinates, relative to the eye. Directions (w = 0) stay as they are.
    glm::dvec4 ToEye(const glm::dvec4& vertex) const
    {
      return vertex - glm::dvec4(vertex.w * this->Eye, 0.0);
    }

    /// How far a volume is pushed for a rounding: the change of z / w, times w, if z and w are
    /// those of a point that is off by so much.
    double GetPush(double rounding) const
    {
      const auto getLength = [this](int row)
      { return glm::length(glm::dvec3(glm::row(this->EyeToClip, row))); };
      return rounding * (getLength(2) + getLength(3));
    }

    /// The largest push of the volumes of parts, whose rounding is rounded up.
    double GetPush(const std::vector<const vtkShadowPart*>& parts) const
    {
      double largest = 0.0;
      for (const vtkShadowPart* part : parts)
      {
        largest = std::max(largest, part->GetPushedRounding());
      }
      return this->GetPush(2.0 * largest);
    }

    glm::dvec3 Eye = { 0.0, 0.0, 0.0 };     ///< The camera's position in the world.
    glm::dmat4 EyeToClip = glm::dmat4(1.0); ///< See vtkNBufferCamera::GetEyeToClip().

    /// For a parallel camera the box, in world coordinates, around what it can see. It is empty for
    /// a perspective camera.
    vtkShadowBlock ParallelView;

    int Viewport[4] = { 0, 0, 0, 0 }; ///< x, y, width, height in the framebuffer.

    /// Without litmaps, which casters of a spot are not drawn. The default is none.
    vtkShadowConeReach ConeReach;

    /// True to draw into boxes of pixels, false to draw into the whole viewport: in mode Culled,
    /// and because some devices also draw outside of a scissor box (vtkNBufferGL::KeepsToScissor).
    bool Boxes = true;
  };

  vtkShadowDrawList(const vtkShadowLight& light, const View& view)
    : Light(light)
    , Camera(view)
  {
  }

  /// Changes the view of a list in which all draws are whole volumes, drawn everywhere. Returns
  /// false, and changes nothing, if the volumes depend on the view (vtkShadowVolume.h).
  bool SetView(const View& view);

  /// Adds the rays of a caster that will be drawn, for IsCountWithin(). Rays that are not finite
  /// stand for any ray.
  void AddRays(const vtkShadowSilhouette& silhouette, const vtkShadowBlock& rays);

  /// Adds the draws of the whole volume of a caster into these boxes, or everywhere if there are
  /// none.
  void AddWhole(const vtkShadowPart& caster, const Boxes& boxes, vtkShadowVolumeStore& store);

  /// Adds the draws of a clamped piece of a caster's volume (vtkShadowVolume::AddClamped).
  void AddClamped(const vtkShadowPart& caster, const vtkShadowLightSpace& space,
    const vtkShadowSlab& slab, double casterFar, const Boxes& boxes, vtkShadowVolumeStore& store);

  /// The draws, in the order in which they were added.
  const std::vector<vtkShadowDraw>& GetDraws() const { return this->Draws; }

  /// The number of their triangles. Those that are drawn into several boxes count once.
  long long GetNumberOfTriangles() const { return this->Triangles; }

  /// Returns true if no receiver can have a stencil count above `limit` when all volumes are drawn.
  bool IsCountWithin(int limit) const;

private:
  void AddDraws(const vtkShadowPart& caster, bool isNearCapItsOwn, const Boxes& boxes,
    const vtkShadowPiece& piece);
  bool IsBeyondNearPlane(const vtkShadowPiece& piece) const;

  vtkShadowLight Light;
  View Camera;
  std::vector<vtkShadowDraw> Draws;
  std::vector<vtkShadowPiece> Pieces; ///< The piece of each draw.
  long long Triangles = 0;
  std::vector<vtkShadowOverlap::Item> Items; ///< The rays of the casters, weighted by their counts.
  mutable std::optional<long long> Bound;    ///< vtkShadowOverlap::GetBound() of Items, if known.
};

VTK_ABI_NAMESPACE_END
#endif
