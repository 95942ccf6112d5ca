// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// GoogleTest's main, but 125 (skipped, with the reason) where the window system that the
// environment asks for is missing, and VTK's messages collected from the start.
#include "CullerTest.h"

#include "vtkAutoInit.h"

#include <cstdlib>
#include <cstring>
#include <iostream>

namespace
{
constexpr int Skipped = 125;

/// Empty if a window of the class asked for works.
std::string FindFault()
{
  vtkNew<vtkRenderWindow> window;
  const char* wanted = std::getenv("VTK_DEFAULT_OPENGL_WINDOW");
  if (wanted && std::strcmp(wanted, window->GetClassName()) != 0)
  {
    return std::string(wanted) + " is not in this VTK (got " + window->GetClassName() + ")";
  }
  if (window->IsA("vtkXOpenGLRenderWindow") && !std::getenv("DISPLAY"))
  {
    return "this VTK opens X windows only, and DISPLAY is not set";
  }
  window->SetOffScreenRendering(1);
  window->SetSize(16, 16);
#if VTKNBUFFER_HAS_INITIALIZE
  window->Initialize();
#else
  window->Render();
#endif
  if (!window->SupportsOpenGL())
  {
    return std::string(window->GetClassName()) + " has no usable OpenGL: " + TakeMessages();
  }
  return "";
}
}

int main(int argc, char* argv[])
{
  testing::InitGoogleTest(&argc, argv);
  TakeMessages();
  if (!testing::GTEST_FLAG(list_tests))
  {
    const std::string fault = FindFault();
    if (!fault.empty())
    {
      std::cout << "SKIPPED: " << fault << std::endl;
      return Skipped;
    }
  }
  const int result = RUN_ALL_TESTS();
  const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
  return result == 0 && tests.skipped_test_count() > 0 && tests.successful_test_count() == 0
    ? Skipped
    : result;
}
