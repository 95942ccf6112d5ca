// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenePasses.h
 * @brief The render passes that scenarios name.
 */
#ifndef ScenePasses_h
#define ScenePasses_h

#include "Scenario.h"

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <initializer_list>

namespace TestScene
{
/// Makes a pass; nullptr for PassKind::None. The kinds with shadow volumes, and reversed ones, use
/// the pass `shadows`; if it is nullptr, they draw the same without shadows.
vtkSmartPointer<vtkRenderPass> MakePass(PassKind kind, vtkRenderPass* shadows = nullptr);

inline bool HasShadowVolumes(PassKind kind)
{
  return kind == PassKind::ShadowVolumes || kind == PassKind::ShadowVolumesInSequence;
}

/// Makes a vtkCameraPass around a sequence of passes, as applications do.
vtkSmartPointer<vtkRenderPass> MakeSequence(std::initializer_list<vtkRenderPass*> passes);
}

#endif
