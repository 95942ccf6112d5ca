// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowShading
 * @brief Gives the masks of a frame to the shaders of VTK's mappers.
 *
 * While the props are drawn, the pass is among their property keys, and VTK's mappers call it back:
 * first to change the text of their shaders, then, for each prop, to set the uniforms of the
 * program. The pass forwards these calls to this class.
 *
 * In the text, each term of a light (diffuse and specular of Phong shading, the radiance of PBR) is
 * multiplied by the share of the light that arrives, which vtkShadowLightDec.glsl declares.
 * Insert() knows the lighting code of VTK 9.1 to 9.7.
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
  /// Sets the lights and the number of samples of a pixel for which shaders are made from now on.
  void SetUp(const std::vector<vtkShadowLightSource>& lights, int samples);

  /// Sets the lights whose masks darken what is drawn: those of SetUp(), or none to draw without
  /// shadows.
  void SetLights(const std::vector<vtkShadowLightSource>& lights) { this->Lights = lights; }
  const std::vector<vtkShadowLightSource>& GetLights() const { return this->Lights; }

  /// A time that grows when mappers have to build their shaders again.
  vtkMTimeType GetMTime() const { return this->Time.GetMTime(); }

  /// Declares the masks in a mapper's fragment shader. Call it before the mapper inserts its own
  /// code. It does nothing in a shader that already declares them.
  void Declare(std::string& fragmentShader) const;

  /// Multiplies the terms of lights by their shares, and VTK's offsets of depth by 0 where only the
  /// depth of receivers is drawn. Call it after the mapper has inserted its own code. It does
  /// nothing for lights whose terms are already multiplied. Returns false if the shader uses a
  /// light in an unknown way, so that its props receive no shadow of that light.
  bool Insert(std::string& fragmentShader) const;

  /// Sets the uniforms of a mapper's program. Call it within a Scope.
  void SetParameters(vtkShaderProgram* program);

  /// What the props are drawn for.
  enum class Purpose
  {
    Depth, ///< The depth of the receivers.
    Color
  };

  /// Binds the masks of `target` and, for Color, the depth that the shaders need, to texture units.
  /// When the scope ends, it releases them and restores the active texture unit.
  class Scope
  {
  public:
    Scope(vtkShadowShading& shading, vtkOpenGLRenderWindow* window, const vtkShadowTarget& target,
      Purpose purpose);
    ~Scope();
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

  private:
    const vtkOpenGLState::ScopedglActiveTexture ActiveUnit; ///< The first member, so it ends last.
    std::vector<vtkTextureObject*> Textures;                ///< Those that are bound.
  };

private:
  std::vector<int> ShaderLights; ///< The lights with masks, by their numbers in VTK's shaders.
  int Samples = 1;               ///< The samples of a pixel in the masks.
  vtkTimeStamp Time;
  std::vector<vtkShadowLightSource> Lights;
  std::vector<int> TextureUnits; ///< Element i is the texture unit of mask i.
  int DepthUnit = 0;
  Purpose DrawnFor = Purpose::Color;
  vtkOpenGLState* State = nullptr; ///< That of the Scope's window.
  /// The program whose uniforms were set last in this Scope, and its handle. Most props share their
  /// program, which keeps its uniforms from prop to prop.
  std::pair<const void*, int> LastProgram = {};
  std::vector<float> SampleOffsets; ///< x and y of each sample from a pixel's middle, in pixels.
  std::vector<float> Attenuations;  ///< For each of ShaderLights; 0 if Lights is empty.
};

VTK_ABI_NAMESPACE_END
#endif
