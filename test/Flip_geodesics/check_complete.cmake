# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Fails if CTest knows fewer tests than there should be. Arguments:
#   build_dir   where CTest looks
#   ctest       the program ctest
#   expected    names of tests, separated by commas
#   pattern     files of which each must be a test of the same name, or empty; looked up now, not when configuring

cmake_minimum_required(VERSION 3.16)

string(REPLACE "," ";" expected "${expected}")
if(pattern)
  file(GLOB sources "${pattern}")
  if(NOT sources)
    message(FATAL_ERROR "no test source matches ${pattern}")
  endif()
  foreach(source IN LISTS sources)
    get_filename_component(name "${source}" NAME_WE)
    list(APPEND expected ${name})
  endforeach()
endif()
list(REMOVE_DUPLICATES expected)

execute_process(
  COMMAND "${ctest}" -N
  WORKING_DIRECTORY "${build_dir}"
  OUTPUT_VARIABLE listing
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "ctest -N failed in ${build_dir}")
endif()
string(REGEX MATCHALL "Test +#[0-9]+: [^\n]+" registered "${listing}")
list(TRANSFORM registered REPLACE "Test +#[0-9]+: " "")

set(missing ${expected})
list(REMOVE_ITEM missing ${registered})
if(missing)
  message(FATAL_ERROR "not registered with CTest: ${missing}")
endif()
list(LENGTH expected number_expected)
list(LENGTH registered number_registered)
message(STATUS "${number_registered} tests are registered, at least ${number_expected} are expected")
