// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class ShadowMode
 * @brief A way to draw shadows that takes its turn in the one renderer that all modes share.
 *
 *     none        without shadows
 *     unclamped   vtkShadowVolumeClampPass, whole volumes
 *     cull        casters that have receivers, whole volumes
 *     auto        for each light unclamped or exact, whichever is guessed to be faster: the default
 *     exact       casters that have receivers, inside of the receivers' box of pixels
 *     clamp       the same, clamped to one slab (SlabGap 64)
 *     slabs       the same, clamped to several slabs (SlabGap 4)
 *     slabslit    slabs, with SkipUnlitReceivers
 *     paper       clamp, with the paper's litmap, drawn from the light: shadows may be lost
 *     vtk         vtkShadowMapPass with its baker, as VTK's tests put them together; right in
 *                 square windows only, as it looks maps up with an aspect ratio of 1
 *
 * cull, exact, clamp and slabs have the SkipUnlitReceivers that the pass was set up with, the
 * others have not but for slabslit. cull@N, auto@N, exact@N, clamp@N, slabs@N and paper@N have
 * litmaps of N x N lexels, vtk@N shadow maps of N x N texels instead of VTK's default. Modes of
 * volumes also with settings (ModeSettings.h), such as slabs@64:SlabGap=2.
 */
#ifndef ShadowMode_h
#define ShadowMode_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkRenderer;
class vtkShadowVolumeClampPass;

namespace NBufferBench
{

class ShadowMode
{
public:
  /// Modes of vtkShadowVolumeClampPass set up `volumes`, which they share, with litmaps of `litmap`
  /// x `litmap` where the name says nothing. Throws std::runtime_error if there is no such mode.
  ShadowMode(const std::string& name, int litmap, vtkShadowVolumeClampPass* volumes);

  const std::string& GetName() const { return this->Name; }

  bool HasVolumes() const { return this->IsVolumes; }

  /// Whether a sample that differs from a ray and is not ambiguous is an error of this module.
  static bool IsExact(const std::string& name);

  void Enter(vtkRenderer* renderer) const;

  /// Back to no pass; frees what the pass has on the graphics device.
  void Release(vtkRenderer* renderer) const;

private:
  std::string Name;
  std::string Kind;   ///< The name without @N and settings.
  int Resolution = 0; ///< Of the name, or 0.
  int Litmap;
  int BoxCost;             ///< Of the pass, where the name says nothing,
  bool SkipUnlitReceivers; ///< likewise.
  bool IsVolumes;
  vtkSmartPointer<vtkRenderPass> Pass;
};

} // namespace NBufferBench

#endif
