# SPDX-License-Identifier: LGPL-3.0-or-later
#
# cmake -D PROGRAM=... -D MPIEXEC=... -D NUMBER_OPTION=... -P distributed_paths.cmake
#
# Runs distributed_paths_example on one process and on more, and where a run was cut short. The results are the same.

# Processes of the superuser, and more of them than processors. Leaks are those of MPI.
foreach(variable OMPI_ALLOW_RUN_AS_ROOT OMPI_ALLOW_RUN_AS_ROOT_CONFIRM OMPI_MCA_rmaps_base_oversubscribe
                 PRTE_ALLOW_RUN_AS_ROOT PRTE_ALLOW_RUN_AS_ROOT_CONFIRM)
  set(ENV{${variable}} 1)
endforeach()
set(ENV{PRTE_MCA_rmaps_default_mapping_policy} ":oversubscribe")
set(ENV{ASAN_OPTIONS} detect_leaks=0)

set(paths "")
foreach(i RANGE 70)
  math(EXPR target "(${i} * 101 + 7) % 288")
  string(APPEND paths "torus.off ${i} ${target}\n")
endforeach()
string(APPEND paths "torus.off 0 288\nno_such_mesh.off 0 1\n\ntorus.off 1\n\"torus.off\" 7 9") # no end of the line
file(WRITE distributed_paths.txt "${paths}")
file(REMOVE distributed_1.txt distributed_2.txt distributed_3.txt)

function(run processes status)
  execute_process(
    COMMAND ${MPIEXEC} ${NUMBER_OPTION} ${processes} ${PROGRAM} distributed_paths.txt ${ARGN}
    RESULT_VARIABLE result
    OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT result STREQUAL status)
    message(FATAL_ERROR "${processes} processes: exit status ${result} instead of ${status}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(1 1 distributed_1.txt)
file(READ distributed_1.txt expected)
string(REGEX MATCHALL "torus.off\"? [0-9]+ [0-9]+: [0-9.]+ LOCALLY_SHORTEST\n" lengths "${expected}")
list(LENGTH lengths number)
string(REGEX MATCHALL ": error: (the mesh has 288 vertices|the file does not contain a triangle mesh|a line of paths)" errors
       "${expected}")
list(LENGTH errors number_of_errors)
if(NOT number EQUAL 72 OR NOT number_of_errors EQUAL 3 OR NOT output MATCHES "3 of the paths failed")
  message(FATAL_ERROR "${number} lengths and ${number_of_errors} errors in:\n${expected}\n${output}")
endif()

string(SUBSTRING "${expected}" 0 1000 beginning)
file(WRITE distributed_3.txt "${beginning}")
foreach(processes 2 3)
  run(${processes} 1 distributed_${processes}.txt)
  file(READ distributed_${processes}.txt results)
  if(NOT results STREQUAL expected)
    message(FATAL_ERROR "${processes} processes:\n${results}\ninstead of\n${expected}")
  endif()
endforeach()

# The results of other paths are not touched.
file(WRITE distributed_3.txt "torus.off 0 1: 2\n")
run(2 1 distributed_3.txt)
file(READ distributed_3.txt results)
if(NOT output MATCHES "contains results of other paths" OR NOT results STREQUAL "torus.off 0 1: 2\n")
  message(FATAL_ERROR "${output}\n${results}")
endif()
