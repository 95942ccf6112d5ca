// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowCheck.h"

#include "StatisticsCheck.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace TestScene
{
namespace
{

/// Where single precision may see a sample on the other side of the cone. In radians.
constexpr double ConeMargin = 2e-4;

bool Casts(const Player& stage, int number)
{
  vtkLight* light = stage.GetLights().GetLight(0, number);
  return light->GetSwitch() && !light->LightTypeIsHeadlight() && light->GetIntensity() > 0.0 &&
    stage.GetLights().GetPass(0)->GetLightCasts(light);
}

/// The passes with shadows of all renderers.
std::vector<vtkShadowVolumeClampPass*> GetPasses(const Player& stage)
{
  std::vector<vtkShadowVolumeClampPass*> passes;
  for (int i = 0; i < stage.GetNumberOfRenderers(); ++i)
  {
    if (vtkShadowVolumeClampPass* pass = stage.GetLights().GetPass(i))
    {
      passes.push_back(pass);
    }
  }
  return passes;
}

/// Surely in the cone, if there is one.
bool IsReached(const OracleLight& light, const glm::dvec3& point)
{
  if (light.ConeCosine <= -1.0)
  {
    return true;
  }
  const glm::dvec3 ray = glm::normalize(point - glm::make_vec3(light.Position));
  const double cosine = std::clamp(glm::dot(ray, glm::make_vec3(light.Direction)), -1.0, 1.0);
  return std::acos(cosine) < std::acos(light.ConeCosine) - ConeMargin;
}

/// From pixels and depth in [0, 1] to the world.
class Unprojection
{
public:
  Unprojection(vtkRenderer* renderer, int width, int height)
    : Width(width)
    , Height(height)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    vtkNew<vtkMatrix4x4> matrix;
    vtkMatrix4x4::Multiply4x4(
      camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0),
      camera->GetModelViewTransformMatrix(), matrix);
    vtkMatrix4x4::Invert(matrix, this->ClipToWorld);
  }

  glm::dvec3 Apply(int x, int y, double depth) const
  {
    double clip[4] = { (2.0 * x + 1.0) / this->Width - 1.0, (2.0 * y + 1.0) / this->Height - 1.0,
      2.0 * depth - 1.0, 1.0 };
    this->ClipToWorld->MultiplyPoint(clip, clip);
    return glm::make_vec3(clip) / clip[3];
  }

private:
  int Width;
  int Height;
  vtkNew<vtkMatrix4x4> ClipToWorld;
};

/// Whether the 3 x 3 pixels around a pixel have both values.
bool IsAtShadowEdge(const ShadowFrame& frame, const std::vector<unsigned char>& mask, int x, int y)
{
  const unsigned char value = mask[static_cast<std::size_t>(y) * frame.Width + x];
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, frame.Height - 1); ++j)
  {
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, frame.Width - 1); ++i)
    {
      if (mask[static_cast<std::size_t>(j) * frame.Width + i] != value)
      {
        return true;
      }
    }
  }
  return false;
}

/// Whether the 3 x 3 pixels around a pixel lie in no plane, or beyond the image. Depth is linear in
/// the image over each plane.
bool IsAtSurfaceEdge(const ShadowFrame& frame, int x, int y)
{
  constexpr float rounding = 1e-6f;
  const auto getDepth = [&frame](int i, int j)
  { return frame.Depth[static_cast<std::size_t>(j) * frame.Width + i]; };
  if (x == 0 || y == 0 || x == frame.Width - 1 || y == frame.Height - 1)
  {
    return true;
  }
  for (const auto& [i, j] :
    { std::make_pair(1, 0), std::make_pair(0, 1), std::make_pair(1, 1), std::make_pair(1, -1) })
  {
    const float bend = getDepth(x - i, y - j) - 2.0f * getDepth(x, y) + getDepth(x + i, y + j);
    if (std::abs(bend) > rounding)
    {
      return true;
    }
  }
  return false;
}

