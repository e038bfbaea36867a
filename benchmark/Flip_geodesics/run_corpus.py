#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs flip_geodesics on random pairs of vertices of many meshes, checks every curve with check_polylines, and writes
one CSV row per curve. A mesh that is rejected, crashes or takes too long has one row as well. With --curves points, the
curves pass through random points of the surface, and with --curves splines, they have such points as control points;
sample_points chooses the points.

    run_corpus.py --program build/flip_geodesics --checker build/check_polylines --meshes DIR --out results
    run_corpus.py --curves points --sampler build/sample_points ... --out results_of_points
    run_corpus.py --summarise results

With --shard i/n (i from 0 to n-1), only the meshes whose number modulo n is i are computed, so that a batch scheduler
can distribute them; each shard appends to its own file. If an interrupted run is started again, it continues where it
stopped: a mesh is finished once its rows and its line in the list of finished meshes are written.

Exit status: 0 on success, 1 if the summary contains a wrong curve or a lost result, 2 if the arguments are wrong. The
summary covers all shards in the output folder.
"""

import argparse
import collections
import concurrent.futures
import csv
import glob
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

MESH_EXTENSIONS = {".off", ".obj", ".ply", ".stl", ".vtp"}

RUN_COLUMNS = ["mesh", "category", "outcome", "exit_status", "checker_exit_status", "seconds", "message"]
STATS_COLUMNS = ["curve", "source", "target", "initial_segments", "initial_length", "length", "flips", "flip_outs",
                 "min_angle", "status", "certificate", "search_s", "shorten_s", "extract_s", "contracted"]
# Column of the checker -> column here, where the statistics have one of the same name.
CHECKER_COLUMNS = {"points": "points", "segments": "segments", "broken": "broken", "strip_bend": "strip_bend",
                   "point_deviation": "point_deviation", "raw_bend": "raw_bend",
                   "min_vertex_angle": "min_vertex_angle", "bent_vertices": "bent_vertices",
                   "min_unblocked_angle": "min_unblocked_angle", "length": "checked_length",
                   "length_error": "length_error", "ok": "ok", "message": "checker_message"}
COLUMNS = RUN_COLUMNS + STATS_COLUMNS + list(CHECKER_COLUMNS.values())

BEND_TOLERANCE = 1e-6  # radians


def fail(message):
    print(f"run_corpus.py: {message}", file=sys.stderr)
    sys.exit(2)


# --------------------------------------------------------------------------------------------------- which meshes --

def meshes_of_manifest(manifest, folder):
    """The (file, category) pairs of a tab separated table with a header, in its order."""
    with open(manifest, newline="", encoding="utf-8") as table:
        rows = csv.reader(table, delimiter="\t", quoting=csv.QUOTE_NONE)
        header = next(rows)
        if header[:2] != ["file", "category"]:
            fail(f"{manifest}: the first two columns should be `file` and `category`")
        meshes = [(row[0], row[1]) for row in rows if row]
    missing = [file for file, _ in meshes if not os.path.exists(os.path.join(folder, file))]
    if missing:
        print(f"{len(missing)} meshes of the manifest do not exist; the first is {missing[0]}", file=sys.stderr)
    return meshes


def meshes_of_folder(folder):
    """The (file, category) pairs of a folder, sorted; the category is the name of the folder a mesh lies in."""
    meshes = []
    for directory, _, files in os.walk(folder):
        for file in files:
            if os.path.splitext(file)[1].lower() in MESH_EXTENSIONS:
                path = os.path.relpath(os.path.join(directory, file), folder)
                meshes.append((path, os.path.basename(os.path.dirname(path))))
    return sorted(meshes)


def select_meshes(arguments):
    meshes = (meshes_of_manifest(arguments.manifest, arguments.meshes) if arguments.manifest
              else meshes_of_folder(arguments.meshes))
    if arguments.categories:
        wanted = set(arguments.categories.split(","))
        meshes = [mesh for mesh in meshes if mesh[1] in wanted]
    index, number = arguments.shard
    return meshes[index::number]


# ------------------------------------------------------------------------------------------------------- one mesh --

def run(command, timeout):
    """Returns the exit status (negative: the signal; None: out of time) and the last line of standard error."""
    with tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors,
                                   start_new_session=True)
        try:
            status = process.wait(timeout=timeout)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            status = None
        errors.seek(0)
        lines = errors.read().decode("utf-8", "replace").split("\n")
    lines = [line.strip() for line in lines if line.strip()]
    return status, lines[-1] if lines else ""


def signal_name(number):
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def read_table(path):
    """The rows of a CSV file by their column `curve`, in the order of the file. Nothing if there is no such file."""
    if not os.path.exists(path):
        return {}
    with open(path, newline="", encoding="utf-8") as table:
        return {row["curve"]: row for row in csv.DictReader(table) if row.get("curve")}


def outcome_of(status, has_stats):
    if status is None:
        return "timeout"
    if status < 0 or status > 2:
        return "crashed"
    if status == 2:
        return "rejected"
    return "computed" if has_stats else "no output"


def join_rows(run_row, stats, checked):
    """One row a curve; a single one without a curve if there are none."""
    rows = []
    for curve in list(stats) + [curve for curve in checked if curve not in stats]:
        row = dict(run_row, curve=curve)
        row.update({name: stats.get(curve, {}).get(name, "") for name in STATS_COLUMNS if name != "curve"})
        row.update({here: checked.get(curve, {}).get(there, "") for there, here in CHECKER_COLUMNS.items()})
        rows.append(row)
    return rows or [run_row]


def asked_curves(path, folder, arguments):
    """What program and checker are told about the curves. A mesh that the sampler rejects is left to the program."""
    if arguments.curves == "pairs":
        return ["--random", str(arguments.pairs), "--seed", str(arguments.seed)], []
    points = os.path.join(folder, "points.txt")
    options = ["--splines"] if arguments.curves == "splines" else []
    with open(points, "w", encoding="utf-8") as file:
        subprocess.run([arguments.sampler, path, "--curves", str(arguments.pairs), "--seed", str(arguments.seed),
                        *options], stdout=file, stderr=subprocess.DEVNULL, timeout=arguments.timeout, check=False)
    return (["--bezier", points], ["--splines", points]) if options else (["--points", points], ["--points", points])


def process_mesh(mesh, category, arguments):
    """Runs program and checker on one mesh; returns its rows."""
    path = os.path.join(arguments.meshes, mesh)
    with tempfile.TemporaryDirectory(prefix="run_corpus_") as folder:
        polylines, stats, checked = (os.path.join(folder, name) for name in ("curves.txt", "stats.csv", "check.csv"))
        asked_of_program, asked_of_checker = asked_curves(path, folder, arguments)
        start = time.monotonic()
        command = "spline" if arguments.curves == "splines" else "path"
        status, message = run([arguments.program, command, path, *asked_of_program, "--kernel", arguments.kernel,
                               "--polylines", polylines, "--stats", stats, "--quiet"], arguments.timeout)
        seconds = time.monotonic() - start
        row = {"mesh": mesh, "category": category, "seconds": f"{seconds:.3f}", "message": message,
               "exit_status": "" if status is None else status}
        stats_rows = read_table(stats) if status in (0, 1) else {}
        row["outcome"] = outcome_of(status, bool(stats_rows))
        if status is not None and status < 0:
            row["message"] = " ".join([signal_name(-status), message]).strip()
        if row["outcome"] != "computed":
            return [row]
        open(polylines, "a", encoding="utf-8").close()  # no curve may have had any points
        status, message = run([arguments.checker, path, polylines, *asked_of_checker, "--stats", stats, "--csv", checked,
                               "--quiet"], arguments.timeout)
        row["checker_exit_status"] = "timeout" if status is None else status
        if status not in (0, 1):
            row.update(outcome="not checked", message=message)
        keep_files(folder, mesh, status, arguments)
        return join_rows(row, stats_rows, read_table(checked) if status in (0, 1) else {})


def keep_files(folder, mesh, status, arguments):
    """Keeps what program and checker wrote, if the checker found something wrong and it was asked for."""
    if status != 0 and arguments.keep:
        target = os.path.join(arguments.out, "kept", mesh.replace(os.sep, "__"))
        shutil.rmtree(target, ignore_errors=True)
        shutil.copytree(folder, target)


# -------------------------------------------------------------------------------------------- a shard, resumable --

class Shard:
    """The two files of a shard: the rows, and the list of meshes whose rows are complete."""

    def __init__(self, arguments):
        os.makedirs(arguments.out, exist_ok=True)
        name = "shard_{}_of_{}".format(*arguments.shard)
        self.rows_path = os.path.join(arguments.out, f"curves_{name}.csv")
        self.done_path = os.path.join(arguments.out, f"done_{name}.txt")
        self.check_settings(os.path.join(arguments.out, f"settings_{name}.json"), arguments)
        self.done = self.read_done()
        self.drop_unfinished_rows()

    @staticmethod
    def check_settings(path, arguments):
        """Rows of different settings do not belong into one file."""
        settings = {name: getattr(arguments, name) for name in ("curves", "pairs", "seed", "kernel")}
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                before = json.load(file)
            if before != settings:
                fail(f"{arguments.out} holds results for {before}; use another --out")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(settings, file)

    def read_done(self):
        if not os.path.exists(self.done_path):
            return set()
        with open(self.done_path, encoding="utf-8") as file:
            text = file.read()
        lines = text.split("\n")
        if lines.pop():  # the last line was cut off
            with open(self.done_path, "w", encoding="utf-8") as file:
                file.writelines(line + "\n" for line in lines)
        return set(lines)

    def drop_unfinished_rows(self):
        rows = []
        if os.path.exists(self.rows_path):
            with open(self.rows_path, newline="", encoding="utf-8") as file:
                rows = [row for row in csv.DictReader(file) if row["mesh"] in self.done]
        with open(self.rows_path + ".new", "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, COLUMNS, restval="", extrasaction="ignore", lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
        os.replace(self.rows_path + ".new", self.rows_path)

    def add(self, mesh, rows):
        with open(self.rows_path, "a", newline="", encoding="utf-8") as file:
            csv.DictWriter(file, COLUMNS, restval="", lineterminator="\n").writerows(rows)
            file.flush()
            os.fsync(file.fileno())
        with open(self.done_path, "a", encoding="utf-8") as file:
            file.write(mesh + "\n")
        self.done.add(mesh)


def run_shard(arguments):
    shard = Shard(arguments)
    meshes = select_meshes(arguments)
    todo = [(mesh, category) for mesh, category in meshes if mesh not in shard.done]
    print(f"{len(meshes)} meshes, {len(todo)} to do", file=sys.stderr)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        # In the order of the meshes, so that the file does not depend on the number of jobs.
        results = pool.map(lambda entry: process_mesh(*entry, arguments), todo)
        for number, ((mesh, _), rows) in enumerate(zip(todo, results), 1):
            shard.add(mesh, rows)
            wrong = sum(row.get("ok") == "0" for row in rows)
            print(f"{number}/{len(todo)} {mesh}: {rows[0]['outcome']}, {rows[0]['seconds']} s"
                  + (f", {wrong} curves wrong" if wrong else ""), file=sys.stderr, flush=True)


# -------------------------------------------------------------------------------------------------------- summary --

def number(row, name, default=math.nan):
    try:
        return float(row.get(name) or "nan")
    except ValueError:
        return default


def bend_of(row):
    """The larger of the bend at a crossing and the bend at a passed vertex, in radians."""
    bends = (number(row, "strip_bend"), math.pi - number(row, "min_unblocked_angle"))
    return max((bend for bend in bends if not math.isnan(bend)), default=0.0)


def read_rows(folder):
    rows = []
    for path in sorted(glob.glob(os.path.join(folder, "curves_shard_*.csv"))):
        with open(path, newline="", encoding="utf-8") as file:
            rows += list(csv.DictReader(file))
    return rows


def print_rows(title, rows, describe, limit=10):
    if rows:
        print(f"\n{title}:")
    for row in rows[:limit]:
        print(f"  {row['mesh']} {describe(row)}".rstrip())
    if len(rows) > limit:
        print(f"  ... and {len(rows) - limit} more")


def print_counts(title, values):
    counts = collections.Counter(values)
    print(f"{title}: " + (", ".join(f"{value} {count}" for value, count in sorted(counts.items())) or "none"))


def describe_curve(row):
    return (f"curve {row['curve']} from {row['source']} to {row['target']}: {row['status']}, bend {bend_of(row):.3g}, "
            f"broken {row['broken']}, length error {row['length_error'] or '-'} {row['checker_message']}")


def summarise(folder):
    """Prints the summary of all shards in a folder; returns whether nothing is wrong."""
    rows = read_rows(folder)
    first_rows = {row["mesh"]: row for row in rows}.values()
    curves = [row for row in rows if row["curve"]]
    shortest = [row for row in curves if row["status"] == "LOCALLY_SHORTEST"]
    broken = [row for row in curves if number(row, "broken", 0) > 0]
    bent = [row for row in shortest if bend_of(row) >= BEND_TOLERANCE]
    wrong = [row for row in curves if row["ok"] != "1"]
    lost = [row for row in first_rows if row["outcome"] not in ("computed", "rejected")]

    print_counts(f"meshes: {len(first_rows)}", (row["outcome"] for row in first_rows))
    print_counts(f"curves: {len(curves)}", (row["status"] or "(no status)" for row in curves))
    if any(row["certificate"] for row in curves):
        print_counts("certificates", (row["certificate"] for row in curves))
    print(f"broken polylines: {len(broken)}")
    print(f"LOCALLY_SHORTEST and bent by {BEND_TOLERANCE:g} or more: {len(bent)}")
    print(f"wrong curves in total: {len(wrong)}")
    print(f"curves that bend at a vertex where they are blocked: "
          f"{sum(number(row, 'bent_vertices', 0) > 0 and row['ok'] == '1' for row in shortest)}")
    for title, figure in (("bend at a crossing", lambda row: number(row, "strip_bend")),
                          ("bend at a passed vertex", lambda row: math.pi - number(row, "min_unblocked_angle")),
                          ("distance of a point from the line", lambda row: number(row, "point_deviation")),
                          ("error of a length", lambda row: number(row, "length_error"))):
        figures = [figure(row) for row in shortest]
        print(f"largest {title}: {max((x for x in figures if not math.isnan(x)), default=0.0):.3g}")

    print_rows("crashes, time-outs and lost results", lost, lambda row: f"({row['outcome']}) {row['message']}")
    print_rows("rejected meshes", [row for row in first_rows if row["outcome"] == "rejected"],
               lambda row: row["message"])
    print_rows("broken curves", broken, describe_curve)
    print_rows("worst bends", sorted(bent, key=bend_of, reverse=True), describe_curve)
    print_rows("other wrong curves", [row for row in wrong if row not in broken and row not in bent], describe_curve)
    print_rows("other statuses", [row for row in curves if row["status"] != "LOCALLY_SHORTEST"],
               lambda row: f"curve {row['curve']} from {row['source']} to {row['target']}: {row['status']}")
    return not (lost or wrong)


# ------------------------------------------------------------------------------------------------------ arguments --

def parse_shard(text):
    index, _, count = text.partition("/")
    if not (index.isdigit() and count.isdigit() and int(index) < int(count)):
        raise argparse.ArgumentTypeError(f"{text} is not i/n with 0 <= i < n")
    return int(index), int(count)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--summarise", metavar="DIR", help="only print the summary of the results in this folder")
    parser.add_argument("--program", help="the program flip_geodesics")
    parser.add_argument("--checker", help="the program check_polylines")
    parser.add_argument("--meshes", metavar="DIR", help="the folder of the meshes, searched with its subfolders")
    parser.add_argument("--manifest", metavar="TSV", help="a table with columns `file` (below --meshes) and `category`")
    parser.add_argument("--categories", metavar="A,B",
                        help="only these categories; without a manifest, they are the names of folders")
    parser.add_argument("--curves", choices=["pairs", "points", "splines"], default="pairs",
                        help="paths between vertices, paths through points, or splines (default %(default)s)")
    parser.add_argument("--sampler", help="the program sample_points, for --curves points and splines")
    parser.add_argument("--pairs", type=int, default=10, help="random curves per mesh (default %(default)s)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kernel", choices=["certified", "double"], default="certified")
    parser.add_argument("--out", metavar="DIR", help="the folder of the results")
    parser.add_argument("--shard", type=parse_shard, default=(0, 1), metavar="i/n")
    parser.add_argument("--timeout", type=float, default=300, metavar="S",
                        help="time limit per mesh in seconds (default %(default)s)")
    parser.add_argument("--jobs", type=int, default=1, help="meshes computed at the same time (default %(default)s)")
    parser.add_argument("--keep", action="store_true", help="keep the files of meshes on which a curve is wrong")
    arguments = parser.parse_args()
    if not arguments.summarise:
        programs = ["program", "checker"] + (["sampler"] if arguments.curves != "pairs" else [])
        for name in programs + ["meshes", "out"]:
            if getattr(arguments, name) is None:
                parser.error(f"--{name} is required")
        for name in programs:
            path = shutil.which(getattr(arguments, name))
            if path is None:
                parser.error(f"{getattr(arguments, name)} is not an executable program")
            setattr(arguments, name, os.path.abspath(path))
        if not os.path.isdir(arguments.meshes):
            parser.error(f"{arguments.meshes} is not a folder")
    return arguments


def main():
    arguments = parse_arguments()
    if not arguments.summarise:
        run_shard(arguments)
    return 0 if summarise(arguments.summarise or arguments.out) else 1


if __name__ == "__main__":
    sys.exit(main())
