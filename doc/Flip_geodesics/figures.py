#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws the figures of the manual into fig/, from what the program computes.

    bash examples/run.sh                                builds the program and unpacks CGAL's data set
    python3 doc/Flip_geodesics/figures.py [NAME...]     draws all figures, or those that are named

Needs VTK and Pillow for Python and a virtual screen, in Debian the packages python3-vtk9, python3-pil and xvfb, and for
the figure `page` the package chromium. A figure is a function here with the decorator @figure, which returns its
panels, or a PNG file. The file in fig/ has the function's name.
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

from figure_drawing import BLUE, GREEN, INK, ORANGE, RED, WHITE, Panel, make_small, size_of, write_png  # noqa: E402
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
        """Runs a program in the folder; examples that run.sh does not build are built first."""
        if not (self.programs / program).exists():
            subprocess.run(['cmake', '--build', self.programs.parents[1], '--target', program], check=True)
        subprocess.run([self.programs / program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL,
                       cwd=self.folder)

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


    def screenshot(self, page, state, width, height):
        """A picture of a page as Debian's Chromium shows it; `state` stands behind the # of the address."""
        browser = shutil.which('chromium')
        if browser is None:
            sys.exit('figures.py: needs chromium for this figure')
        picture = self.folder / 'screenshot.png'
        subprocess.run([browser, '--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
                        '--no-first-run', '--disable-background-networking', '--disable-component-update',
                        '--disable-sync', f'--user-data-dir={self.folder}/profile', '--hide-scrollbars',
                        f'--window-size={width},{height}', '--virtual-time-budget=20000', f'--screenshot={picture}',
                        f'{page.as_uri()}#{state}'], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return picture


def read_ply(path, name):
    """The points and faces of a PLY file in text, and the numbers called `name` at its points."""
    lines = iter(path.read_text().splitlines())
    counts, columns = {}, []
    for line in lines:
        words = line.split()
        if words[0] == 'element':
            counts[words[1]] = int(words[2])
        elif words[0] == 'property' and list(counts) == ['vertex']:
            columns.append(words[2])
        elif words[0] == 'end_header':
            break
    rows = [[float(x) for x in next(lines).split()] for _ in range(counts['vertex'])]
    faces = [tuple(map(int, next(lines).split()[1:])) for _ in range(counts['face'])]
    return [tuple(row[:3]) for row in rows], faces, [row[columns.index(name)] for row in rows]


def read_obj(path):
    """The lines of an OBJ file by their first word: numbers, of which those of faces and lines count from 0."""
    result = {'v': [], 'vt': [], 'f': [], 'l': []}
    for line in path.read_text().splitlines():
        word, *rest = line.split()
        if word in ('v', 'vt'):
            result[word].append(tuple(map(float, rest)))
        elif word in ('f', 'l'):
            result[word].append(tuple(int(x.split('/')[0]) - 1 for x in rest))
    return result


def read_off(path):
    """The points and faces of an OFF file in text."""
    numbers = iter(' '.join(line.split('#')[0] for line in path.read_text().splitlines()).split()[1:])
    points, faces = int(next(numbers)), int(next(numbers))
    next(numbers)
    return ([tuple(float(next(numbers)) for _ in range(3)) for _ in range(points)],
            [tuple(int(next(numbers)) for _ in range(int(next(numbers)))) for _ in range(faces)])


class Graph:
    """Shortest paths of edges, to make loops and networks from."""

    def __init__(self, points, faces):
        self.points, self.faces = points, faces
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


def ring(graph, center, u, v, radius, count=6):
    """A loop of edges about a limb: past the vertices that are nearest to points on a circle."""
    angles = [2 * math.pi * k / count for k in range(count)]
    way_points = [graph.nearest([c + radius * (math.cos(t) * a + math.sin(t) * b) for c, a, b in zip(center, u, v)])
                  for t in angles]
    return graph.loop([w for w, before in zip(way_points, way_points[-1:] + way_points) if w != before])


def region_borders(graph, seeds):
    """The mesh's edges between the regions of vertices that are closest to each seed, as chains of vertices."""
    label, queue = {}, [(0.0, seed, i) for i, seed in enumerate(seeds)]
    while queue:
        d, v, i = heapq.heappop(queue)
        if v in label:
            continue
        label[v] = i
        for w in graph.neighbours[v]:
            if w not in label:
                heapq.heappush(queue, (d + math.dist(graph.points[v], graph.points[w]), w, i))
    face_label = {f: max(label[v] for v in f) for f in graph.faces}
    owners = {}
    for f in graph.faces:
        for i in range(3):
            owners.setdefault(frozenset((f[i - 1], f[i])), []).append(face_label[f])
    neighbours = {}
    for edge, labels in owners.items():
        if len(set(labels)) > 1:
            a, b = edge
            neighbours.setdefault(a, set()).add(b)
            neighbours.setdefault(b, set()).add(a)
    nodes = {v for v, others in neighbours.items() if len(others) != 2}
    chains = []
    for start in sorted(nodes):
        while neighbours[start]:
            chain = [start, neighbours[start].pop()]
            neighbours[chain[1]].discard(start)
            while chain[-1] not in nodes:
                chain.append(neighbours[chain[-1]].pop())
                neighbours[chain[-1]].discard(chain[-2])
            chains.append(chain)
    return chains, nodes


@figure(900, 440)
def teaser(tools):
    """Geodesics from one vertex of a scan to others, and closed ones about its limbs."""
    mesh = tools.mesh('bunny00.off')
    page = tools.curves(mesh, '--random', 1)
    graph = Graph(page.points, page.faces)
    view = (0.35, 0.2, 1)
    source = graph.nearest((0.1, 0.05, 0.45))
    angles = [k * math.pi / 20 for k in range(40)]
    targets = {graph.nearest((0.6 * math.cos(t), 0.6 * math.sin(t), 0.05)) for t in angles}
    fan = tools.curves(mesh, '--pairs', tools.lines('pairs', [(source, t) for t in sorted(targets)]))
    left = Panel(size_of(page.points))
    left.surface(page.points, page.faces)
    left.tubes(fan.curves.values(), BLUE, 0.005)
    left.balls([page.points[source]], RED, 0.022)
    left.balls([page.points[t] for t in targets], BLUE, 0.009)
    left.look(view)

    front = (0, 0, 1)
    rings = [ring(graph, (-0.24, 0.07, 0), (0.86, 0.51, 0), front, 0.3),
             ring(graph, (0.0, 0.36, 0.14), (-0.6, 0.8, 0), front, 0.12),
             ring(graph, (-0.12, 0.36, -0.12), (-0.8, 0.6, 0), front, 0.12),
             ring(graph, (0.1, -0.05, 0), (0, 1, 0), front, 0.5)]
    closed = tools.curves(mesh, '--loop', tools.lines('loops', rings))
    right = Panel(size_of(page.points))
    right.surface(page.points, page.faces)
    right.tubes(closed.curves.values(), GREEN, 0.007)
    right.look(view)
    return [left, right]


def detour(tools):
    """A path of edges on a coarse torus that makes a detour, straightened."""
    along = 12
    places = [(15, 3), (15, 2), *((i, 1) for i in range(15, 22)), (21, 2), (21, 3)]
    path = [i * along + j for i, j in places]
    return tools.curves(tools.torus(24, along), '--edges', tools.lines('path', [path]))


@figure(900, 400)
def conforming_triangulation(tools):
    """A coarse mesh, and the intrinsic triangulation that has a geodesic as edges."""
    page = detour(tools)
    state = page.runs[0].state(-1)
    inputs = {edge for edge, _, _ in page.runs[0].input_edges}
    replaced = {frozenset((a, b)) for edge, a, b in page.runs[0].input_edges if edge not in state.present}
    panels = []
    for is_after in (False, True):
        panel = Panel(size_of(page.points))
        panel.surface(page.points, page.faces, is_smooth=False)
        sides = {frozenset((f[i], f[i - 1])) for f in page.faces for i in range(3)} - (replaced if is_after else set())
        panel.tubes([[page.points[v] for v in side] for side in sides], INK, 0.0025)
        if is_after:
            flipped = [page.runs[0].polylines[e] for e in state.present - inputs]
            panel.tubes(flipped, BLUE, 0.004)
            panel.tubes(state.lines, RED, 0.009)
        else:
            panel.tubes(page.runs[0].state(0).lines, RED, 0.009)
        panel.balls([page.curves[0][0], page.curves[0][-1]], RED, 0.025)
        panel.look((0.1, -0.6, 1), target=(0.0, -0.85, 0.2), zoom=1.5)
        panels.append(panel)
    return panels


@figure(960, 240)
def flips(tools):
    """Four states of a shortening, close by: the edges that the last step has flipped are orange."""
    page = detour(tools)
    run = page.runs[0]
    panels = []
    for step in (0, len(run.steps) // 3, 2 * len(run.steps) // 3, -1):
        state = run.state(step)
        untouched = {frozenset((f[i], f[i - 1])) for f in page.faces for i in range(3)}
        untouched -= {frozenset((a, b)) for _, a, b in run.input_edges}
        panel = Panel(size_of(page.points))
        panel.surface(page.points, page.faces, is_smooth=False)
        panel.tubes([[page.points[v] for v in side] for side in untouched], INK, 0.0015)
        panel.tubes(state.edges, INK, 0.0025)
        panel.tubes([run.polylines[e] for e in state.fresh], ORANGE, 0.005)
        panel.tubes(state.lines, RED, 0.008)
        panel.look((0.1, -0.6, 1), target=(0.0, -0.85, 0.2), zoom=1.45)
        panels.append(panel)
    return panels


@figure(900, 440)
def network(tools):
    """Borders between regions of a scan: as edges of the mesh, and straightened with their nodes fixed."""
    mesh = tools.mesh('bunny00.off')
    start = tools.curves(mesh, '--random', 1)
    graph = Graph(start.points, start.faces)
    spiral = [(0.5 * math.sqrt(k / 14), 2.4 * k) for k in range(14)]
    seeds = {graph.nearest((r * math.cos(t), r * math.sin(t), side)) for side in (-0.5, 0.5) for r, t in spiral}
    chains, nodes = region_borders(graph, sorted(seeds))
    page = tools.curves(mesh, '--network', tools.lines('network', chains))
    panels = []
    for lines, name in (([[start.points[v] for v in chain] for chain in chains], ORANGE), (page.curves.values(), BLUE)):
        panel = Panel(size_of(start.points))
        panel.surface(start.points, start.faces)
        panel.tubes(lines, name, 0.006)
        panel.balls([start.points[v] for v in nodes], RED, 0.013)
        panel.look((0.35, 0.2, 1))
        panels.append(panel)
    return panels


@figure(900, 420)
def loops(tools):
    """Closed curves on a torus with bumps, before and after."""
    around, along = 96, 48
    start = [[around // 8 * i * along + j for j in range(along)] for i in range(8)]
    start.append([i * along + (round(6 * math.sin(10 * math.pi * i / around)) + 12) % along for i in range(around)])
    start[-1] = staircase(start[-1], along)
    page = tools.curves(tools.torus(around, along), '--loop', tools.lines('loops', start))
    panels = []
    before = [[page.points[v] for v in loop + loop[:1]] for loop in start]
    for lines, name in ((before, ORANGE), (page.curves.values(), GREEN)):
        panel = Panel(size_of(page.points))
        panel.surface(page.points, page.faces)
        panel.tubes(lines, name, 0.007)
        panel.look((0, -0.9, 1), up=(0, 1, 0))
        panels.append(panel)
    return panels


def staircase(loop, along):
    """Fills in the vertices between places of a torus that are more than an edge apart along the tube."""
    result = []
    for a, b in zip(loop, loop[1:] + loop[:1]):
        result.append(a)
        j, end = a % along, b % along
        while j != end:
            j = (j + (1 if (end - j) % along < along / 2 else -1)) % along
            result.append(a - a % along + j)
    return result


@figure(900, 440)
def poisson(tools):
    """The temperature of surfaces that are heated evenly and kept at zero along a geodesic, with lines of equal heat."""
    panels = []
    for mesh, source, target, view in ((tools.mesh('bunny00.off'), 13512, 11509, (-0.35, 0.2, -1)),
                                       (tools.torus(160, 80), 20, 6440, (0, -0.9, 1))):
        tools.run('poisson_example', mesh, source, target)
        points, faces, heat = read_ply(tools.folder / 'poisson.ply', 'u')
        most = max(heat)
        panel = Panel(size_of(points))
        panel.colored_surface(points, faces, heat, [(0, '#2b5fb3'), (most / 2, '#e9e4d8'), (most, '#c2321b')])
        panel.contours(points, faces, heat, [most * k / 12 for k in range(1, 12)], INK, 0.0022)
        panel.tubes(tools.curves(mesh, '--from', source, '--to', target).curves.values(), WHITE, 0.01)
        panel.look(view)
        panels.append(panel)
    return panels


@figure(900, 480)
def cross_field(tools):
    """The smoothest field of crosses that runs along a geodesic, on a torus."""
    mesh = tools.torus(72, 36)
    source, target = 9, 1340
    tools.run('cross_field_example', mesh, source, target)
    lines = read_obj(tools.folder / 'cross_field.obj')
    page = tools.curves(mesh, '--from', source, '--to', target)
    panel = Panel(size_of(page.points))
    panel.surface(page.points, page.faces)
    panel.tubes([[lines['v'][i] for i in line] for line in lines['l']], BLUE, 0.0028)
    panel.tubes(page.curves.values(), RED, 0.009)
    panel.look((0, -0.8, 1))
    return [panel]


@figure(1000, 380)
def refinement(tools):
    """A coarse torus with a geodesic inserted as edges, and its common subdivision with the refined triangulation."""
    mesh = tools.torus(24, 12)
    ends = ('--from', 169, '--to', 257)
    page = tools.curves(mesh, *ends)
    panels = []
    for arguments in (('--insert',), ('--refine', 25, '--subdivision')):
        result = tools.folder / 'result.off'
        tools.run('flip_geodesics', mesh, *ends, '--quiet', *arguments, result)
        points, faces = read_off(result)
        panel = Panel(size_of(points))
        panel.surface(points, faces, is_smooth=False)
        panel.edges(points, faces, width=0.0022)
        panel.tubes(page.curves.values(), RED, 0.009)
        panel.look((0, -0.8, 1))
        panels.append(panel)
    return panels


@figure(1000, 420)
def flattening(tools):
    """A torus cut open along two geodesic loops and flattened, with lines of equal texture coordinates."""
    tools.run('flattening_example')
    mesh = read_obj(tools.folder / 'flattening.obj')
    corners = [mesh['v'][v] for face in mesh['f'] for v in face]
    flat = [(x, y, 0.0) for x, y in mesh['vt']]
    faces = [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(mesh['f']))]
    panels = []
    for points, view in ((corners, (0, -0.9, 1)), (flat, (0, 0, 1))):
        panel = Panel(size_of(points))
        panel.surface(points, faces, is_smooth=False)
        for axis, color in ((0, BLUE), (1, RED)):
            values = [p[axis] for p in flat]
            step = 0.1
            first, last = round(min(values) / step), round(max(values) / step)
            panel.contours(points, faces, values, [step * k for k in range(first, last + 1)], color, 0.0016)
        panel.look(view)
        panels.append(panel)
    return panels


@figure(900, 440)
def logarithmic_map(tools):
    """The plane about one vertex, a grid and circles, laid over a scan by the logarithmic map."""
    mesh = tools.mesh('bunny00.off')
    start = tools.curves(mesh, '--random', 1)
    source = Graph(start.points, start.faces).nearest((0.1, 0.05, 0.45))
    tools.run('geodesic_tree_example', mesh, source)
    data = read_obj(tools.folder / 'logarithmic_map.obj')
    points, plane = data['v'], data['vt']
    panels = []
    for numbers in (([x for x, _ in plane], [y for _, y in plane]), ([math.hypot(x, y) for x, y in plane],)):
        panel = Panel(size_of(points))
        panel.surface(points, data['f'])
        near = [f for f in data['f'] if all(math.hypot(*plane[v]) < 0.62 for v in f)]
        for values, name in zip(numbers, (BLUE, GREEN)):
            panel.contours(points, near, values, [0.05 * k + 0.001 for k in range(-13, 13)], name, 0.0035)
        panel.balls([points[source]], RED, 0.022)
        panel.look((0.35, 0.2, 1))
        panels.append(panel)
    return panels


@figure(900, 380)
def spline(tools):
    """A geodesic between points inside faces, and the Bezier curve of four such points."""
    mesh = tools.torus(20, 10)  # on which the example's faces lie well
    page = tools.curves(mesh, '--random', 1)
    tools.run('geodesic_spline_example', mesh)
    curves = []
    for line in (tools.folder / 'geodesic_spline.polylines.txt').read_text().splitlines():
        numbers = [float(x) for x in line.split()[1:]]
        curves.append(list(zip(numbers[0::3], numbers[1::3], numbers[2::3])))
    geodesic, bezier = curves

    def point(face, first):  # the example's weights, from one corner of a face on
        corners = [page.points[page.faces[face][(first + k) % 3]] for k in range(3)]
        return [0.5 * a + 0.3 * b + 0.2 * c for a, b, c in zip(*corners)]
    first = min(range(3), key=lambda k: math.dist(point(0, k), geodesic[0]))
    controls = [point(face, first) for face in (0, 40, 90, 130)]
    panels = []
    for view in ((0.8, 0.55, 0.9), (-0.5, -0.5, 0.75)):
        panel = Panel(size_of(page.points))
        panel.surface(page.points, page.faces, is_smooth=False)
        panel.edges(page.points, page.faces)
        panel.tubes([geodesic], BLUE, 0.008)
        panel.tubes([bezier], RED, 0.01)
        panel.balls(controls, ORANGE, 0.025)
        panel.look(view, up=(0, 0, 1))
        panels.append(panel)
    return panels


@figure(104, 104)
def flip_geodesics_small(tools):
    """The small picture of the package overview."""
    page = detour(tools)
    panel = Panel(size_of(page.points))
    panel.surface(page.points, page.faces, is_smooth=False)
    panel.edges(page.points, page.faces, width=0.005)
    panel.tubes([page.runs[0].state(0).lines[0]], ORANGE, 0.02)
    panel.tubes(page.curves.values(), RED, 0.03)
    panel.look((0.1, -0.6, 1), target=(0.0, -0.85, 0.2), zoom=1.35)
    return [panel]


@figure(1000, 620)
def page(tools):
    """The page of --page in a browser, in the middle of a shortening."""
    path = tools.folder / 'curves.html'
    tools.run('flip_geodesics', tools.torus(48, 24), '--random', 4, '--seed', 3, '--quiet', '--page', path)
    return tools.screenshot(path, 'curve=3&step=12&edges=1', 1000, 620)


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
            result = draw(Tools(options.build.resolve(), folder))
            if isinstance(result, Path):
                shutil.copy(result, path)
                make_small(path)
            else:
                write_png(path, result, width, height)
            print(f'{path.name}: {path.stat().st_size // 1000} kB')


if __name__ == '__main__':
    main()
