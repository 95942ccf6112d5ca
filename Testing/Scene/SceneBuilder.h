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
/// The indices and numbers of props in the wall scene.
struct Wall
{
  static constexpr int Index = 0;       ///< The wall itself.
  static constexpr int FirstBehind = 1; ///< The first of the boxes that the wall hides wholly.
  static constexpr int Behind = 60;     ///< The number of these boxes.
  static constexpr int FirstInFront = FirstBehind + Behind; ///< The first of the other boxes.
  static constexpr int InFront = 12; ///< The number of boxes before the wall and beside it.
  static constexpr int Count = FirstInFront + InFront; ///< The number of all props.
  /// The least number of hidden props. The first frame may draw a few untested, as occluders.
  static constexpr int Hidden = Behind - 4;
};

class SceneBuilder
{
public:
  Scenario Scene;
  bool UsesDoubles = false; ///< For the points of all props that are added from now on.

  /// @name Props
  /// The colour of a prop follows from its Id, which is its index. A reference that is returned is
  /// valid until the next prop is added.
  ///@{
  Prop& Add(ShapeKind kind, const glm::dvec3& center, const glm::dvec3& size, int detail = 1);
  Prop& Box(const glm::dvec3& center, const glm::dvec3& size);
  /// Adds a rectangle in a plane z = const, of cells x cells quads. It is unlit, so that only its
  /// colour distinguishes it from others.
  Prop& Quad(double x0, double y0, double x1, double y1, double z, int cells = 1);
  Prop& Sphere(const glm::dvec3& center, double radius, int resolution = 16);
  Prop& Mesh(const std::vector<glm::dvec3>& points, const std::vector<std::vector<int>>& polygons);
  /// Adds a parallelogram with the sides u and v at a corner, as one polygon.
  Prop& Sheet(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v);
  /// Adds the square [-halfSize, halfSize]^2 at height z, as one polygon.
  Prop& Floor(double halfSize, double z = 0.0);
  /// Adds the wall scene: a wall at z = 0 across most of the view, and boxes behind it, before it
  /// and beside it (see Wall).
  void AddWall(int renderer = 0);
  /// Adds quads that overlap at exactly equal depths, and a door before them, at random places in
  /// the list. Returns the door's Id.
  int AddTies(unsigned int seed, bool large);
  ///@}

  /// @name Lights
  ///@{
  Light& Directional(const glm::dvec3& direction);
  /// Adds a spot. `cone` is VTK's cone angle, from the axis to the edge, in degrees.
  Light& Spot(const glm::dvec3& position, const glm::dvec3& focalPoint, double cone);
  Light& PointLight(const glm::dvec3& position);
  ///@}

  /// @name Cameras and changes, from the current frame on
  ///@{
  /// Sets the camera. What is not given stays as in the view before; in the first view the clipping
  /// range is fitted to the scene.
  View& LookFrom(const glm::dvec3& eye, const glm::dvec3& focalPoint = { 0.0, 0.0, 0.0 });
  /// As LookFrom(), with z up, or y up if the camera looks along z.
  View& Look(const glm::dvec3& eye, const glm::dvec3& focalPoint, double viewAngle = 40.0);
  /// As Look(), with parallel projection; `scale` is half the height of the view.
  View& LookParallel(const glm::dvec3& eye, const glm::dvec3& focalPoint, double scale);
  /// Looks at the wall scene from (0, 0, 20), moved sideways by `shift`.
  View& LookAtWall(double shift = 0.0);
  /// Sets a parallel camera in which a unit of x and y is a pixel of the window, (0, 0) is its
  /// lower left corner, and z from 99 to -101 becomes a window depth from 0 to 1.
  View& LookAtPixels(double shiftX = 0.0, double shiftY = 0.0);
  void Move(int prop, const glm::dvec3& position);
  void Change(ChangeKind kind, int target, std::vector<double> values);
  ///@}

  /// Ends the current frame: cameras and changes that follow belong to the next one. Frames are
  /// numbered from 0 on.
  void NextFrame() { ++this->Scene.Frames; }
  int GetFrame() const { return this->Scene.Frames - 1; }
  int GetNumberOfProps() const { return static_cast<int>(this->Scene.Props.size()); }
};

/// Makes the data of SceneBuilder::Mesh(), with points in double precision.
vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<glm::dvec3>& points, const std::vector<std::vector<int>>& polygons);
}

#endif
