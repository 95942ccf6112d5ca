// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeakScene.h
 * @brief A wall with boxes behind it, and weak pointers to all that its frames are made of.
 */
#ifndef LeakScene_h
#define LeakScene_h

#include "vtkNBufferVTKVersion.h"

#include "vtkActor.h"
#include "vtkCuller.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <vector>

namespace LeakScene
{
/// The wall hides them all but for what the first frame guesses.
constexpr int BoxesBehind = 60;
/// Translucent ones behind the wall; they get gates instead of being held back.
constexpr int TranslucentBehind = 6;

/// A box with a mapper and data of its own: from a pipeline (`kind` 1) or without one (0), or
/// without one and translucent (2).
vtkSmartPointer<vtkActor> MakeBox(double x, double y, double z, double size, int kind);

/// The wall, the boxes and a camera before it. The renderer alone keeps the props.
void Build(vtkRenderer* renderer);

/// Another view of it; one that differs from frame to frame is culled anew.
void SetCamera(vtkRenderer* renderer, int frame);

/**
 * The culler behind ours: it sees what ours puts into the renderer's list, and keeps weak pointers
 * to every prop there that is not the renderer's own.
 */
class Spy : public vtkCuller
{
public:
  static Spy* New();
  vtkTypeMacro(Spy, vtkCuller);

  double Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& initialized) override;

  /// How many of them were seen, and how many of those are alive.
  int GetNumberOfForeignProps() const { return static_cast<int>(this->Foreign.size()); }
  int GetNumberOfLivingForeignProps() const;

protected:
  Spy() = default;
  ~Spy() override = default;

private:
  std::vector<vtkWeakPointer<vtkProp>> Foreign;
};

/// Weak pointers to a renderer's actors, their mappers, properties and data.
class Contents
{
public:
  explicit Contents(vtkRenderer* renderer);
  int GetNumberOfObjects() const { return static_cast<int>(this->Objects.size()); }
  int GetNumberOfLivingObjects() const;
  /// Sum of their reference counts.
  int GetNumberOfReferences() const;

private:
  std::vector<vtkWeakPointer<vtkObject>> Objects;
};
}

#endif
