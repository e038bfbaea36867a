# SPDX-License-Identifier: LGPL-3.0-or-later
#
# One program, built for other processors as well, has to give the same results each time: as the others are built; with
# products and sums rounded in one operation wherever the compiler likes; for 32 bits, if there are such libraries; and by
# clang++ without optimization, if it is installed and the others are built by another compiler.
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
foreach(variant IN ITEMS "fused;-O2;-march=native;-ffp-contract=fast" "32_bit;-m32;-msse2;-mfpmath=sse")
  list(POP_FRONT variant name)
  list(JOIN variant " " CMAKE_REQUIRED_FLAGS)
  check_cxx_source_compiles("#include <vector>\nint main() { return std::vector<int>(1).back(); }"
                            FLIP_GEODESICS_HAS_${name})
  unset(CMAKE_REQUIRED_FLAGS)
  if(FLIP_GEODESICS_HAS_${name})
    flip_geodesics_add_same_words(same_words_${name} "${variant}")
  else()
    message(STATUS "Flip_geodesics: same words are NOT tested with ${variant}")
  endif()
endforeach()

find_program(FLIP_GEODESICS_CLANG clang++)
if(FLIP_GEODESICS_CLANG AND NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  set(program "${CMAKE_CURRENT_BINARY_DIR}/same_words_clang")
  set(directories $<TARGET_PROPERTY:same_words,INCLUDE_DIRECTORIES>)
  set(definitions $<TARGET_PROPERTY:same_words,COMPILE_DEFINITIONS>)
  add_custom_command(
    OUTPUT "${program}"
    COMMAND
      ${CMAKE_CXX_COMPILER_LAUNCHER} "${FLIP_GEODESICS_CLANG}" -std=c++17 -O0 "-I$<JOIN:${directories},;-I>"
      "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>" -MD -MF "${program}.d" -c -o "${program}.o"
      "${CMAKE_CURRENT_SOURCE_DIR}/variants/same_words.cpp"
    COMMAND "${FLIP_GEODESICS_CLANG}" -o "${program}" "${program}.o"
    DEPENDS variants/same_words.cpp
    DEPFILE "${program}.d"
    COMMAND_EXPAND_LISTS VERBATIM)
  add_custom_target(same_words_by_clang ALL DEPENDS "${program}")
  add_test(NAME same_words_clang COMMAND "${program}")
  set_tests_properties(same_words_clang PROPERTIES TIMEOUT ${timeout})
  list(APPEND variants same_words_clang)
else()
  message(STATUS "Flip_geodesics: same words are NOT tested with clang++ beside another compiler")
endif()
