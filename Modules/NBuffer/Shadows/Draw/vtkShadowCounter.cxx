// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCounter.h"

#include "vtkShadowTarget.h"

#include "vtkNBufferDepthConvention.h"
#include "vtkShadowTintFS.h"
#include "vtkShadowVolumeFS.h"
#include "vtkShadowVolumeVS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr const char* CounterFailure =
  "A shader for shadow volumes does not compile on this driver. Update the driver, and report its "
  "message.";

// The polygon offset, away from the eye (see the header).
constexpr float OffsetFactor = 1.0f / 128;
constexpr float OffsetUnits = 2.0f;
/// What the fragment shader adds to the window depth instead of the units.
constexpr float OffsetByShader = 2 * OffsetUnits * 0x1p-24f;

constexpr GLenum StencilNames[2][7] = { { GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK,
                                          GL_STENCIL_FAIL, GL_STENCIL_PASS_DEPTH_FAIL,
                                          GL_STENCIL_PASS_DEPTH_PASS, GL_STENCIL_WRITEMASK },
  { GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK, GL_STENCIL_BACK_FAIL,
    GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BACK_PASS_DEPTH_PASS, GL_STENCIL_BACK_WRITEMASK } };

/// The capabilities that decide where and in which samples volumes are drawn. A Scope begins with
/// GL_MULTISAMPLE enabled and the others disabled.
constexpr GLenum CounterCapabilities[] = { GL_MULTISAMPLE, GL_SAMPLE_ALPHA_TO_COVERAGE,
  GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK, GL_DEPTH_CLAMP,
  GL_POLYGON_OFFSET_FILL };

void SetBox(const vtkNBufferRectangle& box, const int viewport[4])
{
  glScissor(viewport[0] + box.X0, viewport[1] + box.Y0, box.GetWidth(), box.GetHeight());
}

/// Where an index is in the buffer of indices.
const void* GetPlace(int index)
{
  return reinterpret_cast<const void*>(index * sizeof(unsigned int));
}

/// How triangles are drawn: by z-pass or z-fail, with or without the polygon offset, and for how
/// much rounding they are pushed in addition.
using Way = std::tuple<bool, bool, float>;

/// A range of indices, and where its triangles are drawn.
struct Piece
{
  int First;
  int Count;
  vtkNBufferRectangle Box;
};

/// The draws by the ways in which they are drawn. Pieces that follow each other in the same box are
/// one, because counts in the stencil do not depend on the order of volumes.
std::map<Way, std::vector<Piece>> GetPieces(const vtkShadowDraw* first, const vtkShadowDraw* last)
{
  std::map<Way, std::vector<Piece>> pieces;
  for (const vtkShadowDraw* draw = first; draw != last; ++draw)
  {
    const auto add = [&pieces, draw](bool isOffset, int begin, int end)
    {
      if (end <= begin)
      {
        return;
      }
      std::vector<Piece>& ofWay = pieces[{ draw->ZPass, isOffset, draw->Rounding }];
      const int first = draw->FirstIndex + begin;
      if (ofWay.empty() || !(ofWay.back().Box == draw->Box) ||
        ofWay.back().First + ofWay.back().Count != first)
      {
        ofWay.push_back({ first, 0, draw->Box });
      }
      ofWay.back().Count += end - begin;
    };
    add(true, 0, draw->NumberOfOffsetIndices);
    add(false, draw->NumberOfOffsetIndices, draw->NumberOfIndices);
  }
  return pieces;
}
}

vtkShadowCounter::vtkShadowCounter()
  : MaskPass(vtkShadowTintFS, CounterFailure)
{
}

