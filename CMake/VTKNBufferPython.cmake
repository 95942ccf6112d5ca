# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# The Python package vtknbuffer: VTK's own wrapping of the module, in a folder of the package that
# is named for the VTK that it belongs to, and the Python sources. One wheel may hold both folders:
#
#   _vtk      the packages vtk, vtkmodules: Kitware's wheel, Debian's VTK, a VTK of one's own
#   _cvista   the package cvista
if (SKBUILD)
  set(_python_destination ".")
else ()
  vtk_module_python_default_destination(_python_destination)
endif ()
vtk_module_wrap_python(
  MODULES ${VTKNBUFFER_MODULE} ${VTKNBUFFER_PARALLEL_MODULE}
  PYTHON_PACKAGE "vtknbuffer.${VTKNBUFFER_PYTHON_FOLDER}"
  MODULE_DESTINATION "${_python_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/VTKNBuffer"
  INSTALL_HEADERS OFF
  COMPONENT python)

# The sources and the city of the demonstration, in the build folder as in the installation, so that
# tests use them as users do.
file(GLOB _files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/Modules/NBuffer/Python/vtknbuffer/*.py")
list(APPEND _files
  "${PROJECT_SOURCE_DIR}/Modules/NBuffer/Python/vtknbuffer/py.typed"
  "${PROJECT_SOURCE_DIR}/Examples/Data/neubrandenburg.city"
  "${PROJECT_SOURCE_DIR}/Examples/Data/neubrandenburg.city.license")
set(VTKNBUFFER_PYTHON_PATH "${CMAKE_BINARY_DIR}/${_python_destination}")
set(_package "${VTKNBUFFER_PYTHON_PATH}/vtknbuffer")
set(_copies)
foreach (_file IN LISTS _files)
  get_filename_component(_name "${_file}" NAME)
  add_custom_command(
    OUTPUT "${_package}/${_name}"
    DEPENDS "${_file}"
    COMMAND "${CMAKE_COMMAND}" -E copy "${_file}" "${_package}/${_name}")
  list(APPEND _copies "${_package}/${_name}")
endforeach ()
add_custom_target(vtknbuffer-python ALL DEPENDS ${_copies})
install(FILES ${_files} DESTINATION "${_python_destination}/vtknbuffer" COMPONENT python)

# What the package checks when it is imported.
file(CONFIGURE OUTPUT "${_package}/${VTKNBUFFER_PYTHON_FOLDER}/__init__.py" @ONLY CONTENT
"# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
\"\"\"The module as compiled for VTK @VTK_VERSION@ of the Python package @VTKNBUFFER_VTK_PACKAGE@.\"\"\"

VTK_VERSION = \"@VTK_VERSION@\"
")
install(FILES "${_package}/${VTKNBUFFER_PYTHON_FOLDER}/__init__.py"
  DESTINATION "${_python_destination}/vtknbuffer/${VTKNBUFFER_PYTHON_FOLDER}" COMPONENT python)

# Type stubs, by VTK's own generator, which imports the module: it needs the Python package of this
# VTK. In a build folder or an installation of VTK that is below VTK_PYTHONPATH, where it goes before
# another VTK that the interpreter may have.
set(_python "${CMAKE_COMMAND}" -E env "PYTHONPATH=${VTK_PREFIX_PATH}/${VTK_PYTHONPATH}"
  "PYVISTA_VTK_BACKEND=${VTKNBUFFER_VTK_PACKAGE}" "${Python3_EXECUTABLE}")
execute_process(
  COMMAND ${_python} -c
    "import ${VTKNBUFFER_VTK_PACKAGE}.generate_pyi, ${VTKNBUFFER_VTK_PACKAGE}.vtkRenderingOpenGL2"
  RESULT_VARIABLE _no_stubs OUTPUT_QUIET ERROR_QUIET)
if (_no_stubs)
  message(STATUS
    "No type stubs: ${Python3_EXECUTABLE} cannot import ${VTKNBUFFER_VTK_PACKAGE}.generate_pyi")
else ()
  # VTK 9.7 has renamed the wrapper's target.
  set(_wrapper PyvtkNBufferPython)
  if (NOT TARGET ${_wrapper})
    set(_wrapper vtkNBufferPython)
  endif ()
  add_custom_command(
    OUTPUT "${_package}/${VTKNBUFFER_PYTHON_FOLDER}/vtkNBuffer.pyi"
    DEPENDS ${_wrapper} ${_copies}
    WORKING_DIRECTORY "${VTKNBUFFER_PYTHON_PATH}"
    COMMAND ${_python} -m ${VTKNBUFFER_VTK_PACKAGE}.generate_pyi
      -p "vtknbuffer.${VTKNBUFFER_PYTHON_FOLDER}"
      -o "${_package}/${VTKNBUFFER_PYTHON_FOLDER}" vtkNBuffer
    COMMENT "Type stubs of the Python module")
  add_custom_target(vtknbuffer-python-stubs ALL DEPENDS "${_package}/${VTKNBUFFER_PYTHON_FOLDER}/vtkNBuffer.pyi")
  install(FILES "${_package}/${VTKNBUFFER_PYTHON_FOLDER}/vtkNBuffer.pyi"
    DESTINATION "${_python_destination}/vtknbuffer/${VTKNBUFFER_PYTHON_FOLDER}" COMPONENT python)
endif ()
