// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where vtkNBufferGL::DrawIn() lets others draw.
#include "vtkNBufferGL.h"
#include "vtkNBufferScissor.h"

#include "GLStateSnapshot.h"
#include "WindowFixture.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <vector>

namespace
{
constexpr int Width = 37;
constexpr int Height = 23;

/// A framebuffer of one colour of its own, bound while it lives.
class Target
{
public:
  Target()
  {
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &this->Before);
    glGenRenderbuffers(1, &this->Color);
    glBindRenderbuffer(GL_RENDERBUFFER, this->Color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, Width, Height);
    glGenFramebuffers(1, &this->Framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, this->Color);
  }

  ~Target()
  {
    glBindFramebuffer(GL_FRAMEBUFFER, this->Before);
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteRenderbuffers(1, &this->Color);
  }

  /// Which pixels have been drawn to, row by row, since Clear().
  std::vector<bool> GetDrawn() const
  {
    std::vector<unsigned char> rgba(static_cast<std::size_t>(4) * Width * Height);
    glReadPixels(0, 0, Width, Height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    std::vector<bool> drawn;
    for (std::size_t i = 0; i < rgba.size(); i += 4)
    {
      drawn.push_back(rgba[i] != 0);
    }
    return drawn;
  }

  static void Clear()
  {
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  }

  /// Draws wherever drawing is allowed.
  static void Draw()
  {
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  }

private:
  GLint Before = 0;
  GLuint Framebuffer = 0;
  GLuint Color = 0;
};
}

class GpuTestNBufferScissor : public WindowFixture
{
protected:
};

// Hazard: what is drawn again in regions is drawn beside them, or left out of them.
TEST_F(GpuTestNBufferScissor, DrawsInRegionsAlone)
{
  const vtkNBufferRectangle viewport = { 5, 3, 36, 22 };
  const std::vector<vtkNBufferRectangle> regions = { { 0, 0, 1, 1 }, { 2, 3, 9, 5 },
    { 8, 4, 20, 15 }, { 25, 10, 31, 19 } };
  for (const bool confined : { false, true })
  {
    // The scissor of whoever draws: none, or a box that cuts the regions.
    const vtkNBufferRectangle outer =
      confined ? vtkNBufferRectangle{ 8, 0, 24, 30 } : vtkNBufferRectangle{ 0, 0, Width, Height };
    const Target target;
    glDisable(GL_SCISSOR_TEST);
    Target::Clear();
    glViewport(viewport.X0, viewport.Y0, viewport.GetWidth(), viewport.GetHeight());
    glScissor(outer.X0, outer.Y0, outer.GetWidth(), outer.GetHeight());
    if (confined)
    {
      glEnable(GL_SCISSOR_TEST);
    }
    int calls = 0;
    GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
    const int draws = vtkNBufferGL::DrawIn(regions,
      [&calls]()
      {
        ++calls;
        Target::Draw();
      });
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
    EXPECT_EQ(draws, 4);
    EXPECT_EQ(calls, 4);

    std::vector<bool> expected;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        expected.push_back(x >= outer.X0 && x < outer.X1 && y >= outer.Y0 && y < outer.Y1 &&
          std::any_of(regions.begin(), regions.end(),
            [&](const vtkNBufferRectangle& region)
            {
              return x >= viewport.X0 + region.X0 && x < viewport.X0 + region.X1 &&
                y >= viewport.Y0 + region.Y0 && y < viewport.Y0 + region.Y1;
            }));
      }
    }
    EXPECT_EQ(target.GetDrawn(), expected);
  }
  glDisable(GL_SCISSOR_TEST);
}

TEST_F(GpuTestNBufferScissor, WithoutRegionsNothingIsConfined)
{
  const Target target;
  glDisable(GL_SCISSOR_TEST);
  Target::Clear();
  EXPECT_EQ(vtkNBufferGL::DrawIn({}, []() { Target::Draw(); }), 1);
  EXPECT_EQ(target.GetDrawn(), std::vector<bool>(static_cast<std::size_t>(Width) * Height, true));
}
