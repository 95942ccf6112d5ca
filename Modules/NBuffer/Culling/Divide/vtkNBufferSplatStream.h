// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSplatStream
 * @brief The points of a vtkPointGaussianMapper: what it draws, and how to draw some of them.
 *
 * The mapper has a helper draw, a mapper of polydata with one vertex for each splat. Since VTK 9.3
 * the helper draws by an index buffer, which vtkNBufferDrawHook exchanges as that of any mesh.
 * Before, it calls glDrawArrays() for all vertices, which no number that can be changed prevents.
 * This class then draws the chosen vertices itself, and has OpenGL discard VTK's own draw: within
 * glBeginConditionalRender() with a query that has counted nothing, nothing is drawn.
 *
 * Only splats with the scale factor 0, drawn as opaque points, are divided. Splats with a radius
 * are blended among opaque props, with the depth of the whole splat, so that what is drawn before
 * them shows through (Blends()).
 */
#ifndef vtkNBufferSplatStream_h
#define vtkNBufferSplatStream_h

#include "vtkNBufferOwnDraw.h"
#include "vtkNBufferUnits.h"

#include "vtkType.h"

#include <functional>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkActor;
class vtkOpenGLHelper;
class vtkOpenGLIndexBufferObject;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;

class vtkNBufferSplatStream
{
public:
  vtkNBufferSplatStream() = default;
  ~vtkNBufferSplatStream() { this->Restore(); }
  vtkNBufferSplatStream(const vtkNBufferSplatStream&) = delete;
  void operator=(const vtkNBufferSplatStream&) = delete;

  /// The mapper if it is the one that draws splats, otherwise nullptr.
  static vtkOpenGLPolyDataMapper* GetHelper(vtkAbstractMapper* mapper);

  /// Whether an actor draws splats in the opaque stage that are blended with what has been drawn
  /// before: emissive ones, and those that are less opaque at their borders or by an array.
  static bool Blends(vtkActor* actor);

  /// Whether the actor has a vtkPointGaussianMapper that draws one polydata.
  static bool DrawsSplats(vtkActor* actor);

  /// Whether an actor that draws splats draws opaque points, in the actor's place and at their own
  /// depths.
  static bool MayBeDivided(vtkActor* actor);

  ///@{
  /// Of an actor that draws splats: its data; the newest time of what the points are made of,
  /// whose pipeline is brought up to date; and how large its points are, as
  /// vtkNBufferSurface::GetMargin().
  static vtkPolyData* GetData(vtkActor* actor);
  static vtkMTimeType GetTime(vtkActor* actor);
  static double GetMargin(vtkActor* actor);
  ///@}

  /// Whether a stream of the helper has no index buffer.
  static bool DrawsArrays(vtkOpenGLHelper* stream);

  /// The vertices of a stream without an index buffer, in the order in which they are drawn.
  static void ReadVertices(vtkPolyData* data, vtkNBufferUnits::Mesh& mesh);

  /// Let the helper's draw of a stream without an index buffer, whose shader parameters are being
  /// set, draw only these vertices.
  void DrawNext(
    vtkOpenGLPolyDataMapper* mapper, vtkOpenGLHelper* stream, vtkOpenGLIndexBufferObject* vertices);

  /// Undo what DrawNext() has changed.
  void Restore();

  void ReleaseGraphicsResources();

private:
  bool Draw(vtkOpenGLIndexBufferObject* vertices);

  vtkNBufferOwnDraw Own;
  unsigned int Nothing = 0;  ///< A query that has counted nothing, or 0.
  bool IsDiscarding = false; ///< Until Restore() nothing is drawn.
};

VTK_ABI_NAMESPACE_END
#endif
