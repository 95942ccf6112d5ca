# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# Run by CTest with -D: checkout (of this project), source (the emulation of
# VTK's tree), work (where to put it), and how the build had been configured.
set(tree "${work}/tree")
file(REMOVE_RECURSE "${tree}")
file(COPY "${source}/CMakeLists.txt" DESTINATION "${tree}")
# Called .in because VTK's search would find them in the real tree, too.
foreach (file IN ITEMS CMakeLists.txt vtk.module vtkNBufferStub.h)
  configure_file("${source}/Stub/${file}.in" "${tree}/Stub/${file}" COPYONLY)
endforeach ()
file(COPY
  "${checkout}/CMakeLists.txt" "${checkout}/vtk.module" "${checkout}/Modules" "${checkout}/Testing"
  DESTINATION "${tree}/Remote/NBuffer")

# Unoptimised: only that it builds matters, and that it lands where VTK's do.
file(REMOVE_RECURSE "${work}/build")
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${tree}" -B "${work}/build" -G "${generator}"
  "-DCMAKE_MAKE_PROGRAM=${make_program}"
  "-DCMAKE_CXX_COMPILER=${cxx_compiler}"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${cxx_compiler_launcher}"
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0
  "-DVTK_DIR=${VTK_DIR}"
  "-Dbuild_speed=${checkout}/CMake/VTKNBufferBuildSpeed.cmake"
  "-DVTKNBUFFER_PRECOMPILE_HEADERS=${precompile}"
  "-DVTKNBUFFER_UNITY_BUILD=${precompile}"
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${work}/build" COMMAND_ERROR_IS_FATAL ANY)
file(GLOB libraries "${work}/build/lib*/*vtkNBuffer-tree.*")
if (NOT libraries)
  message(FATAL_ERROR "no vtkNBuffer library with the tree's suffix was built")
endif ()
