# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DFOLDER=... -P CheckRelocatable.cmake: fails when a CMake file in the folder, as installed,
# has the path of a library or header of this machine.
file(GLOB files "${FOLDER}/*.cmake")
if (NOT files)
  message(FATAL_ERROR "no CMake files in ${FOLDER}")
endif ()
foreach (file IN LISTS files)
  file(STRINGS "${file}" paths REGEX "(\"|;|LINK_ONLY:)/[^\"]*(lib|include)")
  if (paths)
    message(FATAL_ERROR "${file} names a path of this machine:\n${paths}")
  endif ()
endforeach ()
