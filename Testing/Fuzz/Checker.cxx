// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checker.h"

#include "GLStateSnapshot.h"
#include "Messages.h"
#include "StatisticsCheck.h"
#include "Tune.h"

#include "vtkNBufferVTKVersion.h"
#include VTKNBUFFER_GL_HEADER

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>

namespace NBufferFuzz
{
namespace
{
/// Comparing the state asks OpenGL some thousand questions.
constexpr int FramesPerStateCheck = 4;

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
  unsigned int Error = GL_NO_ERROR;
  std::string Messages;
  GLStateSnapshot State; ///< If it was asked for.
};

Checker::Drawn Checker::Draw(Stage& stage, ShadowPasses passes, bool captureState)
{
  Drawn drawn;
  stage.Render(passes);
  stage.GetWindow()->MakeCurrent();
  drawn.Error = glGetError();
  if (captureState)
  {
    drawn.State = GLStateSnapshot::Capture(vtkOpenGLRenderWindow::SafeDownCast(stage.GetWindow()));
    while (glGetError() != GL_NO_ERROR)
    {
    }
  }
  drawn.Messages = TakeMessages();
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
  std::string testedMessages = TakeMessages();
  if (found != expected)
  {
    return "Selected: " + expected + "without the culler, " + found + "with it\n";
  }

  // What VTK itself does wrong is not ours.
  const bool checkState = frame % FramesPerStateCheck == 1;
  const Lights& lights = this->Reference.GetLights();
  const bool shadows = lights.HasShadows();
  const Drawn alone =
    Draw(this->Reference, shadows ? ShadowPasses::Absent : ShadowPasses::Lasting, checkState);
  messages += alone.Messages;
  this->IsUndefined = alone.Error != GL_NO_ERROR;
  const auto judge = [&](const Drawn& drawn, const std::string& before)
  {
    std::string failure;
    if (drawn.Error != GL_NO_ERROR && !this->IsUndefined)
    {
      ++this->GLErrors;
      std::ostringstream text;
      text << "OpenGL error 0x" << std::hex << drawn.Error << "\n";
      failure += text.str();
    }
    if (!(before + drawn.Messages).empty() && messages.empty())
    {
      failure += "VTK reports: " + before + drawn.Messages;
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
  const bool stereo = this->Reference.GetWindow()->GetStereoRender() != 0;
  const ShadowPasses passes = this->IsJudging ? ShadowPasses::Lasting : last;
  if (shadows && stereo)
  {
    // As the reference: see DrawReferenceShadows().
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
    failure += this->CompareImages(this->Reference.GetWindow()->GetMultiSamples() <= 1 && !stereo);
  }
  failure += this->CheckStatistics();
  // The statistics are those of one eye; shadows draw what and as often as they like.
  if (!stereo && !shadows && scenario.Renderers.size() == 1)
  {
    failure += this->CheckDraws(scenario.Culler.DefaultCuller != DefaultCuller::Removed);
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
  if (this->Reference.GetWindow()->GetStereoRender())
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
    const std::string masks =
      CompareMasks(this->Unclamped, tested, mode, this->Shadows, MakeRayJudge(this->Tested));
    const std::optional<ShadowStrays> found = masks.empty() || mode == ShadowMode::Clamped
      ? std::nullopt
      : FindStrays(this->Tested, this->Unclamped, tested, HasParted(this->Reference, this->Tested));
    if (found)
    {
      this->Shadows.Strays += found->Seen;
      this->Shadows.UnlitStrays += found->Unlit;
      this->Shadows.PartedStrays += found->Parted;
    }
    strays = found && found->Seen + found->Parted > 0;
    failure += found ? "" : masks;
  }
  return failure;
}

std::string Checker::CompareImages(bool compareDepth)
{
  vtkNew<vtkUnsignedCharArray> pixels[2];
  vtkNew<vtkFloatArray> depths[2];
  int sizes[2][2];
  for (Stage* stage : { &this->Reference, &this->Tested })
  {
    const int index = stage == &this->Tested;
    vtkRenderWindow* window = stage->GetWindow();
    std::copy_n(window->GetActualSize(), 2, sizes[index]);
    const int* size = sizes[index];
    window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels[index]);
    if (compareDepth)
    {
      window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths[index]);
    }
    window->MakeCurrent();
    while (glGetError() != GL_NO_ERROR)
    {
    }
  }
  const vtkIdType count = static_cast<vtkIdType>(sizes[0][0]) * sizes[0][1];
  if (!std::equal(sizes[0], sizes[0] + 2, sizes[1]) ||
    pixels[0]->GetNumberOfValues() != 4 * count || pixels[1]->GetNumberOfValues() != 4 * count)
  {
    return "The windows have different sizes.\n";
  }
  std::ostringstream text;
  const auto say = [&](const char* what, vtkIdType differing, vtkIdType first)
  {
    text << what << " differs in " << differing << " of " << count << " pixels, first in ("
         << first % sizes[0][0] << ", " << first / sizes[0][0] << ")\n";
  };
  const auto compare = [&](const char* what, const void* data, const void* other, std::size_t size)
  {
    const auto* a = static_cast<const unsigned char*>(data);
    const auto* b = static_cast<const unsigned char*>(other);
    if (std::memcmp(a, b, size * count) == 0)
    {
      return;
    }
    vtkIdType differing = 0;
    vtkIdType first = -1;
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (std::memcmp(a + size * i, b + size * i, size) != 0)
      {
        ++differing;
        first = first < 0 ? i : first;
      }
    }
    say(what, differing, first);
  };
  compare("The image", pixels[0]->GetPointer(0), pixels[1]->GetPointer(0), 4);
  if (compareDepth && depths[0]->GetNumberOfValues() == count &&
    depths[1]->GetNumberOfValues() == count)
  {
    compare("The depth", depths[0]->GetPointer(0), depths[1]->GetPointer(0), sizeof(float));
  }
  return text.str();
}

