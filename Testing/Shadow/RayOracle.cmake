# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# The oracle of the tests, which nbuffer-bench has as well, with and without tests.
if (NOT TARGET NBufferRayOracle)
  add_library(NBufferRayOracle STATIC
    "${CMAKE_CURRENT_LIST_DIR}/DrawnPolygon.cxx"
    "${CMAKE_CURRENT_LIST_DIR}/DrawnPolygon.h"
    "${CMAKE_CURRENT_LIST_DIR}/RayOracle.cxx"
    "${CMAKE_CURRENT_LIST_DIR}/RayOracle.h"
    "${CMAKE_CURRENT_LIST_DIR}/RenderedTriangles.cxx"
    "${CMAKE_CURRENT_LIST_DIR}/RenderedTriangles.h"
    "${CMAKE_CURRENT_LIST_DIR}/ThinSides.cxx"
    "${CMAKE_CURRENT_LIST_DIR}/ThinSides.h"
    "${CMAKE_CURRENT_LIST_DIR}/TriangleTree.cxx"
    "${CMAKE_CURRENT_LIST_DIR}/TriangleTree.h")
  nbuffer_precompile(NBufferRayOracle)
  target_include_directories(NBufferRayOracle PUBLIC "${CMAKE_CURRENT_LIST_DIR}")
  target_link_libraries(NBufferRayOracle PUBLIC VTKNBuffer::NBuffer VTK::RenderingOpenGL2)
endif ()
