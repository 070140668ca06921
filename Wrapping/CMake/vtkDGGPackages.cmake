# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# Debian packages, one for each component of what is installed: cpack -G DEB, or the target package.
# The folders are those of Debian when the prefix is /usr (preset package). Of the plugin there is one
# package, which has all of its libraries in its own folder, as ParaView's VTK is another one.
foreach (program IN ITEMS dpkg-deb dpkg-shlibdeps file gzip)
  find_program("DGG_PROGRAM_${program}" "${program}")
  mark_as_advanced("DGG_PROGRAM_${program}")
  if (NOT DGG_PROGRAM_${program})
    message(STATUS "No Debian packages can be made: there is no ${program}.")
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
  set(CPACK_PACKAGE_CONTACT "vtkDGG authors <vtkdgg@example.invalid>") # whoever hands them out
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

set(version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(folder "${CMAKE_BINARY_DIR}/packaging")

# What Debian wants of every package.
file(READ "${PROJECT_SOURCE_DIR}/LICENSE" license)
file(WRITE "${folder}/copyright" "vtkDGG, made into packages by CPack.\n\n${license}\n\
The libraries hold compiled code of headers of Eigen and Spectra, which are under the MPL-2.0\n\
(/usr/share/common-licenses/MPL-2.0) and in Debian's packages libeigen3-dev and libspectra-dev.\n")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE "${folder}/changelog.Debian" "vtkdgg (${version}) unstable; urgency=medium\n\n\
  * Made by CPack. What has changed is in changelog.gz.\n\n\
 -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
configure_file("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${folder}/changelog" COPYONLY)
execute_process(
  COMMAND "${DGG_PROGRAM_gzip}" -9nf "${folder}/changelog" "${folder}/changelog.Debian"
  COMMAND_ERROR_IS_FATAL ANY)

# dgg_add_package(<component> <package> <section> <for what> <what it is>): its other variables are
# those of CPack.
macro (dgg_add_package component package section purpose content)
  string(TOUPPER "${component}" name)
  list(APPEND CPACK_COMPONENTS_ALL "${component}")
  set(CPACK_DEBIAN_${name}_PACKAGE_NAME "${package}")
  set(CPACK_DEBIAN_${name}_PACKAGE_SECTION "${section}")
  set(CPACK_COMPONENT_${name}_DESCRIPTION "geodesics on meshes and point clouds, ${purpose}
vtkDGG computes geodesic distances, paths, isolines, Voronoi cells and more on
triangle meshes and point clouds, exact or within a promised error.
${content}")
  install(FILES "${folder}/copyright" "${folder}/changelog.gz" "${folder}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
    COMPONENT "${component}"
    EXCLUDE_FROM_ALL)
endmacro ()

set(CPACK_COMPONENTS_ALL)
if (DGG_PARAVIEW_PLUGIN)
  dgg_add_package(plugin paraview-vtkdgg science "in ParaView"
    "This is the plugin Geodesics, with filters in the menu and in pvpython.")
  set(paraview_version "${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
  math(EXPR next "${ParaView_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PLUGIN_PACKAGE_DEPENDS
    "paraview (>= ${paraview_version}), paraview (<< ${ParaView_VERSION_MAJOR}.${next}~)")
  set(CPACK_DEBIAN_PLUGIN_PACKAGE_RECOMMENDS python3-paraview)
  # Of a ParaView that is unpacked, not installed.
  get_target_property(library VTK::CommonCore LOCATION)
  get_filename_component(library_folder "${library}" DIRECTORY)
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${library_folder}")
else ()
  set(package "libvtkdgg${dgg_soversion}")
  dgg_add_package(runtime "${package}" libs "for VTK"
    "These are the libraries that programs need to run.")
  # What packages of programs depend on. (CPack would complain of the modules of Python.)
  string(REPLACE "DGG::" "vtkDGG" libraries "dggCore;${dgg_modules}")
  list(TRANSFORM libraries REPLACE "(.+)" "lib\\1 ${dgg_soversion} ${package} (= ${version})")
  list(JOIN libraries "\n" libraries)
  file(WRITE "${folder}/shlibs" "${libraries}\n")
  file(WRITE "${folder}/triggers" "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${folder}/shlibs" "${folder}/triggers")

  dgg_add_package(development libvtkdgg-dev libdevel "for VTK (development)"
    "These are headers and the CMake package vtkDGG.")
  set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS runtime)
  # Debian's VTK looks for its Qt parts when it is found.
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libvtk9-dev, libvtk9-qt-dev")
  if (DGG_WITH_PCL)
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libflann-dev, liblz4-dev")
    set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS libpcl-dev)
  endif ()
endif ()
if (DGG_WITH_PYTHON)
  dgg_add_package(python python3-vtkdgg python "for VTK (Python)"
    "This is the package vtkdgg: functions on arrays and meshes, and all filters.")
  set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
  math(EXPR next "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python3_VERSION_MINOR}~), \
python3 (<< 3.${next}), python3-numpy, python3-vtk9")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-scipy, python3-tqdm")
  # Compiled modules are not in the package, so they are to be made and to be removed.
  file(WRITE "${folder}/postinst" "#!/bin/sh\nset -e\nif [ \"$1\" = configure ]; then\n\
  py3compile -p python3-vtkdgg\nfi\n")
  file(WRITE "${folder}/prerm" "#!/bin/sh\nset -e\npy3clean -p python3-vtkdgg\n")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${folder}/postinst" "${folder}/prerm")

  dgg_add_package(tools vtkdgg-tools science "from the shell"
    "This is the command vtkdgg, which reads and writes files of many formats.")
  set(CPACK_COMPONENT_TOOLS_DEPENDS python)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS python3)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS "xvfb, xauth") # to draw without a display
endif ()
include(CPack)
