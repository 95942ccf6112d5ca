// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "QueryCuller.h"

#include "FlatQueries.h"
#include "FrameProjection.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferScissor.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <utility>

namespace NBufferPeers
{

vtkStandardNewMacro(QueryCuller);

QueryCuller::QueryCuller()
  : Props(this->Projection)
{
  this->Stage->Function = [this](vtkRenderer* renderer) { return this->DrawProps(renderer); };
}

double QueryCuller::Cull(
  vtkRenderer* vtkNotUsed(renderer), vtkProp** propList, int& listLength, int& initialized)
{
  const bool other = this->Props.Synchronize(propList, listLength);
  const bool changed = this->Props.Refresh() > 0;
  this->TreeIsOld = this->TreeIsOld || other || changed;
  this->Candidates.clear();
  int kept = 0;
  for (int i = 0; i < listLength; ++i)
  {
    if (this->Props.GetCandidate(i).IsCandidate())
    {
      this->Candidates.push_back(i);
    }
    else
    {
      propList[kept++] = propList[i];
    }
  }
  if (kept < listLength)
  {
    // Last, so that everything else is in the depth buffer.
    propList[kept++] = this->Stage;
  }
  listLength = kept;
  for (int i = 0; i < listLength; ++i)
  {
    propList[i]->SetRenderTimeMultiplier(1.0);
  }
  initialized = 1;
  return listLength;
}

bool QueryCuller::SetView(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkNBufferDepthSource source;
  if (!window || !source.Inspect(window, this->Error))
  {
    this->Error = window ? this->Error : "no OpenGL window";
    return false;
  }
  SetFrameProjection(renderer, source, this->Projection);
  this->Props.Project();
  this->Samples = source.Samples;
  return this->Queries.Begin(window, this->Target, this->Error);
}

PlacedBox QueryCuller::Place(const vtkNBufferBox& box)
{
  PlacedBox placed;
  placed.Box = box;
  placed.Placement = this->Projection.IsOutside(box) ? vtkNBufferPlacement::Outside
                                                     : this->Projection.Project(box, placed.Screen);
  return placed;
}

int QueryCuller::Query(const PlacedBox& box)
{
  ClipBox clip;
  return MakeClipBox(this->Projection, box.Box, box.Screen, clip) ? this->Queries.Query(clip) : -1;
}

bool QueryCuller::IsVisible(int query)
{
  const vtkNBufferClock clock;
  this->Statistics.Waits += this->Queries.HasAnswer(query) ? 0 : 1;
  const bool visible = this->Queries.IsVisible(query);
  this->Statistics.WaitTime += clock.GetMilliseconds();
  return visible;
}

void QueryCuller::Draw(int prop)
{
  // A leaf of the tree can be in view where the prop's own box, rounded once less, is not.
  if (this->Props.GetState(prop).Placement == vtkNBufferPlacement::Outside)
  {
    return;
  }
  this->Props.GetProp(prop)->RenderOpaqueGeometry(this->Renderer);
  this->Drawn.push_back(this->Props.GetDrawn(prop, static_cast<int>(this->Drawn.size()) + 1));
}

void QueryCuller::DrawByTree(bool old)
{
  if (old)
  {
    std::vector<vtkNBufferBox> boxes;
    for (int i : this->Candidates)
    {
      boxes.push_back(this->Props.GetBox(i));
    }
    this->Tree.Build(boxes, this->Candidates);
  }
  this->Tree.Draw(*this);
  this->Statistics.Nodes = static_cast<int>(this->Tree.GetNumberOfNodes());
  this->Statistics.Visits = this->Tree.GetNumberOfVisits();
}

void QueryCuller::Redraw()
{
  // With what was drawn before the stage, in the renderer's order.
  std::vector<vtkNBufferDrawnProp> all = this->Drawn;
  for (int i = 0; i < this->Props.GetSize(); ++i)
  {
    if (!this->Props.GetCandidate(i).IsCandidate() && this->Props.GetCandidate(i).WritesDepth())
    {
      all.push_back(this->Props.GetDrawn(i, 0));
    }
  }
  const std::vector<vtkNBufferRedraw> redraws = vtkNBufferTieOrder::GetRedraws(
    this->Projection, all, vtkNBufferGL::KeepsToScissor(this->Samples));
  for (const vtkNBufferRedraw& redraw : redraws)
  {
    vtkProp* prop = this->Props.GetProp(all[redraw.Position].Index);
    this->Statistics.Redrawn +=
      vtkNBufferGL::DrawIn(redraw.Regions, [&]() { prop->RenderOpaqueGeometry(this->Renderer); });
  }
}

int QueryCuller::DrawProps(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  this->Statistics = QueryStatistics();
  this->Error.clear();
  this->Drawn.clear();
  if (!this->SetView(renderer))
  {
    for (int i : this->Candidates)
    {
      this->Props.GetProp(i)->RenderOpaqueGeometry(renderer);
    }
    return static_cast<int>(this->Candidates.size());
  }
  std::vector<FlatItem> items;
  for (int i : this->Candidates)
  {
    const vtkNBufferPlacement placement = this->Props.GetState(i).Placement;
    if (placement != vtkNBufferPlacement::Outside)
    {
      ++this->Statistics.InView;
      if (this->Method == QueryMethod::Flat)
      {
        items.push_back({ { this->Props.GetBox(i), this->Props.GetScreen(i), placement }, i });
      }
    }
  }
  if (this->Method == QueryMethod::Flat)
  {
    DrawByFlatQueries(*this, items);
  }
  else
  {
    this->DrawByTree(std::exchange(this->TreeIsOld, false));
  }
  this->Statistics.Queries = this->Queries.GetCount();
  this->Statistics.Drawn = static_cast<int>(this->Drawn.size());
  this->Statistics.Hidden = this->Statistics.InView - this->Statistics.Drawn;
  this->Redraw();
  return this->Statistics.Drawn;
}

} // namespace NBufferPeers
