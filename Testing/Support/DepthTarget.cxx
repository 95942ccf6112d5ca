// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthTarget.h"

#include "vtkNBufferVTKVersion.h"
#include VTKNBUFFER_GL_HEADER

#include <gtest/gtest.h>

namespace
{
const char* const VertexSource = R"(#version 150
void main()
{
  vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

const char* const NoiseSource = R"(#version 150
uniform uint seed;
uint Hash(uint x)
{
  x ^= x >> 16u; x *= 0x7feb352du; x ^= x >> 15u; x *= 0x846ca68bu; x ^= x >> 16u;
  return x;
}
void main()
{
  uint pixel = uint(gl_FragCoord.y) * 65536u + uint(gl_FragCoord.x);
  uint bits = Hash(pixel ^ Hash(seed));
  float v = float(bits >> 8) / 16777216.0;
  uint kind = (pixel / 5u) % 4u;
  gl_FragDepth = kind == 0u ? v : kind == 1u ? pow(v, 8.0) : kind == 2u ? 1.0 - pow(v, 12.0)
    : float(bits & 1u);
}
)";

const char* const FetchSource = R"(#version 150
uniform sampler2D depth;
out float value;
void main() { value = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r; }
)";

const char* const FetchSampleSource = R"(#version 150
uniform sampler2DMS depth;
uniform int index;
out float value;
void main() { value = texelFetch(depth, ivec2(gl_FragCoord.xy), index).r; }
)";

/// A full-screen triangle with one fragment shader, and nothing left behind.
class Program
{
public:
  explicit Program(const char* fragmentSource)
    : Name(LinkProgram(VertexSource, fragmentSource))
  {
    glGetIntegerv(GL_CURRENT_PROGRAM, &this->Previous);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &this->PreviousArray);
    glUseProgram(this->Name);
    glGenVertexArrays(1, &this->Array);
    glBindVertexArray(this->Array);
  }
  ~Program()
  {
    glUseProgram(this->Previous);
    glBindVertexArray(this->PreviousArray);
    glDeleteVertexArrays(1, &this->Array);
    glDeleteProgram(this->Name);
  }
  Program(const Program&) = delete;
  void operator=(const Program&) = delete;

  GLint GetLocation(const char* uniform) const { return glGetUniformLocation(this->Name, uniform); }
  void Draw() const { glDrawArrays(GL_TRIANGLES, 0, 3); }

private:
  GLuint Name;
  GLuint Array = 0;
  GLint Previous = 0;
  GLint PreviousArray = 0;
};

/// The state that the draws here need; tests that care take a snapshot after filling.
void PrepareDraw()
{
  for (GLenum capability : { GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST,
         GL_SAMPLE_MASK, GL_COLOR_LOGIC_OP, GL_RASTERIZER_DISCARD })
  {
    glDisable(capability);
  }
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

bool HasStencil(GLenum format)
{
  return format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
}

void AllocateTexture(GLenum format, int width, int height)
{
  if (!HasStencil(format))
  {
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  }
  else
  {
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_DEPTH_STENCIL,
      format == GL_DEPTH24_STENCIL8 ? GL_UNSIGNED_INT_24_8 : GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
      nullptr);
  }
  // What shadow mapping would leave behind: sampled as it is, it returns comparisons.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
}
}

unsigned int LinkProgram(const char* vertexSource, const char* fragmentSource)
{
  const GLuint program = glCreateProgram();
  const auto attach = [program](GLenum type, const char* source)
  {
    const GLuint shader = glCreateShader(type);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    char log[1024] = {};
    glGetShaderInfoLog(shader, sizeof(log), nullptr, log);
    EXPECT_TRUE(compiled) << log;
    glAttachShader(program, shader);
    glDeleteShader(shader);
  };
  attach(GL_VERTEX_SHADER, vertexSource);
  attach(GL_FRAGMENT_SHADER, fragmentSource);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  EXPECT_TRUE(linked);
  return program;
}

const std::vector<TargetFormat>& GetTargetFormats()
{
  static const std::vector<TargetFormat> formats = { { "Depth16", GL_DEPTH_COMPONENT16 },
    { "Depth24", GL_DEPTH_COMPONENT24 }, { "Depth32", GL_DEPTH_COMPONENT32 },
    { "Depth32F", GL_DEPTH_COMPONENT32F }, { "Depth24Stencil8", GL_DEPTH24_STENCIL8 },
    { "Depth32FStencil8", GL_DEPTH32F_STENCIL8 } };
  return formats;
}

