#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws the figures of the manual into fig/, from what the program computes.

    bash examples/run.sh                                builds the program and unpacks CGAL's data set
    python3 doc/Flip_geodesics/figures.py [NAME...]     draws all figures, or those that are named

Needs VTK for Python and a virtual screen, in Debian the packages python3-vtk9 and xvfb. A figure is a function here
with the decorator @figure, which returns its panels; the file has the function's name.
"""

import argparse
import heapq
import math
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

if not os.environ.get('DISPLAY') and shutil.which('xvfb-run'):
    os.execvp('xvfb-run', ['xvfb-run', '-a', sys.executable, *sys.argv])

here = Path(__file__).resolve().parent
root = here.parents[1]
sys.path[:0] = [str(here), str(root / 'examples/Flip_geodesics/page')]

from figure_drawing import (BLUE, GREEN, INK, ORANGE, RED, VIOLET, Panel, size_of, write_png)  # noqa: E402
from read_page import Page  # noqa: E402

figures = {}


def figure(width, height):
    """Registers a function of a `Tools` that returns panels, side by side in a picture of that many pixels."""
    def register(function):
        figures[function.__name__] = (function, width, height)
        return function
    return register


class Tools:
    """The programs, the meshes, and a folder for what is in between."""

    def __init__(self, build, folder):
        self.programs = build / 'examples/Flip_geodesics'
        self.data = build / 'data'
        self.folder = Path(folder)

    def run(self, program, *arguments):
        subprocess.run([self.programs / program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

    def mesh(self, name):
        """A mesh of CGAL's data set."""
        found = sorted(self.data.rglob(name))
        if not found:
            sys.exit(f'figures.py: no {name} in {self.data}; run examples/run.sh first')
        return found[0]

    def torus(self, around, along):
        """A torus with bumps; vertex i * along + j has angle i / around about the axis and j / along about the tube."""
        self.run('generate_torus', self.folder / 'torus.off', around, along)
        return self.folder / 'torus.off'

    def lines(self, name, curves):
        """A file with a line of numbers, or words, per curve."""
        path = self.folder / name
        path.write_text(''.join(' '.join(map(str, curve)) + '\n' for curve in curves))
        return path

    def curves(self, mesh, *arguments):
        """The page that the program writes of some curves."""
        page = self.folder / 'page.html'
        self.run('flip_geodesics', mesh, *arguments, '--quiet', '--page', page)
        return Page(page)


class Graph:
    """Shortest paths of edges, to make loops and networks from."""

    def __init__(self, points, faces):
        self.points = points
        self.neighbours = [set() for _ in points]
        for f in faces:
            for i in range(3):
                self.neighbours[f[i]].update((f[i - 1], f[(i + 1) % 3]))

    def nearest(self, place):
        return min(range(len(self.points)), key=lambda v: math.dist(self.points[v], place))

    def path(self, source, target):
        distance, parent, queue = {source: 0.0}, {}, [(0.0, source)]
        while queue:
            d, v = heapq.heappop(queue)
            if v == target:
                break
            if d > distance[v]:
                continue
            for w in self.neighbours[v]:
                far = d + math.dist(self.points[v], self.points[w])
                if far < distance.get(w, math.inf):
                    distance[w], parent[w] = far, v
                    heapq.heappush(queue, (far, w))
        path = [target]
        while path[-1] != source:
            path.append(parent[path[-1]])
        return path[::-1]

    def loop(self, way_points):
        result = []
        for a, b in zip(way_points, way_points[1:] + way_points[:1]):
            result += self.path(a, b)[:-1]
        return result


@figure(900, 560)
def teaser(tools):
    """Geodesics from one point of a scan to many, and closed ones."""
    mesh = tools.mesh('bunny00.off')
    paths = tools.curves(mesh, '--random', 1)
    panel = Panel(size_of(paths.points))
    panel.surface(paths.points, paths.faces)
    print({i: (min(p[i] for p in paths.points), max(p[i] for p in paths.points)) for i in range(3)})
    panel.look((0.3, 0.25, 1))
    return [panel]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--build', type=Path, default=root / 'build/examples', help='where examples/run.sh has built')
    parser.add_argument('--out', type=Path, default=here / 'fig')
    parser.add_argument('names', nargs='*', help=', '.join(figures))
    options = parser.parse_args()
    if unknown := set(options.names) - set(figures):
        sys.exit(f'figures.py: no figure {", ".join(unknown)}; there are {", ".join(figures)}')
    for name in options.names or figures:
        draw, width, height = figures[name]
        with tempfile.TemporaryDirectory() as folder:
            path = options.out / f'{name}.png'
            write_png(path, draw(Tools(options.build.resolve(), folder)), width, height)
            print(f'{path.name}: {path.stat().st_size // 1000} kB')


if __name__ == '__main__':
    main()
