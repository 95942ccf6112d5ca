// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSettings
 * @brief The settings of a culler that a user decides, at the beginning of a frame.
 * vtkNBufferCuller.h says what they mean.
 */
#ifndef vtkNBufferSettings_h
#define vtkNBufferSettings_h

#include "vtkNBufferBackend.h"
#include "vtkNBufferDepthTest.h"

VTK_ABI_NAMESPACE_BEGIN

struct vtkNBufferSettings
{
  vtkNBufferBackend::Kind Backend = vtkNBufferBackend::Auto;
  vtkNBufferSliverPolicy TestSlivers = vtkNBufferSliverPolicy::Never;
  bool Freeze = false;
};

VTK_ABI_NAMESPACE_END
#endif
