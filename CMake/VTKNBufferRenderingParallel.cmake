# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# The target vtknbuffer_rendering_parallel, where it can be had: MPI and VTK's own classes that
# composite the pictures of several processes (vtkCompositedSynchronizedRenderers). Debian's VTK has
# ParallelMPI but not RenderingParallel. Its few sources are then compiled from the source tree of
# the same version of VTK, if VTKNBUFFER_VTK_SOURCE names it.
set(VTKNBUFFER_VTK_SOURCE "" CACHE PATH
  "Source tree of the VTK that is used, for examples and tests that need its Rendering/Parallel")
find_package(VTK QUIET OPTIONAL_COMPONENTS ParallelMPI RenderingParallel)
set(_folder "${VTKNBUFFER_VTK_SOURCE}/Rendering/Parallel")
if (NOT VTKNBUFFER_BUILD_PARALLEL OR NOT TARGET VTK::ParallelMPI)
  return()
elseif (TARGET VTK::RenderingParallel)
  add_library(vtknbuffer_rendering_parallel INTERFACE)
  target_link_libraries(vtknbuffer_rendering_parallel INTERFACE
    VTK::RenderingParallel VTK::ParallelMPI)
elseif (VTKNBUFFER_VTK_SOURCE AND EXISTS "${_folder}/vtkCompositedSynchronizedRenderers.cxx")
  set(_sources vtkCompositedSynchronizedRenderers vtkCompositer vtkCompressCompositer
    vtkParallelRenderManager vtkSynchronizedRenderWindows vtkSynchronizedRenderers vtkTreeCompositer)
  list(TRANSFORM _sources PREPEND "${_folder}/")
  list(TRANSFORM _sources APPEND ".cxx")
  add_library(vtknbuffer_rendering_parallel STATIC ${_sources})
  set(_headers "${CMAKE_CURRENT_BINARY_DIR}/RenderingParallel")
  file(CONFIGURE OUTPUT "${_headers}/vtkRenderingParallelModule.h" @ONLY CONTENT
"// In place of the export header that VTK generates.
#define VTKRENDERINGPARALLEL_EXPORT
")
  target_include_directories(vtknbuffer_rendering_parallel SYSTEM PUBLIC "${_headers}" "${_folder}")
  target_link_libraries(vtknbuffer_rendering_parallel PUBLIC
    VTK::CommonSystem VTK::FiltersExtraction VTK::ImagingCore VTK::IOImage VTK::ParallelMPI
    VTK::RenderingOpenGL2)
  target_compile_options(vtknbuffer_rendering_parallel PRIVATE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-w>)
endif ()
