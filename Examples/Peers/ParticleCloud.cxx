// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParticleCloud.h"

#include "PeerParticleFS.h"
#include "PeerParticleVS.h"

#include "PeerErrors.h"
#include "vtkNBufferFullScreenPass.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferQuery.h"

#include "vtkOpenGLRenderWindow.h"

#include <cmath>

namespace NBufferPeers
{
namespace
{
constexpr int CornersOfBox = 8;
constexpr int IndicesOfBox = 36;

/// Corner i of a box is at x, y and z by bits 0, 1 and 2 of i; faces are seen counter-clockwise.
constexpr unsigned int BoxTriangles[IndicesOfBox] = { 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5,
  0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6 };

/// The depth of a sprite's fragments differs from that of its vertex by a few roundings of 2^-24.
constexpr float Slack = 0x1p-20f;

template <typename T>
void SetData(GLenum target, vtkNBufferGL::Buffer& buffer, const std::vector<T>& values)
{
  glBindBuffer(target, buffer.Create());
  glBufferData(
    target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}
}

void ParticleCloud::Set(const std::vector<glm::vec3>& centers, float boxSide)
{
  this->Centers = centers;
  this->BoxSide = boxSide;
  this->VertexArray.Delete();
}

void ParticleCloud::Build(vtkOpenGLRenderWindow* window, ParticleCulling culling)
{
  this->Window = window;
  // The paper needs the first few levels for sprites only. Boxes may have any size.
  const int levels = this->IsOfBoxes() ? 99 : SpriteLevel + 1;
  vtkNBufferTexture* texture = this->GetTexture(culling);
  texture->SetBothExtrema(culling == ParticleCulling::MinimaFirst);
  ThrowUnless(texture->Build(window, 1, levels, vtkNBufferExtremum::Maximum), texture->GetError());
  this->Size[0] = texture->GetWidth();
  this->Size[1] = texture->GetHeight();
}

void ParticleCloud::Upload()
{
  // A box has its centre at each corner.
  std::vector<glm::vec3> vertices;
  std::vector<unsigned int> indices;
  for (const glm::vec3& center : this->Centers)
  {
    const auto first = static_cast<unsigned int>(vertices.size());
    vertices.insert(vertices.end(), this->IsOfBoxes() ? CornersOfBox : 1, center);
    for (int i = 0; this->IsOfBoxes() && i < IndicesOfBox; ++i)
    {
      indices.push_back(first + BoxTriangles[i]);
    }
  }
  glBindVertexArray(this->VertexArray.Create());
  SetData(GL_ARRAY_BUFFER, this->Vertices, vertices);
  SetData(GL_ELEMENT_ARRAY_BUFFER, this->Indices, indices);
  const auto attribute =
    static_cast<GLuint>(glGetAttribLocation(this->Program->GetHandle(), "center"));
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
}

template <typename Function>
void ParticleCloud::WithProgram(
  const glm::dmat4& eyeToClip, ParticleCulling culling, int report, Function&& function)
{
  vtkNBufferGL::ClearErrors();
  const vtkNBufferGL::ScopedPass pass(this->Window);
  std::string text = PeerParticleVS;
  vtkShaderProgram::Substitute(text, "//VTK::NBuffer::Query", vtkNBufferQuery);
  std::string why;
  vtkShaderProgram* program = vtkNBufferGL::UseProgram(this->Window, this->Program, text.c_str(),
    PeerParticleFS, "the shader of particles does not compile on this driver", why);
  ThrowUnless(program, why);
  const int side = static_cast<int>(std::ceil(std::sqrt(this->Centers.size())));
  vtkNBufferGL::SetMatrix(program, "eyeToClip", eyeToClip);
  program->SetUniform2i("shape.size", this->Size);
  program->SetUniformi("shape.factor", 1);
  vtkNBufferTexture* texture = this->GetTexture(culling);
  program->SetUniformi("shape.levels", texture->GetNumberOfLevels());
  program->SetUniformi("shape.minima", texture->GetBothExtrema());
  program->SetUniformi("spriteLevel", this->IsOfBoxes() ? -1 : SpriteLevel);
  program->SetUniformf("boxSide", this->BoxSide);
  program->SetUniformf("slack", Slack);
  program->SetUniformi("culling", static_cast<int>(culling));
  program->SetUniformi("report", report);
  program->SetUniformi("count", side);
  program->SetUniformi("even", 1);
  program->SetUniformi("odd", 2);
  const auto bind = [&](bool isBound)
  {
    for (int i = 0; i < 2; ++i)
    {
      glActiveTexture(GL_TEXTURE1 + i);
      glBindTexture(GL_TEXTURE_2D_ARRAY, isBound ? texture->GetHandle(i) : 0);
    }
    glActiveTexture(GL_TEXTURE0);
  };
  const int buffer = vtkNBufferGL::GetInteger(GL_ARRAY_BUFFER_BINDING);
  const int depthFunction = vtkNBufferGL::GetInteger(GL_DEPTH_FUNC);
  GLboolean depthMask = GL_TRUE;
  glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask);
  bind(true);
  if (this->VertexArray.GetName() == 0)
  {
    this->Upload();
  }
  glBindVertexArray(this->VertexArray.GetName());
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_PROGRAM_POINT_SIZE);
  if (report == 0)
  {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
  }
  function(side);
  for (GLenum capability : { GL_DEPTH_TEST, GL_CULL_FACE, GL_PROGRAM_POINT_SIZE })
  {
    glDisable(capability);
  }
  glDepthFunc(depthFunction);
  glDepthMask(depthMask);
  bind(false);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  ThrowOnErrors("Drawing particles");
}

