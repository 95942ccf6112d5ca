// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferHierarchy
 * @brief A hierarchy of bounding boxes: parents before children, refit when boxes move. No OpenGL.
 *
 * A binary tree by the median of the centres along the longest axis. Nodes follow each other depth
 * first, so that passing over what is below a node is adding to an index, and refitting is one walk
 * backwards:
 *
 *              0              nodes      0 1 2 3 4 5 6
 *          1       4          Next       7 4 3 4 7 6 7
 *        2   3   5   6
 *
 * The box of a node is one that vtkNBufferProjection may judge like any other, and what it says of
 * the node holds for all that is below: it contains their boxes, rounded outward, its rounding is
 * at least that of each of them, and its margin the largest. A box that is not finite makes all
 * nodes above it so, of which nothing is ever known.
 *
 * Cost of n boxes: Build() about n log n, Refit() the nodes above what has moved; memory about 150
 * bytes per box.
 */
#ifndef vtkNBufferHierarchy_h
#define vtkNBufferHierarchy_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferHierarchy
{
public:
  /// Boxes of a leaf: asking a node costs as much as asking a box.
  static constexpr int DefaultLeafSize = 8;

  struct Node
  {
    vtkNBufferBox Box;
    int Begin = 0; ///< In GetOrder().
    int End = 0;
    int Left = -1; ///< -1: a leaf. The left child is the next node.
    int Right = -1;
    int Next = 0; ///< The first node that is not below this one.
  };

  /// Of those boxes whose places are in `places`, each at most once.
  void Build(const std::vector<vtkNBufferBox>& boxes, std::vector<int> places,
    int leafSize = DefaultLeafSize);

  /// Of all boxes.
  void Build(const std::vector<vtkNBufferBox>& boxes, int leafSize = DefaultLeafSize);

  /// No boxes.
  void Clear();

  /// Whether the box of a place is in the tree.
  bool Has(int place) const
  {
    return place < static_cast<int>(this->Slots.size()) &&
      this->Slots[static_cast<std::size_t>(place)] >= 0;
  }

  /// Another box for a place that is in the tree; nodes follow with the next Refit().
  void Move(int place, const vtkNBufferBox& box);

  /// Fit the nodes to boxes that have moved. Returns how many nodes are above these.
  int Refit();

  /// The same tree over boxes that may all have moved.
  void Refit(const std::vector<vtkNBufferBox>& boxes);

  /**
   * How much wider the leaves are than when they were built, 1 for as wide: the sum of their sizes
   * along all axes by what it was. Boxes that have left their neighbours make it grow, and with it
   * the number of nodes that are asked in vain.
   */
  double GetGrowth() const;

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
  /// For other walks: the root comes first; places of boxes, a node's from Begin to End.
  const std::vector<Node>& GetNodes() const { return this->Nodes; }
  const std::vector<int>& GetOrder() const { return this->Order; }
  ///@}

private:
  struct Key;

  int Split(std::vector<Key>& keys, int begin, int end, int leafSize);
  void FitNode(std::size_t place);

  std::vector<Node> Nodes;
  std::vector<unsigned char> Dirty; ///< By node: something below has moved.
  std::vector<int> Order;
  std::vector<int> Slots;           ///< By place: where in Order, or -1.
  std::vector<vtkNBufferBox> Boxes; ///< In the order of Order.
  double Extent = 0.0;              ///< Of all leaves.
  double BuiltExtent = 0.0;
};

VTK_ABI_NAMESPACE_END
#endif
