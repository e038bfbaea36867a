#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Measures the processor time and the memory that compiling a program that uses the package takes.

    measure_compiling.py [--rounds N] [--compiler C++] [--option O]... [--include DIR]

Each round compiles every program once, in turn. The table has medians, and ratios to a program that only reads a mesh.
Nothing is linked: the last program is compiled as for the library CGAL::Flip_geodesics_compiled.
"""

import argparse
import os
import pathlib
import re
import statistics
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]

MESH = """#include <CGAL/{kernel}.h>
#include <CGAL/Surface_mesh.h>
{includes}
using Mesh = CGAL::Surface_mesh<CGAL::{type}::Point_3>;
"""
READ = """#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <iostream>
#include <iterator>
#include <vector>
"""
PATH = "#include <CGAL/Flip_geodesics/geodesic_path.h>\n"
MAIN = """
int main(int argc, char** argv)
{{
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || mesh.is_empty())
    return 1;
  std::vector<Mesh::Point> path;
  {body}
  std::cout << path.size() << '\\n';
}}
"""
ENDS = "*mesh.vertices().begin(), *--mesh.vertices().end()"


def cartesian(includes):
    return MESH.format(kernel="Simple_cartesian", type="Simple_cartesian<double>", includes=includes)


def filtered(includes):
    name = "Exact_predicates_inexact_constructions_kernel"
    return MESH.format(kernel=name, type=name, includes=includes)


def readme():
    text = (ROOT / "README.md").read_text()
    return re.search(r"```cpp\n(.*?)```", text, re.S).group(1)


def programs():
    """Title, source and options of each program."""
    shortest = """using Traits = CGAL::Surface_mesh_shortest_path_traits<CGAL::{0}, Mesh>;
  CGAL::Surface_mesh_shortest_path<Traits> search(mesh);
  search.add_source_point(*mesh.vertices().begin());
  search.shortest_path_points_to_source_points(*--mesh.vertices().end(), std::back_inserter(path));""".format(
        "Exact_predicates_inexact_constructions_kernel")
    in_double = f"""CGAL::Flip_geodesics::geodesic_path(mesh, {ENDS}, std::back_inserter(path),
    CGAL::parameters::geom_traits(
        CGAL::Flip_geodesics::Intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>()));"""
    compiled = ["-DCGAL_FLIP_GEODESICS_COMPILED"]
    return [
        ("Surface_mesh alone", cartesian("") + "int main() { return Mesh().is_empty() ? 0 : 1; }\n", []),
        ("reading a polygon mesh", cartesian(READ) + MAIN.format(body=""), []),
        ("the same and Surface_mesh_shortest_path",
         filtered(READ + "#include <CGAL/Surface_mesh_shortest_path.h>\n") + MAIN.format(body=shortest), []),
        ("the same and geodesic_path(), in double", cartesian(READ + PATH) + MAIN.format(body=in_double), []),
        ("the program of README.md", readme(), []),
        ("the program of README.md, compiled library", readme(), compiled),
    ]


def compile_once(command):
    """Seconds of the processor in user mode, and megabytes."""
    pid = os.posix_spawnp(command[0], command, os.environ)
    _, status, usage = os.wait4(pid, 0)
    if status != 0:
        sys.exit("this does not compile: " + " ".join(command))
    return usage.ru_utime, usage.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--option", action="append", default=[])
    parser.add_argument("--include", default=str(ROOT / "include"), help="the folder of the headers")
    arguments = parser.parse_args()
    options = ["-std=c++17", "-O2", "-DCGAL_USE_GMP", "-DCGAL_USE_MPFR", *arguments.option, "-I", arguments.include]
    measured = {}
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "program.cpp"
        for _ in range(arguments.rounds):
            for title, text, more in programs():
                source.write_text(text)
                command = [arguments.compiler, *options, *more, "-c", str(source), "-o", str(source) + ".o"]
                measured.setdefault(title, []).append(compile_once(command))
    seconds = {title: statistics.median(s for s, _ in runs) for title, runs in measured.items()}
    reading = seconds["reading a polygon mesh"]
    print(f"{'program':44} {'s':>6} {'ratio':>6} {'MB':>6}")
    for title, runs in measured.items():
        memory = statistics.median(m for _, m in runs)
        print(f"{title:44} {seconds[title]:6.1f} {seconds[title] / reading:6.2f} {memory:6.0f}")


if __name__ == "__main__":
    main()
