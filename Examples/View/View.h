// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class View
 * @brief A window with three renderers, one over the other, and a camera that walks.
 *
 * The first renderer draws the scene and nothing else, so that its frames can be timed and
 * compared. The second one, which has the same camera, draws marks on parts of the scene. The third
 * one draws text and insets.
 */
#ifndef View_h
#define View_h

#include "Scene.h"

#include "vtkNBufferClock.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>

namespace NBufferView
{

class View
{
public:
  /// Without `isShown` the window is drawn in memory only. Throws std::runtime_error if the window
  /// cannot be opened, or cannot be seen.
  View(const NBufferExamples::Scene& scene, std::array<int, 2> size, bool isShown);
  View(const View&) = delete;
  void operator=(const View&) = delete;

  vtkRenderWindow* GetWindow() { return this->Window; }
  vtkRenderer* GetScene() { return this->SceneRenderer; }
  vtkRenderer* GetMarks() { return this->MarkRenderer; }
  vtkRenderer* GetOverlay() { return this->OverlayRenderer; }

  /// Shows or hides everything that is not the scene itself.
  void SetDecorated(bool decorated);

  /// Moves the camera to the first pose of the path that suits the scene best.
  void GoHome();

  /// Moves the camera by a number of steps: ahead, level with the ground, and up.
  void Walk(double ahead, double up);
  /// Returns the length of a step: half a metre in a city, elsewhere a two-hundredth of the
  /// diagonal of the scene.
  double GetStep() const;

  /// Turns the camera about the axis that points up, to the left, in degrees.
  void Turn(double degrees);

  /// Draws a frame, waits until it is finished, and returns the milliseconds that the scene took.
  /// The camera counts as changed, so that the culler uses no verdicts of an earlier frame.
  double Draw();

  /// Returns the milliseconds that the scene took in the last frame, by whomever it was drawn.
  double GetLastTime() const { return this->LastTime; }

private:
  void BeginFrame();
  void BeginScene();
  void EndScene();

  const NBufferExamples::Scene& Parts;
  double Bounds[6];
  vtkNBufferClock Clock; ///< Of the frame that is being drawn.
  double LastTime = 0.0;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> SceneRenderer;
  vtkNew<vtkRenderer> MarkRenderer;
  vtkNew<vtkRenderer> OverlayRenderer;
};

} // namespace NBufferView

#endif
