// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class CoherentQueries
 * @brief Coherent hierarchical culling: queries over a tree of boxes, interleaved with drawing.
 *
 * J. Bittner, M. Wimmer, H. Piringer, W. Purgathofer: Coherent Hierarchical Culling: Hardware
 * Occlusion Queries Made Useful. Computer Graphics Forum 23 (3), 2004. Boxes of a hierarchy
 * overlap, so that the nodes are visited front to back by a queue of distances, as in the successor
 * (O. Mattausch, J. Bittner, M. Wimmer: CHC++. Computer Graphics Forum 27 (2), 2008):
 *
 *  - Inner nodes that were visible in the last frame are opened without a query.
 *  - Leaves that were visible get a query, for the next frame, and are drawn at once.
 *  - Nodes that were hidden get a query, and nothing is done with them until the answer arrives.
 *  - If an answer is "visible", all ancestors become visible. The answer "hidden" changes nothing:
 *    a node becomes hidden when it is visited, and stays so unless something below it is visible.
 *  - The algorithm waits only when there is nothing else to do.
 *
 * A leaf is one prop. No visible prop is left out: every verdict "hidden" comes from this frame.
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
  /// Builds the tree over boxes; box i is that of prop props[i]. All nodes become hidden.
  void Build(const std::vector<vtkNBufferBox>& boxes, const std::vector<int>& props);

  /// Draws a frame.
  void Draw(QueryHost& host);

  std::size_t GetNumberOfNodes() const { return this->Tree.GetNodes().size(); }

  /// Returns the number of nodes that were visited in the last frame.
  int GetNumberOfVisits() const { return this->Visits; }

private:
  struct State
  {
    int Parent = -1;
    long long LastVisited = -1;
    bool Visible = false;
    bool Drawn = false; ///< Whether a leaf has been drawn in this frame.
  };
  struct Entry
  {
    int Node;
    PlacedBox Box;
  };
  /// Orders entries so that the nearest one is on top.
  struct Later
  {
    bool operator()(const Entry& a, const Entry& b) const
    {
      return a.Box.GetNearest() > b.Box.GetNearest();
    }
  };
  struct Queried
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
  std::deque<Queried> Queue;
  long long Frame = 0;
  int Visits = 0;
};

} // namespace NBufferPeers

#endif
