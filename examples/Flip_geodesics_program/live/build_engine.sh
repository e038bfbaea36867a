#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# build_engine.sh FILE: compiles the engine of the live page to WebAssembly, with Emscripten, and writes FILE.sources, the
# SHA-256 of what went into it. CGAL is used without GMP and MPFR; the headers of CGAL, Boost and Eigen are looked for in
# /usr/include and in the folders of CPATH.
set -euo pipefail

target=$1
here=$(cd "$(dirname "$0")" && pwd)
program=$(dirname "$here")
root=$(cd "$program/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Emscripten's own headers come first: of the system's only those of libraries without code are seen.
mkdir "$work/include"
IFS=: read -r -a folders <<< "${CPATH:-}:/usr/include:/usr/local/include"
for library in CGAL boost eigen3; do
  for folder in "${folders[@]}"; do
    if [ -d "$folder/$library" ] && [ ! -e "$work/include/$library" ]; then ln -s "$folder/$library" "$work/include/$library"; fi
  done
done

# -O2: with -Oz isolines and curves take three to six times as long, and the page is 0.2 megabytes smaller.
# WebAssembly rounds to nearest only, which is enough for the library; CGAL's intervals are told.
flags=(-std=c++17 -O2 -fwasm-exceptions -DNDEBUG -DCGAL_NDEBUG -DCGAL_DISABLE_GMP -DCGAL_DISABLE_MPFR
  -DCGAL_ALWAYS_ROUND_TO_NEAREST -DBOOST_ALL_NO_LIB "-I$root/include" "-I$program" -isystem "$work/include" -isystem "$work/include/eigen3"
  "-ffile-prefix-map=$work/=" "-ffile-prefix-map=$root/=") # what is thrown names files, but not those of one machine
objects=()
for source in live/engine.cpp run/engine_certified.cpp run/field_curves.cpp run/inserted_curves.cpp run/other_ways.cpp \
  run/slit_surface.cpp run/traced_curves.cpp; do
  object=$work/$(basename "$source").o
  emcc "${flags[@]}" -MMD -MF "$object.d" -c "$program/$source" -o "$object"
  objects+=("$object")
done
emcc -O2 -fwasm-exceptions --no-entry -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=2GB "${objects[@]}" -o "$work/engine.wasm"
cd "$root"
sed 's/\\$//' "$work"/*.d | tr -s ' ' '\n' | grep -F "$root/" | xargs realpath --relative-to=. | grep -v '\.cpp\.o' | sort -u \
  | cat - <(realpath --relative-to=. "$here/build_engine.sh") | xargs sha256sum | awk '{ print $2, $1 }' > "$work/sources"
cd - > /dev/null
mv "$work/engine.wasm" "$target"
mv "$work/sources" "$target.sources"
