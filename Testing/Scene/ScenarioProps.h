// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenarioProps.h
 * @brief The props of a scenario.
 */
#ifndef ScenarioProps_h
#define ScenarioProps_h

#include "ScenarioNames.h"

#include "vtkNBufferGLM.h"

#include <vector>

namespace TestScene
{
enum class ShapeKind
{
  Box,
  Sphere,
  Quad,      ///< Upright, normal z.
  Grating,   ///< `Detail` upright bars; they fill the share `Fill` of the width.
  Lattice,   ///< `Detail` x `Detail` upright cells of which about the share `Fill` is there.
  Terrain,   ///< `Detail` x `Detail` cells with heights anywhere in the box.
  Soup,      ///< `Detail` triangles anywhere in the box.
  Lines,     ///< `Detail` segments anywhere in the box.
  Points,    ///< `Detail` vertices anywhere in the box.
  Book,      ///< `Detail` upright leaves that share an edge, the spine, wound one way and the other
             ///< by turns.
  Strip,     ///< A triangle strip of 2 x `Detail` triangles, heights anywhere in the box.
  Stack,     ///< `Detail` level quads above each other.
  Empty,     ///< No points; for an odd `Seed` not even an empty vtkPoints.
  NaNPoint,  ///< A box with a coordinate that is NaN, or infinite for an odd `Seed`.
  SharedBox, ///< A box whose eight points are shared by its faces.
  Globe,    ///< VTK's sphere with `Detail` meridians and parallels: one point at each pole, a seam.
  Cylinder, ///< VTK's cylinder along y with `Detail` sides.
  Cone,     ///< VTK's cone along x with `Detail` sides.
  Tiles,    ///< An upright rectangle of `Detail` x `Detail` quads that share their points.
  Scraps,  ///< `Detail` upright quads that overlap in three planes, shaded by normals of their own.
  Ribbons, ///< The same quads, each of them a strip.
  Mesh     ///< `Points` and `Polygons` as they are, moved to `Center` and scaled by `Size`.
};
NBUFFER_SCENE_NAMES(ShapeKind, "Box", "Sphere", "Quad", "Grating", "Lattice", "Terrain", "Soup",
  "Lines", "Points", "Book", "Strip", "Stack", "Empty", "NaNPoint", "SharedBox", "Globe",
  "Cylinder", "Cone", "Tiles", "Scraps", "Ribbons", "Mesh");

/// A mesh that fills the box of the size `Size` around `Center`.
struct Shape
{
  ShapeKind Kind = ShapeKind::Box;
  glm::dvec3 Center = { 0.0, 0.0, 0.0 };
  glm::dvec3 Size = { 1.0, 1.0, 1.0 };
  int Detail = 1;
  double Fill = 0.5;
  int Seed = 0;               ///< Of what is random. If it is odd, points are stored as doubles.
  bool CellValues = false;    ///< Whether each cell has a color, and a normal for flat shading.
  std::vector<double> Points; ///< For Mesh: three coordinates for each point.
  /// For Mesh: for each polygon the number of its points, and the indices of these. A polygon of
  /// two points is a line, one of one point a vertex.
  std::vector<double> Polygons;

