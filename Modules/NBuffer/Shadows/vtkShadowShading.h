// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowShading
 * @brief Gives the masks of a frame to the shaders of VTK's mappers.
 *
 * The pass is among the property keys of the props while they are drawn, and VTK's mappers call it
 * back: first to change the text of their shaders (vtkShadowShader), then, for each prop, to set
 * the uniforms of the program.
 */
#ifndef vtkShadowShading_h
#define vtkShadowShading_h

#include "vtkShadowLightList.h"
#include "vtkShadowShader.h"

#include "vtkOpenGLState.h"
#include "vtkTimeStamp.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkShadowTarget;
class vtkTextureObject;

class vtkShadowShading
{
public:
  /// The shaders are made for these lights and this number of samples of a pixel from now on.
  void SetUp(const std::vector<vtkShadowLightSource>& lights, int samples);

  /// The lights whose masks darken what is drawn; the other lights of SetUp() shine everywhere.
  void SetLights(const std::vector<vtkShadowLightSource>& lights) { this->Lights = lights; }
  const std::vector<vtkShadowLightSource>& GetLights() const { return this->Lights; }

  /// Changes when mappers have to build their shaders anew.
  vtkMTimeType GetMTime() const { return this->Time.GetMTime(); }
  const vtkShadowShader& GetShader() const { return this->Shader; }

  /// Set the uniforms of a mapper's program.
  void SetParameters(vtkShaderProgram* program, const vtkShadowTarget& target) const;

  /// While it lives, the masks of `target` are bound to texture units, and so is `depth` if it is
  /// not nullptr. The active texture unit is restored.
  class Scope
  {
  public:
    Scope(vtkShadowShading& shading, vtkOpenGLRenderWindow* window, const vtkShadowTarget& target,
      vtkTextureObject* depth);
    ~Scope();
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

  private:
    const vtkOpenGLState::ScopedglActiveTexture ActiveUnit; ///< Ends last.
    const vtkShadowTarget& Target;
    vtkTextureObject* Depth;
  };

private:
  vtkShadowShader Shader;
  vtkTimeStamp Time;
  std::vector<vtkShadowLightSource> Lights;
  std::vector<int> TextureUnits; ///< Unit i holds mask i.
  int DepthUnit = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowShading.h
