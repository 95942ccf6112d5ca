# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# Run by CTest with -D: binary (the build to install), config, source (of the
# consumer), work (where to put it), and how that build had been configured.
file(REMOVE_RECURSE "${work}/prefix" "${work}/build")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${binary}" --config "${config}"
  --prefix "${work}/prefix" COMMAND_ERROR_IS_FATAL ANY)
set(flags)
if (sanitize)
  set(flags "-DCMAKE_CXX_FLAGS=-fsanitize=${sanitize}")
endif ()
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${source}" -B "${work}/build" -G "${generator}"
  "-DCMAKE_MAKE_PROGRAM=${make_program}"
  "-DCMAKE_CXX_COMPILER=${cxx_compiler}"
  "-DCMAKE_BUILD_TYPE=${config}"
  "-DCMAKE_PREFIX_PATH=${work}/prefix"
  "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF"
  "-DCMAKE_RUNTIME_OUTPUT_DIRECTORY=${work}/build/$<0:>bin"
  "-DVTK_DIR=${VTK_DIR}" ${flags}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${work}/build" --config "${config}"
  COMMAND_ERROR_IS_FATAL ANY)
if (VTK_VERSION VERSION_LESS 9.4 AND "$ENV{DISPLAY}" STREQUAL "" AND UNIX AND NOT APPLE)
  message("SKIPPED: this VTK opens X windows only, and DISPLAY is not set")
else ()
  execute_process(COMMAND "${work}/build/bin/consumer" COMMAND_ERROR_IS_FATAL ANY)
endif ()
