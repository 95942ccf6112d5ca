// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View.h"

#include "CameraPath.h"
#include "Frames.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMath.h"

#include <cmath>
#include <string>

namespace NBufferView
{

View::View(const NBufferExamples::Scene& scene, std::array<int, 2> size, bool isShown)
  : Parts(scene)
{
  NBufferExamples::CheckDisplay(this->Window, isShown, "--offscreen FILE");
  this->Window->SetOffScreenRendering(isShown ? 0 : 1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(size[0], size[1]);
  this->Window->SetWindowName(("nbuffer-view " + scene.Name).c_str());
  this->Window->SetNumberOfLayers(3);
  int layer = 0;
  for (vtkRenderer* renderer :
    { this->SceneRenderer.Get(), this->MarkRenderer.Get(), this->OverlayRenderer.Get() })
  {
    renderer->SetLayer(layer++);
    this->Window->AddRenderer(renderer);
  }
  this->MarkRenderer->InteractiveOff();
  this->MarkRenderer->SetActiveCamera(this->SceneRenderer->GetActiveCamera());
  this->OverlayRenderer->InteractiveOff();
  // Far less than VTK's own, so that a camera inside the scene sees what is near.
  this->SceneRenderer->SetNearClippingPlaneTolerance(3e-5);
  scene.AddTo(this->SceneRenderer);
  scene.GetBounds().GetBounds(this->Bounds);
  NBufferExamples::PrepareWindow(this->Window);

  this->Window->AddObserver(vtkCommand::StartEvent, this, &View::BeginFrame);
  // Before and after whatever else observes the scene.
  this->SceneRenderer->AddObserver(vtkCommand::StartEvent, this, &View::BeginScene, -1.0F);
  this->SceneRenderer->AddObserver(vtkCommand::EndEvent, this, &View::EndScene, 1.0F);
  this->GoHome();
}

void View::SetDecorated(bool decorated)
{
  this->MarkRenderer->SetDraw(decorated);
  this->OverlayRenderer->SetDraw(decorated);
}

void View::GoHome()
{
  const std::string path = NBufferExamples::GetUsualPath(this->Parts);
  const NBufferExamples::CameraPath poses = NBufferExamples::MakePath(this->Parts, path, 8, 1);
  // The second pose of an orbit looks at the scene from a corner.
  const bool isOrbit = path == "orbit";
  NBufferExamples::ApplyPose(poses[isOrbit ? 1 : 0], this->Bounds, this->SceneRenderer);
  if (!isOrbit)
  {
    // Who stands in the scene orbits around what is some way ahead.
    this->SceneRenderer->GetActiveCamera()->SetDistance(60.0 * this->GetStep());
  }
}

void View::Walk(double ahead, double up)
{
  vtkCamera* camera = this->SceneRenderer->GetActiveCamera();
  const int axis = this->Parts.UpAxis;
  glm::dvec3 heading = glm::make_vec3(camera->GetDirectionOfProjection());
  heading[axis] = 0.0;
  if (glm::length(heading) < 1e-6) // The camera looks straight up or down.
  {
    heading = glm::make_vec3(camera->GetViewUp());
    heading[axis] = 0.0;
  }
  glm::dvec3 way = ahead * this->GetStep() * glm::normalize(heading);
  way[axis] = up * this->GetStep();
  const glm::dvec3 eye = glm::make_vec3(camera->GetPosition()) + way;
  const glm::dvec3 target = glm::make_vec3(camera->GetFocalPoint()) + way;
  camera->SetPosition(glm::value_ptr(eye));
  camera->SetFocalPoint(glm::value_ptr(target));
}

double View::GetStep() const
{
  return this->Parts.Plan ? 0.5 : vtkBoundingBox(this->Bounds).GetDiagonalLength() / 200.0;
}

void View::Turn(double degrees)
{
  vtkCamera* camera = this->SceneRenderer->GetActiveCamera();
  glm::dvec3 axis(0.0);
  axis[this->Parts.UpAxis] = 1.0;
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  const auto turn = [&](const glm::dvec3& way)
  {
    return std::cos(angle) * way + std::sin(angle) * glm::cross(axis, way) +
      (1.0 - std::cos(angle)) * glm::dot(axis, way) * axis;
  };
  const glm::dvec3 eye = glm::make_vec3(camera->GetPosition());
  const glm::dvec3 target = eye + turn(glm::make_vec3(camera->GetFocalPoint()) - eye);
  camera->SetFocalPoint(glm::value_ptr(target));
  camera->SetViewUp(glm::value_ptr(turn(glm::make_vec3(camera->GetViewUp()))));
}

double View::Draw()
{
  this->SceneRenderer->GetActiveCamera()->Modified();
  this->Window->Render();
  return this->LastTime;
}

void View::BeginFrame()
{
  this->SceneRenderer->ResetCameraClippingRange(this->Bounds);
}

void View::BeginScene()
{
  this->Clock.Restart();
}

void View::EndScene()
{
  this->Window->WaitForCompletion();
  this->LastTime = this->Clock.GetMilliseconds();
}

} // namespace NBufferView
