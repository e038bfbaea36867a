#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Builds and runs the tests, from nothing, on Debian 12, Ubuntu 24.04 or newer.
#
#   bash test/run.sh           every test, each public header alone and every example with clang++, in which tests
#                              share instances of templates; a call of each public function with g++ and under
#                              sanitizers; the program of README.md with g++: some ten minutes with two processors
#   bash test/run.sh --full    in addition every test with all of its cases, each header alone and every example with
#                              g++, optimized with clang++, and under sanitizers with checked iterators; OpenMesh and
#                              MPI installed as well: hours. Compares results bit by bit between compilers and processors:
#                              g++, clang++, libc++, 32 bits, aarch64 under qemu, mingw under wine; skips what is not
#                              installed
#   bash test/run.sh --no-install   installs nothing; prints the command that installs what is missing
#   bash test/run.sh --cgal DIR     with the CGAL that was unpacked in DIR, 5.5 or newer, instead of the installed one
#
# A run that was interrupted continues where it stopped. Environment: BUILD_DIR (default: build/run-tests in the
# repository) takes everything that is written, JOBS is the number of parallel jobs (default: one per processor).

set -euo pipefail

# Run with g++ and under sanitizers each time: calls each public function. Alone, since it takes a minute to compile.
smoke_tests=(test_entry_points)

# The first program of a user, with g++.
examples_with_gcc=(readme_example)

# libclang-rt-dev has the sanitizers of clang++, and lld links in a quarter of the time.
packages=(g++ clang libclang-rt-dev lld cmake ninja-build ccache libcgal-dev libgmp-dev libmpfr-dev libboost-test-dev
          libeigen3-dev libtbb-dev libcli11-dev zlib1g-dev python3 doxygen)
# Some 250 packages come along with the first and 50 with MPI, therefore not for everybody.
full_packages=(libopenmesh-dev libboost-mpi-dev openmpi-bin)

full=0
install_options=()
cgal_options=()
cgal_include_dir=/usr/include
usage() { echo "usage: bash test/run.sh [--full] [--no-install] [--cgal DIR]" >&2; exit 2; }
while [ $# -gt 0 ]; do
  case "$1" in
    --full) full=1 ;;
    --no-install) install_options=(--no-install) ;;
    --cgal)
      [ $# -gt 1 ] || usage
      shift
      config=$(find "$1" -name CGALConfig.cmake 2> /dev/null | sort | head -n 1 || true)
      version=$(find "$1" -path '*/include/CGAL/version.h' 2> /dev/null | head -n 1 || true)
      if [ -z "$config" ] || [ -z "$version" ]; then
        echo "$1 has no CGALConfig.cmake or no include/CGAL/version.h; specify the folder of an unpacked CGAL" >&2
        exit 2
      fi
      cgal_options=(-D "CGAL_DIR=$(cd "$(dirname "$config")" && pwd)")
      cgal_include_dir=$(cd "$(dirname "$version")/.." && pwd)
      ;;
    *) usage ;;
  esac
  shift
done

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/package_info/install_packages.sh"
build_dir=${BUILD_DIR:-$root/build/run-tests}
mkdir -p "$build_dir"
build_dir=$(cd "$build_dir" && pwd)
jobs=${JOBS:-$(nproc 2>/dev/null || echo 2)}
start=$SECONDS

say() { printf '\n== %s  [%d s]\n' "$*" "$((SECONDS - start))"; }

passed=0
failed=0
problems=()

# run_stage(preset, minimum number of tests, further options of cmake...)
run_stage() {
  local preset=$1 minimum=$2 dir=$build_dir/$1 generator=() keep_going=()
  shift 2
  # A build folder keeps the generator that it was made with.
  if command -v ninja > /dev/null && ! [ -f "$dir/Makefile" ]; then
    generator=(-G Ninja)
    keep_going=(0)
  fi
  say "$preset: configure and build"
  if ! (cd "$root" && cmake --preset "$preset" -B "$dir" "${generator[@]}" "${launcher[@]}" \
      ${cgal_options[@]+"${cgal_options[@]}"} "$@") \
    > "$dir.log" 2>&1; then
    cat "$dir.log"
    problems+=("$preset: configuring failed")
    return
  fi
  # Goes on after an error: one broken test does not hide the result of the others.
  cmake --build "$dir" -j "$jobs" -- -k "${keep_going[@]}" || problems+=("$preset: building failed")

  say "$preset: run"
  local log=$dir/ctest.log summary number_failed number_run
  (cd "$dir" && ctest -j "$jobs" --output-on-failure --no-tests=error < /dev/null) 2>&1 | tee "$log" || true
  summary=$(grep -E 'tests? failed out of [0-9]+' "$log" || true)
  number_failed=$(sed -nE 's/.* ([0-9]+) tests? failed out of.*/\1/p' <<< "$summary")
  number_run=$(sed -nE 's/.* failed out of ([0-9]+).*/\1/p' <<< "$summary")
  passed=$((passed + ${number_run:-0} - ${number_failed:-0}))
  failed=$((failed + ${number_failed:-0}))
  if [ "${number_failed:-1}" -ne 0 ]; then
    problems+=("$preset: ${number_failed:-all} of ${number_run:-the} tests failed")
  fi
  if [ "${number_run:-0}" -lt "$minimum" ]; then
    problems+=("$preset: ${number_run:-0} tests ran, at least $minimum were expected")
  fi
}

