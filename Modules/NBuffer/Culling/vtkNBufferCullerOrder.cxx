// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCullerOrder.h"

#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkSmartPointer.h"

#include <typeinfo>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Whether the frustum test of vtkNBufferView does everything that `culler` would do.
bool IsDefaultFrustumCuller(vtkCuller* culler)
{
  if (typeid(*culler) != typeid(vtkFrustumCoverageCuller))
  {
    return false;
  }
  auto* frustum = static_cast<vtkFrustumCoverageCuller*>(culler);
  return frustum->GetMinimumCoverage() == 0.0 && frustum->GetMaximumCoverage() == 1.0 &&
    frustum->GetSortingStyle() == VTK_CULLER_SORT_NONE;
}
}

namespace vtkNBufferCullerOrder
{
void MoveFrustumCullersBehind(vtkCuller* self, vtkCullerCollection* cullers)
{
  std::vector<vtkSmartPointer<vtkCuller>> before;
  vtkCollectionSimpleIterator cookie;
  cullers->InitTraversal(cookie);
  for (vtkCuller* culler = cullers->GetNextCuller(cookie); culler && culler != self;
       culler = cullers->GetNextCuller(cookie))
  {
    if (IsDefaultFrustumCuller(culler))
    {
      before.emplace_back(culler);
    }
  }
  for (const vtkSmartPointer<vtkCuller>& culler : before)
  {
    cullers->RemoveItem(culler);
    cullers->AddItem(culler);
  }
}

bool IsOtherBehind(vtkCuller* self, vtkCullerCollection* cullers)
{
  bool behind = false;
  vtkCollectionSimpleIterator cookie;
  cullers->InitTraversal(cookie);
  while (vtkCuller* culler = cullers->GetNextCuller(cookie))
  {
    if (behind && !IsDefaultFrustumCuller(culler))
    {
      return true;
    }
    behind = behind || culler == self;
  }
  return false;
}
}
VTK_ABI_NAMESPACE_END
