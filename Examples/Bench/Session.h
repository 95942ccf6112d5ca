// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Session.h
 * @brief One offscreen window with one renderer that shows a scene, and its images.
 */
#ifndef Session_h
#define Session_h

#include "CameraPath.h"
#include "Frames.h"
#include "Scene.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <string>
#include <vector>

class vtkCuller;
class vtkProp;

namespace NBufferBench
{

/// Writes what is being done to stderr, at most one line every few seconds.
void ShowProgress(const std::string& text);

struct SessionOptions
{
  std::array<int, 2> Size = { 960, 720 };
  int Samples = 0;
};

class Session
{
public:
  /**
   * Makes a session that lives until the process ends. When a window is destroyed, VTK searches the
   * buffers of all props for each prop, which takes seconds for a city; the end of the process
   * frees them at no cost. Throws std::runtime_error if there is no OpenGL.
   */
  static Session& New(const NBufferExamples::Scene& scene, const SessionOptions& options);

  Session(const Session&) = delete;
  void operator=(const Session&) = delete;

  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkRenderWindow* GetWindow() { return this->Window; }

  /// Returns the props of the renderer, in the order of its list.
  std::vector<vtkProp*> GetProps();

  /// Makes a culler the only one of the renderer; nullptr leaves the renderer without cullers.
  void SetCuller(vtkCuller* culler = nullptr);

  /// Moves the camera. The camera counts as changed even when the pose is the one of the last
  /// frame, because another mode may have rendered that frame.
  void SetPose(const NBufferExamples::CameraPose& pose);

  ///@{
  /// Functions of Frames.h, for the window of the session.
  double Render() { return NBufferExamples::RenderTimed(this->Window); }
  vtkSmartPointer<vtkUnsignedCharArray> ReadPixels()
  {
    return NBufferExamples::GrabPixels(this->Window);
  }
  vtkSmartPointer<vtkImageData> MakeImage(vtkUnsignedCharArray* rgba)
  {
    return NBufferExamples::MakeColorImage(this->Window, rgba);
  }
  std::string GetDevice() { return NBufferExamples::GetDevice(this->Window); }
  ///@}

  /// Returns the size of the window in pixels as in 960x720.
  std::string GetSize();

private:
  Session(const NBufferExamples::Scene& scene, const SessionOptions& options);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  double Bounds[6];
};

using NBufferExamples::WritePNG;

/// Throws std::exception if that is not possible.
void MakeFolder(const std::string& folder);

} // namespace NBufferBench

#endif
