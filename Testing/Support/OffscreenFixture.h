// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OffscreenFixture.h
 * @brief GoogleTest fixture with an off-screen render window, or a skip that says why there is
 * none.
 *
 * The environment variable VTK_DEFAULT_OPENGL_WINDOW names the window class to test
 * (vtkOSOpenGLRenderWindow, vtkEGLRenderWindow, vtkXOpenGLRenderWindow); if it is not set, VTK
 * chooses. Errors of VTK and of OpenGL (by debug output, where the context has it) fail the test in
 * which they occur.
 *
 *     class TestSomething : public OffscreenFixture {};
 *     TEST_F(TestSomething, Works)
 *     {
 *       auto window = this->NewWindow(300, 200);
 *       window->AddRenderer(renderer);
 *       window->Render();
 *     }
 */
#ifndef OffscreenFixture_h
#define OffscreenFixture_h

#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <functional>

class vtkOpenGLRenderWindow;
class vtkRenderer;

class OffscreenFixture : public ::testing::Test
{
public:
  /**
   * Returns a new off-screen window of the class under test, which has rendered one empty frame and
   * whose context is current, with debug output on. The size is in pixels; with 0 samples there is
   * no multisampling.
   */
  static vtkSmartPointer<vtkOpenGLRenderWindow> NewWindow(
    int width, int height, int multiSamples = 0);

  /**
   * Renders `window` once, and calls `function` after `renderer` has drawn its props, while the
   * framebuffer, the viewport and the depth are still those of this renderer.
   */
  static void WhileDrawing(
    vtkRenderWindow* window, vtkRenderer* renderer, const std::function<void()>& function);

protected:
  void SetUp() override;
};

/// The fixture for tests with parameters (TEST_P).
template <typename Parameter, typename Fixture = OffscreenFixture>
class OffscreenFixtureWithParam
  : public Fixture
  , public ::testing::WithParamInterface<Parameter>
{
};

#endif
