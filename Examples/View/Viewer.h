// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class Viewer
 * @brief A scene in a window: what the keys do, and the text that says so.
 */
#ifndef Viewer_h
#define Viewer_h

#include "Comparison.h"
#include "CulledParts.h"
#include "HoverName.h"
#include "Keys.h"
#include "LevelInset.h"
#include "Panel.h"
#include "SunShadows.h"
#include "View.h"

#include "vtkInteractorStyleFlight.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkRenderWindowInteractor.h"

#include <array>
#include <string>

namespace NBufferView
{

class Viewer
{
public:
  /// Without `isShown` everything is drawn in memory, and only Play() sends events. Throws
  /// std::runtime_error if there is no window.
  Viewer(const NBufferExamples::Scene& scene, std::array<int, 2> size, bool isShown);
  Viewer(const Viewer&) = delete;
  void operator=(const Viewer&) = delete;

  /// Adds what the keys do; nothing is done without a viewer, so that a help can be made before
  /// there is one.
  static void AddKeys(Keys& keys, Viewer* viewer);

  /// Plays a script (Keys::Play()).
  void Play(const std::string& script) { this->Commands.Play(script); }

  /// Handles the events of the window until the user closes it or a script has done so.
  void Run();

  /// Writes the picture of the window to a file.
  void WritePicture(const std::string& fileName);

  /// Returns how many bytes differed in all verifications so far, except for those with frozen
  /// verdicts.
  long long GetDifferingBytes() const { return this->DifferingBytes; }

private:
  void SwitchCuller();
  void SwitchFreeze();
  void SwitchCulledParts();
  void SwitchShadows();
  void MoveSun(double hours);
  void SwitchSunWalk();
  bool MoveSunOn(vtkObject* caller, unsigned long event, void* timer);
  void ShowNextLevel();
  void Verify();
  void Measure();
  void MeasureAgain();
  void UseStyle(vtkInteractorStyle* style, const std::string& message);
  void SwitchText();
  void SwitchHelp();
  void Quit();

  /// Prints a line, and shows it in the next frame.
  void Say(const std::string& message);
  void Draw();
  /// Is called before the text is drawn, when the statistics of the frame are known.
  void WriteText();

  View Where;
  Comparison Culling;
  CulledParts Red;
  LevelInset Levels;
  SunShadows Shadows;
  Panel Text;
  HoverName Names;
  Keys Commands;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> Orbit;
  vtkNew<vtkInteractorStyleFlight> Flight;
  std::string Message;
  long long DifferingBytes = 0;
  int SunTimer = 0;
  bool HasText = true;
  bool HasHelp = false;
  bool IsOver = false;
};

} // namespace NBufferView

#endif
