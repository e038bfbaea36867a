# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The test `headers`: each header compiles alone, and twice in a row; all of them linked into one program show a function
# that lacks `inline` as a duplicate symbol. Where g++ does that, clang++ looks at our code, all of it in one source.

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/include"
     "${PROJECT_SOURCE_DIR}/include/CGAL/*.h")

# What most headers include. A header gets what it includes anyway, itself or by our others, so that nothing that it lacks
# is hidden.
set(precompiled_graph
    <CGAL/Iterator_range.h> <CGAL/boost/graph/properties.h> <boost/graph/graph_traits.hpp>
    <boost/iterator/iterator_facade.hpp> <algorithm> <array> <functional> <memory> <ostream> <stdexcept> <string> <vector>)
set(precompiled_numbers
    ${precompiled_graph} <CGAL/Kernel_traits.h> <CGAL/Named_function_parameters.h> <CGAL/Simple_cartesian.h>
    <boost/math/constants/constants.hpp> <boost/multiprecision/cpp_bin_float.hpp> <boost/multiprecision/cpp_int.hpp>
    <complex> <deque> <map> <optional> <random> <sstream> <unordered_map>)

# Sets `result` to everything in <> that `header` includes, itself or by our others.
function(flip_geodesics_includes_of header result)
  get_property(known GLOBAL PROPERTY "flip_geodesics_includes_of_${header}" SET)
  if(NOT known)
    file(READ "${PROJECT_SOURCE_DIR}/include/${header}" text)
    string(REGEX MATCHALL "\n#include <[^>]+>" includes "${text}")
    list(TRANSFORM includes REPLACE "\n#include " "")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE "[<>]" "" path "${include}")
      if(path IN_LIST headers)
        flip_geodesics_includes_of("${path}" of_ours)
        list(APPEND includes ${of_ours})
      endif()
    endforeach()
    list(REMOVE_DUPLICATES includes)
    set_property(GLOBAL PROPERTY "flip_geodesics_includes_of_${header}" "${includes}")
  endif()
  get_property(includes GLOBAL PROPERTY "flip_geodesics_includes_of_${header}")
  set(${result} "${includes}" PARENT_SCOPE)
endfunction()

# Sets `result` to what can be precompiled for `header`: graph, numbers or nothing.
function(flip_geodesics_precompiled_for header result)
  flip_geodesics_includes_of("${header}" includes)
  set(${result} nothing PARENT_SCOPE)
  foreach(group graph numbers)
    set(absent ${precompiled_${group}})
    list(REMOVE_ITEM absent ${includes})
    if(NOT absent)
      set(${result} ${group} PARENT_SCOPE)
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
set(everything "")
set(number_of_headers 0)
foreach(group nothing graph numbers)
  set(sources_with_${group} "")
endforeach()
# Adds a source with these lines to those of `group`.
macro(flip_geodesics_add_header_source name group lines)
  file(CONFIGURE OUTPUT "${header_folder}/${name}.cpp" CONTENT "${lines}")
  list(APPEND sources_with_${group} "${header_folder}/${name}.cpp")
  string(APPEND everything "${lines}")
  math(EXPR number_of_headers "${number_of_headers} + 1")
endmacro()

foreach(header IN LISTS headers)
  file(READ "${PROJECT_SOURCE_DIR}/include/${header}" text)
  if(text MATCHES "<Eigen/" AND NOT TARGET CGAL::Eigen3_support)
    continue() # such headers are not in Flip_geodesics.h
  endif()
  flip_geodesics_precompiled_for("${header}" group)
  string(MAKE_C_IDENTIFIER "${header}" name)
  flip_geodesics_add_header_source(${name} ${group} "#include <${header}>\n#include <${header}>\n")
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
if(FLIP_GEODESICS_PRECOMPILE_HEADERS AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  file(CONFIGURE OUTPUT "${header_folder}/everything.cpp" CONTENT "${everything}")
  flip_geodesics_add_headers(all_headers "${header_folder}/everything.cpp")
elseif(FLIP_GEODESICS_PRECOMPILE_HEADERS)
  foreach(group nothing graph numbers)
    flip_geodesics_add_headers(headers_with_${group} ${sources_with_${group}})
    if(NOT group STREQUAL "nothing")
      target_precompile_headers(headers_with_${group} PRIVATE ${precompiled_${group}})
    endif()
  endforeach()
else()
  flip_geodesics_add_headers(headers_alone ${sources_with_nothing} ${sources_with_graph} ${sources_with_numbers})
endif()
add_test(NAME headers COMMAND headers_together)
