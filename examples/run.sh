#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Builds flip_geodesics and runs it on real meshes and a generated one, from nothing, on Debian 12, Ubuntu 24.04 or newer.
#
#   bash examples/run.sh                with two processors, the first geodesic takes half a minute, and the
#                                       whole script three minutes
#   bash examples/run.sh --no-install   installs nothing; prints the command that installs what is missing
#
# Environment: BUILD_DIR (default: build/ in the repository) takes everything that is written, JOBS is the number of
# parallel jobs (default: one per processor).

set -euo pipefail

install_options=()
for option in "$@"; do
  case "$option" in
    --no-install) install_options=(--no-install) ;;
    *) echo "usage: bash examples/run.sh [--no-install]" >&2; exit 2 ;;
  esac
done

packages=(g++ cmake ninja-build libcgal-dev libgmp-dev libmpfr-dev libtbb-dev libcli11-dev zlib1g-dev libcgal-demo)

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/package_info/install_packages.sh"
build_dir=${BUILD_DIR:-$root/build}
mkdir -p "$build_dir"
build_dir=$(cd "$build_dir" && pwd)
work=$build_dir/examples
data=$work/data
results=$work/results
first=$work/first # a build folder of its own for the program of README.md, which does not wait for the others
program=$work/examples/Flip_geodesics_program/flip_geodesics
checker=$work/benchmark/Flip_geodesics/check_polylines
jobs=${JOBS:-$(nproc 2>/dev/null || echo 2)}

patience="" # a command before builds that can wait

fail() { echo "examples/run.sh: $*" >&2; exit 1; }

# For a first look: -O1 takes three quarters of the time of -O2 to compile, and queries take some 10 % longer. g++ is faster
# with more memory.
optimized="-O1 -DNDEBUG --param=ggc-min-heapsize=500000"

# build(folder, jobs, options of cmake... -- targets...): configures and builds. Sources of a program that instantiate the
# same templates are compiled as one.
build() {
  local dir=$1 jobs=$2 options=()
  shift 2
  while [ "$1" != -- ]; do
    options+=("$1")
    shift
  done
  shift
  # A build folder keeps the generator that it was made with.
  if command -v ninja > /dev/null && ! [ -f "$dir/Makefile" ]; then
    options+=(-G Ninja)
  fi
  mkdir -p "$dir"
  cmake -S "$root" -B "$dir" -D CMAKE_BUILD_TYPE=Release -D "CMAKE_CXX_FLAGS_RELEASE=$optimized" \
    -D FLIP_GEODESICS_UNITE_SOURCES=ON -D FLIP_GEODESICS_BUILD_EXAMPLES=ON -D FLIP_GEODESICS_BUILD_TESTS=OFF \
    -D FLIP_GEODESICS_BUILD_BENCHMARKS=OFF ${options[@]+"${options[@]}"} > "$dir/build.log" 2>&1 ||
    { tail -n 40 "$dir/build.log" >&2; fail "configuring failed; see $dir/build.log"; }
  $patience cmake --build "$dir" -j "$jobs" --target "$@" >> "$dir/build.log" 2>&1 ||
    { tail -n 40 "$dir/build.log" >&2; fail "building $* failed; see $dir/build.log"; }
}

build_program() { build "$work" "$jobs" -- flip_geodesics check_polylines generate_torus; }

# CGAL's data set is an archive among the documentation of libcgal-demo. Systems that are installed without
# documentation lack the file although they have the package: then it is taken out of the package.
unpack_data() {
  [ -d "$data" ] && [ -n "$(find "$data" -name fandisk.off)" ] && return
  mkdir -p "$data"
  local archive=""
  if command -v dpkg > /dev/null; then
    archive=$( (dpkg -L libcgal-demo libcgal-dev 2> /dev/null || true) | grep -E '/data\.tar\.[a-z0-9]+$' | head -n 1)
    if [ -n "$archive" ] && ! [ -f "$archive" ]; then
      (cd "$data" && apt-get download -q libcgal-demo && dpkg-deb -x libcgal-demo_*.deb .) > /dev/null 2>&1 || true
      archive=$data$archive
    fi
  fi
  [ -f "$archive" ] || fail "the data of the package libcgal-demo were not found; reinstall the package"
  tar -xf "$archive" -C "$data"
}

# Prints the first of the named meshes that the data set has.
find_mesh() {
  local name found
  for name in "$@"; do
    found=$(find "$data" -name "$name" | head -n 1)
    [ -n "$found" ] && echo "$found" && return
  done
  fail "CGAL's data set contains none of $*"
}

