// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class VTKNBUFFER_EXPORT vtkShadowCasterList
 * @brief Which props of a renderer cast, whether the camera sees them or not.
 *
 * Of every visible prop of the renderer the actors are looked at, those in assemblies too. An actor
 * casts if it is drawn opaque, as a surface, by a mapper of polydata, of composite data sets of
 * them, or of other data sets (vtkDataSetMapper), whose surface is extracted as that mapper does.
 * What cannot cast is counted by reason (vtkShadowSkip).
 *
 * A prop is looked at again when the modification times of what it came from say so
 * (vtkNBufferSources), and in every frame where they cannot tell. Pipelines are brought up to date
 * then, as VTK does before it draws. 15,000 unchanged actors cost 3 ms.
 */
#ifndef vtkShadowCasterList_h
#define vtkShadowCasterList_h

#include "vtkNBufferCandidate.h"
#include "vtkNBufferSources.h"
#include "vtkShadowCaster.h"
#include "vtkShadowStatistics.h"

#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkDataObject;
class vtkGeometryFilter;
class vtkInformation;
class vtkMatrix4x4;
class vtkPolyData;
class vtkProp;
class vtkRenderer;

class VTKNBUFFER_EXPORT vtkShadowCasterList
{
public:
  /// Look at the renderer's props. `requiredKeys`: only props with these keys cast; nullptr: all.
  void Update(vtkRenderer* renderer, vtkInformation* requiredKeys);

  const std::vector<vtkShadowCaster*>& GetCasters() const { return this->Casters; }

  /// Actors that do not cast, by reason.
  const std::array<int, NumberOfShadowSkips>& GetSkipped() const { return this->Skipped; }

  /// Casters whose mesh or matrix was not that of the last time.
  int GetNumberOfUpdates() const { return this->Updates; }

  /**
   * Grows with every Update() since which a visible prop, caster or not, may draw something else
   * than before. Props other than plain actors may change without a trace: with them it always
   * grows.
   */
  vtkMTimeType GetVersion() const { return this->Version; }

  /// The visible props, in the renderer's order; to compare only.
  const std::vector<vtkProp*>& GetProps() const { return this->Props; }

private:
  struct Mesh
  {
    int Path;
    const void* Block;
    std::unique_ptr<vtkShadowCaster> Caster;
  };
  struct Member
  {
    vtkNBufferSources Sources;
    bool Watched = false;    ///< Sources tell all changes.
    bool HasChanged = false; ///< Or may have, without a trace.
    bool HasNewKeys = false;
    bool Looked = false;        ///< The next three are known:
    bool Casts = false;         ///< has the required keys;
    const void* Keys = nullptr; ///< of the prop, to compare only, and their time.
    vtkMTimeType KeysTime = 0;
    vtkMTimeType Time = 0; ///< Of the last change, as far as times tell.
    std::vector<Mesh> Meshes;
    std::array<int, NumberOfShadowSkips> Skipped = {};
    std::map<int, vtkSmartPointer<vtkGeometryFilter>> Surfaces; ///< Of data sets, by path.
  };

  void Synchronize(std::vector<vtkProp*>& props);
  /// Shared out to threads: reads times alone.
  void FindChanges(bool sameRequired);
  /// Whether a prop has the required keys. vtkProp::HasKeys() makes an iterator each time, which
  /// takes longer than all the rest.
  static bool TakeKeys(vtkProp* prop, vtkInformation* required, Member& member);
  bool Look(vtkProp* prop, Member& member);
  void AddProp(vtkProp* prop, Member& member);
  void AddActor(vtkActor* actor, int path, vtkMatrix4x4* matrix, Member& member);
  void AddData(vtkActor* actor, int path, vtkMatrix4x4* matrix, vtkDataObject* data, bool visible,
    double opacity, Member& member);
  void AddMesh(vtkActor* actor, int path, vtkMatrix4x4* matrix, vtkPolyData* mesh, Member& member);

  std::vector<vtkProp*> Props;
  std::vector<Member> Members; ///< One for each prop.
  std::vector<vtkProp*> Found; ///< Kept for its memory.
  std::vector<Mesh> OldMeshes; ///< Of the member being looked at.
  vtkNBufferCandidate::GlobalState GlobalState{};
  const void* RequiredKeys = nullptr;
  vtkMTimeType RequiredTime = 0;
  vtkMTimeType Version = 0;
  std::vector<vtkShadowCaster*> Casters;
  std::array<int, NumberOfShadowSkips> Skipped = {};
  int Updates = 0;
};

VTK_ABI_NAMESPACE_END
#endif
