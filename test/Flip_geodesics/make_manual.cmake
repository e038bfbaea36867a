# SPDX-License-Identifier: LGPL-3.0-or-later
#
# cmake -D source=... -D binary=... -D generator=... -D make_program=... -D cgal_dir=... -D compiler=... -D python=...
#   -P make_manual.cmake
#
# Makes the manual in the folder `binary`, with the two commands of README.md, and reads it.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${output}")
  endif()
endfunction()

run("${CMAKE_COMMAND}" -S "${source}" -B "${binary}" -G "${generator}" -D FLIP_GEODESICS_BUILD_DOC=ON
    -D CMAKE_DISABLE_FIND_PACKAGE_boost_unit_test_framework=ON -D "CGAL_DIR=${cgal_dir}"
    -D "CMAKE_CXX_COMPILER=${compiler}" -D "CMAKE_MAKE_PROGRAM=${make_program}")
run("${CMAKE_COMMAND}" --build "${binary}" --target doc)
run("${python}" "${source}/test/Flip_geodesics/check_manual.py" "${binary}/doc/Flip_geodesics/html")
