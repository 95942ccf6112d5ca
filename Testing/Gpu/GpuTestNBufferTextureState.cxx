// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The OpenGL state that vtkNBufferTexture restores, and what it allocates, refuses and releases.
#include "vtkNBufferTexture.h"

#include "DepthTarget.h"
#include "GLStateSnapshot.h"
#include "LevelComparison.h"
#include "WindowFixture.h"

#include "vtkOpenGLShaderCache.h"

#include <sstream>
#include <utility>

namespace
{
constexpr int StateWidth = 40;
constexpr int StateHeight = 26;
constexpr auto Maximum = vtkNBufferExtremum::Maximum;
}

class GpuTestNBufferTextureState : public WindowFixture
{
protected:
  /// Build and download from the bound framebuffer and compare with the host. Both reduce what
  /// samplers return, which drivers round in other ways than glReadPixels() does.
  void ExpectWorks(int width = StateWidth, int height = StateHeight)
  {
    const vtkNBufferDepthSource source = this->Inspect();
    std::vector<float> depth(static_cast<std::size_t>(width) * height);
    {
      vtkNew<vtkNBufferTexture> pixels;
      ASSERT_TRUE(pixels->Build(this->Window, source, 0, 0, width, height, 1, 1, Maximum) &&
        pixels->Download(this->Window, { { 0, 0, width, height } }, depth.data()))
        << pixels->GetError();
    }
    const std::vector<float> read = this->Read(source, { 0, 0, width, height });
    for (std::size_t i = 0; i < read.size(); ++i)
    {
      ASSERT_NEAR(depth[i], read[i], 0x1p-23) << i;
    }
    ASSERT_TRUE(
      this->Texture->Build(this->Window, source, 0, 0, width, height, 2, AllLevels, Maximum))
      << this->Texture->GetError();
    vtkNBufferLevels levels;
    ASSERT_TRUE(this->Texture->Download(this->Window, levels)) << this->Texture->GetError();
    EXPECT_EQ(FindDifference(BuildOnHost(depth, width, height, 2, Maximum), levels), "");
    EXPECT_EQ(this->Texture->GetError(), "");
  }

  /// A Build that must fail for a reason that names `word`, after one that worked.
  void ExpectFails(const vtkNBufferDepthSource& source, int x, int width, int factor, int levels,
    const std::string& word)
  {
    EXPECT_FALSE(this->Texture->Build(
      this->Window, source, x, 0, width, StateHeight, factor, levels, Maximum));
    EXPECT_NE(this->Texture->GetError().find(word), std::string::npos) << this->Texture->GetError();
    // The cause, then the remedy.
    EXPECT_NE(this->Texture->GetError().find(". "), std::string::npos);
    EXPECT_EQ(this->Texture->GetNumberOfLevels(), 0);
    EXPECT_EQ(this->Texture->GetHandle(0), 0u);
    vtkNBufferLevels levelsLeft;
    levelsLeft.Allocate(4, 4, 1, 1, Maximum);
    EXPECT_FALSE(this->Texture->Download(this->Window, levelsLeft));
    EXPECT_EQ(levelsLeft.GetNumberOfLevels(), 0);
  }

  vtkNew<vtkNBufferTexture> Texture;
};

TEST_F(GpuTestNBufferTextureState, IsPutBack)
{
  GLuint other = 0;
  glGenTextures(1, &other);
  GLuint buffers[2] = { 0, 0 };
  glGenBuffers(2, buffers);
  for (const TargetFormat& format : GetTargetFormats())
  {
    for (int kind = 0; kind < 3; ++kind)
    {
      SCOPED_TRACE(std::string(format.Name) +
        (kind == 0      ? " texture"
            : kind == 1 ? " renderbuffer"
                        : " multisampled texture"));
      const DepthTarget target(format, StateWidth, StateHeight, kind != 1, kind == 2 ? 4 : 0);
      if (!target.IsComplete())
      {
        continue;
      }
      target.Fill(2);
      const vtkNBufferDepthSource source = this->Inspect();
      std::vector<float> expected;
      if (kind == 0 && source.DepthBits == 24)
      {
        // Drivers differ in how their samplers round 24 bits.
        expected = target.Fetch();
      }
      else if (kind != 2 && source.DepthBits != 24)
      {
        expected = this->Read(source, { 0, 0, StateWidth, StateHeight });
      }
      target.Bind(0, 0, StateWidth, StateHeight);
      glActiveTexture(GL_TEXTURE0);
      glBindTexture(GL_TEXTURE_2D_ARRAY, other);
      glActiveTexture(GL_TEXTURE3);
      glBindTexture(GL_TEXTURE_2D, source.Texture && kind == 0 ? source.DepthName : 0);
      glBindBuffer(GL_PIXEL_PACK_BUFFER, buffers[0]);
      glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffers[1]);
      SpoilGLState();
      glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);

      const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
      EXPECT_TRUE(this->Texture->Build(
        this->Window, source, 0, 0, StateWidth, StateHeight, 2, AllLevels, Maximum))
        << this->Texture->GetError();
      EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
      vtkNBufferLevels levels;
      EXPECT_TRUE(this->Texture->Download(this->Window, levels)) << this->Texture->GetError();
      EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");

      glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
      glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
      UnspoilGLState();
      // The spoilt state reached no pass.
      if (!expected.empty())
      {
        EXPECT_EQ(
          FindDifference(BuildOnHost(expected, StateWidth, StateHeight, 2, Maximum), levels), "");
      }
    }
  }
  glDeleteBuffers(2, buffers);
  glDeleteTextures(1, &other);
}

