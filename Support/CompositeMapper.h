// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CompositeMapper.h
 * @brief One name, CompositeMapper, for the mapper of composite data that draws with OpenGL, which
 * has different names in different versions of VTK.
 */
#ifndef CompositeMapper_h
#define CompositeMapper_h

#include "vtkNBufferVTKVersion.h"

#include VTKNBUFFER_COMPOSITE_MAPPER_HEADER

using CompositeMapper = VTKNBUFFER_COMPOSITE_MAPPER;

#endif
