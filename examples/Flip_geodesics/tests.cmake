# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Runs the examples on a torus that the program generate_torus makes.

set(run_program ${CMAKE_CURRENT_SOURCE_DIR}/../run_program.cmake)
set(example_dir ${CMAKE_CURRENT_BINARY_DIR}/run)
file(MAKE_DIRECTORY ${example_dir})

# With 12 * 24 vertices; those of the closed curves are around its hole and around its tube.
add_test(NAME example_input COMMAND $<TARGET_FILE:generate_torus> torus.off 24 12 WORKING_DIRECTORY ${example_dir})
set_tests_properties(example_input PROPERTIES FIXTURES_SETUP example_input)

# flip_geodesics_test_example(name arguments...)
function(flip_geodesics_test_example name)
  if(NOT TARGET ${name})
    return()
  endif()
  add_test(NAME ${name} COMMAND ${name} ${ARGN} WORKING_DIRECTORY ${example_dir})
  if(EXISTS /dev/full)
    add_test(NAME ${name}_full_output COMMAND sh -c "\"$@\" > /dev/full; test $? -eq 1" sh $<TARGET_FILE:${name}> ${ARGN}
             WORKING_DIRECTORY ${example_dir})
    # Both write the same files.
    set_tests_properties(${name}_full_output PROPERTIES FIXTURES_REQUIRED example_input RESOURCE_LOCK ${name})
  endif()
  set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED example_input RESOURCE_LOCK ${name})
  if("${ARGN}" STREQUAL "") # makes its own mesh
    return()
  endif()
  # With an exit status of its own: a crash is none.
  list(TRANSFORM ARGN REPLACE "torus.off" "no_such_mesh.off" OUTPUT_VARIABLE arguments)
  list(JOIN arguments "|" arguments)
  add_test(
    NAME ${name}_bad_input
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${name}> -D STATUS=1 -D "PATTERN=triangle mesh" -D
            "ARGUMENTS=${arguments}" -P ${run_program}
    WORKING_DIRECTORY ${example_dir})
endfunction()
flip_geodesics_test_example(certify_curve_example torus.off)
flip_geodesics_test_example(conforming_triangulation_example torus.off)
flip_geodesics_test_example(cross_field_example torus.off 0 150)
flip_geodesics_test_example(cut_and_refine_example torus.off)
flip_geodesics_test_example(drawn_polyline_example torus.off)
flip_geodesics_test_example(dragged_curve_example torus.off 0 100 130)
flip_geodesics_test_example(edge_length_metric_example torus.off)
flip_geodesics_test_example(kernels_example)
flip_geodesics_test_example(flattening_example torus.off 0 4 8 0 96 192 0)
if(TARGET flattening_example)
  add_test(NAME flattening_example_of_a_cut_graph COMMAND flattening_example torus.off WORKING_DIRECTORY ${example_dir})
  set_tests_properties(flattening_example_of_a_cut_graph PROPERTIES FIXTURES_REQUIRED example_input RESOURCE_LOCK
                                                                    flattening_example)
endif()
flip_geodesics_test_example(geodesic_loop_example torus.off 0 96 192)
flip_geodesics_test_example(geodesic_path_example torus.off)
flip_geodesics_test_example(geodesic_spline_example torus.off)
flip_geodesics_test_example(geodesic_tree_example torus.off 7)
flip_geodesics_test_example(graph_example torus.off 0 40 5)
flip_geodesics_test_example(distance_field_example torus.off)
flip_geodesics_test_example(distance_table_example torus.off)
flip_geodesics_test_example(insert_curves_example torus.off)
flip_geodesics_test_example(isolines_example torus.off 0 100 200)
flip_geodesics_test_example(network_early_stop_example torus.off)
flip_geodesics_test_example(own_mesh_and_kernel_example torus.off)
flip_geodesics_test_example(loop_basis_example torus.off 0 4 8)
flip_geodesics_test_example(handle_and_tunnel_loops_example torus.off)
flip_geodesics_test_example(poisson_example torus.off 0 150)
flip_geodesics_test_example(save_network_example torus.off)
flip_geodesics_test_example(obstacles_example torus.off 6 150)
flip_geodesics_test_example(other_ways_example torus.off 6 150 4 100 101)
flip_geodesics_test_example(shortest_path_example torus.off 6 150)
flip_geodesics_test_example(trace_geodesic_example torus.off 2 7)
flip_geodesics_test_example(parallel_paths_example torus.off 2)
flip_geodesics_test_example(parallel_transport_example torus.off 7 1)
flip_geodesics_test_example(means_example torus.off 0 5 60)
flip_geodesics_test_example(decal_example torus.off 7 1.5 scan.png)
flip_geodesics_test_example(write_files_example torus.off)

