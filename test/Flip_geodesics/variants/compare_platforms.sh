#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Builds platform.cpp for each platform whose tools are installed, and compares its output with the native one, bit by bit.
#
#   bash compare_platforms.sh BUILD_DIR
#
# Environment: CGAL_INCLUDE_DIR and BOOST_INCLUDE_DIR (default: /usr/include); LAUNCHER, put before each compiler.

set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
mkdir -p "$1"
build_dir=$(cd "$1" && pwd)

# Cross compilers must not see the native headers beside those of CGAL and Boost.
headers=$build_dir/headers
mkdir -p "$headers"
ln -sfn "${CGAL_INCLUDE_DIR:-/usr/include}/CGAL" "$headers/CGAL"
ln -sfn "${BOOST_INCLUDE_DIR:-/usr/include}/boost" "$headers/boost"

# What the target CGAL::Flip_geodesics passes on, see CMakeLists.txt.
options=(-std=c++17 -O1 -ffp-contract=off -Wno-psabi -I "$root/include" -I "$root/test/Flip_geodesics" -isystem "$headers")

skipped=0
failed=0

# build_and_run(name, emulator, compiler...): the output of the program is in NAME.txt. Fails if there are no such tools.
build_and_run() {
  local name=$1 emulator=$2
  shift 2
  command -v "$1" > /dev/null || return 1
  [ -z "$emulator" ] || command -v "${emulator%% *}" > /dev/null || return 1
  echo '#include <vector>
        int main() { return std::vector<int>(1).back(); }' > "$build_dir/probe.cpp"
  "$@" -std=c++17 -o "$build_dir/$name.exe" "$build_dir/probe.cpp" > /dev/null 2>&1 || return 1
  $emulator "$build_dir/$name.exe" > /dev/null 2>&1 || return 1
  ${LAUNCHER-} "$@" "${options[@]}" -c -o "$build_dir/$name.o" "$here/platform.cpp" &&
    "$@" -o "$build_dir/$name.exe" "$build_dir/$name.o" &&
    $emulator "$build_dir/$name.exe" 2> "$build_dir/$name.err" | tr -d '\r' > "$build_dir/$name.txt" || return 2
}

# compare(name, emulator, compiler...)
compare() {
  local name=$1 status=0
  build_and_run "$@" || status=$?
  if [ $status -eq 1 ]; then
    echo "SKIPPED  $name: the compiler, its libraries or the emulator are not installed"
    skipped=$((skipped + 1))
  elif [ $status -ne 0 ]; then
    echo "FAILED   $name: the program was not built, or did not run"
    failed=$((failed + 1))
  elif ! cmp -s "$build_dir/native.txt" "$build_dir/$name.txt"; then
    echo "FAILED   $name: $(diff "$build_dir/native.txt" "$build_dir/$name.txt" | grep -c '^<') of" \
      "$(wc -l < "$build_dir/native.txt") lines differ from the native ones"
    failed=$((failed + 1))
  else
    echo "same     $name"
  fi
}

build_and_run native "" "${CXX:-g++}"
compare fused "" g++ -march=native
compare clang "" clang++
compare libcxx "" clang++ -stdlib=libc++
# Debian has the headers of the kernel for both sizes in one folder, which only g++-multilib links to.
compare 32_bit "" g++ -m32 -msse2 -mfpmath=sse -idirafter "/usr/include/$(g++ -dumpmachine)"
compare aarch64 "qemu-aarch64 -L /usr/aarch64-linux-gnu" aarch64-linux-gnu-g++
compare mingw "env WINEDEBUG=-all wine" x86_64-w64-mingw32-g++-posix -static
echo "$failed platforms differ, $skipped skipped"
[ $failed -eq 0 ]
