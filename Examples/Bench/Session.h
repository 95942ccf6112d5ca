// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Session.h
 * @brief One offscreen window with one renderer that shows a scene, and what it is asked for.
 */
#ifndef Session_h
#define Session_h

#include "CameraPath.h"
#include "Scene.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <string>

namespace NBufferBench
{

struct SessionOptions
{
  int Width = 960;
  int Height = 720;
  int Samples = 0;
  /// osmesa, egl, glx, or default for VTK's choice.
  std::string Window = "default";
};

/// Which window system VTK's windows are of from now on; VTK before 9.4 knows one only.
void ChooseWindowSystem(const std::string& system);

class Session
{
public:
  /**
   * A session that lives until the process ends. Taking down a window costs VTK a search through
   * the buffers of all props for each of them: seconds for a city, which the end of the process
   * does for free. Throws std::runtime_error if the window system is missing or has no OpenGL.
   */
  static Session& New(const NBufferExamples::Scene& scene, const SessionOptions& options);

  Session(const Session&) = delete;
  void operator=(const Session&) = delete;

  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkRenderWindow* GetWindow() { return this->Window; }

  /// Move the camera. Everything that follows from it counts as changed, also when the pose is
  /// the one of the last frame, as if another mode had not rendered it already.
  void SetPose(const NBufferExamples::CameraPose& pose);

  /// Render, wait until the image is finished, and return the milliseconds that both took.
  double Render();

  /// RGBA bytes of the frame rendered last, row 0 at the bottom.
  void ReadPixels(vtkUnsignedCharArray* pixels);

  /// GL_RENDERER, the class of the window, and its size in pixels as in 960x720.
  std::string GetDevice();
  std::string GetWindowClass();
  std::string GetSize();

private:
  Session(const NBufferExamples::Scene& scene, const SessionOptions& options);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  double Bounds[6];
};

} // namespace NBufferBench

#endif
