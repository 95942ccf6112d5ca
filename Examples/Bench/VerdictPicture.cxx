// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VerdictPicture.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNBufferGLM.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTubeFilter.h"

#include <algorithm>
#include <cmath>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPose;
using NBufferExamples::Scene;

enum Group
{
  Drawn,
  Culled,
  Outside,
  Ground,
  Streets,
  NumberOfGroups
};
constexpr double Colors[NumberOfGroups][3] = { { 0.05, 0.40, 0.85 }, { 0.86, 0.20, 0.16 },
  { 0.86, 0.86, 0.85 }, { 0.93, 0.94, 0.92 }, { 0.80, 0.81, 0.80 } };

Group GetGroup(vtkNBufferVerdict verdict)
{
  return verdict == vtkNBufferVerdict::Outside ? Outside
    : verdict == vtkNBufferVerdict::Hidden     ? Culled
                                               : Drawn;
}

/// The heading of a view, level with the ground.
struct Axes
{
  glm::dvec3 Eye;
  glm::dvec3 Ahead;
  glm::dvec3 Side;
  glm::dvec3 Up = glm::dvec3(0.0);

  Axes(const CameraPose& pose, int upAxis)
    : Eye(pose.Eye)
  {
    this->Up[upAxis] = 1.0;
    this->Ahead = pose.Target - this->Eye;
    this->Ahead[upAxis] = 0.0;
    this->Ahead = glm::normalize(this->Ahead);
    this->Side = glm::cross(this->Ahead, this->Up);
  }

  glm::dvec3 GetPlace(double ahead, double side, double up) const
  {
    return this->Eye + ahead * this->Ahead + side * this->Side + up * this->Up;
  }
};

/// The sides of the view from the eye, and a ring around it, as tubes above the roofs.
vtkSmartPointer<vtkActor> MakeMarker(
  const CameraPose& pose, const Axes& axes, double aspect, double reach)
{
  const double half = aspect * std::tan(vtkMath::RadiansFromDegrees(0.5 * pose.ViewAngle));
  const double height = 0.05 * reach;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const auto add = [&](double ahead, double side)
  {
    lines->InsertCellPoint(
      points->InsertNextPoint(glm::value_ptr(axes.GetPlace(ahead, side, height))));
  };
  lines->InsertNextCell(3);
  add(1.6 * reach, -1.6 * reach * half);
  add(0.0, 0.0);
  add(1.6 * reach, 1.6 * reach * half);
  constexpr int corners = 32;
  lines->InsertNextCell(corners + 1);
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / corners;
    add(0.018 * reach * std::cos(angle), 0.018 * reach * std::sin(angle));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(data);
  tubes->SetRadius(0.004 * reach);
  tubes->SetNumberOfSides(12);
  tubes->CappingOn();
  tubes->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(tubes->GetOutput());
  auto marker = vtkSmartPointer<vtkActor>::New();
  marker->SetMapper(mapper);
  marker->GetProperty()->SetColor(0.05, 0.05, 0.05);
  marker->GetProperty()->LightingOff();
  return marker;
}

vtkSmartPointer<vtkTextActor> MakeText(const std::string& text, const double color[3], double y)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->SetPosition(14.0, y);
  vtkTextProperty* font = actor->GetTextProperty();
  font->SetFontFamilyToArial();
  font->SetFontSize(22);
  font->BoldOn();
  font->SetColor(color[0], color[1], color[2]);
  font->SetBackgroundColor(1.0, 1.0, 1.0);
  font->SetBackgroundOpacity(0.85);
  return actor;
}
}

std::string DescribeHierarchy(const vtkNBufferStatistics& statistics)
{
  if (statistics.Nodes == 0)
  {
    return "";
  }
  return "hierarchy: " + std::to_string(statistics.Nodes) + " nodes looked at for " +
    std::to_string(statistics.Props) + " props";
}

vtkSmartPointer<vtkImageData> MakeVerdictPicture(Session& session, const Scene& scene,
  const std::vector<vtkNBufferVerdict>& verdicts, const vtkNBufferStatistics& statistics,
  const CameraPose& pose, double reach)
{
  vtkNew<vtkProperty> properties[NumberOfGroups];
  for (int group = 0; group < NumberOfGroups; ++group)
  {
    properties[group]->SetColor(Colors[group][0], Colors[group][1], Colors[group][2]);
    properties[group]->SetAmbient(0.45);
    properties[group]->SetDiffuse(0.65);
  }
  int counts[NumberOfGroups] = {};
  const std::size_t buildings = scene.Plan ? scene.Plan->Buildings.size() : scene.Actors.size();
  for (std::size_t i = 0; i < scene.Actors.size(); ++i)
  {
    const Group group = GetGroup(verdicts[i]);
    ++counts[group];
    // After the buildings of a city come its ground and then its streets.
    const Group color = i < buildings ? group : i == buildings ? Ground : Streets;
    scene.Actors[i]->SetProperty(properties[color]);
  }

  vtkRenderer* renderer = session.GetRenderer();
  const int* size = session.GetWindow()->GetActualSize();
  const Axes axes(pose, scene.UpAxis);
  const vtkSmartPointer<vtkActor> marker =
    MakeMarker(pose, axes, static_cast<double>(size[0]) / size[1], reach);
  renderer->AddActor(marker);
  const double grey[3] = { 0.35, 0.35, 0.35 };
  std::vector<vtkSmartPointer<vtkTextActor>> texts = {
    MakeText(std::to_string(counts[Drawn]) + " props drawn", Colors[Drawn], 74.0),
    MakeText(std::to_string(counts[Culled]) + " culled: hidden", Colors[Culled], 44.0),
    MakeText(std::to_string(counts[Outside]) + " outside the view", grey, 14.0)
  };
  const std::string hierarchy = DescribeHierarchy(statistics);
  if (!hierarchy.empty())
  {
    texts.push_back(MakeText(hierarchy, grey, 104.0));
  }
  for (const vtkSmartPointer<vtkTextActor>& text : texts)
  {
    renderer->AddViewProp(text);
  }

  session.SetCuller();
  session.SetPose({ axes.GetPlace(-0.62 * reach, 0.0, 0.85 * reach),
    axes.GetPlace(0.42 * reach, 0.0, 0.0), axes.Up, 45.0, 0.02 * reach, 100.0 * reach });
  session.Render();
  const vtkSmartPointer<vtkImageData> image = session.MakeImage(session.ReadPixels());
  for (const vtkSmartPointer<vtkTextActor>& text : texts)
  {
    renderer->RemoveViewProp(text);
  }
  renderer->RemoveActor(marker);
  return image;
}

} // namespace NBufferBench
