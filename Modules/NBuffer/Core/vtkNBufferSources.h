// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSources
 * @brief All objects from which something cached was made, and whether any has changed since.
 *
 * Asking an actor, its mapper and its data for their modification times walks some thirty cache
 * lines one after the other; for 15,000 props that is most of a culled frame. Here the time stamps
 * that those methods combine are listed once, so that they can be fetched side by side, each from
 * the one cache line that it lies in.
 *
 * The list mirrors vtkActor, vtkMapper, vtkTrivialProducer, vtkPolyData, vtkPoints and
 * vtkFieldData::GetMTime, which are the same in VTK 9.1 to 9.7. Take() checks that it gives the
 * same time as they do and otherwise refuses. A shader property, which VTK makes later without
 * marking its prop as modified, is compared as well. A transform or matrix of the user's, as
 * importers give each of their actors, is asked itself: what it is concatenated from has no limit.
 *
 * An object's stamp is listed behind its owner's: it is alive if its owner has not changed.
 */
#ifndef vtkNBufferSources_h
#define vtkNBufferSources_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"
#include "vtkType.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkAlgorithm;
class vtkFieldData;
class vtkLinearTransform;
class vtkMapper;
class vtkObject;
class vtkPolyData;
class vtkShaderProperty;
class vtkTimeStamp;

class VTKNBUFFER_EXPORT vtkNBufferSources
{
public:
  /**
   * List what an actor is made of whose mapper (vtkOpenGLPolyDataMapper or vtkDataSetMapper) shows
   * polydata without a pipeline. False for others, if it does not fit, or if something unknown
   * takes part; HasChanged() must then not be asked.
   */
  bool Take(vtkActor* actor);

  /// Whether anything was modified since Take(). Reads only; safe in parallel.
  bool HasChanged() const;

  /// Have the processor fetch what HasChanged() will read.
  void Prefetch() const;

  /// The newest time of everything.
  vtkMTimeType GetTime() const { return this->Time; }

  /// A prop's shader property, or nullptr: vtkProp::GetShaderProperty() would make one.
  static vtkShaderProperty* GetShaderProperty(vtkActor* actor);

private:
  bool TakeAll(vtkActor* actor, vtkMapper* mapper, vtkAlgorithm* producer, vtkPolyData* input);
  bool Add(const vtkObject* object);
  bool AddFields(vtkFieldData* fields);
  bool HasNewer(int begin, int end) const;

  vtkMTimeType Time = 0;
  vtkActor* Actor = nullptr;
  vtkShaderProperty* Shaders = nullptr;
  vtkLinearTransform* UserTransform = nullptr;
  int Count = 0;
  int BeforeMapper = 0; ///< Stamps of the actor; the mapper's come behind.
  std::array<const vtkTimeStamp*, 18> Stamps{};
};

VTK_ABI_NAMESPACE_END
#endif
