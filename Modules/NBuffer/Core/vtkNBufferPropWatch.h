// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferPropWatch
 * @brief Whether what a prop draws has changed since it was last read.
 *
 * The culler and the shadow pass cache what they know of a prop for as long as this class finds no
 * change. An actor consists of many objects (property, mapper, data, ...). VTK takes all
 * modification times from one global counter, so any change of any of them increases the newest of
 * their times. Track() chooses the cheapest means to detect that:
 *
 * - Stamps: the mapper shows polydata without a pipeline. Track() lists all objects, and each later
 *   check reads only their time stamps, one cache line for each. vtkActor::GetMTime() and
 *   vtkMapper::GetMTime() read some thirty cache lines one after the other, which for 15,000 props
 *   takes most of a culled frame. After Observe() only the actor's stamp is read, or no stamp at
 *   all (IsWhollyObserved()), as long as vtkNBufferObservedObjects says that no observed object has
 *   been modified.
 * - Pipeline: filters or sources make the polydata, or actor or mapper are of a class that the
 *   application vouches for, which may override GetMTime(). vtkActor::GetBounds() sends three
 *   requests up the pipeline, which takes as long as drawing a small prop. VTK begins each request
 *   by querying the modification times of all filters, and ends it if none is newer than the data.
 *   HasChanged() does only this first step, in about a microsecond.
 * - Times: any other plain mapper (vtkNBufferSurface::IsPlain()), a mapper of glyphs that is known
 *   (vtkNBufferGlyphs::GetMapper()), or an actor without a mapper. The times are known only after
 *   the pipeline has been updated, as VTK does before it draws. HasChanged() is always true. A
 *   change shows in GetTime() after the next Track().
 * - None: any other prop or mapper. It may change without a newer time.
 *
 * The list of stamps mirrors GetMTime() of vtkActor, vtkMapper, vtkTrivialProducer, vtkPolyData,
 * vtkPoints and vtkFieldData, which are the same in VTK 9.1 to 9.7. Track() verifies that the list
 * gives the same time as these functions, and otherwise does not use it. An object is listed after
 * its owner: it is alive if its owner has not changed. Two objects are not in the list and are
 * compared separately: the shader property, which VTK may create later without marking its prop as
 * modified, and the user's transform, which importers give to each actor and which may concatenate
 * any number of others.
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
class vtkNBufferObservedObjects;
class vtkObject;
class vtkPolyData;
class vtkProp;
class vtkShaderProperty;

class VTKNBUFFER_EXPORT vtkNBufferPropWatch
{
public:
  /// How changes are found; see above.
  enum class Means
  {
    None,
    Times,
    Pipeline,
    Stamps
  };

  /// Find changes from now on. The prop's pipeline must be up to date. With `withBlocks` GetTime()
  /// includes the blocks of composite data, which have to be visited one by one.
  void Track(vtkProp* prop, bool withBlocks = true);

  Means GetMeans() const { return this->How; }

  /// The mapper that the actor had in Track(), which may have been deleted since.
  const vtkMapper* GetMapper() const { return this->Mapper; }

  ///@{
  /**
   * Whether anything may have been modified since Track(), or whether another prop has been made at
   * the address of a deleted actor; true before the first Track().
   *
   * MayHaveChanged() only reads time stamps, and may be called in parallel. It is true for all
   * means other than Stamps. `observedAreUnchanged` says that no observed object has been modified
   * since the last call. HasChanged() also queries the pipeline. It must not be called in parallel,
   * because pipelines store the times that they find, and may share filters.
   */
  bool MayHaveChanged(bool observedAreUnchanged = false) const
  {
    return this->How != Means::Stamps || this->ActorHasChanged() ||
      (!(observedAreUnchanged && this->Observed) && this->ObjectsHaveChanged());
  }
  bool HasChanged() const
  {
    return this->How == Means::Pipeline ? this->PipelineHasChanged() : this->MayHaveChanged();
  }
  ///@}

  /// Prefetch the memory that MayHaveChanged() will read.
  void Prefetch(bool observedAreUnchanged = false) const;

  ///@{
  /**
   * Observe() lets `actors` observe the actor, and `objects` all other objects of the prop, until
   * the next Track() or Forget(). It does nothing for means other than Stamps, if there are too
   * many objects, and in the first call after Track(): a prop that has not changed from one call to
   * the next will probably not change soon. Two kinds of actors are not observed: those with a
   * user's transform, which may depend on any number of others, and those that have never been
   * drawn, for VTK creates their shader property without an event. (Creating it here would change
   * when the mapper builds its shaders anew, and so what is drawn of actors that share a mapper.)
   *
   * IsObserved() says whether the other objects are observed, IsWhollyObserved() whether the actor
   * is, too, so that every change of the prop invokes an event.
   */
  void Observe(vtkNBufferObservedObjects& objects, vtkNBufferObservedObjects& actors);
  void Forget() { this->Observed = this->ActorObserved = false; }
  bool IsObserved() const { return this->Observed; }
  bool IsWhollyObserved() const { return this->ActorObserved; }
  ///@}

  /**
   * The newest time of everything that the prop draws, as Track() found it: the actor, its
   * property, texture, user's transform and shader property, the mapper, its clipping planes and
   * data, and the blocks of composite data if Track() had to visit them. It is 0 for a prop that is
   * no plain actor.
   */
  vtkMTimeType GetTime() const { return this->Time; }

  /**
   * Whether every change shows in GetTime(). This is false for the props of means None, for glyphs,
   * for composite data, whose blocks have attributes without times, for replaced shaders, whose
   * uniforms have none, and for actors that follow a device.
   */
  bool SeesAllChanges() const { return this->Complete; }

  /// The time of data (0 for none) and, if `withBlocks` is true, of the blocks of composite data.
  static vtkMTimeType GetDataTime(vtkDataObject* data, bool withBlocks);

  /// What may change what props draw, or which props are known, without changing the times of the
  /// props: VTK's settings for all mappers, and the version of vtkNBufferKnownClasses.
  using GlobalState = std::array<double, 8>;
  static GlobalState GetGlobalState();

private:
  bool TrackStamps(vtkMapper* mapper, vtkPolyData* input);
  bool Add(vtkObject* object);
  bool AddFields(vtkFieldData* fields);
  bool ActorHasChanged() const;
  bool ObjectsHaveChanged() const;
  bool GetPipelineTime(vtkMTimeType& time) const;
  bool PipelineHasChanged() const;

  // What MayHaveChanged() reads of each prop in each frame comes first, to share a cache line.
  Means How = Means::None;
  bool Observed = false;
  bool ActorObserved = false;
  bool IsSettled = false; ///< Whether Observe() has been called since Track().
  bool Complete = false;
  vtkMTimeType Time = 0;
  vtkActor* Actor = nullptr;
  vtkShaderProperty* Shaders = nullptr;
  vtkLinearTransform* UserTransform = nullptr;

  vtkMapper* Mapper = nullptr;
  vtkDataObject* Input = nullptr;
  vtkMTimeType PipelineTime = 0;
  int Count = 0; ///< The number of objects whose time stamps are compared besides the actor's.
  std::array<vtkObject*, 18> Objects{};
};

VTK_ABI_NAMESPACE_END
#endif
