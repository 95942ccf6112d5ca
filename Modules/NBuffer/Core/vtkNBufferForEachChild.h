// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferForEachChild.h
 * @brief Visits the nodes of composite data.
 *
 * vtk::Range() does the same, but each reference to a child copies the iterator, and the copy
 * begins again at the first child. With thousands of children this takes seconds.
 */
#ifndef vtkNBufferForEachChild_h
#define vtkNBufferForEachChild_h

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkNBufferVTKVersion.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN

/// Call `visit` with each child that is not null, in their order, until it returns false.
template <typename Visit>
void vtkNBufferForEachChild(vtkDataObjectTree* tree, const Visit& visit)
{
  const auto child = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  child->SkipEmptyNodesOn();
  child->TraverseSubTreeOff();
  child->VisitOnlyLeavesOff();
  for (child->InitTraversal(); !child->IsDoneWithTraversal(); child->GoToNextItem())
  {
    if (!visit(child->GetCurrentDataObject()))
    {
      return;
    }
  }
}

/// Whether a test holds for data or, if it is composite, for any node of it. No further node is
/// tested once it holds. `data` may be nullptr.
template <typename Test>
bool vtkNBufferAnyNode(vtkDataObject* data, const Test& test)
{
  bool holds = data && test(data);
  if (auto* tree = holds ? nullptr : vtkDataObjectTree::SafeDownCast(data))
  {
    vtkNBufferForEachChild(tree,
      [&](vtkDataObject* child)
      {
        holds = vtkNBufferAnyNode(child, test);
        return !holds;
      });
  }
  return holds;
}

VTK_ABI_NAMESPACE_END
#endif
