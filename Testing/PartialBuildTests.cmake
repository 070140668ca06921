# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# The project without PCL, without VTK and as a wheel: each in a build tree of its own, where CMake
# does not find the package.

# dgg_add_partial_build(<package> <options>...): tests that clean and configure the build tree, for
# tests that require the fixture dgg_without_<package>.
function (dgg_add_partial_build package)
  set(build "${CMAKE_BINARY_DIR}/Testing/Without${package}")
  add_test(NAME "Without${package}.Clean"
    COMMAND "${CMAKE_COMMAND}" -E rm -rf "${build}")
  set_tests_properties("Without${package}.Clean" PROPERTIES
    FIXTURES_SETUP dgg_clean_without_${package}
    LABELS Install)
  add_test(NAME "Without${package}.Configure"
    COMMAND "${CMAKE_COMMAND}" -S "${PROJECT_SOURCE_DIR}" -B "${build}"
      -G "${CMAKE_GENERATOR}"
      -DDGG_WITH_${package}=OFF
      -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON
      "-DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}"
      "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
      "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
      "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
      ${ARGN})
  set_tests_properties("Without${package}.Configure" PROPERTIES
    FIXTURES_REQUIRED dgg_clean_without_${package}
    FIXTURES_SETUP dgg_without_${package}
    LABELS Install
    TIMEOUT 600)
endfunction ()

# dgg_add_partial_test(<package> <name> <command>...)
function (dgg_add_partial_test package name)
  add_test(NAME "Without${package}.${name}" COMMAND ${ARGN})
  set_tests_properties("Without${package}.${name}" PROPERTIES
    FIXTURES_REQUIRED dgg_without_${package}
    LABELS Install
    TIMEOUT 1800)
endfunction ()

if (DGG_WITH_PCL)
  # The kernel and the other filters are compiled by the same commands as with PCL, and need not be
  # compiled again. A dry run fails where a source or a library is missing. The readers are built:
  # they offer to convert PCL's clouds.
  dgg_add_partial_build(PCL
    "-DDGG_WITH_PYTHON=${DGG_WITH_PYTHON}" "-DPython3_EXECUTABLE=${Python3_EXECUTABLE}")
  set(without_pcl "${CMAKE_BINARY_DIR}/Testing/WithoutPCL")
  dgg_add_partial_test(PCL Plan "${CMAKE_COMMAND}" --build "${without_pcl}" -- -n)
  dgg_add_partial_test(PCL BuildReaders
    "${CMAKE_COMMAND}" --build "${without_pcl}" --target Readers --parallel 2)
  set_tests_properties(WithoutPCL.BuildReaders PROPERTIES
    PROCESSORS 2)
endif ()

# The kernel alone, with its tests, installed and used by a program.
dgg_add_partial_build(VTK "-DDGG_WITH_PCL=${DGG_WITH_PCL}")
set(without_vtk "${CMAKE_BINARY_DIR}/Testing/WithoutVTK")
set(kernel_prefix "${without_vtk}/Install")
dgg_add_partial_test(VTK Build "${CMAKE_COMMAND}" --build "${without_vtk}" --parallel 2)
set_tests_properties(WithoutVTK.Build PROPERTIES
  FIXTURES_SETUP dgg_kernel
  PROCESSORS 2)
dgg_add_partial_test(VTK Test
  "${CMAKE_CTEST_COMMAND}" --test-dir "${without_vtk}" --output-on-failure)
dgg_add_partial_test(VTK Install
  "${CMAKE_COMMAND}" --install "${without_vtk}" --prefix "${kernel_prefix}")
set(kernel_program "${without_vtk}/Program")
file(WRITE "${dgg_test_output}/KernelProgram/CMakeLists.txt" "cmake_minimum_required(VERSION 3.20)
project(KernelProgram LANGUAGES C CXX)
find_package(vtkDGG REQUIRED COMPONENTS Kernel)
add_executable(KernelOnly \"${PROJECT_SOURCE_DIR}/Examples/Cxx/KernelOnly.cxx\")
target_link_libraries(KernelOnly PRIVATE DGG::Core) # the alias
")
dgg_add_partial_test(VTK Program "${CMAKE_CTEST_COMMAND}"
  --build-and-test "${dgg_test_output}/KernelProgram" "${kernel_program}"
  --build-generator "${CMAKE_GENERATOR}"
  --build-options
    -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON
    "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
    "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
    "-DvtkDGG_DIR:PATH=${kernel_prefix}/${dgg_cmake_destination}"
  --test-command "${kernel_program}/KernelOnly")
set_tests_properties(WithoutVTK.Test PROPERTIES
  FIXTURES_REQUIRED dgg_kernel)
set_tests_properties(WithoutVTK.Install PROPERTIES
  FIXTURES_REQUIRED dgg_kernel
  FIXTURES_SETUP dgg_installed_kernel)
set_tests_properties(WithoutVTK.Program PROPERTIES
  FIXTURES_REQUIRED dgg_installed_kernel)

# The wheel of the Python package, which contains the kernel.
if (DGG_WITH_PYTHON)
  add_test(NAME Wheel
    COMMAND "${CMAKE_CURRENT_SOURCE_DIR}/wheel.sh" "${CMAKE_BINARY_DIR}/Testing/Wheel")
  set_tests_properties(Wheel PROPERTIES
    ENVIRONMENT "PYTHON=${Python3_EXECUTABLE};CMAKE_BUILD_PARALLEL_LEVEL=2;CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
    LABELS Install
    PROCESSORS 2
    SKIP_RETURN_CODE 77
    TIMEOUT 1800)
endif ()
