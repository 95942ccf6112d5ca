// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowLitmapSet
 * @brief Looks up the receivers on a caster's rays in all litmaps of one light. No OpenGL.
 *
 * A directional or spot light has one litmap. A point light has six, one for each face of a cube
 * around it:
 *
 *        +-----------+      A caster whose bounding box lies in the pyramid of one face (a) is
 *        | \   b   / |      looked up as for a spot: no other face has receivers on its rays.
 *        |  \ ___ /  |
 *        |   \[ ]/   |      Other casters (b) are looked up in all faces that their rays may meet,
 *        | a  \L/    |      which finds boxes of pixels, but no slabs.
 *        |[]  / \    |
 *        |   /   \   |
 *        +-----------+
 */
#ifndef vtkShadowLitmapSet_h
#define vtkShadowLitmapSet_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowConeReach.h"
#include "vtkShadowFootprint.h"
#include "vtkShadowLight.h"
#include "vtkShadowLitmap.h"

#include "vtkMath.h"

#include <cmath>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkShadowLitmapSet
{
public:
  /// A litmap with the light space that it was made in.
  struct Face
  {
    const vtkShadowLightSpace* Space;
    const vtkShadowLitmap* Litmap;
  };

  /// One litmap, and the rays of a caster for which it is read.
  struct FaceQuery
  {
    Face Map; ///< The litmap.
    /// The caster's rays, and depths from its nearest point to infinity. All are infinite if the
    /// caster reaches through the light's plane.
    vtkShadowBlock Rays;
  };

  /// The result of LookUp().
  struct Lookup
  {
    std::vector<FaceQuery> Queries; ///< The litmaps that were read; empty without `points`.
    vtkShadowExtent Extent;         ///< The merged extent of all receivers on the caster's rays.
    /// True if all rays of the caster are known and in one litmap. Only then are Near and Far
    /// valid.
    bool IsInOneFace = false;
    double Near = 0.0; ///< The depth of the caster's nearest point in this litmap.
    double Far = 0.0;  ///< The depth of the caster's farthest point in this litmap.
  };

  /// `faces` has one litmap, six for a point light, or none if nothing is known of the receivers.
  /// The light spaces and the litmaps must outlive the set.
  vtkShadowLitmapSet(const vtkShadowLight& light, std::vector<Face> faces);

  /// Returns true if there is any litmap.
  bool IsKnown() const { return !this->Faces.empty(); }

  /// Returns true if there are the six litmaps of a point light.
  bool HasFaces() const { return this->Faces.size() > 1; }

  /// Looks a caster up in the litmaps, of which there must be at least one. `points` are the
  /// caster's points. Without them Queries stays empty and, for a point light, the corners of the
  /// caster's bounds are used, so that more receivers may be found.
  Lookup LookUp(const vtkShadowFootprint& footprint, const vtkShadowPoints* points = nullptr) const;

  /// Returns true if a caster with these light coordinates reaches to a positional light's plane
  /// s = 0 or lies behind it. It may have receivers on any ray.
  bool IsThroughLightPlane(const vtkShadowBlock& block) const
  {
    return this->Light.IsPositional() && !(block.Low[2] > Margin * std::abs(block.High[2]));
  }

  /// Returns true if the caster lies wholly behind a spot's plane s = 0, and all receivers, also
  /// those outside of the cone, lie before it. Then the caster shadows none of them.
  bool IsBehindSpot(const vtkShadowFootprint& footprint) const
  {
    return this->Light.Kind == vtkShadowLightKind::Spot && footprint.Block.High[2] <= 0.0 &&
      this->GetWidestAngle() < 0.5 * vtkMath::Pi();
  }

  /// Returns true if the caster of a spot shadows no receiver, whatever the litmap says.
  bool IsBeyondReach(const vtkShadowFootprint& footprint, const vtkShadowConeReach& reach) const;

  /// Returns true if the sphere around the caster's bounds lies outside of a spot's cone. The cone
  /// is widened to hold the receivers outside of it.
  bool IsOutsideCone(const vtkShadowFootprint& footprint) const;

private:
  /// A generous bound of the rounding error of a footprint's depths, relative to the farthest one.
  static constexpr double Margin = 1e-6;

  /// The angle in radians from a spot's axis beyond which there is no receiver.
  double GetWidestAngle() const;

  /// The sphere around a caster's bounds as seen from the light: the least angle from the axis, in
  /// radians, and the least distance. The angle is negative if the light is in the sphere.
  struct Nearest
  {
    double Angle = -1.0;
    double Distance = 0.0;
  };
  Nearest GetNearest(const vtkShadowFootprint& footprint) const;

  vtkShadowLight Light;
  std::vector<Face> Faces;
};

VTK_ABI_NAMESPACE_END
#endif
