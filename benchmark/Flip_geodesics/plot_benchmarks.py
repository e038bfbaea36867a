#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws the tables of run_benchmarks.py as SVG figures in the style of the manual, and prints their medians.

    plot_benchmarks.py --tables FOLDER --out doc/Flip_geodesics/fig

benchmark_stages.svg     times of the stages of a query against the segments of its shortest edge path
benchmark_size.svg       medians of the same against the size of the mesh
benchmark_flips.svg      flips against segments, with and without funnel initialization
benchmark_opponents.svg  the time of three methods of shortening over that of Dijkstra's algorithm
"""

import argparse
import collections
import csv
import math
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "doc/Flip_geodesics"))
from drawing_tools import CURVE, FAINT, LINE, Canvas, Plot  # noqa: E402
from figure_colors import FIXED, INK, MESH, RESULT, SECOND, START  # noqa: E402

STAGES = {"dijkstra_s": ("Dijkstra's algorithm", MESH), "search_s": ("search", SECOND),
          "shorten_s": ("shortening", START), "certify_s": ("certificate", FIXED), "extract_s": ("extraction", INK),
          "fresh_s": ("a whole call", RESULT)}
KINDS = {"torus": ("torus with bumps", RESULT), "terrain": ("rough terrain", SECOND), "": ("real meshes", START)}
METHODS = {"flip_out": ("flips", RESULT), "unfolding": ("iterative unfolding", SECOND),
           "relaxation": ("iterative relaxation", START)}


def read_table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def medians(rows, key, columns):
    """Groups rows by a column and takes medians of others: [(group, {column: median, ...}), ...] in their order."""
    groups = collections.defaultdict(list)
    for row in rows:
        groups[row[key]].append(row)
    return [(group, {c: statistics.median(float(r[c]) for r in members) for c in columns})
            for group, members in groups.items()]


def fit(points):
    """The power and the factor of the line through the logarithms of points, by least squares."""
    x, y = [math.log(p[0]) for p in points], [math.log(p[1]) for p in points]
    mean_x, mean_y = statistics.mean(x), statistics.mean(y)
    power = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)
    return power, math.exp(mean_y - power * mean_x)


def kind_of(row):
    """The key of KINDS for the mesh of a row."""
    return next(kind for kind in KINDS if row["mesh"].startswith(kind))


def draw_legend(canvas, left, top, entries):
    """Names with dots of their colors in one line."""
    for name, color in entries:
        canvas.dot((left, top), color, 5)
        left = canvas.text((left + 10, top), name, anchor="start", size=13) + 28


def ranges(rows, *columns):
    """The smallest and the greatest positive value of some columns."""
    values = [value for row in rows for value in (float(row[column]) for column in columns) if value > 0]
    return min(values), max(values)


def draw_stages(tables, out):
    """A panel for each stage, with one dot for each query."""
    rows = read_table(tables / "stages_lookback.csv")
    canvas = Canvas(440, "The times of the stages of queries against the segments of their shortest edge paths")
    draw_legend(canvas, 66, 14, KINDS.values())
    x_range, (low, high) = ranges(rows, "edge_segments"), ranges(rows, *STAGES)
    for i, (column, (title, _)) in enumerate(STAGES.items()):
        left, top = 62 + 217 * (i % 3), 54 + 188 * (i // 3)
        plot = Plot(canvas, (left, top, left + 200, top + 150), x_range, (1e3 * low, 1e3 * high))
        plot.axes("segments" if i > 2 else "", "milliseconds" if i % 3 == 0 else "")
        canvas.text((left, top - 14), f"({'abcdef'[i]}) {title}", size=13, anchor="start", is_bold=True)
        for kind, (_, color) in KINDS.items():
            plot.dots([(float(row["edge_segments"]), 1e3 * float(row[column])) for row in rows
                       if kind_of(row) == kind and float(row[column]) > 0], color)
    write(canvas, out / "benchmark_stages.svg")


def draw_sizes(tables, out):
    """Medians by the size of the mesh, and the slope of times that are proportional to it."""
    rows = [row for row in read_table(tables / "stages_lookback.csv") if kind_of(row) == "torus"]
    by_size = sorted((float(size), values) for size, values in medians(rows, "triangles", STAGES))
    times = [1e3 * value for _, values in by_size for value in values.values()]
    canvas = Canvas(400, "The times of the stages of queries against the size of the mesh")
    plot = Plot(canvas, (70, 16, 540, 340), (by_size[0][0], by_size[-1][0]), (min(times), max(times)))
    plot.axes("triangles of the mesh", "milliseconds, median")
    labels = []
    for column, (title, color) in STAGES.items():
        points = [(size, 1e3 * values[column]) for size, values in by_size]
        plot.line(points, color, CURVE if column == "fresh_s" else LINE)
        plot.dots(points, color, 6)
        labels.append((plot(points[-1])[1], title, color))
    draw_line_labels(canvas, 552, labels)
    plot.slope_triangle((1e5, 2.5e-3), 1.0)
    write(canvas, out / "benchmark_size.svg")


def draw_line_labels(canvas, left, labels, distance=18):
    """Names at the ends of lines, moved apart."""
    y = -math.inf
    for wanted, title, color in sorted(labels):
        y = max(wanted, y + distance)
        canvas.text((left, y), title, INK if color == MESH else color, anchor="start", size=13)


def draw_flips(tables, out):
    """A panel for each kind of generated meshes, with the fitted powers of the number of segments."""
    starts = (("astar", "shortest edge path", START), ("lookback", "funnel initialization", RESULT))
    rows = {table: read_table(tables / f"stages_{table}.csv") for table, _, _ in starts}
    canvas = Canvas(340, "Flips against the segments of the shortest edge path")
    draw_legend(canvas, 70, 14, [(name, color) for _, name, color in starts])
    shown = [row for table in rows.values() for row in table if kind_of(row)]
    for i, kind in enumerate(("torus", "terrain")):
        left = 66 + 326 * i
        plot = Plot(canvas, (left, 58, left + 300, 280), ranges(shown, "edge_segments"), ranges(shown, "flips"))
        plot.axes("segments of the shortest edge path", "" if i else "flips")
        canvas.text((left, 42), f"({'ab'[i]}) {KINDS[kind][0]}", size=13, anchor="start", is_bold=True)
        fits = []
        for table, _, color in starts:
            points = [(float(r["edge_segments"]), float(r["flips"])) for r in rows[table]
                      if kind_of(r) == kind and float(r["flips"]) > 0]
            plot.dots(points, color)
            fits.append((*fit(points), color))
        draw_fits(canvas, plot, left, fits)
    write(canvas, out / "benchmark_flips.svg")


def draw_fits(canvas, plot, left, fits):
    for i, (power, factor, color) in enumerate(fits):
        plot.power_line(factor, power, color)
        canvas.text((left + 12, 72 + 20 * i), f"fit: exponent {power:.2f}", color, anchor="start", size=13)


def draw_opponents(tables, out):
    """Box plots: the median, the quartiles, and the 5th and the 95th percentile."""
    rows = read_table(tables / "opponents.csv")
    ratios = {method: statistics.quantiles([float(r[f"{method}_s"]) / float(r["dijkstra_s"]) for r in rows], n=20,
                                           method="inclusive") for method in METHODS}
    canvas = Canvas(220, "Three methods of shortening the same paths")
    low, high = min(q[0] for q in ratios.values()), max(q[-1] for q in ratios.values())
    plot = Plot(canvas, (150, 34, 570, 170), (low, high), (0.4, 3.6), is_y_logarithmic=False)
    plot.axes("time over that of Dijkstra's algorithm", "")
    canvas.text((635, 18), f"geodesic, of {len(rows)}", size=13, is_bold=True)
    for y, (method, (title, color)) in zip((3, 2, 1), METHODS.items()):
        least, first, median, third, most = (ratios[method][i] for i in (0, 4, 9, 14, 18))
        plot.line([(least, y), (most, y)], color)
        plot.polygon([(first, y - 0.25), (third, y - 0.25), (third, y + 0.25), (first, y + 0.25)], FAINT, color)
        plot.line([(median, y - 0.25), (median, y + 0.25)], color, CURVE)
        canvas.text((140, plot((low, y))[1]), title, anchor="end", size=13)
        canvas.text((635, plot((low, y))[1]), str(sum(int(r[f"{method}_geodesic"]) for r in rows)), size=13)
    write(canvas, out / "benchmark_opponents.svg")


def print_opponents(tables, name):
    rows = read_table(tables / f"{name}.csv")
    for method in METHODS:
        good = sum(int(r[method + "_geodesic"]) for r in rows)
        ratio = statistics.median(float(r[method + "_s"]) / float(r["dijkstra_s"]) for r in rows)
        print(f"{name}, {method}: geodesic {good} of {len(rows)}, time over Dijkstra {ratio:.3g}")


def write(canvas, path):
    path.write_text(canvas.svg(), encoding="utf-8")


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
    draw_sizes(arguments.tables, arguments.out)
    draw_flips(arguments.tables, arguments.out)
    draw_opponents(arguments.tables, arguments.out)
    for name in ("opponents", "detours"):
        print_opponents(arguments.tables, name)
    print_stages(arguments.tables)


if __name__ == "__main__":
    main()
