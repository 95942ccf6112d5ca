// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferKnownClasses.h
 * @brief Which classes of passes, mappers and actors are known to draw what the culler relies on.
 *
 * The known classes are those of VTK that were examined, and those that an application vouches for.
 * vtkNBufferCuller::AddKnownPass(), AddKnownMapper() and AddKnownActor() say what the application
 * promises by this. The names that it adds hold for the whole process, because a promise is about a
 * class, and the code that gives it (a script, a plug-in) may have no access to every culler. They
 * cannot be removed. All functions may be called by several threads.
 */
#ifndef vtkNBufferKnownClasses_h
#define vtkNBufferKnownClasses_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkMapper;
class vtkProp;
class vtkRenderPass;

namespace vtkNBufferKnownClasses
{
enum List
{
  Passes,
  Mappers,
  Actors
};

/// Add a class of an application by the name that GetClassName() returns. Returns false, and adds
/// nothing, if the name is null or empty.
VTKNBUFFER_EXPORT bool Add(List list, const char* name);

/// A number that grows with each new name. Props that were read before have to be read again
/// (vtkNBufferPropWatch::GetGlobalState()).
VTKNBUFFER_EXPORT int GetVersion();

/// Whether a mapper is known to draw the polygons of its input. Some subclasses of
/// vtkPolyDataMapper draw splats, spheres, sticks or labels at the points instead, and one that
/// draws in several pieces has only one of them as its input.
bool DrawsPolygons(vtkMapper* mapper);

/// Whether a pass is of a known class. It looks up a name, and is meant for the few passes of a
/// renderer.
VTKNBUFFER_EXPORT bool IsKnown(vtkRenderPass* pass);

/// The kinds of mappers whose drawing is known.
enum class MapperKind
{
  PolyData,
  DataSet,
  Composite,
  Other
};

///@{
/**
 * The kind of a mapper, and the prop if it is a plain actor, otherwise nullptr. Subclasses of VTK's
 * classes may draw anything. They are Other and nullptr, unless the application vouches for them.
 * The names of subclasses are looked up, so that these functions are meant for props that are read
 * anew, and not for each prop in each frame.
 */
VTKNBUFFER_EXPORT MapperKind GetKind(vtkMapper* mapper);
VTKNBUFFER_EXPORT vtkActor* GetPlainActor(vtkProp* prop);
///@}

/// Whether a plain actor and its mapper, which must not be nullptr, are of VTK's own classes. Of
/// these it is known which objects' times GetMTime() combines; subclasses may override GetMTime().
VTKNBUFFER_EXPORT bool HaveKnownTimes(vtkActor* actor);
}
VTK_ABI_NAMESPACE_END
#endif
