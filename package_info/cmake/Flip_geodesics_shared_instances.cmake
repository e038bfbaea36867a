# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Instances of templates that programs share, for clang++ 11 or newer: they are part of a precompiled header
# (shared_instances.h), and their code is made once, in an object that the programs are linked to. A program compiles in
# a fifth of the time that it takes otherwise.

# The objects are large; LLVM's linker takes a quarter of the time of the default one.
find_program(FLIP_GEODESICS_LLD ld.lld)
mark_as_advanced(FLIP_GEODESICS_LLD)
if(FLIP_GEODESICS_LLD)
  add_link_options(-fuse-ld=lld)
endif()

# flip_geodesics_add_shared_instances(name level [DEFINITIONS macro...] [LIBRARIES target...] [HEADERS file...])
#
# Adds instances with these macros and libraries, and code of this level of optimization. The programs get the libraries
# as well, but not that level. The headers are precompiled together with the instances.
function(flip_geodesics_add_shared_instances name level)
  cmake_parse_arguments(arg "" "" "DEFINITIONS;LIBRARIES;HEADERS" ${ARGN})
  set(dir "${PROJECT_BINARY_DIR}/${name}")
  file(CONFIGURE OUTPUT "${dir}/nothing.cpp" CONTENT "") # stays as it is, and what is made of it
  add_library(${name} OBJECT "${dir}/nothing.cpp")
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
  target_link_libraries(${name} PRIVATE CGAL::Flip_geodesics Flip_geodesics_warnings ${arg_LIBRARIES})
  target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
  # Their code is not made where the header is used, but here.
  target_compile_options(${name} PRIVATE "SHELL:-Xclang -fmodules-codegen" -O0)
  target_precompile_headers(${name} PRIVATE "${PROJECT_SOURCE_DIR}/package_info/cmake/shared_instances.h"
                            ${arg_HEADERS})

  get_target_property(target_dir ${name} BINARY_DIR)
  set(object "${dir}/${name}${CMAKE_CXX_OUTPUT_EXTENSION}")
  separate_arguments(flags NATIVE_COMMAND "${CMAKE_CXX_FLAGS}")
  # Optimized, but made into machine code without optimization: that takes half the time, and tests run little longer.
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
  # The code of headers of GMP is there as well.
  target_link_libraries(${target} PRIVATE ${libraries} "${object}" gmpxx)
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${object}")
  # Ninja knows how the object is made and has the link alone wait for it, others have the sources wait as well.
  if(NOT CMAKE_GENERATOR MATCHES "Ninja")
    add_dependencies(${target} ${name}_object)
  endif()
endfunction()