void ParticleCloud::DrawRange(int first, int count)
{
  if (this->IsOfBoxes())
  {
    glDrawElements(GL_TRIANGLES, count * IndicesOfBox, GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(static_cast<std::size_t>(first) * IndicesOfBox * sizeof(int)));
    return;
  }
  glDrawArrays(GL_POINTS, first, count);
}

void ParticleCloud::Draw(const glm::dmat4& eyeToClip, ParticleCulling culling)
{
  this->WithProgram(eyeToClip, culling, 0, [this](int) { this->DrawRange(0, this->GetCount()); });
}

std::vector<unsigned int> ParticleCloud::CountFragments(
  const glm::dmat4& eyeToClip, bool testsDepth)
{
  std::vector<unsigned int> fragments(this->Centers.size(), 0);
  std::vector<vtkNBufferGL::Query> queries(this->Centers.size());
  this->WithProgram(eyeToClip, ParticleCulling::None, 0,
    [&](int)
    {
      glDepthFunc(testsDepth ? GL_LEQUAL : GL_ALWAYS);
      for (int i = 0; i < this->GetCount(); ++i)
      {
        glBeginQuery(GL_SAMPLES_PASSED, queries[static_cast<std::size_t>(i)].Create());
        this->DrawRange(i, 1);
        glEndQuery(GL_SAMPLES_PASSED);
      }
      for (std::size_t i = 0; i < queries.size(); ++i)
      {
        glGetQueryObjectuiv(queries[i].GetName(), GL_QUERY_RESULT, &fragments[i]);
      }
    });
  return fragments;
}

std::vector<ParticleCloud::Finding> ParticleCloud::Find(
  const glm::dmat4& eyeToClip, ParticleCulling culling)
{
  std::vector<Finding> findings(this->Centers.size());
  for (int report = 1; report <= 2; ++report)
  {
    this->WithProgram(eyeToClip, culling, report,
      [&](int side)
      {
        vtkNBufferGL::Texture texture;
        vtkNBufferGL::Framebuffer target;
        glBindTexture(GL_TEXTURE_2D, texture.Create());
        vtkNBufferGL::SetPlainSampling(GL_TEXTURE_2D);
        {
          const vtkNBufferGL::ScopedUpload upload(0);
          glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, side, side, 0, GL_RGBA, GL_FLOAT, nullptr);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, target.Create());
        glFramebufferTexture2D(
          GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.GetName(), 0);
        glViewport(0, 0, side, side);
        // Each corner of a box finds the same, at the same pixel.
        glDrawArrays(GL_POINTS, 0, this->GetCount() * (this->IsOfBoxes() ? CornersOfBox : 1));
        std::vector<glm::vec4> texels(static_cast<std::size_t>(side) * side);
        const vtkNBufferGL::ScopedReadback readback(target.GetName());
        glReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, texels.data());
        for (std::size_t i = 0; i < findings.size(); ++i)
        {
          const glm::vec4& texel = texels[i];
          if (report == 1)
          {
            findings[i].Pixels = { static_cast<int>(texel.x), static_cast<int>(texel.y),
              static_cast<int>(texel.z), static_cast<int>(texel.w) };
            continue;
          }
          findings[i].IsHidden = texel.x > 0.0f;
          findings[i].IsAccepted = texel.y > 0.0f;
          findings[i].IsTested = texel.z > 0.0f;
        }
      });
  }
  return findings;
}

} // namespace NBufferPeers
