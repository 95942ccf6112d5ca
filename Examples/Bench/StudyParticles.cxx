// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"

#include "ParticleCloud.h"

#include "vtkNBufferCamera.h"
#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"
#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"

#include <cmath>
#include <numeric>
#include <random>

namespace NBufferBench
{
namespace
{
using NBufferPeers::ParticleCloud;
using NBufferPeers::ParticleCulling;

constexpr double Nearest = 1.0; // distances of particles from the eye, in metres
constexpr double Farthest = 200.0;
constexpr float BoxSide = 1.0f;

/// Returns places all over the picture, and at all distances.
std::vector<glm::vec3> MakeParticles(const glm::dmat4& eyeToClip, int count)
{
  const glm::dmat4 clipToEye = vtkNBufferGLM::Invert(eyeToClip);
  std::mt19937 random(5);
  const auto choose = [&random](double low, double high)
  { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
  std::vector<glm::vec3> particles;
  for (int i = 0; i < count; ++i)
  {
    const double x = choose(-1.0, 1.0);
    const double y = choose(-1.0, 1.0);
    const glm::dvec4 place = vtkNBufferGLM::Multiply(clipToEye, { x, y, 0.0, 1.0 });
    const glm::dvec3 direction = glm::normalize(glm::dvec3(place) / place.w);
    particles.emplace_back(choose(Nearest, Farthest) * direction);
  }
  return particles;
}

/// Returns the milliseconds of all draws with a kind of culling, and of building what it needs.
void MeasureTimes(vtkOpenGLRenderWindow* window, ParticleCloud& cloud, const glm::dmat4& eyeToClip,
  int repetitions, Json::Value& entry)
{
  const std::string names[] = { "none", "maxima", "minima_first" };
  const Json::Value times = Repeat(repetitions,
    [&](NamedTimes& result)
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto culling = static_cast<ParticleCulling>(k);
        window->WaitForCompletion();
        vtkNBufferClock clock;
        if (culling != ParticleCulling::None)
        {
          cloud.Build(window, culling);
        }
        window->WaitForCompletion();
        const double built = clock.Restart();
        cloud.Draw(eyeToClip, culling);
        window->WaitForCompletion();
        const double drawn = clock.GetMilliseconds();
        result["build " + names[k]].push_back(built);
        result["draw " + names[k]].push_back(drawn);
      }
    });
  for (int k = 0; k < 3; ++k)
  {
    entry["draw_ms"][names[k]] = times["draw " + names[k]];
    if (k > 0)
    {
      entry["build_ms"][names[k]] = times["build " + names[k]];
    }
  }
}

/// Returns how many lookups of maxima a particle needs: one for a sprite in the image.
int CountLookups(const ParticleCloud::Finding& finding, bool isOfBoxes, const int size[2])
{
  const vtkNBufferRectangle pixels = finding.Pixels.GetIntersection({ 0, 0, size[0], size[1] });
  return pixels.IsEmpty() ? 0 : isOfBoxes ? vtkNBufferMath::GetCoverOfFour(pixels).Count : 1;
}

void CountParticles(vtkOpenGLRenderWindow* window, ParticleCloud& cloud,
  const glm::dmat4& eyeToClip, bool isOfBoxes, const int size[2], Json::Value& entry)
{
  cloud.Build(window, ParticleCulling::Maxima);
  cloud.Build(window, ParticleCulling::MinimaFirst);
  const std::vector<unsigned int> fragments = cloud.CountFragments(eyeToClip, false);
  const std::vector<unsigned int> passed = cloud.CountFragments(eyeToClip, true);
  const std::vector<ParticleCloud::Finding> found = cloud.Find(eyeToClip, ParticleCulling::Maxima);
  const std::vector<ParticleCloud::Finding> early =
    cloud.Find(eyeToClip, ParticleCulling::MinimaFirst);
  int counts[5] = { 0, 0, 0, 0, 0 };
  int lookups[2] = { 0, 0 };
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const bool isSeen = passed[i] > 0;
    counts[0] += !isSeen;
    counts[1] += found[i].IsHidden;
    counts[2] += early[i].IsAccepted;
    // Culling is wrong if it rejects what is seen; an early accept, if that changes a verdict.
    counts[3] += found[i].IsHidden && isSeen;
    counts[4] += found[i].IsHidden != early[i].IsHidden;
    const int tests = found[i].IsTested ? CountLookups(found[i], isOfBoxes, size) : 0;
    lookups[0] += tests;
    lookups[1] += tests > 0 ? 1 + (early[i].IsAccepted ? 0 : tests) : 0;
  }
  const char* const names[] = { "hidden", "rejected", "accepted", "wrongly_rejected", "changed" };
  for (int i = 0; i < 5; ++i)
  {
    entry[names[i]] = counts[i];
  }
  entry["tests"]["drawn"] = std::accumulate(fragments.begin(), fragments.end(), 0.0);
  entry["tests"]["maxima"] = lookups[0];
  entry["tests"]["minima_first"] = lookups[1];
}
}

Json::Value MeasureParticles(
  Session& session, const NBufferExamples::CameraPose& pose, int most, int repetitions)
{
  Json::Value result(Json::arrayValue);
  RenderAndInspect(session, pose,
    [&](vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source)
    {
      const glm::dmat4 eyeToClip = vtkNBufferCamera(session.GetRenderer()).GetEyeToClip();
      ParticleCloud cloud;
      for (const bool isBefore : { true, false })
      {
        if (!isBefore)
        {
          // Nothing is before the particles. The frame is complete, so that nothing needs its
          // depth.
          const float far = 1.0f;
          GLboolean mask = GL_TRUE;
          glGetBooleanv(GL_DEPTH_WRITEMASK, &mask);
          glDepthMask(GL_TRUE);
          glClearBufferfv(GL_DEPTH, 0, &far);
          glDepthMask(mask);
        }
        for (const float boxSide : { 0.0f, BoxSide })
        {
          for (const int side : { 60, 240 })
          {
            const int count = side * side;
            if (count > most)
            {
              continue;
            }
            ShowProgress("the paper's particles: " + std::to_string(count));
            Json::Value entry;
            entry["kind"] = boxSide > 0.0f ? "boxes" : "sprites";
            entry["occluders"] = isBefore;
            entry["particles"] = count;
            cloud.Set(MakeParticles(eyeToClip, count), boxSide);
            CountParticles(window, cloud, eyeToClip, boxSide > 0.0f, source.Viewport + 2, entry);
            MeasureTimes(window, cloud, eyeToClip, repetitions, entry);
            result.append(entry);
          }
        }
      }
    });
  return result;
}

} // namespace NBufferBench
