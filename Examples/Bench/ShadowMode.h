// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class ShadowMode
 * @brief A way to draw shadows that takes its turn in the one renderer that all modes share.
 *
 *     none        without shadows
 *     unclamped   vtkShadowVolumeClampPass, whole volumes
 *     cull        only casters that have receivers, whole volumes
 *     auto        for each light unclamped or exact, whichever is estimated to be faster; the
 *                 default of the pass
 *     exact       only casters that have receivers, inside of the receivers' box of pixels
 *     clamp       the same, clamped to one slab (SlabGap 64)
 *     slabs       the same, clamped to several slabs (SlabGap 4)
 *     paper       as clamp, with the litmap of the paper (RerenderedLitmap.h)
 *     vtk         vtkShadowMapPass with its baker, put together as in VTK's tests. It is right in
 *                 square windows only, because it looks maps up with an aspect ratio of 1
 *
 * cull@N, auto@N, exact@N, clamp@N, slabs@N and paper@N have litmaps of N x N lexels; vtk@N has
 * shadow maps of N x N texels instead of VTK's default. Modes of volumes and vtk can also have
 * settings (ModeSettings.h), such as slabs@64:SlabGap=2 or vtk@1024:Exponent=80.
 */
#ifndef ShadowMode_h
#define ShadowMode_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

class vtkRenderer;
class vtkShadowLitmapSource;
class vtkShadowVolumeClampPass;

namespace NBufferBench
{

class ShadowMode
{
public:
  /// All modes of volumes share the pass `volumes` and set it up when they are entered. Throws
  /// std::runtime_error if there is no such mode.
  ShadowMode(const std::string& name, vtkShadowVolumeClampPass* volumes);

  const std::string& GetName() const { return this->Name; }

  /// Returns whether the mode draws with vtkShadowVolumeClampPass.
  bool HasVolumes() const { return this->IsVolumes; }

  /// Returns whether the mode draws a shadow map anew for each frame, which it does where the light
  /// has been modified.
  bool DrawsMapEachFrame() const { return this->IsEachFrame; }

  /// Returns whether every sample that differs from a ray and is not ambiguous is an error of this
  /// module. That is so in all modes of volumes except paper.
  bool IsExact() const { return this->IsVolumes && this->Kind != "paper"; }

  void Enter(vtkRenderer* renderer) const;

  /// Takes the pass off the renderer and frees what the pass has on the graphics device.
  void Release(vtkRenderer* renderer) const;

private:
  std::string Name;
  std::string Kind;   ///< The name without @N and settings.
  int Resolution = 0; ///< The N of the name, or 0.
  bool IsVolumes;
  bool IsEachFrame = false;
  vtkSmartPointer<vtkRenderPass> Pass;
  std::shared_ptr<vtkShadowLitmapSource> LitmapSource; ///< The paper's, of the mode paper.
};

} // namespace NBufferBench

#endif
