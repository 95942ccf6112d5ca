// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowShading
 * @brief Gives the masks of a frame to the shaders of VTK's mappers.
 *
 * The pass is among the property keys of the props while they are drawn, and VTK's mappers call it
 * back: first to change the text of their shaders, then, for each prop, to set the uniforms of the
 * program.
 *
 * In the text, each term of a light (diffuse and specular of Phong shading, the radiance of PBR) is
 * multiplied by the share of the light that arrives, which vtkShadowLightDec.glsl declares.
 * Insert() knows what VTK's lighting code looks like, from VTK 9.1 to 9.7.
 */
#ifndef vtkShadowShading_h
#define vtkShadowShading_h

#include "vtkShadowLightList.h"

#include "vtkOpenGLState.h"
#include "vtkTimeStamp.h"

#include <string>
#include <utility>
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

  /// Declares the masks in a mapper's fragment shader. To be called before the mapper inserts its
  /// own code. Does nothing in a shader that declares them already.
  void Declare(std::string& fragmentShader) const;

  /// Multiplies the terms of lights by their shares. To be called after the mapper has inserted its
  /// own code. Does nothing for terms that are multiplied already. Returns false if the shader uses
  /// a light in an unknown way, so that its props receive no shadow of that light.
  bool Insert(std::string& fragmentShader) const;

  /// Sets the uniforms of a mapper's program. A Scope must live.
  void SetParameters(vtkShaderProgram* program);

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
  std::vector<int> ShaderLights; ///< The lights with masks, by their numbers in VTK's shaders.
  int Samples = 1;               ///< The samples of a pixel in the masks.
  vtkTimeStamp Time;
  std::vector<vtkShadowLightSource> Lights;
  std::vector<int> TextureUnits; ///< Unit i holds mask i.
  int DepthUnit = 0;
  /// The program whose uniforms were set last in this Scope, and its handle. Most props share their
  /// program, which keeps its uniforms from prop to prop.
  std::pair<const void*, int> LastProgram = {};
  std::vector<float> SampleOffsets; ///< From the middle of a pixel, x and y of each sample.
  std::vector<float> Attenuations;  ///< For each of ShaderLights; 0 if Lights is empty.
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowShading.h
