#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs the benchmarks and writes their tables, with machine and compiler, to a folder.

    run_benchmarks.py --programs BUILD/benchmark/Flip_geodesics --out FOLDER [--all] [--meshes FILE...]

Without --all everything is small and done in about 3 minutes; with it, meshes reach 5 million triangles. Real meshes are
read from the CGAL data of Debian's package libcgal-dev, if it is installed; more can be given.

stages_*.csv    the stages of queries, with Dijkstra's algorithm interleaved    query_stages
order.csv       the same as the meshes are numbered, and along a Hilbert curve  query_stages
many.csv        many paths, in one thread and in two                            many_paths
memory.csv      resident memory                                                 memory_use
opponents.csv   flips, iterative unfolding, iterative relaxation                compare_straightening
detours.csv     the same from starts that are far from the geodesic             compare_straightening
kernels.csv     single operations, plain and certified                          kernels
exact.csv       continuous Dijkstra and the heat method                         compare_distance_methods
fields.csv      exact distances of all vertices                                 compare_distance_fields
pairs.csv       shortest paths between random vertices                          shortest_pairs
pairs_landmarks.csv  the same without and with landmarks                         shortest_pairs --landmarks 8
landmarks.csv   landmarks, made in one thread and in two                        making_landmarks
certified.csv   queries with certified and with plain traits, full of ties      certified_queries
every_kind.csv  curves of all kinds on meshes of every kind                     certified_queries --every-kind
rays.csv        straightest geodesics over ten edges                            trace_rays
drags.csv       ends, way points and control points that are dragged            drag_curves
machine.txt     processor, compiler, load at the start
"""

import argparse
import os
import pathlib
import platform
import subprocess
import sys
import tarfile
import tempfile

DEBIAN_DATA = pathlib.Path("/usr/share/doc/libcgal-dev/data.tar.gz")
REAL_MESHES = ["bunny00.off", "refined_elephant.off", "fandisk_large.off", "armadillo.off"]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=pathlib.Path, required=True, help="the folder with the built benchmarks")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="the folder for the tables")
    parser.add_argument("--all", action="store_true", help="large meshes as well; takes about twenty minutes")
    parser.add_argument("--meshes", nargs="*", default=[], help="further mesh files")
    return parser.parse_args()


def unpack_real_meshes(folder):
    """The real meshes of the distribution's package, as paths; none if it is not there."""
    if not DEBIAN_DATA.exists():
        print(f"{DEBIAN_DATA} does not exist; only generated meshes are used", file=sys.stderr)
        return []
    with tarfile.open(DEBIAN_DATA) as archive:
        wanted = ["data/meshes/" + name for name in REAL_MESHES]
        archive.extractall(folder, [m for m in archive.getmembers() if m.name in wanted])
        return [str(pathlib.Path(folder) / name) for name in wanted]


def machine_description(programs):
    """Lines on processor, system, compiler and load."""
    processor = platform.processor() or platform.machine()
    cpuinfo = pathlib.Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for line in cpuinfo.read_text().splitlines():
            if line.startswith("model name"):
                processor = line.split(":", 1)[1].strip()
                break
    lines = [f"processor: {processor}, {os.cpu_count()} cores seen", f"system: {platform.system()} {platform.release()}"]
    cache = next((p / "CMakeCache.txt" for p in [programs, *programs.parents] if (p / "CMakeCache.txt").exists()), None)
    if cache:
        values = dict(line.split("=", 1) for line in cache.read_text().splitlines() if "=" in line and line[0].isalpha())
        values = {key.split(":")[0]: value for key, value in values.items()}
        compiler = values.get("CMAKE_CXX_COMPILER", "c++")
        version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=False).stdout
        flags = " ".join([values.get("CMAKE_CXX_FLAGS", ""), values.get("CMAKE_CXX_FLAGS_RELEASE", "")]).strip()
        lines.append(f"compiler: {version.splitlines()[0] if version else compiler}, {flags}")
    lines.append("load at the start: " + " ".join(f"{x:.1f}" for x in os.getloadavg()))
    return "\n".join(lines) + "\n"


