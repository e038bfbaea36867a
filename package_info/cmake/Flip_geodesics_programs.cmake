# SPDX-License-Identifier: LGPL-3.0-or-later
#
# What the tests, examples and benchmarks share: the warnings, the optional libraries, one function per program.

find_package(Eigen3 QUIET)
include(CGAL_Eigen3_support)
find_package(TBB QUIET)
include(CGAL_TBB_support)
find_package(CLI11 QUIET)
find_package(benchmark QUIET)

# Boost.MPI, with what it needs, for programs that run on many machines. Boost.MPI is looked for first: where MPI has its
# compiler but not its headers, as on machines that only run such programs, looking for MPI is an error.
find_package(boost_mpi QUIET CONFIG)
find_package(boost_serialization QUIET CONFIG)
if(TARGET Boost::mpi)
  find_package(MPI QUIET COMPONENTS CXX)
endif()
if(CMAKE_CXX_FLAGS MATCHES "_GLIBCXX_DEBUG")
  # Containers with checked iterators are not those that the library was compiled with.
  message(STATUS "Flip_geodesics: Boost.MPI is NOT used with checked iterators")
elseif(TARGET MPI::MPI_CXX AND TARGET Boost::mpi AND TARGET Boost::serialization)
  add_library(Flip_geodesics_MPI INTERFACE IMPORTED)
  set_target_properties(Flip_geodesics_MPI PROPERTIES INTERFACE_LINK_LIBRARIES
                                                      "Boost::mpi;Boost::serialization;MPI::MPI_CXX")
endif()

# By hand: the configuration file of some distributions' OpenMesh names files that they do not ship.
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
               # OpenMesh has elements without initial values, which g++ reports where they are inlined.
               INTERFACE_COMPILE_OPTIONS "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>")
else()
  message(STATUS "Flip_geodesics: meshes of OpenMesh are NOT tested, because it was not found")
endif()

add_library(Flip_geodesics_warnings INTERFACE)
target_compile_options(
  Flip_geodesics_warnings
  INTERFACE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wpedantic>
            $<$<AND:$<BOOL:${FLIP_GEODESICS_WARNINGS_AS_ERRORS}>,$<CXX_COMPILER_ID:GNU,Clang,AppleClang>>:-Werror>)

# Instead of CGAL::Flip_geodesics: a program does not compile if it includes GMP or MPFR, and is not linked to them.
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

# An optional library is linked to the programs whose source mentions it, so that nobody keeps lists and the other
# programs do not pay for it. `flip_geodesics_optional_libraries` holds triples: pattern, target, and what happens
# without it: GUARDED (the source has an #ifdef) or REQUIRED (the program is left out). TBB is required if an include of
# one of its headers follows no #ifdef.
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

# Sets `used` to the optional libraries that the `sources` mention and `missing` to those that they cannot do without.
function(flip_geodesics_find_used_libraries sources used missing)
  set(text "")
  foreach(source IN LISTS sources)
    # Editing the source may change the answer.
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
# Adds the executable `name` made of `name.cpp`, linked to CGAL::Flip_geodesics if nothing else is said. Leaves it out,
# with a message, if a required library is missing: test if(TARGET name) after the call. The parts, sources and
# headers, are compiled together with it, so that a program costs the same however many sources it is in.
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
