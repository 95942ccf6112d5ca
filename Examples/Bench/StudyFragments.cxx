// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mode.h"
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"
#include "VisibleProps.h"

#include "DrawStage.h"

#include "vtkNBufferDepthSource.h"
#include "vtkNBufferGL.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace NBufferBench
{
namespace
{
template <typename Functor>
void ForEachMapper(Session& session, Functor&& functor)
{
  for (vtkProp* prop : session.GetProps())
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (actor && actor->GetMapper())
    {
      functor(actor->GetMapper(), prop);
    }
  }
}

/// The draw of a prop, with colours or for its depth alone.
struct Draw
{
  vtkProp* Prop;
  bool Colors;
};

/// Records the draws, in order, for as long as it lives.
class Recorder
{
public:
  explicit Recorder(Session& session)
  {
    this->Observer->SetClientData(this);
    this->Observer->SetCallback(
      [](vtkObject* mapper, unsigned long, void* self, void*)
      {
        auto* recorder = static_cast<Recorder*>(self);
        GLboolean mask[4] = { GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE };
        glGetBooleanv(GL_COLOR_WRITEMASK, mask);
        recorder->Draws.push_back({ recorder->Props.at(mapper), mask[0] == GL_TRUE });
      });
    const std::string why = GetFragmentsObstacle(session);
    if (!why.empty())
    {
      throw std::runtime_error(why);
    }
    ForEachMapper(session,
      [this](vtkMapper* mapper, vtkProp* prop)
      {
        this->Props.emplace(mapper, prop);
        this->Tags.emplace_back(
          mapper, mapper->AddObserver(vtkCommand::StartEvent, this->Observer));
      });
  }
  ~Recorder()
  {
    for (const auto& [mapper, tag] : this->Tags)
    {
      mapper->RemoveObserver(tag);
    }
  }
  Recorder(const Recorder&) = delete;
  void operator=(const Recorder&) = delete;

  std::vector<Draw> Draws;

private:
  vtkNew<vtkCallbackCommand> Observer;
  std::unordered_map<vtkObject*, vtkProp*> Props;
  std::vector<std::pair<vtkMapper*, unsigned long>> Tags;
};

/// Counts by their names in the report.
using Fragments = std::map<std::string, long long>;

long long CountShown(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkNBufferDepthSource source;
  std::string why;
  if (!window || !source.Inspect(window, why))
  {
    throw std::runtime_error("the depth cannot be read: " + why);
  }
  std::vector<float> depth;
  ReadDepth(window, source, depth);
  return std::count_if(depth.begin(), depth.end(), [](float value) { return value < 1.0f; });
}

/// Repeats the draws, each within a query. Returns the samples of each draw, and sets `shown` to
/// the number of pixels that show a prop.
std::vector<GLuint> Replay(Session& session, const std::vector<Draw>& draws, long long& shown)
{
  std::vector<GLuint> samples(draws.size());
  vtkNew<NBufferPeers::DrawStage> stage;
  stage->Function = [&](vtkRenderer* renderer)
  {
    std::vector<GLuint> queries(draws.size());
    glGenQueries(static_cast<GLsizei>(queries.size()), queries.data());
    for (std::size_t i = 0; i < draws.size(); ++i)
    {
      glBeginQuery(GL_SAMPLES_PASSED, queries[i]);
      draws[i].Prop->RenderOpaqueGeometry(renderer);
      glEndQuery(GL_SAMPLES_PASSED);
    }
    for (std::size_t i = 0; i < draws.size(); ++i)
    {
      glGetQueryObjectuiv(queries[i], GL_QUERY_RESULT, &samples[i]);
    }
    glDeleteQueries(static_cast<GLsizei>(queries.size()), queries.data());
    shown = CountShown(renderer);
    return static_cast<int>(draws.size());
  };
  RenderOnly(session, { stage });
  return samples;
}

/// Takes the least of three counts of each draw, because llvmpipe now and then counts samples more
/// than once.
Fragments Count(
  Session& session, const std::vector<Draw>& draws, const std::vector<vtkProp*>& visible)
{
  constexpr int times = 3;
  const std::unordered_set<vtkProp*> seen(visible.begin(), visible.end());
  long long shown = 0;
  std::vector<GLuint> least = Replay(session, draws, shown);
  for (int i = 1; i < times; ++i)
  {
    const std::vector<GLuint> samples = Replay(session, draws, shown);
    std::transform(samples.begin(), samples.end(), least.begin(), least.begin(),
      [](GLuint a, GLuint b) { return std::min(a, b); });
  }
  long long passed = 0; // With colours, as the next two.
  long long ofHidden = 0;
  long long again = 0;
  long long ofDepth = 0; // Of draws for their depth alone.
  std::unordered_set<vtkProp*> drawn;
  for (std::size_t i = 0; i < draws.size(); ++i)
  {
    vtkProp* prop = draws[i].Prop;
    if (!draws[i].Colors)
    {
      ofDepth += least[i];
      continue;
    }
    passed += least[i];
    again += drawn.insert(prop).second ? 0 : least[i];
    ofHidden += seen.count(prop) > 0 ? 0 : least[i];
  }
  return { { "passed", passed }, { "shown", shown }, { "wasted", passed - shown },
    { "of_hidden", ofHidden }, { "again", again }, { "of_depth", ofDepth },
    { "draws", static_cast<long long>(draws.size()) } };
}
}

std::string GetFragmentsObstacle(Session& session)
{
  std::unordered_set<vtkMapper*> mappers;
  bool shared = false;
  ForEachMapper(session,
    [&](vtkMapper* mapper, vtkProp*) { shared = !mappers.insert(mapper).second || shared; });
  return shared ? "props share a mapper, their draws cannot be distinguished" : "";
}

Json::Value MeasureFragments(Session& session, const NBufferExamples::CameraPath& path,
  const std::vector<std::string>& modes, int frames)
{
  // Each frame and the one before it.
  std::vector<std::size_t> places;
  NBufferExamples::CameraPath poses;
  for (int i = 0; i < frames; ++i)
  {
    places.push_back(1 + (path.size() - 2) * static_cast<std::size_t>(i) / std::max(frames - 1, 1));
    poses.push_back(path[places.back()]);
  }
  const std::vector<std::vector<vtkProp*>> visible = FindVisibleProps(session, poses);
  Json::Value result(Json::objectValue);
  for (const std::string& name : modes)
  {
    ShowProgress("fragments of " + name);
    Fragments sum;
    // Passes of the OpenGL back-end are no draws of props.
    Mode mode(name, "cpu");
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      std::vector<Draw> draws;
      mode.Enter(session.GetRenderer());
      if (OracleCuller* oracle = mode.GetOracleCuller())
      {
        oracle->SetProps(&visible[i]);
      }
      // Twice before: what culls by the last frame has to have got used to it.
      for (std::size_t before : { places[i] - 1, places[i] - 1 })
      {
        session.SetPose(path[before]);
        session.Render();
      }
      {
        Recorder recorder(session);
        session.SetPose(path[places[i]]);
        session.Render();
        draws = recorder.Draws;
      }
      mode.Leave(session.GetRenderer());
      for (const auto& [kind, count] : Count(session, draws, visible[i]))
      {
        sum[kind] += count;
      }
    }
    for (const auto& [kind, count] : sum)
    {
      result[name][kind] = Round(static_cast<double>(count) / static_cast<double>(places.size()));
    }
  }
  return result;
}

} // namespace NBufferBench
