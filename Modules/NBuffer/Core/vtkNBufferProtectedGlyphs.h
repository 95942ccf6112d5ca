// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferProtectedGlyphs.h
 * @brief The protected members of the mappers that draw glyphs (see vtkNBufferProtectedMembers.h).
 */
#ifndef vtkNBufferProtectedGlyphs_h
#define vtkNBufferProtectedGlyphs_h

#include "vtkGlyph3DMapper.h"
#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkTimeStamp.h"

#include <optional>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;

namespace vtkNBufferProtectedMembers
{
/// The buffers that the internal mapper of a vtkGlyph3DMapper has uploaded for its instances.
struct InstanceBuffers
{
  vtkOpenGLBufferObject* Matrices;
  vtkOpenGLBufferObject* NormalMatrices;
  vtkOpenGLBufferObject* Colors;
  vtkMTimeType BuildTime; ///< When they were uploaded.
  vtkMTimeType LoadTime;  ///< When they were attached to the vertex array.
};

/// The buffers of instances, or nothing if the instances are drawn one by one.
inline std::optional<InstanceBuffers> GetInstanceBuffers(vtkOpenGLGlyph3DHelper* mapper)
{
  struct Access : vtkOpenGLGlyph3DHelper
  {
    static std::optional<InstanceBuffers> Get(vtkOpenGLGlyph3DHelper* mapper)
    {
      if (!(mapper->*&Access::UsingInstancing))
      {
        return std::nullopt;
      }
      return InstanceBuffers{ mapper->*&Access::MatrixBuffer, mapper->*&Access::NormalMatrixBuffer,
        mapper->*&Access::ColorBuffer, (mapper->*&Access::InstanceBuffersBuildTime).GetMTime(),
        (mapper->*&Access::InstanceBuffersLoadTime).GetMTime() };
    }
  };
  return Access::Get(mapper);
}

/// The arrays from which a vtkGlyph3DMapper makes its instances; null where one is not used.
struct GlyphArrays
{
  vtkDataArray* Mask;
  vtkDataArray* Orientation;
  vtkDataArray* Scale;
  vtkDataArray* SourceIndex;
};

inline GlyphArrays GetGlyphArrays(vtkGlyph3DMapper* mapper, vtkDataSet* data)
{
  struct Access : vtkGlyph3DMapper
  {
    static GlyphArrays Get(vtkGlyph3DMapper* mapper, vtkDataSet* data)
    {
      return { (mapper->*&Access::GetMaskArray)(data),
        (mapper->*&Access::GetOrientationArray)(data), (mapper->*&Access::GetScaleArray)(data),
        (mapper->*&Access::GetSourceIndexArray)(data) };
    }
  };
  return Access::Get(mapper, data);
}
}

VTK_ABI_NAMESPACE_END
#endif
