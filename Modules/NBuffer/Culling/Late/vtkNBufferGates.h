// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferGates
 * @brief The gates of one renderer's translucent props (vtkNBufferTranslucentProxy), reused each
 * frame.
 */
#ifndef vtkNBufferGates_h
#define vtkNBufferGates_h

#include "vtkNBufferTranslucentProxy.h"

#include "vtkSmartPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferGates
{
public:
  /// Begin a frame without gates.
  void Clear() { this->Count = 0; }

  /// The next gate, before a prop.
  vtkNBufferTranslucentProxy* Add(vtkProp* prop, bool open);

  ///@{
  /// Gate n is the n-th that was added.
  void SetOpen(std::size_t n, bool open) { this->Gates[n]->SetOpen(open); }
  bool HasDrawn(std::size_t n) const { return this->Gates[n]->HasDrawn(); }
  ///@}

private:
  std::vector<vtkSmartPointer<vtkNBufferTranslucentProxy>> Gates;
  std::size_t Count = 0;
};
VTK_ABI_NAMESPACE_END
#endif
