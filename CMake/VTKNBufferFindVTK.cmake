# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# VTK by the usual CMake way (CMAKE_PREFIX_PATH or VTK_DIR). Components are
# always named: without them some packaged VTKs pull in MPI, Qt, Java, HDF5.
if (NOT DEFINED CMAKE_POLICY_DEFAULT_CMP0174)
  # VTK 9.7's module functions rely on it and CMake 3.31 warns about each call.
  set(CMAKE_POLICY_DEFAULT_CMP0174 OLD)
endif ()
set(VTKNBUFFER_VTK_COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath FiltersGeometry
  RenderingCore RenderingOpenGL2 jsoncpp)
set(_python_components)
if (VTKNBUFFER_WRAP_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
  set(_python_components Python WrappingPythonCore)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${VTKNBUFFER_VTK_COMPONENTS} ${_python_components})

# The module for parallel programs, where VTK has what it needs. Wheels do without it.
find_package(VTK 9.1 QUIET OPTIONAL_COMPONENTS ParallelCore)
set(_has_parallel OFF)
if (TARGET VTK::ParallelCore AND NOT SKBUILD)
  set(_has_parallel ON)
endif ()
option(VTKNBUFFER_BUILD_PARALLEL
  "Build the module NBufferParallel, which needs VTK::ParallelCore" ${_has_parallel})
if (VTKNBUFFER_BUILD_PARALLEL)
  if (NOT TARGET VTK::ParallelCore)
    message(FATAL_ERROR
      "This VTK has no module ParallelCore. Configure with -DVTKNBUFFER_BUILD_PARALLEL=OFF or use "
      "another VTK.")
  endif ()
  list(APPEND VTKNBUFFER_VTK_COMPONENTS ParallelCore)
endif ()

# The Python package that contains this VTK, and the folder of ours for modules compiled for it.
get_property(VTKNBUFFER_VTK_PACKAGE TARGET VTK::CommonCore
  PROPERTY INTERFACE_vtk_module_python_package)
if (VTKNBUFFER_VTK_PACKAGE STREQUAL "cvista")
  set(VTKNBUFFER_PYTHON_FOLDER "_cvista")
else ()
  set(VTKNBUFFER_VTK_PACKAGE "vtkmodules")
  set(VTKNBUFFER_PYTHON_FOLDER "_vtk")
endif ()

# What only the examples and tests need.
set(VTKNBUFFER_EXAMPLE_COMPONENTS
  ChartsCore CommonColor CommonTransforms FiltersCore FiltersGeneral FiltersModeling FiltersSources
  ImagingCore IOExport IOExportGL2PS IOGeometry IOImage IOImport IOLegacy IOPLY IOXML
  InteractionStyle RenderingAnnotation RenderingContext2D RenderingContextOpenGL2
  RenderingFreeType RenderingGL2PSOpenGL2 RenderingVolume RenderingVolumeOpenGL2 ViewsContext2D)
if (VTKNBUFFER_BUILD_EXAMPLES OR VTKNBUFFER_BUILD_TESTING)
  find_package(VTK 9.1 REQUIRED COMPONENTS ${VTKNBUFFER_EXAMPLE_COMPONENTS})
  list(TRANSFORM VTKNBUFFER_EXAMPLE_COMPONENTS PREPEND "VTK::" OUTPUT_VARIABLE VTKNBUFFER_EXAMPLE_TARGETS)
endif ()
