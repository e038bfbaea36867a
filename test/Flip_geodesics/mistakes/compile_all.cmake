# SPDX-License-Identifier: LGPL-3.0-or-later
#
# cmake -D build_dir=... -D target=... -D config=... -D messages=FOLDER -P compile_all.cmake
#
# Compiles all mistakes as one source, and writes the errors of the mistake in NUMBER.h to FOLDER/NUMBER.txt. Fails if an
# error belongs to none of them.

cmake_minimum_required(VERSION 3.16)

execute_process(COMMAND "${CMAKE_COMMAND}" --build "${build_dir}" --target "${target}" --config "${config}"
                RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(status EQUAL 0)
  message(FATAL_ERROR "mistakes compile")
endif()
# What CMake takes for parts of a list.
string(REGEX REPLACE "[][;]" "," output "${output}")
# A line with an error begins a new part.
string(REGEX REPLACE "\n([^\n]*: error: )" ";\\1" parts "${output}")
list(POP_FRONT parts before)

file(REMOVE_RECURSE "${messages}")
file(MAKE_DIRECTORY "${messages}")
set(number "")
set(place "/([0-9]+)\\.h:[0-9]+")
foreach(part IN LISTS parts)
  # clang++ says in notes after an error for which line something is instantiated, once for the errors in a row that come
  # of it; g++ says so before each.
  if(part MATCHES "^[^\n]*${place}")
    set(number "${CMAKE_MATCH_1}")
  elseif(output MATCHES "required from here")
    if(before MATCHES ".*${place}") # the last one
      set(number "${CMAKE_MATCH_1}")
    endif()
  elseif(part MATCHES "${place}")
    set(number "${CMAKE_MATCH_1}")
  endif()
  if(number STREQUAL "")
    message(FATAL_ERROR "of no mistake: ${part}")
  endif()
  file(APPEND "${messages}/${number}.txt" "${part}\n")
  set(before "${part}")
endforeach()
