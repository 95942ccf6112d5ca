// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSurface
 * @brief What an actor draws: the one place that knows VTK's kinds of mappers.
 *
 * Culler and shadows support a new kind of mapper as soon as this class does. The static methods
 * read actor and mapper. An object of this class belongs to one actor; if the actor's data is no
 * polydata, it keeps the surface that is extracted.
 *
 * Which classes of mappers are supported depends on the purpose:
 *
 *     IsPlain()   for the culler: the classes that are known (vtkNBufferKnownClasses). A subclass
 *                 may draw outside its bounds, and the culler would leave out what can be seen,
 *                 unless the application vouches for it.
 *     GetParts()  for shadows: subclasses as well. Bounds do not matter: the triangles in the
 *                 mapper's input cast the shadow, and if a subclass draws something else in
 *                 addition, only the shadow of that is missing.
 */
#ifndef vtkNBufferSurface_h
#define vtkNBufferSurface_h

#include "vtkBoundingBox.h"
#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkGeometryFilter;
class vtkMapper;
class vtkMatrix4x4;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;
class vtkProperty;
class vtkTexture;

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
  /// Whether all that a mapper draws in the opaque stage is known to lie within its bounds.
  static bool IsPlain(vtkMapper* mapper);

  /// Whether a mapper shows composite data, whose blocks may have attributes of their own.
  static bool IsComposite(vtkMapper* mapper);

  /// Whether the user has replaced parts of the actor's shaders, which may then draw anything.
  static bool HasReplacedShaders(vtkActor* actor);

  /// Whether an actor with this property draws its filled polygons and nothing outside of them:
  /// no vertices, and no spheres or tubes if `linesOrPoints`, which says whether the data has such
  /// cells. Visible edges are drawn inside of polygons (VTKNBUFFER_EDGES_KEEP_TRIANGLES).
  static bool DrawsAsSurface(vtkProperty* property, bool linesOrPoints);

  /// Whether the actor is placed by a device or in the physical world, not in world coordinates.
  static bool HasOtherCoordinates(vtkActor* actor);
  ///@}

  /// The input of a plain mapper if it is a single vtkPolyData, and no subclass, which the mapper
  /// draws as it is; otherwise nullptr.
  static vtkPolyData* GetOnlyPolyData(vtkMapper* mapper);

  /// The mapper that draws a mesh for this one, which is another one for vtkDataSetMapper; nullptr
  /// for composite data and glyphs.
  static vtkOpenGLPolyDataMapper* GetDrawingMapper(vtkMapper* mapper);

  /// The textures of an actor and of its property, which is created if it is missing.
  static std::vector<vtkTexture*> GetTextures(vtkActor* actor);

  /// Update the pipelines of mapper and textures, as VTK does before it draws. Does nothing for a
  /// static mapper (vtkMapper::SetStatic()), and costs little where there is no pipeline.
  static void UpdatePipeline(vtkActor* actor);

  ///@{
  /**
   * How far outside its surface a plain actor draws, in pixels: half the width of its lines or
   * points, plus 1 (GetMarginOfLines()), or 0 if it surely has neither. DrawsLines(): whether it
   * has lines.
   */
  static double GetMargin(vtkActor* actor);
  static double GetMarginOfLines(vtkProperty* property);
  static bool DrawsLines(vtkMapper* mapper);
  ///@}

  /// The bounds of a mapper, and of all points of its polydata or blocks, as VTK keeps them.
  static vtkBoundingBox GetBoundsOfPoints(vtkMapper* mapper, bool visibleOnly);

  /**
   * How far, in pixels, the position at which VTK's shader lights a fragment of an actor may be
   * from the fragment: points and lines are lit at their middle. It is infinite for replaced
   * shaders, which may use any position, and for surfaces whose depth is offset, because these may
   * be drawn before others whose depth is nearer without the offset.
   */
  static double GetLightingMargin(vtkActor* actor);

  /**
   * Whether the polygon offset of an actor with a plain mapper may give a sample a depth nearer to
   * the eye than its surface. `linesOrPoints`: whether it draws such cells. HasOffset(): whether it
   * has any offset. Both depend on vtkNBufferPropWatch::GetGlobalState().
   */
  static bool HasOffset(vtkActor* actor);
  static bool HasOffsetTowardsEye(vtkActor* actor, bool linesOrPoints);

  /// A clipping plane a x + b y + c z + d >= 0 in world coordinates: it keeps the side to which its
  /// normal (a, b, c) points. Of more than six planes of a mapper VTK uses the first six.
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
   * The meshes of an actor whose pipeline is up to date: the polydata of its mapper, each block of
   * composite data, or the surface that vtkDataSetMapper extracts from any other data set.
   * `toWorld` is the matrix of the actor, or of its place in an assembly. Returns false if the
   * triangles cannot be known. The meshes are valid until the next call or change of the data.
   */
  bool GetParts(vtkActor* actor, vtkMatrix4x4* toWorld, std::vector<Part>& parts);

  /// As GetParts(), but returns false if a surface would have to be extracted.
  static bool GetPartsAtHand(vtkActor* actor, vtkMatrix4x4* toWorld, std::vector<Part>& parts);

  /// The triangles of a polydata: those of its polygons, then those of its strips, made by the
  /// functions that VTK's mappers use.
  static vtkNBufferMesh GetMesh(vtkPolyData* data);

private:
  vtkSmartPointer<vtkGeometryFilter> Extractor;
};

VTK_ABI_NAMESPACE_END
#endif
