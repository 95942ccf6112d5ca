// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestedBackend.h
 * @brief The back-end of the culler in tests that name none.
 */
#ifndef TestedBackend_h
#define TestedBackend_h

#include "vtkNBufferCuller.h"

#include <cstdlib>
#include <cstring>

/**
 * Returns `backend`, or OpenGL if it is Auto and the environment variable VTKNBUFFER_TEST_BACKEND
 * is "opengl". With a software renderer Auto is the CPU, so that only in this way tests meet there
 * what they meet on graphics devices.
 */
inline int GetTestedBackend(int backend)
{
  const char* wanted = std::getenv("VTKNBUFFER_TEST_BACKEND");
  return backend == vtkNBufferCuller::Auto && wanted && std::strcmp(wanted, "opengl") == 0
    ? vtkNBufferCuller::OpenGL
    : backend;
}

/**
 * Returns true if the culler tests pixels whenever texels leave a doubt. With the OpenGL back-end
 * it reads no pixels for fewer than 32 candidates, nor for the units of large props, so that it
 * draws more of them.
 */
inline bool TestsAllPixels(vtkNBufferCuller* culler)
{
  return culler->GetBackendInUse() == vtkNBufferCuller::CPU;
}

#endif
