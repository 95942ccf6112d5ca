# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# Scripts/make-vtk-sdk.sh puts this file into the CMake package of the SDK, as
# VTK-targets-wheel.cmake, in place of the list of libraries that VTK's build would install.
#
#   VTK_WHEEL_DIR   the folder vtkmodules of the installed wheel. By default it is that of
#                   Python3_EXECUTABLE, or of the Python that CMake finds.
if (NOT VTK_WHEEL_DIR)
  if (NOT Python3_EXECUTABLE)
    find_package(Python3 REQUIRED COMPONENTS Interpreter)
  endif ()
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -c "import importlib.util as u; print(u.find_spec('vtkmodules').submodule_search_locations[0])"
    OUTPUT_VARIABLE VTK_WHEEL_DIR RESULT_VARIABLE _failed
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if (_failed)
    message(FATAL_ERROR "${Python3_EXECUTABLE} has no package vtk: pip install vtk==@VERSION@, or set VTK_WHEEL_DIR.")
  endif ()
endif ()
file(TO_CMAKE_PATH "${VTK_WHEEL_DIR}" _wheel)
if (NOT EXISTS "${_wheel}/libvtkCommonCore.so")
  message(FATAL_ERROR "VTK_WHEEL_DIR (${_wheel}) has no libvtkCommonCore.so: it is not the folder vtkmodules of the wheel.")
endif ()
file(STRINGS "${_wheel}/libvtkCommonCore.so" _version REGEX "^vtk version [0-9.]+$" LIMIT_COUNT 1)
if (NOT _version STREQUAL "vtk version @VERSION@")
  message(FATAL_ERROR "This SDK is for VTK @VERSION@, but ${_wheel} has ${_version}.")
endif ()

# Libraries that the wheel lacks are not needed by modules that it has. WrappingPythonCore has the
# version of Python in its name.
get_property(_targets DIRECTORY PROPERTY IMPORTED_TARGETS)
foreach (_target IN LISTS _targets)
  get_target_property(_type ${_target} TYPE)
  string(REGEX REPLACE "^VTK::(vtk)?" "vtk" _name "${_target}")
  if (NOT _target MATCHES "^VTK::")
    continue ()
  elseif (_type STREQUAL "SHARED_LIBRARY")
    file(GLOB _files "${_wheel}/lib${_name}.so" "${_wheel}/lib${_name}[0-9]*.so")
  elseif (_type STREQUAL "EXECUTABLE")
    file(GLOB _files "${_IMPORT_PREFIX}/bin/${_name}")
  else ()
    continue ()
  endif ()
  if (_files)
    list(GET _files 0 _file)
    set_target_properties(${_target} PROPERTIES IMPORTED_LOCATION "${_file}")
  endif ()
endforeach ()

# The std::string that the wheel's libraries use, in all that uses VTK.
set_property(TARGET VTK::vtkplatform APPEND PROPERTY
  INTERFACE_COMPILE_DEFINITIONS "_GLIBCXX_USE_CXX11_ABI=@NEW_STRINGS@")
foreach (_name IN ITEMS failed file files name target targets type version wheel)
  unset(_${_name})
endforeach ()
