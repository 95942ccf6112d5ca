// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLStateSnapshot.h"

#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"

#include <sstream>

namespace
{
struct Query
{
  const char* Name;
  GLenum Value;
  int Count;
};
#define QUERY(name, count)                                                                         \
  Query                                                                                            \
  {                                                                                                \
#name, name, count                                                                             \
  }

const Query Capabilities[] = { QUERY(GL_BLEND, 1), QUERY(GL_COLOR_LOGIC_OP, 1),
  QUERY(GL_CULL_FACE, 1), QUERY(GL_DEPTH_CLAMP, 1), QUERY(GL_DEPTH_TEST, 1), QUERY(GL_DITHER, 1),
  QUERY(GL_FRAMEBUFFER_SRGB, 1), QUERY(GL_LINE_SMOOTH, 1), QUERY(GL_MULTISAMPLE, 1),
  QUERY(GL_POLYGON_OFFSET_FILL, 1), QUERY(GL_POLYGON_OFFSET_LINE, 1), QUERY(GL_POLYGON_SMOOTH, 1),
  QUERY(GL_PRIMITIVE_RESTART, 1), QUERY(GL_PROGRAM_POINT_SIZE, 1), QUERY(GL_RASTERIZER_DISCARD, 1),
  QUERY(GL_SAMPLE_ALPHA_TO_COVERAGE, 1), QUERY(GL_SAMPLE_ALPHA_TO_ONE, 1),
  QUERY(GL_SAMPLE_COVERAGE, 1), QUERY(GL_SAMPLE_MASK, 1), QUERY(GL_SCISSOR_TEST, 1),
  QUERY(GL_STENCIL_TEST, 1), QUERY(GL_TEXTURE_CUBE_MAP_SEAMLESS, 1), QUERY(GL_CLIP_DISTANCE0, 1),
  QUERY(GL_CLIP_DISTANCE1, 1), QUERY(GL_CLIP_DISTANCE2, 1), QUERY(GL_CLIP_DISTANCE3, 1),
  QUERY(GL_CLIP_DISTANCE4, 1), QUERY(GL_CLIP_DISTANCE5, 1) };

const Query Integers[] = { QUERY(GL_ACTIVE_TEXTURE, 1), QUERY(GL_ARRAY_BUFFER_BINDING, 1),
  QUERY(GL_BLEND_DST_ALPHA, 1), QUERY(GL_BLEND_DST_RGB, 1), QUERY(GL_BLEND_EQUATION_ALPHA, 1),
  QUERY(GL_BLEND_EQUATION_RGB, 1), QUERY(GL_BLEND_SRC_ALPHA, 1), QUERY(GL_BLEND_SRC_RGB, 1),
  QUERY(GL_CLAMP_READ_COLOR, 1), QUERY(GL_COLOR_WRITEMASK, 4), QUERY(GL_CULL_FACE_MODE, 1),
  QUERY(GL_CURRENT_PROGRAM, 1), QUERY(GL_DEPTH_FUNC, 1), QUERY(GL_DEPTH_WRITEMASK, 1),
  QUERY(GL_DRAW_BUFFER0, 1), QUERY(GL_DRAW_BUFFER1, 1), QUERY(GL_DRAW_BUFFER2, 1),
  QUERY(GL_DRAW_FRAMEBUFFER_BINDING, 1), QUERY(GL_ELEMENT_ARRAY_BUFFER_BINDING, 1),
  QUERY(GL_FRONT_FACE, 1), QUERY(GL_LOGIC_OP_MODE, 1), QUERY(GL_PACK_ALIGNMENT, 1),
  QUERY(GL_PACK_IMAGE_HEIGHT, 1), QUERY(GL_PACK_LSB_FIRST, 1), QUERY(GL_PACK_ROW_LENGTH, 1),
  QUERY(GL_PACK_SKIP_IMAGES, 1), QUERY(GL_PACK_SKIP_PIXELS, 1), QUERY(GL_PACK_SKIP_ROWS, 1),
  QUERY(GL_PACK_SWAP_BYTES, 1), QUERY(GL_PIXEL_PACK_BUFFER_BINDING, 1),
  QUERY(GL_PIXEL_UNPACK_BUFFER_BINDING, 1), QUERY(GL_POLYGON_MODE, 2), QUERY(GL_READ_BUFFER, 1),
  QUERY(GL_READ_FRAMEBUFFER_BINDING, 1), QUERY(GL_RENDERBUFFER_BINDING, 1),
  QUERY(GL_SAMPLE_COVERAGE_INVERT, 1), QUERY(GL_SCISSOR_BOX, 4), QUERY(GL_STENCIL_BACK_FAIL, 1),
  QUERY(GL_STENCIL_BACK_FUNC, 1), QUERY(GL_STENCIL_BACK_REF, 1),
  QUERY(GL_STENCIL_BACK_VALUE_MASK, 1), QUERY(GL_STENCIL_BACK_WRITEMASK, 1),
  QUERY(GL_STENCIL_FAIL, 1), QUERY(GL_STENCIL_FUNC, 1), QUERY(GL_STENCIL_REF, 1),
  QUERY(GL_STENCIL_VALUE_MASK, 1), QUERY(GL_STENCIL_WRITEMASK, 1),
  QUERY(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 1), QUERY(GL_UNIFORM_BUFFER_BINDING, 1),
  QUERY(GL_UNPACK_ALIGNMENT, 1), QUERY(GL_UNPACK_IMAGE_HEIGHT, 1), QUERY(GL_UNPACK_LSB_FIRST, 1),
  QUERY(GL_UNPACK_ROW_LENGTH, 1), QUERY(GL_UNPACK_SKIP_IMAGES, 1), QUERY(GL_UNPACK_SKIP_PIXELS, 1),
  QUERY(GL_UNPACK_SKIP_ROWS, 1), QUERY(GL_UNPACK_SWAP_BYTES, 1), QUERY(GL_VERTEX_ARRAY_BINDING, 1),
  QUERY(GL_VIEWPORT, 4) };

const Query Floats[] = { QUERY(GL_BLEND_COLOR, 4), QUERY(GL_COLOR_CLEAR_VALUE, 4),
  QUERY(GL_DEPTH_CLEAR_VALUE, 1), QUERY(GL_DEPTH_RANGE, 2), QUERY(GL_LINE_WIDTH, 1),
  QUERY(GL_POINT_SIZE, 1), QUERY(GL_POLYGON_OFFSET_FACTOR, 1), QUERY(GL_POLYGON_OFFSET_UNITS, 1),
  QUERY(GL_SAMPLE_COVERAGE_VALUE, 1) };

// Per texture unit.
const Query Bindings[] = { QUERY(GL_TEXTURE_BINDING_1D, 1), QUERY(GL_TEXTURE_BINDING_2D, 1),
  QUERY(GL_TEXTURE_BINDING_2D_ARRAY, 1), QUERY(GL_TEXTURE_BINDING_2D_MULTISAMPLE, 1),
  QUERY(GL_TEXTURE_BINDING_3D, 1), QUERY(GL_TEXTURE_BINDING_BUFFER, 1),
  QUERY(GL_TEXTURE_BINDING_CUBE_MAP, 1), QUERY(GL_TEXTURE_BINDING_RECTANGLE, 1) };

// What vtkOpenGLState remembers instead of asking.
const Query CachedIntegers[] = { QUERY(GL_VIEWPORT, 4), QUERY(GL_SCISSOR_BOX, 4),
  QUERY(GL_CULL_FACE_MODE, 1), QUERY(GL_DEPTH_FUNC, 1), QUERY(GL_BLEND_SRC_RGB, 1),
  QUERY(GL_BLEND_DST_RGB, 1), QUERY(GL_BLEND_SRC_ALPHA, 1), QUERY(GL_BLEND_DST_ALPHA, 1),
  QUERY(GL_DRAW_FRAMEBUFFER_BINDING, 1), QUERY(GL_READ_FRAMEBUFFER_BINDING, 1) };
const Query CachedCapabilities[] = { QUERY(GL_BLEND, 1), QUERY(GL_CULL_FACE, 1),
  QUERY(GL_DEPTH_TEST, 1), QUERY(GL_SCISSOR_TEST, 1), QUERY(GL_STENCIL_TEST, 1),
  QUERY(GL_DEPTH_WRITEMASK, 1) };
#undef QUERY

template <typename T>
std::string Join(const T* values, int count)
{
  std::ostringstream text;
  text.precision(9);
  for (int i = 0; i < count; ++i)
  {
    text << (i ? " " : "") << +values[i];
  }
  return text.str();
}
}