std::string Checker::CheckStatistics()
{
  std::string failure;
  for (int i = 0; i < this->Tested.GetNumberOfRenderers(); ++i)
  {
    if (vtkNBufferCuller* culler = this->Tested.GetCuller(i))
    {
      const vtkNBufferStatistics& statistics = culler->GetStatistics(this->Tested.GetRenderer(i));
      const std::string fault =
        FindInconsistency(statistics, culler->GetTuning().MaximumNumberOfRounds);
      if (!fault.empty())
      {
        failure += fault + "\n" + statistics.GetAsJSON() + "\n";
      }
    }
  }
  return failure;
}

std::string Checker::CheckDraws(bool stockCuller)
{
  vtkNBufferCuller* culler = this->Tested.GetCuller(0);
  if (!culler)
  {
    return "";
  }
  const vtkNBufferStatistics& statistics = culler->GetStatistics(this->Tested.GetRenderer(0));
  if (statistics.Decision > vtkNBufferDecision::BackedOff)
  {
    return ""; // shadows and selections draw what and as often as they like
  }
  int extra = 0;
  std::ostringstream wrong;
  for (std::size_t i = 0; i < this->Tested.GetMembers().size(); ++i)
  {
    const Stage::Member& member = this->Tested.GetMembers()[i];
    if (!member.Present || !member.Counted)
    {
      continue;
    }
    const int expected = this->Reference.GetMembers()[i].Draws;
    extra += std::max(member.Draws - expected, 0);
    const vtkNBufferVerdict verdict =
      culler->GetVerdict(member.Object, this->Tested.GetRenderer(0));
    const bool culled =
      verdict == vtkNBufferVerdict::Hidden || verdict == vtkNBufferVerdict::Outside;
    // vtkFrustumCoverageCuller may still remove some of the others.
    if ((culled && member.Draws > 0) || (!culled && !stockCuller && member.Draws < expected))
    {
      wrong << "Prop " << member.Description->Id << " is " << vtkNBufferStatistics::GetName(verdict)
            << " and was drawn " << member.Draws << " times (" << expected
            << " without the culler).\n";
    }
  }
  if (extra > statistics.Redrawn)
  {
    wrong << extra << " draws beyond those without the culler, " << statistics.Redrawn
          << " counted.\n";
  }
  return wrong.str();
}

void Checker::CountShadows(Tally& tally) const
{
  const Lights& lights = this->Tested.GetLights();
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
    tally.Features["shadows with multisampling"] += this->Tested.GetWindow()->GetMultiSamples() > 1;
  }
}

void Checker::Count(const Scenario& scenario, Tally& tally) const
{
  ++tally.Frames;
  tally.GLErrors += this->GLErrors;
  tally.Undefined += this->IsUndefined;
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
    }
  }
  tally.FramesWithHidden += hidden;
  this->CountShadows(tally);
  vtkRenderWindow* window = this->Tested.GetWindow();
  tally.Features["multisampled"] += window->GetMultiSamples() > 1;
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
