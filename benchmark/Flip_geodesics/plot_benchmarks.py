#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws the tables of run_benchmarks.py as SVG with gnuplot, and prints their medians.

    plot_benchmarks.py --tables FOLDER --out doc/Flip_geodesics/fig

benchmark_stages.svg     times of the stages of a query against the segments of its edge path
benchmark_size.svg       medians of the same against the size of the mesh
benchmark_flips.svg      flips against segments, from shortest edge paths and from those that look back
benchmark_opponents.svg  the time of three ways of straightening over that of Dijkstra's algorithm, sorted
benchmark_detours.svg    the same from starts that are far from the geodesic
"""

import argparse
import collections
import csv
import math
import pathlib
import statistics
import subprocess

STAGES = ["dijkstra_s", "search_s", "shorten_s", "extract_s", "certify_s", "fresh_s"]
COLORS = {"dijkstra": "#888888", "search": "#0072b2", "shorten": "#d55e00", "extract": "#009e73", "certify": "#cc79a7",
          "fresh": "#000000"}
TITLES = {"dijkstra": "Dijkstra's algorithm", "fresh": "a whole call"}


def read_table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def medians(rows, key, columns):
    """Groups rows by a column and takes medians of others: [(group, {column: median, ...}), ...] in order of mention."""
    groups = collections.defaultdict(list)
    for row in rows:
        groups[row[key]].append(row)
    return [(group, {c: statistics.median(float(r[c]) for r in members) for c in columns})
            for group, members in groups.items()]


def exponent(points):
    """The slope of the line through the logarithms of points, by least squares."""
    x, y = [math.log(p[0]) for p in points], [math.log(p[1]) for p in points]
    mean_x, mean_y = statistics.mean(x), statistics.mean(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def draw(path, x_label, y_label, series, logarithmic="xy"):
    """Draws series of (title, style, points) with gnuplot."""
    lines = ['set terminal svg size 720,480 dynamic font "sans,13" background "#ffffff"', f'set output "{path}"',
             "set grid lc rgb '#dddddd'", "set key left top", f'set xlabel "{x_label}"', f'set ylabel "{y_label}"']
    if logarithmic:
        lines.append(f"set logscale {logarithmic}")
    for i, (_, _, points) in enumerate(series):
        lines += [f"$data{i} << EOD", *(f"{x} {y}" for x, y in points), "EOD"]
    lines.append("plot " + ", ".join(f'$data{i} using 1:2 with {style} title "{title}"'
                                     for i, (title, style, _) in enumerate(series)))
    subprocess.run(["gnuplot"], input="\n".join(lines) + "\n", text=True, check=True)


def stage_series(rows, x, style):
    result = []
    for stage in STAGES:
        name = stage[:-2]
        points = [(row[x], 1e3 * float(row[stage])) for row in rows if float(row[stage]) > 0]
        result.append((TITLES.get(name, name), f"{style} lc rgb '{COLORS[name]}'", points))
    return result


def draw_stages(tables, out):
    rows = read_table(tables / "stages_lookback.csv")
    draw(out / "benchmark_stages.svg", "segments of the shortest edge path", "milliseconds",
         stage_series(rows, "edge_segments", "points pt 7 ps 0.3"))
    smooth = [row for row in rows if row["mesh"].startswith("torus")]
    by_size = [{"triangles": size, **m} for size, m in medians(smooth, "triangles", STAGES)]
    draw(out / "benchmark_size.svg", "triangles of the mesh", "milliseconds, median",
         stage_series(by_size, "triangles", "linespoints pt 7 ps 0.6"))


def draw_flips(tables, out):
    series = []
    for search, color in (("astar", "#888888"), ("lookback", "#d55e00")):
        for kind, symbol in (("torus", 7), ("terrain", 6)):
            points = [(float(r["edge_segments"]), float(r["flips"])) for r in read_table(tables / f"stages_{search}.csv")
                      if r["mesh"].startswith(kind) and float(r["flips"]) > 0]
            title = f"{search}, {kind}: m^{{{exponent(points):.2f}}}"
            series.append((title, f"points pt {symbol} ps 0.5 lc rgb '{color}'", points))
    draw(out / "benchmark_flips.svg", "segments m of the shortest edge path", "flips", series)


def draw_opponents(tables, out, name):
    rows = read_table(tables / f"{name}.csv")
    series = []
    for column, title, color in (("flip_out_s", "flips, with the check of the result", "#d55e00"),
                                 ("unfolding_s", "iterative unfolding", "#0072b2"),
                                 ("relaxation_s", "iterative relaxation", "#888888")):
        ratios = sorted(float(r[column]) / float(r["dijkstra_s"]) for r in rows)
        points = [((i + 0.5) / len(ratios), ratio) for i, ratio in enumerate(ratios)]
        series.append((title, f"lines lw 2 lc rgb '{color}'", points))
    draw(out / f"benchmark_{name}.svg", "share of the paths", "time over that of Dijkstra's algorithm", series, "y")
    for method in ("flip_out", "unfolding", "relaxation"):
        good = sum(int(r[method + "_geodesic"]) for r in rows)
        ratio = statistics.median(float(r[method + "_s"]) / float(r["dijkstra_s"]) for r in rows)
        print(f"{name}, {method}: geodesic {good} of {len(rows)}, time over Dijkstra {ratio:.3g}")


def time_of_a_flip(rows):
    """Nanoseconds, all that FlipOut does included, on paths of 50 to 300 segments; NaN if there are none."""
    rows = [row for row in rows if 50 <= int(row["segments"]) <= 300]
    flips = sum(int(row["flips"]) for row in rows)
    return 1e9 * sum(float(row["steps_s"]) for row in rows) / flips if flips else math.nan


def print_stages(tables):
    print("mesh | triangles | m | flips | " + " | ".join(s[:-2] + " ms" for s in STAGES) +
          " | query over Dijkstra | all of it over Dijkstra | a flip of the steps, ns")
    for search in ("lookback", "astar"):
        rows = read_table(tables / f"stages_{search}.csv")
        for row in rows:
            row["ratio"] = sum(float(row[s]) for s in ("search_s", "shorten_s", "extract_s")) / float(row["dijkstra_s"])
            row["fresh_ratio"] = float(row["fresh_s"]) / float(row["dijkstra_s"])
        for mesh, m in medians(rows, "mesh", ["triangles", "edge_segments", "flips", "ratio", "fresh_ratio", *STAGES]):
            flip = time_of_a_flip([row for row in rows if row["mesh"] == mesh]) if search == "astar" else math.nan
            print(f"{search} {mesh} | {m['triangles']:.0f} | {m['edge_segments']:.0f} | {m['flips']:.0f} | " +
                  " | ".join(f"{1e3 * m[s]:.3g}" for s in STAGES) +
                  f" | {m['ratio']:.3f} | {m['fresh_ratio']:.3f} | {flip:.0f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tables", type=pathlib.Path, required=True, help="the folder of run_benchmarks.py")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="the folder for the figures")
    arguments = parser.parse_args()
    draw_stages(arguments.tables, arguments.out)
    draw_flips(arguments.tables, arguments.out)
    for name in ("opponents", "detours"):
        draw_opponents(arguments.tables, arguments.out, name)
    print_stages(arguments.tables)


if __name__ == "__main__":
    main()
