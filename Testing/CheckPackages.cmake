# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# The Debian packages of a build tree hold each file that gets installed, once, and their
# documentation, and depend on what they need:
#   cmake -DBUILD=<build tree> -DPACKAGES=<folder> -DVERSION=... -DSOVERSION=... -DWITH_PCL=...
#     -DWITH_PYTHON=... -P CheckPackages.cmake
cmake_minimum_required(VERSION 3.20) # if (... IN_LIST ...)

file(READ "${CMAKE_CURRENT_LIST_DIR}/../Wrapping/README.md" page)

# check_package(<name> <depends>...): its files go to ${packed}.
function (check_package name)
  string(FIND "${page}" "| `${name}` |" row)
  if (row EQUAL -1)
    message(SEND_ERROR "Wrapping/README.md does not list ${name}")
  endif ()
  file(GLOB archive "${PACKAGES}/${name}_${VERSION}-1_*.deb")
  if (NOT archive)
    message(FATAL_ERROR "there is no package ${name}")
  endif ()
  execute_process(
    COMMAND dpkg-deb --field "${archive}" Depends
    OUTPUT_VARIABLE depends
    OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  foreach (need IN LISTS ARGN)
    string(FIND ", ${depends}," ", ${need}" position) # up to a version or not
    if (position EQUAL -1)
      message(SEND_ERROR "${name} does not depend on ${need}, only on ${depends}")
    endif ()
  endforeach ()

  set(folder "${PACKAGES}/unpacked/${name}")
  file(MAKE_DIRECTORY "${folder}")
  execute_process(
    COMMAND dpkg-deb --extract "${archive}" "${folder}"
    COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB_RECURSE files RELATIVE "${folder}/usr" "${folder}/*")
  foreach (file IN ITEMS copyright changelog.gz changelog.Debian.gz)
    if (NOT "share/doc/${name}/${file}" IN_LIST files)
      message(SEND_ERROR "${name} has no ${file}")
    endif ()
  endforeach ()
  list(FILTER files EXCLUDE REGEX "^share/doc/")
  foreach (file IN LISTS files)
    if (file IN_LIST packed)
      message(SEND_ERROR "${file} is in ${name} and in another package")
    endif ()
  endforeach ()
  set(packed ${packed} ${files} PARENT_SCOPE)
endfunction ()

if (EXISTS "${PACKAGES}/libvtkdgg-dev_0.0-1_all.deb")
  message(SEND_ERROR "a package of before is there")
endif ()
set(packed)
set(library "libvtkdgg${SOVERSION}")
set(cloud_library)
if (WITH_PCL)
  set(cloud_library libpcl-kdtree)
endif ()
check_package("${library}" libc6 libstdc++6 libvtk9. ${cloud_library})
check_package(libvtkdgg-dev
  "${library} (= ${VERSION}-1)" libvtk9-dev libvtk9-qt-dev)
if (WITH_PYTHON)
  check_package(python3-vtkdgg
    "${library} (= ${VERSION}-1)" libvtk9. "python3 (>= 3." "python3 (<< 3." python3-numpy
    python3-vtk9)
  check_package(vtkdgg-tools "python3-vtkdgg (= ${VERSION}-1)" "python3,")
  if (NOT EXISTS "${PACKAGES}/unpacked/vtkdgg-tools/usr/share/doc/vtkdgg-tools/Examples/Solved.md")
    message(SEND_ERROR "vtkdgg-tools has no pages")
  endif ()
endif ()

file(REMOVE_RECURSE "${PACKAGES}/installed")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PACKAGES}/installed"
  OUTPUT_QUIET
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE installed RELATIVE "${PACKAGES}/installed" "${PACKAGES}/installed/*")
set(missing ${installed})
list(REMOVE_ITEM missing ${packed})
list(REMOVE_ITEM packed ${installed})
if (missing OR packed)
  message(FATAL_ERROR "in no package: ${missing}\nnot installed, but in a package: ${packed}")
endif ()