/// Whether the surface through a pixel and its neighbours turns the same side to eye and light;
/// true where there are no neighbours.
bool FacesLight(const ShadowFrame& frame, const Unprojection& unprojection,
  const OracleLight& light, const glm::dvec3& eye, int x, int y)
{
  if (x == 0 || y == 0 || x == frame.Width - 1 || y == frame.Height - 1)
  {
    return true;
  }
  const auto unproject = [&](int i, int j)
  { return unprojection.Apply(i, j, frame.Depth[static_cast<std::size_t>(j) * frame.Width + i]); };
  const glm::dvec3 across = unproject(x + 1, y) - unproject(x - 1, y);
  const glm::dvec3 up = unproject(x, y + 1) - unproject(x, y - 1);
  const glm::dvec3 normal = glm::normalize(glm::cross(across, up));
  const glm::dvec3 point = unproject(x, y);
  const glm::dvec3 toLight = light.Positional
    ? glm::normalize(glm::make_vec3(light.Position) - point)
    : -glm::make_vec3(light.Direction);
  constexpr double grazing = 0.01;
  const double side = glm::dot(normal, eye - point) > 0.0 ? 1.0 : -1.0;
  return side * glm::dot(normal, toLight) > grazing;
}

std::string SayWhere(const char* what, int light, long long count, long long first, int width)
{
  std::ostringstream text;
  text << what << " in " << count << " samples of light " << light << ", first in ("
       << first % width << ", " << first / width << ")\n";
  return text.str();
}
}

bool HasReadableReceivers(const Player& stage)
{
  vtkRenderWindow* window = stage.Window;
  const std::vector<Prop>& props = stage.GetScenario()->Props;
  const bool onlySurfaces = std::none_of(props.begin(), props.end(),
    [](const Prop& prop)
    {
      return prop.Kind == PropKind::Text || prop.Kind == PropKind::Billboard ||
        prop.Kind == PropKind::Volume || prop.Kind == PropKind::Slice;
    });
  return onlySurfaces && stage.GetNumberOfRenderers() == 1 && stage.GetLights().GetPass(0) &&
    window->GetMultiSamples() <= 1 && !window->GetStereoRender();
}

ShadowFrame CaptureShadows(const Player& stage)
{
  ShadowFrame frame;
  vtkRenderer* renderer = stage.GetRenderer(0);
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&frame.Width, &frame.Height, &origin[0], &origin[1]);
  const std::size_t count = static_cast<std::size_t>(frame.Width) * frame.Height;
  vtkNew<vtkFloatArray> depth;
  stage.Window->GetZbufferData(
    origin[0], origin[1], origin[0] + frame.Width - 1, origin[1] + frame.Height - 1, depth);
  stage.Window->MakeCurrent();
  const bool readable = depth->GetNumberOfValues() == static_cast<vtkIdType>(count);
  frame.Depth.assign(count, 1.0f);
  std::copy_n(depth->GetPointer(0), readable ? count : 0, frame.Depth.begin());
  const Unprojection unprojection(renderer, frame.Width, frame.Height);
  // Of parallel cameras a point far behind it.
  vtkCamera* camera = renderer->GetActiveCamera();
  const double behind = camera->GetParallelProjection() ? 1e6 * camera->GetParallelScale() : 0.0;
  const glm::dvec3 eye = glm::make_vec3(camera->GetPosition()) -
    behind * glm::make_vec3(camera->GetDirectionOfProjection());
  for (int light = 0; light < stage.GetLights().GetNumberOfLights(); ++light)
  {
    const OracleLight geometry(stage.GetLights().GetLight(0, light));
    std::vector<unsigned char> receivers(count, 0);
    std::vector<unsigned char> facing(count, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      const float value = frame.Depth[i];
      if (value < 1.0f)
      {
        const int x = static_cast<int>(i % frame.Width);
        const int y = static_cast<int>(i / frame.Width);
        facing[i] = FacesLight(frame, unprojection, geometry, eye, x, y);
        receivers[i] = IsReached(geometry, unprojection.Apply(x, y, value));
      }
    }
    frame.Receivers.push_back(std::move(receivers));
    frame.Facing.push_back(std::move(facing));
    int size[2];
    std::vector<unsigned char> mask =
      stage.GetLights().GetPass(0)->GetMask(stage.GetLights().GetLight(0, light), size[0], size[1]);
    if (mask.size() != count)
    {
      mask.assign(count, 0);
    }
    frame.Masks.push_back(std::move(mask));
  }
  return frame;
}

long long GetClampedFlips(long long receiversAtEdges)
{
  return 4 + receiversAtEdges / 20;
}

