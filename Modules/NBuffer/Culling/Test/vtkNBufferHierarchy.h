// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferHierarchy
 * @brief A hierarchy of bounding boxes whose nodes follow boxes that move. No OpenGL.
 *
 * The hierarchy is a binary tree. Each node is split at the median of the centres of its boxes,
 * along the axis on which the centres extend farthest. The nodes are stored depth first. A jump to
 * an index (Next) then skips everything below a node, and refitting is one pass from the last node
 * to the first:
 *
 *              0              nodes      0 1 2 3 4 5 6
 *          1       4          Next       7 4 3 4 7 6 7
 *        2   3   5   6
 *
 * The box of a node can be tested by vtkNBufferProjection like any other, and the result for the
 * node holds for everything below it: the box contains all boxes below, rounded outward, the error
 * of its vertices is at least that of each of them, and its margin is the largest. If a box below
 * is not finite, the node's box is NaN, and every test of the node says that nothing is known.
 *
 * With n boxes, Build() takes about n log n steps and Refit() looks at the nodes above the boxes
 * that have moved. The memory is about 150 bytes for each box.
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
  /// The largest number of boxes in a leaf. Testing a node takes as long as testing a box.
  static constexpr int DefaultLeafSize = 8;

  struct Node
  {
    vtkNBufferBox Box;
    ///@{
    /// The boxes below the node are those at Begin to End - 1 of GetOrder().
    int Begin = 0;
    int End = 0;
    ///@}
    int Left = -1;  ///< The left child, which is the next node; -1 for a leaf.
    int Right = -1; ///< The right child; -1 for a leaf.
    int Next = 0;   ///< The first node after this one that is not below it.
  };

  /// Build the tree over those of `boxes` whose indices are in `places`, each at most once.
  void Build(const std::vector<vtkNBufferBox>& boxes, std::vector<int> places,
    int leafSize = DefaultLeafSize);

  /// Build the tree over all boxes.
  void Build(const std::vector<vtkNBufferBox>& boxes, int leafSize = DefaultLeafSize);

  /// Remove all boxes.
  void Clear();

  /// Whether the tree contains the box of a place.
  bool Has(int place) const
  {
    return place < static_cast<int>(this->Slots.size()) && this->Slots[place] >= 0;
  }

  /// Replace the box of a place that is in the tree. The nodes follow with the next Refit().
  void Move(int place, const vtkNBufferBox& box);

  /// Fit the nodes to the boxes that were replaced since the last call. Returns the number of nodes
  /// that were fitted.
  int Refit();

  /**
   * How much larger the leaves are than when the tree was built: the sum of their sizes along all
   * axes, divided by that sum at Build(). It is 1 just after Build(). It grows when boxes move away
   * from their neighbours; then more nodes are visited in vain.
   */
  double GetGrowth() const;

  /// Call descend(const Node&) for node `root` and the nodes below it, each before its children.
  /// descend() returns whether to visit what is below the node.
  template <typename Descend>
  void Visit(int root, Descend&& descend) const
  {
    const int end = this->Nodes.empty() ? root : this->Nodes[root].Next;
    for (int i = root; i < end;)
    {
      i = descend(this->Nodes[i]) ? i + 1 : this->Nodes[i].Next;
    }
  }

  /// All nodes, the root first.
  const std::vector<Node>& GetNodes() const { return this->Nodes; }

  /// The index of a node in GetNodes().
  int GetIndex(const Node& node) const { return static_cast<int>(&node - this->Nodes.data()); }

  /// The places of the boxes, in an order in which those below any node are neighbours.
  const std::vector<int>& GetOrder() const { return this->Order; }

private:
  struct Key;

  int Split(std::vector<Key>& keys, int begin, int end, int leafSize);
  void FitNode(std::size_t place);

  std::vector<Node> Nodes;
  std::vector<unsigned char> Dirty; ///< For each node, whether a box below was replaced.
  std::vector<int> Order;
  std::vector<int> Slots;           ///< For each place, where it is in Order, or -1.
  std::vector<vtkNBufferBox> Boxes; ///< The boxes in the order of Order.
  double Extent = 0.0;              ///< The sum of the sizes of all leaves.
  double BuiltExtent = 0.0;         ///< That sum at Build().
};

VTK_ABI_NAMESPACE_END
#endif