GLStateSnapshot GLStateSnapshot::Capture(vtkOpenGLRenderWindow* window)
{
  GLStateSnapshot snapshot;
  auto& values = snapshot.Values;
  GLint integers[16] = {};
  for (const Query& query : Capabilities)
  {
    values[query.Name] = glIsEnabled(query.Value) ? "on" : "off";
  }
  for (const Query& query : Integers)
  {
    glGetIntegerv(query.Value, integers);
    values[query.Name] = Join(integers, query.Count);
  }
  for (const Query& query : Floats)
  {
    GLfloat floats[16] = {};
    glGetFloatv(query.Value, floats);
    values[query.Name] = Join(floats, query.Count);
  }
  glGetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, integers);
  values["GL_SAMPLE_MASK_VALUE"] = Join(integers, 1);
  if (vtkNBufferGL::HasVersion(4, 3))
  {
    glGetIntegerv(GL_DRAW_INDIRECT_BUFFER_BINDING, integers);
    values["GL_DRAW_INDIRECT_BUFFER_BINDING"] = Join(integers, 1);
    glGetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, integers);
    values["GL_SHADER_STORAGE_BUFFER_BINDING"] = Join(integers, 1);
    for (GLuint number = 0; number < 8; ++number)
    {
      glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, number, integers);
      values["GL_SHADER_STORAGE_BUFFER_BINDING " + std::to_string(number)] = Join(integers, 1);
      GLint64 start = 0;
      glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, number, &start);
      values["GL_SHADER_STORAGE_BUFFER_START " + std::to_string(number)] = std::to_string(start);
    }
  }

  GLint active = 0;
  GLint units = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
  for (GLint unit = 0; unit < units; ++unit)
  {
    glActiveTexture(GL_TEXTURE0 + unit);
    const std::string suffix = " of unit " + std::to_string(unit);
    for (const Query& query : Bindings)
    {
      glGetIntegerv(query.Value, integers);
      values[query.Name + suffix] = Join(integers, 1);
    }
    if (vtkNBufferGL::HasVersion(3, 3))
    {
      glGetIntegerv(GL_SAMPLER_BINDING, integers);
      values["GL_SAMPLER_BINDING" + suffix] = Join(integers, 1);
    }
  }
  glActiveTexture(active);

  vtkOpenGLState* state = window->GetState();
  for (const Query& query : CachedIntegers)
  {
    state->vtkglGetIntegerv(query.Value, integers);
    values[std::string("vtkOpenGLState ") + query.Name] = Join(integers, query.Count);
  }
  for (const Query& query : CachedCapabilities)
  {
    unsigned char on = 0;
    state->vtkglGetBooleanv(query.Value, &on);
    values[std::string("vtkOpenGLState ") + query.Name] = on ? "on" : "off";
  }
  std::ostringstream shader;
  shader << static_cast<const void*>(state->GetShaderCache()->GetLastShaderBound());
  values["vtkOpenGLShaderCache LastShaderBound"] = shader.str();
  return snapshot;
}

