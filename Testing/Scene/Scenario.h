// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scenario.h
 * @brief Some frames of a scene as plain data: made from a seed, written as JSON, run twice.
 *
 * A member that has its default is left out of the file, so that the defaults, like the names, are
 * part of the format. Every combination of values can be run: what refers to something that is not
 * there is passed over. The shrinker relies on both.
 */
#ifndef Scenario_h
#define Scenario_h

#include "vtkNBufferGLM.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace TestScene
{
/// Names of an enumerator's values in files, ended by a null pointer.
template <typename Enum>
struct EnumNames;

#define NBUFFER_SCENE_NAMES(Enum, ...)                                                             \
  template <>                                                                                      \
  struct EnumNames<Enum>                                                                           \
  {                                                                                                \
    static const char* const* Get()                                                                \
    {                                                                                              \
      static const char* const names[] = { __VA_ARGS__, nullptr };                                 \
      return names;                                                                                \
    }                                                                                              \
  }

//------------------------------------------------------------------------------------------------
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
  Book,      ///< `Detail` leaves round an upright spine that they share, wound by turns.
  Strip,     ///< A triangle strip of 2 x `Detail` triangles, heights anywhere in the box.
  Stack,     ///< `Detail` level quads above each other.
  Empty,     ///< No points at all.
  NaNPoint,  ///< A box with a coordinate that is no number, or infinite for an odd `Seed`.
  SharedBox, ///< A box whose eight points are shared by its faces.
  Globe,    ///< VTK's sphere with `Detail` meridians and parallels: one point at each pole, a seam.
  Cylinder, ///< VTK's cylinder along y with `Detail` sides.
  Cone,     ///< VTK's cone along x with `Detail` sides.
  Tiles,    ///< An upright rectangle of `Detail` x `Detail` quads that share their points.
  Mesh      ///< `Points` and `Polygons` as they are, moved to `Center` and scaled by `Size`.
};
NBUFFER_SCENE_NAMES(ShapeKind, "Box", "Sphere", "Quad", "Grating", "Lattice", "Terrain", "Soup",
  "Lines", "Points", "Book", "Strip", "Stack", "Empty", "NaNPoint", "SharedBox", "Globe",
  "Cylinder", "Cone", "Tiles", "Mesh");

struct Shape
{
  ShapeKind Kind = ShapeKind::Box;
  glm::dvec3 Center = { 0.0, 0.0, 0.0 };
  glm::dvec3 Size = { 1.0, 1.0, 1.0 };
  int Detail = 1;
  double Fill = 0.5;
  int Seed = 0;                 ///< Points are stored as doubles if it is odd.
  std::vector<double> Points;   ///< Of a Mesh: three coordinates for each point.
  std::vector<double> Polygons; ///< Of a Mesh: for each polygon the number of its points and these.

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("kind", self.Kind);
    visit("center", self.Center);
    visit("size", self.Size);
    visit("detail", self.Detail);
    visit("fill", self.Fill);
    visit("seed", self.Seed);
    visit("points", self.Points);
    visit("polygons", self.Polygons);
  }
};

//------------------------------------------------------------------------------------------------
enum class PropKind
{
  Actor,
  Piped,     ///< An actor whose data come out of a filter.
  DataSet,   ///< An actor with vtkDataSetMapper.
  Composite, ///< Two blocks side by side, the second one of another colour.
  Assembly,  ///< Two actors side by side.
  Follower,
  Glyphs, ///< The shape, small, at its own points.
  LOD,
  Volume,
  Billboard,
  Text,
  NoMapper
};
NBUFFER_SCENE_NAMES(PropKind, "Actor", "Piped", "DataSet", "Composite", "Assembly", "Follower",
  "Glyphs", "LOD", "Volume", "Billboard", "Text", "NoMapper");

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
  Some, ///< Of the texture or the scalars: alpha below 1 in places.
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
  int From = 0;   ///< First frame in which it is in the renderer.
  int Until = -1; ///< First frame in which it is not any more; -1: never.
  glm::dvec3 Position = { 0.0, 0.0, 0.0 };
  glm::dvec3 Orientation = { 0.0, 0.0, 0.0 };
  glm::dvec3 Scale = { 1.0, 1.0, 1.0 };
  std::vector<double> UserMatrix; ///< Empty or 16.
  glm::dvec3 Color = { 1.0, 1.0, 1.0 };
  double Opacity = 1.0;
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
  int CulledFaces = 0; ///< 1 front, 2 back.
  bool ForceOpaque = false;
  bool ForceTranslucent = false;
  Translucency Texture = Translucency::None;
  Translucency Scalars = Translucency::None;
  TestScene::Shader Shader = TestScene::Shader::Original;
  std::vector<double> ClippingPlane; ///< Empty, or origin and normal.
  bool ShiftCoordinates = true;      ///< Large coordinates are moved on their way to the device.
  double OffsetUnits = 0.0;          ///< Relative polygon offset, where such offsets are on.
  bool Casts = true;                 ///< Has the key of Shadows::CasterKeys.
  int MapperOf = -1; ///< Id of the actor before it whose mapper it shares; -1: none.

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("id", self.Id);
    visit("kind", self.Kind);
    visit("shape", self.Shape);
    visit("renderer", self.Renderer);
    visit("from", self.From);
    visit("until", self.Until);
    visit("position", self.Position);
    visit("orientation", self.Orientation);
    visit("scale", self.Scale);
    visit("user_matrix", self.UserMatrix);
    visit("color", self.Color);
    visit("opacity", self.Opacity);
    visit("visible", self.Visible);
    visit("lighting", self.Lighting);
    visit("flat", self.Flat);
    visit("representation", self.Representation);
    visit("edges", self.Edges);
    visit("vertices", self.Vertices);
    visit("spheres", self.Spheres);
    visit("tubes", self.Tubes);
    visit("line_width", self.LineWidth);
    visit("point_size", self.PointSize);
    visit("culled_faces", self.CulledFaces);
    visit("force_opaque", self.ForceOpaque);
    visit("force_translucent", self.ForceTranslucent);
    visit("texture", self.Texture);
    visit("scalars", self.Scalars);
    visit("shader", self.Shader);
    visit("clipping_plane", self.ClippingPlane);
    visit("shift_coordinates", self.ShiftCoordinates);
    visit("offset_units", self.OffsetUnits);
    visit("casts", self.Casts);
    visit("mapper_of", self.MapperOf);
  }
};

