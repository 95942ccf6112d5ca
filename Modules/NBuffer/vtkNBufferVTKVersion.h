// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferVTKVersion.h
 * @brief Every difference between the supported versions of VTK (9.1 to 9.7), and nothing else.
 *
 * Code elsewhere tests for a feature by the names defined here and never for a version number.
 */
#ifndef vtkNBufferVTKVersion_h
#define vtkNBufferVTKVersion_h

#include "vtkVersionMacros.h"

// VTK before 9.2 has no ABI namespace.
#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 2
#include "vtkABINamespace.h"
#else
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

// VTK's wrappers would make the macros below members of the wrapped module.
#ifndef __VTK_WRAP__

// The header that declares OpenGL: VTK loads OpenGL with glad since 9.4, with GLEW before.
// (__has_include would say it more directly, but VTK's header parser does not know it.)
#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 4
#define VTKNBUFFER_GL_HEADER "vtk_glad.h"
#else
#define VTKNBUFFER_GL_HEADER "vtk_glew.h"
#endif

// vtkProp3D::CoordinateSystem: actors that follow a VR device or the physical world.
#define VTKNBUFFER_HAS_COORDINATE_SYSTEMS (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 2)

// The mapper that applications use for composite data whose blocks have attributes, and the header
// that declares it.
#define VTKNBUFFER_HAS_COMPOSITE_MAPPER_2 (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3)
#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
#define VTKNBUFFER_COMPOSITE_MAPPER vtkCompositePolyDataMapper2
#define VTKNBUFFER_COMPOSITE_MAPPER_HEADER "vtkCompositePolyDataMapper2.h"
#else
#define VTKNBUFFER_COMPOSITE_MAPPER vtkCompositePolyDataMapper
#define VTKNBUFFER_COMPOSITE_MAPPER_HEADER "vtkCompositePolyDataMapper.h"
#endif

// vtkCompositeDataDisplayAttributes chooses the scalars of a block, their range and lookup table.
#define VTKNBUFFER_HAS_BLOCK_SCALARS (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 3)

// vtkOpenGLBatchedPolyDataMapper draws the blocks of composite data in the order of a list of flat
// indices.
#define VTKNBUFFER_HAS_BATCHED_MAPPER (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 4)

// The geometry shader of surfaces with visible edges leaves their triangles as they are. Older
// versions widen each triangle by half of the width of the edges.
#define VTKNBUFFER_EDGES_KEEP_TRIANGLES (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 4)

// vtkAlgorithm::ABORTED(): a filter whose last run did not come to its end.
#define VTKNBUFFER_HAS_ABORTED_FILTERS (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 3)

// vtkRenderWindow::Initialize() and GetInitialized(). In older versions the first Render() makes
// the context.
#define VTKNBUFFER_HAS_INITIALIZE (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 4)

// vtkOpenGLResourceFreeCallback.h is installed; see vtkNBufferResourceCallback.h.
#define VTKNBUFFER_HAS_RESOURCE_CALLBACK (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 5)

// vtkRenderer::SetUseOIT(). In older versions order-independent transparency is always on.
#define VTKNBUFFER_HAS_OIT_SWITCH (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 5)

// The name of the function that lists the types of a vtkDataSet's cells.
#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 6
#define VTKNBUFFER_GET_CELL_TYPES GetDistinctCellTypes
#else
#define VTKNBUFFER_GET_CELL_TYPES GetCellTypes
#endif

// vtkCompositeDataDisplayAttributes::SetBlockTexture().
#define VTKNBUFFER_HAS_BLOCK_TEXTURES (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 6)

// Ambient occlusion works in a part of a window. Older versions draw outside its framebuffer.
#define VTKNBUFFER_HAS_SSAO_IN_PARTS (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 7)

// VTK's shadow maps work with props that are added later. In 9.1 such a prop ends the program.
#define VTKNBUFFER_HAS_LASTING_SHADOW_MAPS (VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 7)

#endif // __VTK_WRAP__
#endif
