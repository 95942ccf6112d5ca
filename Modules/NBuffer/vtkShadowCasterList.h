// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowCasterList
 * @brief Which props of a renderer cast, whether the camera sees them or not.
 *
 * Of every visible prop of the renderer the actors are looked at, those in assemblies too. An actor
 * casts if it is drawn opaque, as a surface, by a mapper of polydata or of composite data sets of
 * them. What cannot cast is counted by reason (vtkShadowSkip).
 *
 * Pipelines are brought up to date, as VTK does before it draws.
 */
#ifndef vtkShadowCasterList_h
#define vtkShadowCasterList_h

#include "vtkShadowCaster.h"
#include "vtkShadowStatistics.h"

#include <array>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkDataObject;
class vtkInformation;
class vtkMatrix4x4;
class vtkPolyData;
class vtkProp;
class vtkRenderer;

class vtkShadowCasterList
{
public:
  /// Look at the renderer's props. `requiredKeys`: only props with these keys cast; nullptr: all.
  void Update(vtkRenderer* renderer, vtkInformation* requiredKeys);

  const std::vector<vtkShadowCaster*>& GetCasters() const { return this->Casters; }

  /// Actors that do not cast, by reason.
  const std::array<int, NumberOfShadowSkips>& GetSkipped() const { return this->Skipped; }

  /// Casters whose mesh or matrix was not that of the last time.
  int GetNumberOfUpdates() const { return this->Updates; }

private:
  using Key = std::tuple<const void*, int, const void*>; ///< Actor, path, block.
  struct Entry
  {
    std::unique_ptr<vtkShadowCaster> Caster;
    unsigned int Round = 0;
  };

  void AddProp(vtkProp* prop);
  void AddActor(vtkActor* actor, int path, vtkMatrix4x4* matrix);
  void AddData(vtkActor* actor, int path, vtkMatrix4x4* matrix, vtkDataObject* data, bool visible,
    double opacity);
  void AddMesh(vtkActor* actor, int path, vtkMatrix4x4* matrix, vtkPolyData* mesh);
  void Skip(vtkShadowSkip reason) { ++this->Skipped[static_cast<int>(reason)]; }

  std::map<Key, Entry> Entries;
  unsigned int Round = 0;
  std::vector<vtkShadowCaster*> Casters;
  std::array<int, NumberOfShadowSkips> Skipped = {};
  int Updates = 0;
};

VTK_ABI_NAMESPACE_END
#endif