//------------------------------------------------------------------------------------------------
/// From this frame on a renderer's camera is this one.
struct View
{
  int Frame = 0;
  int Renderer = 0;
  glm::dvec3 Position = { 0.0, 0.0, 10.0 };
  glm::dvec3 FocalPoint = { 0.0, 0.0, 0.0 };
  glm::dvec3 ViewUp = { 0.0, 1.0, 0.0 };
  double ViewAngle = 30.0;
  bool Parallel = false;
  double ParallelScale = 1.0;
  double Near = 0.0; ///< Both 0: vtkRenderer::ResetCameraClippingRange.
  double Far = 0.0;
  std::array<double, 2> WindowCenter = { 0.0, 0.0 };
  double EyeAngle = 2.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("frame", self.Frame);
    visit("renderer", self.Renderer);
    visit("position", self.Position);
    visit("focal_point", self.FocalPoint);
    visit("view_up", self.ViewUp);
    visit("view_angle", self.ViewAngle);
    visit("parallel", self.Parallel);
    visit("parallel_scale", self.ParallelScale);
    visit("near", self.Near);
    visit("far", self.Far);
    visit("window_center", self.WindowCenter);
    visit("eye_angle", self.EyeAngle);
  }
};

//------------------------------------------------------------------------------------------------
enum class ChangeKind
{
  Position,       ///< Of prop `Target`; 3 values.
  Orientation,    ///< 3 values.
  Scale,          ///< 3 values.
  UserMatrix,     ///< 16 values.
  Color,          ///< 3 values.
  Opacity,        ///< 1 value, as all below that say nothing else.
  Visible,        //
  Representation, //
  LineWidth,      ///< And the size of points.
  Edges,          //
  MovePoints,     ///< Add 3 values to the points of the data, in place.
  ReplaceData,    ///< Another data set, whose shape has the 3 values as size.
  ClippingPlane,  ///< The origin of the plane in place; 3 values.
  Rejoin,         ///< Taken out of the renderer and added again, at the end.
  WindowSize,     ///< 2 values.
  MultiSamples,   //
  Stereo,         ///< A stereo type of VTK, or -1.
  NewContext,     ///< The window's context is released.
  Viewport,       ///< Of renderer `Target`; 4 values.
  Pass,           ///< Of renderer `Target`, a value of PassKind.
  FXAA,           ///< Of renderer `Target`.
  SSAO,           ///< Of renderer `Target`.
  CullerEnabled,  //
  CullerBackend,  //
  CullerBaseFactor,
  CullerRoundSize,
  CullerPresent, ///< In the renderers' lists of cullers or not.
  PolygonOffset, ///< VTK's global switch.
  Select,        ///< A hardware selection of the whole window between two frames.
  Casts,
  BlockVisible,  ///< Of the second block of a composite prop.
  LightPosition, ///< Of light `Target`; 3 values.
  LightFocalPoint,
  LightCone,
  LightOn,
  LightCasts,
  LightAttenuation, ///< ShadowAttenuation.
  ShadowMode,       ///< A value of the enumeration of that name, as all below of Shadows' members.
  LitmapResolution,
  SlabGap,
  CasterKeys,
  BoxCost
};
NBUFFER_SCENE_NAMES(ChangeKind, "Position", "Orientation", "Scale", "UserMatrix", "Color",
  "Opacity", "Visible", "Representation", "LineWidth", "Edges", "MovePoints", "ReplaceData",
  "ClippingPlane", "Rejoin", "WindowSize", "MultiSamples", "Stereo", "NewContext", "Viewport",
  "Pass", "FXAA", "SSAO", "CullerEnabled", "CullerBackend", "CullerBaseFactor", "CullerRoundSize",
  "CullerPresent", "PolygonOffset", "Select", "Casts", "BlockVisible", "LightPosition",
  "LightFocalPoint", "LightCone", "LightOn", "LightCasts", "LightAttenuation", "ShadowMode",
  "LitmapResolution", "SlabGap", "CasterKeys", "BoxCost");

