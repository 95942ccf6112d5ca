// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OffscreenFixture.h
 * @brief GoogleTest fixture with an off-screen render window, or a skip that says why there is
 * none.
 *
 * The environment variable VTK_DEFAULT_OPENGL_WINDOW names the window class to test
 * (vtkOSOpenGLRenderWindow, vtkEGLRenderWindow, vtkXOpenGLRenderWindow); unset, VTK chooses.
 * VTK errors and OpenGL errors (by debug output, where the context has it) fail the test in which
 * they occur.
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
   * A new off-screen window of the class under test whose context exists and is current, with
   * debug output on. It has rendered once, empty. Sizes in pixels, 0 samples: no multisampling.
   */
  static vtkSmartPointer<vtkOpenGLRenderWindow> NewWindow(
    int width, int height, int multiSamples = 0);

  /**
   * Render `window` once and call `function` after `renderer` has drawn its props, while its
   * framebuffer, viewport and depth are still those that it drew with.
   */
  static void WhileDrawing(
    vtkRenderWindow* window, vtkRenderer* renderer, const std::function<void()>& function);

protected:
  void SetUp() override;
};

/// The same for TEST_P.
template <typename Parameter>
class OffscreenFixtureWithParam
  : public OffscreenFixture
  , public ::testing::WithParamInterface<Parameter>
{
};

#endif
