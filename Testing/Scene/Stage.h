// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stage.h
 * @brief The window of a test: renderers, props whose draws are counted, and the culler under test.
 *
 * A stage is built by hand, prop by prop, or by a Player from a Scenario. Tests have two of them
 * that differ in one thing, the culler or the shadow pass, and let Judge.h compare them.
 */
#ifndef Stage_h
#define Stage_h

#include "vtkNBufferCuller.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <set>
#include <vector>

namespace TestScene
{
class Stage
{
public:
  /// A stage without a window.
  Stage() = default;
  /// A new off-screen window, which has not rendered yet, with one renderer that fills it.
  Stage(int width, int height, int multiSamples = 0);

  vtkSmartPointer<vtkRenderWindow> Window;
  std::vector<vtkSmartPointer<vtkRenderer>> Renderers;
  /// All props in the order in which they were added. A Player has them in the scenario's order,
  /// with nullptr for a prop that has not been in a renderer yet.
  std::vector<vtkSmartPointer<vtkProp>> Props;
  /// The scene lights of the first renderer, for tests that compare the mask of each.
  std::vector<vtkLight*> Lights;
  /// The culler under test; nullptr in a reference.
  vtkSmartPointer<vtkNBufferCuller> Culler;

  int GetNumberOfRenderers() const { return static_cast<int>(this->Renderers.size()); }
  vtkRenderer* GetRenderer(int index = 0) const { return this->Renderers[index]; }
  vtkActor* GetActor(int index) const;
  /// Returns the index of a prop in Props; -1 if it is not there.
  int FindIndex(const vtkObjectBase* prop) const;
  /// Returns the vtkNBufferCuller in a renderer's list of cullers, or nullptr.
  vtkNBufferCuller* GetCuller(int renderer = 0) const;

  /// Adds a renderer with this viewport to the window.
  vtkRenderer* AddRenderer(double x0, double y0, double x1, double y1, int layer = 0);

  /// Adds a prop to a renderer, by default to the first one. Draws of actors are counted.
  void Add(vtkProp* prop, vtkRenderer* renderer = nullptr);
  vtkActor* AddActor(vtkPolyData* data, const double color[3], vtkRenderer* renderer = nullptr);

  /// Counts the draws of an actor from now on, by the events of its mapper. Must be called again
  /// after a change of the mapper.
  void CountDraws(vtkActor* actor);
  /// Returns the number of draws of a prop since ResetDraws().
  int GetDraws(int prop) const { return *this->Draws[prop]; }
  /// Returns whether this number is right: only for actors with a polydata mapper of their own.
  bool AreDrawsCounted(int prop) const;
  /// Sets the numbers of draws of all props to 0.
  void ResetDraws();

  /// Makes the window's context current, if there is a window.
  void MakeCurrent() const;

protected:
  std::vector<std::shared_ptr<int>> Draws;
  /// The indices of props that share a mapper or are parts of an assembly.
  std::set<int> DrawnWithOthers;
};
}

#endif