/// Done before the frame is drawn, in the order of the list.
struct Change
{
  int Frame = 0;
  ChangeKind Kind = ChangeKind::Position;
  int Target = 0;
  std::vector<double> Values; ///< Those that are missing are 0.

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("frame", self.Frame);
    visit("kind", self.Kind);
    visit("target", self.Target);
    visit("values", self.Values);
  }
};

//------------------------------------------------------------------------------------------------
enum class PassKind
{
  None,
  RenderSteps,
  OpaqueTranslucent, ///< Lights, opaque, translucent, volumetric, overlay.
  OpaqueTwice,
  TranslucentFirst,
  Default, ///< Lights, vtkDefaultPass.
  DepthPeeling,
  DualDepthPeeling,
  SSAO,
  FXAA,
  Framebuffer,            ///< One that the culler does not know.
  Sobel,                  ///< One that the culler does not know.
  ShadowVolumes,          ///< vtkShadowVolumeClampPass as the pass of the renderer.
  ShadowVolumesInSequence ///< In the place of the opaque pass of OpaqueTranslucent.
};
NBUFFER_SCENE_NAMES(PassKind, "None", "RenderSteps", "OpaqueTranslucent", "OpaqueTwice",
  "TranslucentFirst", "Default", "DepthPeeling", "DualDepthPeeling", "SSAO", "FXAA", "Framebuffer",
  "Sobel", "ShadowVolumes", "ShadowVolumesInSequence");

struct Renderer
{
  std::array<double, 4> Viewport = { 0.0, 0.0, 1.0, 1.0 };
  int Layer = 0;
  bool Erase = true;
  bool PreserveDepth = false;
  bool SharesCamera = false; ///< With renderer 0.
  bool SharesProps = false;  ///< All props of renderer 0 are in it as well.
  PassKind Pass = PassKind::None;
  bool SSAO = false;
  bool FXAA = false;
  bool DepthPeeling = false;
  bool OIT = true;
  bool HiddenLines = false;
  bool Shadows = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("viewport", self.Viewport);
    visit("layer", self.Layer);
    visit("erase", self.Erase);
    visit("preserve_depth", self.PreserveDepth);
    visit("shares_camera", self.SharesCamera);
    visit("shares_props", self.SharesProps);
    visit("pass", self.Pass);
    visit("ssao", self.SSAO);
    visit("fxaa", self.FXAA);
    visit("depth_peeling", self.DepthPeeling);
    visit("oit", self.OIT);
    visit("hidden_lines", self.HiddenLines);
    visit("shadows", self.Shadows);
  }
};

struct Window
{
  int Width = 96;
  int Height = 80;
  int MultiSamples = 0;
  bool StencilCapable = false;
  bool LineSmoothing = false;
  int Stereo = -1; ///< A stereo type of VTK.
  int TileScale = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("width", self.Width);
    visit("height", self.Height);
    visit("multi_samples", self.MultiSamples);
    visit("stencil_capable", self.StencilCapable);
    visit("line_smoothing", self.LineSmoothing);
    visit("stereo", self.Stereo);
    visit("tile_scale", self.TileScale);
  }
};

//------------------------------------------------------------------------------------------------
enum class DefaultCuller
{
  Removed,
  Before, ///< vtkFrustumCoverageCuller where VTK puts it.
  Behind,
  NoTakeOver ///< Before, and ours is told to leave it there.
};
NBUFFER_SCENE_NAMES(DefaultCuller, "Removed", "Before", "Behind", "NoTakeOver");

