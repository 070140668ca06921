# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# The package that find_package(vtkDGG) finds, in the build tree and where it is installed.
include(CMakePackageConfigHelpers)
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/vtkDGGConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${dgg_cmake_destination}/vtkDGGConfig.cmake"
  INSTALL_DESTINATION "${dgg_cmake_destination}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${dgg_cmake_destination}/vtkDGGConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${dgg_cmake_destination}/vtkDGGConfig.cmake"
    "${CMAKE_BINARY_DIR}/${dgg_cmake_destination}/vtkDGGConfigVersion.cmake"
  DESTINATION "${dgg_cmake_destination}"
  COMPONENT development)
