// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowMaskMaker
 * @brief Makes the shadow mask of each light from the casters and the depth of the receivers.
 *
 *     receivers' depth (drawn by the caller into GetTarget())
 *        |                 for each light:
 *        +-- read --> litmap --> plan: which part of which caster's volume
 *        |                          |
 *        +------ stencil <----------+
 *                   |
 *                   +--> channel of a mask
 */
#ifndef vtkShadowMaskMaker_h
#define vtkShadowMaskMaker_h

#include "vtkShadowCasterList.h"
#include "vtkShadowCostModel.h"
#include "vtkShadowCounter.h"
#include "vtkShadowDebugView.h"
#include "vtkShadowEstimate.h"
#include "vtkShadowLightList.h"
#include "vtkShadowLitmap.h"
#include "vtkShadowPlan.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowStatistics.h"
#include "vtkShadowTarget.h"
#include "vtkShadowTimers.h"
#include "vtkShadowTuning.h"
#include "vtkShadowVolumeBuffer.h"
#include "vtkShadowVolumeStore.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkRenderer;

class vtkShadowMaskMaker
{
public:
  /// The settings of the pass.
  struct Settings
  {
    vtkShadowMode Mode;
    const vtkShadowTuning& Tuning;
    vtkShadowPicture Picture;     ///< The debug view to make.
    const vtkLight* PictureLight; ///< The light that it shows; nullptr means the first one.
  };

  /// A frame whose masks are made.
  struct Frame
  {
    const vtkShadowMaskMaker::Settings& Settings;
    vtkRenderer* Renderer;
    const std::vector<vtkShadowLightSource>& Lights;
    const vtkShadowCasterList& Casters;
    vtkShadowTimers& Timers;         ///< Measures the stage Draw.
    vtkShadowDebugView& DebugView;   ///< Its image is made; the caller shows it.
    vtkShadowStatistics& Statistics; ///< The counts and times of the masks are added to these.
  };

  /// Allocates the masks of this many lights for the viewport that is set now, with the samples of
  /// the framebuffer that is bound for drawing: see vtkShadowTarget::Reserve(). GetError() has the
  /// cause if that fails, or if the device refuses these samples.
  bool Reserve(vtkOpenGLRenderWindow* window, std::size_t lights);

  /**
   * Makes the masks. Call Reserve() and draw the depth of the receivers before. Returns false on
   * failure, with the cause in GetError(). Afterwards GetNumberOfShadows() is the number of lights
   * for which a volume was drawn.
   */
  bool Make(const Frame& frame);

  int GetNumberOfShadows() const { return this->Shadows; }

  /// The masks. A light has the number that it has in Frame::Lights.
  vtkShadowTarget& GetTarget() { return this->Target; }
  /// The viewport of the last Reserve(): x, y, width and height in pixels of the framebuffer.
  const int* GetViewport() const { return this->Viewport; }
  const std::string& GetError() const { return this->Error; }

  /// Deletes the OpenGL objects; the context that made them must be current.
  void Release();

private:
  struct Work;
  /// What is kept of a light from frame to frame.
  struct Volumes
  {
    vtkShadowVolumeStore Store;
    vtkShadowVolumeBuffer Buffer;
    std::optional<vtkShadowPlan> Whole; ///< The plan of its whole volumes; see PlanWhole().
    vtkMTimeType CastersVersion = 0;    ///< vtkShadowCasterList::GetVersion() of that plan.
    vtkMTimeType StoreTime = 0;         ///< vtkShadowVolumeStore::GetTime() of that plan.
    vtkShadowEstimate Estimate;         ///< What drawing its whole volumes costs.
  };

  std::size_t GetNumberOfSamples() const; ///< The number of all samples of the viewport.
  vtkShadowView GetReceiverView(const Work& work) const;
  bool ReadReceivers(const Work& work);
  bool MakeLitmaps(const Work& work, const std::vector<vtkShadowLightSpace>& spaces,
    std::vector<vtkShadowPlan::Face>& faces);
  void FindParts(const Work& work);
  void AddCasters(const Work& work, vtkShadowPlan& plan);
  /// The camera's view for plans of whole volumes. In mode Automatic it has a ConeReach for a spot.
  vtkShadowPlan::View GetWholeView(const Work& work) const;
  /// Plans to draw whole volumes. While neither casters nor light change, this is the last such
  /// plan, in another view.
  vtkShadowPlan& PlanWhole(const Work& work, const vtkShadowPlan::View& view);
  void MeasureCosts(const Work& work); ///< Of the mode Automatic.
  /// Returns whether litmaps are likely to be worth their cost by the estimate of the light. Sets
  /// the estimates of `cost`. Measures the costs if that is due.
  bool IsLitmapWorthIt(const Work& work, vtkShadowLightCost& cost);
  long long EstimateCovered(const Work& work); ///< The number of samples that are not background.
  /// Draws the shadows of a light, and sets all of `cost` except Time.
  bool Shade(const Work& work, vtkShadowLightCost& cost);
  bool Count(const Work& work, const vtkShadowPlan& plan);

  vtkShadowTarget Target;
  vtkShadowCounter Counter;
  std::shared_ptr<vtkShadowLitmapSource> LitmapSource; ///< The last source that was used, if any.
  std::vector<float> Depth; ///< The window depths of all samples (vtkShadowTarget::ReadDepth()).
  bool IsDepthRead = false; ///< True if Depth and LitmapSource are those of the current frame.
  std::vector<vtkShadowLitmap> Litmaps;    ///< One, or six for a point light, of the current light.
  std::vector<Volumes> LightVolumes;       ///< By the number of the light.
  std::vector<const vtkShadowPart*> Parts; ///< Of all casters, in order, for the current light.
  std::vector<vtkShadowPlan::Choice> Choices; ///< The decision about each of Parts.
  vtkShadowCoverage Coverage;
  vtkShadowCostModel::Costs Costs; ///< Of the mode Automatic.
  int Viewport[4] = { 0, 0, 0, 0 };
  int Shadows = 0;
  std::string Error;
};

VTK_ABI_NAMESPACE_END
#endif
