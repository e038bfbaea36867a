# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Runs the program on a generated mesh with good and bad input.

set(run_program ${CMAKE_CURRENT_SOURCE_DIR}/../run_program.cmake)
set(program_dir ${CMAKE_CURRENT_BINARY_DIR}/run)
file(MAKE_DIRECTORY ${program_dir})

# What is read by other programs than ours, and what happens to files and streams.
find_package(Python3 COMPONENTS Interpreter QUIET)

# flip_geodesics_add_program_test(name status pattern arguments...): the exit status and what is printed.
function(flip_geodesics_add_program_test name status pattern)
  string(REPLACE ";" "|" arguments "${ARGN}")
  string(REPLACE ";" "." pattern "${pattern}") # which would end the argument
  add_test(
    NAME program_${name}
    COMMAND
      ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:flip_geodesics> -D STATUS=${status} -D PATTERN=${pattern} -D
      ARGUMENTS=${arguments} -P ${run_program}
    WORKING_DIRECTORY ${program_dir})
  set_tests_properties(program_${name} PROPERTIES FIXTURES_REQUIRED program_input)
endfunction()

if(TARGET flip_geodesics AND TARGET generate_torus)
  add_test(NAME program_input COMMAND generate_torus torus.off 24 12 WORKING_DIRECTORY ${program_dir})
  set_tests_properties(program_input PROPERTIES FIXTURES_SETUP program_input)

  # A torus of 24 x 12 vertices; vertex 12 i + j.
  file(WRITE ${program_dir}/pairs.txt "0 150\n# a comment\n3 77 # another\n")
  file(WRITE ${program_dir}/zeros.txt "00 0150\n+010 077\n")
  file(WRITE ${program_dir}/hexadecimal.txt "0 0x1\n")
  file(WRITE ${program_dir}/path.txt "0 1 2 14 26 25 37\n5 6 7\n")
  file(WRITE ${program_dir}/loop.txt "0 1 2 3 4 5 6 7 8 9 10 11 0\n")
  file(WRITE ${program_dir}/trivial_loop.txt "0 12 13\n")
  file(WRITE ${program_dir}/network.txt "o 0 1 2 3 4 5 6 7 8 9 10 11\n24 36 48 49\n49 50 51\n25 24\n! 36\n")
  file(WRITE ${program_dir}/gap.txt "0 1 2\n0 1 5\n")
  file(WRITE ${program_dir}/crossing.txt "5 6 7\n3 4 5 17 16 4 280\n")
  file(WRITE ${program_dir}/crossing_network.txt "3 4 5\n16 4 280\n")
  file(WRITE ${program_dir}/joined_network.txt "3 4 5\n16 4 280\n! 4\n")
  file(WRITE ${program_dir}/loose_network.txt "3 4 5\n! 9\n")
  file(WRITE ${program_dir}/no_curve.txt "# nothing\n\n")
  file(WRITE ${program_dir}/equal.txt "0 1\n4 4\n")
  file(WRITE ${program_dir}/seam.off "OFF\n8 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1.0000000000000002 0 0\n2 0 0\n2 1 0\n"
                                     "1.0000000000000002 1 0\n3 0 1 2\n3 0 2 3\n3 4 5 6\n3 4 6 7\n")
  file(WRITE ${program_dir}/some_joined.txt "0 1\n0 3\n3 5\n2 4\n")
  file(WRITE ${program_dir}/far.txt "0 1\n4 400\n")
  file(WRITE ${program_dir}/word.txt "0 one\n")
  file(WRITE ${program_dir}/points.txt "0 150\n0,1,0.25 13,14,26,0.3,0.3 100\n")
  file(WRITE ${program_dir}/crossing_bezier.txt "0 39 3 36 26 1 38\n0 15 40 65\n")
  file(WRITE ${program_dir}/crossing_line.txt "0 39 3 36 26 1 38\n")
  file(WRITE ${program_dir}/bezier.txt "0,12,13,0.3,0.3 15 40,41,0.5 65\ns 0 15 40 65\n")
  file(WRITE ${program_dir}/drawn.txt "0,12,13,0.3,0.3 15 40,41,0.5 65\no 0,12,13,0.3,0.3 48,60,61,0.2,0.3 3 # closed\n")
  file(WRITE ${program_dir}/pen.polylines.txt
       "9 1.4 0 0 1 1 0 0 1.4 0 -1 1 0 -1.4 0 0 -1 -1 0 0 -1.4 0 1 -1 0 1.4 0 0\n")
  file(WRITE ${program_dir}/short.polylines.txt "3 0 0 0 1 1 1\n")
  file(WRITE ${program_dir}/bad_points.txt "0,1,1.5 7\n")
  file(WRITE ${program_dir}/no_face.txt "0,1,100,0.2,0.2 7\n")
  file(WRITE ${program_dir}/empty.off "")
  file(WRITE ${program_dir}/two_points.txt "0,1,2,0.3,0.3 3,4,5,0.3,0.3\n")
  file(WRITE ${program_dir}/quad.off "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
  file(WRITE ${program_dir}/turned.off "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 3 2\n")
  file(WRITE ${program_dir}/book.off "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n")
  file(WRITE ${program_dir}/bow.off "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n-1 0 0\n-1 -1 0\n3 0 1 2\n3 0 3 4\n")
  file(WRITE ${program_dir}/repeated.off "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 1\n")
  file(WRITE ${program_dir}/range.obj "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 4\n")
  file(WRITE ${program_dir}/nan.obj "v 0 0 0\nv 1 0 nan\nv 1 1 0\nf 1 2 3\n")
  file(WRITE ${program_dir}/truncated.off "OFF\n3 1 0\n0 0 0\n1 0 0\n")
  file(WRITE ${program_dir}/huge.off "OFF\n900000000000 1 0\n0 0 0\n")
  file(WRITE ${program_dir}/early_property.ply "ply\nformat ascii 1.0\nproperty float x\nelement vertex 1\nend_header\n0\n")
  string(ASCII 27 escape)
  string(ASCII 239 187 191 byte_order_mark)
  file(WRITE ${program_dir}/escape.txt "0 1\n2 ${escape}c7\n")
  file(WRITE ${program_dir}/marked.txt "${byte_order_mark}0 150\r\n3 77\r")
  file(WRITE ${program_dir}/beyond.txt "0 99999999999999999999\n")
  file(WRITE ${program_dir}/two_parts.off
       "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n5 0 0\n6 0 0\n6 1 0\n3 0 1 2\n3 3 4 5\n")
  # Vertices 3 and 4 are one point; the path from 0 to 2 stays away from them.
  file(WRITE ${program_dir}/zero_length.off
       "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n9 9 0\n9 9 0\n3 0 1 2\n3 0 2 3\n3 3 2 4\n")
  file(WRITE ${program_dir}/zero_length.txt "0 4\n0 1\n")
  # The points of the face 1 0 3, which has no area, are moved to the other face.
  file(WRITE ${program_dir}/flat.off "OFF\n4 2 0\n0 0 0\n2 0 0\n1 1 0\n3 0 0\n3 0 1 2\n3 1 0 3\n")
  file(WRITE ${program_dir}/flat.polylines.txt "2 2.7 0 0 1 0.9 0\n")
  file(WRITE ${program_dir}/no_area.off "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n")
  file(WRITE ${program_dir}/tiny.off "OFF\n3 1 0\n0 0 0\n1e-170 0 0\n0 1e-170 0\n3 0 1 2\n")
  file(WRITE ${program_dir}/far.polylines.txt "2 1 0 0 1e308 0 0\n")

  # A square pyramid: a quadrilateral, a face turned over, one that is there twice, two points in the place of vertex 4,
  # a point that is none, a triangle at vertex 0 alone.
  file(WRITE ${program_dir}/pyramid.off
       "OFF\n10 8 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 2\n1 1 2\n1 1 2\n0 nan 0\n-1 0 0\n-1 -1 0\n"
       "4 3 2 1 0\n3 0 1 4\n3 1 5 2\n3 2 3 4\n3 3 0 6\n3 0 1 4\n3 0 1 7\n3 0 8 9\n")
  file(WRITE ${program_dir}/pyramid_edges.txt "0 5 2\n")
  file(WRITE ${program_dir}/pyramid.seg "# labels\n0 # the base\n1\n1\n1\n1\n1\n1\n1\n")
  file(WRITE ${program_dir}/collapsed.off "OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n")
  file(WRITE ${program_dir}/quad_seam.obj "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                          "vt 0 1\nvt 5 5\nf 1/1 2/2 3/3 4/4\nf 2/5 5/2 6/3 3/4\n")

  flip_geodesics_add_program_test(pair 0 "1 curve: 1 LOCALLY_SHORTEST" path torus.off --from 0 --to 150)
  flip_geodesics_add_program_test(pairs 0 "2 LOCALLY_SHORTEST" path torus.off --pairs pairs.txt --mesh pairs.vtp)
  flip_geodesics_add_program_test(random 0 "30 LOCALLY_SHORTEST" path torus.off --random 30 --seed 7 --mesh random.ply)
  flip_geodesics_add_program_test(dijkstra 0 "9 LOCALLY_SHORTEST" path torus.off --random 9 --search dijkstra)
  flip_geodesics_add_program_test(astar 0 "9 LOCALLY_SHORTEST" path torus.off --random 9 --search astar)
  if(TARGET CGAL::TBB_support)
    flip_geodesics_add_program_test(help_with_threads 0 "--threads NUMBER" path --help)
    flip_geodesics_add_program_test(threads 0 "30 LOCALLY_SHORTEST" path torus.off --random 30 --seed 7 --threads 2)
    flip_geodesics_add_program_test(no_threads 2 "--threads: '0' is out of range" path torus.off --random 2 --threads 0)
    flip_geodesics_add_program_test(threads_too_many 2 "--threads: '99999999999' is out of range" path torus.off
                                    --random 1 --threads 99999999999)
    flip_geodesics_add_program_test(threads_and_page 2 "--threads and --page cannot be combined" path torus.off --random 2
                                    --threads 2 --page threads.html)
    flip_geodesics_add_program_test(threads_and_page_as_output 2 "--threads and the page threads.html cannot be combined"
                                    path torus.off --random 2 --threads 2 -o threads.html)
    # More than there are, without a word on standard error.
    flip_geodesics_add_program_test(many_threads 0 "30 LOCALLY_SHORTEST.*extract [^\n]*\n$" path torus.off --random 30
                                    --seed 7 --threads 1024)
  endif()
  # The shortened paths of edges have other lengths.
  flip_geodesics_add_program_test(shortest_pair 0 " 2.77034 .*1 WITHIN_ROUNDING" shortest torus.off --from 0 --to 150)
  flip_geodesics_add_program_test(shortest_pairs 0 "2 WITHIN_ROUNDING.*locally shortest: 2 PROVEN" shortest torus.off
                                  --pairs pairs.txt --stats shortest_pairs.csv)
  flip_geodesics_add_program_test(landmarks 0 "4 landmarks, computed in.*30 WITHIN_ROUNDING" shortest torus.off --random 30
                                  --seed 7 --landmarks 4 --polylines landmarks.txt)
  flip_geodesics_add_program_test(without_landmarks 0 "30 WITHIN_ROUNDING" shortest torus.off --random 30 --seed 7
                                  --polylines without_landmarks.txt)
  if(TARGET CGAL::TBB_support)
    flip_geodesics_add_program_test(landmarks_by_threads 0 "30 WITHIN_ROUNDING" shortest torus.off --random 30 --seed 7
                                    --landmarks 4 --threads 2 --polylines landmarks_by_threads.txt)
  endif()
  foreach(other without_landmarks landmarks_by_threads)
    if(TEST program_${other})
      add_test(NAME program_${other}_same COMMAND ${CMAKE_COMMAND} -E compare_files landmarks.txt ${other}.txt
               WORKING_DIRECTORY ${program_dir})
      set_tests_properties(program_${other}_same PROPERTIES DEPENDS "program_landmarks;program_${other}")
    endif()
  endforeach()
  flip_geodesics_add_program_test(shortest_double 0 "2 WITHIN_TOLERANCE" shortest torus.off --pairs pairs.txt --kernel
                                  double)
  flip_geodesics_add_program_test(shortest_given_up 0 " 2.80946 .*1 UNDECIDED" shortest torus.off --from 0 --to 150
                                  --memory-limit 0.0001)
  flip_geodesics_add_program_test(shortest_inserted 0 "1 WITHIN_ROUNDING" shortest torus.off --from 0 --to 150 --insert
                                  shortest.off)
  flip_geodesics_add_program_test(shortest_on_contracted 0 "2 WITHIN_ROUNDING.*1 curve was computed after degenerate edges had been contracted\n"
                                  shortest zero_length.off --pairs zero_length.txt)
  flip_geodesics_add_program_test(landmarks_of_nothing 2 "--landmarks: .*length zero; omit --landmarks or use --mollify"
                                  shortest zero_length.off --pairs zero_length.txt --landmarks 2)
  flip_geodesics_add_program_test(landmarks_mollified 0 "2 WITHIN_ROUNDING" shortest zero_length.off --pairs
                                  zero_length.txt --landmarks 2 --mollify 1e-3)
  flip_geodesics_add_program_test(landmarks_alone 2 "--landmarks is not an option of path, but of shortest" path
                                  torus.off --random 2 --landmarks 2)
  flip_geodesics_add_program_test(no_landmarks 2 "--landmarks: '0' is out of range. use at least 1 and at most 1000"
                                  shortest torus.off --random 2 --landmarks 0)
  flip_geodesics_add_program_test(shortest_loop 2 "--loop is not an option of shortest, but of loop" shortest torus.off
                                  --loop loop.txt)
  flip_geodesics_add_program_test(shortest_stopped 2 "--stop-length is not an option of shortest, but of path" shortest
                                  torus.off --random 2 --stop-length 0.9)
  flip_geodesics_add_program_test(path 0 "2 LOCALLY_SHORTEST" path torus.off --edges path.txt --mesh path.obj --tubes 0)
  flip_geodesics_add_program_test(tubes 0 "2 LOCALLY_SHORTEST" path torus.off --edges path.txt --mesh tubes.glb --tubes
                                  0.02)
  add_test(NAME program_materials COMMAND ${CMAKE_COMMAND} -E cat path.obj.mtl WORKING_DIRECTORY ${program_dir})
  set_tests_properties(program_materials PROPERTIES DEPENDS program_path PASS_REGULAR_EXPRESSION "newmtl curve_a\nKd ")
  flip_geodesics_add_program_test(negative_tubes 2 "--tubes: '-0.02' is out of range" path torus.off --edges path.txt
                                  --mesh t.glb --tubes=-0.02)
  flip_geodesics_add_program_test(tubes_of_nothing 2 "--tubes requires --output" path torus.off --edges path.txt --tubes
                                  1)
  # The other files have no tubes: the curves are those without the option.
  flip_geodesics_add_program_test(tubes_and_polylines 0 "1 LOCALLY_SHORTEST" path torus.off --from 0 --to 150 --tubes 0.02
                                  -o tubes.vtp -o tubes.polylines.txt -o tubes.csv)
  flip_geodesics_add_program_test(no_tubes 0 "1 LOCALLY_SHORTEST" path torus.off --from 0 --to 150 -o
                                  no_tubes.polylines.txt)
  add_test(NAME program_polylines_beside_tubes
           COMMAND ${CMAKE_COMMAND} -E compare_files tubes.polylines.txt no_tubes.polylines.txt
           WORKING_DIRECTORY ${program_dir})
  set_tests_properties(program_polylines_beside_tubes PROPERTIES DEPENDS "program_tubes_and_polylines;program_no_tubes")
  # Points on edges need not share a face if degenerate edges between them were contracted.
  file(WRITE ${program_dir}/coincident.off "OFF\n6 8 0\n1 0 0\n0 0 1\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n3 0 2 4\n3 2 1 4\n"
                                           "3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n")
  flip_geodesics_add_program_test(samples_of_contracted 2 "--sample: curve --from, --to passes through degenerate edges; use --repair"
                                  path coincident.off --from 0 --to 1 --sample 0.2)
  flip_geodesics_add_program_test(cut_along_contracted 2 "--insert and --cut: a curve passes through degenerate edges; use --repair"
                                  shortest coincident.off --from 0 --to 1 --ways 1 --cut x.off)
  flip_geodesics_add_program_test(near_sources_of_parts 0 "0 curves" distance coincident_parts.off --source 0,3
                                  --voronoi)
  file(WRITE ${program_dir}/coincident_parts.off "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1e-16 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
                                                 "3 3 4 5\n")
  flip_geodesics_add_program_test(weight_of_point 0 "1 LOCALLY_SHORTEST" path torus.off --from 0,1,1e-300 --to 150)
  # The points of a curve on a mesh far from the origin lie in faces because of rounding errors only.
  file(WRITE ${program_dir}/far_from_origin.off
       "OFF\n9 8 0\n50000.13 450000.27 0\n50001.07 450000.11 0.31\n50002.19 450000.05 0\n50000.02 450001.23 0.17\n"
       "50001.11 450001.09 0.41\n50002.07 450001.16 0.08\n50000.21 450002.12 0\n50001.17 450002.31 0.22\n"
       "50002.03 450002.09 0\n3 0 1 4\n3 0 4 3\n3 1 2 5\n3 1 5 4\n3 3 4 7\n3 3 7 6\n3 4 5 8\n3 4 8 7\n")
  flip_geodesics_add_program_test(distant_curve 0 "1 LOCALLY_SHORTEST" path far_from_origin.off --from 2 --to 6 -o
                                  far_from_origin.polylines.txt)
  flip_geodesics_add_program_test(certify_distant 0 "locally shortest: 1 PROVEN" certify far_from_origin.off --draw
                                  far_from_origin.polylines.txt)
  set_tests_properties(program_certify_distant PROPERTIES DEPENDS program_distant_curve)
  file(WRITE ${program_dir}/thin_and_far.off
       "OFF\n9 8 0\n500000.274 5400000.13 0\n500001.31 5400000.27 0.31\n500002.19 5400000.05 0\n"
       "500000.22 5401000.23 0.17\n500001.11 5401000.09 0.41\n500002.07 5401000.16 0.08\n500000.21 5402000.12 0\n"
       "500001.17 5402000.31 0.22\n500002.03 5402000.09 0\n3 0 1 4\n3 0 4 3\n3 1 2 5\n3 1 5 4\n3 3 4 7\n3 3 7 6\n"
       "3 4 5 8\n3 4 8 7\n")
  flip_geodesics_add_program_test(thin_distant_curve 0 "1 LOCALLY_SHORTEST" path thin_and_far.off --from 0,1,0.51 --to
                                  7,8,0.77 -o thin_and_far.polylines.txt)
  flip_geodesics_add_program_test(certify_thin_distant 0 "locally shortest: 1 PROVEN" certify thin_and_far.off --draw
                                  thin_and_far.polylines.txt)
  set_tests_properties(program_certify_thin_distant PROPERTIES DEPENDS program_thin_distant_curve)
  foreach(format polylines.txt html json csv)
    flip_geodesics_add_program_test(tubes_in_${format} 2 "--tubes requires an .obj, .ply, .vtp or .glb file; use --output" path torus.off --from
                                    0 --to 150 --tubes 0.02 -o x.${format})
  endforeach()
  flip_geodesics_add_program_test(points 0 "2 LOCALLY_SHORTEST" path torus.off --points points.txt --polylines
                                  points.out)
  # Ends at vertices, in space, on an edge and in a face, with commas between them.
  file(WRITE ${program_dir}/pairs.csv "0,150\n1.5,0,0, -1.5,0,0.5\n0,1,0.25,1.5,0,0\n0,12,13,0.3,0.3,0,1,13,0.2,0.2\n")
  file(WRITE ${program_dir}/path.csv "0,1,2,14\n5, 6, 7\n")
  file(WRITE ${program_dir}/no_pair.csv "1.5,0,0,-1.5,0\n")
  flip_geodesics_add_program_test(ends_in_space 0 "1 LOCALLY_SHORTEST" path torus.off --from 1.5,0,0.1 --to=-1.5,0,0.5)
  flip_geodesics_add_program_test(ends_of_two_kinds 0 "1 LOCALLY_SHORTEST" path torus.off --from 0 --to 0,12,13,0.3,0.3)
  flip_geodesics_add_program_test(pairs_of_points 0 "0 +0 +150 .*4 LOCALLY_SHORTEST" path torus.off --pairs pairs.csv)
  flip_geodesics_add_program_test(edges_with_commas 0 "2 LOCALLY_SHORTEST" path torus.off --edges path.csv)
  flip_geodesics_add_program_test(no_pair 2 "no_pair.csv line 1: a pair consists of two points, not 1" path torus.off --pairs
                                  no_pair.csv)
  flip_geodesics_add_program_test(no_edge_but_space 2 "--to: '0,100,0.5' names .*for a point in space, write x or y with a decimal point"
                                  path torus.off --from 0 --to 0,100,0.5)
  # Coordinates are not read as numbers of vertices.
  file(WRITE ${program_dir}/coordinates.txt "20.0 8 10 8.0 20 3\n")
  file(WRITE ${program_dir}/closed_coordinates.txt "o 20.0 0 0 20.0 8 0 1 2 3\n")
  file(WRITE ${program_dir}/exponents.txt "2e1 8\n")
  set(no_vertex "is not the number of a vertex. write a whole number, counted from 0, or a point in space without blanks, as in 3.0,4,5")
  flip_geodesics_add_program_test(decimal_vertex 2 "--from: '20.0' ${no_vertex}" path torus.off --from 20.0 --to 150)
  flip_geodesics_add_program_test(decimal_target 2 "--to: '150.' ${no_vertex}" shortest torus.off --from 20 --to 150.)
  flip_geodesics_add_program_test(decimal_source 2 "--source: '20.0' ${no_vertex}" distance torus.off --source 20.0
                                  --spacing 0.3)
  flip_geodesics_add_program_test(decimal_vertex_of_trace 2 "--trace: '20.0' ${no_vertex}" trace torus.off --trace
                                  20.0,8,10)
  flip_geodesics_add_program_test(decimal_vertex_of_face 2 "--from: '12.0' ${no_vertex}" path torus.off --from
                                  0,12.0,13,0.3,0.3 --to 150)
  flip_geodesics_add_program_test(exponent_in_pair 2 "exponents.txt line 1: '2e1' ${no_vertex}" path torus.off --pairs
                                  exponents.txt)
  foreach(command "path --points coordinates" "spline --bezier coordinates" "distance --map x.csv --sources coordinates"
                  "path --draw closed_coordinates" "cut --cut x.off --draw closed_coordinates")
    separate_arguments(arguments UNIX_COMMAND "${command}.txt")
    list(POP_FRONT arguments name)
    list(GET arguments -2 option)
    flip_geodesics_add_program_test(coordinates_of_${name}_${option} 2 "coordinates.txt line 1: '20.0' ${no_vertex}" ${name}
                                    torus.off ${arguments})
  endforeach()
  flip_geodesics_add_program_test(ambiguous_point 2
                                  "--from: '0,1,0' is ambiguous. write 0.0,1.0,0 for a point in space, or 0 for the vertex"
                                  path torus.off --from 0,1,0 --to 150)
  flip_geodesics_add_program_test(ambiguous_source 2
                                  "--source: '0,1,1' is ambiguous. write 0.0,1.0,1 for a point in space, or 1 for the vertex"
                                  log torus.off --source 0,1,1)
  flip_geodesics_add_program_test(ambiguous_point_of_no_edge 2 "--trace: '500,0,1' is ambiguous. write 500.0,0.0,1 for" trace
                                  torus.off --trace 500,0,1,0.5,2)
  set(in_space "for a point in space, write x or y with a decimal point")
  flip_geodesics_add_program_test(point_beyond_edge 2 "--from: '20,8,1.5' is outside its edge. t must be .* at most 1. ${in_space}"
                                  path torus.off --from 20,8,1.5 --to 150)
  flip_geodesics_add_program_test(sources_as_vertices 0 "sources  3: vertex 1, vertex 2, vertex 0; distances confirmed"
                                  distance torus.off --source 1,2,0 --map sources.csv)
  file(WRITE ${program_dir}/nearly_flat.off "OFF\n5 4 0\n0 0 0\n2 0 0\n1 1e-12 0\n1 1 0\n1 -1 0\n3 0 1 2\n3 1 3 2\n3 3 0 2\n"
       "3 0 4 1\n")
  flip_geodesics_add_program_test(distances_not_confirmed 0 "sources  1: point 1.0,-0.5,0; distances not confirmed" distance
                                  nearly_flat.off --source 1.0,-0.5,0 --map nearly_flat.csv)
  flip_geodesics_add_program_test(whole_coordinates 2 "--from: '20,8,10' is ambiguous. write 20.0,8.0,10 for a point in space\n"
                                  path torus.off --from 20,8,10 --to 150)
  flip_geodesics_add_program_test(coordinates_beyond_vertices 2
                                  "--from: vertex 500 does not exist. use 0 to 287. ${in_space}" path torus.off --from
                                  500,0,0.5 --to 150)
  flip_geodesics_add_program_test(far_end 0 "1 point is not on the mesh, but at a distance of 1e.70 .--to" path torus.off
                                  --from 0 --to 1e70,0,0)
  flip_geodesics_add_program_test(shortest_tree_from_point 2 "--shortest requires a vertex as the source, and 0,12,0.3 is not one. omit"
                                  log torus.off --source 0,12,0.3 --shortest)
  flip_geodesics_add_program_test(shortest_tree_from_location_of_vertex 0 "shortest 287 paths, confirmed" log torus.off
                                  --source 0,12,0.0 --shortest)
  flip_geodesics_add_program_test(shortest_between_points 0 "1 WITHIN_ROUNDING\nlocally shortest: 1 PROVEN" shortest
                                  torus.off --from 0 --to 0.1,0.2,0.3 --cut shortest_cut.off)
  flip_geodesics_add_program_test(shortest_pairs_of_points 0 "4 WITHIN_ROUNDING" shortest torus.off --pairs pairs.csv
                                  --polylines shortest_points.out)
  flip_geodesics_add_program_test(shortest_between_locations_of_vertices 0 " 2.77034 " shortest torus.off --from 0,1,0.0
                                  --to 150)
  flip_geodesics_add_program_test(ways_between_points 0 "3 WITHIN_ROUNDING.*ways     3 of --from, --to, confirmed" shortest
                                  torus.off --from 13,14,0.5 --to 1.5,0,0.1 --ways 3)
  flip_geodesics_add_program_test(ways_between_points_past_hole 0 "2 WITHIN_ROUNDING" shortest torus.off --from
                                  13,14,0.5 --to 1.5,0,0.1 --ways 2 --avoid hole.txt)
  flip_geodesics_add_program_test(tree_from_point 0 "288 LOCALLY_SHORTEST.*paths +288 from the source" log torus.off
                                  --source 0,12,13,0.3,0.3 --map point_map.csv)
  flip_geodesics_add_program_test(trace_from_points 0 "from point 0,1,0.25 at 0.5\n.*3 LENGTH" trace torus.off --trace
                                  0,1,0.25,0.5,2 --trace 0,12,13,0.3,0.3,1,2 --trace 1.5,0,0,0,1)
  # Against the order of the vertices in the face.
  flip_geodesics_add_program_test(trace_from_reversed_points 0 "\n0 0 1 2 0.25[0-9]* 0.25[0-9]* .*\n1 0 1 2 0.(19999|2)[0-9]* 0.3" trace
                                  seam.obj --trace 1,0,0.5,4.71238898038469,0.25 --trace 1,0,2,0.3,0.3,0,0.2 --polylines -)
  file(WRITE ${program_dir}/sources.txt "5 100 # two vertices\n0,1,0.25\n")
  flip_geodesics_add_program_test(distance_map 0 "vertex,distance,source\n0,[^\n]*,2\n1," distance torus.off
                                  --sources sources.txt --map - --matrix matrix.csv --values -o distances.vtp -o
                                  distances.ply)
  flip_geodesics_add_program_test(distance_map_of_ply 0 "288 vertices" info distances.ply)
  set_tests_properties(program_distance_map_of_ply PROPERTIES DEPENDS program_distance_map)
  file(WRITE ${program_dir}/no_sources.txt "# no vertices\n")
  flip_geodesics_add_program_test(no_sources 2 "no_sources.txt: the file contains no points" distance torus.off
                                  --sources no_sources.txt --map -)
  file(WRITE ${program_dir}/repeated_point.txt "5 5 5\n")
  flip_geodesics_add_program_test(repeated_point 2 "line 1: a curve .* consecutive points that coincide count as one" path
                                  torus.off --draw repeated_point.txt)
  add_test(NAME program_distance_matrix COMMAND ${CMAKE_COMMAND} -E cat matrix.csv WORKING_DIRECTORY ${program_dir})
  set_tests_properties(program_distance_matrix PROPERTIES DEPENDS program_distance_map PASS_REGULAR_EXPRESSION
                       "^0,[^,]*,[^,]*\n[^,]*,0,[^,]*\n[^,]*,[^,]*,0\n$")
  flip_geodesics_add_program_test(distance_without_path 0 "\n1,1,0\n.*\n3,inf,\n4,inf,\n5,inf,\n" distance
                                  two_parts.off --source 0 --map -)
  flip_geodesics_add_program_test(values_alone 2 "--values requires --output" distance torus.off --source 0 --values)
  flip_geodesics_add_program_test(values_of_obj 2 "--values requires a .ply, .vtp or .json file; use --output" distance
                                  torus.off --source 0 --isolines 0.3 --values -o values.obj)
  flip_geodesics_add_program_test(values_in_json 0 "\"distances\":.0," distance torus.off --source 0 --values -o -
                                  --output-format json --quiet)
  flip_geodesics_add_program_test(sample 0 "3 LENGTH" trace torus.off --trace 0,0.5,2 --trace 0,0.5,0 --trace 7,1,0.25
                                  --sample 0.5 --polylines samples.txt)
  add_test(NAME program_samples COMMAND ${CMAKE_COMMAND} -E cat samples.txt WORKING_DIRECTORY ${program_dir})
  set_tests_properties(program_samples PROPERTIES DEPENDS program_sample PASS_REGULAR_EXPRESSION
                       "^(0 [^\n]*\n)(0 [^\n]*\n)(0 [^\n]*\n)(0 [^\n]*\n)(0 [^\n]*\n)1 [^\n]*\n1 [^\n]*\n2 [^\n]*\n2 [^\n]*\n$")
  flip_geodesics_add_program_test(sample_of_paths 0 "2 LOCALLY_SHORTEST" path torus.off --pairs pairs.txt --sample 0.1 -o
                                  samples.vtp)
  flip_geodesics_add_program_test(stop_curve_length 0 "4 curves: 2 LENGTH_LIMIT 2 LOCALLY_SHORTEST" network torus.off --network network.txt
                                  --stop-curve-length 0.99)
  flip_geodesics_add_program_test(distance_from_points 0 "between vertex 5 and point 0,1,0.25" distance torus.off --source
                                  5,100 --source 0,1,0.25 --source 1.5,0,0.1 --voronoi --isolines 0.2)
  flip_geodesics_add_program_test(crossing_bezier 0 "2 LOCALLY_SHORTEST" spline torus.off --bezier crossing_bezier.txt)
  flip_geodesics_add_program_test(crossing_page 0 "2 LOCALLY_SHORTEST" spline torus.off --bezier crossing_bezier.txt
                                  --page crossing.html)
  flip_geodesics_add_program_test(crossing_inserted 1 "line 1.*the curve crosses itself, which --draw, .*--insert, .*move its points" spline
                                  torus.off --bezier crossing_line.txt --insert crossing.off)
  flip_geodesics_add_program_test(crossing_snapped 1 "crossing_line.txt line 1.*cross at vertex [0-9]+; separate them" path
                                  torus.off --draw crossing_line.txt --snap)
  flip_geodesics_add_program_test(bezier 0 "2 LOCALLY_SHORTEST.*length  *[1-9][0-9.]* of [1-9]" spline torus.off
                                  --bezier bezier.txt --kernel certified)
  flip_geodesics_add_program_test(draw 0 "1 CONTRACTED 1 LOCALLY" path torus.off --draw drawn.txt --mesh
                                  drawn.polylines.txt)
  flip_geodesics_add_program_test(draw_snapped 0 "1 CONTRACTED 1 LOCALLY" path torus.off --draw drawn.txt --snap)
  flip_geodesics_add_program_test(draw_as_drawn 0 "2 curves: 2 DRAWN" cut torus.off --draw drawn.txt --cut drawn_cut.off
                                  --insert drawn_insert.off)
  flip_geodesics_add_program_test(as_drawn_snapped 2 "--snap is not an option of cut, but of path" cut torus.off --draw
                                  drawn.txt --snap)
  flip_geodesics_add_program_test(as_drawn_of_nothing 2 "--from is not an option of cut, but of path" cut torus.off
                                  --from 0 --to 1)
  flip_geodesics_add_program_test(draw_in_space 0 "LOCALLY_SHORTEST" path torus.off --draw pen.polylines.txt)
  flip_geodesics_add_program_test(draw_short 2 "short.polylines.txt line 1: point 2 is cut off" path torus.off --draw
                                  short.polylines.txt)
  flip_geodesics_add_program_test(points_outside 2 "is outside" path torus.off --points bad_points.txt)
  flip_geodesics_add_program_test(points_in_no_face 2 "do not form an edge or face" spline torus.off --bezier
                                  no_face.txt)
  flip_geodesics_add_program_test(reads_its_obj 0 LOCALLY_SHORTEST path path.obj --from 0 --to 150)
  set_tests_properties(program_reads_its_obj PROPERTIES DEPENDS program_path)
  flip_geodesics_add_program_test(not_repaired 2 "turned.off: the edge.*or use --repair" path turned.off --from 0 --to
                                  1)
  flip_geodesics_add_program_test(repair 0 "LOCALLY_SHORTEST.*repair: 1 polygon triangulated: more than three corners" path
                                  pyramid.off --repair --from 0 --to 2)
  flip_geodesics_add_program_test(repair_again 0 "11 vertices, 7 tri" path repaired.off --from 0 --to 2)
  set_tests_properties(program_repair_again PROPERTIES DEPENDS program_only_repaired)
  flip_geodesics_add_program_test(repair_merged 0 "0  *4 " path pyramid.off --repair --from 0 --to 5)
  flip_geodesics_add_program_test(repair_split 0 "vertex 0 was split by the repair into the vertices 0, 10; vertex 0 is used" path
                                  pyramid.off --repair --from 0 --to 2)
  flip_geodesics_add_program_test(repair_dropped 2 "vertex 7 has no faces after the repair" path pyramid.off --repair
                                  --from 0 --to 7)
  flip_geodesics_add_program_test(repair_edges 0 "1 LOCALLY_SHORTEST" path pyramid.off --repair --edges
                                  pyramid_edges.txt)
  flip_geodesics_add_program_test(repair_segmentation 0 "1 CONTRACTED" network pyramid.off --repair --segmentation
                                  pyramid.seg)
  flip_geodesics_add_program_test(repair_seams 0 "1 LOCALLY_SHORTEST" network quad_seam.obj --repair --seams)
  flip_geodesics_add_program_test(near_borders 1 "nearly coincide" path seam.off --repair --from 0 --to 5)
  flip_geodesics_add_program_test(welded_borders 0 "1 LOCALLY_SHORTEST" path seam.off --repair --weld 1e-12 --from 0
                                  --to 5)
  flip_geodesics_add_program_test(weld_alone 2 "--weld requires --repair" path seam.off --weld 1e-12 --from 0 --to 1)
  flip_geodesics_add_program_test(bad_weld 2 "--weld" path seam.off --repair --weld 2 --from 0 --to 1)
  flip_geodesics_add_program_test(repair_nothing_left 2 "collapsed.off: no triangle remains after the repair: 1 degenerate triangle"
                                  path collapsed.off --repair --from 0 --to 1)
  flip_geodesics_add_program_test(only_repaired 0 "11 vertices, 7 triangles.*repair: 1 polygon" repair pyramid.off
                                  --output repaired.off)
  flip_geodesics_add_program_test(output_format_of_curves 2 "x.off: the extension .*--output. use one of obj, ply, vtp, glb, polylines.txt, csv, html, json" path
                                  torus.off --from 0 --to 1 --output x.off)
  flip_geodesics_add_program_test(outputs 0 "1 curve" path torus.off --from 0 --to 150 -o several.obj -o several.glb -o
                                  several.json -o several.csv -o several.html --output several.polylines.txt)
  add_test(NAME program_outputs_exist
           COMMAND ${CMAKE_COMMAND} -E sha256sum several.obj several.glb several.json several.csv several.html
                   several.polylines.txt
           WORKING_DIRECTORY ${program_dir})
  set_tests_properties(program_outputs_exist PROPERTIES DEPENDS program_outputs)
  flip_geodesics_add_program_test(two_outputs_of_json 2 "another result has the format json" path torus.off --from 0 --to
                                  150 -o a.json -o b.json)
  flip_geodesics_add_program_test(json_to_standard_output 0 "^.\"command\":\"path\",\"curves\":.\n.\"curve\":0,.*\"status\":\"LOCALLY_SHORTEST\""
                                  path torus.off --from 0 --to 150 -o - --output-format json --quiet)
  flip_geodesics_add_program_test(bad_repaired 2 "x.xyz" repair torus.off --output x.xyz)
  flip_geodesics_add_program_test(loop 0 LOCALLY_SHORTEST loop torus.off --loop loop.txt)
  flip_geodesics_add_program_test(trivial_loop 0 CONTRACTED loop torus.off --loop trivial_loop.txt --mesh none.vtp)
  flip_geodesics_add_program_test(network 0 "4 LOCALLY_SHORTEST" network torus.off --network network.txt)
  flip_geodesics_add_program_test(joined_network 0 "2 LOCALLY_SHORTEST" network torus.off --network joined_network.txt)
  flip_geodesics_add_program_test(stop_length 0 LENGTH_LIMIT path torus.off --edges path.txt --stop-length 0.99)
  # A label for each of the 576 faces: three parts, of which two meet the third; and those of one part only.
  set(labels "")
  set(one_label "")
  foreach(face RANGE 575)
    math(EXPR label "${face} / 200")
    string(APPEND labels "${label}\n")
    string(APPEND one_label "5\n")
  endforeach()
  file(WRITE ${program_dir}/parts.seg "${labels}")
  file(WRITE ${program_dir}/one_part.seg "${one_label}")
  file(WRITE ${program_dir}/short.seg "0\n1\n")
  file(WRITE ${program_dir}/word.seg "0\none\n")
  # Two triangles that are textured apart, and two that are not.
  file(WRITE ${program_dir}/seam.obj "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 5\n"
                                     "f 1/1 2/2 3/3\nf 1/1 3/5 4/-2\n")
  file(WRITE ${program_dir}/no_seam.obj "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                        "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n")
  file(WRITE ${program_dir}/half_textured.obj
       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1 3 4\n")
  file(WRITE ${program_dir}/cube.off
       "OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n"
       "3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n")
  file(WRITE ${program_dir}/tetrahedron.off
       "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
  file(WRITE ${program_dir}/corners.txt "1 0 2 3\n! 0 2\n")
  flip_geodesics_add_program_test(loops 0 "2 curves: 2 LOCALLY_SHORTEST.*locally shortest: 2 PROVEN" loops torus.off --mesh
                                  loops.vtp --stats loops.csv)
  flip_geodesics_add_program_test(handles 0 "handle loop 0.*tunnel loop 0.*2 LOCALLY_SHORTEST" loops torus.off --handles)
  flip_geodesics_add_program_test(handles_of_disk 2 "does not bound a solid. omit --handles, or close" loops seam.obj --handles)
  flip_geodesics_add_program_test(no_loops 0 "0 curves" loops seam.obj)
  flip_geodesics_add_program_test(cut_graph 0 "LOCALLY_SHORTEST" loops torus.off --cut-graph --cut disk.off)
  flip_geodesics_add_program_test(cut_graph_cuts 0 "components  1\n[^\n]*genus 0, 1 border\n" info disk.off)
  set_tests_properties(program_cut_graph_cuts PROPERTIES DEPENDS program_cut_graph)
  flip_geodesics_add_program_test(info 0 "576 triangles, genus 1, 0 borders\ndefects     none" info torus.off)
  flip_geodesics_add_program_test(info_defects 0 "defects     found in the file; the numbers above describe the mesh after the repair:\n.*  repair: 1 polygon triangulated: more than three"
                                  info pyramid.off)
  flip_geodesics_add_program_test(info_welded 0 "components  1\n  0: 6 vertices, 4 triangles, genus 0, 1 border" info seam.off --weld 1e-12)
  flip_geodesics_add_program_test(info_near_borders 0 "nearly coincide with others and stay open" info seam.off)
  flip_geodesics_add_program_test(info_short_edges 0 "length 1e-170 to .*\n  3 edges have lengths outside the range from 1e-70 to 1e70" info
                                  tiny.off)
  file(WRITE ${program_dir}/giant.off "OFF\n3 1 0\n0 0 0\n1e300 0 0\n0 1e300 0\n3 0 1 2\n")
  flip_geodesics_add_program_test(info_long_edges 0 "length 1e.300 to 1.41421e.300;.*\n  3 edges have lengths outside" info
                                  giant.off)
  flip_geodesics_add_program_test(info_json 0 "\"components\":.{\"vertices\":288,.*\"genus\":1}.*\"defects\":" info
                                  torus.off --quiet --json -)
  flip_geodesics_add_program_test(certify_written 0 "2 LOCALLY_SHORTEST" path torus.off --pairs pairs.txt --mesh
                                  certified.polylines.txt)
  flip_geodesics_add_program_test(certify 0 "2 GIVEN\nlocally shortest: 2 PROVEN" certify torus.off --draw
                                  certified.polylines.txt)
  set_tests_properties(program_certify PROPERTIES DEPENDS program_certify_written)
  flip_geodesics_add_program_test(certify_bent 1 "path.txt line 1.: the curve is not locally shortest: BENT_JOINT at point"
                                  certify torus.off --draw path.txt --stats bent.csv)
  flip_geodesics_add_program_test(certify_gap 1 "gap.txt line 2.: " certify torus.off --draw gap.txt)
  file(WRITE ${program_dir}/twice.polylines.txt "6 1 0 0 1 0 0 0.5 0.5 0 0.5 0.5 0 0.5 0.5 0 0 1 0\n")
  flip_geodesics_add_program_test(certify_coincident_points 0 "locally shortest: 1 PROVEN" certify no_seam.obj --draw
                                  twice.polylines.txt)
  # Points that differ by rounding errors are projected to one vertex.
  file(WRITE ${program_dir}/nearly_twice.polylines.txt "4 1 0 0 0.5 0.5 0 0 1 0 1e-17 1 0\n")
  flip_geodesics_add_program_test(certify_nearly_coincident_points 0 "locally shortest: 1 PROVEN" certify no_seam.obj --draw
                                  nearly_twice.polylines.txt)
  # The loop passes a vertex at a distance of 1e-17.
  add_test(NAME program_small_torus COMMAND generate_torus small_torus.off 6 3 WORKING_DIRECTORY ${program_dir})
  flip_geodesics_add_program_test(certify_loops_written 0 "2 LOCALLY_SHORTEST" loops small_torus.off -o
                                  loops.polylines.txt)
  set_tests_properties(program_certify_loops_written PROPERTIES DEPENDS program_small_torus)
  flip_geodesics_add_program_test(certify_loops 0 "locally shortest: 1 PROVEN 1 STRAIGHT_WITHIN_ROUNDING" certify small_torus.off
                                  --draw loops.polylines.txt)
  set_tests_properties(program_certify_loops PROPERTIES DEPENDS program_certify_loops_written)
  # The first segment is bent by 1.6e-12 radians, and the curve turns at its end.
  file(WRITE ${program_dir}/corner.off "OFF\n5 4 0\n0 0 0\n1 0.500000000001 0\n2 1 0\n1 2 0\n1 -2 0\n3 0 1 3\n3 1 2 3\n3 0 4 1\n"
       "3 4 2 1\n")
  file(WRITE ${program_dir}/corner.txt "0 1,3,0.1 2 3\n")
  flip_geodesics_add_program_test(certify_corner 1 "BENT_JOINT at point 2, with a bend of 1.89255 radians" certify
                                  corner.off --draw corner.txt)
  file(WRITE ${program_dir}/closed.polylines.txt "5 0 0 0 1 0 0 1 1 0 0 1 0 0 0 0\n")
  flip_geodesics_add_program_test(certify_closed 1 "BENT_JOINT at point 0, .*where the closed curve begins and ends"
                                  certify no_seam.obj --draw closed.polylines.txt)
  file(WRITE ${program_dir}/collinear.off "OFF\n6 6 0\n0 0 0\n1 0 0\n2 0 0\n1 1 0\n1 -1 0\n1 2 0.5\n"
                                          "3 0 1 3\n3 1 2 3\n3 0 2 1\n3 0 4 2\n3 3 5 0\n3 3 2 5\n")
  file(WRITE ${program_dir}/collinear.polylines.txt "4 1 1 0 1 0 0 1 0 0 1 -1 0\n")
  flip_geodesics_add_program_test(certify_degenerate_faces 1 "sides of degenerate faces are crossed, so repair the mesh"
                                  certify collinear.off --draw collinear.polylines.txt)
  flip_geodesics_add_program_test(points_off_the_mesh 0 "3 points are not on the mesh, but at a distance of up to 3 .off_surface.polylines.txt line 1"
                                  path no_seam.obj --draw off_surface.polylines.txt)
  file(WRITE ${program_dir}/off_surface.polylines.txt "3 0 0 1 1 0 2 1 1 3\n")
  flip_geodesics_add_program_test(point_off_the_mesh 0 "1 point is not on the mesh, but at a distance of 0.5 .--to" path
                                  no_seam.obj --from 0 --to 1.0,1.0,0.5)
  flip_geodesics_add_program_test(output_format_with_extension 0 "^2 0 0 0 1 1 0\n$" path no_seam.obj --from 0 --to 2 -o -
                                  --output-format .polylines.txt --quiet)
  flip_geodesics_add_program_test(format_of_result 2 "not known as an input format.*; for a result, use --output-format" path
                                  torus.off --from 0 --to 2 -o x.obj --format polylines.txt)
  flip_geodesics_add_program_test(format_on_standard_output 2 "standard output, and --format that of the mesh; use one of obj"
                                  path torus.off --from 0 --to 2 -o - --format off)
  flip_geodesics_add_program_test(trace_limit 0 "at most 1000000 edges" trace --help)
  if(TARGET CGAL::Eigen3_support)
    flip_geodesics_add_program_test(flatten 0 "cuts?. .*flattened in .* steps" flatten torus.off --output flat.obj)
    flip_geodesics_add_program_test(flatten_limit 2 "^flip_geodesics: the subdivided mesh would have [^\n]*but at most 100 are allowed[^\n]*--vertex-limit\n$"
                                    flatten torus.off --vertex-limit 100 --output x.obj --quiet)
    flip_geodesics_add_program_test(flatten_disk 0 "0 cuts.*flattened" flatten seam.obj --output flat.glb)
    # Finer faces are needed at corners.
    flip_geodesics_add_program_test(flatten_cube 0 "1 cut. .*flattened in" flatten cube.off --output flat_cube.obj)
    flip_geodesics_add_program_test(flatten_tetrahedron 0 "1 cut. .*flattened in" flatten tetrahedron.off
                                    --output flat_corners.obj)
    # At the tip of a spike, scale factors are below the precision of coordinates: the cut graph is extended to it.
    file(WRITE ${program_dir}/spike.off "OFF\n5 4 0\n0 0 60\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n"
                                        "3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 1\n")
    flip_geodesics_add_program_test(flatten_spike 0 "1 cut. .*flattened in" flatten spike.off --output flat_spike.obj)
    file(WRITE ${program_dir}/base.txt "1 2\n")
    # The cut must reach the apex; the other corners of the faces there are on the border.
    file(WRITE ${program_dir}/steep.off "OFF\n5 4 0\n0 0 10\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n"
                                        "3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 1\n")
    flip_geodesics_add_program_test(flatten_steep 0 "1 cut. .*flattened in" flatten steep.off --output flat_steep.obj)
    flip_geodesics_add_program_test(flatten_uncut_spike 2
                                    "lengths at vertex 0 would be multiplied by about 1e-.*extend the cut to this vertex"
                                    flatten spike.off --network base.txt --output x.obj)
    flip_geodesics_add_program_test(flatten_through_corners 0 "1 cut. 4 vertices, flattened in" flatten tetrahedron.off
                                    --network corners.txt --output flat_tetrahedron.obj)
    flip_geodesics_add_program_test(flatten_pieces 2 "quad_seam.obj: the mesh cannot be flattened because the cut surface is not connected" flatten
                                    quad_seam.obj --repair --seams --output x.obj)
    flip_geodesics_add_program_test(flatten_components 2 "two_parts.off: the mesh cannot be flattened because it has 2 components"
                                    flatten two_parts.off --output x.obj)
    flip_geodesics_add_program_test(flatten_no_disk 2 "cannot be flattened because the cut surface is not a disk" flatten torus.off
                                    --network joined_network.txt --output x.obj)
    # Corners of one vertex have the same texture coordinates on one side of the cut.
    flip_geodesics_add_program_test(flatten_cut_torus 0 "0 cuts.*flattened" flatten disk.off --output flat_disk.obj)
    set_tests_properties(program_flatten_cut_torus PROPERTIES DEPENDS program_cut_graph)
    flip_geodesics_add_program_test(flattened_has_no_seams 2 "flat_disk.obj: the texture has no seam inside" network
                                    flat_disk.obj --seams)
    set_tests_properties(program_flattened_has_no_seams PROPERTIES DEPENDS program_flatten_cut_torus)
    # Faces of size 1e-20, with texture coordinates near 1, are rounded to points, which is not a defect.
    file(WRITE ${program_dir}/tiny_faces.off
         "OFF\n6 4 0\n0 0 0\n1e-20 0 0\n0 1e-20 0\n1 1 0\n0 1 0\n5 5 0\n3 0 1 2\n3 1 3 2\n3 3 4 2\n3 3 5 4\n")
    flip_geodesics_add_program_test(flatten_tiny_faces 0 "0 cuts.*flattened in" flatten tiny_faces.off --output
                                    flat_tiny_faces.obj)
  endif()
  flip_geodesics_add_program_test(flatten_format 2 "x.ply: the extension .*--output. use one of obj, glb, json" flatten
                                  torus.off --output x.ply)
  flip_geodesics_add_program_test(segmentation 0 "LOCALLY_SHORTEST" network torus.off --segmentation parts.seg)
  flip_geodesics_add_program_test(segmentation_stop 0 "LENGTH_LIMIT" network torus.off --segmentation parts.seg
                                  --stop-length 0.97)
  flip_geodesics_add_program_test(segmentation_free 0 "curves: " network torus.off --segmentation parts.seg
                                  --free-junctions)
  flip_geodesics_add_program_test(one_part 2 "one_part.seg: no edge separates faces" network torus.off --segmentation one_part.seg)
  flip_geodesics_add_program_test(too_few_labels 2 "2 labels for 576" network torus.off --segmentation short.seg)
  flip_geodesics_add_program_test(label_no_number 2 "label 1, 'one'" network torus.off --segmentation word.seg)
  flip_geodesics_add_program_test(no_labels 2 "missing.seg" network torus.off --segmentation missing.seg)
  flip_geodesics_add_program_test(free_without_segmentation 2 "--free-junctions requires --segmentation" network
                                  torus.off --free-junctions)
  flip_geodesics_add_program_test(seams 0 "1 LOCALLY_SHORTEST" network seam.obj --seams)
  flip_geodesics_add_program_test(no_seams 2 "no seam" network no_seam.obj --seams)
  flip_geodesics_add_program_test(untextured_face 2 "line 9: face 1 has a corner" network half_textured.obj --seams)
  flip_geodesics_add_program_test(seams_of_off 2 "obj file" network torus.off --seams)
  flip_geodesics_add_program_test(tree 0 "287 LOCALLY_SHORTEST.*paths +287 from vertex 5, the longest to vertex" log
                                  torus.off --source 5 --map map.csv --mesh tree.ply)
  flip_geodesics_add_program_test(shortest_tree 0 "287 LOCALLY_SHORTEST.*shortest 287 paths, confirmed" log torus.off
                                  --source 5 --shortest --kernel certified)
  flip_geodesics_add_program_test(source_out_of_range 2 "vertex 288" log torus.off --source 288)
  flip_geodesics_add_program_test(isolines 0 "ISOLINE +at distance 0.3\n.*9 curves: 3 BOUNDARY 6 ISOLINE" distance
                                  torus.off --source 0,100,200 --isolines 0.3,0.6 --voronoi --mesh isolines.vtp
                                  --polylines isolines.txt --tolerance 0.01)
  flip_geodesics_add_program_test(cut_along_isolines 0 "9 curves: 3 BOUNDARY 6 ISOLINE" distance torus.off --source
                                  0,100,200 --isolines 0.3,0.6 --voronoi --tolerance 0.01 --cut isolines_cut.off
                                  --insert isolines_insert.off)
  flip_geodesics_add_program_test(cut_along_isolines_is_open 0 "the distance of the farthest vertex is 0.3; use" distance
                                  isolines_cut.off --source 0 --isolines 99)
  set_tests_properties(program_cut_along_isolines_is_open PROPERTIES DEPENDS program_cut_along_isolines)
  flip_geodesics_add_program_test(trace 0 "LENGTH +from vertex 0 at 0.5\n.*2 curves: 2 LENGTH" trace torus.off --trace
                                  0,0.5,2 --trace 7,-1e-1,3 --polylines traces.txt --stats traces.csv --mesh traces.vtp)
  flip_geodesics_add_program_test(trace_without_length 2 "specify a point, an angle and a length" trace torus.off --trace
                                  0,1)
  flip_geodesics_add_program_test(trace_no_number 2 "specify a point, an angle and a length" trace torus.off --trace
                                  0,a,1)
  flip_geodesics_add_program_test(trace_too_much 2 "'0,1' is not a point" trace torus.off --trace
                                  0,1,2,3)
  flip_geodesics_add_program_test(trace_negative 2 "must not be negative" trace torus.off --trace 0,1,-2)
  flip_geodesics_add_program_test(trace_of_no_vertex 2 "--trace: vertex 288 does not exist" trace torus.off --trace
                                  288,0,1)
  flip_geodesics_add_program_test(trace_and_random 2 "--random is not an option of trace, but of path" trace torus.off
                                  --trace 0,0,1 --random 3)
  # Walls along meridians, which open the torus, and all of its faces.
  set(meridian "0 1 2 3 4 5 6 7 8 9 10 11 0\n")
  file(WRITE ${program_dir}/wall.txt "# a meridian\n${meridian}")
  file(WRITE ${program_dir}/two_walls.txt "${meridian}144 145 146 147 148 149 150 151 152 153 154 155 144\n")
  file(WRITE ${program_dir}/hole.txt "f 300 301\nf400")
  set(all_faces "f")
  foreach(face RANGE 575)
    string(APPEND all_faces " ${face}")
  endforeach()
  file(WRITE ${program_dir}/all_faces.txt "${all_faces}\n")
  file(WRITE ${program_dir}/no_faces.txt "f\n")
  file(WRITE ${program_dir}/face_beyond.txt "f 5 576\n")
  file(WRITE ${program_dir}/face_word.txt "f 5 x\n")
  set(pair_beside_wall torus.off --from 13 --to 270)
  flip_geodesics_add_program_test(ways 0 "4 curves: 4 WITHIN_ROUNDING.*ways     4 from 13 to 150, confirmed. the paths of all other"
                                  shortest torus.off --from 13 --to 150 --ways 4 --mesh ways.vtp --stats ways.csv)
  flip_geodesics_add_program_test(ways_of_pairs 0 "4 curves: 4 WITHIN_ROUNDING.*from 0 to 150.*from 3 to 77" shortest
                                  torus.off --pairs pairs.txt --ways 2 --page ways.html)
  flip_geodesics_add_program_test(ways_at_random 0 "6 curves: 6 WITHIN_ROUNDING" shortest torus.off --random 3 --seed 2
                                  --ways 2)
  flip_geodesics_add_program_test(no_other_ways 0 "1 curve: 1 WITHIN_ROUNDING.*no other class exists" shortest pyramid.off
                                  --repair --from 0 --to 2 --ways 3)
  flip_geodesics_add_program_test(ways_along_wall 0 "2 WITHIN_ROUNDING.*length   8.46715 of.*flips    52" shortest
                                  ${pair_beside_wall} --ways 2 --avoid wall.txt)
  flip_geodesics_add_program_test(ways_past_hole 0 "5 WITHIN_ROUNDING" shortest torus.off --from 13 --to 150 --ways 5
                                  --avoid hole.txt)
  flip_geodesics_add_program_test(ways_walled_off 1 "from, --to.*: no path connects the two ends"
                                  shortest ${pair_beside_wall} --ways 2 --avoid two_walls.txt)
  flip_geodesics_add_program_test(ways_from_wall 1 "vertex 3 lies on a barrier of --avoid" shortest torus.off --from 3 --to
                                  150 --ways 2 --avoid wall.txt)
  flip_geodesics_add_program_test(ways_inside_obstacle 1 "vertex 13 lies inside an obstacle" shortest
                                  ${pair_beside_wall} --ways 2 --avoid all_faces.txt)
  flip_geodesics_add_program_test(ways_given_up 1 "the search reached the memory limit after .* vertices of the universal cover" shortest
                                  torus.off --from 13 --to 150 --ways 30 --memory-limit 0.1)
  flip_geodesics_add_program_test(no_ways 2 "--ways: '0' is out of range. use at least 1" shortest torus.off --from 0
                                  --to 1 --ways 0)
  flip_geodesics_add_program_test(ways_double 2 "--ways and --kernel cannot be combined" shortest torus.off --random 2
                                  --ways 2 --kernel double)
  flip_geodesics_add_program_test(avoid_alone 0 "1 curve: 1 WITHIN_ROUNDING" shortest torus.off --from 13 --to 150
                                  --avoid hole.txt)
  flip_geodesics_add_program_test(avoid_gap 2 "gap.txt line 2.*1 and 5" shortest torus.off --random 1 --ways 2 --avoid
                                  gap.txt)
  flip_geodesics_add_program_test(avoid_nothing 2 "no_curve.txt: the file has no obstacles" shortest torus.off --random 1
                                  --ways 2 --avoid no_curve.txt)
  flip_geodesics_add_program_test(avoid_no_faces 2 "no_faces.txt line 1: the line has no faces" shortest torus.off --random 1
                                  --ways 2 --avoid no_faces.txt)
  flip_geodesics_add_program_test(avoid_face_beyond 2 "face_beyond.txt line 1: face 576 does not exist. use 0 to 575"
                                  shortest torus.off --random 1 --ways 2 --avoid face_beyond.txt)
  flip_geodesics_add_program_test(avoid_word 2 "face_word.txt line 1: 'x' is not a whole number" shortest torus.off
                                  --random 1 --ways 2 --avoid face_word.txt)
  # Obstacles of distances and traces, and weights.
  flip_geodesics_add_program_test(distance_walled_off 0 "no isoline at distance 9: the distance of the farthest vertex is [0-9.]+; use"
                                  distance torus.off --source 13 --isolines 9 --avoid two_walls.txt)
  flip_geodesics_add_program_test(distance_from_wall 2 "^flip_geodesics: vertex 3 lies on a barrier of --avoid, or where obstacles meet"
                                  distance torus.off --source 3 --map x.csv --avoid wall.txt)
  flip_geodesics_add_program_test(distance_inside_obstacle 2
                                  "point 1.0,2.0,0.3 lies inside an obstacle of --avoid; choose another point" distance
                                  torus.off --source 1.0,2.0,0.3 --map x.csv --avoid all_faces.txt --quiet)
  flip_geodesics_add_program_test(trace_from_wall 2 "vertex 3 lies on a barrier" trace torus.off --trace 3,0,1 --avoid
                                  wall.txt)
  flip_geodesics_add_program_test(trace_to_wall 0 "1 BORDER" trace torus.off --trace 13,3,9 --avoid wall.txt)
  flip_geodesics_add_program_test(log_avoid 2 "--avoid is not an option of log, but of shortest, trace and distance. see" log torus.off --source 0
                                  --avoid wall.txt)
  file(WRITE ${program_dir}/weights.csv "0, 3\n1,3 # heavy\n575 0.5\n")
  file(WRITE ${program_dir}/edge_weights.csv "0,1,0.5\n1 2 0.5\n")
  file(WRITE ${program_dir}/too_few_weights.txt "1\n2\n")
  file(WRITE ${program_dir}/no_weight.csv "0,3\n1,0\n")
  file(WRITE ${program_dir}/word_weight.csv "face,weight\n1,2\n")
  file(WRITE ${program_dir}/weight_beyond.csv "576,2\n")
  file(WRITE ${program_dir}/mixed_weights.csv "0,2\n3\n")
  file(WRITE ${program_dir}/no_edge.csv "0,1,2\n1,5,2\n")
  file(WRITE ${program_dir}/short_edge.csv "0,1\n")
  file(WRITE ${program_dir}/spoilt.csv "0,1,50\n")
  foreach(command "path --from 0 --to 150" "loop --loop loop.txt" "network --network network.txt" "spline --bezier bezier.txt"
                  "shortest --from 0 --to 1.0,2.0,0.3" "log --source 0" "distance --source 0 --spacing 0.4" "trace --trace 0,1,2")
    separate_arguments(arguments UNIX_COMMAND "${command}")
    list(POP_FRONT arguments name)
    flip_geodesics_add_program_test(${name}_of_weights 0 "curves?: " ${name} torus.off ${arguments} --face-weights
                                    weights.csv)
    flip_geodesics_add_program_test(${name}_of_edge_weights 0 "curves?: " ${name} torus.off ${arguments} --edge-weights
                                    edge_weights.csv)
    flip_geodesics_add_program_test(${name}_of_spoilt_weights 2
                                    "spoilt.csv: with these weights, the sides of the face with vertices [0-9]+, [0-9]+ and" ${name}
                                    torus.off ${arguments} --edge-weights spoilt.csv)
  endforeach()
  flip_geodesics_add_program_test(mollified_weights 0 "added to the length of every edge.*locally shortest: 1 PROVEN" path
                                  torus.off --from 0 --to 150 --edge-weights spoilt.csv --mollify 1e-5)
  flip_geodesics_add_program_test(mollified_distances 0 "0 curves" distance torus.off --source 0 --map mollified.csv
                                  --edge-weights spoilt.csv --mollify 1e-5)
  flip_geodesics_add_program_test(weights_in_double 2 "--kernel and --face-weights cannot be combined" path torus.off
                                  --from 0 --to 150 --face-weights weights.csv --kernel double)
  flip_geodesics_add_program_test(repaired_weights 0 "1 LOCALLY_SHORTEST" path pyramid.off --repair --from 0 --to 2
                                  --face-weights edge_weights_of_pyramid.csv)
  file(WRITE ${program_dir}/edge_weights_of_pyramid.csv "0,2\n")
  flip_geodesics_add_program_test(weights_of_nothing 2 "too_few_weights.txt: the file has 2 weights for 576 faces" path
                                  torus.off --from 0 --to 150 --face-weights too_few_weights.txt)
  flip_geodesics_add_program_test(weight_of_zero 2 "no_weight.csv line 2: the weight of face 1 is 0. give a positive" path
                                  torus.off --from 0 --to 150 --face-weights no_weight.csv)
  flip_geodesics_add_program_test(weight_of_word 2 "word_weight.csv line 1: 'face' is not a whole number" distance
                                  torus.off --source 0 --map x.csv --face-weights word_weight.csv)
  flip_geodesics_add_program_test(weight_beyond 2 "weight_beyond.csv line 1: face 576 does not exist. use 0 to 575" path
                                  torus.off --from 0 --to 150 --face-weights weight_beyond.csv)
  file(WRITE ${program_dir}/repeated_face.csv "0,2\n5,3\n0,2\n")
  flip_geodesics_add_program_test(weight_of_face_repeated 2 "repeated_face.csv line 3: face 0 is given two weights" path
                                  torus.off --from 0 --to 150 --face-weights repeated_face.csv)
  file(WRITE ${program_dir}/repeated_edge.csv "0,1,0.5\n1,0,0.7\n")
  flip_geodesics_add_program_test(weight_of_edge_repeated 2
                                  "repeated_edge.csv line 2: the edge between vertices 1 and 0 is given two weights" path
                                  torus.off --from 0 --to 150 --edge-weights repeated_edge.csv)
  flip_geodesics_add_program_test(weights_mixed 2 "mixed_weights.csv line 2: the line has 1 item. write either one weight" path torus.off --from 0
                                  --to 150 --face-weights mixed_weights.csv)
  flip_geodesics_add_program_test(weight_of_no_edge 2 "no_edge.csv line 2: no edge connects vertices 1 and 5. correct the line" path torus.off
                                  --from 0 --to 150 --edge-weights no_edge.csv)
  flip_geodesics_add_program_test(weight_missing 2 "short_edge.csv line 1: the line has 2 items. write two vertices" path
                                  torus.off --from 0 --to 150 --edge-weights short_edge.csv)
  flip_geodesics_add_program_test(weights_empty 2 "no_curve.txt: the file has no weights" path torus.off --from 0 --to
                                  150 --edge-weights no_curve.txt)
  flip_geodesics_add_program_test(weights_absent 2 "missing.csv: cannot be opened" trace torus.off --trace 0,0,1
                                  --face-weights missing.csv)
  flip_geodesics_add_program_test(weights_twice 2 "--face-weights and --edge-weights cannot be combined" path torus.off
                                  --from 0 --to 150 --edge-weights edge_weights.csv --face-weights weights.csv)
  flip_geodesics_add_program_test(weights_of_ways 2 "--ways and --face-weights cannot be combined" shortest torus.off
                                  --from 0 --to 150 --ways 2 --face-weights weights.csv)
  flip_geodesics_add_program_test(weights_of_loops 2 "--face-weights is not an option of loops, but of path" loops
                                  torus.off --face-weights weights.csv)
  flip_geodesics_add_program_test(trace_certified 2 "--kernel is not an option of trace" trace torus.off --trace 0,0,1
                                  --kernel certified)
  flip_geodesics_add_program_test(far_isoline 0
                                  "0 curves.*no isoline at distance 99: the distance of the farthest vertex is [0-9.]+; use" distance
                                  torus.off --source 0 --isolines 99)
  flip_geodesics_add_program_test(near_isoline 0 "1 curve: 1 ISOLINE" distance torus.off --source 0 --isolines 1e-9)
  flip_geodesics_add_program_test(isoline_at_source 2 "--isolines: '0' is out of range. use more than 0" distance
                                  torus.off --source 0 --isolines 0.3,0)
  flip_geodesics_add_program_test(spacing 0 "curves: [1-9][0-9]* ISOLINE" distance torus.off --source 0,100 --spacing
                                  0.3 --mesh spacing.vtp)
  flip_geodesics_add_program_test(spacing_too_large 0 "0 curves.*no isoline at a multiple of --spacing" distance
                                  torus.off --source 0 --spacing 99)
  flip_geodesics_add_program_test(spacing_too_small 2 "--spacing 1e-09 results in more than 10000 isolines" distance
                                  torus.off --source 0 --spacing 1e-9)
  flip_geodesics_add_program_test(spacing_zero 2 "--spacing: '0' is out of range. use more than 0" distance torus.off
                                  --source 0 --spacing 0)
  flip_geodesics_add_program_test(voronoi_of_one_source 0 "0 curves.*no boundary: there is only one source" distance
                                  torus.off --source 0 --voronoi)
  flip_geodesics_add_program_test(voronoi_of_near_sources 2 "between vertex 0 and point 0,1,1e-14 is below the rounding errors"
                                  distance torus.off --source 0 --source 0,1,1e-14 --voronoi)
  flip_geodesics_add_program_test(voronoi_of_one_point_twice 2 "is below the rounding errors" distance torus.off --source
                                  0,12,13,0.2,0.3 --source 12,13,0,0.3,0.5 --voronoi)
  flip_geodesics_add_program_test(voronoi_of_one_place 0 "no boundary: in each component, all points have the" distance
                                  torus.off --source 0,0 --voronoi)
  flip_geodesics_add_program_test(json_named_as_mesh 2 "--json writes lines of text. use a name that ends in .json" path
                                  torus.off --from 0 --to 1 --json x.obj)
  flip_geodesics_add_program_test(value_missing 2 "--to requires a value" path torus.off --from 0 --to)
  flip_geodesics_add_program_test(spacing_and_isolines 2 "--isolines and --spacing cannot be combined" distance
                                  torus.off --source 0 --spacing 1 --isolines 1)
  flip_geodesics_add_program_test(isoline_no_number 2 "--isolines: 'nan' is not a finite number" distance torus.off
                                  --source 0 --isolines 1,nan --mesh no_isolines.vtp)
  flip_geodesics_add_program_test(negative_isoline 2 "--isolines: '-2' is out of range" distance torus.off --source 0
                                  --isolines 1,-2)
  flip_geodesics_add_program_test(left_out_isoline 2 "--isolines: '' is not a number" distance torus.off --source 0
                                  --isolines 0.1,,0.2)
  flip_geodesics_add_program_test(left_out_last_isoline 2 "--isolines: '0.1,' ends with a comma" distance torus.off
                                  --source 0 --isolines 0.1,)
  flip_geodesics_add_program_test(left_out_source 2 "--source: '' is not a point" distance torus.off --source 0,,1
                                  --isolines 1)
  flip_geodesics_add_program_test(source_too_large 2 "--source: '99999999999999999999' is not the number of a vertex. write a whole number" distance torus.off
                                  --source 0,99999999999999999999 --isolines 1)
  flip_geodesics_add_program_test(vertex_too_large 2 "--from: '99999999999999999999' is not the number of a vertex. write a whole number" path
                                  torus.off --from 99999999999999999999 --to 3)
  flip_geodesics_add_program_test(seed_too_large 2 "--seed: '99999999999999999999' is out of range" path torus.off
                                  --random 1 --seed 99999999999999999999)
  flip_geodesics_add_program_test(spacing_too_long 2 "--spacing: '1e999' is out of range" distance torus.off
                                  --source 0 --spacing 1e999)
  flip_geodesics_add_program_test(edges_too_short 2 "--longest-edge: '1e-300' is out of range. use at least 1e-70"
                                  refine torus.off --from 0 --to 9 --refine 20 --longest-edge 1e-300 --subdivision
                                  refined.off)
  # Decimal everywhere, as in files; finite; and the option is named.
  flip_geodesics_add_program_test(leading_zero 0 "0  *10  *150  .*1 LOCALLY_SHORTEST" path torus.off --from 010 --to
                                  0150)
  flip_geodesics_add_program_test(leading_zeros 0 "from vertex 10 .*from vertex 9 .*from vertex 10 .*3 curves" trace
                                  torus.off --trace 010,00.5,01 --trace 9,0,1 --trace +10,1,1)
  flip_geodesics_add_program_test(zeros_in_file 0 "0  *0  *150  .*1  *10  *77  .*2 LOCALLY_SHORTEST" path torus.off
                                  --pairs zeros.txt)
  flip_geodesics_add_program_test(hexadecimal_file 2 "hexadecimal.txt line 1: '0x1' is not a point" path torus.off
                                  --pairs hexadecimal.txt)
  flip_geodesics_add_program_test(zeros_in_limits 0 "8 LOCALLY_SHORTEST" path torus.off --random 08 --seed 09)
  flip_geodesics_add_program_test(hexadecimal 2 "--to: '0x1' is not a point. write `v` for a vertex" path torus.off --from 0 --to
                                  0x1)
  flip_geodesics_add_program_test(hexadecimal_rounds 2 "--rounds: '0x1' is not a whole number" spline torus.off --bezier
                                  bezier.txt --rounds 0x1)
  flip_geodesics_add_program_test(hexadecimal_trace 2 "--trace: .0x1. is not a point" trace torus.off --trace 0x1,0,1)
  flip_geodesics_add_program_test(blank_number 2 "--from: ' 1' is not a point" path torus.off "--from= 1" --to 0)
  flip_geodesics_add_program_test(isoline_infinite 2 "--isolines: 'inf' is not a finite number" distance torus.off
                                  --source 0 --isolines inf)
  flip_geodesics_add_program_test(tolerance_infinite 2 "--tolerance: 'inf' is not a finite number" distance torus.off
                                  --source 0 --isolines 1 --tolerance inf)
  flip_geodesics_add_program_test(spacing_infinite 2 "--spacing: 'inf' is not a finite number" distance torus.off
                                  --source 0 --spacing inf)
  flip_geodesics_add_program_test(no_angle 2 "--refine: 'nan' is not a finite number" refine torus.off --from 0 --to 9
                                  --refine nan --subdivision refined.off)
  flip_geodesics_add_program_test(isoline_next_to_the_source 0 "1 curve: 1 ISOLINE" distance torus.off --source 0
                                  --isolines 1e-150)
  flip_geodesics_add_program_test(isolines_of_nothing 2 "the command distance requires one of the options --source or --sources" distance torus.off --isolines 1)
  flip_geodesics_add_program_test(isolines_of_no_vertex 2 "vertex 288" distance torus.off --source 0,288 --isolines 1)
  flip_geodesics_add_program_test(isolines_and_tree 2 "--shortest is not an option of distance, but of log" distance
                                  torus.off --source 0 --isolines 1 --shortest)
  flip_geodesics_add_program_test(tree_of_two 2 "--source: '0,1' is not a point" log torus.off --source 0,1)
  flip_geodesics_add_program_test(bad_tolerance 2 "--tolerance" distance torus.off --source 0 --voronoi --tolerance 0)
  flip_geodesics_add_program_test(tolerance_too_small 2 "--tolerance 1e-300 is less than a millionth" distance torus.off
                                  --source 0 --voronoi --tolerance 1e-300)
  flip_geodesics_add_program_test(tolerance_of_nothing 2 "requires one of the options --isolines, --spacing, --voronoi" distance
                                  torus.off --source 0 --tolerance 0.1)
  flip_geodesics_add_program_test(map_without_source 2 "--source is required" log torus.off --map map.csv)
  flip_geodesics_add_program_test(refine 0 "smallest angle 2[5-9].* 0 faces outside the bounds" refine torus.off --from 0 --to 150
                                  --delaunay --refine 25 --subdivision subdivision.off --insert inserted.ply)
  flip_geodesics_add_program_test(cut 0 "4 LOCALLY_SHORTEST" network torus.off --network network.txt --cut cut.off)
  # A curve that is a point leaves the mesh as it is.
  flip_geodesics_add_program_test(refine_at_point 0 "1 CONTRACTED.*refined +0 vertices" refine torus.off --from 4 --to 4
                                  --refine 1 --subdivision point.subdivision.off --insert point.insert.off --cut point.cut.off)
  add_test(NAME program_meshes_at_point COMMAND ${CMAKE_COMMAND} -E sha256sum point.subdivision.off point.insert.off
                                                point.cut.off WORKING_DIRECTORY ${program_dir})
  set_tests_properties(program_meshes_at_point PROPERTIES DEPENDS program_refine_at_point)
  # STL does not store the cut, and a repair merges the points of its two sides.
  flip_geodesics_add_program_test(cut_in_stl 0 "slit.stl: 4 vertices coincide with others; readers of STL, .* close cuts. use an .off" path torus.off
                                  --edges slit.txt --cut slit.stl)
  file(WRITE ${program_dir}/slit.txt "0 1 2 3\n")
  flip_geodesics_add_program_test(cut_in_stl_is_closed 0 "components  1\n[^\n]*genus 1, 0 borders" info slit.stl)
  set_tests_properties(program_cut_in_stl_is_closed PROPERTIES DEPENDS program_cut_in_stl)
  flip_geodesics_add_program_test(cut_in_stl_quietly 0 "^$" path torus.off --edges slit.txt --cut quiet_slit.stl --quiet)
  flip_geodesics_add_program_test(cut_in_stl_as_json 0 "\"remarks\":[^\n]*json_slit.stl: 4 vertices coincide" path
                                  torus.off --edges slit.txt --cut json_slit.stl --json -)
  flip_geodesics_add_program_test(cut_in_ply 0 "^[^:]*torus.off: [^\n]*\ncurve.*extract [^\n]*\n$" path torus.off --edges
                                  slit.txt --cut slit.ply)
  flip_geodesics_add_program_test(insertion_in_stl 0 "^[^:]*torus.off: [^\n]*\ncurve.*extract [^\n]*\n$" path torus.off
                                  --edges slit.txt --insert slit_insert.stl)
  flip_geodesics_add_program_test(repair_in_stl 0 "bow.stl: 1 vertex coincides with another one; readers of STL" repair
                                  bow.off -o bow.stl)
  flip_geodesics_add_program_test(info_of_cut 0 "genus 1, 1 border\ndefects     found in the file; the numbers above describe the mesh before any repair:\n  repair: 4 points merged"
                                  info slit.ply)
  set_tests_properties(program_info_of_cut PROPERTIES DEPENDS program_cut_in_ply)
  flip_geodesics_add_program_test(info_of_cut_json 0 "\"repaired\":false,\"defects\":.\"repair: 4 points merged" info
                                  slit.ply --quiet --json -)
  set_tests_properties(program_info_of_cut_json PROPERTIES DEPENDS program_cut_in_ply)
  flip_geodesics_add_program_test(repaired_cut_is_closed 0 "genus 1, 0 borders\ndefects     none" info closed_slit.ply)
  flip_geodesics_add_program_test(repair_of_cut 0 "repair: 4 points merged" repair slit.ply -o closed_slit.ply)
  set_tests_properties(program_repair_of_cut PROPERTIES DEPENDS program_cut_in_ply)
  set_tests_properties(program_repaired_cut_is_closed PROPERTIES DEPENDS program_repair_of_cut)
  # An edge with both ends inside opens at its middle: vertices 288 and 289 are new.
  flip_geodesics_add_program_test(cut_one_edge 0 "1 LOCALLY_SHORTEST" path torus.off --from 0 --to 1 --cut slit.off)
  flip_geodesics_add_program_test(slit_of_one_edge 0 "289 LOCALLY_SHORTEST" log slit.off --source 289)
  set_tests_properties(program_slit_of_one_edge PROPERTIES DEPENDS program_cut_one_edge)
  file(WRITE ${program_dir}/thread.off
       "OFF\n6 8 0\n0 0 0\n1e-6 0 0\n0 1e-6 0\n0 0 1\n1e-6 0 1\n0 1e-6 1\n3 0 2 1\n3 3 4 5\n"
       "3 0 1 4\n3 0 4 3\n3 1 2 5\n3 1 5 4\n3 2 0 3\n3 2 3 5\n")
  flip_geodesics_add_program_test(refine_thread 0 "bounds cannot be reached: [1-9][0-9]* faces" refine thread.off --from
                                  0 --to 1 --refine 25 --insertion-limit 5000)
  flip_geodesics_add_program_test(subdivision_limit 2 "^flip_geodesics: the subdivided mesh would have [0-9]+ vertices, but at most 288 are allowed[^\n]*--vertex-limit\n$"
                                  refine torus.off --from 0 --to 150 --subdivision x.off --vertex-limit 288 --quiet)
  flip_geodesics_add_program_test(vertex_limit_of_nothing 2 "--vertex-limit requires --subdivision" refine torus.off --from
                                  0 --to 150 --refine 25 --vertex-limit 288)
  flip_geodesics_add_program_test(refine_edges 0 "vertices inserted.* [1-9][0-9]* faces outside the bounds. ended" refine torus.off --from
                                  0 --to 150 --refine 0 --longest-edge 0.02 --insertion-limit 30)
  flip_geodesics_add_program_test(edges_of_nothing 2 "--longest-edge requires --refine; use --refine 0" refine torus.off --from 0 --to
                                  150 --longest-edge 0.1)
  flip_geodesics_add_program_test(bad_longest_edge 2 "--longest-edge" refine torus.off --from 0 --to 150 --refine 9
                                  --longest-edge 0)
  flip_geodesics_add_program_test(bad_refine 2 "--refine" refine torus.off --from 0 --to 150 --refine 50)
  flip_geodesics_add_program_test(bad_cut 2 "cut.xyz" path torus.off --from 0 --to 150 --cut cut.xyz)
  flip_geodesics_add_program_test(unwritable_cut 2 "no_such_folder/x.off" path torus.off --from 0 --to 150 --cut
                                  no_such_folder/x.off)
  flip_geodesics_add_program_test(vtp 0 LOCALLY_SHORTEST path torus.off --from 0 --to 150 --cut cut.vtp --insert
                                  insert.stl)
  # A failure leaves what an earlier run has written, and nothing half-written.
  file(WRITE ${program_dir}/earlier.csv "kept\n")
  flip_geodesics_add_program_test(failure_after_output 2 "no_such_folder/x.html" path torus.off --from 0 --to 150
                                  --stats earlier.csv --page no_such_folder/x.html)
  add_test(NAME program_earlier_results COMMAND ${CMAKE_COMMAND} -E compare_files earlier.csv kept.csv
           WORKING_DIRECTORY ${program_dir})
  file(WRITE ${program_dir}/kept.csv "kept\n")
  set_tests_properties(program_earlier_results PROPERTIES DEPENDS program_failure_after_output)
  flip_geodesics_add_program_test(one_file_for_two 2 "twice.csv: two" path torus.off --random 2 --stats twice.csv
                                  --polylines twice.csv)
  flip_geodesics_add_program_test(cut_of_many 2 "require a single curve, or one network of curves, instead of 3 curves" path
                                  torus.off --random 3 --cut cut.off)
  flip_geodesics_add_program_test(quiet_with_value 2 "--quiet does not take a value; see" info torus.off --quiet=7)
  flip_geodesics_add_program_test(quiet 0 "^$" path torus.off --from 0 --to 150 --quiet)
  flip_geodesics_add_program_test(help 0 "path .*loop .*view .*Examples:.*flip_geodesics distance" --help)
  foreach(command path loop loops network spline shortest trace distance log certify cut flatten refine repair info view)
    set(example " +flip_geodesics ${command} [^\n]*\n")
    flip_geodesics_add_program_test(help_of_${command} 0 "Usage: flip_geodesics ${command} .*Examples:\n${example}${example}${example}$"
                                    ${command} --help)
  endforeach()
  flip_geodesics_add_program_test(no_command 2 "'torus.off' is not a command. specify one of these before the mesh: path, " torus.off
                                  --from 0 --to 5)
  flip_geodesics_add_program_test(nothing 2 "specify a command: path, ")
  flip_geodesics_add_program_test(version 0 "^flip_geodesics ${PROJECT_VERSION}" --version)
  flip_geodesics_add_program_test(misspelt 2 "--radnom is not known; did you mean --random." path torus.off --radnom 3)
  flip_geodesics_add_program_test(one_dash 2 "-randm is not known; did you mean --random." path torus.off -randm 3)
  flip_geodesics_add_program_test(one_letter 2 "-x is not known. see flip_geodesics path --help" path torus.off -x
                                  x.obj)
  flip_geodesics_add_program_test(no_vertex 2 "--from: 'zero' is not a point" path torus.off --from zero --to 5)
  flip_geodesics_add_program_test(begun 2 "--seg is not known. did you mean --segmentation." network torus.off --seg=x)
  flip_geodesics_add_program_test(unlike_any 2 "--xyzzyx is not known; see" path torus.off --xyzzyx)
  flip_geodesics_add_program_test(zero_length 1
                                  "0 .zero_length.txt line 1.: .*length zero; omit --refuse-zero-edges" path
                                  zero_length.off --pairs zero_length.txt --refuse-zero-edges)
  flip_geodesics_add_program_test(zero_length_field 2 "length zero; use --repair" distance zero_length.off --source 0
                                  --isolines 1)
  flip_geodesics_add_program_test(zero_length_trace 1 "length zero; use --repair" trace zero_length.off --trace 3,0,1)
  flip_geodesics_add_program_test(zero_length_contracted 0 "2 LOCALLY_SHORTEST.*1 curve was computed after degenerate edges had been contracted\n"
                                  path zero_length.off --pairs zero_length.txt --kernel certified)
  flip_geodesics_add_program_test(zero_length_tree 0 "3 LOCALLY_SHORTEST.*3 curves were computed after" log zero_length.off --source 0 --map
                                  zero_length.csv)
  flip_geodesics_add_program_test(tiny_length 1 "has the length 1e-170[^\n]*. scale the mesh or correct this length\n" path tiny.off --from 0 --to 1)
  flip_geodesics_add_program_test(projected_to_no_area 0 "LOCALLY_SHORTEST" path flat.off --draw flat.polylines.txt)
  flip_geodesics_add_program_test(no_area 2 "all faces of the mesh are degenerate" path no_area.off --draw
                                  flat.polylines.txt)
  file(WRITE ${program_dir}/distant.off
       "OFF\n4 4 0\n0 0 0\n1e60 0 0\n0 1e60 0\n0 0 1e60\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
  flip_geodesics_add_program_test(beyond_floats 1 "distant.glb: vertex 0 is too far from the center" path distant.off
                                  --from 0 --to 2 --mesh distant.glb)
  flip_geodesics_add_program_test(far_point 0 "2 points are not on the mesh, but at a distance of up to 1e.308 .far.polylines.txt line 1" path torus.off
                                  --draw far.polylines.txt)

  # The curve passes a vertex at a distance that rounding does not see: it crosses the edges of that vertex inside.
  file(WRITE ${program_dir}/below.off
       "OFF\n5 4 0\n-1 0 0\n1 0 0\n0 -1e-30 0\n0 1 0\n0 -1 0\n3 0 2 3\n3 2 1 3\n3 0 4 2\n3 4 1 2\n")
  file(WRITE ${program_dir}/there_and_back.txt "0 2 1\n1 2 0\n")
  flip_geodesics_add_program_test(near_vertex 0 "2 LOCALLY_SHORTEST" path below.off --edges there_and_back.txt --kernel
                                  certified --polylines near_vertex.txt)
  flip_geodesics_add_program_test(near_vertex_legs 0 "2 LOCALLY_SHORTEST" path below.off --points ends.txt --kernel
                                  certified --polylines near_vertex_legs.txt)
  file(WRITE ${program_dir}/ends.txt "0 1\n1 0\n")
  set_target_properties(check_polylines PROPERTIES EXCLUDE_FROM_ALL OFF) # otherwise built on demand
  foreach(name near_vertex near_vertex_legs)
    add_test(NAME program_${name}_checked COMMAND check_polylines below.off ${name}.txt WORKING_DIRECTORY ${program_dir})
    set_tests_properties(program_${name}_checked PROPERTIES DEPENDS program_${name})
  endforeach()

  if(Python3_Interpreter_FOUND AND UNIX)
    foreach(case inputs results kinds_of_results failed_curves page places standard_streams interruption full_disk
                 little_memory closed_streams conditions progress values_without_path)
      add_test(NAME program_files_${case}
               COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/Flip_geodesics/check_program_files.py --program
                       $<TARGET_FILE:flip_geodesics> --torus $<TARGET_FILE:generate_torus> ${case})
    endforeach()
    set_tests_properties(program_files_progress PROPERTIES PROCESSORS 3)
  else()
    message(STATUS "Flip_geodesics: what the program does to files and streams is NOT checked, because Python 3 was not found")
  endif()

  # What is written for viewers is read back by readers that share nothing with the program.
  find_program(FLIP_GEODESICS_CHROMIUM NAMES chromium chromium-browser google-chrome
               DOC "A browser to load pages of flip_geodesics with; none if it is not found")
  mark_as_advanced(FLIP_GEODESICS_CHROMIUM)
  if(NOT Python3_Interpreter_FOUND)
    message(STATUS "Flip_geodesics: files for viewers are NOT checked, because Python 3 was not found")
  elseif(NOT FLIP_GEODESICS_CHROMIUM)
    message(STATUS "Flip_geodesics: pages are NOT loaded by a browser in tests, because Chromium was not found")
  endif()
  # flip_geodesics_add_viewer_test(name arguments...)
  function(flip_geodesics_add_viewer_test name)
    if(Python3_Interpreter_FOUND)
      add_test(
        NAME viewer_files_${name}
        COMMAND
          ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/Flip_geodesics/check_viewer_files.py --program
          $<TARGET_FILE:flip_geodesics> --mesh torus.off -- ${ARGN}
        WORKING_DIRECTORY ${program_dir})
      set_tests_properties(viewer_files_${name} PROPERTIES FIXTURES_REQUIRED program_input)
    endif()
  endfunction()
  flip_geodesics_add_viewer_test(pairs path --random 8)
  flip_geodesics_add_viewer_test(network network --network network.txt)
  flip_geodesics_add_viewer_test(contracted loop --loop trivial_loop.txt)
  flip_geodesics_add_viewer_test(tree log --source 0)
  flip_geodesics_add_viewer_test(ways shortest --from 13 --to 150 --ways 3 --avoid hole.txt)
  flip_geodesics_add_viewer_test(isolines distance --source 0,100 --isolines 0.3,0.5 --voronoi)
  if(Python3_Interpreter_FOUND AND FLIP_GEODESICS_CHROMIUM)
    add_test(
      NAME page_in_browser
      COMMAND
        ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/Flip_geodesics/check_viewer_files.py --program
        $<TARGET_FILE:flip_geodesics> --mesh torus.off --chromium ${FLIP_GEODESICS_CHROMIUM} -- path --random 3
      WORKING_DIRECTORY ${program_dir})
    set_tests_properties(page_in_browser PROPERTIES FIXTURES_REQUIRED program_input)
    add_test(
      NAME live_page_in_browser
      COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/Flip_geodesics/check_live_page.py --program
              $<TARGET_FILE:flip_geodesics> --mesh torus.off --chromium ${FLIP_GEODESICS_CHROMIUM}
      WORKING_DIRECTORY ${program_dir})
    set_tests_properties(live_page_in_browser PROPERTIES FIXTURES_REQUIRED program_input)
  endif()
  add_test(NAME page_is_built COMMAND ${CMAKE_COMMAND} -P ${CMAKE_CURRENT_SOURCE_DIR}/page/check_sources.cmake)

  # Pages are built for a release, and may be older than their sources in between.
  set_tests_properties(page_is_built PROPERTIES SKIP_REGULAR_EXPRESSION "_page.html is older than")
  # The page is built with a release only, but what it computes with has to compile.
  add_test(
    NAME live_engine
    COMMAND
      ${CMAKE_CXX_COMPILER} -std=c++17 -w -frounding-math -fsyntax-only
      "-I$<JOIN:$<TARGET_PROPERTY:flip_geodesics,INCLUDE_DIRECTORIES>,;-I>"
      "-D$<JOIN:$<TARGET_PROPERTY:flip_geodesics,COMPILE_DEFINITIONS>,;-D>" ${CMAKE_CURRENT_SOURCE_DIR}/live/engine.cpp
    COMMAND_EXPAND_LISTS)
  flip_geodesics_add_program_test(live 0 "torus.off: 288 vertices" view torus.off --output live.html)
  flip_geodesics_add_program_test(live_and_stats 2 "--stats is not an option of view, but of path" view torus.off
                                  --output live.html --stats x.csv)
  flip_geodesics_add_program_test(unknown_option 2 "--wrong" path torus.off --wrong)
  flip_geodesics_add_program_test(no_curves 2 "requires one of the options --from, --pairs, --random, --edges, --points or --draw" path
                                  torus.off)
  flip_geodesics_add_program_test(two_sets_of_curves 2 "--pairs and --random cannot be combined. use one of them" path
                                  torus.off --random 2 --pairs pairs.txt)
  flip_geodesics_add_program_test(from_without_to 2 "--from requires --to" path torus.off --from 3)
  flip_geodesics_add_program_test(certified 0 "5 LOCALLY_SHORTEST.*locally shortest: 5 PROVEN" path torus.off --random 5)
  flip_geodesics_add_program_test(double 0 "5 LOCALLY_SHORTEST\nlength" path torus.off --random 5 --kernel double)
  flip_geodesics_add_program_test(kernel_of_isolines 2 "--kernel is not an option of distance" distance torus.off
                                  --source 0 --isolines 0.3 --kernel certified)
  flip_geodesics_add_program_test(mollified 0 "LOCALLY_SHORTEST" path torus.off --random 5 --mollify 1e-5)
  flip_geodesics_add_program_test(bad_mollify 2 "--mollify: '2' is out of range. use more than 0 and less than 1" path
                                  torus.off --random 5 --mollify 2)
  flip_geodesics_add_program_test(unknown_kernel 2 "--kernel: 'fast' is not known. use certified or double" path torus.off --random 2 --kernel fast)
  flip_geodesics_add_program_test(unknown_search 2 "--search: 'best' is not known. use lookback, astar or dijkstra" path torus.off --random 2 --search best)
  flip_geodesics_add_program_test(bad_stop_length 2 "--stop-length" path torus.off --random 2 --stop-length 2)
  flip_geodesics_add_program_test(bad_memory_limit 2 "--memory-limit" path torus.off --random 2 --memory-limit 0)
  flip_geodesics_add_program_test(memory_limit 1 "curve 0 .*--memory-limit" path torus.off --edges path.txt --kernel
                                  certified --memory-limit 0.0001)
  flip_geodesics_add_program_test(unwritable 2 "no_such_folder/x" path torus.off --random 2 --stats no_such_folder/x)
  flip_geodesics_add_program_test(unwritable_page 2
                                  "no_such_folder/x.html: the folder [^\n]*no_such_folder does not exist" path torus.off
                                  --random 2 --page no_such_folder/x.html)
  flip_geodesics_add_program_test(viewer_format 2 "x.xyz" path torus.off --random 2 --mesh x.xyz)
  flip_geodesics_add_program_test(out_of_range 2 "vertex 288" path torus.off --from 0 --to 288)
  flip_geodesics_add_program_test(out_of_range_in_file 2 "far.txt line 2: vertex 400" path torus.off --pairs far.txt)
  flip_geodesics_add_program_test(equal_ends 0 "CONTRACTED" path torus.off --pairs equal.txt)
  flip_geodesics_add_program_test(not_a_number 2 "word.txt line 1.*one" path torus.off --pairs word.txt)
  flip_geodesics_add_program_test(gap 2 "gap.txt line 2.*1 and 5" path torus.off --edges gap.txt)
  flip_geodesics_add_program_test(disconnected 1 "curve 0 .--from, --to.: .*vertices 0 and 3 lie in different" path two_parts.off
                                  --from 0 --to 3)
  set(advice_on_gaps "the command `info` lists the components, and --repair with --weld TOLERANCE joins borders")
  foreach(end 3 3,4,0.5)
    foreach(command path shortest "shortest --ways 2" "path --kernel double")
      separate_arguments(arguments UNIX_COMMAND "${command}")
      list(POP_FRONT arguments name)
      string(MAKE_C_IDENTIFIER "${command} ${end}" id)
      flip_geodesics_add_program_test(disconnected_${id} 1 "${advice_on_gaps}" ${name} two_parts.off --from 0 --to ${end}
                                      ${arguments})
    endforeach()
  endforeach()
  flip_geodesics_add_program_test(disconnected_drawn 2 "joined.txt line 2: .*${advice_on_gaps}" cut two_parts.off --draw
                                  drawn_some_joined.txt --cut x.off)
  file(WRITE ${program_dir}/drawn_some_joined.txt "0 1\n0 3\n")
  flip_geodesics_add_program_test(disconnected_alone 1
                                  "curve 1 .some_joined.txt line 2.: [^\n]*vertices 0 and 3 [^\n]*\n[^\n]*curve 3 .some_joined.txt line 4.: "
                                  path two_parts.off --pairs some_joined.txt)
  flip_geodesics_add_program_test(disconnected_points 1 "curve 0 .two_points.txt line 1.: no path" path two_parts.off
                                  --points two_points.txt)
  flip_geodesics_add_program_test(no_file 2 "missing.off" path missing.off --random 2)
  flip_geodesics_add_program_test(unknown_format 2 "pairs.txt: the extension does not determine the format.*--format" path pairs.txt
                                  --random 2)
  flip_geodesics_add_program_test(format_of_no_name 2 "--format xyz: not known as an input format; use one of obj, off" path torus.off
                                  --format xyz --random 2)
  flip_geodesics_add_program_test(given_twice 2 "--from is given 2 times. give it once" path torus.off --from 0 --from 1
                                  --to 5)
  flip_geodesics_add_program_test(two_values 2 "'0' is unexpected" path torus.off 0 100)
  flip_geodesics_add_program_test(empty_file 2 "empty.off" path empty.off --random 2)
  flip_geodesics_add_program_test(quad 2 "quad.off: face 0 has 4" path quad.off --random 2)
  flip_geodesics_add_program_test(misoriented 2 "turned.off.*0 and 2.*orient" path turned.off --random 2)
  file(WRITE ${program_dir}/doubled.off "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n3 1 2 0\n")
  flip_geodesics_add_program_test(doubled_face 2 "doubled.off: face 2 has the same vertices as face 0. remove one of them, or use --repair"
                                  path doubled.off --random 2)
  flip_geodesics_add_program_test(nonmanifold_edge 2 "book.off.*0 and 1 has more than two faces" path book.off --random 2)
  flip_geodesics_add_program_test(nonmanifold_vertex 2 "bow.off: vertex 0" path bow.off --random 2)
  flip_geodesics_add_program_test(repeated_vertex 2 "repeated.off: face 0" path repeated.off --random 2)
  flip_geodesics_add_program_test(face_out_of_range 2 "range.obj line 4: face 0 has a vertex" path range.obj --random 2)
  flip_geodesics_add_program_test(not_a_coordinate 2 "nan.obj line 2: vertex 1 has 'nan'" path nan.obj --random 2)
  flip_geodesics_add_program_test(truncated 2 "truncated.off line 4: vertex 2 is missing" path truncated.off --random 2)
  flip_geodesics_add_program_test(huge_header 2 "huge.off line 2: .*number of vertices" path huge.off --random 2)
  file(WRITE ${program_dir}/strips.ply
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
       "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0\n")
  file(WRITE ${program_dir}/no_faces.off "OFF\n1 0 0\n0 0 0\n")
  flip_geodesics_add_program_test(strips 2 "strips.ply[^\n]*: the file has triangle strips, which are not supported" path
                                  strips.ply --random 2)
  flip_geodesics_add_program_test(nothing_to_repair 2 "no_faces.off: the file has no faces" repair no_faces.off --output
                                  x.off)
  flip_geodesics_add_program_test(early_property 2 "early_property.ply line 3: .*property before any element" path
                                  early_property.ply --random 2)
  flip_geodesics_add_program_test(escape 2 "escape.txt line 2: '[?]c7' is not a point" path torus.off --pairs
                                  escape.txt)
  flip_geodesics_add_program_test(folder 2 ": is a folder; specify a file" path . --random 2)
  flip_geodesics_add_program_test(folder_of_pairs 2 ": is a folder; specify a file" path torus.off --pairs .)
  flip_geodesics_add_program_test(escape_in_name 2 "no[?]c.off: cannot be opened" path "no${escape}c.off" --random 2)
  flip_geodesics_add_program_test(escape_in_option 2 "--kernel: '[?]c' is not known" path torus.off --random 2 --kernel
                                  "${escape}c")
  flip_geodesics_add_program_test(marked 0 "2 LOCALLY_SHORTEST" path torus.off --pairs marked.txt)
  flip_geodesics_add_program_test(beyond 2 "beyond.txt line 1: '99999999999999999999' is not the number of a vertex" path
                                  torus.off --pairs beyond.txt)
  flip_geodesics_add_program_test(none_at_random 2 "--random: '0' is out of range" path torus.off --random 0)
  flip_geodesics_add_program_test(too_many_at_random 2 "--random: '99999999999' is out of range" path torus.off --random
                                  99999999999)
  flip_geodesics_add_program_test(bad_seed 2 "--seed: '-1' is out of range" path torus.off --random 2 --seed -1)
  flip_geodesics_add_program_test(rounds_of_nothing 2 "--rounds is not an option of path, but of spline" path torus.off
                                  --random 2 --rounds 3)
  flip_geodesics_add_program_test(less_than_none 2 "--random: '-3' is out of range" path torus.off --random -3)
  flip_geodesics_add_program_test(no_curve 2 "no_curve.txt" network torus.off --network no_curve.txt)
  flip_geodesics_add_program_test(loose_fixed_vertex 2 "vertex 9" network torus.off --network loose_network.txt)
  flip_geodesics_add_program_test(crossing_itself 2 "crossing.txt line 2.*cross.*vertex 4" path torus.off --edges
                                  crossing.txt)
  flip_geodesics_add_program_test(crossing_network 2 "cross.*vertex 4.*line `! 4`" network torus.off --network crossing_network.txt)
endif()
