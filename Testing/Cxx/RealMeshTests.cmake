# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# Tests on meshes from files, as separate programs: of the kernel against CGAL if available, and of
# the kernel and of paths on a folder of real-world meshes if one is named.
set(shared "${CMAKE_CURRENT_LIST_DIR}/../Benchmark")
set(reader_modules
  VTK::CommonCore
  VTK::CommonDataModel
  VTK::CommonExecutionModel
  VTK::FiltersCore
  VTK::IOGeometry
  VTK::IOLegacy
  VTK::IOPLY
  VTK::IOXML)

function (dgg_add_real_mesh_tests name)
  add_executable(${name} ${ARGN}
    "${shared}/MeshArrays.h"
    "${shared}/MeshFile.cxx"
    "${shared}/MeshFile.h")
  target_include_directories(${name} PRIVATE "${shared}")
  target_compile_definitions(${name} PRIVATE ${dgg_test_definitions})
  target_compile_options(${name} PRIVATE ${dgg_flags_outside_kernel})
  target_link_libraries(${name} PRIVATE DGG::Kernel ${reader_modules} GTest::gtest_main)
  vtk_module_autoinit(TARGETS ${name} MODULES ${reader_modules})
  dgg_add_gtest(${name} Cxx 4)
endfunction ()

include("${shared}/PeerCGAL.cmake")
if (TARGET dggPeerCGAL)
  dgg_add_real_mesh_tests(dggCGALTests
    TestAgainstCGAL.cxx
    "${shared}/GeneratedMesh.cxx"
    "${shared}/GeneratedMesh.h")
  target_link_libraries(dggCGALTests PRIVATE dggPeerCGAL dggTestTools)
  set(bunny "/usr/share/glmark2/models/bunny.obj")
  if (EXISTS "${bunny}")
    target_compile_definitions(dggCGALTests PRIVATE "DGG_GLMARK2_BUNNY=\"${bunny}\"")
  endif ()
endif ()
if (TARGET dggPeerHeat)
  dgg_add_real_mesh_tests(dggCGALHeatTests
    TestHeatAgainstCGAL.cxx
    "${shared}/GeneratedMesh.cxx"
    "${shared}/GeneratedMesh.h")
  target_link_libraries(dggCGALHeatTests PRIVATE dggPeerHeat dggTestTools)
endif ()
if (DGG_EXTRA_DATA)
  dgg_add_real_mesh_tests(dggExtraDataTests ExtraMeshes.cxx TestExtraData.cxx)
  target_link_libraries(dggExtraDataTests PRIVATE dggTestTools DGG::Kernel)
  dgg_add_real_mesh_tests(dggExtraPathTests
    ExtraMeshes.cxx
    TestExtraIsolines.cxx
    TestExtraLoops.cxx
    TestExtraPaths.cxx)
  target_link_libraries(dggExtraPathTests PRIVATE dggFilterTestTools DGG::Kernel)
  if (DGG_WITH_PCL)
    dgg_add_real_mesh_tests(dggExtraCloudTests ExtraMeshes.cxx TestExtraClouds.cxx)
    target_link_libraries(dggExtraCloudTests PRIVATE dggFilterTestTools DGG::FiltersPointCloud)
  endif ()
endif ()