std::string GLStateSnapshot::GetDifference(const GLStateSnapshot& other) const
{
  std::string difference;
  for (const auto& [name, value] : this->Values)
  {
    const auto found = other.Values.find(name);
    const std::string now = found == other.Values.end() ? "missing" : found->second;
    if (now != value)
    {
      difference += name + ": " + value + ", then " + now + "\n";
    }
  }
  return difference;
}

void SpoilGLState()
{
  glViewport(3, 2, 1, 1);
  glScissor(1, 1, 1, 1);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_ZERO, GL_ONE, GL_ZERO, GL_ONE);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT_AND_BACK);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_NEVER);
  glDepthMask(GL_FALSE);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_NEVER, 1, 0xFF);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_CLEAR);
  glEnable(GL_SAMPLE_MASK);
  glSampleMaski(0, 0);
  glEnable(GL_RASTERIZER_DISCARD);
  glPixelStorei(GL_PACK_ALIGNMENT, 8);
  glPixelStorei(GL_PACK_ROW_LENGTH, 7);
  glPixelStorei(GL_PACK_SKIP_ROWS, 2);
  glPixelStorei(GL_PACK_SKIP_PIXELS, 3);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 5);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
}

void UnspoilGLState()
{
  for (GLenum capability : { GL_SCISSOR_TEST, GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST,
         GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_SAMPLE_MASK, GL_RASTERIZER_DISCARD })
  {
    glDisable(capability);
  }
  glBlendFuncSeparate(GL_ONE, GL_ZERO, GL_ONE, GL_ZERO);
  glCullFace(GL_BACK);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glStencilFunc(GL_ALWAYS, 0, ~0u);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glLogicOp(GL_COPY);
  glSampleMaski(0, ~0u);
  for (GLenum parameter : { GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
         GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS })
  {
    glPixelStorei(parameter, 0);
  }
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}
