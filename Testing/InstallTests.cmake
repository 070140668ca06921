# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# Install into a folder of the build tree, and use what is there as a stranger would: build the
# examples as a project of their own, run them, and import the Python package.
set(install_prefix "${CMAKE_BINARY_DIR}/Testing/Install")
set(consumer_dir "${CMAKE_BINARY_DIR}/Testing/Consumer")
set(consumer_output "${dgg_test_output}/Consumer")
file(MAKE_DIRECTORY "${consumer_output}")
configure_file(Data/tetrahedron.off "${consumer_output}/mesh.off" COPYONLY)
configure_file(Data/bumpy.ply "${consumer_output}/mesh.ply" COPYONLY)

add_test(NAME Install.Install
  COMMAND "${CMAKE_COMMAND}" --install "${CMAKE_BINARY_DIR}" --prefix "${install_prefix}")
set_tests_properties(Install.Install PROPERTIES
  FIXTURES_SETUP dgg_install
  LABELS "Install")

add_test(NAME Install.IsRelocatable
  COMMAND "${CMAKE_COMMAND}" "-DFOLDER=${install_prefix}/${dgg_cmake_destination}"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/CheckRelocatable.cmake")
set_tests_properties(Install.IsRelocatable PROPERTIES
  FIXTURES_REQUIRED dgg_install
  LABELS "Install")

# A fresh configure each time, so that an old cache hides nothing.
add_test(NAME Install.CleanConsumer
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${consumer_dir}")
add_test(NAME Install.BuildConsumer
  COMMAND "${CMAKE_CTEST_COMMAND}"
    --build-and-test "${PROJECT_SOURCE_DIR}/Examples/Cxx" "${consumer_dir}"
    --build-generator "${CMAKE_GENERATOR}"
    --build-options
      "-DCMAKE_PREFIX_PATH=${install_prefix}"
      "-DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}"
      "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
      "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
      "-DvtkDGG_DIR:PATH=${install_prefix}/${dgg_cmake_destination}")
set_tests_properties(Install.CleanConsumer PROPERTIES
  FIXTURES_SETUP dgg_clean_consumer
  LABELS "Install")
set_tests_properties(Install.BuildConsumer PROPERTIES
  FIXTURES_REQUIRED "dgg_install;dgg_clean_consumer"
  FIXTURES_SETUP dgg_consumer
  LABELS "Install"
  TIMEOUT 600)

set(headers_dir "${CMAKE_BINARY_DIR}/Testing/PublicHeaders")
add_test(NAME Install.PublicHeaders
  COMMAND "${CMAKE_CTEST_COMMAND}"
    --build-and-test "${CMAKE_CURRENT_SOURCE_DIR}/PublicHeaders" "${headers_dir}"
    --build-generator "${CMAKE_GENERATOR}"
    --build-options
      "-DCMAKE_PREFIX_PATH=${install_prefix}"
      "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}"
      "-DvtkDGG_DIR:PATH=${install_prefix}/${dgg_cmake_destination}"
      "-DHEADERS=${install_prefix}/${dgg_include_destination}")
set_tests_properties(Install.PublicHeaders PROPERTIES
  FIXTURES_REQUIRED dgg_install
  LABELS "Install"
  TIMEOUT 600)

# An unknown component is named.
set(unknown_dir "${consumer_output}/UnknownComponent")
file(WRITE "${unknown_dir}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.20)
project(UnknownComponent LANGUAGES C CXX)
find_package(vtkDGG COMPONENTS FiltersGeodesic FiltersUnknown)
message(STATUS \"found: \${vtkDGG_FOUND}. \${vtkDGG_NOT_FOUND_MESSAGE}\")
")
add_test(NAME Install.UnknownComponent
  COMMAND "${CMAKE_COMMAND}" -DEXIT_CODE=0
    "-DEXPECTED=found: 0. vtkDGG has no component FiltersUnknown[.]"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/RunAndMatch.cmake" --
    "${CMAKE_COMMAND}" -S "${unknown_dir}" -B "${unknown_dir}/build"
      "-DvtkDGG_DIR:PATH=${install_prefix}/${dgg_cmake_destination}")
set_tests_properties(Install.UnknownComponent PROPERTIES
  FIXTURES_REQUIRED dgg_install
  LABELS "Install")

function (dgg_add_consumer_test name exit_code expected)
  add_test(NAME "Install.${name}"
    COMMAND "${CMAKE_COMMAND}" "-DEXIT_CODE=${exit_code}" "-DEXPECTED=${expected}"
      -P "${CMAKE_CURRENT_SOURCE_DIR}/RunAndMatch.cmake" -- ${ARGN}
    WORKING_DIRECTORY "${consumer_output}")
  set_tests_properties("Install.${name}" PROPERTIES
    FIXTURES_REQUIRED dgg_consumer
    LABELS "Install")
endfunction ()

dgg_add_consumer_test(KernelOnly 0 "loops: 1.*opposite corners: 1.41421"
  "${consumer_dir}/KernelOnly")
dgg_add_consumer_test(TenLines 0 ""
  "${consumer_dir}/TenLines")
dgg_add_consumer_test(TenLines.MissingFile 1 "Cannot read mesh.ply: the file does not exist"
  "${CMAKE_COMMAND}" -E chdir "${consumer_dir}" "${consumer_dir}/TenLines")
foreach (extension IN ITEMS off ply)
  dgg_add_consumer_test("Pipeline.${extension}" 0 "points, distances 0 to [0-9.]+, ${extension}.png"
    "${consumer_dir}/ExactDistancePipeline" "mesh.${extension}" 0 "${extension}.png")
  set_tests_properties("Install.Pipeline.${extension}" PROPERTIES
    ENVIRONMENT "${dgg_leaking_environment}")
endforeach ()
dgg_add_consumer_test(GraphPipeline 0 "from point 3: up to [0-9.]+.*from point 600.*edges, [0-9.]+ per"
  "${consumer_dir}/GraphPipeline" "mesh.ply" 3 600 "graph.png")
set_tests_properties("Install.GraphPipeline" PROPERTIES
  ENVIRONMENT "${dgg_leaking_environment}")
if (TARGET DGG::FiltersParallel AND MPIEXEC_EXECUTABLE)
  dgg_add_consumer_test(GraphInPieces 0 "process 1: [1-9][0-9]* edges, distances up to [0-9.]+"
    "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_NUMPROC_FLAG} 2 ${MPIEXEC_PREFLAGS}
      "${consumer_dir}/GraphInPieces")
  set_tests_properties("Install.GraphInPieces" PROPERTIES
    ENVIRONMENT "${dgg_leaking_environment};${dgg_mpi_environment}"
    TIMEOUT 60)
endif ()
dgg_add_consumer_test(TerrainPath 0
  "on the surface: 12.50.* km.*along mesh edges: 13.22.* km, [0-9.]+ % longer"
  "${consumer_dir}/TerrainPath" "terrain.png")
set_tests_properties("Install.TerrainPath" PROPERTIES
  ENVIRONMENT "${dgg_leaking_environment}")
dgg_add_consumer_test(GraphPipeline.WrongSource 1 "Source id 642"
  "${consumer_dir}/GraphPipeline" "mesh.ply" 0 642 "wrong.png")
dgg_add_consumer_test(Isolines 0 "[0-9]+ lines, [0-9]+ ridges, [0-9]+ triangles in bands"
  "${consumer_dir}/Isolines" "mesh.ply" 8 "isolines.png")
set_tests_properties("Install.Isolines" PROPERTIES
  ENVIRONMENT "${dgg_leaking_environment}")
dgg_add_consumer_test(Isolines.WrongNumber 1 "not a number of lines"
  "${consumer_dir}/Isolines" "mesh.ply" none "wrong.png")
dgg_add_consumer_test(GreensPipeline 0
  "Green's function from -[0-9.]+ to [0-9.]+, biharmonic distance up to [0-9.]+"
  "${consumer_dir}/GreensPipeline" "mesh.ply" 3 "greens.vtp")
dgg_add_consumer_test(GreensPipeline.WrongPoint 1 "Source id 642"
  "${consumer_dir}/GreensPipeline" "mesh.ply" 642 "wrong.vtp")
dgg_add_consumer_test(VoronoiCells 0 "20 cells, areas from [0-9.]+.*iterations [0-9.]+"
  "${consumer_dir}/VoronoiCells" "mesh.ply" 20 "cells.png")
set_tests_properties("Install.VoronoiCells" PROPERTIES
  ENVIRONMENT "${dgg_leaking_environment}")
dgg_add_consumer_test(VoronoiCells.WrongNumber 1 "NumberOfSamples"
  "${consumer_dir}/VoronoiCells" "mesh.ply" 0 "wrong.png")
dgg_add_consumer_test(Loops 0
  "through the point: length 6.*angle [0-3].*taut: length 6.275.*angle 3.14159.*2 rims"
  "${consumer_dir}/Loops" "mesh.ply" 76 0.2 "loops.png")
set_tests_properties("Install.Loops" PROPERTIES
  ENVIRONMENT "${dgg_leaking_environment}")
dgg_add_consumer_test(Loops.WrongPoint 1 "Loop point id 642"
  "${consumer_dir}/Loops" "mesh.ply" 642 0.2 "wrong.png")
dgg_add_consumer_test(PatchBoundaries 0
  "landmarks +first surface +second surface.*0 to 1 +0.7004[0-9]* +0.7004[0-9]*.*5 to 4 "
  "${consumer_dir}/PatchBoundaries" "mesh.ply" "mesh.ply" "patches.png")
set_tests_properties("Install.PatchBoundaries" PROPERTIES
  ENVIRONMENT "${dgg_leaking_environment}")
dgg_add_consumer_test(GeodesicExplorer 0
  "virtual sources, [0-9.]+ ms.*virtual sources, .*graph, [0-9.]+ ms.*graph, path 0.[0-9]+, [0-9.]+ ms"
  "${consumer_dir}/GeodesicExplorer" "mesh.ply" --play)
set_tests_properties("Install.GeodesicExplorer" PROPERTIES
  ENVIRONMENT "${dgg_leaking_environment}")
dgg_add_consumer_test(GeodesicExplorer.MissingFile 1 "Usage: "
  "${consumer_dir}/GeodesicExplorer" "missing.ply")
dgg_add_consumer_test(GeodesicExplorer.NoFile 1 "^Usage: "
  "${consumer_dir}/GeodesicExplorer")
dgg_add_consumer_test(GeodesicExplorer.WrongOption 1 "^Usage: "
  "${consumer_dir}/GeodesicExplorer" "mesh.ply" --lay)
dgg_add_consumer_test(Isolines.MissingFile 1 "missing.ply: no points"
  "${consumer_dir}/Isolines" "missing.ply" 8 "wrong.png")
dgg_add_consumer_test(VoronoiCells.MissingFile 1 "missing.ply: no points"
  "${consumer_dir}/VoronoiCells" "missing.ply" 8 "wrong.png")
dgg_add_consumer_test(PatchBoundaries.MissingFile 1 "missing.ply: no surface"
  "${consumer_dir}/PatchBoundaries" "mesh.ply" "missing.ply" "wrong.png")
dgg_add_consumer_test(Pipeline.MissingFile 1 "missing.off"
  "${consumer_dir}/ExactDistancePipeline" missing.off 0 missing.png)
dgg_add_consumer_test(Pipeline.WrongSource 1 "source|point"
  "${consumer_dir}/ExactDistancePipeline" mesh.off 4 wrong.png)

if (DGG_WITH_PCL)
  dgg_add_consumer_test(PointCloud 0
    "points, [0-9]+ edges, 1 comp.*farthest point: 13.[4-7][0-9]* along.*cloud.pcd: [0-9]+ points"
    "${consumer_dir}/PointCloud" "cloud.pcd")
  dgg_add_consumer_test(PointCloud.CannotWrite 1 "none/cloud.pcd.*cannot be opened"
    "${consumer_dir}/PointCloud" "none/cloud.pcd")
  dgg_add_consumer_test(CloudPath 0
    "642 points, [0-9]+ edges, 1 components.*farthest is point [0-9]+: [23][.][0-9]+ away"
    "${consumer_dir}/CloudPath" "mesh.ply" 0 "path.vtp")
  dgg_add_consumer_test(CloudPath.WrongSource 1 "Source id 642"
    "${consumer_dir}/CloudPath" "mesh.ply" 642 "wrong.vtp")
  dgg_add_consumer_test(CloudPath.NoNumber 1 "abc: not the number of a point"
    "${consumer_dir}/CloudPath" "mesh.ply" abc "wrong.vtp")
  dgg_add_consumer_test(CloudPath.MissingFile 1 "missing.ply: no distances"
    "${consumer_dir}/CloudPath" "missing.ply" 0 "wrong.vtp")
endif ()

if (DGG_WITH_PYTHON)
  add_test(NAME Install.Python
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/installed_package.py"
      "${install_prefix}" "${PROJECT_VERSION}" "${DGG_WITH_PCL}")
  set_tests_properties(Install.Python PROPERTIES
    FIXTURES_REQUIRED dgg_install
    LABELS "Install"
    ENVIRONMENT "PYTHONPATH=${install_prefix}/${dgg_python_destination}")
  if (TARGET DGG::FiltersParallel AND MPIEXEC_EXECUTABLE)
    add_test(NAME Install.PythonPieces
      COMMAND "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_NUMPROC_FLAG} 2 ${MPIEXEC_PREFLAGS}
        "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/test_pieces.py")
    set_tests_properties(Install.PythonPieces PROPERTIES
      FIXTURES_REQUIRED dgg_install
      LABELS "Install;Ranks"
      ENVIRONMENT "PYTHONPATH=${install_prefix}/${dgg_python_destination};\
DGG_TEST_OUTPUT=${dgg_test_output};${dgg_leaking_environment};${dgg_mpi_environment}"
      TIMEOUT 120)
  endif ()
endif ()
