// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeakScene.h
 * @brief A wall with boxes behind it, and weak pointers that show which of its objects still live.
 */
#ifndef LeakScene_h
#define LeakScene_h

#include "vtkActor.h"
#include "vtkOpenGLRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <vector>

namespace LeakScene
{
/// The number of opaque boxes behind the wall, which hides all of them.
constexpr int BoxesBehind = 60;
/// The number of translucent boxes behind the wall. The culler does not hold these back: in the
/// renderer's list, a proxy takes the place of each.
constexpr int TranslucentBehind = 6;

/// Makes a box with its own mapper and data. `kind` 0: opaque; 1: opaque, with data that come out
/// of a filter; 2: translucent.
vtkSmartPointer<vtkActor> MakeLeakBox(double x, double y, double z, double size, int kind);

/// Adds the wall and the boxes, and puts the camera in front of the wall. Only the renderer refers
/// to the props.
void Build(vtkRenderer* renderer);

/// Moves the camera to a place that depends on the frame, so that the culler tests each frame anew.
void SetCamera(vtkRenderer* renderer, int frame);

/// Weak pointers to objects.
class WeakObjects
{
public:
  /// Adds an object that is not there yet.
  void Add(vtkObject* object);
  int GetSize() const { return static_cast<int>(this->Objects.size()); }
  int GetNumberOfLiving() const;

private:
  std::vector<vtkWeakPointer<vtkObject>> Objects;
};

/// Returns a renderer's actors, their mappers, properties and data.
WeakObjects GetContents(vtkRenderer* renderer);

/// A renderer that records the props that the culler puts into its list for a frame: those that the
/// application did not add to the renderer.
class Renderer : public vtkOpenGLRenderer
{
public:
  static Renderer* New();
  vtkTypeMacro(Renderer, vtkOpenGLRenderer);

  const std::shared_ptr<WeakObjects>& GetForeignProps() const { return this->Foreign; }

protected:
  Renderer() = default;
  ~Renderer() override = default;

  int UpdateGeometry(vtkFrameBufferObjectBase* framebuffer) override;

private:
  ///@{
  /// PropArray is a vector, or (before VTK 9.7) a pointer with a second member for its length.
  template <typename Self>
  static int CountProps(Self*, const std::vector<vtkProp*>& props)
  {
    return static_cast<int>(props.size());
  }
  template <typename Self>
  static int CountProps(Self* self, vtkProp**)
  {
    return self->PropArrayCount;
  }
  ///@}

  std::shared_ptr<WeakObjects> Foreign = std::make_shared<WeakObjects>();
};
}

#endif
