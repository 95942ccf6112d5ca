# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# Run by CTest with -D: binary (the build to install), config, source (of the
# consumer), work (where to put it), and how that build had been configured.
function (run what)
  message(STATUS "${what}")
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed: ${result}")
  endif ()
endfunction ()

file(REMOVE_RECURSE "${work}/prefix" "${work}/build")
run("Install" "${CMAKE_COMMAND}" --install "${binary}" --config "${config}" --prefix "${work}/prefix")
set(flags)
if (sanitize)
  set(flags "-DCMAKE_CXX_FLAGS=-fsanitize=${sanitize}")
endif ()
run("Configure" "${CMAKE_COMMAND}" -S "${source}" -B "${work}/build" -G "${generator}"
  "-DCMAKE_MAKE_PROGRAM=${make_program}"
  "-DCMAKE_CXX_COMPILER=${cxx_compiler}"
  "-DCMAKE_BUILD_TYPE=${config}"
  "-DCMAKE_PREFIX_PATH=${work}/prefix"
  "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF"
  "-DCMAKE_RUNTIME_OUTPUT_DIRECTORY=${work}/build/$<0:>bin"
  "-DVTK_DIR=${VTK_DIR}" ${flags})
run("Build" "${CMAKE_COMMAND}" --build "${work}/build" --config "${config}")
if (VTK_VERSION VERSION_LESS 9.4 AND "$ENV{DISPLAY}" STREQUAL "" AND UNIX AND NOT APPLE)
  message("SKIPPED: this VTK opens X windows only, and DISPLAY is not set")
else ()
  run("Run" "${work}/build/bin/consumer")
endif ()
