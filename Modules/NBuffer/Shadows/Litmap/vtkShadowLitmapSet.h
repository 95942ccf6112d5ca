// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowLitmapSet
 * @brief The litmaps of one light, one or six, and the receivers on a caster's rays there. No
 * OpenGL.
 *
 * A directional or spot light has one litmap. A point light has six, one for each face of a cube
 * around it:
 *
 *        +-----------+      A caster whose bounding box lies in the pyramid of one face (a) is
 *        | \   b   / |      looked up like one before a spot: no other face has receivers on its
 *        |  \ ___ /  |      rays.
 *        |   \[ ]/   |      The rays of other casters (b) are looked up in all faces that they
 *        | a  \L/    |      meet, for the receivers' boxes of pixels alone.
 *        |[]  / \    |
 *        |   /   \   |
 *        +-----------+
 *
 * A positional light's coordinates mean nothing at and behind its plane s = 0. A caster that
 * reaches through this plane may have receivers anywhere.
 */
#ifndef vtkShadowLitmapSet_h
#define vtkShadowLitmapSet_h

#include "vtkNBufferModule.h" // For export macro
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

  /// A caster as it is looked up in one litmap.
  struct FaceQuery
  {
    Face Map;            ///< The litmap.
    vtkShadowBlock Rays; ///< The caster's rays, with depths from its nearest corner on.
  };

  /// A caster in all litmaps into which it may cast, and the receivers on its rays there.
  struct Lookup
  {
    std::vector<FaceQuery> Queries; ///< Empty if the caster's points were not given.
    vtkShadowExtent Extent;         ///< All receivers on the caster's rays.
    bool IsInOneFace = false;       ///< True if all its rays are in one litmap.
    double Near = 0.0;              ///< If so, the depth of the caster's nearest point there.
    double Far = 0.0;               ///< If so, the depth of the caster's farthest point there.
  };

  /// `faces` has one litmap, six for a point light, or none if nothing is known of the receivers.
  /// Light, spaces and litmaps must outlive the set.
  vtkShadowLitmapSet(const vtkShadowLight& light, std::vector<Face> faces);

  /// Returns true if there is any litmap.
  bool IsKnown() const { return !this->Faces.empty(); }

  /// Returns true if there are the six litmaps of a point light.
  bool HasFaces() const { return this->Faces.size() > 1; }

  /// Looks a caster up in the litmaps, of which there must be one at least. `points` are the
  /// caster's points. Without them the corners of its bounds stand for them.
  Lookup LookUp(const vtkShadowFootprint& footprint, const vtkShadowPoints* points = nullptr) const;

  /// Returns true if a caster with these light coordinates reaches through a positional light's
  /// plane s = 0, or lies behind it.
  bool IsThroughLightPlane(const vtkShadowBlock& block) const
  {
    return this->Light.IsPositional() && !(block.Low[2] > Margin * std::abs(block.High[2]));
  }

  /// Returns true if the caster lies wholly behind a spot and shadows nothing that the spot
  /// reaches, receivers outside of the cone included.
  bool IsBehindSpot(const vtkShadowFootprint& footprint) const
  {
    return this->Light.Kind == vtkShadowLightKind::Spot && footprint.Block.High[2] <= 0.0 &&
      this->GetWidestAngle() < 0.5 * vtkMath::Pi();
  }

  /// Returns true if the sphere around the caster's bounds lies outside of a spot's cone, which is
  /// widened by receivers outside of it.
  bool IsOutsideCone(const vtkShadowFootprint& footprint) const;

private:
  /// What rounding may do to a footprint, in units of the caster's own size, generously.
  static constexpr double Margin = 1e-6;

  /// The angle in radians from a spot's axis beyond which there is no receiver.
  double GetWidestAngle() const;

  const vtkShadowLight& Light;
  std::vector<Face> Faces;
};

VTK_ABI_NAMESPACE_END
#endif
