// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoherentQueries.h"

#include <utility>

namespace NBufferPeers
{

void CoherentQueries::Build(const std::vector<vtkNBufferBox>& boxes, const std::vector<int>& props)
{
  this->Tree.Build(boxes, 1);
  this->Props = props;
  this->States.assign(this->Tree.GetNodes().size(), State());
  for (int i = 0; i < static_cast<int>(this->States.size()); ++i)
  {
    const vtkNBufferHierarchy::Node& node = this->Tree.GetNodes()[i];
    if (node.Left >= 0)
    {
      this->States[node.Left].Parent = i;
      this->States[node.Right].Parent = i;
    }
  }
}

void CoherentQueries::Draw(QueryHost& host)
{
  ++this->Frame;
  this->Visits = 0;
  this->Queue.clear();
  if (this->States.empty())
  {
    return;
  }
  this->Push(host, 0);
  while (!this->Distances.empty() || !this->Queue.empty())
  {
    while (!this->Queue.empty() &&
      (this->Distances.empty() || host.HasAnswer(this->Queue.front().Query)))
    {
      const Queried queried = this->Queue.front();
      this->Queue.pop_front();
      if (host.IsVisible(queried.Query))
      {
        this->PullUp(queried.Node);
        this->Open(host, queried.Node);
      }
    }
    if (!this->Distances.empty())
    {
      const Entry entry = this->Distances.top();
      this->Distances.pop();
      this->Visit(host, entry);
    }
  }
}

void CoherentQueries::Visit(QueryHost& host, const Entry& entry)
{
  ++this->Visits;
  State& state = this->States[entry.Node];
  const bool isLeaf = this->Tree.GetNodes()[entry.Node].Left < 0;
  const bool wasVisible = state.Visible && state.LastVisited == this->Frame - 1;
  state.Visible = false;
  state.Drawn = false;
  state.LastVisited = this->Frame;
  if (wasVisible && !isLeaf)
  {
    this->Open(host, entry.Node);
    return;
  }
  const int query = entry.Box.Placement == vtkNBufferPlacement::Inside ? host.Query(entry.Box) : -1;
  if (query < 0)
  {
    this->PullUp(entry.Node);
    this->Open(host, entry.Node);
    return;
  }
  this->Queue.push_back({ entry.Node, query });
  if (wasVisible)
  {
    this->Open(host, entry.Node);
  }
}

void CoherentQueries::Open(QueryHost& host, int place)
{
  const vtkNBufferHierarchy::Node& node = this->Tree.GetNodes()[place];
  if (node.Left < 0)
  {
    // The answer to a leaf that has been drawn without waiting for it.
    if (!std::exchange(this->States[place].Drawn, true))
    {
      host.Draw(this->Props[this->Tree.GetOrder()[node.Begin]]);
    }
    return;
  }
  this->Push(host, node.Left);
  this->Push(host, node.Right);
}

void CoherentQueries::Push(QueryHost& host, int node)
{
  const Entry entry = { node, host.Place(this->Tree.GetNodes()[node].Box) };
  if (entry.Box.Placement != vtkNBufferPlacement::Outside)
  {
    this->Distances.push(entry);
  }
}

void CoherentQueries::PullUp(int node)
{
  // An ancestor that is visible already has visible ancestors.
  for (; node >= 0 && !this->States[node].Visible; node = this->States[node].Parent)
  {
    this->States[node].Visible = true;
  }
}

} // namespace NBufferPeers
