// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferPropWatch
 * @brief Whether what a prop draws has changed since it was last read.
 *
 * Culler and shadows cache what they know of a prop for as long as this class finds no change. VTK
 * takes all modification times from one global counter, so any change makes the newest time of
 * everything that an actor is made of grow. Track() chooses the cheapest means to see that:
 *
 * - Stamps: the mapper shows polydata without a pipeline. The time stamps of all objects are listed
 *   once and then compared, each in one cache line. vtkActor::GetMTime() and vtkMapper::GetMTime()
 *   walk some thirty cache lines one after the other, which for 15,000 props takes most of a culled
 *   frame.
 * - Pipeline: filters or sources make the polydata. vtkActor::GetBounds() sends three requests up
 *   the pipeline, which takes as long as drawing a small prop. VTK begins each request by querying
 *   the modification times of all filters, and ends it if none is newer than the data. HasChanged()
 *   does only this first step, in about a microsecond.
 * - Times: any other mapper of vtkNBufferSurface::IsPlain(), and an actor without a mapper. The
 *   times are known only after the pipeline was updated, as VTK does before it draws. HasChanged()
 *   is always true, and GetTime() says after the next Track() whether there was a change.
 * - None: any other prop or mapper may change without a trace.
 *
 * The list of stamps mirrors GetMTime() of vtkActor, vtkMapper, vtkTrivialProducer, vtkPolyData,
 * vtkPoints and vtkFieldData, which are the same in VTK 9.1 to 9.7. Track() verifies that the list
 * gives the same time as they do, and otherwise does not use it. An object's stamp is listed after
 * that of its owner: the object is alive if its owner has not changed. Two things are compared
 * besides: the shader property, which VTK creates later without marking its prop as modified, and
 * the user's transform, as importers give to each actor, which may concatenate any number of
 * others.
 *
 * A filter may run again without a newer time because another time step is requested, because its
 * last run was aborted, or because its data was released. HasChanged() is true then.
 */
#ifndef vtkNBufferPropWatch_h
#define vtkNBufferPropWatch_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"
#include "vtkType.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkDataObject;
class vtkFieldData;
class vtkLinearTransform;
class vtkMapper;
class vtkObject;
class vtkPolyData;
class vtkProp;
class vtkShaderProperty;
class vtkTimeStamp;

class VTKNBUFFER_EXPORT vtkNBufferPropWatch
{
public:
  /// How changes are found, see above.
  enum class Means
  {
    None,
    Times,
    Pipeline,
    Stamps
  };

  /// Find changes from now on. The prop's pipeline must be up to date.
  void Track(vtkProp* prop);

  Means GetMeans() const { return this->How; }

  ///@{
  /**
   * Whether anything may have been modified since Track(); true before the first Track().
   * MayHaveChanged() reads time stamps only, is true for everything that does not show in them, and
   * may be called in parallel. HasChanged() queries the pipeline as well. It must not be called in
   * parallel, because pipelines store the times that they find, and may share filters.
   */
  bool MayHaveChanged() const { return this->How != Means::Stamps || this->StampsHaveChanged(); }
  bool HasChanged() const
  {
    return this->How == Means::Pipeline ? this->PipelineHasChanged() : this->MayHaveChanged();
  }
  ///@}

  /// Have the processor fetch what MayHaveChanged() will read.
  void Prefetch() const;

  /**
   * The newest time of everything that the prop draws, as Track() found it: the actor, its
   * property, texture, user's transform and shader property, the mapper, its clipping planes and
   * data, and the blocks of composite data. It is 0 for a prop that is no plain actor.
   */
  vtkMTimeType GetTime() const { return this->Time; }

  /**
   * Whether every change shows in GetTime(). This is false for the props of means None, for
   * composite data, whose blocks have attributes without times, for replaced shaders, whose
   * uniforms have none, and for actors that follow a device.
   */
  bool SeesAllChanges() const { return this->Complete; }

  /// VTK's settings for all mappers, which change what props draw without changing their times.
  using GlobalState = std::array<double, 6>;
  static GlobalState GetGlobalState();

private:
  bool TrackStamps(vtkMapper* mapper, vtkPolyData* input);
  bool Add(const vtkObject* object);
  bool AddFields(vtkFieldData* fields);
  bool HasNewer(int begin, int end) const;
  bool StampsHaveChanged() const;
  bool GetPipelineTime(vtkMTimeType& time) const;
  bool PipelineHasChanged() const;

  Means How = Means::None;
  bool Complete = false;
  int Count = 0;        ///< The number of time stamps.
  int BeforeMapper = 0; ///< How many of them belong to the actor. The mapper's follow.
  vtkMTimeType Time = 0;
  vtkMTimeType PipelineTime = 0;
  vtkActor* Actor = nullptr;
  vtkMapper* Mapper = nullptr;
  vtkDataObject* Input = nullptr;
  vtkShaderProperty* Shaders = nullptr;
  vtkLinearTransform* UserTransform = nullptr;
  std::array<const vtkTimeStamp*, 18> Stamps{};
};

VTK_ABI_NAMESPACE_END
#endif
