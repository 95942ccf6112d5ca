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
/// nullptr for PassKind::None. `shadows` is used by the kinds with shadow volumes; these are as the
/// others, without shadows, where it is nullptr.
vtkSmartPointer<vtkRenderPass> MakePass(PassKind kind, vtkRenderPass* shadows = nullptr);

inline bool HasShadowVolumes(PassKind kind)
{
  return kind == PassKind::ShadowVolumes || kind == PassKind::ShadowVolumesInSequence;
}

/// A camera pass around the passes, as applications build their own pipelines.
vtkSmartPointer<vtkRenderPass> MakeSequence(std::initializer_list<vtkRenderPass*> passes);
}

#endif
