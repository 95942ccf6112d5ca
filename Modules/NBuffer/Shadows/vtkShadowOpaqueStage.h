// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowOpaqueStage
 * @brief Draws the opaque props of a frame with their shadows: what vtkShadowVolumeClampPass does.
 *
 *     lights and casters of the renderer
 *        |   none: the props are drawn as without the pass, and OpenGL is not called
 *     depth of the receivers: the opaque props, drawn into a vtkShadowTarget
 *        |
 *     masks (vtkShadowMaskMaker), or those of the last frame if nothing has changed
 *        |   no volume is drawn, or a call fails: the props are drawn as without the pass
 *     the opaque props, with the masks (vtkShadowShading)
 *        |
 *     debug view, if there is one
 */
#ifndef vtkShadowOpaqueStage_h
#define vtkShadowOpaqueStage_h

#include "vtkNBufferResourceCallback.h"
#include "vtkShadowCasterList.h"
#include "vtkShadowDebugView.h"
#include "vtkShadowFrameKey.h"
#include "vtkShadowMaskMaker.h"
#include "vtkShadowShading.h"
#include "vtkShadowStatistics.h"
#include "vtkShadowTimers.h"

#include "vtkNew.h"
#include "vtkOpaquePass.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
class vtkLight;
class vtkOpenGLRenderPass;
class vtkOpenGLRenderWindow;
class vtkRenderState;
class vtkWindow;

class vtkShadowOpaqueStage
{
public:
  /// The settings of the pass for one frame.
  struct Settings
  {
    vtkShadowMaskMaker::Settings Masks;
    vtkInformation* CasterKeys; ///< nullptr lets all props cast.
    std::function<bool(vtkLight*)> DoesLightCast;
    vtkMTimeType Time; ///< The time of the last change of any setting.
  };

  /// `pass` is the pass that mappers call back and that warnings are reported for.
  explicit vtkShadowOpaqueStage(vtkOpenGLRenderPass* pass);
  ~vtkShadowOpaqueStage();
  vtkShadowOpaqueStage(const vtkShadowOpaqueStage&) = delete;
  void operator=(const vtkShadowOpaqueStage&) = delete;

  /// Draws the opaque props of the state. Returns how many props were drawn.
  int Render(const vtkRenderState* state, const Settings& settings);

  /// The statistics of the last frame.
  const vtkShadowStatistics& GetStatistics() const { return this->Statistics; }
  vtkShadowShading& GetShading() { return this->Shading; }
  const vtkShadowTarget& GetTarget() { return this->Masks.GetTarget(); }

  /// See vtkShadowVolumeClampPass::GetMask(). If an OpenGL call fails, `why` receives the cause.
  std::vector<unsigned char> ReadMask(
    vtkLight* light, int sample, int& width, int& height, std::string& why);

  /// The debug view of the last frame, or nullptr if there was none.
  const vtkShadowDebugView* GetDebugView() const;

  /// Deletes the OpenGL objects that belong to a window; nullptr means any window.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  using Callback = vtkOpenGLResourceFreeCallback<vtkShadowOpaqueStage>;

  void UseContext(vtkOpenGLRenderWindow* window);
  void ReleaseObjects(vtkWindow* window);
  bool MakeMasks(const vtkRenderState* state, const Settings& settings,
    const std::vector<vtkShadowLightSource>& lights);
  void Draw(const vtkRenderState* state, vtkShadowShading::Purpose purpose);
  int DrawPlain(const vtkRenderState* state, vtkShadowDecision decision);
  void JoinProps(const vtkRenderState* state);
  void LeaveProps(const vtkRenderState* state);
  void WarnOnce(bool& hasWarned, const std::string& what);

  vtkOpenGLRenderPass* Pass;
  vtkNew<vtkOpaquePass> Opaque;
  vtkShadowCasterList Casters; ///< The casters of the renderer, visible to the camera or not.
  vtkShadowMaskMaker Masks;
  vtkShadowShading Shading;
  vtkShadowTimers Timers;
  vtkShadowDebugView DebugView;
  vtkShadowFrameKey Key; ///< The key of the frame that the masks belong to.
  vtkShadowStatistics Statistics;
  bool HasWarned = false;
  bool HasWarnedOfDebugView = false;
  bool HasWarnedOfSamples = false;
  vtkOpenGLRenderWindow* Window = nullptr; ///< The window that the OpenGL objects belong to.
  std::unique_ptr<Callback> ResourceCallback;
};

VTK_ABI_NAMESPACE_END
#endif