DepthTarget::DepthTarget(
  const TargetFormat& format, int width, int height, bool texture, int samples)
  : Texture(texture)
  , Stencil(HasStencil(format.InternalFormat))
  , Width(width)
  , Height(height)
{
  GLint maximum = 0;
  glGetIntegerv(texture ? GL_MAX_DEPTH_TEXTURE_SAMPLES : GL_MAX_SAMPLES, &maximum);
  if (samples > maximum)
  {
    return;
  }
  const GLenum point = this->Stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
  glGenFramebuffers(1, &this->Framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  if (!texture)
  {
    glGenRenderbuffers(1, &this->Attachment);
    glBindRenderbuffer(GL_RENDERBUFFER, this->Attachment);
    glRenderbufferStorageMultisample(
      GL_RENDERBUFFER, samples, format.InternalFormat, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, this->Attachment);
  }
  else
  {
    const GLenum target = samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    glGenTextures(1, &this->Attachment);
    glBindTexture(target, this->Attachment);
    if (samples > 0)
    {
      glTexImage2DMultisample(target, samples, format.InternalFormat, width, height, GL_TRUE);
    }
    else
    {
      AllocateTexture(format.InternalFormat, width, height);
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, target, this->Attachment, 0);
    glBindTexture(target, 0);
  }
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  this->Complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glGetIntegerv(GL_SAMPLES, &this->Samples);
}

DepthTarget::~DepthTarget()
{
  glDeleteFramebuffers(1, &this->Framebuffer);
  if (this->Texture)
  {
    glDeleteTextures(1, &this->Attachment);
  }
  else
  {
    glDeleteRenderbuffers(1, &this->Attachment);
  }
}

void DepthTarget::Bind(int x, int y, int width, int height) const
{
  glBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  glViewport(x, y, width, height);
}

void DepthTarget::Fill(unsigned int seed) const
{
  this->Bind(0, 0, this->Width, this->Height);
  PrepareDraw();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glDepthMask(GL_TRUE);
  const Program program(NoiseSource);
  if (this->Samples > 1)
  {
    glEnable(GL_SAMPLE_MASK);
  }
  for (int sample = 0; sample < (this->Samples > 1 ? this->Samples : 1); ++sample)
  {
    // One draw for each sample: a shader that runs per sample needs more than OpenGL 3.2.
    if (this->Samples > 1)
    {
      glSampleMaski(0, 1u << sample);
    }
    glUniform1ui(program.GetLocation("seed"), seed * 64u + static_cast<unsigned int>(sample));
    program.Draw();
  }
  glSampleMaski(0, ~0u);
  glDisable(GL_SAMPLE_MASK);
}

std::vector<float> DepthTarget::Fetch(int sample) const
{
  EXPECT_TRUE(this->Texture) << "only textures can be sampled";
  const bool multisample = this->Samples > 1;
  const GLenum target = multisample ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;

  PrepareDraw();
  glDisable(GL_DEPTH_TEST);
  glViewport(0, 0, this->Width, this->Height);
  GLuint color = 0;
  GLuint framebuffer = 0;
  glActiveTexture(GL_TEXTURE0);
  glGenTextures(1, &color);
  glBindTexture(GL_TEXTURE_2D, color);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, this->Width, this->Height, 0, GL_RED, GL_FLOAT, nullptr);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);

  const Program program(multisample ? FetchSampleSource : FetchSource);
  glBindTexture(target, this->Attachment);
  GLint mode = GL_NONE;
  if (!multisample)
  {
    glGetTexParameteriv(target, GL_TEXTURE_COMPARE_MODE, &mode);
    glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  }
  glUniform1i(program.GetLocation("depth"), 0);
  if (multisample)
  {
    glUniform1i(program.GetLocation("index"), sample);
  }
  program.Draw();
  if (!multisample)
  {
    glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, mode);
  }
  glBindTexture(target, 0);
  std::vector<float> values(static_cast<std::size_t>(this->Width) * this->Height);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, this->Width, this->Height, GL_RED, GL_FLOAT, values.data());
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(1, &color);
  return values;
}
