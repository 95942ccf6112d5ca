# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# What makes a build from nothing short. Most of the time of a file of this project goes into
# reading VTK's, GoogleTest's and the standard library's headers, and into optimising what they
# bring along. The headers are read once, as precompiled headers, several sources are compiled as
# one (a unity build), and code whose own speed does not matter is optimised less.
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
# anonymous namespaces have to differ within a target.
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

# _nbuffer_share_headers(<name>
#   [OPTIONS <options>...] [LIBRARIES <libraries>...] [HEADERS <headers>...] TARGETS <targets>...)
#
# The targets use the precompiled headers of the standard library, of VTK's data and the given ones.
# These belong to a target <name> of one empty file, which is compiled with the options. Shared
# libraries have other options for position-independent code, and use none.
function (_nbuffer_share_headers name)
  if (NOT VTKNBUFFER_PRECOMPILE_HEADERS)
    return()
  endif ()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "OPTIONS;LIBRARIES;HEADERS;TARGETS")
  if (NOT TARGET ${name})
    set(source "${CMAKE_BINARY_DIR}/CMakeFiles/${name}.cxx")
    file(CONFIGURE OUTPUT "${source}"
      CONTENT "// A precompiled header belongs to a target, and a target has a file.\n" @ONLY)
    add_library(${name} OBJECT "${source}")
    target_compile_options(${name} PRIVATE ${arg_OPTIONS})
    target_link_libraries(${name} PRIVATE VTK::CommonDataModel ${arg_LIBRARIES})
    target_precompile_headers(${name} PRIVATE
      ${_nbuffer_standard_headers} ${_nbuffer_data_headers} ${arg_HEADERS})
  endif ()
  foreach (target IN LISTS arg_TARGETS)
    get_target_property(type ${target} TYPE)
    if (NOT type STREQUAL "SHARED_LIBRARY")
      target_precompile_headers(${target} REUSE_FROM ${name})
    endif ()
  endforeach ()
endfunction ()

# nbuffer_precompile(<target>...)
#
# For libraries and programs whose own speed is measured. They are optimised as the build type says.
function (nbuffer_precompile)
  _nbuffer_unite(${ARGN})
  _nbuffer_share_headers(vtknbuffer_headers TARGETS ${ARGN})
endfunction ()

# nbuffer_speed_up(<target>...)
# nbuffer_speed_up_tests(<target>...)
#
# For other libraries and programs, and for programs of tests: less optimisation. Their own code runs
# once or a few times; what takes time when they run (the module, the ray oracle, VTK and the driver)
# is not compiled with these options. The precompiled headers of tests have GoogleTest's, too.
set(_nbuffer_less_optimization
  $<$<AND:$<CXX_COMPILER_ID:GNU,Clang,AppleClang>,$<CONFIG:Release,RelWithDebInfo>>:-O1>)
function (_nbuffer_optimize_less)
  foreach (target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE ${_nbuffer_less_optimization})
  endforeach ()
  _nbuffer_unite(${ARGN})
endfunction ()
function (nbuffer_speed_up)
  _nbuffer_optimize_less(${ARGN})
  _nbuffer_share_headers(vtknbuffer_program_headers
    OPTIONS ${_nbuffer_less_optimization} TARGETS ${ARGN})
endfunction ()
function (nbuffer_speed_up_tests)
  _nbuffer_optimize_less(${ARGN})
  _nbuffer_share_headers(vtknbuffer_test_headers
    OPTIONS ${_nbuffer_less_optimization} LIBRARIES GTest::gtest HEADERS <gtest/gtest.h>
    TARGETS ${ARGN})
endfunction ()
