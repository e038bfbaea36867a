# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Installs the package into an empty prefix, then configures, builds and runs the project of this folder against it.
# Arguments: build_dir and source_dir of the package, its version, whether it has_compiled the library, the
# object_extension, and the generator, make_program, compiler, launcher, flags, build_flags (those of its build type) and
# cgal_dir that it was configured with.

cmake_minimum_required(VERSION 3.16)

set(work_dir "${build_dir}/consumer")
set(prefix "${work_dir}/prefix")
file(REMOVE_RECURSE "${work_dir}")

# run(what command...): stops with the output of the command if it fails.
function(run what)
  execute_process(
    COMMAND ${ARGN}
    RESULT_VARIABLE status
    OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what} failed (${status}):\n${output}")
  endif()
  message(STATUS "${what}: done")
  set(output "${output}" PARENT_SCOPE)
endfunction()

run("install" "${CMAKE_COMMAND}" --install "${build_dir}" --prefix "${prefix}")

file(GLOB_RECURSE installed "${prefix}/*")
list(FILTER installed EXCLUDE REGEX "\\.(a|lib)$") # with assertions, which name their source
foreach(file IN LISTS installed)
  file(READ "${file}" text)
  string(FIND "${text}" "${source_dir}" position)
  if(NOT position EQUAL -1)
    message(FATAL_ERROR "${file} cannot be moved to another machine: it names ${source_dir}")
  endif()
endforeach()

# Copied, so that no relative path leads back to the package's sources.
file(COPY "${CMAKE_CURRENT_LIST_DIR}/CMakeLists.txt" "${CMAKE_CURRENT_LIST_DIR}/main.cpp"
     "${CMAKE_CURRENT_LIST_DIR}/one_topic.cpp" "${CMAKE_CURRENT_LIST_DIR}/part.cpp"
     DESTINATION "${work_dir}/source")
set(options -G "${generator}" -D "CMAKE_MAKE_PROGRAM=${make_program}" -D "CMAKE_CXX_COMPILER=${compiler}"
            -D "CMAKE_CXX_COMPILER_LAUNCHER=${launcher}" -D "CMAKE_CXX_FLAGS=${flags}" -D CMAKE_BUILD_TYPE=Release -D "CMAKE_CXX_FLAGS_RELEASE=${build_flags} -DNDEBUG"
            -D "CGAL_DIR=${cgal_dir}" -D "CMAKE_PREFIX_PATH=${prefix}")
run("configure" "${CMAKE_COMMAND}" -S "${work_dir}/source" -B "${work_dir}/build" ${options})

load_cache("${work_dir}/build" READ_WITH_PREFIX consumer_ Flip_geodesics_DIR)
string(FIND "${consumer_Flip_geodesics_DIR}" "${prefix}" position)
if(NOT position EQUAL 0)
  message(FATAL_ERROR "found ${consumer_Flip_geodesics_DIR} instead of the package in ${prefix}")
endif()

run("build" "${CMAKE_COMMAND}" --build "${work_dir}/build")
# Linked to the compiled library, a program has the same results, and no instance of its own of what the library has.
foreach(program main one_topic)
  run("run ${program}" "${work_dir}/build/${program}")
  message(STATUS "version ${version}: ${output}")
  if(has_compiled)
    set(printed "${output}")
    run("run ${program} with the compiled library" "${work_dir}/build/compiled_${program}")
    if(NOT output STREQUAL printed)
      message(FATAL_ERROR "${program} with the compiled library: ${output}")
    endif()
    set(objects "${work_dir}/build/CMakeFiles")
    file(SIZE "${objects}/${program}.dir/${program}.cpp${object_extension}" size)
    file(SIZE "${objects}/compiled_${program}.dir/${program}.cpp${object_extension}" compiled_size)
    math(EXPR half "${size} / 2")
    if(NOT compiled_size LESS half)
      message(FATAL_ERROR "${program}: ${compiled_size} bytes for the compiled library, ${size} bytes without it")
    endif()
  endif()
endforeach()

# As a part of the project, without an install.
set(options ${options} -D "PACKAGE_SOURCE=${source_dir}" -D FLIP_GEODESICS_BUILD_TESTS=OFF
            -D FLIP_GEODESICS_BUILD_EXAMPLES=OFF)
run("configure as a part" "${CMAKE_COMMAND}" -S "${work_dir}/source" -B "${work_dir}/part" ${options})
run("build as a part" "${CMAKE_COMMAND}" --build "${work_dir}/part" --target part)
run("run as a part" "${work_dir}/part/part")

find_program(pkg_config pkg-config)
if(pkg_config)
  set(ENV{PKG_CONFIG_PATH} "${prefix}/share/pkgconfig")
  run("pkg-config" "${pkg_config}" --modversion Flip_geodesics)
  set(found "${output}")
  run("pkg-config" "${pkg_config}" --cflags Flip_geodesics)
  string(REGEX MATCH "-I([^ ]*)" include "${output}")
  if(NOT EXISTS "${CMAKE_MATCH_1}/CGAL/Flip_geodesics.h" OR NOT found MATCHES "^${version}\n")
    message(FATAL_ERROR "pkg-config says ${found} and ${output}")
  endif()
endif()
