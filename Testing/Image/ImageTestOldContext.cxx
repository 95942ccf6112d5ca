// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// A program of its own: Mesa gives contexts that say they are of OpenGL 3.1 while the environment
// asks for them, in which VTK still draws.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkOpenGLRenderWindow.h"

#include <cstdlib>

namespace
{
/// Before any context exists.
const bool AsksForAnOldContext = setenv("MESA_GL_VERSION_OVERRIDE", "3.1", 1) == 0 &&
  setenv("MESA_GLSL_VERSION_OVERRIDE", "150", 1) == 0;
}

// Hazard: an OpenGL older than what VTK and the culler's passes are written for.
TEST(CullerErrors, OldContext)
{
  ASSERT_TRUE(AsksForAnOldContext);
  ComparisonOptions options;
  options.KeepMessages = true;
  Comparison comparison(Scenes::BuildWall, options);
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.01 * i);
    int version[2] = { 0, 0 };
    vtkOpenGLRenderWindow::SafeDownCast(comparison.Culled.Window)
      ->GetOpenGLVersion(version[0], version[1]);
    if (version[0] != 3 || version[1] != 1)
    {
      GTEST_SKIP() << "this driver gives OpenGL " << version[0] << "." << version[1]
                   << " although the environment asks Mesa for 3.1";
    }
    EXPECT_EQ(comparison.GetDecision(), vtkNBufferDecision::OldContext);
    EXPECT_EQ(comparison.GetHidden(), 0);
    EXPECT_EQ(comparison.GetStatistics().FailedFrames, i + 1);
  }
  const std::string warning = "vtkNBufferCuller draws everything (OldContext). The OpenGL context "
                              "is older than 3.2. Update the driver";
  const std::size_t first = comparison.Messages.find(warning);
  EXPECT_NE(first, std::string::npos) << comparison.Messages;
  EXPECT_EQ(comparison.Messages.find(warning, first + 1), std::string::npos);
}
