// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeakScene.h
 * @brief A wall with boxes behind it, and weak pointers to all that its frames are made of.
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
/// The wall hides them all, except for those that the first frame draws untested.
constexpr int BoxesBehind = 60;
/// Translucent ones behind the wall; they get gates instead of being held back.
constexpr int TranslucentBehind = 6;

/// A box with a mapper and data of its own: from a pipeline (`kind` 1) or without one (0), or
/// without one and translucent (2).
vtkSmartPointer<vtkActor> MakeLeakBox(double x, double y, double z, double size, int kind);

/// The wall, the boxes and a camera before it. The renderer alone keeps the props.
void Build(vtkRenderer* renderer);

/// Another view of it; one that differs from frame to frame is culled anew.
void SetCamera(vtkRenderer* renderer, int frame);

/// Weak pointers to the props that stood in a renderer's list without being the renderer's own:
/// those that the culler put there.
class ForeignProps
{
public:
  void Note(vtkProp* prop);
  int GetNumberOfProps() const { return static_cast<int>(this->Props.size()); }
  int GetNumberOfLivingProps() const;

private:
  std::vector<vtkWeakPointer<vtkProp>> Props;
};

/// A renderer that records them in every frame.
class Renderer : public vtkOpenGLRenderer
{
public:
  static Renderer* New();
  vtkTypeMacro(Renderer, vtkOpenGLRenderer);

  const std::shared_ptr<ForeignProps>& GetForeignProps() const { return this->Foreign; }

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

  std::shared_ptr<ForeignProps> Foreign = std::make_shared<ForeignProps>();
};

/// Weak pointers to a renderer's actors, their mappers, properties and data.
class Contents
{
public:
  explicit Contents(vtkRenderer* renderer);
  int GetNumberOfObjects() const { return static_cast<int>(this->Objects.size()); }
  int GetNumberOfLivingObjects() const;

private:
  std::vector<vtkWeakPointer<vtkObject>> Objects;
};
}

#endif
