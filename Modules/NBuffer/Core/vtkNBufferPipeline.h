// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferPipeline
 * @brief Whether an actor with a pipeline upstream of its mapper shows what it showed before.
 *
 * Where vtkNBufferSources does not help, because filters and sources make the data, asking for
 * bounds sends three requests up the pipeline, which takes as long as drawing a small prop. The
 * first thing that VTK does for them is to ask all filters for their modification times; if none
 * is newer than the data, the requests end without effect. Here only that is asked.
 *
 * A filter may also run because another time step is requested, because its last run was aborted
 * or because its data was released. Such pipelines are not taken, or count as changed.
 */
#ifndef vtkNBufferPipeline_h
#define vtkNBufferPipeline_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"
#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkDataObject;
class vtkMapper;
class vtkShaderProperty;

class VTKNBUFFER_EXPORT vtkNBufferPipeline
{
public:
  /**
   * Remember an actor whose mapper (vtkOpenGLPolyDataMapper or vtkDataSetMapper) shows polydata and
   * whose pipeline has just been updated. False for others, and if something takes part whose
   * changes do not show in modification times; HasChanged() must then not be asked.
   */
  bool Take(vtkActor* actor);

  /// Whether anything was modified since Take(), or may run again. About a microsecond, not to be
  /// asked in parallel: pipelines note the times that they find, and may share filters.
  bool HasChanged() const;

private:
  bool GetTime(vtkMTimeType& time) const;

  vtkActor* Actor = nullptr;
  vtkMapper* Mapper = nullptr;
  vtkDataObject* Input = nullptr;
  vtkShaderProperty* Shaders = nullptr;
  vtkMTimeType Time = 0;
};

VTK_ABI_NAMESPACE_END
#endif
