// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferVTKVersion.h
 * @brief Every difference between the supported versions of VTK (9.1 to 9.7), and nothing else.
 *
 * Code elsewhere asks for a feature by the names defined here and never for a version number.
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

#endif
