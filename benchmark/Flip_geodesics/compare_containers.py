#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Compares the times of typical tasks with containers of the package and with containers of libraries.

    compare_containers.py [--rounds N] [--compiler C++] [--only CONTAINER]... [--mesh FILE]

Each header in the folder library_containers has the same interface as an internal header of that name, over the
standard library or Boost, and is put before it on the include path. Each round runs a task both ways, one after
the other. The ratio is the time with the library to the time with the package; results are compared as well.
"""

import argparse
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
TASKS = {  # of each container: what stands in its place, and tasks with how many runs they measure
    "Heap_of_four": ("std::push_heap", [("edge_path", 60), ("shortest_path", 8), ("tree", 6)]),
    "Block_array": ("boost::container::deque", [("path", 400), ("shortest_path", 8), ("tree", 6), ("history", 2)]),
}


def compile_tasks(compiler, folder, container=None):
    """The program of the tasks, with a container of the package replaced."""
    program = folder / (container or "package")
    includes = []
    if container:
        (header,) = (ROOT / "include").glob(f"CGAL/Flip_geodesics/internal/*/{container}.h")
        shadow = folder / f"{container}_include"
        place = shadow / header.relative_to(ROOT / "include")
        place.parent.mkdir(parents=True)
        shutil.copy(HERE / "library_containers" / f"{container}.h", place)
        includes = ["-I", str(shadow)]
    command = [*compiler.split(), "-std=c++17", "-O2", "-DNDEBUG", *includes, "-I", str(ROOT / "include"), "-I", str(HERE),
               str(HERE / "container_tasks.cpp"), "-o", str(program), "-lgmp", "-lmpfr"]
    subprocess.run(command, check=True)
    return program


def run(program, task, count, mesh):
    """The result of a task, and its seconds."""
    command = [str(program), task, str(count), *mesh]
    result, seconds = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    return result, float(seconds)


def compare(package, library, container, rounds, mesh):
    """Prints a line for each task of a container; false if results differ."""
    name, tasks = TASKS[container]
    is_same = True
    for task, count in tasks:
        times = []
        for _ in range(rounds):
            (own, own_time), (other, other_time) = run(package, task, count, mesh), run(library, task, count, mesh)
            is_same = is_same and own == other
            times.append((own_time, other_time, other_time / own_time))
        own_time, other_time, ratio = (statistics.median(column) for column in zip(*times))
        spread = f"{min(t[2] for t in times):.2f} to {max(t[2] for t in times):.2f}"
        print(f"| `{container}` | {name} | {task} | {1e3 * own_time / count:.3g} | {1e3 * other_time / count:.3g} "
              f"| {ratio:.2f} | {spread} |", flush=True)
    return is_same


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=7, help="runs of each task with each container (default: 7)")
    parser.add_argument("--compiler", default="c++", help="the compiler, with its options (default: c++)")
    parser.add_argument("--only", action="append", choices=TASKS, help="compare this container (default: all)")
    parser.add_argument("--mesh", default=None, help="a mesh to measure on (default: a torus of 100 000 vertices)")
    arguments = parser.parse_args()
    mesh = [arguments.mesh] if arguments.mesh else []
    is_same = True
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        package = compile_tasks(arguments.compiler, folder)
        print("| container | library | task | package (ms) | library (ms) | ratio | from, to |\n|---|---|---|---:|---:|---:|---|")
        for container in arguments.only or TASKS:
            library = compile_tasks(arguments.compiler, folder, container)
            is_same = compare(package, library, container, arguments.rounds, mesh) and is_same
    if not is_same:
        print("results differ", file=sys.stderr)
    return 0 if is_same else 1


if __name__ == "__main__":
    sys.exit(main())