TEST_F(GpuTestNBufferTextureState, IsPutBackAmidARendering)
{
  // A mapper's program is bound then, which the shader cache remembers.
  vtkNew<vtkRenderer> renderer;
  AddCone(renderer);
  this->Window->AddRenderer(renderer);
  for (const bool foreignProgram : { false, true })
  {
    WhileDrawing(this->Window, renderer,
      [&]()
      {
        ASSERT_NE(this->Window->GetShaderCache()->GetLastShaderBound(), nullptr);
        GLint program = 0;
        glGetIntegerv(GL_CURRENT_PROGRAM, &program);
        if (foreignProgram)
        {
          glUseProgram(0);
        }
        const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
        this->ExpectWorks(16, 16);
        EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
        glUseProgram(program);
      });
  }
}

TEST_F(GpuTestNBufferTextureState, DepthTextureKeepsItsParameters)
{
  const DepthTarget target(GetTargetFormats()[4], StateWidth, StateHeight, true);
  target.Fill(2);
  const vtkNBufferDepthSource source = this->Inspect();
  const GLenum names[] = { GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC, GL_TEXTURE_MIN_FILTER,
    GL_TEXTURE_MAG_FILTER, GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL };
  const auto getParameters = [&]()
  {
    std::ostringstream text;
    glBindTexture(GL_TEXTURE_2D, source.DepthName);
    for (const GLenum name : names)
    {
      GLint value = 0;
      glGetTexParameteriv(GL_TEXTURE_2D, name, &value);
      text << value << " ";
    }
    return text.str();
  };
  const std::string before = getParameters();
  ASSERT_TRUE(this->Texture->Build(
    this->Window, source, 0, 0, StateWidth, StateHeight, 4, AllLevels, Maximum));
  EXPECT_EQ(getParameters(), before);
}

TEST_F(GpuTestNBufferTextureState, TexelsOutsideAreUntouched)
{
  const float sentinel = 0.4375f;
  const DepthTarget target(GetTargetFormats()[3], StateWidth, StateHeight, true);
  target.Fill(2);
  const vtkNBufferDepthSource source = this->Inspect();
  // Room for much more than is drawn next.
  ASSERT_TRUE(
    this->Texture->Build(this->Window, source, 0, 0, StateWidth, StateHeight, 1, 5, Maximum));
  const unsigned int arrays[2] = { this->Texture->GetHandle(0), this->Texture->GetHandle(1) };
  EXPECT_NE(arrays[0], arrays[1]);
  for (int i = 0; i < 2; ++i)
  {
    const int layers = i == 0 ? 3 : 2;
    const std::vector<float> fill(
      static_cast<std::size_t>(StateWidth) * StateHeight * layers, sentinel);
    glBindTexture(GL_TEXTURE_2D_ARRAY, arrays[i]);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, StateWidth, StateHeight, layers, GL_RED,
      GL_FLOAT, fill.data());
  }
  ASSERT_TRUE(this->Texture->Build(this->Window, source, 3, 3, 20, 15, 1, 2, Maximum));
  for (int i = 0; i < 2; ++i)
  {
    ASSERT_EQ(this->Texture->GetHandle(i), arrays[i]) << "allocated again";
    const int layers = i == 0 ? 3 : 2;
    std::vector<float> texels(static_cast<std::size_t>(StateWidth) * StateHeight * layers);
    glBindTexture(GL_TEXTURE_2D_ARRAY, arrays[i]);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RED, GL_FLOAT, texels.data());
    // The layers one above the other.
    for (const auto& [x, y] : Pixels(StateWidth, StateHeight * layers))
    {
      ASSERT_EQ(texels[static_cast<std::size_t>(y) * StateWidth + x] != sentinel, x < 20 && y < 15)
        << "array " << i << " layer " << y / StateHeight << " texel (" << x << ", "
        << y % StateHeight << ")";
    }
  }
}

