// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneKinds.h"

#include "Parts.h"
#include "Random.h"

#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

namespace NBufferExamples
{
namespace
{
using Point = glm::dvec3;

// Metres.
constexpr double Length = 120.0;
constexpr double Bay = 6.0;
constexpr double RackWidth = 6.0;
constexpr double RackStep = 20.0; // from one rack to the next
constexpr double FirstLevel = 4.5;
constexpr double LevelStep = 2.2;
constexpr int Racks = 3;
constexpr int Levels = 4;
/// Of an elbow's middle line, in diameters of its pipe.
constexpr double BendRadius = 1.5;

double GetRackPlace(int rack)
{
  return (rack - 0.5 * (Racks - 1)) * RackStep;
}

/// A bend by a right angle of a pipe of diameter 1: from the origin along x, turning to y.
vtkSmartPointer<vtkPolyData> MakeElbow()
{
  constexpr int around = 12;
  constexpr int along = 6;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (int i = 0; i <= along; ++i)
  {
    const double turn = 0.5 * vtkMath::Pi() * i / along;
    for (int j = 0; j < around; ++j)
    {
      const double angle = 2.0 * vtkMath::Pi() * j / around;
      const double radius = BendRadius + 0.5 * std::cos(angle);
      points->InsertNextPoint(
        radius * std::sin(turn), BendRadius - radius * std::cos(turn), 0.5 * std::sin(angle));
      if (i < along)
      {
        const vtkIdType next = (j + 1) % around;
        const vtkIdType quad[] = { i * around + j, i * around + next, (i + 1) * around + next,
          (i + 1) * around + j };
        quads->InsertNextCell(4, quad);
      }
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(quads);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(data);
  normals->Update();
  return normals->GetOutput();
}

class PlantBuilder
{
public:
  explicit PlantBuilder(std::uint64_t seed)
    : Numbers(seed)
  {
    vtkNew<vtkCubeSource> cube;
    this->Box = MakePartMapper(cube);
    vtkNew<vtkCylinderSource> cylinder;
    cylinder->SetResolution(16);
    this->Cylinder = MakePartMapper(cylinder);
    vtkNew<vtkCylinderSource> drum;
    drum->SetResolution(48);
    this->Drum = MakePartMapper(drum);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(16);
    this->Ball = MakePartMapper(sphere);
    this->Elbow = MakePartMapper(MakeElbow());
  }

  Scene Build()
  {
    this->Result.Name = "plant (synthetic)";
    this->AddBlock({ 0.0, 0.0, -0.5 }, { Length + 20.0, 90.0, 1.0 })
      ->GetProperty()
      ->SetColor(0.6, 0.6, 0.58);
    for (int rack = 0; rack < Racks; ++rack)
    {
      this->AddSteel(GetRackPlace(rack));
      this->AddPipesOfRack(GetRackPlace(rack));
    }
    this->AddTanks();
    this->AddVessels();
    this->AddHouses();
    return std::move(this->Result);
  }

private:
  vtkActor* AddBlock(const Point& center, const Point& size)
  {
    return AddPart(this->Result, this->Box, center, size);
  }

  /// A cylinder, which VTK makes along y, along another axis.
  vtkActor* AddCylinder(
    vtkPolyDataMapper* mapper, const Point& center, int axis, double diameter, double length)
  {
    vtkActor* actor = AddPart(this->Result, mapper);
    actor->SetPosition(center[0], center[1], center[2]);
    actor->SetScale(diameter, length, diameter);
    actor->SetOrientation(axis == 2 ? 90.0 : 0.0, 0.0, axis == 0 ? 90.0 : 0.0);
    return actor;
  }

  void AddElbow(const Point& corner, const Point& from, const Point& to, double diameter)
  {
    const glm::dmat4 place(glm::dvec4(diameter * from, 0.0), glm::dvec4(diameter * to, 0.0),
      glm::dvec4(diameter * glm::cross(from, to), 0.0),
      glm::dvec4(corner - BendRadius * diameter * from, 1.0));
    vtkNew<vtkMatrix4x4> matrix;
    matrix->DeepCopy(vtkNBufferGLM::ToRows(place).data());
    AddPart(this->Result, this->Elbow)->SetUserMatrix(matrix);
  }

  /// A pipe through corners, each of which differs from the one before in one coordinate: pieces of
  /// at most a bay with flanges between them, elbows, and a valve here and there.
  void AddPipe(const std::vector<Point>& corners, double diameter)
  {
    Point last(0.0);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    {
      const Point begin = corners[i];
      const Point step = corners[i + 1] - begin;
      const int axis = step.x != 0.0 ? 0 : step.y != 0.0 ? 1 : 2;
      const double length = std::abs(step[axis]);
      const Point way = glm::sign(step);
      if (i > 0)
      {
        this->AddElbow(begin, last, way, diameter);
      }
      const double bend = BendRadius * diameter;
      const double first = i > 0 ? bend : 0.0;
      const double rest = length - first - (i + 2 < corners.size() ? bend : 0.0);
      if (rest > 0.0)
      {
        this->AddLeg(begin + first * way, way, axis, rest, diameter);
      }
      last = way;
    }
  }

  void AddLeg(const Point& begin, const Point& way, int axis, double length, double diameter)
  {
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / Bay - 1e-9)));
    const auto at = [&](double distance) { return begin + distance * way; };
    const double piece = length / pieces;
    for (int i = 0; i < pieces; ++i)
    {
      this->AddCylinder(this->Cylinder, at((i + 0.5) * piece), axis, diameter, piece);
      this->AddCylinder(this->Cylinder, at(i * piece), axis, 1.6 * diameter, 0.25 * diameter);
      if (piece > 6.0 * diameter && this->Numbers.Between(0.0, 1.0) < 0.12)
      {
        const Point place = at((i + 0.3) * piece);
        const Point up(0.0, 0.0, diameter);
        AddPart(this->Result, this->Ball, place, Point(1.9 * diameter));
        this->AddCylinder(this->Cylinder, place + up, 2, 0.3 * diameter, 2.0 * diameter);
        this->AddCylinder(this->Cylinder, place + 2.0 * up, 2, 1.6 * diameter, 0.15 * diameter);
      }
    }
  }

