# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# VTK's module system installs targets and properties but no package
# configuration: find_package(VTKNBuffer) reads the one written here.
include(CMakePackageConfigHelpers)
list(JOIN VTKNBUFFER_VTK_COMPONENTS " " VTKNBUFFER_VTK_COMPONENTS)
set(_destination "${CMAKE_INSTALL_LIBDIR}/cmake/VTKNBuffer")
configure_package_config_file(CMake/VTKNBufferConfig.cmake.in
  "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/VTKNBufferConfig.cmake"
  INSTALL_DESTINATION "${_destination}")
write_basic_package_version_file(
  "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/VTKNBufferConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/VTKNBufferConfig.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/VTKNBufferConfigVersion.cmake"
  DESTINATION "${_destination}"
  COMPONENT "development")
install(FILES LICENSE
  DESTINATION "${CMAKE_INSTALL_DATADIR}/licenses/VTKNBuffer"
  COMPONENT "development")
