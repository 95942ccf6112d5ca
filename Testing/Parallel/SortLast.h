// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SortLast.h
 * @brief A small replacement for vtkCompositedSynchronizedRenderers, which not every VTK has. At
 * the beginning of a frame it sends the camera of the first process to all, and at the end of the
 * frame it composites their pictures by depth on the first process.
 */
#ifndef SortLast_h
#define SortLast_h

#include "Judge.h"

#include "vtkCommand.h"
#include "vtkMultiProcessController.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

class SortLast : public vtkCommand
{
public:
  static SortLast* New() { return new SortLast; }
  vtkTypeMacro(SortLast, vtkCommand);

  /// Must be called once, on all processes.
  void Attach(vtkRenderer* renderer, vtkMultiProcessController* controller);

  /// Whether this process sends and composites, as in vtkSynchronizedRenderers. Default: true.
  void SetParallelRendering(bool on) { this->ParallelRendering = on; }

  void Execute(vtkObject* caller, unsigned long event, void* data) override;

  /// Returns the composited picture of the last frame, on the first process only.
  const TestScene::Picture& GetPicture() const { return this->Picture; }

  /// Returns the CPU time of this process in the last frame, in milliseconds, without the time for
  /// sending the camera and for compositing.
  double GetTime() const { return this->Time; }

private:
  void SendCamera();
  void Composite();

  vtkRenderer* Renderer = nullptr;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  TestScene::Picture Picture;
  double Time = 0.0;
  bool ParallelRendering = true;
};

/// Returns the CPU time that this process has used, in milliseconds.
double GetProcessTime();

#endif