  void AddSteel(double y)
  {
    const double top = FirstLevel + Levels * LevelStep;
    const int bays = static_cast<int>(Length / Bay);
    for (int i = 0; i <= bays; ++i)
    {
      const double x = (i - 0.5 * bays) * Bay;
      for (double side : { -0.5, 0.5 })
      {
        this->AddBlock({ x, y + side * RackWidth, 0.5 * top }, { 0.3, 0.3, top });
        for (int level = 0; level < Levels && i < bays; ++level)
        {
          this->AddBlock(
            { x + 0.5 * Bay, y + side * RackWidth, FirstLevel + level * LevelStep - 0.15 },
            { Bay - 0.3, 0.15, 0.2 });
        }
      }
      for (int level = 0; level < Levels; ++level)
      {
        this->AddBlock(
          { x, y, FirstLevel + level * LevelStep - 0.15 }, { 0.25, RackWidth - 0.3, 0.3 });
      }
    }
  }

  void AddPipesOfRack(double y)
  {
    for (int level = 0; level < Levels; ++level)
    {
      double place = -0.5 * RackWidth + 0.3;
      while (true)
      {
        const double diameter = this->Numbers.Between(0.12, 0.6);
        place += 0.5 * diameter;
        if (place + 0.5 * diameter > 0.5 * RackWidth - 0.2)
        {
          break;
        }
        const double z = FirstLevel + level * LevelStep + 0.5 * diameter;
        const double begin = -0.5 * Length + Bay * this->Numbers.Index(5);
        const double end = 0.5 * Length - Bay * this->Numbers.Index(5) - 1.0;
        // Some leave the rack: up over the others, aside, and down.
        if (this->Numbers.Between(0.0, 1.0) < 0.35)
        {
          const double side = this->Numbers.Index(2) == 0 ? -1.0 : 1.0;
          const double over = FirstLevel + Levels * LevelStep + this->Numbers.Between(0.3, 2.5);
          const double out = y + side * (0.5 * RackWidth + this->Numbers.Between(1.5, 5.0));
          this->AddPipe({ { begin, y + place, z }, { end, y + place, z }, { end, y + place, over },
                          { end, out, over }, { end, out, 1.0 } },
            diameter);
        }
        else
        {
          this->AddPipe({ { begin, y + place, z }, { end, y + place, z } }, diameter);
        }
        place += 0.5 * diameter + this->Numbers.Between(0.08, 0.25);
      }
    }
  }