def run(programs, out, name, program, *arguments):
    """Runs a program with its output in a table; a failure ends everything."""
    run_each(programs, out, name, program, [arguments])


def run_each(programs, out, name, program, runs):
    """Runs a program once for each list of arguments, with all output in a table that has one header."""
    rows = []
    for arguments in runs:
        print(f"{name}: {program} {' '.join(map(str, arguments))}", file=sys.stderr)
        result = subprocess.run([str(programs / program), *map(str, arguments)], stdout=subprocess.PIPE, text=True,
                                check=True)
        rows += result.stdout.splitlines(keepends=True)[1 if rows else 0:]
    (out / name).write_text("".join(rows), encoding="utf-8")


def main():
    arguments = parse_arguments()
    arguments.out.mkdir(parents=True, exist_ok=True)
    (arguments.out / "machine.txt").write_text(machine_description(arguments.programs), encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        real = unpack_real_meshes(folder) + arguments.meshes
        sizes = [1e3, 4e3, 16e3, 64e3, 256e3]
        generated = [f"{kind}:{int(size)}" for kind in ("torus", "terrain") for size in sizes]
        subdivided = [f"{mesh}+1" for mesh in real[:1]]
        large_real, large = [], []
        if arguments.all:
            large_real = [f"{mesh}+{k}" for mesh in real[:1] for k in (2, 3)]
            large = [f"{kind}:{size}" for kind in ("torus", "terrain") for size in (1000000, 4000000)] + large_real

        def table(name, program, *options):
            run(arguments.programs, arguments.out, name, program, *options)

        for search in ("lookback", "landmarks", "astar"):
            options = ["--pairs", 15, "--search", search]
            run_each(arguments.programs, arguments.out, f"stages_{search}.csv", "query_stages",
                     [[*options, "--rounds", 5, *generated, *real, *subdivided]] +
                     [[*options, "--rounds", 3, mesh] for mesh in large])
        numbered = [mesh + order for mesh in [*real, *subdivided, *large_real] for order in ("", "~")]
        table("order.csv", "query_stages", "--pairs", 30, "--rounds", 1, *numbered)
        table("many.csv", "many_paths", "--rounds", 5 if arguments.all else 3, *generated[2:5], *real)
        # A process each, since memory that was used once counts as resident afterwards.
        run_each(arguments.programs, arguments.out, "memory.csv", "memory_use",
                 [[mesh] for mesh in [*generated, *real, *subdivided, *large]])
        smooth_and_rough = [*real, "torus:64000", "terrain:64000"]
        table("opponents.csv", "compare_straightening", 30 if arguments.all else 10, *smooth_and_rough)
        # Relaxation takes minutes for some such paths.
        table("detours.csv", "compare_straightening", "--detour", 3, "torus:4000", "torus:16000")
        table("exact.csv", "compare_distance_methods", 3 if arguments.all else 2, "torus:4000", "torus:16000",
              *real[2:3], *(real[:1] if arguments.all else []))
        table("fields.csv", "compare_distance_fields", 3, int(arguments.all), "torus:16000", *real)
        table("pairs.csv", "shortest_pairs", 100 if arguments.all else 20, "torus:16000", *real)
        table("pairs_landmarks.csv", "shortest_pairs", "--landmarks", 8, 100 if arguments.all else 20, "torus:16000",
              *real)
        table("landmarks.csv", "making_landmarks", "--rounds", 9 if arguments.all else 3, "torus:16000", *real)
        table("certified.csv", "certified_queries", "--limit", 1000)
        table("every_kind.csv", "certified_queries", "--every-kind")
        table("drags.csv", "drag_curves", 1000, "torus:1000000", "terrain:1000000", *real)
        table("rays.csv", "trace_rays", 1000000, 10, "torus:16000", "terrain:256000", *real)
        if (arguments.programs / "kernels").exists():
            table("kernels.csv", "kernels", "--benchmark_format=csv", "--benchmark_repetitions=5",
                  "--benchmark_report_aggregates_only=true", "--benchmark_min_time=0.2")


if __name__ == "__main__":
    main()
