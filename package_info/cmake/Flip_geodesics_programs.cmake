# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Settings of the tests, examples and benchmarks: warnings, optional libraries, and the functions that add programs.

find_package(Eigen3 QUIET)
include(CGAL_Eigen3_support)
find_package(TBB QUIET)
include(CGAL_TBB_support)
find_package(CLI11 QUIET)
find_package(benchmark QUIET)

# Boost.MPI and the libraries that it requires, for programs that run on several machines. Boost.MPI is searched for
# first, because a search for MPI fails on machines that have the MPI compiler but not its headers.
find_package(boost_mpi QUIET CONFIG)
find_package(boost_serialization QUIET CONFIG)
if(TARGET Boost::mpi)
  find_package(MPI QUIET COMPONENTS CXX)
endif()
if(CMAKE_CXX_FLAGS MATCHES "_GLIBCXX_DEBUG")
  # Containers with checked iterators are not compatible with the compiled library.
  message(STATUS "Flip_geodesics: Boost.MPI is NOT used with checked iterators")
elseif(TARGET MPI::MPI_CXX AND TARGET Boost::mpi AND TARGET Boost::serialization)
  add_library(Flip_geodesics_MPI INTERFACE IMPORTED)
  set_target_properties(Flip_geodesics_MPI PROPERTIES INTERFACE_LINK_LIBRARIES
                                                      "Boost::mpi;Boost::serialization;MPI::MPI_CXX")
endif()

# Not by find_package(): in some distributions, the configuration file of OpenMesh names files that do not exist.
find_path(FLIP_GEODESICS_OPENMESH_INCLUDE_DIR OpenMesh/Core/Mesh/ArrayKernel.hh)
find_library(FLIP_GEODESICS_OPENMESH_LIBRARY OpenMeshCore)
mark_as_advanced(FLIP_GEODESICS_OPENMESH_INCLUDE_DIR FLIP_GEODESICS_OPENMESH_LIBRARY)
if(CMAKE_CXX_FLAGS MATCHES "_GLIBCXX_DEBUG")
  # As above.
  message(STATUS "Flip_geodesics: meshes of OpenMesh are NOT tested with checked iterators")
elseif(FLIP_GEODESICS_OPENMESH_INCLUDE_DIR AND FLIP_GEODESICS_OPENMESH_LIBRARY)
  add_library(Flip_geodesics_OpenMesh INTERFACE IMPORTED)
  set_target_properties(
    Flip_geodesics_OpenMesh
    PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${FLIP_GEODESICS_OPENMESH_INCLUDE_DIR}"
               INTERFACE_LINK_LIBRARIES "${FLIP_GEODESICS_OPENMESH_LIBRARY}"
               INTERFACE_COMPILE_DEFINITIONS "CGAL_USE_OPENMESH;NOMINMAX;_USE_MATH_DEFINES"
               # OpenMesh does not initialize some elements, which g++ reports where it inlines functions.
               INTERFACE_COMPILE_OPTIONS "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>")
else()
  message(STATUS "Flip_geodesics: meshes of OpenMesh are NOT tested, because it was not found")
endif()

add_library(Flip_geodesics_warnings INTERFACE)
target_compile_options(
  Flip_geodesics_warnings
  INTERFACE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wpedantic>
            $<$<AND:$<BOOL:${FLIP_GEODESICS_WARNINGS_AS_ERRORS}>,$<CXX_COMPILER_ID:GNU,Clang,AppleClang>>:-Werror>)

# A target that replaces CGAL::Flip_geodesics: programs are not linked to GMP and MPFR, and cannot include their
# headers.
add_library(Flip_geodesics_without_gmp INTERFACE)
set(flip_geodesics_hidden_dir "${PROJECT_BINARY_DIR}/hidden")
foreach(header gmp.h gmpxx.h mpfr.h)
  file(CONFIGURE OUTPUT "${flip_geodesics_hidden_dir}/${header}" CONTENT "#error \"@header@ is hidden\"\n" @ONLY)
