// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferTieQuery.h
 * @brief Finds out from the device whether a draw has fragments with the same depth as what has
 * been drawn before.
 */
#ifndef vtkNBufferTieQuery_h
#define vtkNBufferTieQuery_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <functional>

VTK_ABI_NAMESPACE_BEGIN

namespace vtkNBufferTieQuery
{
/**
 * Whether draw() has a fragment with the same depth as the sample that it falls on. draw() is
 * called once, with a depth function of GL_EQUAL and without writing colors, so that it changes
 * nothing; OpenGL promises that the depth of a fragment does not depend on either (OpenGL 4.6,
 * appendix A.3, rules 2 and 3). A query of the device counts the fragments that pass.
 *
 * The answer is true, without a draw, if a query of the application is running already.
 *
 * The caller waits until the device has drawn.
 */
VTKNBUFFER_EXPORT bool HasTies(const std::function<void()>& draw);
}

VTK_ABI_NAMESPACE_END
#endif
