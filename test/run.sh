#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Builds and runs the tests, from nothing, on Debian 12, Ubuntu 24.04 or newer.
#
#   bash test/run.sh           every test with g++; headers and smoke tests with clang++ and under sanitizers
#   bash test/run.sh --full    every test with g++, with clang++, and under sanitizers with checked iterators; OpenMesh
#                              and MPI installed as well
#
# Environment: BUILD_DIR (default: build/ in the repository) takes everything that is written, JOBS is the number of
# parallel jobs (default: one per processor), SKIP_INSTALL=1 neither looks for packages nor installs any.

set -euo pipefail

# Run with clang++ and under sanitizers each time, so that each public function is. Few, since each costs half a minute to
# compile twice more.
smoke_tests=(test_checker test_edge_path_graph test_entry_points)

packages=(g++ clang cmake ninja-build ccache libcgal-dev libgmp-dev libmpfr-dev libboost-test-dev libeigen3-dev
          libtbb-dev libcli11-dev zlib1g-dev python3 doxygen)
# Some 250 packages come along with the first and 50 with MPI, therefore not for everybody; the second has the sanitizers
# of clang++.
full_packages=(libopenmesh-dev libclang-rt-dev libboost-mpi-dev openmpi-bin)

full=0
case "${1-}" in
  "") ;;
  --full) full=1 ;;
  *) echo "usage: bash test/run.sh [--full]" >&2; exit 2 ;;
esac

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/package_info/install_packages.sh"
build_dir=${BUILD_DIR:-$root/build}
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
  if ! (cd "$root" && cmake --preset "$preset" -B "$dir" "${generator[@]}" "${launcher[@]}" "$@") \
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
if [ -z "${SKIP_INSTALL-}" ]; then
  install_packages "${packages[@]}"
fi
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
sources=("$root"/test/Flip_geodesics/test_*.cpp)
everything=($((${#sources[@]} + 3)) # on top of the sources: headers, consumer, complete
            -D FLIP_GEODESICS_TESTS=all -D FLIP_GEODESICS_BUILD_EXAMPLES=ON)
smoke=($((${#smoke_tests[@]} + 2)) # on top of them: headers, complete
       -D "FLIP_GEODESICS_TESTS=$(IFS=';' && echo "${smoke_tests[*]}")" -D FLIP_GEODESICS_BUILD_EXAMPLES=OFF)

run_stage test "${everything[@]}"
if [ $full -eq 1 ]; then
  run_stage clang "${everything[@]}"
else
  run_stage clang "${smoke[@]}"
fi
# What compiles is known by now: the headers need no sanitizer.
run_stage asan-ubsan $((smoke[0] - 1)) "${smoke[@]:1}" -D FLIP_GEODESICS_TEST_HEADERS=OFF
if [ $full -eq 1 ]; then
  run_stage checked $((everything[0] - 1)) "${everything[@]:1}" -D FLIP_GEODESICS_TEST_HEADERS=OFF
fi

say "done"
for problem in ${problems[@]+"${problems[@]}"}; do
  echo "FAILED  $problem"
done
echo "$passed passed, $failed failed"
if [ ${#problems[@]} -ne 0 ] || [ "$passed" -eq 0 ]; then
  exit 1
fi
