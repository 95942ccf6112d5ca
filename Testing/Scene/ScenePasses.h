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
#include "vtkRenderer.h"
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

/// Prepares the pass of a renderer for another context. VTK 9.1's FXAA pass keeps the shader of the
/// old one. vtkShadowMapBakerPass bakes only after a change of props or lights, and does not notice
/// that its maps went with the context. Both would end the program.
void RenewPasses(vtkRenderer* renderer);

///@{
/// Make a vtkCameraPass around a sequence of passes, as applications do, and the sequence alone.
vtkSmartPointer<vtkRenderPass> MakeSequence(std::initializer_list<vtkRenderPass*> passes);
vtkSmartPointer<vtkRenderPass> InSequence(std::initializer_list<vtkRenderPass*> passes);
///@}
}

#endif
