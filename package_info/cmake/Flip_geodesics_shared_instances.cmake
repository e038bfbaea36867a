# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Template instances that several programs share, for clang++ 11 or newer. The instances are part of a precompiled
# header (shared_instances.h), and their code is generated once, in an object to which the programs are linked. This
# reduces the time to compile a program to a fifth.

# The objects are large; the linker of LLVM takes a quarter of the time that the default linker takes.
find_program(FLIP_GEODESICS_LLD ld.lld)
mark_as_advanced(FLIP_GEODESICS_LLD)
if(FLIP_GEODESICS_LLD)
  add_link_options(-fuse-ld=lld)
endif()

# flip_geodesics_add_shared_instances(name level [DEFINITIONS macro...] [LIBRARIES target...] [HEADERS file...])
#
# Adds instances with the given macros and libraries, compiled with the given level of optimization. The programs are
# linked to the libraries as well, but are not compiled with this level. The headers are precompiled together with the
# instances.
function(flip_geodesics_add_shared_instances name level)
  cmake_parse_arguments(arg "" "" "DEFINITIONS;LIBRARIES;HEADERS" ${ARGN})
  set(dir "${PROJECT_BINARY_DIR}/${name}")
  file(CONFIGURE OUTPUT "${dir}/nothing.cpp" CONTENT "") # stays as it is, and what is made of it
  add_library(${name} OBJECT "${dir}/nothing.cpp")
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(${name} PRIVATE CGAL::Flip_geodesics Flip_geodesics_warnings ${arg_LIBRARIES})
  target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
  # The code of the instances is generated here and not in the programs that use the header.
  target_compile_options(${name} PRIVATE "SHELL:-Xclang -fmodules-codegen" -O0)
  target_precompile_headers(${name} PRIVATE "${PROJECT_SOURCE_DIR}/package_info/cmake/shared_instances.h"
                            ${arg_HEADERS})

  get_target_property(target_dir ${name} BINARY_DIR)
  set(object "${dir}/${name}${CMAKE_CXX_OUTPUT_EXTENSION}")
  separate_arguments(flags NATIVE_COMMAND "${CMAKE_CXX_FLAGS}")
  # Machine code is generated without optimization from the optimized intermediate code: this takes half the time, and
  # tests are only slightly slower.
  set(compile "${CMAKE_CXX_COMPILER}" ${flags} -Wno-unused-command-line-argument)
  set(bitcode "${dir}/${name}.bc")
  add_custom_command(
    OUTPUT "${object}"
    COMMAND ${compile} ${level} -emit-llvm -c "${target_dir}/CMakeFiles/${name}.dir/cmake_pch.hxx.pch" -o "${bitcode}"
    COMMAND ${compile} -O0 -c "${bitcode}" -o "${object}"
    DEPENDS $<TARGET_OBJECTS:${name}>
    COMMENT "Building the code of ${name}")
  add_custom_target(${name}_object ALL DEPENDS "${object}")
  set_property(TARGET ${name} PROPERTY FLIP_GEODESICS_OBJECT "${object}")
  set_property(TARGET ${name} PROPERTY FLIP_GEODESICS_LIBRARIES "${arg_LIBRARIES}")
endfunction()

# flip_geodesics_share_instances(target name): compiles `target`, which is linked to CGAL::Flip_geodesics and to no
# optional library that changes what the header declares, with these instances.
function(flip_geodesics_share_instances target name)
  get_property(object TARGET ${name} PROPERTY FLIP_GEODESICS_OBJECT)
  get_property(libraries TARGET ${name} PROPERTY FLIP_GEODESICS_LIBRARIES)
  target_precompile_headers(${target} REUSE_FROM ${name})
  target_compile_options(${target} PRIVATE -O0)
  # The object contains code of the headers of GMP as well.
  target_link_libraries(${target} PRIVATE ${libraries} "${object}" gmpxx)
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${object}")
  # With Ninja, only linking waits for the object; with other generators, compilation waits for it as well.
  if(NOT CMAKE_GENERATOR MATCHES "Ninja")
    add_dependencies(${target} ${name}_object)
  endif()
endfunction()
