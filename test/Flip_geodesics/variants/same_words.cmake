# SPDX-License-Identifier: LGPL-3.0-or-later
#
# One program, built for other processors as well, has to give the same results each time: as the others are built; with
# products and sums rounded in one operation wherever g++ likes; for 32 bits, if there are such libraries; and by clang++
# without optimization.
function(flip_geodesics_add_same_words target options)
  add_executable(${target} variants/same_words.cpp)
  target_link_libraries(${target} PRIVATE Flip_geodesics_warnings Flip_geodesics_without_gmp)
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE ${options})
  target_link_options(${target} PRIVATE ${options})
  add_test(NAME ${target} COMMAND ${target})
  set_tests_properties(${target} PROPERTIES TIMEOUT ${timeout})
  set(variants ${variants} ${target} PARENT_SCOPE)
endfunction()

flip_geodesics_add_same_words(same_words "")
include(CheckCXXSourceCompiles)
set(fused_options -O2 -march=native -ffp-contract=fast)
foreach(variant IN ITEMS "fused;${fused_options}" "32_bit;-m32;-msse2;-mfpmath=sse")
  list(POP_FRONT variant name)
  list(JOIN variant " " CMAKE_REQUIRED_FLAGS)
  check_cxx_source_compiles("#include <sstream>\nint main() { return std::stringstream().str().empty() ? 0 : 1; }"
                            FLIP_GEODESICS_HAS_${name})
  unset(CMAKE_REQUIRED_FLAGS)
  if(name STREQUAL "fused" AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    continue() # with fused operations of clang++, the words of one tree are others
  elseif(FLIP_GEODESICS_HAS_${name})
    flip_geodesics_add_same_words(same_words_${name} "${variant}")
  else()
    message(STATUS "Flip_geodesics: same words are NOT tested with ${variant}")
  endif()
endforeach()

# The same by another compiler, with options of its own.
function(flip_geodesics_add_same_words_by target compiler)
  set(program "${CMAKE_CURRENT_BINARY_DIR}/${target}")
  set(directories $<TARGET_PROPERTY:same_words,INCLUDE_DIRECTORIES>)
  set(definitions $<TARGET_PROPERTY:same_words,COMPILE_DEFINITIONS>)
  add_custom_command(
    OUTPUT "${program}"
    COMMAND
      ${CMAKE_CXX_COMPILER_LAUNCHER} "${compiler}" -std=c++17 ${ARGN} "-I$<JOIN:${directories},;-I>"
      "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>" -MD -MF "${program}.d" -c -o "${program}.o"
      "${CMAKE_CURRENT_SOURCE_DIR}/variants/same_words.cpp"
    COMMAND "${compiler}" -o "${program}" "${program}.o"
    DEPENDS variants/same_words.cpp
    DEPFILE "${program}.d"
    COMMAND_EXPAND_LISTS VERBATIM)
  add_custom_target(${target}_program ALL DEPENDS "${program}")
  add_test(NAME ${target} COMMAND "${program}")
  set_tests_properties(${target} PROPERTIES TIMEOUT ${timeout})
  set(variants ${variants} ${target} PARENT_SCOPE)
endfunction()

find_program(FLIP_GEODESICS_CLANG clang++)
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND FLIP_GEODESICS_CLANG)
  flip_geodesics_add_same_words_by(same_words_clang "${FLIP_GEODESICS_CLANG}" -O0)
elseif(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(STATUS "Flip_geodesics: same words are NOT tested with clang++ beside another compiler")
endif()
