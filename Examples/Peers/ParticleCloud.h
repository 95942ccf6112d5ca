// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ParticleCloud.h
 * @brief Particles that the vertex stage rejects by an N-buffer, as the paper draws them.
 *
 * X. Decoret, "N-Buffers for efficient depth map query", Computer Graphics Forum 24(3), 2005,
 * sections 3.2 and 4.3: the scene is drawn, the N-buffer of its depth is built, and a vertex
 * program moves hidden particles out of the clip volume. It queries by vtkNBufferQuery.glsl: one
 * lookup for a sprite of 16 x 16 pixels, four squares for a box. Optionally a lookup of minima
 * first accepts particles before everything else (M. Turitzin, "Hierarchical Depth Buffers", 2020).
 *
 * Sprites begin where a pixel begins, and are drawn where they are with and without culling.
 * Particles write no depth, so that they do not hide each other.
 */
#ifndef ParticleCloud_h
#define ParticleCloud_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferGLObject.h"
#include "vtkNBufferTexture.h"

#include "vtkNew.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace NBufferPeers
{

enum class ParticleCulling
{
  None,
  Maxima,      ///< Hidden particles are rejected.
  MinimaFirst, ///< As Maxima, but a lookup of minima accepts particles before it.
};

class ParticleCloud
{
public:
  /// What the vertex stage found of a particle.
  struct Finding
  {
    vtkNBufferRectangle Pixels; ///< All that it may cover, of which a part may be outside.
    bool IsHidden = false;      ///< It was rejected.
    bool IsAccepted = false;    ///< The lookup of minima was sufficient.
    bool IsTested = false;      ///< It does not reach behind the near plane.
  };

  static constexpr int SpriteLevel = 4; ///< Sprites of the paper have 16 x 16 pixels.

  /// Sets the particles, relative to the eye. A `boxSide` above 0 makes them boxes of that side.
  void Set(const std::vector<glm::vec3>& centers, float boxSide);

  /// Builds the levels that this kind of culling needs, of the framebuffer that is bound, which all
  /// functions below draw into. They restore the state of OpenGL, and throw std::runtime_error on
  /// an error. The context must be current for them, and when the object is destroyed.
  void Build(vtkOpenGLRenderWindow* window, ParticleCulling culling);

  /// Draws all particles. Does not wait for the device.
  void Draw(const glm::dmat4& eyeToClip, ParticleCulling culling);

  /// Counts the fragments of each particle, drawn without culling, by one hardware occlusion query
  /// for each: those that pass the depth test or, if `testsDepth` is false, all of them.
  std::vector<unsigned int> CountFragments(const glm::dmat4& eyeToClip, bool testsDepth);

  /// Reads what the vertex stage finds of each particle.
  std::vector<Finding> Find(const glm::dmat4& eyeToClip, ParticleCulling culling);

private:
  int GetCount() const { return static_cast<int>(this->Centers.size()); }
  bool IsOfBoxes() const { return this->BoxSide > 0.0f; }
  vtkNBufferTexture* GetTexture(ParticleCulling culling)
  {
    return culling == ParticleCulling::MinimaFirst ? this->Extrema : this->Maxima;
  }
  template <typename Function>
  void WithProgram(
    const glm::dmat4& eyeToClip, ParticleCulling culling, int report, Function&& function);
  void Upload();
  void DrawRange(int first, int count);

  vtkOpenGLRenderWindow* Window = nullptr;
  std::vector<glm::vec3> Centers;
  float BoxSide = 0.0f;
  vtkNew<vtkNBufferTexture> Maxima;
  vtkNew<vtkNBufferTexture> Extrema; ///< Maxima and minima.
  vtkSmartPointer<vtkShaderProgram> Program;
  vtkNBufferGL::VertexArray VertexArray;
  vtkNBufferGL::Buffer Vertices;
  vtkNBufferGL::Buffer Indices;
  int Size[2] = { 0, 0 };
};

} // namespace NBufferPeers

#endif
