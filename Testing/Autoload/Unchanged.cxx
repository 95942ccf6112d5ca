// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Unchanged.cxx
 * @brief A program that knows nothing of this project: `nbuffer-unchanged threads|stages`.
 */
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkCullerCollection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <string>
#include <thread>
#include <vector>

namespace
{
class OwnActor : public vtkOpenGLActor
{
public:
  static OwnActor* New();
  vtkTypeMacro(OwnActor, vtkOpenGLActor);
};
vtkStandardNewMacro(OwnActor);

/// Rows of boxes one behind the other, in a window.
class Scene
{
public:
  template <typename Actor>
  void AddBoxes(int count)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(80, 60);
    this->Window->AddRenderer(this->Renderer);
    for (int i = 0; i < count; ++i)
    {
      vtkNew<vtkCubeSource> box;
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(box->GetOutputPort());
      vtkNew<Actor> actor;
      actor->SetMapper(mapper);
      actor->SetPosition(i % 5, i / 5 % 5, i / 25 * -2);
      actor->GetProperty()->SetColor(i % 7 / 7.0, i % 11 / 11.0, i % 3 / 3.0);
      this->Renderer->AddActor(actor);
    }
  }

  void Draw(int frames)
  {
    for (int frame = 0; frame < frames; ++frame)
    {
      vtkCamera* camera = this->Renderer->GetActiveCamera();
      camera->SetPosition(2.0 + 0.05 * frame, 2.0, 12.0);
      camera->SetFocalPoint(2.0, 2.0, 0.0);
      this->Renderer->ResetCameraClippingRange();
      this->Window->Render();
    }
  }

  void RemoveBoxes() { this->Renderer->RemoveAllViewProps(); }
  void RemoveCullers() { this->Renderer->GetCullers()->RemoveAllItems(); }

private:
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

/// Three threads make, draw and delete windows of their own.
void DrawInThreads()
{
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i)
  {
    threads.emplace_back(
      []
      {
        for (int k = 0; k < 40; ++k)
        {
          Scene scene;
          scene.AddBoxes<vtkActor>(60);
          scene.Draw(2);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

/// Four frames of actors of a class of its own, three more after VTK has loaded all plug-ins again,
/// and two without any actor. The list of cullers is emptied now and then.
void DrawInStages()
{
  Scene scene;
  scene.AddBoxes<OwnActor>(300);
  scene.RemoveCullers();
  scene.Draw(4);
  scene.RemoveCullers();
  vtkObjectFactory::ReHash();
  scene.Draw(3);
  scene.RemoveBoxes();
  scene.Draw(2);
  scene.RemoveCullers();
}
}

int main(int argc, char* argv[])
{
  if (argc > 1 && argv[1] == std::string("threads"))
  {
    DrawInThreads();
  }
  else
  {
    DrawInStages();
  }
}
