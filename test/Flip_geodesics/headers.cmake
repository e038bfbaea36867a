# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The test `headers`: each header compiles alone, and twice in a row; all of them linked into one program show a function
# that lacks `inline` as a duplicate symbol.
#
# A source has a chain of headers, each of which includes those before it, directly or by others of ours. What a header
# lacks is not hidden by what comes before it in its chain, since it includes that anyway. Some 180 headers make half as
# many chains. With FLIP_GEODESICS_TEST_HEADERS=PUBLIC, internal headers are not compiled alone, which halves the time
# again: what one of them lacks is found if a public header that includes it lacks it as well.

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/include"
     "${PROJECT_SOURCE_DIR}/include/CGAL/*.h")
if(FLIP_GEODESICS_TEST_HEADERS STREQUAL "PUBLIC")
  list(FILTER headers EXCLUDE REGEX "/internal/")
endif()

# Each is compiled once for all chains whose first header includes it, which hides nothing either: of these, the last
# that it includes. Every header is in a chain, these as well.
set(precompiled_headers Descriptors.h internal/surface/Indexed_mesh.h internal/numbers/Integer.h internal/unfolding/Exact_sign.h
                        metrics.h internal/triangulation/Point_insertion.h)
if(FLIP_GEODESICS_TEST_HEADERS STREQUAL "PUBLIC") # two chains each do not pay for them
  list(REMOVE_ITEM precompiled_headers internal/numbers/Integer.h internal/unfolding/Exact_sign.h)
endif()
list(TRANSFORM precompiled_headers PREPEND "CGAL/Flip_geodesics/")

# Sets `result` to those of our headers that `header` includes, directly or by others of ours, before any condition.
function(flip_geodesics_includes_of header result)
  get_property(known GLOBAL PROPERTY "flip_geodesics_includes_of_${header}" SET)
  if(NOT known)
    file(READ "${PROJECT_SOURCE_DIR}/include/${header}" text)
    string(REGEX REPLACE "^.*\n#define [A-Z0-9_]+_H\n" "" text "${text}")
    string(REGEX REPLACE "\n#if.*$" "" text "${text}")
    string(REGEX MATCHALL "#include <CGAL/Flip_geodesics[^>]*>" named "${text}")
    list(TRANSFORM named REPLACE "#include <(.*)>" "\\1")
    set(includes ${named})
    foreach(include IN LISTS named)
      flip_geodesics_includes_of("${include}" more)
      list(APPEND includes ${more})
    endforeach()
    list(REMOVE_DUPLICATES includes)
    set_property(GLOBAL PROPERTY "flip_geodesics_includes_of_${header}" "${includes}")
  endif()
  get_property(includes GLOBAL PROPERTY "flip_geodesics_includes_of_${header}")
  set(${result} "${includes}" PARENT_SCOPE)
endfunction()

# Sorts the list of headers named `list` by how many they include: each comes after those that it includes.
function(flip_geodesics_sort_headers list)
  set(keys "")
  foreach(header IN LISTS ${list})
    flip_geodesics_includes_of("${header}" includes)
    list(LENGTH includes number)
    math(EXPR number "1000 + ${number}")
    list(APPEND keys "${number} ${header}")
  endforeach()
  list(SORT keys)
  list(TRANSFORM keys REPLACE "^[0-9]+ " "")
  set(${list} "${keys}" PARENT_SCOPE)
endfunction()

# Sets `result` to what is precompiled for `header`, or to nothing.
function(flip_geodesics_precompiled_for header result)
  flip_geodesics_includes_of("${header}" includes)
  set(${result} nothing PARENT_SCOPE)
  foreach(precompiled IN LISTS precompiled_headers)
    if(precompiled IN_LIST includes)
      set(${result} "${precompiled}" PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# A library of objects that are only to compile, hence without optimization.
function(flip_geodesics_add_headers name)
  add_library(${name} OBJECT ${ARGN})
  target_link_libraries(${name} PRIVATE CGAL::Flip_geodesics Flip_geodesics_warnings
                                        $<TARGET_NAME_IF_EXISTS:CGAL::Eigen3_support>)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-O0>)
  target_sources(headers_together PRIVATE $<TARGET_OBJECTS:${name}>)
endfunction()

set(header_folder "${CMAKE_CURRENT_BINARY_DIR}/headers")
set(number_of_headers 0)
foreach(group nothing ${precompiled_headers})
  set("sources_with_${group}" "")
endforeach()

# Adds a source with these lines to those of `group`.
macro(flip_geodesics_add_header_source name group lines)
  file(CONFIGURE OUTPUT "${header_folder}/${name}.cpp" CONTENT "${lines}")
  list(APPEND "sources_with_${group}" "${header_folder}/${name}.cpp")
endmacro()

# Each header is appended to one of the chains that end with a header that it includes, the one that includes most, or
# begins a chain.
flip_geodesics_sort_headers(headers)
set(lasts "") # of the chains, in the order of the headers
foreach(header IN LISTS headers)
  file(READ "${PROJECT_SOURCE_DIR}/include/${header}" text)
  if(text MATCHES "<Eigen/" AND NOT TARGET CGAL::Eigen3_support)
    continue() # such headers are not in Flip_geodesics.h
  endif()
  math(EXPR number_of_headers "${number_of_headers} + 1")
  flip_geodesics_includes_of("${header}" includes)
  flip_geodesics_precompiled_for("${header}" group)
  set(chain_to_${header} "#include <${header}>\n#include <${header}>\n")
  set(group_of_${header} ${group})
  list(REVERSE lasts)
  foreach(last IN LISTS lasts)
    if(last IN_LIST includes AND group STREQUAL group_of_${last})
      string(PREPEND chain_to_${header} "${chain_to_${last}}")
      list(REMOVE_ITEM lasts ${last})
      break()
    endif()
  endforeach()
  list(REVERSE lasts)
  list(APPEND lasts ${header})
endforeach()
foreach(last IN LISTS lasts)
  string(MAKE_C_IDENTIFIER "${last}" name)
  flip_geodesics_add_header_source(${name} ${group_of_${last}} "${chain_to_${last}}")
endforeach()

# What CMake makes of the page of the program, as large as a compiler bears.
if(TARGET flip_geodesics)
  flip_geodesics_add_header_source(
    page_template nothing
    "#include \"${PROJECT_BINARY_DIR}/examples/Flip_geodesics_program/generated/page_template.h\"\n")
endif()

file(CONFIGURE OUTPUT "${header_folder}/main.cpp" CONTENT [[
#include <iostream>

int main()
{
  std::cout << "@number_of_headers@ headers compile\n";
  return @number_of_headers@ > 0 ? 0 : 1;
}
]] @ONLY)
add_executable(headers_together "${header_folder}/main.cpp")
target_link_libraries(headers_together PRIVATE CGAL::Flip_geodesics)
if(FLIP_GEODESICS_PRECOMPILE_HEADERS)
  foreach(group nothing ${precompiled_headers})
    if("${sources_with_${group}}" STREQUAL "")
      continue()
    endif()
    get_filename_component(name "${group}" NAME_WE)
    flip_geodesics_add_headers(headers_with_${name} ${sources_with_${group}})
    if(NOT group STREQUAL "nothing")
      target_precompile_headers(headers_with_${name} PRIVATE "<${group}>")
    endif()
  endforeach()
else()
  set(sources "")
  foreach(group nothing ${precompiled_headers})
    list(APPEND sources ${sources_with_${group}})
  endforeach()
  flip_geodesics_add_headers(headers_alone ${sources})
endif()
add_test(NAME headers COMMAND headers_together)