vtkShadowCounter::Scope::Scope(vtkOpenGLRenderWindow* window, const int viewport[4])
  : ScopedPass(window)
{
  using vtkNBufferGL::GetInteger;
  // ScopedPass enables again what was enabled before.
  this->AtEnd(
    []
    {
      glDisable(GL_SCISSOR_TEST);
      glDisable(GL_STENCIL_TEST);
      glDisable(GL_DEPTH_TEST);
    });
  for (const GLenum name : CounterCapabilities)
  {
    this->AtEnd([name, on = glIsEnabled(name)] { (on ? glEnable : glDisable)(name); });
    (name == GL_MULTISAMPLE ? glEnable : glDisable)(name);
  }
  float offset[2] = { 0.0f, 0.0f };
  glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &offset[0]);
  glGetFloatv(GL_POLYGON_OFFSET_UNITS, &offset[1]);
  this->AtEnd([factor = offset[0], units = offset[1]] { glPolygonOffset(factor, units); });
  this->AtEnd([function = GetInteger(GL_DEPTH_FUNC)] { glDepthFunc(function); });
  this->AtEnd([mask = GetInteger(GL_DEPTH_WRITEMASK) != 0] { glDepthMask(mask); });
  std::array<int, 4> scissor{};
  glGetIntegerv(GL_SCISSOR_BOX, scissor.data());
  this->AtEnd([scissor] { glScissor(scissor[0], scissor[1], scissor[2], scissor[3]); });
  for (const GLenum side : { GL_FRONT, GL_BACK })
  {
    const auto& names = StencilNames[side == GL_FRONT ? 0 : 1];
    std::array<int, 7> s{};
    std::transform(std::begin(names), std::end(names), s.begin(), GetInteger);
    this->AtEnd(
      [side, s]
      {
        glStencilFuncSeparate(side, s[0], s[1], static_cast<GLuint>(s[2]));
        glStencilOpSeparate(side, s[3], s[4], s[5]);
        glStencilMaskSeparate(side, static_cast<GLuint>(s[6]));
      });
  }
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_STENCIL_TEST);
  glStencilMask(0xff);
  glDepthMask(GL_FALSE);
}

void vtkShadowCounter::ClearMask(const vtkShadowTarget& target, int mask, const int viewport[4])
{
  glBindFramebuffer(GL_FRAMEBUFFER, target.GetMaskFramebuffer(mask));
  glScissor(viewport[0], viewport[1], viewport[2], viewport[3]);
  const float lit[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, lit);
}

void vtkShadowCounter::ClearStencil(const vtkShadowTarget& target, const int viewport[4])
{
  glBindFramebuffer(GL_FRAMEBUFFER, target.GetDepthFramebuffer());
  glScissor(viewport[0], viewport[1], viewport[2], viewport[3]);
  const int none = 0;
  glClearBufferiv(GL_STENCIL, 0, &none);
}

bool vtkShadowCounter::BeginVolumes(vtkOpenGLRenderWindow* window,
  vtkSmartPointer<vtkShaderProgram>& program, const std::string& fragmentShader,
  const vtkShadowVolumeBuffer& volume, const vtkShadowDrawList::View& view, std::string& why)
{
  if (!vtkNBufferGL::UseProgram(
        window, program, vtkShadowVolumeVS, fragmentShader, CounterFailure, why))
  {
    return false;
  }
  volume.Bind(program, view);
  return true;
}

bool vtkShadowCounter::Count(vtkOpenGLRenderWindow* window, const vtkShadowTarget& target,
  const vtkShadowVolumeBuffer& volume, const vtkShadowDrawList::View& view,
  const vtkShadowDraw* first, const vtkShadowDraw* last, long long* fragments, std::string& why)
{
  vtkNBufferGL::ClearErrors();
  const bool isOffsetByShader = !vtkNBufferGL::OffsetsBeyondFarPlane();
  std::string fragmentShader; // only for the first call, which compiles it
  if (!this->VolumeProgram)
  {
    fragmentShader = vtkShadowVolumeFS;
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::NBuffer::Dec",
      isOffsetByShader ? "#define NBUFFER_SHADOW_OFFSET 1" : "#define NBUFFER_SHADOW_OFFSET 0");
  }
  if (!this->BeginVolumes(window, this->VolumeProgram, fragmentShader, volume, view, why))
  {
    return false;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, target.GetDepthFramebuffer());

  glEnable(GL_DEPTH_CLAMP);
  glPolygonOffset(OffsetFactor, OffsetUnits);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(vtkNBufferDepthConvention::PassIfNearer);
  const vtkNBufferRectangle everywhere = { 0, 0, view.Viewport[2], view.Viewport[3] };
  const std::map<Way, std::vector<Piece>> pieces = GetPieces(first, last);
  glStencilFunc(GL_ALWAYS, 0, 0xff);
  const auto setState = [&](const Way& way)
  {
    const auto [zPass, isOffset, rounding] = way;
    (zPass ? glDisable : glEnable)(GL_CLIP_DISTANCE0);
    if (zPass)
    {
      glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
      glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    }
    else
    {
      glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
      glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    }
    this->VolumeProgram->SetUniformf("push", static_cast<float>(view.GetPush(rounding)));
    if (isOffsetByShader)
    {
      this->VolumeProgram->SetUniformf("factor", isOffset ? OffsetFactor : 0.0f);
      this->VolumeProgram->SetUniformf("bias", isOffset ? OffsetByShader : 0.0f);
    }
    else
    {
      (isOffset ? glEnable : glDisable)(GL_POLYGON_OFFSET_FILL);
    }
  };
  const auto drawAll = [&]
  {
    for (const auto& [way, ofWay] : pieces)
    {
      setState(way);
      std::vector<GLsizei> counts; // of what is drawn into the whole viewport, by one call
      std::vector<const void*> places;
      for (const auto& [first, count, box] : ofWay)
      {
        if (box == everywhere)
        {
          counts.push_back(count);
          places.push_back(GetPlace(first));
        }
        else
        {
          SetBox(box, view.Viewport);
          glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, GetPlace(first));
        }
      }
      SetBox(everywhere, view.Viewport);
      if (!counts.empty())
      {
        glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, places.data(),
          static_cast<GLsizei>(counts.size()));
      }
    }
  };
  drawAll();
  if (fragments)
  {
    glDepthFunc(GL_ALWAYS);
    glStencilMask(0);
    glBeginQuery(GL_SAMPLES_PASSED, this->Query.Create());
    drawAll();
    glEndQuery(GL_SAMPLES_PASSED);
    glStencilMask(0xff);
    GLuint samples = 0;
    glGetQueryObjectuiv(this->Query.GetName(), GL_QUERY_RESULT, &samples);
    *fragments += samples;
  }
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
  glDisable(GL_CLIP_DISTANCE0);
  return vtkNBufferGL::CheckErrors("Drawing shadow volumes", why);
}

