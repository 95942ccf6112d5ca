// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowCasterList
 * @brief The props of a renderer that cast shadows, whether the camera sees them or not.
 *
 * Every actor among the visible props of the renderer may cast, and so may the actors in its
 * assemblies. An actor casts if it is drawn opaque, as a surface, by a mapper whose triangles are
 * known: those of a mesh or of the blocks of composite data (vtkNBufferSurface::GetParts()), or
 * those of the instances of a glyph (vtkNBufferGlyphs.h). Each block and each instance is a caster
 * of its own; invisible blocks and masked instances are no casters. The actors that do not cast are
 * counted by reason (vtkShadowSkip).
 *
 * The instances of a glyph share the topology of their source. In addition, each takes about 300
 * bytes and 24 for each point of the source, and for each light about 300 bytes and 12 for each
 * triangle and edge of its silhouette, as other casters do, and its volume once that is drawn. For
 * a cube under the sun these are 1.7 kB. Instances are read again if the mapper or its data have
 * changed, and only those whose matrix differs are computed again.
 *
 * A prop is read again when vtkNBufferPropWatch says that it has changed, and in every frame if
 * that cannot be known. Its pipeline is then brought up to date, as VTK does before it draws.
 */
#ifndef vtkShadowCasterList_h
#define vtkShadowCasterList_h

#include "vtkNBufferPropList.h"
#include "vtkNBufferPropWatch.h"
#include "vtkNBufferSurface.h"
#include "vtkShadowCaster.h"
#include "vtkShadowStatistics.h"

#include <array>
#include <cstddef>
#include <memory>
#include <unordered_map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkGlyph3DMapper;
class vtkInformation;
class vtkMatrix4x4;
class vtkProp;
class vtkRenderer;

class VTKNBUFFER_EXPORT vtkShadowCasterList
{
public:
  /// Reads the renderer's props that have changed. Only props with `requiredKeys` cast; if it is
  /// nullptr, all props do.
  void Update(vtkRenderer* renderer, vtkInformation* requiredKeys);

  const std::vector<vtkShadowCaster*>& GetCasters() const { return this->Casters; }

  /// The number of actors that do not cast, by reason.
  const std::array<int, NumberOfShadowSkips>& GetSkipped() const { return this->Skipped; }

  /// The largest vtkNBufferSurface::GetLightingMargin(), in pixels, of all visible actors, casters
  /// or not. It is infinite if there are visible props that are neither actors nor 2D actors, or
  /// that blend with what is behind them (vtkNBufferDrawOrder::MattersTo()).
  double GetLightingMargin() const { return this->LightingMargin; }

  /// The number of casters whose mesh, matrix or planes the last Update() found changed.
  int GetNumberOfUpdates() const { return this->Updates; }

  /**
   * A number that Update() increases if a visible prop, caster or not, may draw something else than
   * at the last Update(). Some props may change without a trace: those of
   * vtkNBufferPropWatch::Means::None, those that uniforms of the application's shaders may move,
   * and those that follow a device. If there are any, every Update() increases the number.
   */
  vtkMTimeType GetVersion() const { return this->Version; }

  /// The visible props in the renderer's order. The pointers must only be compared.
  const std::vector<vtkProp*>& GetProps() const { return this->Members.GetProps(); }

private:
  /// A mesh of an actor.
  struct Mesh
  {
    int Path = 0;                   ///< The number of the actor in its assembly.
    const void* Block = nullptr;    ///< The polydata. The pointer is only compared.
    vtkMTimeType Time = 0;          ///< The time of the polydata when Topology was made.
    vtkMTimeType InstancesTime = 0; ///< vtkNBufferGlyphs::GetTime() when Casters were made.
    std::array<double, 16> ToWorld = {};
    std::vector<vtkNBufferSurface::Plane> Planes;
    std::shared_ptr<const vtkShadowTopology> Topology;
    std::vector<std::unique_ptr<vtkShadowCaster>> Casters; ///< One, or one for each instance.
  };

  /// What is known of a visible prop.
  struct Member
  {
    void Skip(vtkShadowSkip reason)
    {
      this->Skipped[static_cast<std::size_t>(reason)] += this->Casts ? 1 : 0;
    }

    bool MayHaveChanged = false;  ///< Watch.MayHaveChanged(), which is called in parallel.
    bool HasRequiredKeys = false; ///< True if the prop has the required keys now.
    bool Casts = false;           ///< True if it had them when it was read last.
    bool MovesUnseen = false;     ///< True if shaders or a device may move it without a time.
    double LightingMargin = 0.0;  ///< The largest lighting margin of its actors, in pixels.
    vtkNBufferPropWatch Watch;
    std::vector<Mesh> Meshes;
    std::array<int, NumberOfShadowSkips> Skipped = {};
    std::vector<vtkNBufferSurface> Surfaces; ///< One for each actor, by path.
  };

  /// Reads a prop again. Returns whether it may draw something else than before.
  bool ReadProp(vtkProp* prop, Member& member);
  void AddProp(vtkProp* prop, Member& member);
  void AddActor(vtkActor* actor, int path, vtkMatrix4x4* matrix, Member& member);
  /// Adds the casters of a part. If `glyphs` is not nullptr, it draws instances of the part, and
  /// each of them is a caster.
  void AddMesh(const vtkNBufferSurface::Part& part, vtkGlyph3DMapper* glyphs, int path,
    const std::vector<vtkNBufferSurface::Plane>& planes, Member& member);
  /// Removes the mesh of an actor and a block from OldMeshes and returns it; returns a new mesh if
  /// it is not there. `place` is the index of the mesh among those that are read now. It is mostly
  /// the index in OldMeshes, too, and is tried first.
  Mesh TakeOldMesh(int path, const void* block, std::size_t place);

  vtkNBufferPropList<Member> Members;
  std::vector<vtkProp*> Visible;              ///< Used in Update(); a member to keep its memory.
  std::vector<vtkNBufferSurface::Part> Parts; ///< Used in AddActor(); a member to keep its memory.
  std::vector<Mesh> OldMeshes;                ///< The last meshes of the prop that is being read.
  /// The indices of OldMeshes by Block, made when a mesh is not at the index that it had before.
  std::unordered_multimap<const void*, std::size_t> OldPlaces;
  vtkNBufferPropWatch::GlobalState GlobalState{};
  vtkMTimeType Version = 0;
  std::vector<vtkShadowCaster*> Casters;
  std::array<int, NumberOfShadowSkips> Skipped = {};
  double LightingMargin = 0.0;
  int Updates = 0;
};

VTK_ABI_NAMESPACE_END
#endif
