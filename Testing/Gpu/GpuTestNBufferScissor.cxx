// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pixels to which vtkNBufferGL::DrawIn() restricts draws.
#include "vtkNBufferGL.h"
#include "vtkNBufferScissor.h"

#include "ColorTarget.h"
#include "GLStateSnapshot.h"
#include "WindowFixture.h"

#include <algorithm>
#include <vector>

namespace
{
constexpr int ScissorWidth = 37;
constexpr int ScissorHeight = 23;

/// Colours all where drawing is allowed.
void Draw(float grey)
{
  glClearColor(grey, grey, grey, grey);
  glClear(GL_COLOR_BUFFER_BIT);
}

/// Which pixels have been drawn to, row by row.
std::vector<bool> GetDrawn(const ColorTarget& target)
{
  const std::vector<unsigned char> rgba = target.Read();
  std::vector<bool> drawn;
  for (std::size_t i = 0; i < rgba.size(); i += 4)
  {
    drawn.push_back(rgba[i] != 0);
  }
  return drawn;
}
}

using GpuTestNBufferScissor = WindowFixture;

// Hazard: what is drawn again in regions is also drawn outside of them, or is missing in them.
TEST_F(GpuTestNBufferScissor, DrawsInRegionsAlone)
{
  const vtkNBufferRectangle viewport = { 5, 3, 36, 22 };
  const std::vector<vtkNBufferRectangle> regions = { { 0, 0, 1, 1 }, { 2, 3, 9, 5 },
    { 8, 4, 20, 15 }, { 25, 10, 31, 19 } };
  for (const bool confined : { false, true })
  {
    // The scissor of whoever draws: none, or a box that cuts the regions.
    const vtkNBufferRectangle outer = confined
      ? vtkNBufferRectangle{ 8, 0, 24, 30 }
      : vtkNBufferRectangle{ 0, 0, ScissorWidth, ScissorHeight };
    const ColorTarget target(ScissorWidth, ScissorHeight);
    glDisable(GL_SCISSOR_TEST);
    Draw(0.0f);
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
        Draw(1.0f);
      });
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
    EXPECT_EQ(draws, 4);
    EXPECT_EQ(calls, 4);

    std::vector<bool> expected;
    for (const auto& [x, y] : Pixels(ScissorWidth, ScissorHeight))
    {
      const int inX = x - viewport.X0;
      const int inY = y - viewport.Y0;
      expected.push_back(IsIn(x, y, outer) &&
        std::any_of(regions.begin(), regions.end(),
          [=](const vtkNBufferRectangle& region) { return IsIn(inX, inY, region); }));
    }
    EXPECT_EQ(GetDrawn(target), expected);
  }
  glDisable(GL_SCISSOR_TEST);
}

TEST_F(GpuTestNBufferScissor, WithoutRegionsNothingIsConfined)
{
  const ColorTarget target(ScissorWidth, ScissorHeight);
  glDisable(GL_SCISSOR_TEST);
  Draw(0.0f);
  EXPECT_EQ(vtkNBufferGL::DrawIn({}, []() { Draw(1.0f); }), 1);
  EXPECT_EQ(GetDrawn(target),
    std::vector<bool>(static_cast<std::size_t>(ScissorWidth) * ScissorHeight, true));
}