/// Properties of vtkNBufferCuller of the same names, and how it is added.
struct Culler
{
  TestScene::DefaultCuller DefaultCuller = TestScene::DefaultCuller::Removed;
  bool OnePerRenderer = false;
  int AddedInFrame = 0;
  int Backend = 0;
  int BaseFactor = 4;
  int MinimumNumberOfCandidates = 1;
  int MaximumNumberOfRounds = 6;
  int RoundSize = 8;
  int MaximumNumberOfPieces = 8;
  int HierarchySize = 10000;
  bool TestPixels = true;
  int TestSlivers = 0;
  bool ReuseWhenStill = true;
  bool BackOff = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("default_culler", self.DefaultCuller);
    visit("one_per_renderer", self.OnePerRenderer);
    visit("added_in_frame", self.AddedInFrame);
    visit("backend", self.Backend);
    visit("base_factor", self.BaseFactor);
    visit("minimum_number_of_candidates", self.MinimumNumberOfCandidates);
    visit("maximum_number_of_rounds", self.MaximumNumberOfRounds);
    visit("round_size", self.RoundSize);
    visit("maximum_number_of_pieces", self.MaximumNumberOfPieces);
    visit("hierarchy_size", self.HierarchySize);
    visit("test_pixels", self.TestPixels);
    visit("test_slivers", self.TestSlivers);
    visit("reuse_when_still", self.ReuseWhenStill);
    visit("back_off", self.BackOff);
  }
};

//------------------------------------------------------------------------------------------------
enum class LightKind
{
  Directional,
  Spot,
  Point,
  Headlight,
  Camera ///< A directional light that moves with the camera; in its coordinates.
};
NBUFFER_SCENE_NAMES(LightKind, "Directional", "Spot", "Point", "Headlight", "Camera");

/// Every renderer has one of its own of each.
struct Light
{
  LightKind Kind = LightKind::Directional;
  glm::dvec3 Position = { 3.0, 8.0, 5.0 };
  glm::dvec3 FocalPoint = { 0.0, 0.0, 0.0 };
  double ConeAngle = 40.0; ///< Of spots.
  double Exponent = 0.0;   ///< Of spots.
  glm::dvec3 Attenuation = { 1.0, 0.0, 0.0 };
  glm::dvec3 Color = { 1.0, 1.0, 1.0 };
  double Intensity = 0.7;
  bool On = true;
  bool Casts = true; ///< vtkShadowVolumeClampPass::SetLightCasts
  double ShadowAttenuation = 1.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("kind", self.Kind);
    visit("position", self.Position);
    visit("focal_point", self.FocalPoint);
    visit("cone_angle", self.ConeAngle);
    visit("exponent", self.Exponent);
    visit("attenuation", self.Attenuation);
    visit("color", self.Color);
    visit("intensity", self.Intensity);
    visit("on", self.On);
    visit("casts", self.Casts);
    visit("shadow_attenuation", self.ShadowAttenuation);
  }
};

enum class ShadowMode
{
  Unclamped,
  Scissored,
  Clamped,
  Automatic,
  Culled ///< Last, since recorded changes hold the numbers of the others.
};
NBUFFER_SCENE_NAMES(ShadowMode, "Unclamped", "Exact", "Clamped", "Automatic", "Culled");

/// Properties of vtkShadowVolumeClampPass of the same names, and how it is used.
struct Shadows
{
  ShadowMode Mode = ShadowMode::Scissored;
  int LitmapResolution = 256;
  int SlabGap = 4;
  int BoxCost = 256;
  bool CasterKeys = false;  ///< Only props with Prop::Casts cast.
  bool OneForAll = false;   ///< Renderers share one pass object.
  bool CompareRays = false; ///< One frame is compared with rays in double precision, too.

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("mode", self.Mode);
    visit("litmap_resolution", self.LitmapResolution);
    visit("slab_gap", self.SlabGap);
    visit("box_cost", self.BoxCost);
    visit("caster_keys", self.CasterKeys);
    visit("one_for_all", self.OneForAll);
    visit("compare_rays", self.CompareRays);
  }
};

struct Scenario
{
  std::uint64_t Seed = 0;
  std::string Family; ///< What kind of scene the generator made; only for people.
  int Frames = 1;
  TestScene::Window Window;
  std::vector<TestScene::Renderer> Renderers = std::vector<TestScene::Renderer>(1);
  TestScene::Culler Culler;
  TestScene::Shadows Shadows;
  std::vector<TestScene::Light> Lights; ///< None: VTK's own headlight.
  std::vector<TestScene::Prop> Props;   ///< In the order in which they join the renderers.
  std::vector<TestScene::View> Views;
  std::vector<TestScene::Change> Changes;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit)
  {
    visit("seed", self.Seed);
    visit("family", self.Family);
    visit("frames", self.Frames);
    visit("window", self.Window);
    visit("renderers", self.Renderers);
    visit("culler", self.Culler);
    visit("shadows", self.Shadows);
    visit("lights", self.Lights);
    visit("props", self.Props);
    visit("views", self.Views);
    visit("changes", self.Changes);
  }
};
}

#undef NBUFFER_SCENE_NAMES
#endif
