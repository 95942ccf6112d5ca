// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzPasses.h
 * @brief The render passes that scenarios name.
 */
#ifndef FuzzPasses_h
#define FuzzPasses_h

#include "Scenario.h"

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

namespace NBufferFuzz
{
/// nullptr for PassKind::None.
vtkSmartPointer<vtkRenderPass> MakePass(PassKind kind);
}

#endif