TEST_F(GpuTestNBufferTextureState, NothingIsAllocatedTwice)
{
  for (const std::size_t format : { 2u, 3u })
  {
    for (const bool texture : { true, false })
    {
      const DepthTarget target(GetTargetFormats()[format], StateWidth, StateHeight, texture);
      target.Fill(2);
      this->ExpectWorks();
      const int allocations = this->Texture->GetNumberOfAllocations();
      EXPECT_GE(allocations, 2);
      const int downloads = this->Texture->GetNumberOfDownloads();
      this->ExpectWorks();
      EXPECT_EQ(this->Texture->GetNumberOfDownloads(), downloads + 1);
      this->ExpectWorks(StateWidth - 7, StateHeight - 10);
      this->ExpectWorks();
      EXPECT_EQ(this->Texture->GetNumberOfAllocations(), allocations);
    }
  }
}

TEST_F(GpuTestNBufferTextureState, FailuresSayWhyAndLeaveNothing)
{
  const DepthTarget target(GetTargetFormats()[3], StateWidth, StateHeight, true);
  target.Fill(2);
  this->ExpectWorks();
  const vtkNBufferDepthSource source = this->Inspect();
  this->ExpectFails(vtkNBufferDepthSource(), 0, StateWidth, 2, 3, "no depth buffer");
  this->ExpectFails(source, 0, StateWidth, 3, 3, "factor is 3");
  this->ExpectFails(source, 0, StateWidth, 0, 3, "factor is 0");
  this->ExpectFails(source, 0, StateWidth, 2, 0, "No level");
  this->ExpectFails(source, 1, StateWidth, 2, 3, "outside");
  this->ExpectFails(source, 0, 0, 2, 3, "empty");
  this->Texture->SetAllowFloatTextures(false);
  this->ExpectFails(source, 0, StateWidth, 2, 3, "Float textures");
  this->Texture->SetAllowFloatTextures(true);
  this->ExpectWorks();

  vtkNBufferDepthSource renderbuffer = source;
  renderbuffer.Samples = 4;
  renderbuffer.Texture = false;
  this->ExpectFails(renderbuffer, 0, StateWidth, 2, 3, "Multisampled");
}

TEST_F(GpuTestNBufferTextureState, MultisampledRenderbufferIsRefused)
{
  const DepthTarget target(GetTargetFormats()[3], StateWidth, StateHeight, false, 4);
  if (target.GetSamples() < 2)
  {
    GTEST_SKIP() << "the driver offers no multisampled depth renderbuffers";
  }
  target.Fill(2);
  this->ExpectFails(this->Inspect(), 0, StateWidth, 2, 3, "Multisampled");
}

TEST_F(GpuTestNBufferTextureState, SurvivesALostContext)
{
  {
    const DepthTarget target(GetTargetFormats()[2], StateWidth, StateHeight, true);
    target.Fill(2);
    this->ExpectWorks();
  }
  this->Window->Finalize();
  EXPECT_EQ(this->Texture->GetNumberOfLevels(), 0);
  EXPECT_EQ(this->Texture->GetHandle(0), 0u);
  this->Window->Render();
  this->Window->MakeCurrent();
  const DepthTarget target(GetTargetFormats()[2], StateWidth, StateHeight, true);
  target.Fill(2);
  this->ExpectWorks();
}

TEST_F(GpuTestNBufferTextureState, IsReleasedByHand)
{
  const DepthTarget target(GetTargetFormats()[2], StateWidth, StateHeight, true);
  target.Fill(2);
  this->Texture->ReleaseGraphicsResources(this->Window);
  this->ExpectWorks();
  const unsigned int handle = this->Texture->GetHandle(0);
  EXPECT_TRUE(glIsTexture(handle));
  this->Texture->ReleaseGraphicsResources(this->Window);
  EXPECT_FALSE(glIsTexture(handle));
  EXPECT_EQ(this->Texture->GetNumberOfLevels(), 0);
  this->ExpectWorks();
  this->Texture->ReleaseGraphicsResources(nullptr);
  EXPECT_EQ(this->Texture->GetNumberOfLevels(), 0);
}

TEST_F(GpuTestNBufferTextureState, MovesBetweenWindows)
{
  auto other = NewWindow(16, 16);
  for (int turn = 0; turn < 4; ++turn)
  {
    this->Window->MakeCurrent();
    const DepthTarget target(GetTargetFormats()[3], StateWidth, StateHeight, true);
    target.Fill(2);
    this->ExpectWorks();
    vtkNBufferLevels levels;
    EXPECT_FALSE(this->Texture->Download(other, levels));
    this->ExpectWorks();
    std::swap(this->Window, other);
  }
}

TEST_F(GpuTestNBufferTextureState, OutlivesItsWindow)
{
  {
    const DepthTarget target(GetTargetFormats()[3], StateWidth, StateHeight, true);
    target.Fill(2);
    this->ExpectWorks();
  }
  this->Window = nullptr;
  EXPECT_EQ(this->Texture->GetNumberOfLevels(), 0);
  this->Texture->ReleaseGraphicsResources(nullptr);
  std::ostringstream text;
  this->Texture->Print(text);
  EXPECT_NE(text.str().find("NumberOfLevels: 0"), std::string::npos);
}
