# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# What makes a build from nothing short. Most of the time of a file of this project goes into
# reading VTK's, GoogleTest's and the standard library's headers, and into optimising what they
# bring along. The headers are read once, as precompiled headers, several sources are compiled as
# one (a unity build), and the code of tests is optimised less.
#
# Nothing of this reaches VTK's own tree, where the module is built without this file.

# Who gives a launcher by hand shares a cache between checkouts as a rule. Precompiled headers
# contain the paths of their checkout and would be the end of that.
set(_nbuffer_precompile ON)
if (CMAKE_CXX_COMPILER_LAUNCHER)
  set(_nbuffer_precompile OFF)
endif ()
option(VTKNBUFFER_PRECOMPILE_HEADERS
  "Read the headers of VTK and the standard library once for many files" ${_nbuffer_precompile})
option(VTKNBUFFER_UNITY_BUILD "Compile several source files as one" ON)
option(VTKNBUFFER_CCACHE
  "Take ccache as the compilers' launcher where it is installed and no other launcher is given" ON)

# Without these words ccache refuses to look at files that use a precompiled header. The time
# macros __DATE__ and __TIME__, which they let pass, are not used here.
find_program(VTKNBUFFER_CCACHE_PROGRAM ccache)
mark_as_advanced(VTKNBUFFER_CCACHE_PROGRAM)
if (VTKNBUFFER_CCACHE AND VTKNBUFFER_CCACHE_PROGRAM)
  foreach (_language IN ITEMS C CXX)
    if (NOT CMAKE_${_language}_COMPILER_LAUNCHER)
      set(CMAKE_${_language}_COMPILER_LAUNCHER
        "${CMAKE_COMMAND}" -E env "CCACHE_SLOPPINESS=pch_defines,time_macros"
        "${VTKNBUFFER_CCACHE_PROGRAM}")
    endif ()
  endforeach ()
endif ()

# What nearly every file reads, sorted by what it belongs to. Headers of VTK's rendering are for
# the module alone: they depend on macros (autoinit) that differ from program to program, and a
# precompiled header is of use only where all of its macros are the same.
set(_nbuffer_standard_headers
  <algorithm> <array> <cmath> <cstddef> <cstdint> <functional> <iostream> <limits> <map> <memory>
  <random> <set> <sstream> <string> <utility> <vector>)
set(_nbuffer_data_headers
  <vtkCellArray.h> <vtkMath.h> <vtkMatrix4x4.h> <vtkNew.h> <vtkPoints.h> <vtkPolyData.h>
  <vtkSmartPointer.h>)
set(_nbuffer_rendering_headers
  <vtkActor.h> <vtkCamera.h> <vtkOpenGLRenderWindow.h> <vtkOpenGLState.h> <vtkProperty.h>
  <vtkRenderer.h> <vtkShaderProgram.h>)

# _nbuffer_unite(<target>...)
#
# Files that stand next to each other in the target's list are compiled as one: what they include is
# read once, and templates and inline functions that several of them use are compiled once. Names in
# anonymous namespaces have to differ within a target. A target that sets UNITY_GROUP for files of
# its own sets UNITY_BUILD_MODE GROUP, too.
#
# GCC warns of a class with a base in an anonymous namespace that is not in the compiler's main
# file. It is meant for headers, and here every source is included by another one.
set(_nbuffer_unity_files 8)
function (_nbuffer_unite)
  set_target_properties(${ARGN} PROPERTIES
    UNITY_BUILD "${VTKNBUFFER_UNITY_BUILD}"
    UNITY_BUILD_BATCH_SIZE ${_nbuffer_unity_files})
  if (VTKNBUFFER_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    foreach (target IN LISTS ARGN)
      target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    endforeach ()
  endif ()
endfunction ()

# nbuffer_precompile_module(<target>)
#
# The module's own precompiled header: it is compiled for a shared library, which nothing else is.
# Called from outside of the module's CMakeLists.txt, which VTK's own tree reads too.
function (nbuffer_precompile_module target)
  get_target_property(aliased ${target} ALIASED_TARGET)
  if (aliased)
    set(target ${aliased})
  endif ()
  _nbuffer_unite(${target})
  if (NOT VTKNBUFFER_PRECOMPILE_HEADERS)
    return()
  endif ()
  target_precompile_headers(${target} PRIVATE
    ${_nbuffer_standard_headers} ${_nbuffer_data_headers} ${_nbuffer_rendering_headers})
endfunction ()

# _nbuffer_add_precompiled(<name> OPTIONS <options>... LIBRARIES <libraries>... HEADERS <headers>...)
#
# A target of one empty file whose precompiled header others use.
function (_nbuffer_add_precompiled name)
  if (TARGET ${name})
    return()
  endif ()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "OPTIONS;LIBRARIES;HEADERS")
  set(source "${CMAKE_BINARY_DIR}/CMakeFiles/${name}.cxx")
  file(CONFIGURE OUTPUT "${source}"
    CONTENT "// A precompiled header belongs to a target, and a target has a file.\n" @ONLY)
  add_library(${name} OBJECT "${source}")
  target_compile_options(${name} PRIVATE ${arg_OPTIONS})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction ()

# nbuffer_precompile(<target>...)
#
# For static libraries and programs that are optimised as the build type says.
function (nbuffer_precompile)
  _nbuffer_unite(${ARGN})
  if (NOT VTKNBUFFER_PRECOMPILE_HEADERS)
    return()
  endif ()
  _nbuffer_add_precompiled(vtknbuffer_headers
    LIBRARIES VTK::CommonDataModel
    HEADERS ${_nbuffer_standard_headers} ${_nbuffer_data_headers})
  foreach (target IN LISTS ARGN)
    target_precompile_headers(${target} REUSE_FROM vtknbuffer_headers)
  endforeach ()
endfunction ()

# nbuffer_speed_up_tests(<target>...)
#
# For programs of tests: precompiled headers, GoogleTest's among them, and less optimisation. A
# test's own code runs once or a few times; what takes time when tests run (the module, the ray
# oracle, the fuzzer, VTK and the driver) is not compiled with these options.
set(_nbuffer_test_options
  $<$<AND:$<CXX_COMPILER_ID:GNU,Clang,AppleClang>,$<CONFIG:Release,RelWithDebInfo>>:-O1>)
function (nbuffer_speed_up_tests)
  foreach (target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE ${_nbuffer_test_options})
  endforeach ()
  _nbuffer_unite(${ARGN})
  if (NOT VTKNBUFFER_PRECOMPILE_HEADERS)
    return()
  endif ()
  _nbuffer_add_precompiled(vtknbuffer_test_headers
    OPTIONS ${_nbuffer_test_options}
    LIBRARIES VTK::CommonDataModel GTest::gtest
    HEADERS ${_nbuffer_standard_headers} ${_nbuffer_data_headers} <gtest/gtest.h>)
  foreach (target IN LISTS ARGN)
    target_precompile_headers(${target} REUSE_FROM vtknbuffer_test_headers)
  endforeach ()
endfunction ()
