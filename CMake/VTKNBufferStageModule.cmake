# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# vtk_module_build computes a module's binary folder from CMAKE_SOURCE_DIR, so
# a vtk.module in the root itself has none. A staged copy beside a CMakeLists.txt
# of two lines stands in for it. Outside of VTK's own tree the module is in a
# namespace of its own.
set(VTKNBUFFER_MODULE VTKNBuffer::NBuffer)
set(_stage "${CMAKE_CURRENT_BINARY_DIR}/ModuleStage/NBuffer")
set(VTKNBUFFER_MODULE_FILE "${_stage}/vtk.module")

set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  vtk.module Modules/NBufferParallel/vtk.module)
file(READ vtk.module _module)
string(REPLACE "VTK::NBuffer\n" "${VTKNBUFFER_MODULE}\n" _module "${_module}")
file(CONFIGURE OUTPUT "${VTKNBUFFER_MODULE_FILE}" @ONLY CONTENT "@_module@")

file(CONFIGURE OUTPUT "${_stage}/CMakeLists.txt" @ONLY CONTENT
"set(VTKNBUFFER_MODULE @VTKNBUFFER_MODULE@)
add_subdirectory(\"@PROJECT_SOURCE_DIR@/Modules/NBuffer\" \"@_stage@/build\")
")

# The module for parallel programs has a folder of its own, but needs the other namespace, too.
set(VTKNBUFFER_PARALLEL_MODULE)
set(VTKNBUFFER_PARALLEL_MODULE_FILE)
if (VTKNBUFFER_BUILD_PARALLEL)
  set(VTKNBUFFER_PARALLEL_MODULE VTKNBuffer::NBufferParallel)
  set(_stage "${CMAKE_CURRENT_BINARY_DIR}/ModuleStage/NBufferParallel")
  set(VTKNBUFFER_PARALLEL_MODULE_FILE "${_stage}/vtk.module")
  file(READ Modules/NBufferParallel/vtk.module _module)
  string(REPLACE "VTK::NBuffer" "VTKNBuffer::NBuffer" _module "${_module}")
  file(CONFIGURE OUTPUT "${VTKNBUFFER_PARALLEL_MODULE_FILE}" @ONLY CONTENT "@_module@")
  file(CONFIGURE OUTPUT "${_stage}/CMakeLists.txt" @ONLY CONTENT
"set(VTKNBUFFER_PARALLEL_MODULE @VTKNBUFFER_PARALLEL_MODULE@)
add_subdirectory(\"@PROJECT_SOURCE_DIR@/Modules/NBufferParallel\" \"@_stage@/build\")
")
endif ()
