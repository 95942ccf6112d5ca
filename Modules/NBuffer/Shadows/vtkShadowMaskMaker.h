// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowMaskMaker
 * @brief From casters, lights and the depth of the receivers to one mask for each light.
 *
 *     receivers' depth (drawn by the caller after BeginDepth())
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
#include "vtkShadowCounter.h"
#include "vtkShadowDebugView.h"
#include "vtkShadowLightList.h"
#include "vtkShadowLitmap.h"
#include "vtkShadowPlan.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowStatistics.h"
#include "vtkShadowTarget.h"
#include "vtkShadowTargetReader.h"
#include "vtkShadowTimers.h"
#include "vtkShadowTuning.h"
#include "vtkShadowVolume.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkRenderer;

class vtkShadowMaskMaker
{
public:
  /// What a user has chosen. `Tuning` is the pass's own.
  struct Settings
  {
    vtkShadowMode Mode;
    const vtkShadowTuning& Tuning;
    vtkShadowPicture Picture;
    const vtkLight* PictureLight; ///< The light of the picture; nullptr means the first one.
  };

  /// What a frame brings along.
  struct Frame
  {
    vtkRenderer* Renderer;
    const std::vector<vtkShadowLightSource>& Lights;
    const vtkShadowCasterList& Casters;
    vtkShadowTimers& Timers;         ///< Measures the stage Draw.
    vtkShadowDebugView& DebugView;   ///< Its image is made; the caller shows it.
    vtkShadowStatistics& Statistics; ///< The counts and times of the masks are added to these.
  };

  /**
   * Room for the masks of so many lights in the viewport that is set now, with the samples of the
   * framebuffer that is bound for drawing, or with one (vtkShadowTarget::HasRefusedSamples(), the
   * cause in GetError()). Returns false, with the cause in GetError(), if OpenGL refuses.
   */
  bool Reserve(vtkRenderer* renderer, std::size_t lights);

  /**
   * After Reserve(): bind a framebuffer for the depth of what is drawn next, and clear it. The
   * caller pops the framebuffer bindings of the window's vtkOpenGLState.
   */
  void BeginDepth(vtkRenderer* renderer);

  /**
   * Make the masks. Returns false on failure, with the cause in GetError(). Afterwards
   * GetNumberOfShadows() is the number of lights for which a volume was drawn.
   */
  bool Make(const Frame& frame, const Settings& settings);

  /**
   * Read back the mask of a light, by its number among the lights of the frame: one value for each
   * pixel of the viewport, row by row, the lowest first, 0 lit to 255 in shadow. Of a sample, or,
   * if it is negative, the mean of all. Returns false, with the cause in GetError(), if OpenGL
   * refuses.
   */
  bool ReadMask(
    vtkOpenGLRenderWindow* window, std::size_t slot, int sample, std::vector<unsigned char>& mask);

  int GetNumberOfShadows() const { return this->Shadows; }
  const vtkShadowTarget& GetTarget() const { return this->Target; }
  const int* GetViewport() const { return this->Viewport; }
  const std::string& GetError() const { return this->Error; }

  /// Delete the OpenGL objects; the context that made them must be current.
  void Release();

private:
  struct Work;
  struct CasterPart
  {
    const std::vector<glm::dvec3>& GetPoints() const
    {
      return vtkShadowCaster::GetPoints(*this->Caster, *this->Part);
    }

    const vtkShadowCaster* Caster;
    const vtkShadowCaster::Part* Part;
  };
  using Verdicts = std::array<int, vtkShadowStatistics::NumberOfVerdicts>;

  std::size_t GetNumberOfSamples() const; ///< Of the viewport.
  bool ReadReceivers(const Work& work);
  bool MakeLitmaps(const Work& work, const std::vector<vtkShadowLightSpace>& frames);
  void FindParts(const Work& work);
  void Decide(const vtkShadowPlan& plan);
  Verdicts AddCasters(const Work& work, vtkShadowPlan& plan);
  bool IsLitmapWorthIt(const Work& work, double fragments, long long triangles);
  bool IsLitmapWorthIt(const Work& work); ///< For the triangles alone.
  long long CountSeen(const Work& work);
  void SetSeen(std::size_t seen, std::size_t samples);
  bool Shade(const Work& work);
  bool Count(const Work& work, const vtkShadowPlan& plan);

  vtkShadowTarget Target;
  vtkShadowCounter Counter;
  std::shared_ptr<vtkShadowLitmapSource> LitmapSource; ///< The one whose objects are to release.
  vtkShadowTargetReader Reader;
  std::vector<vtkShadowLitmap> Litmaps; ///< Of the light at work: one, or one for each face.
  vtkShadowVolume Volume;
  // Of all casters in their order, for the light at work.
  std::vector<const std::vector<vtkShadowCaster::Part>*> PartLists;
  std::vector<CasterPart> Parts;
  std::vector<vtkShadowPlan::Choice> Choices; ///< About the parts.
  double CoveredFraction = 1.0;               ///< Of the samples, when their depth was last read.
  std::size_t SeenSamples = 0;                ///< How many there were then,
  int CoveredAge = 0;                         ///< and how many frames ago that was.
  int Viewport[4] = { 0, 0, 0, 0 };
  int Shadows = 0;
  std::string Error;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowMaskMaker.h
