# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Runs the examples on a mesh that they make themselves.

set(run_program ${CMAKE_CURRENT_SOURCE_DIR}/../run_program.cmake)
set(example_dir ${CMAKE_CURRENT_BINARY_DIR}/run)
file(MAKE_DIRECTORY ${example_dir})

foreach(
  example
  conforming_triangulation_example
  cross_field_example
  cut_and_refine_example
  drawn_polyline_example
  edge_length_metric_example
  exact_number_type_example
  flattening_example
  geodesic_loop_example
  geodesic_path_example
  geodesic_spline_example
  geodesic_tree_example
  graph_example
  network_early_stop_example
  own_mesh_and_kernel_example
  poisson_example
  shortest_path_example
  write_files_example)
  if(TARGET ${example})
    add_test(NAME ${example} COMMAND ${example} WORKING_DIRECTORY ${example_dir})
    # With an exit status of its own: a crash is none.
    add_test(
      NAME ${example}_bad_input
      COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${example}> -D STATUS=1 -D PATTERN=. -D
              ARGUMENTS=no_such_mesh.off -P ${run_program}
      WORKING_DIRECTORY ${example_dir})
    if(EXISTS /dev/full)
      add_test(NAME ${example}_full_output COMMAND sh -c "\"$1\" > /dev/full; test $? -eq 1" sh $<TARGET_FILE:${example}>
               WORKING_DIRECTORY ${example_dir})
      # Both write the same files.
      set_tests_properties(${example} ${example}_full_output PROPERTIES RESOURCE_LOCK ${example})
    endif()
  endif()
endforeach()

# A result of one run as the mesh of the next.
if(TARGET cut_and_refine_example)
  add_test(
    NAME cut_and_refine_example_input_kept
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:cut_and_refine_example> -D STATUS=1 -D PATTERN=replace -D
            ARGUMENTS=./cut.off -P ${run_program}
    WORKING_DIRECTORY ${example_dir})
  set_tests_properties(cut_and_refine_example_input_kept PROPERTIES DEPENDS cut_and_refine_example RESOURCE_LOCK
                                                                    cut_and_refine_example)
endif()

# The listing of README.md.
add_test(NAME readme_input COMMAND $<TARGET_FILE:generate_torus> torus.off 24 12 WORKING_DIRECTORY ${example_dir})
set_tests_properties(readme_input PROPERTIES FIXTURES_SETUP readme_input)
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
  set_tests_properties(readme_example${name} PROPERTIES FIXTURES_REQUIRED readme_input)
endfunction()
flip_geodesics_add_readme_test("" 0 "LOCALLY_SHORTEST" torus.off)
flip_geodesics_add_readme_test(_disconnected 1 "^no path of edges joins vertex 0 and vertex 5\n$" two_parts.off)
flip_geodesics_add_readme_test(_no_mesh 1 "triangle mesh" missing.off)
flip_geodesics_add_readme_test(_no_vertex 1 "triangle mesh" no_vertex.off)
flip_geodesics_add_readme_test(_one_vertex 1 "." one_vertex.off)
flip_geodesics_add_readme_test(_no_argument 1 "triangle mesh" "")
