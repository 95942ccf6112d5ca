// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyFrames.h"

#include "VisibleProps.h"

#include "FrameProjection.h"

#include "vtkNBufferCandidate.h"

#include "vtkCallbackCommand.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkOpenGLRenderWindow.h"

#include <stdexcept>
#include <unordered_set>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPose;
using NBufferStudy::DepthBox;
using NBufferStudy::DepthFrame;

std::vector<vtkNBufferCandidate> MakeCandidates(Session& session)
{
  std::vector<vtkNBufferCandidate> candidates;
  for (vtkProp* prop : session.GetProps())
  {
    candidates.emplace_back(prop);
    candidates.back().Refresh(true);
  }
  return candidates;
}

void TakeBoxes(const std::vector<vtkNBufferCandidate>& candidates,
  const std::unordered_set<vtkProp*>& visible, DepthFrame& frame)
{
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const vtkNBufferCandidate& candidate = candidates[i];
    if (!candidate.IsCandidate())
    {
      ++frame.NotCandidates;
      continue;
    }
    DepthBox box;
    box.Box = candidate.GetBox();
    const vtkNBufferPlacement placement = frame.Projection.Project(box.Box, box.Screen);
    frame.Outside += placement == vtkNBufferPlacement::Outside ? 1 : 0;
    frame.Crossing += placement == vtkNBufferPlacement::Crossing ? 1 : 0;
    if (placement == vtkNBufferPlacement::Inside)
    {
      box.Visible = visible.count(candidate.GetProp()) > 0;
      box.Prop = static_cast<int>(i);
      frame.Boxes.push_back(box);
    }
  }
}
}

void RenderAndInspect(Session& session, const CameraPose& pose,
  const std::function<void(vtkOpenGLRenderWindow*, const vtkNBufferDepthSource&)>& function)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(session.GetWindow());
  std::string why = "no OpenGL window";
  std::function<void()> inspect = [&]()
  {
    vtkNBufferDepthSource source;
    if (window && source.Inspect(window, why))
    {
      why.clear();
      function(window, source);
    }
  };
  vtkNew<vtkCallbackCommand> atEnd;
  atEnd->SetClientData(&inspect);
  atEnd->SetCallback([](vtkObject*, unsigned long, void* run, void*)
    { (*static_cast<std::function<void()>*>(run))(); });
  session.SetPose(pose);
  const unsigned long tag = session.GetRenderer()->AddObserver(vtkCommand::EndEvent, atEnd);
  session.Render();
  session.GetRenderer()->RemoveObserver(tag);
  if (!why.empty())
  {
    throw std::runtime_error("the depth cannot be read: " + why);
  }
}

void ReadDepth(
  vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source, std::vector<float>& depth)
{
  const int* viewport = source.Viewport;
  std::string why;
  if (!source.Read(window, viewport[0], viewport[1], viewport[2], viewport[3], depth, why))
  {
    throw std::runtime_error("the depth cannot be read: " + why);
  }
}

std::vector<DepthFrame> CollectFrames(Session& session, const NBufferExamples::CameraPath& path)
{
  const std::vector<std::vector<vtkProp*>> visible = FindVisibleProps(session, path);
  session.SetCuller(vtkNew<vtkFrustumCoverageCuller>());
  const std::vector<vtkNBufferCandidate> candidates = MakeCandidates(session);
  std::vector<DepthFrame> frames(path.size());
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    DepthFrame& frame = frames[i];
    RenderAndInspect(session, path[i],
      [&](vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source)
      {
        frame.Width = source.Viewport[2];
        frame.Height = source.Viewport[3];
        NBufferPeers::SetFrameProjection(session.GetRenderer(), source, frame.Projection);
        ReadDepth(window, source, frame.Depth);
      });
    TakeBoxes(
      candidates, std::unordered_set<vtkProp*>(visible[i].begin(), visible[i].end()), frame);
  }
  session.SetCuller();
  return frames;
}

std::vector<vtkNBufferBox> CollectBoxes(Session& session)
{
  std::vector<vtkNBufferBox> boxes;
  for (const vtkNBufferCandidate& candidate : MakeCandidates(session))
  {
    if (candidate.IsCandidate())
    {
      boxes.push_back(candidate.GetBox());
    }
  }
  return boxes;
}

} // namespace NBufferBench
