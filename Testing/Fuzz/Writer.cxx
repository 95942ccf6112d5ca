// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Writer.h"

#include "vtkMath.h"

#include <cmath>

namespace TestScene
{
Prop& Writer::Add(ShapeKind kind, const glm::dvec3& center, const glm::dvec3& size)
{
  Prop prop;
  prop.Id = static_cast<int>(this->Scene.Props.size());
  prop.Shape.Kind = kind;
  prop.Shape.Center = center;
  prop.Shape.Size = size;
  prop.Shape.Detail = this->Integer(1, 12);
  prop.Shape.Seed = this->Integer(0, 999);
  for (int i = 0; i < 3; ++i)
  {
    prop.Color[i] = this->Between(0.2, 1.0);
  }
  this->Scene.Props.push_back(prop);
  return this->Scene.Props.back();
}

void Writer::AddChange(int frame, ChangeKind kind, int target, std::vector<double> values)
{
  this->Scene.Changes.push_back({ frame, kind, target, std::move(values) });
}

View& Writer::AddView(int frame)
{
  View view = this->Scene.Views.empty() ? View() : this->Scene.Views.back();
  view.Frame = frame;
  this->Scene.Views.push_back(view);
  return this->Scene.Views.back();
}

void Writer::AddViewsFromFront(double width)
{
  View first;
  first.ViewAngle = this->Any({ 30.0, 30.0, 45.0, 60.0, 90.0 });
  first.Parallel = this->Chance(0.25);
  first.ParallelScale = 0.5 * width;
  const double distance = this->Chance(0.7)
    ? 0.5 * width / std::tan(vtkMath::RadiansFromDegrees(0.5 * first.ViewAngle))
    : Writer::Distance;
  first.Position = { 0.0, 0.0, distance };
  this->Scale = width;
  this->Scene.Views.push_back(first);
  const int style = this->Integer(0, 4);
  const glm::dvec3 other = { this->Between(-0.7, 0.7) * width, this->Between(-0.5, 0.5) * width,
    this->Chance(0.8) ? distance : -distance };
  for (int frame = 1; frame < this->Scene.Frames; ++frame)
  {
    switch (style)
    {
      case 0: // still
        break;
      case 1: // a walk
      {
        View& view = this->AddView(frame);
        for (int axis = 0; axis < 3; ++axis)
        {
          view.Position[axis] += this->Between(-0.02, 0.02) * width;
        }
        break;
      }
      case 2: // back and forth
        this->AddView(frame).Position = frame % 2 ? other : first.Position;
        break;
      case 3: // cuts
      {
        View& view = this->AddView(frame);
        view.Position = { this->Between(-0.8, 0.8) * width, this->Between(-0.5, 0.5) * width,
          this->Between(0.3, 1.2) * distance };
        view.FocalPoint = { this->Between(-0.2, 0.2) * width, 0.0, 0.0 };
        break;
      }
      default: // still in between
        if (this->Chance(0.5))
        {
          View& view = this->AddView(frame);
          view.Position[0] += this->Between(-0.1, 0.1) * width;
          view.FocalPoint[0] = this->Between(0.0, 1.0) < 0.5 ? 0.0 : view.Position[0];
        }
        break;
    }
  }
}
}
