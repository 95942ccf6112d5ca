// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class VolumeStudy
 * @brief The shadow volumes of one frame, drawn in ways that vtkShadowVolumeClampPass does not
 * offer, so that each of its steps can be measured alone.
 *
 * It is made of the private classes of the module: casters, litmaps, plans, and the counter of
 * fragments are those of the pass. Only what is done with them differs (VolumeWay).
 */
#ifndef VolumeStudy_h
#define VolumeStudy_h

#include "Session.h"

#include "vtkShadowCamera.h"
#include "vtkShadowCasterList.h"
#include "vtkShadowCounter.h"
#include "vtkShadowLightList.h"
#include "vtkShadowPlan.h"
#include "vtkShadowTarget.h"
#include "vtkShadowTuning.h"
#include "vtkShadowVolumeBuffer.h"
#include "vtkShadowVolumeStore.h"

#include "vtkPolyData.h"

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkInformation;
class vtkLight;

namespace NBufferBench
{

/// For each pixel, row 0 at the bottom, the place of a caster among VolumeStudy's, or -1.
using CasterPixels = std::vector<int>;

/// A way to draw the volumes of a light.
struct VolumeWay
{
  vtkShadowMode Mode = vtkShadowMode::Clamped;
  vtkShadowTuning Tuning;
  bool Boxes = true; ///< Draw into boxes of pixels; else into the whole viewport.
  bool Tiles = true; ///< Test tiles of pixels; else only the litmap is read.
  bool Reach =
    false; ///< In mode Unclamped, leave out casters that shadow nothing in a spot's cone.
  /// A pixel is no receiver for the caster that is named here. (nullptr: all pixels are.)
  const CasterPixels* Excluded = nullptr;
  /// A pixel is a receiver only for the caster that is named here. (nullptr: for all of them.)
  const CasterPixels* Only = nullptr;
};

class VolumeStudy
{
public:
  /// The light is the only one of the session's renderer. Only props with the keys cast; nullptr:
  /// all props. Throws std::runtime_error unless each of them is one caster.
  VolumeStudy(Session& session, vtkInformation* casterKeys);

  /// Draws the depth of the receivers of a pose, and then calls `work`, which may call the
  /// functions below. Throws std::runtime_error if OpenGL fails.
  void Run(const NBufferExamples::CameraPose& pose, const std::function<void()>& work);

  int GetNumberOfCasters() const { return static_cast<int>(this->Places.size()); }

  /// Returns the place of the caster of a prop, or -1 if the prop does not cast.
  int GetPlace(vtkProp* prop) const;

  /// Finds by rays, for each pixel of the pose that is set, the caster that the ray from its place
  /// to the light meets first.
  CasterPixels FindNearestCasters(vtkLight* light) const;

  /// Returns whether a caster is proven to be a convex body (vtkShadowTopology::IsConvex()).
  bool IsConvex(int caster) const;

  /// What Draw() finds.
  struct Result
  {
    long long Fragments = 0;
    int Drawn = 0;                   ///< The casters of which anything is drawn.
    int Pieces = 0;                  ///< The pieces of volumes that are drawn.
    double ScatterTime = 0.0;        ///< Milliseconds to fill the litmap that is read last.
    double LevelsTime = 0.0;         ///< Milliseconds to build its levels.
    std::vector<unsigned char> Mask; ///< For each pixel 0 if it is lit.
  };

  /// Draws all volumes, or those of the casters for which `isCounted` is true.
  Result Draw(const VolumeWay& way, const std::function<bool(int caster)>& isCounted = {});

  /// The triangles of the volumes of the last Draw(). What lies at infinity is put `reach` away.
  vtkSmartPointer<vtkPolyData> GetVolumes(double reach) const;

  /// The bounds in the world of the pieces of the last Draw(), without what lies at infinity.
  std::vector<vtkShadowBlock> GetPieces() const;

  /// The places of all receivers in the world.
  std::vector<glm::dvec3> GetReceivers() const;

private:
  void Check(bool done) const; ///< Throws if an OpenGL call has failed.
  void Begin(vtkRenderer* renderer);
  /// Fills the litmap, and sets the times of the result.
  void MakeLitmap(
    const VolumeWay& way, const std::vector<float>& depth, vtkShadowLitmap& litmap, Result& result);
  /// The depth without the pixels that are no receivers of a caster.
  std::vector<float> GetDepthFor(const VolumeWay& way, int caster) const;

  Session& Where;
  vtkShadowCasterList Casters;
  std::map<vtkProp*, int> Places; ///< Of the props that cast.
  double LightingMargin = 0.0;
  vtkShadowLight Light;
  std::unique_ptr<vtkShadowLightSpace> Space;
  std::unique_ptr<vtkShadowCamera> Camera;
  vtkRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkShadowTarget Target;
  vtkShadowCounter Counter;
  vtkShadowVolumeStore Store;
  vtkShadowVolumeBuffer Buffer;
  std::vector<vtkShadowDraw> Draws; ///< Of the last Draw().
  std::vector<float> Depth;
  std::string Error;
};

} // namespace NBufferBench

#endif
