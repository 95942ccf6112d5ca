// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// This is a program of its own, because an environment variable makes Mesa report OpenGL 3.1 for
// all contexts of a process. VTK still draws in them.
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

// Hazard: the version of OpenGL is older than what VTK and the culler's passes need.
TEST(CullerOldContext, DrawsEverything)
{
  ASSERT_TRUE(AsksForAnOldContext);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->Render();
  int version[2] = { 0, 0 };
  vtkOpenGLRenderWindow::SafeDownCast(window)->GetOpenGLVersion(version[0], version[1]);
  if (version[0] != 3 || version[1] != 1)
  {
    GTEST_SKIP() << "this driver gives OpenGL " << version[0] << "." << version[1]
                 << " although the environment asks Mesa for 3.1";
  }
  Scenes::ExpectFailure(Scenes::BuildWall, ComparisonOptions(), Decision::OldContext,
    { "vtkNBufferCuller draws everything (OldContext). The OpenGL context is older than 3.2. "
      "Update the driver" });
}
