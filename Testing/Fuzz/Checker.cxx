// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checker.h"

#include "GLErrors.h"
#include "GLStateSnapshot.h"
#include "Judge.h"
#include "Messages.h"

#include "vtkCamera.h"
#include "vtkNBufferGL.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <array>

namespace TestScene
{
namespace
{
/// Comparing the state asks OpenGL some thousand questions.
constexpr int FramesPerStateCheck = 4;

/// The largest difference of a colour (0 to 255) that rounding it twice may make, as seen.
constexpr int ForcedTolerance = 2;

/// What differs between two contexts although nothing is wrong: names of objects, which each
/// context gives out anew, what the prop drawn last leaves behind, and what the translucent stage
/// does, which VTK leaves out where all translucent props are outside.
bool IsComparable(const std::string& name)
{
  static const std::array<const char*, 12> excluded = { "BINDING", "CURRENT_PROGRAM",
    "LastShaderBound", "BUFFER", "GL_LINE_WIDTH", "GL_POINT_SIZE", "GL_CULL_FACE",
    "GL_POLYGON_MODE", "GL_ACTIVE_TEXTURE", "GL_BLEND_", "GL_COLOR_CLEAR_VALUE",
    "GL_DEPTH_WRITEMASK" };
  return std::none_of(excluded.begin(), excluded.end(),
    [&name](const char* part) { return name.find(part) != std::string::npos; });
}

/// Whether the last frame was that of an eye, by whose frustum VTK may cull the next one as well.
bool HasCameraOfAnEye(const Player& player)
{
  for (int i = 0; i < player.GetNumberOfRenderers(); ++i)
  {
    if (player.GetRenderer(i)->GetActiveCamera()->GetStereo())
    {
      return true;
    }
  }
  return false;
}

/// Whether a shadow pass used the mask of an earlier frame in the last one.
bool ReusesShadowMask(const Player& player)
{
  for (int i = 0; i < player.GetNumberOfRenderers(); ++i)
  {
    vtkShadowVolumeClampPass* pass = player.GetLights().GetPass(i);
    if (pass && pass->GetStatistics().Decision == vtkShadowDecision::Still)
    {
      return true;
    }
  }
  return false;
}

/// What vtkOpenGLState takes for the state although it is not, by name.
std::map<std::string, std::string> FindMisremembered(const GLStateSnapshot& snapshot)
{
  const std::string prefix = "vtkOpenGLState ";
  std::map<std::string, std::string> result;
  for (const auto& [name, value] : snapshot.GetValues())
  {
    const auto truth = name.compare(0, prefix.size(), prefix) == 0
      ? snapshot.GetValues().find(name.substr(prefix.size()))
      : snapshot.GetValues().end();
    // Booleans are "on" and "off" on one side, 1 and 0 on the other, where a query is an integer.
    if (truth == snapshot.GetValues().end() || truth->second == value ||
      (truth->second == (value == "on" ? "1" : "0") && (value == "on" || value == "off")))
    {
      continue;
    }
    result[name] = truth->second + ", remembered as " + value;
  }
  return result;
}

std::string CompareStates(const GLStateSnapshot& reference, const GLStateSnapshot& tested)
{
  std::string difference;
  for (const auto& [name, value] : reference.GetValues())
  {
    const auto found = tested.GetValues().find(name);
    if (IsComparable(name) && found != tested.GetValues().end() && found->second != value)
    {
      difference += name + ": " + value + " without the culler, " + found->second + " with it\n";
    }
  }
  const auto known = FindMisremembered(reference);
  for (const auto& [name, value] : FindMisremembered(tested))
  {
    if (known.find(name) == known.end())
    {
      difference += name + ": " + value + "\n";
    }
  }
  return difference.empty() ? "" : "The OpenGL state differs:\n" + difference;
}
}

//------------------------------------------------------------------------------------------------
/// What came with a frame.
struct Checker::Drawn
{
  FrameErrors Errors;
  GLStateSnapshot State; ///< If it was asked for.
};

Checker::Drawn Checker::Draw(Player& stage, ShadowPasses passes, bool captureState)
{
  Drawn drawn;
  stage.UsePasses(passes);
  drawn.Errors = RenderFrame(stage);
  if (captureState)
  {
    drawn.State = GLStateSnapshot::Capture(vtkOpenGLRenderWindow::SafeDownCast(stage.Window));
    TakeGLErrors();
  }
  return drawn;
}

Checker::Checker(Role tested, Role reference)
  : IsJudging(tested == Role::Culled)
  , Reference(reference)
  , Tested(tested)
{
  TakeMessages();
}

Outcome Checker::Run(const Scenario& scenario, bool freshWindows, Tally* tally)
{
  if (freshWindows)
  {
    this->Reference.DropWindow();
    this->Tested.DropWindow();
  }
  TakeMessages();
  this->Reference.Begin(scenario);
  this->Tested.Begin(scenario);
  const Outcome outcome = this->RunFrames(scenario, tally);
  this->Reference.End();
  this->Tested.End();
  if (outcome.HasFailed())
  {
    // What went wrong may have left its traces.
    this->Reference.DropWindow();
    this->Tested.DropWindow();
  }
  return outcome;
}

Outcome Checker::RunFrames(const Scenario& scenario, Tally* tally)
{
  Outcome outcome;
  for (int frame = 0; frame < scenario.Frames; ++frame)
  {
    this->GLErrors = 0;
    const std::string failure = this->CheckFrame(scenario, frame);
    if (tally)
    {
      this->Count(scenario, *tally);
      tally->Shadows = this->Shadows;
    }
    if (this->AfterFrame)
    {
      this->AfterFrame(this->Reference, this->Tested, frame, failure);
    }
    if (!failure.empty())
    {
      outcome.Frame = frame;
      outcome.Failure = failure;
      break;
    }
  }
  if (tally)
  {
    ++tally->Scenarios;
  }
  return outcome;
}

std::string Checker::CheckFrame(const Scenario& scenario, int frame)
{
  const std::string expected = this->Reference.Prepare(frame);
  std::string messages = TakeMessages();
  const std::string found = this->Tested.Prepare(frame);
  this->HasSelected = !found.empty();
  std::string testedMessages = TakeMessages();
  if (found != expected)
  {
    return "Selected: " + expected + "without the culler, " + found + "with it\n";
  }

  // What VTK itself does wrong is not ours.
  const bool checkState = frame % FramesPerStateCheck == 1;
  const LightRig& lights = this->Reference.GetLights();
  const bool shadows = lights.HasShadows();
  const Drawn alone =
    Draw(this->Reference, shadows ? ShadowPasses::Absent : ShadowPasses::Lasting, checkState);
  messages += alone.Errors.VTK;
  this->IsUndefined = alone.Errors.IsPending;
  this->HasReferenceFault = !alone.Errors.GL.empty() || !messages.empty();
  const auto judge = [&](const Drawn& drawn, const std::string& before)
  {
    std::string failure;
    if (!drawn.Errors.GL.empty() && alone.Errors.GL.empty())
    {
      ++this->GLErrors;
      failure += drawn.Errors.GL;
    }
    // That the culler steps aside on this device is right.
    const bool stepsAside = drawn.Errors.VTK.find("(softpipe)") != std::string::npos;
    if (!(before + drawn.Errors.VTK).empty() && messages.empty() && !stepsAside)
    {
      failure += "VTK reports: " + before + drawn.Errors.VTK;
    }
    return failure;
  };

  std::string failure;
  ShadowPasses last = ShadowPasses::Lasting;
  if (shadows)
  {
    last =
      lights.GetMode() == ShadowMode::Clamped ? ShadowPasses::Fresh : ShadowPasses::FreshUnclamped;
    failure += this->DrawReferenceShadows(scenario, frame, judge);
  }
  const bool stereo = this->Reference.Window->GetStereoRender() != 0;
  const ShadowPasses passes = this->IsJudging ? ShadowPasses::Lasting : last;
  if (shadows && (stereo || HasCameraOfAnEye(this->Tested)))
  {
    // The reference has been drawn before: see DrawReferenceShadows(). VTK's first frame after
    // stereo is not the second one either, because VTK drops props by the camera's old frustum.
    Draw(this->Tested, passes, false);
  }
  const Drawn tested = Draw(this->Tested, passes, checkState);
  failure += judge(tested, testedMessages);
  bool strays = false;
  if (shadows && this->IsJudging)
  {
    failure += this->CheckShadows(strays);
  }
  if (!this->IsUndefined && !strays)
  {
    const bool withDepth = this->Reference.Window->GetMultiSamples() <= 1 && !stereo;
    const Picture expected = TakePicture(this->Reference.Window, withDepth);
    const Picture actual = TakePicture(this->Tested.Window, withDepth);
    // Where reading rounds colours: a culler that has been forced to read depth, and a shadow mask
    // that is used again, while the reference draws its mask into another framebuffer.
    const bool roundsTwice = !vtkNBufferGL::KeepsColorsWhenRead() &&
      (scenario.Culler.Backend != vtkNBufferCuller::Auto || ReusesShadowMask(this->Tested));
    const std::string difference =
      FindDifference(expected, actual, nullptr, roundsTwice ? ForcedTolerance : 0);
    failure +=
      shadows && !difference.empty() && this->HasUnreadStrays(expected, actual) ? "" : difference;
    for (Player* stage : { &this->Reference, &this->Tested })
    {
      // VTK makes errors while it reads.
      stage->MakeCurrent();
      TakeGLErrors();
    }
  }
  failure += FindInconsistency(this->Tested);
  vtkNBufferCuller* culler = this->Tested.GetCuller();
  // The statistics are those of one eye; shadows, shadow maps and selections draw what and as often
  // as they like.
  if (!stereo && !shadows && scenario.Renderers.size() == 1 && culler &&
    culler->GetStatistics(this->Tested.GetRenderer()).Decision <= vtkNBufferDecision::BackedOff)
  {
    const bool onlyOurs = scenario.Culler.DefaultCuller == DefaultCuller::Removed;
    failure += FindWrongDraws(
      this->Reference, this->Tested, onlyOurs ? MustBeDrawn::NotCulled : MustBeDrawn::None, false);
  }
  if (checkState)
  {
    failure += CompareStates(alone.State, tested.State);
  }
  if (shadows && !failure.empty())
  {
    failure += "Shadows of the reference:\n" + GetShadowStatistics(this->Reference) +
      "and of what is tested:\n" + GetShadowStatistics(this->Tested);
  }
  TakeMessages();
  return failure;
}

std::string Checker::DrawReferenceShadows(const Scenario& scenario, int frame, const Judge& judge)
{
  std::string failure;
  if (this->Reference.Window->GetStereoRender())
  {
    // VTK's first frame in stereo is not the second one.
    Draw(this->Reference, ShadowPasses::FreshUnclamped, false);
  }
  Drawn drawn = Draw(this->Reference, ShadowPasses::FreshUnclamped, false);
  this->HasMasks = HasReadableReceivers(this->Reference) && !this->IsUndefined;
  if (this->IsJudging)
  {
    failure += judge(drawn, "") + CheckShadowStatistics(this->Reference);
    if (this->HasMasks)
    {
      this->Unclamped = CaptureShadows(this->Reference);
      if (scenario.Shadows.CompareRays && frame == scenario.Frames - 1)
      {
        failure += CompareWithRays(this->Reference, this->Unclamped, this->Shadows);
      }
    }
  }
  if (this->Reference.GetLights().GetMode() == ShadowMode::Clamped)
  {
    drawn = Draw(this->Reference, ShadowPasses::Fresh, false);
    if (this->IsJudging)
    {
      failure += judge(drawn, "") + CheckShadowStatistics(this->Reference);
    }
  }
  return failure;
}

std::string Checker::CheckShadows(bool& strays)
{
  std::string failure =
    CheckShadowStatistics(this->Tested) + CompareShadowStatistics(this->Reference, this->Tested);
  if (this->HasMasks)
  {
    const ShadowFrame tested = CaptureShadows(this->Tested);
    const ShadowMode mode = this->Tested.GetLights().GetMode();
    std::string masks;
    std::optional<ShadowStrays> found;
    try
    {
      const RayJudge judge = MakeRayJudge(this->Tested);
      masks = CompareMasks(this->Unclamped, tested, mode, this->Shadows, judge);
      if (!masks.empty() && mode != ShadowMode::Clamped)
      {
        found = FindStrays(
          this->Unclamped, tested, judge, CountsInPortions(this->Reference, this->Tested));
      }
    }
    catch (const std::invalid_argument& error)
    {
      masks +=
        std::string("Masks differ, and rays cannot say which is right. ") + error.what() + "\n";
    }
    if (found)
    {
      this->Shadows.Strays += found->Seen;
      this->Shadows.UnseenStrays += found->Unseen;
      this->Shadows.StraysInPortions += found->InPortions;
    }
    strays = found && found->Seen + found->InPortions > 0;
    failure += found ? "" : masks;
  }
  return failure;
}

bool Checker::HasUnreadStrays(const Picture& expected, const Picture& actual)
{
  if (!this->IsJudging || this->HasMasks)
  {
    return false;
  }
  long long differing = 0;
  for (std::size_t i = 0; i < std::min(expected.Colors.size(), actual.Colors.size()); i += 4)
  {
    differing += !std::equal(&expected.Colors[i], &expected.Colors[i] + 4, &actual.Colors[i]);
  }
  if (differing > MaximumFlipsElsewhere)
  {
    return false;
  }
  Draw(this->Reference, ShadowPasses::Fresh, false);
  const Picture fresh = TakePicture(this->Reference.Window, !expected.Depths.empty());
  const bool same = FindDifference(fresh, actual).empty();
  this->Shadows.Strays += same ? differing : 0;
  return same;
}

void Checker::CountShadows(Tally& tally) const
{
  const LightRig& lights = this->Tested.GetLights();
  bool drawn = false;
  for (int i = 0; i < this->Tested.GetNumberOfRenderers(); ++i)
  {
    if (vtkShadowVolumeClampPass* pass = lights.GetPass(i))
    {
      const vtkShadowStatistics& statistics = pass->GetStatistics();
      ++tally.ShadowDecisions[vtkShadowStatistics::GetName(statistics.Decision)];
      for (int verdict = 0; verdict < vtkShadowStatistics::NumberOfVerdicts; ++verdict)
      {
        tally
          .ShadowVerdicts[vtkShadowStatistics::GetName(static_cast<vtkShadowVerdict>(verdict))] +=
          statistics.Verdicts[verdict];
      }
      drawn = true;
    }
  }
  if (drawn)
  {
    ++tally.ShadowFrames;
    ++tally.Features[std::string("shadows ") +
      EnumNames<ShadowMode>::Get()[static_cast<int>(lights.GetMode())]];
    tally.Features["shadows with caster keys"] += lights.HasCasterKeys();
    tally.Features["shadows with multisampling"] += this->Tested.Window->GetMultiSamples() > 1;
  }
}

void Checker::Count(const Scenario& scenario, Tally& tally) const
{
  ++tally.Frames;
  tally.GLErrors += this->GLErrors;
  tally.Undefined += this->IsUndefined;
  tally.ReferenceFaults += this->HasReferenceFault;
  ++tally.Features["family " + scenario.Family];
  bool hidden = false;
  for (int i = 0; i < this->Tested.GetNumberOfRenderers(); ++i)
  {
    vtkNBufferCuller* culler = this->Tested.GetCuller(i);
    if (!culler)
    {
      ++tally.Features["without culler"];
      continue;
    }
    const vtkNBufferStatistics& statistics = culler->GetStatistics(this->Tested.GetRenderer(i));
    ++tally.Decisions[vtkNBufferStatistics::GetName(statistics.Decision)];
    for (int verdict = 0; verdict < vtkNBufferStatistics::NumberOfVerdicts; ++verdict)
    {
      if (statistics.Verdicts[verdict] > 0)
      {
        tally.Verdicts[vtkNBufferStatistics::GetName(static_cast<vtkNBufferVerdict>(verdict))] +=
          statistics.Verdicts[verdict];
      }
    }
    const int hiddenProps = statistics.GetCount(vtkNBufferVerdict::Hidden);
    tally.Props += statistics.Props;
    tally.Tested += statistics.Tested;
    tally.HeldBack += statistics.HeldBack;
    tally.Hidden += hiddenProps;
    tally.Redrawn += statistics.Redrawn;
    hidden = hidden || hiddenProps > 0;
    if (statistics.Decision == vtkNBufferDecision::Culled)
    {
      ++tally.Features[culler->GetBackendInUse() == vtkNBufferCuller::OpenGL ? "culled by OpenGL"
                                                                             : "culled by CPU"];
      tally.Features["culled in several rounds"] += statistics.Rounds > 1;
      tally.Features["culled over a hierarchy"] += statistics.Nodes > 0;
      tally.Features["culled by units"] += statistics.UnitsHidden > 0;
      tally.Features["units tested on the device"] += statistics.UnitsOnDevice > 0;
      tally.Features["fresh units"] += statistics.FreshDraws > 0;
    }
  }
  tally.FramesWithHidden += hidden;
  this->CountShadows(tally);
  vtkRenderWindow* window = this->Tested.Window;
  tally.Features["multisampled"] += window->GetMultiSamples() > 1;
  tally.Features["multisampled or with a selection"] +=
    window->GetMultiSamples() > 1 || this->HasSelected;
  tally.Features["stereo"] += window->GetStereoRender() != 0;
  tally.Features["several renderers"] += this->Tested.GetNumberOfRenderers() > 1;
  tally.Features["stencil"] += window->GetStencilCapable() != 0;
  for (const Renderer& renderer : scenario.Renderers)
  {
    ++tally.Features[std::string("pass ") +
      EnumNames<PassKind>::Get()[static_cast<int>(renderer.Pass)]];
    tally.Features["SSAO"] += renderer.SSAO;
    tally.Features["FXAA"] += renderer.FXAA;
    tally.Features["depth peeling"] += renderer.DepthPeeling;
    tally.Features["layers"] += renderer.Layer > 0;
    tally.Features["hidden lines"] += renderer.HiddenLines;
    tally.Features["shadows"] += renderer.Shadows;
  }
}
}
