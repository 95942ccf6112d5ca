// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferFullScreenPass.h
 * @brief Makes shader programs current, and runs a fragment shader for each pixel of a rectangle.
 *
 * VTK's own class, vtkOpenGLQuadHelper, is not used: it dereferences a null pointer if its shader
 * does not compile. A failure in this module must leave the image as it is without the module.
 */
#ifndef vtkNBufferFullScreenPass_h
#define vtkNBufferFullScreenPass_h

#include "vtkNBufferGLObject.h"
#include "vtkNBufferModule.h" // For export macro

#include "vtkSmartPointer.h"

#include <map>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace vtkNBufferGL
{
/**
 * Make a program of the window's shader cache the current one. The first call compiles it from the
 * two texts and sets `program`. Returns nullptr, and sets `why` to `failure`, if it does not
 * compile on this driver.
 */
VTKNBUFFER_EXPORT vtkShaderProgram* UseProgram(vtkOpenGLRenderWindow* window,
  vtkSmartPointer<vtkShaderProgram>& program, const char* vertexShader,
  const std::string& fragmentShader, const char* failure, std::string& why);

/**
 * A fragment shader that is run once for each pixel of a rectangle, by one triangle
 * (vtkNBufferFullScreenVS.glsl). To be used within a ScopedPass:
 *
 *     if (vtkShaderProgram* program = pass.Begin(window, why))
 *     {
 *       program->SetUniformi(...);
 *       pass.Draw(framebuffer, 0, 0, width, height);
 *     }
 */
class VTKNBUFFER_EXPORT FullScreenPass
{
public:
  /// The text of the fragment shader, and what is reported (cause and remedy) if it does not
  /// compile. Both must outlive the pass.
  FullScreenPass(const char* fragmentShader, const char* failure)
    : FragmentShader(fragmentShader)
    , Failure(failure)
  {
  }

  /**
   * Make the pass's program the current one; the first call compiles it. `definitions` replace
   * "//VTK::NBuffer::Dec" in the shader's text: there is one program for each set of definitions.
   * Returns nullptr, with cause and remedy in `why`, if the program does not compile.
   */
  vtkShaderProgram* Begin(
    vtkOpenGLRenderWindow* window, std::string& why, const std::string& definitions = {});

  /// Draw into the current framebuffer and viewport.
  void Draw();

  /// Draw into a rectangle of a framebuffer's pixels, which becomes the viewport.
  void Draw(unsigned int framebuffer, int x, int y, int width, int height);

  /// Delete the objects.
  void Delete(Context context = Context::Current);

private:
  const char* FragmentShader;
  const char* Failure;
  std::map<std::string, vtkSmartPointer<vtkShaderProgram>> Programs; ///< By their definitions.
  VertexArray Empty; ///< A vertex array without attributes, because the shader needs none.
};
}
VTK_ABI_NAMESPACE_END
#endif