# On one process and on several, from the beginning and from the middle, with the same results.
if(TARGET distributed_paths_example)
  add_test(
    NAME distributed_paths_example
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:distributed_paths_example> -D MPIEXEC=${MPIEXEC_EXECUTABLE} -D
            NUMBER_OPTION=${MPIEXEC_NUMPROC_FLAG} -P ${CMAKE_CURRENT_SOURCE_DIR}/distributed_paths.cmake
    WORKING_DIRECTORY ${example_dir})
  set_tests_properties(distributed_paths_example PROPERTIES FIXTURES_REQUIRED example_input)
endif()

# A word where a number belongs.
foreach(case "decal_example 7 two" "edge_length_metric_example two" "geodesic_path_example 0 two" "loop_basis_example 0 two" "means_example two" "network_early_stop_example two"
             "obstacles_example two 0"
             "parallel_paths_example two" "parallel_transport_example 7 two" "shortest_path_example two 0"
             "trace_geodesic_example two")
  string(REPLACE " " ";" case "${case}")
  list(POP_FRONT case name)
  list(JOIN case "|" arguments)
  if(TARGET ${name})
    add_test(
      NAME ${name}_no_number
      COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${name}> -D STATUS=1 -D "PATTERN=two is not a number" -D
              "ARGUMENTS=torus.off|${arguments}" -P ${run_program}
      WORKING_DIRECTORY ${example_dir})
    set_tests_properties(${name}_no_number PROPERTIES FIXTURES_REQUIRED example_input)
  endif()
endforeach()

# A result of one run as the mesh of the next.
foreach(case "flattening_example flattening.obj 0 1 2" "geodesic_tree_example logarithmic_map.obj"
             "poisson_example poisson.ply 0 1" "write_files_example ends.ply")
  string(REPLACE " " ";" case "${case}")
  list(POP_FRONT case name result)
  list(JOIN case "|" arguments)
  if(TARGET ${name})
    add_test(
      NAME ${name}_input_kept
      COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${name}> -D STATUS=1 -D PATTERN=replace -D
              "ARGUMENTS=./${result}|${arguments}" -P ${run_program}
      WORKING_DIRECTORY ${example_dir})
    set_tests_properties(${name}_input_kept PROPERTIES DEPENDS ${name} RESOURCE_LOCK ${name})
  endif()
endforeach()

# The listing of README.md.
if(NOT TARGET readme_example)
  return()
endif()
file(WRITE ${example_dir}/no_vertex.off "OFF\n0 0 0\n")
file(WRITE ${example_dir}/one_vertex.off "OFF\n1 0 0\n0 0 0\n")
file(WRITE ${example_dir}/two_parts.off
     "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n5 0 0\n6 0 0\n6 1 0\n3 0 1 2\n3 3 4 5\n")

# flip_geodesics_add_readme_test(name status pattern arguments...)
function(flip_geodesics_add_readme_test name status pattern)
  add_test(
    NAME readme_example${name}
    COMMAND
      ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:readme_example> -D STATUS=${status} -D PATTERN=${pattern} -D
      ARGUMENTS=${ARGN} -P ${run_program}
    WORKING_DIRECTORY ${example_dir})
  set_tests_properties(readme_example${name} PROPERTIES FIXTURES_REQUIRED example_input)
endfunction()
flip_geodesics_add_readme_test("" 0 "LOCALLY_SHORTEST PROVEN" torus.off)
flip_geodesics_add_readme_test(_disconnected 1 "^vertices 0 and 5 lie in different connected components; no path connects them\n$" two_parts.off)
flip_geodesics_add_readme_test(_no_mesh 1 "manifold mesh" missing.off)
flip_geodesics_add_readme_test(_no_vertex 1 "manifold mesh" no_vertex.off)
flip_geodesics_add_readme_test(_one_vertex 1 "." one_vertex.off)
flip_geodesics_add_readme_test(_no_argument 1 "manifold mesh" "")