  void AddTanks()
  {
    const double y = GetRackPlace(0) - 0.5 * RackStep - 6.0;
    for (double x = -0.5 * Length + 6.0; x < 0.5 * Length - 6.0; x += 13.0)
    {
      const double diameter = this->Numbers.Between(6.0, 10.0);
      const double height = this->Numbers.Between(8.0, 15.0);
      this->AddCylinder(this->Drum, { x, y, 0.5 * height }, 2, diameter, height);
      AddPart(this->Result, this->Ball, { x, y, height }, { diameter, diameter, 0.35 * diameter });
      // To the first rack, and a ladder's rungs.
      this->AddPipe({ { x, y + 0.5 * diameter, 1.2 }, { x, GetRackPlace(0) - 6.0, 1.2 },
                      { x, GetRackPlace(0) - 6.0, 3.6 }, { x, GetRackPlace(0), 3.6 } },
        0.3);
      for (double z = 0.4; z < height; z += 0.4)
      {
        this->AddBlock({ x + 0.5 * diameter + 0.2, y, z }, { 0.04, 0.5, 0.04 });
      }
    }
  }

  void AddVessels()
  {
    for (int rack = 0; rack + 1 < Racks; ++rack)
    {
      const double y = GetRackPlace(rack) + 0.5 * RackStep + 3.2;
      for (double x = -0.5 * Length + 8.0; x < 0.5 * Length - 8.0; x += 9.0)
      {
        const double diameter = this->Numbers.Between(1.2, 2.4);
        const double length = this->Numbers.Between(4.0, 6.0);
        const double z = 0.8 + 0.5 * diameter;
        this->AddCylinder(this->Drum, { x, y, z }, 0, diameter, length);
        for (double end : { -0.5, 0.5 })
        {
          AddPart(this->Result, this->Ball, { x + end * length, y, z },
            { 0.6 * diameter, diameter, diameter });
          this->AddBlock({ x + 0.6 * end * length, y, 0.4 }, { 0.3, diameter, 0.8 });
        }
        const double up = GetRackPlace(rack + 1) - 1.0;
        this->AddPipe({ { x, y, z + 0.5 * diameter }, { x, y, 4.0 }, { x, up, 4.0 } }, 0.2);
        // A pump beside it.
        this->AddBlock({ x + 3.5, y - 1.5, 0.3 }, { 1.8, 0.8, 0.6 });
        this->AddCylinder(this->Cylinder, { x + 3.2, y - 1.5, 0.95 }, 0, 0.6, 0.9);
        this->AddCylinder(this->Cylinder, { x + 4.0, y - 1.5, 0.95 }, 0, 0.9, 0.3);
      }
    }
  }

  void AddHouses()
  {
    const double y = GetRackPlace(Racks - 1) + 0.5 * RackStep + 6.0;
    for (double x : { -40.0, 0.0, 42.0 })
    {
      const double height = this->Numbers.Between(4.0, 9.0);
      this->AddBlock({ x, y, 0.5 * height }, { this->Numbers.Between(12.0, 26.0), 9.0, height });
    }
  }

  Random Numbers;
  Scene Result;
  vtkSmartPointer<vtkPolyDataMapper> Box, Cylinder, Drum, Ball, Elbow;
};

CameraPose LookInside(int frame, int frames)
{
  const double share = static_cast<double>(frame) / frames;
  // Between the first two racks, where the vessels are not.
  const double y = GetRackPlace(0) + 0.5 * RackStep - 2.0;
  const Point eye = { (share - 0.5) * (Length - 20.0), y, 1.7 };
  // The camera looks ahead and, four times on the way, to the left and right.
  const double yaw = 1.2 * std::sin(8.0 * vtkMath::Pi() * share);
  return { eye, eye + Point(std::cos(yaw), std::sin(yaw), 0.1), { 0.0, 0.0, 1.0 }, 60.0, 0.1,
    250.0 };
}

CameraPose LookAround(int frame, int frames)
{
  const double angle = 2.0 * vtkMath::Pi() * frame / frames;
  return { { 110.0 * std::cos(angle), 80.0 * std::sin(angle), 25.0 }, { 0.0, 0.0, 5.0 },
    { 0.0, 0.0, 1.0 }, 45.0, 5.0, 300.0 };
}
}

Scene MakePlant(std::uint64_t seed)
{
  Scene scene = PlantBuilder(seed).Build();
  scene.Paths = { { "inside", MakePathOf(LookInside) }, { "around", MakePathOf(LookAround) } };
  return scene;
}

} // namespace NBufferExamples
