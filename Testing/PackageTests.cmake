# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# The Debian packages of this build tree: they are made, hold what gets installed, each file once,
# and depend on what it needs. packages.sh installs them on a clean system.
set(packages_dir "${CMAKE_BINARY_DIR}/Testing/Packages")
find_program(DGG_LINTIAN lintian)
mark_as_advanced(DGG_LINTIAN)

add_test(NAME Packages.Clean
  COMMAND sh -c "rm -rf \"$1\" && mkdir -p \"$1\" && touch \"$1/libvtkdgg-dev_0.0-1_all.deb\"" sh
    "${packages_dir}")
set_tests_properties(Packages.Clean PROPERTIES
  FIXTURES_SETUP dgg_clean_packages)
add_test(NAME Packages.Build
  COMMAND "${CMAKE_CPACK_COMMAND}" -G DEB --config "${CMAKE_BINARY_DIR}/CPackConfig.cmake"
    -B "${packages_dir}")
set_tests_properties(Packages.Build PROPERTIES
  FIXTURES_REQUIRED dgg_clean_packages
  FIXTURES_SETUP dgg_packages)
add_test(NAME Packages.Check
  COMMAND "${CMAKE_COMMAND}" "-DBUILD=${CMAKE_BINARY_DIR}" "-DPACKAGES=${packages_dir}"
    "-DVERSION=${PROJECT_VERSION}" "-DSOVERSION=${dgg_soversion}"
    "-DWITH_PCL=${DGG_WITH_PCL}" "-DWITH_PYTHON=${DGG_WITH_PYTHON}"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/CheckPackages.cmake")
set(package_tests Packages.Check)
if (DGG_LINTIAN)
  add_test(NAME Packages.Lintian
    COMMAND sh -c "exec \"$1\" --fail-on error --pedantic \"$2\"/*.deb" sh
      "${DGG_LINTIAN}" "${packages_dir}")
  list(APPEND package_tests Packages.Lintian)
endif ()
set_tests_properties(${package_tests} PROPERTIES
  FIXTURES_REQUIRED dgg_packages)
set_tests_properties(Packages.Clean Packages.Build ${package_tests} PROPERTIES
  LABELS "Install"
  TIMEOUT 600)