  NBUFFER_SCENE_MEMBERS(Kind, Center, Size, Detail, Fill, Seed, CellValues, Points, Polygons);
};

//------------------------------------------------------------------------------------------------
enum class PropKind
{
  Actor,
  Piped,     ///< An actor whose data come out of a filter.
  DataSet,   ///< An actor with vtkDataSetMapper.
  Composite, ///< Two blocks side by side, the second one of another colour. For an odd `Seed` of
             ///< the shape it is a block within a block.
  Assembly,  ///< Two actors side by side.
  Follower,
  Glyphs, ///< The shape, small, at its own points. For an odd `Seed` of the shape each instance has
          ///< a size and an orientation of its own, and some are masked. If the seed divided by 8
          ///< leaves 4, two thirds of the instances are boxes and quads.
  Splats, ///< The points of the shape, drawn by vtkPointGaussianMapper.
  LOD,
  Volume,
  Billboard,
  Text,
  NoMapper,
  NoBounds, ///< Draws nothing and has no bounds.
  Slice     ///< An image across the middle of the shape, which blends in the opaque stage.
};
NBUFFER_SCENE_NAMES(PropKind, "Actor", "Piped", "DataSet", "Composite", "Assembly", "Follower",
  "Glyphs", "Splats", "LOD", "Volume", "Billboard", "Text", "NoMapper", "NoBounds", "Slice");

enum class Representation
{
  Points,
  Wireframe,
  Surface
};
NBUFFER_SCENE_NAMES(Representation, "Points", "Wireframe", "Surface");

enum class Translucency
{
  None,
  Some, ///< Alpha is below 1 in places.
  Opaque
};
NBUFFER_SCENE_NAMES(Translucency, "None", "Some", "Opaque");

enum class Shader
{
  Original,
  MovesVertices,
  WritesDepth
};
NBUFFER_SCENE_NAMES(Shader, "Original", "MovesVertices", "WritesDepth");

struct Prop
{
  int Id = 0; ///< What changes refer to.
  PropKind Kind = PropKind::Actor;
  TestScene::Shape Shape;
  int Renderer = 0;
  int From = 0;   ///< The first frame in which the prop is in the renderer.
  int Until = -1; ///< The first frame after that in which it is not; -1: it stays.
  glm::dvec3 Position = { 0.0, 0.0, 0.0 };
  glm::dvec3 Orientation = { 0.0, 0.0, 0.0 };
  glm::dvec3 Scale = { 1.0, 1.0, 1.0 };
  std::vector<double> UserMatrix; ///< Empty or 16.
  glm::dvec3 Color = { 1.0, 1.0, 1.0 };
  double Opacity = 1.0;
  double BackOpacity = 1.0; ///< Below 1: the opacity of the back faces alone.
  bool Visible = true;
  bool Lighting = true;
  bool Flat = false;
  TestScene::Representation Representation = TestScene::Representation::Surface;
  bool Edges = false;
  bool Vertices = false;
  bool Spheres = false;
  bool Tubes = false;
  double LineWidth = 1.0;
  double PointSize = 1.0;
  int CulledFaces = 0; ///< 0: none, 1: front faces, 2: back faces.
  bool ForceOpaque = false;
  bool ForceTranslucent = false;
  Translucency Texture = Translucency::None;
  Translucency Scalars = Translucency::None;
  TestScene::Shader Shader = TestScene::Shader::Original;
  std::vector<double> ClippingPlane; ///< Empty, or origin and normal.
  bool ShiftCoordinates = true; ///< Whether VTK uploads large coordinates relative to an origin.
  ///@{
  /// The mapper's relative polygon offset, which has an effect where such offsets are on.
  double OffsetFactor = 0.0;
  double OffsetUnits = 0.0;
  ///@}
  bool UseBounds = true; ///< vtkProp::UseBounds
  bool Casts = true;     ///< Whether the prop has the key of Shadows::CasterKeys.
  int MapperOf = -1;     ///< The Id of an earlier actor whose mapper this one shares; -1: none.
  int PartOf = -1;       ///< The Id of an earlier assembly of which this is a part; -1: none.

  NBUFFER_SCENE_MEMBERS(Id, Kind, Shape, Renderer, From, Until, Position, Orientation, Scale,
    UserMatrix, Color, Opacity, BackOpacity, Visible, Lighting, Flat, Representation, Edges,
    Vertices, Spheres, Tubes, LineWidth, PointSize, CulledFaces, ForceOpaque, ForceTranslucent,
    Texture, Scalars, Shader, ClippingPlane, ShiftCoordinates, OffsetFactor, OffsetUnits, UseBounds,
    Casts, MapperOf, PartOf);
};

/// Whether a prop has instances of several sources, which cast no shadows.
inline bool HasSeveralSources(const Prop& prop)
{
  return prop.Kind == PropKind::Glyphs && prop.Shape.Seed % 8 == 4;
}
}

#endif