# One line of the table, from the statistics and the verdict of the independent checker.
row() { # title, statistics, verdict
  awk -F, -v title="$1" -v verdict="$(sed -nE 's/^.*, ([0-9]+) wrong.*$/\1/p' "$3" | tail -n 1)" '
    function median(values, n,    i, j, v) {
      for(i = 2; i <= n; ++i) {
        v = values[i]
        for(j = i - 1; j >= 1 && values[j] > v; --j)
          values[j + 1] = values[j]
        values[j + 1] = v
      }
      return values[int((n + 1) / 2)]
    }
    NR > 1 {
      ++n
      good += $10 == "LOCALLY_SHORTEST"
      before += $5; after += $6
      segments[n] = $4; flips[n] = $7
      search[n] = $12; shorten[n] = $13; extract[n] = $14
    }
    END {
      printf "%-26s %6d %8d %6s %8.2f %% %9d %7d %9.3f %9.3f %9.3f\n", title, n, good, verdict, 100 * (1 - after / before),
             median(segments, n), median(flips, n), 1e3 * median(search, n), 1e3 * median(shorten, n),
             1e3 * median(extract, n)
    }' "$2"
}

faults=()

# Computes curves on a mesh, has them checked, and adds a row to the table.
run() { # title, file name of the results, format of the viewable file, command, mesh, options
  local title=$1 out=$results/$2 viewer=$results/$2.$3 command=$4 mesh=$5
  shift 5
  "$program" "$command" "$mesh" "$@" --quiet --polylines "$out.polylines" --stats "$out.csv" --mesh "$viewer"
  "$checker" "$mesh" "$out.polylines" --stats "$out.csv" --csv "$out.check.csv" 2> "$out.check.txt" ||
    faults+=("$out.check.csv")
  row "$title" "$out.csv" "$out.check.txt" >> "$results/table.txt"
}

install_packages ${install_options[@]+"${install_options[@]}"} "${packages[@]}"
unpack_data
scan=$(find_mesh bunny00.off refined_elephant.off armadillo.off)
echo "== building the program of README.md and flip_geodesics (logs in $first/build.log and $work/build.log)"
if [ "$jobs" -gt 1 ]; then
  set -m # a process group of its own, that ends with this script
  patience="nice -n 10" build_program & # leaves a processor to the program of README.md
  building=$!
  set +m
  trap 'kill -- "-$building" 2> /dev/null || true' EXIT
fi
build "$first" 1 -D FLIP_GEODESICS_EXAMPLES=readme_example -- readme_example
echo "== the program of README.md: one geodesic on $(basename "$scan")"
"$first/examples/Flip_geodesics/readme_example" "$scan"
if [ "$jobs" -gt 1 ]; then
  echo "== waiting for flip_geodesics"
  wait "$building"
  trap - EXIT
else
  build_program
fi
rm -rf "$results"
mkdir -p "$results"

part=$(find_mesh fandisk.off anchor_dense.off anchor.off)
torus=$results/torus.off
around=400 along=200
"$work/examples/Flip_geodesics_program/generate_torus" "$torus" $around $along
{
  seq -s ' ' 0 $((along - 1))                                # around the tube
  seq -s ' ' 0 $along $((along * around - 1))                # around the hole, outside
  seq -s ' ' $((along / 2)) $along $((along * around - 1))   # around the hole, inside
} > "$results/torus_loops.txt"

echo "== an example: one geodesic on $(basename "$scan")"
"$program" path "$scan" --from 100 --to 20000
echo
echo "== computing"
run "$(basename "$scan"), a scan" scan ply path "$scan" --random 100 --seed 1
run "$(basename "$part"), a CAD part" part obj path "$part" --random 100 --seed 1
run "torus, generated" torus vtp path "$torus" --random 100 --seed 1
run "torus, closed geodesics" torus_loops vtp loop "$torus" --loop "$results/torus_loops.txt"

echo
echo "Geodesics between random vertices, and closed geodesics. The columns from segments on are medians per curve; wrong"
echo "counts the curves that an independent checker rejects."
echo "                                   locally            length                      search   shorten   extract"
echo "mesh                       curves shortest  wrong  reduction  segments   flips        ms        ms        ms"
cat "$results/table.txt"
echo
echo "Surfaces with curves, for example for MeshLab or ParaView:"
ls "$results"/*.ply "$results"/*.obj "$results"/*.vtp
"$program" path "$scan" --random 8 --seed 1 --quiet --page "$results/scan.html"
"$program" loop "$torus" --loop "$results/torus_loops.txt" --quiet --page "$results/torus_loops.html"
echo "HTML pages that show the curves and the flips step by step:"
ls "$results"/*.html
if [ ${#faults[@]} -ne 0 ]; then
  fail "the checker rejects curves; see ${faults[*]}"
fi