bool vtkShadowCounter::Show(vtkOpenGLRenderWindow* window, const vtkShadowVolumeBuffer& volume,
  const vtkShadowDrawList::View& view, const std::vector<vtkShadowDraw>& draws, bool edges,
  std::string& why)
{
  if (!this->BeginVolumes(window, this->TintProgram, vtkShadowTintFS, volume, view, why))
  {
    return false;
  }
  constexpr float zPass[4] = { 0.2f, 0.6f, 1.0f, 0.8f };
  constexpr float zFail[4] = { 1.0f, 0.55f, 0.1f, 0.8f };
  constexpr float one[4] = { 1.0f / 255, 1.0f / 255, 1.0f / 255, 1.0f / 255 };
  // Edges replace what they cover.
  const vtkNBufferGL::ScopedBlend blend(GL_FUNC_ADD, GL_ONE, edges ? GL_ZERO : GL_ONE);
  glPolygonMode(GL_FRONT_AND_BACK, edges ? GL_LINE : GL_FILL);
  glEnable(GL_DEPTH_CLAMP);
  glEnable(GL_SCISSOR_TEST);
  for (const vtkShadowDraw& draw : draws)
  {
    this->TintProgram->SetUniform4f("tint", !edges ? one : draw.ZPass ? zPass : zFail);
    (draw.ZPass ? glDisable : glEnable)(GL_CLIP_DISTANCE0);
    SetBox(draw.Box, view.Viewport);
    glDrawElements(GL_TRIANGLES, draw.NumberOfIndices, GL_UNSIGNED_INT, GetPlace(draw.FirstIndex));
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_CLAMP);
  glDisable(GL_CLIP_DISTANCE0);
  return vtkNBufferGL::CheckErrors("Showing shadow volumes", why);
}

bool vtkShadowCounter::Resolve(vtkOpenGLRenderWindow* window, const vtkShadowTarget& target,
  int mask, int channel, const int viewport[4], std::string& why)
{
  vtkNBufferGL::ClearErrors();
  vtkShaderProgram* program = this->MaskPass.Begin(window, why);
  if (!program)
  {
    return false;
  }
  constexpr float shadow[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
  program->SetUniform4f("tint", shadow);
  glBindFramebuffer(GL_FRAMEBUFFER, target.GetMaskFramebuffer(mask));
  glScissor(viewport[0], viewport[1], viewport[2], viewport[3]);
  glStencilFunc(GL_NOTEQUAL, 0, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  // The triangle has the background's depth, so that it passes only where something was drawn.
  double range[2];
  glGetDoublev(GL_DEPTH_RANGE, range);
  glDepthRange(vtkNBufferDepthConvention::Background, vtkNBufferDepthConvention::Background);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(vtkNBufferDepthConvention::PassIfFarther);
  glColorMaski(0, channel == 0, channel == 1, channel == 2, channel == 3);
  this->MaskPass.Draw();
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_DEPTH_TEST);
  glDepthRange(range[0], range[1]);
  return vtkNBufferGL::CheckErrors("Making a shadow mask", why);
}

void vtkShadowCounter::Release()
{
  *this = vtkShadowCounter();
}
VTK_ABI_NAMESPACE_END
