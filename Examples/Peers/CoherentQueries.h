// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class CoherentQueries
 * @brief Coherent hierarchical culling: queries over a tree of boxes, interleaved with drawing.
 *
 * J. Bittner, M. Wimmer, H. Piringer, W. Purgathofer: Coherent Hierarchical Culling: Hardware
 * Occlusion Queries Made Useful. Computer Graphics Forum 23 (3), 2004. Front to back, by a queue of
 * distances as in its successor for hierarchies of boxes (O. Mattausch, J. Bittner, M. Wimmer:
 * CHC++. Computer Graphics Forum 27 (2), 2008), since boxes of a hierarchy overlap:
 *
 *  - inner nodes that were visible in the last frame are opened without a query,
 *  - leaves that were visible are queried for the next frame, and drawn at once without waiting,
 *  - nodes that were hidden are queried, and left alone until the answer is there,
 *  - a visible answer is pulled up to the ancestors; hidden ones need none, since a node is reset
 *    when it is visited and stays hidden unless something below is found visible,
 *  - it is waited only when there is nothing else to do.
 *
 * A leaf is one prop. Nothing visible is left out: a hidden verdict is always one of this frame.
 */
#ifndef CoherentQueries_h
#define CoherentQueries_h

#include "QueryHost.h"

#include "vtkNBufferHierarchy.h"

#include <deque>
#include <queue>
#include <vector>

namespace NBufferPeers
{

class CoherentQueries
{
public:
  /// The tree over boxes; box i is that of prop props[i]. Forgets what was visible.
  void Build(const std::vector<vtkNBufferBox>& boxes, const std::vector<int>& props);

  void Draw(QueryHost& host);

  std::size_t GetNumberOfNodes() const { return this->Tree.GetNodes().size(); }

  /// Nodes looked at in the last frame.
  int GetNumberOfVisits() const { return this->Visits; }

private:
  struct State
  {
    int Parent = -1;
    long long LastVisited = -1;
    bool Visible = false;
    bool Drawn = false; ///< In this frame; of leaves.
  };
  struct Entry
  {
    int Node;
    PlacedBox Box;
  };
  /// The nearest on top.
  struct Later
  {
    bool operator()(const Entry& a, const Entry& b) const
    {
      return a.Box.GetNearest() > b.Box.GetNearest();
    }
  };
  struct Asked
  {
    int Node;
    int Query;
  };

  void Visit(QueryHost& host, const Entry& entry);
  void Open(QueryHost& host, int node);
  void PullUp(int node);
  void Push(QueryHost& host, int node);

  vtkNBufferHierarchy Tree;
  std::vector<int> Props;
  std::vector<State> States;
  std::priority_queue<Entry, std::vector<Entry>, Later> Distances;
  std::deque<Asked> Queue;
  long long Frame = 0;
  int Visits = 0;
};

} // namespace NBufferPeers

#endif