if [ $full -eq 1 ]; then
  packages+=("${full_packages[@]}")
fi
install_packages ${install_options[@]+"${install_options[@]}"} "${packages[@]}"
launcher=()
if command -v ccache > /dev/null; then
  launcher=(-D CMAKE_CXX_COMPILER_LAUNCHER=ccache)
  export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
  # What it takes to use precompiled headers as well.
  export CCACHE_SLOPPINESS=pch_defines,time_macros
  # What is not in the cache is not preprocessed twice.
  export CCACHE_DEPEND=1
  # Without a home that can be written, the cache goes where everything else goes.
  if ! [ -w "${HOME:-/nonexistent}" ]; then
    export CCACHE_DIR=${CCACHE_DIR:-$build_dir/ccache}
  fi
fi

# Everything is said each time, since a build folder remembers what the last run asked for.
list() { local IFS=';'; echo "$*"; }
sources=("$root"/test/Flip_geodesics/test_*.cpp)
number_of_tests=$((${#sources[@]} + 3)) # on top of the sources: headers, consumer, complete
tests=(-D FLIP_GEODESICS_TESTS=all)
public_headers=(-D FLIP_GEODESICS_TEST_HEADERS=PUBLIC)
all_headers=(-D FLIP_GEODESICS_TEST_HEADERS=ON)
number_of_smoke_tests=$((${#smoke_tests[@]} + 1)) # on top of them: complete
smoke=(-D "FLIP_GEODESICS_TESTS=$(list "${smoke_tests[@]}")")
all_examples=(-D FLIP_GEODESICS_BUILD_EXAMPLES=ON -D FLIP_GEODESICS_EXAMPLES=all)
with_gcc=(-D FLIP_GEODESICS_BUILD_EXAMPLES=ON -D "FLIP_GEODESICS_EXAMPLES=$(list "${examples_with_gcc[@]}")")
# What is compiled with g++ each time is not compiled with clang++ as well; README.md is no source here.
examples=(flip_geodesics $(basename -s .cpp "$root"/examples/Flip_geodesics/*.cpp))
with_clang=(-D FLIP_GEODESICS_BUILD_EXAMPLES=ON -D "FLIP_GEODESICS_EXAMPLES=$(list "${examples[@]}")")
# Nothing is precompiled for so few, and nothing optimized: that is for --full.
smoke_with_gcc=("${smoke[@]}" "${with_gcc[@]}" -D FLIP_GEODESICS_TEST_HEADERS=OFF
                -D FLIP_GEODESICS_PRECOMPILE_HEADERS=OFF -D CMAKE_CXX_FLAGS_RELWITHDEBINFO=-O0)
# What compiles is known when sanitizers run: the headers need none.
no_examples=(-D FLIP_GEODESICS_BUILD_EXAMPLES=OFF -D FLIP_GEODESICS_TEST_HEADERS=OFF)

# The preset asks for clang++. Where that has no sanitizers, g++ has; under them its warnings misfire.
sanitizers=("$number_of_smoke_tests" "${smoke[@]}" "${no_examples[@]}")
if ! clang++ -fsanitize=address,undefined -x c++ -o "$build_dir/sanitized" - <<< 'int main() {}' > /dev/null 2>&1; then
  echo "clang++ has no sanitizers here; using those of g++."
  sanitizers+=(-D CMAKE_CXX_COMPILER=g++ -D FLIP_GEODESICS_WARNINGS_AS_ERRORS=OFF)
fi

run_stage test "$number_of_tests" "${tests[@]}" "${public_headers[@]}" "${with_clang[@]}"
if [ $full -eq 1 ]; then
  run_stage gcc "$number_of_tests" "${tests[@]}" "${all_headers[@]}" "${all_examples[@]}"
  run_stage clang "$number_of_tests" "${tests[@]}" "${all_headers[@]}" "${all_examples[@]}"
  run_stage asan-ubsan "${sanitizers[@]}"
  run_stage thread-sanitizer 2 -D FLIP_GEODESICS_TESTS=test_threads "${no_examples[@]}" # with the test complete
  run_stage checked $((number_of_tests - 1)) "${tests[@]}" "${all_examples[@]}" -D FLIP_GEODESICS_TEST_HEADERS=OFF
  say "platforms: build, run and compare"
  CGAL_INCLUDE_DIR=$cgal_include_dir LAUNCHER=${launcher:+ccache} \
    bash "$root/test/Flip_geodesics/variants/compare_platforms.sh" "$build_dir/platforms" ||
    problems+=("platforms: results differ from the native ones")
else
  run_stage gcc $((number_of_smoke_tests + ${#examples_with_gcc[@]})) "${smoke_with_gcc[@]}"
  run_stage asan-ubsan "${sanitizers[@]}"
fi

say "done"
for problem in ${problems[@]+"${problems[@]}"}; do
  echo "FAILED  $problem"
done
echo "$passed passed, $failed failed"
if [ ${#problems[@]} -ne 0 ] || [ "$passed" -eq 0 ]; then
  exit 1
fi
