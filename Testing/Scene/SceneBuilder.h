// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SceneBuilder.h
 * @brief Writes a Scenario prop by prop and frame by frame, as a test would do it with VTK.
 *
 *     SceneBuilder scene;
 *     scene.Floor(5.0);
 *     const int door = scene.Box({ 0.0, 0.0, 1.0 }, { 1.0, 0.1, 2.0 }).Id;
 *     scene.Look({ 0.0, -9.0, 3.0 }, { 0.0, 0.0, 1.0 });
 *     scene.NextFrame();
 *     scene.Move(door, { 2.0, 0.0, 0.0 });
 */
#ifndef SceneBuilder_h
#define SceneBuilder_h

#include "Scenario.h"
#include "Shapes.h"

#include <vector>

namespace TestScene
{
/// Where the wall scene keeps what.
struct Wall
{
  static constexpr int Index = 0;       ///< The wall itself.
  static constexpr int FirstBehind = 1; ///< Boxes that the wall hides wholly.
  static constexpr int Behind = 60;     ///< How many of them.
  static constexpr int FirstInFront = FirstBehind + Behind;
  static constexpr int InFront = 12; ///< Boxes between camera and wall, and beside it.
  static constexpr int Count = FirstInFront + InFront;
  /// So many are hidden at least, the first frame's guesses at the occluders apart.
  static constexpr int Hidden = Behind - 4;
};

class SceneBuilder
{
public:
  Scenario Scene;
  bool UsesDoubles = false; ///< For the points of all props that are added from now on.

  /// @name Props
  /// Each has a colour that follows from its number. References are good until the next prop.
  ///@{
  Prop& Add(ShapeKind kind, const glm::dvec3& center, const glm::dvec3& size, int detail = 1);
  Prop& Box(const glm::dvec3& center, const glm::dvec3& size);
  /// An upright rectangle, normal z, of cells x cells quads. It is unlit, so that only its colour
  /// tells it from others.
  Prop& Quad(double x0, double y0, double x1, double y1, double z, int cells = 1);
  Prop& Sphere(const glm::dvec3& center, double radius, int resolution = 16);
  Prop& Mesh(const std::vector<glm::dvec3>& points, const std::vector<std::vector<int>>& polygons);
  /// The parallelogram at a corner with these two sides, one polygon.
  Prop& Sheet(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v);
  /// The square [-halfSize, halfSize]^2 at height z, one polygon.
  Prop& Floor(double halfSize, double z = 0.0);
  /// A wall at z = 0 across most of the view, boxes behind and before it; see Wall.
  void AddWall(int renderer = 0);
  /// Quads that cover each other at exactly the same depths, and a door before them, anywhere in
  /// the list. Returns the door's Id.
  int AddTies(unsigned int seed, bool large);
  ///@}

  /// @name Lights
  ///@{
  Light& Directional(const glm::dvec3& direction);
  /// `cone` is VTK's cone angle: from the axis to the cone's surface, in degrees.
  Light& Spot(const glm::dvec3& position, const glm::dvec3& focalPoint, double cone);
  Light& PointLight(const glm::dvec3& position);
  ///@}

  /// @name From this frame on
  ///@{
  /// The camera, with the clipping range of the scene. What is not given is as in the view before.
  View& LookFrom(const glm::dvec3& eye, const glm::dvec3& focalPoint = { 0.0, 0.0, 0.0 });
  /// The same with z up, or y if it looks straight down.
  View& Look(const glm::dvec3& eye, const glm::dvec3& focalPoint, double viewAngle = 40.0);
  /// The same with parallel projection; `scale` is half the height of the view.
  View& LookParallel(const glm::dvec3& eye, const glm::dvec3& focalPoint, double scale);
  /// The wall scene's camera at (0, 0, 20), moved a little sideways.
  View& LookAtWall(double shift = 0.0);
  /// A parallel camera in which a unit of x and y is a pixel of the window, (0, 0) is its lower
  /// left corner, and z from 99 to -101 becomes a window depth from 0 to 1.
  View& LookAtPixels(double shiftX = 0.0, double shiftY = 0.0);
  void Move(int prop, const glm::dvec3& position);
  void Change(ChangeKind kind, int target, std::vector<double> values);
  ///@}

  /// What follows belongs to the next frame. The first one has number 0.
  void NextFrame() { ++this->Scene.Frames; }
  int GetFrame() const { return this->Scene.Frames - 1; }
  int GetNumberOfProps() const { return static_cast<int>(this->Scene.Props.size()); }
};

/// The data of SceneBuilder::Mesh(), with points in double precision.
vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<glm::dvec3>& points, const std::vector<std::vector<int>>& polygons);
}

#endif
