# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# The project where there is no PCL, in a build tree of its own: it is configured with tests and
# Python, there is a rule for every file that it would build, and the readers are built, which offer
# to convert PCL's clouds. The kernel and the other filters are compiled by the same commands as with
# PCL, and need not be compiled again.
set(without_pcl_dir "${CMAKE_BINARY_DIR}/Testing/WithoutPCL")

add_test(NAME WithoutPCL.Clean
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${without_pcl_dir}")
set_tests_properties(WithoutPCL.Clean PROPERTIES
  FIXTURES_SETUP dgg_clean_without_pcl)
add_test(NAME WithoutPCL.Configure
  COMMAND "${CMAKE_COMMAND}" -S "${PROJECT_SOURCE_DIR}" -B "${without_pcl_dir}"
    -G "${CMAKE_GENERATOR}"
    -DDGG_WITH_PCL=OFF
    -DCMAKE_DISABLE_FIND_PACKAGE_PCL=ON
    "-DDGG_WITH_PYTHON=${DGG_WITH_PYTHON}"
    "-DPython3_EXECUTABLE=${Python3_EXECUTABLE}"
    "-DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}"
    "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
    "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}")
set_tests_properties(WithoutPCL.Configure PROPERTIES
  FIXTURES_REQUIRED dgg_clean_without_pcl
  FIXTURES_SETUP dgg_without_pcl)
# A dry run, which fails where a source or a library is missing.
add_test(NAME WithoutPCL.Plan
  COMMAND "${CMAKE_COMMAND}" --build "${without_pcl_dir}" -- -n)
add_test(NAME WithoutPCL.BuildReaders
  COMMAND "${CMAKE_COMMAND}" --build "${without_pcl_dir}" --target Readers --parallel 2)
set_tests_properties(WithoutPCL.Plan WithoutPCL.BuildReaders PROPERTIES
  FIXTURES_REQUIRED dgg_without_pcl)
set_tests_properties(
  WithoutPCL.Clean WithoutPCL.Configure WithoutPCL.Plan WithoutPCL.BuildReaders PROPERTIES
    LABELS "Install"
    TIMEOUT 600)
