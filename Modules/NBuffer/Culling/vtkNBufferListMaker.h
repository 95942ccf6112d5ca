// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferListMaker
 * @brief Makes the list of props that the renderer draws in a frame, from the verdicts of Cull().
 *
 * Props with the verdicts Outside and Hidden are left out. While a test is pending, those with the
 * verdict Unknown are held back: one proxy represents all of them. It is the last in the list,
 * except where a prop blends in the opaque stage: that prop shows what has been drawn before it, so
 * that it and the props after it come behind the proxy. Translucent props and large props that are
 * drawn unit by unit keep their places, behind proxies of their own.
 */
#ifndef vtkNBufferListMaker_h
#define vtkNBufferListMaker_h

#include "vtkNBufferPropProxy.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferCandidateList;
class vtkNBufferDeferredProxy;
class vtkNBufferDepthTest;
class vtkNBufferDivision;
class vtkNBufferPartition;

class vtkNBufferListMaker
{
public:
  /// The arguments are kept by reference and must outlive this object.
  vtkNBufferListMaker(vtkNBufferCandidateList& props, const vtkNBufferPartition& partition,
    vtkNBufferDivision& division, vtkNBufferDeferredProxy* proxy)
    : Props(props)
    , Partition(partition)
    , Division(division)
    , Proxy(proxy)
  {
  }

  /// Replace the list in place, as vtkCuller::Cull() does, and return the sum of the render time
  /// multipliers, as that function does. `isTestPending` says whether the proxy will test.
  double Fill(bool isTestPending, vtkProp** props, int& count, int& initialized);

  /// Test the translucent props, and the units of large ones, which have not been drawn yet in this
  /// frame. Closes the proxies of those that are hidden, and sets their verdicts to Hidden.
  void TestTranslucent(vtkNBufferDepthTest& test);

  /// Open the proxies of all translucent props, and set their verdicts to Translucent.
  void ShowTranslucent();

private:
  /// Let the next unused proxy represent a prop in this frame.
  vtkNBufferPropProxy* AddProxy(int place);
  /// The proxy of a prop that has one.
  vtkNBufferPropProxy* FindProxy(int place) const;

  vtkNBufferCandidateList& Props;
  const vtkNBufferPartition& Partition;
  vtkNBufferDivision& Division;
  vtkNBufferDeferredProxy* Proxy;
  /// These are created once and used again in every frame. The first ones are those of this frame,
  /// in the order of their places.
  std::vector<vtkSmartPointer<vtkNBufferPropProxy>> Proxies;
  std::size_t NumberOfProxies = 0; ///< The number of proxies in use in this frame.
};

VTK_ABI_NAMESPACE_END
#endif
