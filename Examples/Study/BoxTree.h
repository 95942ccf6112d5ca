// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class BoxTree
 * @brief A hierarchy of bounding boxes over props: parents before children, refit when they move.
 *
 * A binary tree by the median of the centres along the longest axis. Nodes follow each other depth
 * first, so that passing over what is below a node is adding to an index, and refitting is one walk
 * backwards. A node's rounding is at least that of every box in it (vtkNBufferProjection.h).
 */
#ifndef BoxTree_h
#define BoxTree_h

#include "vtkNBufferProjection.h"

#include <vector>

namespace NBufferStudy
{

class BoxTree
{
public:
  struct Node
  {
    vtkNBufferBox Box;
    int Begin = 0; ///< In Order.
    int End = 0;
    int Left = -1; ///< -1: a leaf. The left child is the next node.
    int Right = -1;
    int Next = 0; ///< The first node that is not below this one.
  };

  /// Boxes are referred to by their places in `boxes`.
  void Build(const std::vector<vtkNBufferBox>& boxes, int leafSize);

  /// The same tree over boxes that have moved.
  void Refit(const std::vector<vtkNBufferBox>& boxes);

  enum class Answer
  {
    Skip,   ///< Nothing below is asked.
    Descend ///< The children are asked, or the boxes of a leaf.
  };

  /// askNode(const vtkNBufferBox&) gives an Answer; askBox(int) is called for the boxes of leaves.
  template <typename AskNode, typename AskBox>
  void Visit(AskNode&& askNode, AskBox&& askBox) const
  {
    for (std::size_t i = 0; i < this->Nodes.size();)
    {
      const Node& node = this->Nodes[i];
      if (askNode(node.Box) == Answer::Skip)
      {
        i = static_cast<std::size_t>(node.Next);
        continue;
      }
      if (node.Left < 0)
      {
        for (int place = node.Begin; place < node.End; ++place)
        {
          askBox(this->Order[static_cast<std::size_t>(place)]);
        }
      }
      ++i;
    }
  }

  std::size_t GetNumberOfNodes() const { return this->Nodes.size(); }

  ///@{
  /// For other walks: the root comes first; places of boxes, a leaf's from Begin to End.
  const std::vector<Node>& GetNodes() const { return this->Nodes; }
  const std::vector<int>& GetOrder() const { return this->Order; }
  ///@}

private:
  int Split(const std::vector<vtkNBufferBox>& boxes, int begin, int end, int leafSize);

  std::vector<Node> Nodes;
  std::vector<int> Order;
};

} // namespace NBufferStudy

#endif
