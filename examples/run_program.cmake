# SPDX-License-Identifier: LGPL-3.0-or-later
#
# cmake -D PROGRAM=... -D ARGUMENTS=a|b|... -D STATUS=n -D PATTERN=regex -P run_program.cmake
#
# Fails unless the program exits with STATUS and prints something like PATTERN: on standard output, and then on standard
# error, if STATUS is 0, else on standard error, where bad input (2) must be told in one line without control characters and print nothing else.

string(REPLACE "|" ";" arguments "${ARGUMENTS}")
execute_process(
  COMMAND ${PROGRAM} ${arguments}
  RESULT_VARIABLE status
  OUTPUT_VARIABLE output
  ERROR_VARIABLE errors)
if(NOT status STREQUAL STATUS)
  message(FATAL_ERROR "exit status ${status} instead of ${STATUS}\n${output}${errors}")
endif()
if(STATUS EQUAL 0)
  set(text "${output}${errors}")
else()
  set(text "${errors}")
endif()
if(NOT text MATCHES "${PATTERN}")
  message(FATAL_ERROR "no '${PATTERN}' in:\n${text}")
endif()
string(ASCII 1 45 9 11 45 31 controls) # but not the end of the line
if(STATUS EQUAL 2 AND errors MATCHES "[${controls}]")
  message(FATAL_ERROR "control characters in:\n${errors}")
endif()
if(STATUS EQUAL 2 AND NOT errors MATCHES "^flip_geodesics: [^\n]*\n$")
  message(FATAL_ERROR "not one line:\n${errors}")
endif()
