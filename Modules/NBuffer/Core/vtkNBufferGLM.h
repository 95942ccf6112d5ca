// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferGLM.h
 * @brief GLM as this project includes it, and the ways between its types and VTK's arrays.
 *
 * GLM's matrices are stored by columns, VTK's (vtkMatrix4x4::GetData()) by rows: a matrix goes from
 * one to the other through ToMatrix() and nowhere else. GLM is a private dependency: no public
 * header includes this file.
 *
 * Where an error bound counts roundings, the order of operations matters: glm::dot() of three
 * components adds from left to right; of four components it adds two pairs.
 */
#ifndef vtkNBufferGLM_h
#define vtkNBufferGLM_h

// A vector or matrix without arguments is zero, or the identity.
#define GLM_FORCE_CTOR_INIT

#include <glm/glm.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferGLM
{
/// Three numbers of VTK's, such as a point or a direction.
inline glm::dvec3 ToVector(const double x[3])
{
  return { x[0], x[1], x[2] };
}

/// A matrix of VTK's, row by row.
inline glm::dmat4 ToMatrix(const double rows[16])
{
  return glm::transpose(glm::make_mat4(rows));
}
}
VTK_ABI_NAMESPACE_END
#endif
