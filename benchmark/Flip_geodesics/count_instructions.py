#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Counts the instructions of the main kernels under valgrind, whose counts do not depend on the load of the machine.

    count_instructions.py --kernels BUILD/benchmark/Flip_geodesics/kernels            compares with the committed counts
    count_instructions.py --kernels ... --update                                      writes them

Exits with 1 if a kernel takes more instructions than --tolerance allows (default: 5 per cent). The counts hold for one
compiler and its flags; they are those of the preset `benchmark`. Each kernel runs twice, for different times, so that
the difference is the kernel alone.
"""

import argparse
import csv
import pathlib
import re
import subprocess
import sys
import tempfile

COUNTS = pathlib.Path(__file__).with_name("instruction_counts.csv")
KERNELS = ["flip_and_undo", "reflex_test", "wedge", "word_and_strip", "search", "shorten_and_undo", "certify"]


def instructions(program, kernel, count):
    """The instructions of a run of `count` times the kernel, and its units of work."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", str(program), "--kernel", kernel,
                   "--count", str(count)]
        result = subprocess.run(command, capture_output=True, text=True, check=True)
    return int(re.search(r"Collected : (\d+)", result.stderr).group(1)), int(result.stdout)


def measure(program):
    """Instructions per unit of work of each kernel."""
    counts = {}
    for kernel in KERNELS:
        few, few_units = instructions(program, kernel, 1)
        many, many_units = instructions(program, kernel, 11)
        counts[kernel] = (many - few) / (many_units - few_units)
        print(f"{kernel}: {counts[kernel]:.1f} instructions", file=sys.stderr)
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kernels", type=pathlib.Path, required=True, help="the program kernels")
    parser.add_argument("--tolerance", type=float, default=0.05, help="the relative change that is allowed")
    parser.add_argument("--update", action="store_true", help="write the counts instead of comparing them")
    arguments = parser.parse_args()
    counts = measure(arguments.kernels)
    if arguments.update:
        with open(COUNTS, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["kernel", "instructions"])
            writer.writerows((kernel, f"{count:.1f}") for kernel, count in counts.items())
        return 0
    with open(COUNTS, encoding="utf-8", newline="") as file:
        expected = {row["kernel"]: float(row["instructions"]) for row in csv.DictReader(file)}
    worse = [k for k, count in counts.items() if k not in expected or count > expected[k] * (1 + arguments.tolerance)]
    for kernel in worse:
        print(f"{kernel}: {counts[kernel]:.1f} instructions, {expected.get(kernel, 0):.1f} expected")
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main())