namespace
{
Oracle MakeOracle(const Player& stage)
{
  vtkInformation* keys = stage.GetLights().GetPass(0)->GetCasterKeys();
  return Oracle(
    stage.GetRenderer(0), [keys](vtkProp* prop) { return !keys || prop->HasKeys(keys); });
}

/// Neither lit nor shadowed is what the light does not reach, or what turns away from it.
bool IsJudged(OracleSample sample)
{
  return sample == OracleSample::Lit || sample == OracleSample::Shadowed;
}

bool ContradictsRays(unsigned char mask, OracleSample sample)
{
  return (sample == OracleSample::Lit && mask != 0) ||
    (sample == OracleSample::Shadowed && mask == 0);
}

/// How many of the samples rays neither call ambiguous nor right.
long long CountUnexplained(const ShadowFrame& tested, std::size_t light,
  const std::vector<std::size_t>& samples, const OracleImage& rays)
{
  return std::count_if(samples.begin(), samples.end(),
    [&](std::size_t i)
    {
      return !rays.Ambiguous[i] &&
        (!IsJudged(rays.Samples[i]) || ContradictsRays(tested.Masks[light][i], rays.Samples[i]));
    });
}
}

RayJudge MakeRayJudge(const Player& stage)
{
  return [&stage](int light)
  { return MakeOracle(stage).Cast(OracleLight(stage.GetLights().GetLight(0, light))); };
}

std::string CompareMasks(const ShadowFrame& expected, const ShadowFrame& tested, ShadowMode mode,
  ShadowTally& tally, const RayJudge& judge)
{
  if (expected.Width != tested.Width || expected.Height != tested.Height)
  {
    return "The masks have different sizes.\n";
  }
  std::string failure;
  for (std::size_t light = 0; light < expected.Masks.size(); ++light)
  {
    const std::vector<unsigned char>& mask = expected.Masks[light];
    const bool clamped = mode == ShadowMode::Clamped;
    std::vector<std::size_t> elsewhere;
    std::vector<std::size_t> flips;
    long long edges = 0;
    long long nothing = 0;
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      nothing += expected.Depth[i] >= 1.0f && tested.Masks[light][i] != 0;
      if (!expected.Receivers[light][i])
      {
        continue;
      }
      ++tally.Samples;
      tally.Shadowed += mask[i] != 0;
      const int x = static_cast<int>(i % expected.Width);
      const int y = static_cast<int>(i / expected.Width);
      const bool atEdge = clamped && IsAtShadowEdge(expected, mask, x, y);
      edges += atEdge;
      if (tested.Masks[light][i] == mask[i] || (clamped && !expected.Facing[light][i]))
      {
        continue;
      }
      const bool atSurfaceEdge = clamped && IsAtSurfaceEdge(expected, x, y);
      if (atEdge || atSurfaceEdge)
      {
        if (!atSurfaceEdge)
        {
          flips.push_back(i);
        }
        ++tally.ClampedFlips;
        continue;
      }
      elsewhere.push_back(i);
    }
    failure += nothing > 0
      ? "The mask has shadow where nothing is seen, in " + std::to_string(nothing) + " samples\n"
      : "";
    // Of more samples than are granted, those that rays do not explain.
    const auto count = [&](const std::vector<std::size_t>& samples, long long granted)
    {
      const auto all = static_cast<long long>(samples.size());
      return all > granted && clamped
        ? CountUnexplained(tested, light, samples, judge(static_cast<int>(light)))
        : all;
    };
    tally.ClampedFlipsElsewhere += clamped ? static_cast<long long>(elsewhere.size()) : 0;
    const long long grantedElsewhere = clamped ? MaximumFlipsElsewhere : 0;
    const long long wrong = count(elsewhere, grantedElsewhere);
    if (wrong > grantedElsewhere)
    {
      failure += SayWhere(clamped ? "The clamped mask differs away from edges" : "The mask differs",
        static_cast<int>(light), wrong, static_cast<long long>(elsewhere.front()), expected.Width);
    }
    const long long grantedAtEdges = GetClampedFlips(edges);
    const long long wrongAtEdges = count(flips, grantedAtEdges);
    if (wrongAtEdges > grantedAtEdges)
    {
      failure += "The clamped mask differs at edges in " + std::to_string(wrongAtEdges) + " of " +
        std::to_string(edges) + " samples of light " + std::to_string(light) + "\n";
    }
  }
  return failure;
}

