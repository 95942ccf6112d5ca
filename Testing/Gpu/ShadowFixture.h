// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowFixture.h
 * @brief What tests of drawing shadow volumes share: boxes as casters, and a parallel view along -z
 * that shows x, y and z in [-1, 1].
 */
#ifndef ShadowFixture_h
#define ShadowFixture_h

#include "ShadowCaster.h"
#include "WindowFixture.h"
#include "vtkShadowCounter.h"

#include <algorithm>
#include <string>

class ShadowFixture : public WindowFixture
{
protected:
  using WindowFixture::WindowFixture;

  /// Releases the objects of OpenGL, unless the test was skipped.
  void TearDown() override
  {
    if (this->Window)
    {
      this->Counter.Release();
      this->Volume = vtkShadowVolumeBuffer();
    }
  }

  /// Returns the view. The eye is the origin of the world.
  static vtkShadowDrawList::View MakeView(const int viewport[4])
  {
    vtkShadowDrawList::View view;
    std::copy_n(viewport, 4, view.Viewport);
    view.EyeToClip = glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
    return view;
  }

  /// Makes the box between two corners.
  static ShadowMesh MakeBlock(const glm::dvec3& low, const glm::dvec3& high)
  {
    return MakeCube().Move(
      [&](const glm::dvec3& x) { return glm::mix(low, high, x + glm::dvec3(0.5)); });
  }

  /// Adds the clamped volume of a mesh in a slab of a directional light.
  static void AddPiece(vtkShadowVolumeStore& store, const ShadowMesh& mesh,
    const glm::dvec3& direction, const vtkShadowSlab& slab)
  {
    vtkShadowLight light;
    light.Direction = direction;
    const ShadowCaster caster(mesh, light);
    const vtkShadowLightSpace space(light);
    store.AddClamped(caster.MakePart(), space, slab, caster.GetDepths(space).second);
  }

  /// Returns a store with copies of such a clamped volume.
  static vtkShadowVolumeStore MakeVolume(
    const ShadowMesh& mesh, const glm::dvec3& direction, const vtkShadowSlab& slab, int copies = 1)
  {
    vtkShadowVolumeStore store;
    for (int i = 0; i < copies; ++i)
    {
      AddPiece(store, mesh, direction, slab);
    }
    return store;
  }

  /// Returns the draw of all volumes of a store, into the whole viewport.
  static vtkShadowDraw MakeDraw(
    const vtkShadowVolumeStore& store, const int viewport[4], bool zPass = false)
  {
    vtkShadowDraw draw;
    draw.NumberOfIndices = static_cast<int>(store.GetVolume().GetIndices().size());
    draw.ZPass = zPass;
    draw.Box = { 0, 0, viewport[2], viewport[3] };
    return draw;
  }

  /// Returns whether the centre of a pixel of the viewport has |x| < 0.5 and |y| < 0.3.
  static bool IsInVolume(int x, int y, const int viewport[4])
  {
    const double u = 2.0 * (x + 0.5) / viewport[2] - 1.0;
    const double v = 2.0 * (y + 0.5) / viewport[3] - 1.0;
    return u > -0.5 && u < 0.5 && v > -0.3 && v < 0.3;
  }

  vtkShadowCounter Counter;
  vtkShadowVolumeBuffer Volume;
  std::string Why;
};

#endif
