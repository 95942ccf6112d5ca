// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSurface
 * @brief What an actor draws: the one place that knows VTK's kinds of mappers.
 *
 * A new kind of mapper is taught here to the culler and to the shadows at once. The static methods
 * answer what can be read from actor and mapper; an object of this class keeps what has to be made
 * for one actor, the extracted surface of data that is no polydata.
 *
 * Which classes count has two answers:
 *
 *     IsPlain()   for the culler: exactly the classes that are known. What a subclass draws may lie
 *                 outside its bounds, and the culler would leave out what can be seen.
 *     GetParts()  for shadows: subclasses as well. No bounds are involved: the shadow is that of
 *                 the triangles in the mapper's input, and if a subclass draws something else
 *                 in addition, only the shadow of that is missing.
 */
#ifndef vtkNBufferSurface_h
#define vtkNBufferSurface_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkGeometryFilter;
class vtkMapper;
class vtkMatrix4x4;
class vtkPolyData;
class vtkProp;
class vtkProperty;

/// The triangles that VTK's OpenGL mappers draw for a polydata, in model coordinates.
struct vtkNBufferMesh
{
  std::vector<glm::dvec3> Points;
  std::vector<std::array<unsigned int, 3>> Triangles;
};

class VTKNBUFFER_EXPORT vtkNBufferSurface
{
public:
  ///@{
  /**
   * The prop if it is an actor of VTK's own class, otherwise nullptr. A subclass may draw anything.
   */
  static vtkActor* GetPlainActor(vtkProp* prop);

  /// Whether all that a mapper draws in the opaque stage is known to lie within its bounds.
  static bool IsPlain(vtkMapper* mapper);

  /// Whether a mapper shows composite data, whose blocks may have attributes of their own.
  static bool IsComposite(vtkMapper* mapper);

  /// Whether the user has replaced parts of the actor's shaders, which may then draw anything.
  static bool HasReplacedShaders(vtkActor* actor);

  /// Whether these properties draw nothing but what a mapper's polygons cover.
  static bool DrawsAsSurface(vtkProperty* property);

  /// Whether the actor is placed by a device or in the physical world, not in world coordinates.
  static bool HasOtherCoordinates(vtkActor* actor);
  ///@}

  /**
   * The polydata that a plain mapper shows as it is, if its input is one and is exactly of this
   * class; otherwise nullptr.
   */
  static vtkPolyData* GetOnlyPolyData(vtkMapper* mapper);

  /// Bring what feeds mapper and texture up to date, as VTK does before it draws. Does nothing for
  /// a static mapper (vtkMapper::SetStatic()), and costs little where there is no pipeline.
  static void UpdatePipeline(vtkActor* actor);

  ///@{
  /**
   * How much wider than its surface a plain actor draws, in pixels: half the width of its lines and
   * points and one more, or 0 if it has neither. DrawsLines() says whether there are lines.
   */
  static double GetMargin(vtkActor* actor);
  static bool DrawsLines(vtkMapper* mapper);
  ///@}

  /**
   * How far from a fragment of an actor, in pixels, the place may be for which VTK's shader lights
   * it: points and lines are lit in their middle, and replaced shaders may light anything
   * (infinity).
   */
  static double GetLightingMargin(vtkActor* actor);

  /**
   * Whether the polygon offset of a plain mapper may draw its surface nearer than its vertices.
   * Depends on vtkNBufferPropWatch::GetGlobalState().
   */
  static bool HasOffsetTowardsEye(vtkMapper* mapper, bool linesOrPoints);

  /**
   * The coordinates in the vertex buffers of a plain mapper. VTK may shift and scale vertices
   * before it rounds them to floats, hence rounding depends on how far they are from `Origin`, in
   * model coordinates. No coordinate is farther from it than `HalfRange`.
   */
  struct BufferCoordinates
  {
    glm::dvec3 Origin;
    glm::dvec3 HalfRange;
  };

  /// The coordinates in the mapper's vertex buffers, or nothing if they follow the camera.
  static std::optional<BufferCoordinates> GetBufferCoordinates(vtkMapper* mapper);

  /// A clipping plane a x + b y + c z + d >= 0 in world coordinates: it keeps the side to which its
  /// normal (a, b, c) points.
  using Plane = std::array<double, 4>;
  static std::vector<Plane> GetClippingPlanes(vtkMapper* mapper);

  /// One of the meshes that an actor draws. Several parts may share a mesh.
  struct Part
  {
    vtkPolyData* Mesh = nullptr;
    std::array<double, 16> ToWorld = {}; ///< From the coordinates of the mesh, row by row.
    bool IsVisible = true;               ///< False for a block that is switched off.
    bool IsTranslucent = false;          ///< True for a block whose own opacity is below 1.
  };

  /**
   * What an actor draws as a surface, given that its pipeline is up to date: the polydata of its
   * mapper, each block of composite data, or what vtkDataSetMapper extracts from any other data
   * set. `toWorld` is the matrix of the actor, or of its place in an assembly. Returns false if the
   * triangles cannot be known. The meshes are valid until the next call or change of the data.
   */
  bool GetParts(vtkActor* actor, vtkMatrix4x4* toWorld, std::vector<Part>& parts);

  /// GetParts() without what would have to be extracted.
  static bool GetPartsAtHand(vtkActor* actor, vtkMatrix4x4* toWorld, std::vector<Part>& parts);

  /// The triangles of a polydata: of its polygons, then of its strips, made by the functions that
  /// VTK's mappers use.
  static vtkNBufferMesh GetMesh(vtkPolyData* data);

private:
  vtkSmartPointer<vtkGeometryFilter> Extractor;
};

VTK_ABI_NAMESPACE_END
#endif
