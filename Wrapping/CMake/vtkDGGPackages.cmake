# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# Debian packages, one per component of the installation: cpack -G DEB, or the target package.
# With the prefix /usr (preset package) the folders are those of Debian. The plugin is one
# package with all of its libraries in its own folder, since ParaView has its own VTK.
foreach (dgg_program IN ITEMS dpkg-deb dpkg-shlibdeps file gzip)
  find_program("DGG_PROGRAM_${dgg_program}" "${dgg_program}")
  mark_as_advanced("DGG_PROGRAM_${dgg_program}")
  if (NOT DGG_PROGRAM_${dgg_program})
    set(dgg_mode STATUS)
    if (CMAKE_INSTALL_PREFIX STREQUAL "/usr") # as for packages
      set(dgg_mode WARNING)
    endif ()
    message(${dgg_mode} "No Debian packages can be made: there is no ${dgg_program}.")
    return ()
  endif ()
endforeach ()

set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME vtkdgg)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each has its own
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
if (NOT CPACK_PACKAGE_CONTACT)
  set(CPACK_PACKAGE_CONTACT "vtkDGG authors <vtkdgg@example.org>") # distributors replace it
endif ()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SOURCE vtkdgg)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)

set(dgg_version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(dgg_folder "${CMAKE_BINARY_DIR}/packaging")

# Files that Debian requires in every package.
file(READ "${PROJECT_SOURCE_DIR}/LICENSE" dgg_license)
file(READ "${CMAKE_CURRENT_LIST_DIR}/BundledLicenses.txt" dgg_others)
set(dgg_pcl)
if (DGG_WITH_PCL)
  set(dgg_pcl "\nThe same conditions and disclaimer apply to code of headers of\n\n\
  FLANN (libflann-dev): Copyright 2008-2012 Marius Muja and David G. Lowe\n\
  PCL (libpcl-dev): Copyright 2009-2012 Willow Garage, Inc., and 2012- Open Perception, Inc.;\n\
    neither their names nor those of contributors may be used to endorse or promote products\n\
    derived from PCL without specific prior written permission\n")
endif ()
file(WRITE "${dgg_folder}/copyright" "vtkDGG, made into packages by CPack.\n\n${dgg_license}\n\
${dgg_others}${dgg_pcl}\n\
The MPL-2.0 is in /usr/share/common-licenses/MPL-2.0, and the headers are in Debian's packages\n\
libeigen3-dev, libspectra-dev, libnanoflann-dev and pybind11-dev.\n")
string(TIMESTAMP dgg_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE "${dgg_folder}/changelog.Debian" "vtkdgg (${dgg_version}) unstable; urgency=medium\n\n\
  * Made by CPack. What has changed is in changelog.gz.\n\n\
 -- ${CPACK_PACKAGE_CONTACT}  ${dgg_date}\n")
configure_file("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${dgg_folder}/changelog" COPYONLY)
execute_process(
  COMMAND "${DGG_PROGRAM_gzip}" -9nf "${dgg_folder}/changelog" "${dgg_folder}/changelog.Debian"
  COMMAND_ERROR_IS_FATAL ANY)

# Remove earlier packages, which would be treated as current ones.
file(WRITE "${dgg_folder}/remove.cmake" "\
string(FIND \"\${CPACK_PACKAGE_DIRECTORY}\" \"${CMAKE_BINARY_DIR}/\" at)
if (at EQUAL 0) # else others may be there
  file(GLOB packages \"\${CPACK_PACKAGE_DIRECTORY}/*.deb\")
  foreach (package IN LISTS packages)
    file(REMOVE \"\${package}\")
  endforeach ()
endif ()
")
set(CPACK_PRE_BUILD_SCRIPTS "${dgg_folder}/remove.cmake")

# dgg_add_package(<component> <package> <section> <purpose> <description>): other variables are
# those of CPack.
macro (dgg_add_package component package section purpose content)
  string(TOUPPER "${component}" dgg_name)
  list(APPEND CPACK_COMPONENTS_ALL "${component}")
  set(CPACK_DEBIAN_${dgg_name}_PACKAGE_NAME "${package}")
  set(CPACK_DEBIAN_${dgg_name}_PACKAGE_SECTION "${section}")
  set(CPACK_COMPONENT_${dgg_name}_DESCRIPTION "geodesics on meshes and point clouds, ${purpose}
vtkDGG computes geodesic distances, paths, isolines, Voronoi cells and more on
triangle meshes and point clouds, exact or within an error bound.
${content}")
  install(
    FILES "${dgg_folder}/copyright" "${dgg_folder}/changelog.gz"
      "${dgg_folder}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
    COMPONENT "${component}"
    EXCLUDE_FROM_ALL)
endmacro ()

set(CPACK_COMPONENTS_ALL)
if (DGG_PARAVIEW_PLUGIN)
  dgg_add_package(plugin paraview-vtkdgg science "in ParaView"
    "This is the plugin Geodesics, with filters in the menu and in pvpython.")
  set(dgg_paraview_version "${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
  math(EXPR dgg_next "${ParaView_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PLUGIN_PACKAGE_DEPENDS
    "paraview (>= ${dgg_paraview_version}), paraview (<< ${ParaView_VERSION_MAJOR}.${dgg_next}~)")
  set(CPACK_DEBIAN_PLUGIN_PACKAGE_RECOMMENDS python3-paraview)
  # For an unpacked ParaView that is not installed.
  get_target_property(dgg_vtk_library VTK::CommonCore LOCATION)
  get_filename_component(dgg_vtk_folder "${dgg_vtk_library}" DIRECTORY)
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${dgg_vtk_folder}")
else ()
  set(dgg_runtime "libvtkdgg${dgg_soversion}")
  dgg_add_package(runtime "${dgg_runtime}" libs "for VTK"
    "These are the libraries that programs need to run.")
  # Dependencies of programs. (CPack would complain about the Python modules.)
  set(dgg_shlibs dggCore ${dgg_modules})
  if (dgg_with_parallel)
    list(APPEND dgg_shlibs DGG::FiltersParallel)
  endif ()
  list(TRANSFORM dgg_shlibs REPLACE "DGG::" "vtkDGG")
  list(TRANSFORM dgg_shlibs
    REPLACE "(.+)" "lib\\1 ${dgg_soversion} ${dgg_runtime} (= ${dgg_version})")
  list(JOIN dgg_shlibs "\n" dgg_shlibs)
  file(WRITE "${dgg_folder}/shlibs" "${dgg_shlibs}\n")
  file(WRITE "${dgg_folder}/triggers" "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${dgg_folder}/shlibs" "${dgg_folder}/triggers")

  dgg_add_package(development libvtkdgg-dev libdevel "for VTK (development)"
    "These are headers and the CMake package vtkDGG.")
  set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS runtime)
  # Debian's VTK searches its Qt modules in find_package().
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libvtk9-dev, libvtk9-qt-dev")
  if (DGG_WITH_PCL)
    set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS libpcl-dev)
  endif ()
endif ()
if (DGG_WITH_PYTHON)
  dgg_add_package(python python3-vtkdgg python "for VTK (Python)"
    "This is the package vtkdgg: functions on arrays and meshes, and all filters.")
  set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
  math(EXPR dgg_next "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python3_VERSION_MINOR}~), \
python3 (<< 3.${dgg_next}), python3-numpy, python3-vtk9")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-nibabel, python3-scipy, python3-tqdm")
  # Compiled modules are not in the package: scripts create and remove them.
  file(WRITE "${dgg_folder}/postinst" "#!/bin/sh\nset -e\nif [ \"$1\" = configure ]; then\n\
  py3compile -p python3-vtkdgg\nfi\n")
  file(WRITE "${dgg_folder}/prerm" "#!/bin/sh\nset -e\npy3clean -p python3-vtkdgg\n")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${dgg_folder}/postinst" "${dgg_folder}/prerm")

  dgg_add_package(tools vtkdgg-tools science "from the shell"
    "This is the command vtkdgg, which reads and writes files of many formats.")
  set(CPACK_COMPONENT_TOOLS_DEPENDS python)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS python3)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS "xvfb, xauth") # to draw without a display
  # The pages and their pictures.
  set(dgg_documentation "${CMAKE_INSTALL_DATADIR}/doc/vtkdgg-tools")
  foreach (dgg_page IN ITEMS README.md CHANGELOG.md CITATION.cff LICENSE ${dgg_pages})
    get_filename_component(dgg_page_folder "${dgg_page}" DIRECTORY)
    install(FILES "${PROJECT_SOURCE_DIR}/${dgg_page}"
      DESTINATION "${dgg_documentation}/${dgg_page_folder}"
      COMPONENT tools
      EXCLUDE_FROM_ALL)
  endforeach ()
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/Examples"
    DESTINATION "${dgg_documentation}"
    COMPONENT tools
    EXCLUDE_FROM_ALL
    PATTERN __pycache__ EXCLUDE
    PATTERN demo.sh EXCLUDE) # builds from sources
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/Testing/Benchmark/Images"
    DESTINATION "${dgg_documentation}/Testing/Benchmark"
    COMPONENT tools
    EXCLUDE_FROM_ALL)
endif ()
include(CPack)