endforeach()
target_compile_features(Flip_geodesics_without_gmp INTERFACE cxx_std_17)
target_compile_options(Flip_geodesics_without_gmp INTERFACE $<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_COMPILE_OPTIONS>)
target_include_directories(Flip_geodesics_without_gmp INTERFACE "${flip_geodesics_hidden_dir}"
                                                                "${PROJECT_SOURCE_DIR}/include")
target_include_directories(Flip_geodesics_without_gmp SYSTEM
                           INTERFACE $<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_INCLUDE_DIRECTORIES>)

# An optional library is linked only to the programs whose sources mention it. `flip_geodesics_optional_libraries`
# contains triples: a pattern, a target, and GUARDED if the program can be built without the library because the source
# has an #ifdef, or REQUIRED if the program is otherwise omitted. TBB is required if one of its headers is included
# outside of an #ifdef.
set(flip_geodesics_optional_libraries
    "CGAL_EIGEN3_ENABLED" CGAL::Eigen3_support GUARDED
    "#include <Eigen/|/(Operators|Tangent_spaces|Dirichlet_problem|Direction_field|Conformal_flattening)\\.h>"
    CGAL::Eigen3_support
    REQUIRED
    "CGAL_LINKED_WITH_TBB|CGAL::Parallel_tag" CGAL::TBB_support GUARDED
    "\n\n#include <tbb/" CGAL::TBB_support REQUIRED
    "CGAL_USE_OPENMESH" Flip_geodesics_OpenMesh GUARDED
    "<boost/mpi.hpp>" Flip_geodesics_MPI REQUIRED
    "<CLI/CLI.hpp>" CLI11::CLI11 REQUIRED
    "<benchmark/benchmark.h>" benchmark::benchmark REQUIRED)

# Sets `used` to the optional libraries that the `sources` mention, and `missing` to those of them that are required but
# were not found.
function(flip_geodesics_find_used_libraries sources used missing)
  set(text "")
  foreach(source IN LISTS sources)
    # The result can change if the source is edited.
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    file(READ "${source}" text_of_source)
    string(APPEND text "${text_of_source}")
  endforeach()
  set(found "")
  set(absent "")
  set(triples "${flip_geodesics_optional_libraries}")
  while(triples)
    list(POP_FRONT triples pattern library need)
    if(NOT text MATCHES "${pattern}")
      continue()
    elseif(TARGET ${library})
      list(APPEND found ${library})
    elseif(need STREQUAL REQUIRED)
      list(APPEND absent ${library})
    endif()
  endwhile()
  set(${used} "${found}" PARENT_SCOPE)
  set(${missing} "${absent}" PARENT_SCOPE)
endfunction()

# flip_geodesics_add_program(name [WITHOUT_LIBRARY | WITHOUT_GMP] [PARTS source...])
#
# Adds the executable `name` with the source `name.cpp`, by default linked to CGAL::Flip_geodesics. If a required
# library is missing, a message is printed and no target is added: test if(TARGET name) after the call. The parts, that
# is, further sources and headers, are compiled as one unit together with the source.
function(flip_geodesics_add_program name)
  cmake_parse_arguments(arg "WITHOUT_LIBRARY;WITHOUT_GMP" "" "PARTS" ${ARGN})
  set(sources "${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp" ${arg_PARTS})
  flip_geodesics_find_used_libraries("${sources}" used missing)
  if(missing)
    message(STATUS "Flip_geodesics: ${name} is left out, because ${missing} was not found")
    return()
  endif()
  add_executable(${name} ${sources})
  if(arg_PARTS)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
  target_compile_features(${name} PRIVATE cxx_std_17)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(${name} PRIVATE Flip_geodesics_warnings ${used})
  if(arg_WITHOUT_GMP)
    target_link_libraries(${name} PRIVATE Flip_geodesics_without_gmp)
  elseif(NOT arg_WITHOUT_LIBRARY)
    target_link_libraries(${name} PRIVATE CGAL::Flip_geodesics)
  endif()
endfunction()
