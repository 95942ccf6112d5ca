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

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkShadowLitmapSet
{
public:
  /// A litmap with the light space that it was made in.
  struct Face
  {
    const vtkShadowLightSpace* Space = nullptr;
    const vtkShadowLitmap* Litmap = nullptr; ///< Null if nothing is known of the receivers.
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
    const FaceQuery* begin() const { return this->Queries.data(); }
    const FaceQuery* end() const { return this->Queries.data() + this->Count; }
    void Add(const FaceQuery& query) { this->Queries[this->Count++] = query; }

    std::array<FaceQuery, 6> Queries; ///< At most one for each face of a cube.
    std::size_t Count = 0;            ///< The number of queries.
    vtkShadowExtent Extent;           ///< All receivers on the caster's rays.
    bool IsInOneFace = false;         ///< True if all its rays are in the first query's litmap.
    double Near = 0.0; ///< If so, the depth of the caster's nearest point in that face.
    double Far = 0.0;  ///< If so, the depth of the caster's farthest point in that face.
  };

  /// `litmap` may be null. The arguments must outlive the set.
  vtkShadowLitmapSet(
    const vtkShadowLight& light, const vtkShadowLightSpace& space, const vtkShadowLitmap* litmap);

  /// Adds one of the six litmaps of a point light, with its light space. Both must outlive the set.
  void AddFace(const vtkShadowLightSpace& space, const vtkShadowLitmap& litmap);

  /// Returns true if there is any litmap.
  bool IsKnown() const { return this->Whole.Litmap || !this->Faces.empty(); }

  /// Returns true for a point light with six litmaps.
  bool HasFaces() const { return !this->Faces.empty(); }

  /// Looks a caster up in the litmaps, of which there must be one at least. `points` are the
  /// caster's points, or those of a hull around it.
  Lookup LookUp(const vtkShadowFootprint& footprint, vtkShadowPoints points) const;

  /// Returns true if the caster reaches through a positional light's plane s = 0, or lies behind
  /// it.
  bool IsThroughLightPlane(const vtkShadowFootprint& footprint) const;

  /// Returns true if the caster lies wholly behind a spot and shadows nothing that the spot
  /// reaches, receivers outside of the cone included.
  bool IsBehindSpot(const vtkShadowFootprint& footprint) const;

  /// Returns true if the sphere around the caster's bounds lies outside of a spot's cone, which is
  /// widened by receivers outside of it.
  bool IsOutsideCone(const vtkShadowFootprint& footprint) const;

private:
  const Face* FindContainingFace(const vtkShadowFootprint& footprint) const;
  FaceQuery MakeFaceQuery(const Face& face, const vtkShadowFootprint& footprint) const;
  void AddFaces(const vtkShadowFootprint& footprint, Lookup& lookup) const;

  /// The angle in radians from a spot's axis beyond which there is no receiver.
  double GetWidestAngle() const;

  const vtkShadowLight& Light;
  Face Whole;              ///< The only litmap of a light that is not a point light.
  std::vector<Face> Faces; ///< The litmaps of a point light.
};

VTK_ABI_NAMESPACE_END
#endif