std::optional<ShadowStrays> FindStrays(
  const ShadowFrame& expected, const ShadowFrame& tested, const RayJudge& judge, bool inPortions)
{
  ShadowStrays all;
  for (std::size_t light = 0; light < expected.Masks.size(); ++light)
  {
    std::vector<std::size_t> differing;
    for (std::size_t i = 0; i < expected.Masks[light].size(); ++i)
    {
      if (expected.Receivers[light][i] && expected.Masks[light][i] != tested.Masks[light][i])
      {
        differing.push_back(i);
      }
    }
    if (differing.empty())
    {
      continue;
    }
    const OracleImage rays = judge(static_cast<int>(light));
    if (inPortions)
    {
      const auto end = std::remove_if(
        differing.begin(), differing.end(), [&](std::size_t i) { return rays.Ambiguous[i] != 0; });
      all.InPortions += differing.end() - end;
      differing.erase(end, differing.end());
    }
    const bool contradicts = std::any_of(differing.begin(), differing.end(),
      [&](std::size_t i) { return ContradictsRays(tested.Masks[light][i], rays.Samples[i]); });
    const auto isUnlit = [&](std::size_t i) { return rays.Samples[i] == OracleSample::Unlit; };
    const auto number = static_cast<long long>(differing.size());
    const auto unlit = std::count_if(differing.begin(), differing.end(), isUnlit);
    if (!contradicts && number - unlit <= MaximumFlipsElsewhere)
    {
      all.Seen += number - unlit;
      all.Unseen += unlit;
    }
    else if (std::all_of(differing.begin(), differing.end(),
               [&](std::size_t i) { return rays.Ambiguous[i] || isUnlit(i); }))
    {
      all.Unseen += number;
    }
    else
    {
      return std::nullopt;
    }
  }
  return all;
}

bool CountsInPortions(const Player& expected, const Player& tested)
{
  std::vector<vtkShadowVolumeClampPass*> passes = GetPasses(expected);
  const std::vector<vtkShadowVolumeClampPass*> others = GetPasses(tested);
  passes.insert(passes.end(), others.begin(), others.end());
  return std::any_of(passes.begin(), passes.end(),
    [](vtkShadowVolumeClampPass* pass)
    { return pass->GetStatistics().StencilClears > pass->GetStatistics().Lights; });
}

std::string CompareWithRays(const Player& stage, const ShadowFrame& frame, ShadowTally& tally)
{
  const Oracle oracle = MakeOracle(stage);
  std::string failure;
  for (int light = 0; light < stage.GetLights().GetNumberOfLights(); ++light)
  {
    if (!Casts(stage, light))
    {
      continue;
    }
    const OracleImage expected = oracle.Cast(OracleLight(stage.GetLights().GetLight(0, light)));
    long long wrong = 0;
    long long first = -1;
    for (std::size_t i = 0; i < expected.Samples.size(); ++i)
    {
      const bool contradicts = ContradictsRays(frame.Masks[light][i], expected.Samples[i]);
      tally.Rays += IsJudged(expected.Samples[i]);
      tally.RaysAmbiguous += contradicts && expected.Ambiguous[i];
      const bool isWrong = contradicts && !expected.Ambiguous[i];
      first = isWrong && wrong == 0 ? static_cast<long long>(i) : first;
      wrong += isWrong;
    }
    tally.Strays += wrong;
    if (wrong > MaximumFlipsElsewhere)
    {
      failure += SayWhere("The mask contradicts rays", light, wrong, first, frame.Width);
    }
  }
  return failure;
}

std::string CheckShadowStatistics(const Player& stage)
{
  std::string failure;
  for (vtkShadowVolumeClampPass* pass : GetPasses(stage))
  {
    const vtkShadowStatistics& statistics = pass->GetStatistics();
    failure += FindInconsistency(statistics);
    const bool failed = statistics.Decision == vtkShadowDecision::Failed;
    failure += failed ? "The pass failed: " + statistics.GetAsJSON() + "\n" : "";
  }
  return failure;
}

std::string GetShadowStatistics(const Player& stage)
{
  std::string text;
  for (vtkShadowVolumeClampPass* pass : GetPasses(stage))
  {
    text += pass->GetStatistics().GetAsJSON() + "\n";
  }
  return text;
}

std::string CompareShadowStatistics(const Player& expected, const Player& tested)
{
  // A pass has the statistics of the renderer that it drew last.
  vtkShadowVolumeClampPass* passes[2] = { expected.GetLights().GetPass(0),
    tested.GetLights().GetPass(0) };
  if (expected.GetNumberOfRenderers() > 1 || !passes[0] || !passes[1])
  {
    return "";
  }
  const vtkShadowStatistics& a = passes[0]->GetStatistics();
  const vtkShadowStatistics& b = passes[1]->GetStatistics();
  return a.Lights == b.Lights && a.Casters == b.Casters && a.Skipped == b.Skipped
    ? ""
    : "Lights or casters differ:\n" + a.GetAsJSON() + "\n" + b.GetAsJSON() + "\n";
}
}
