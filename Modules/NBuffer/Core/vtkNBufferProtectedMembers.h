// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferProtectedMembers.h
 * @brief Every protected member of VTK's classes that this module reads, and nothing else.
 *
 * C++ allows a derived class to name a protected member of its base, and the resulting pointer to
 * member works for any object of the base. VTK's public getters cannot be used: they create an
 * object that is missing, or they include the times of other objects.
 */
#ifndef vtkNBufferProtectedMembers_h
#define vtkNBufferProtectedMembers_h

#include "vtkMapper.h"
#include "vtkObject.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkProp.h"
#include "vtkTimeStamp.h"

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <algorithm>
#include <iterator>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkScalarsToColors;
class vtkShaderProperty;

namespace vtkNBufferProtectedMembers
{
/// The time stamp of an object itself. GetMTime() is virtual, and may combine several stamps.
inline const vtkTimeStamp& GetTimeStamp(const vtkObject* object)
{
  struct Access : vtkObject
  {
    static vtkTimeStamp vtkObject::*Get() { return &Access::MTime; }
  };
  return object->*Access::Get();
}

/// The time of an object itself, without those of the objects that it refers to.
inline vtkMTimeType GetOwnTime(const vtkObject* object)
{
  return GetTimeStamp(object).GetMTime();
}

/// The shader property of a prop, or nullptr. vtkProp::GetShaderProperty() would create one.
inline vtkShaderProperty* const& GetShaderProperty(const vtkProp* prop)
{
  struct Access : vtkProp
  {
    static vtkShaderProperty* vtkProp::*Get() { return &Access::ShaderProperty; }
  };
  return prop->*Access::Get();
}

/// Whether a mapper draws a selection. VTK's mapper draws one even after SetSelection(nullptr).
inline bool DrawsSelection(vtkOpenGLPolyDataMapper* mapper)
{
  struct Access : vtkOpenGLPolyDataMapper
  {
    static auto Get() { return &Access::SelectionPrimitives; }
  };
  return std::any_of(std::begin(mapper->*Access::Get()), std::end(mapper->*Access::Get()),
    [](const vtkOpenGLHelper& stream) { return stream.IBO->IndexCount > 0; });
}

/// The stream (index buffer, program and vertex array) that a mapper is about to draw, while it
/// sets the parameters of its shader; nullptr unless the mapper draws only the triangles of
/// polygons, only those of strips, or only points.
inline vtkOpenGLHelper* GetOnlyStream(vtkOpenGLPolyDataMapper* mapper)
{
  struct Access : vtkOpenGLPolyDataMapper
  {
    static vtkOpenGLHelper* Get(vtkOpenGLPolyDataMapper* mapper)
    {
      vtkOpenGLHelper* stream = mapper->*&Access::LastBoundBO;
      vtkOpenGLHelper* streams = mapper->*&Access::Primitives;
      const bool isKnown = stream == streams + PrimitiveTris ||
        stream == streams + PrimitiveTriStrips || stream == streams + PrimitivePoints;
      bool isOnly = isKnown && !(mapper->*&Access::PointPicking) && !DrawsSelection(mapper);
      for (int i = PrimitiveStart; i <= PrimitiveTriStrips; ++i)
      {
        isOnly = isOnly && (streams[i].IBO->IndexCount > 0) == (streams + i == stream);
      }
      return isOnly ? stream : nullptr;
    }
  };
  return Access::Get(mapper);
}

/// The time at which a mapper has made the oldest of its shaders; 0 if it has none.
inline vtkMTimeType GetShaderTime(vtkOpenGLPolyDataMapper* mapper)
{
  struct Access : vtkOpenGLPolyDataMapper
  {
    static vtkMTimeType Get(vtkOpenGLPolyDataMapper* mapper)
    {
      vtkMTimeType oldest = VTK_MTIME_MAX;
      for (const vtkOpenGLHelper* streams :
        { mapper->*&Access::Primitives, mapper->*&Access::SelectionPrimitives })
      {
        for (int i = PrimitiveStart; i < PrimitiveEnd; ++i)
        {
          oldest =
            streams[i].Program ? std::min(oldest, streams[i].ShaderSourceTime.GetMTime()) : oldest;
        }
      }
      return oldest == VTK_MTIME_MAX ? 0 : oldest;
    }
  };
  return Access::Get(mapper);
}

/// The number of points in the vertex buffers of a mapper.
inline std::size_t GetNumberOfVertices(vtkOpenGLPolyDataMapper* mapper)
{
  struct Access : vtkOpenGLPolyDataMapper
  {
    static auto Get() { return &Access::VBOs; }
  };
  return static_cast<std::size_t>((mapper->*Access::Get())->GetNumberOfTuples("vertexMC"));
}

/// For each stream that a mapper has drawn, the render passes that were among the property keys of
/// the actor. The mapper makes the stream's shaders anew if the next actor has others.
inline std::vector<vtkInformation*> GetLastPasses(vtkOpenGLPolyDataMapper* mapper)
{
  struct Access : vtkOpenGLPolyDataMapper
  {
    static auto Get() { return &Access::PrimitiveInfo; }
  };
  std::vector<vtkInformation*> last;
  for (auto& [stream, info] : mapper->*Access::Get())
  {
    last.push_back(info.LastRenderPassInfo);
  }
  return last;
}

/// The lookup table of a mapper, or nullptr. vtkMapper::GetLookupTable() would create one.
inline vtkScalarsToColors* const& GetLookupTable(const vtkMapper* mapper)
{
  struct Access : vtkMapper
  {
    static vtkScalarsToColors* vtkMapper::*Get() { return &Access::LookupTable; }
  };
  return mapper->*Access::Get();
}
}

VTK_ABI_NAMESPACE_END
#endif
