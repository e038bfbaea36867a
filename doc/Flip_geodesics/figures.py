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
import math
import os
import shutil
import sys
import tempfile
from pathlib import Path

if not os.environ.get('DISPLAY') and shutil.which('xvfb-run'):
    os.execvp('xvfb-run', ['xvfb-run', '-a', sys.executable, *sys.argv])

here = Path(__file__).resolve().parent
root = here.parents[1]
sys.path[:0] = [str(here), str(root / 'examples/Flip_geodesics_program/page')]

from figure_drawing import BLUE, GREEN, INK, ORANGE, RED, WHITE, Panel, make_small, size_of, write_png  # noqa: E402
from figure_tools import Graph, Tools, read_obj, read_off, read_ply, read_vtp  # noqa: E402

figures = {}


def figure(width, height):
    """Registers a function of a `Tools` that returns panels, side by side in a picture of that many pixels."""
    def register(function):
        figures[function.__name__] = (function, width, height)
        return function
    return register


def ring(graph, center, u, v, radius, count=6):
    """A loop of edges about a limb: past the vertices that are nearest to points on a circle."""
    angles = [2 * math.pi * k / count for k in range(count)]
    way_points = [graph.nearest([c + radius * (math.cos(t) * a + math.sin(t) * b) for c, a, b in zip(center, u, v)])
                  for t in angles]
    return graph.loop([w for w, before in zip(way_points, way_points[-1:] + way_points) if w != before])


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


def detour(tools, *arguments):
    """A path of edges on a coarse torus that makes a detour, straightened."""
    along = 12
    places = [(15, 3), (15, 2), *((i, 1) for i in range(15, 22)), (21, 2), (21, 3)]
    path = [i * along + j for i, j in places]
    return tools.curves(tools.torus(24, along), '--edges', tools.lines('path', [path]), *arguments)


def intrinsic_edges(page, state):
    """All edges of the triangulation of the first run at a state."""
    untouched = {frozenset((f[i], f[i - 1])) for f in page.faces for i in range(3)}
    untouched -= {frozenset((a, b)) for _, a, b in page.runs[0].input_edges}
    return [[page.points[v] for v in side] for side in untouched] + state.edges


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


REGIONS = '#b9c4d6', '#d8cdb4', '#b7d0bd', '#d6b9c1', '#c7bfdb', '#cfd3a8', '#a9ccd3'


@figure(1000, 350)
def network(tools):
    """Boundaries of a segmentation of a scan: as edges, pulled tight, and stopped early with free junctions."""
    mesh = tools.mesh('bunny00.off')
    start = tools.curves(mesh, '--random', 1)
    graph = Graph(start.points, start.faces)
    spiral = [(0.5 * math.sqrt(k / 14), 2.4 * k) for k in range(14)]
    seeds = {graph.nearest((r * math.cos(t), r * math.sin(t), side)) for side in (-0.5, 0.5) for r, t in spiral}
    label = graph.regions(sorted(seeds))
    labels = [max(label[v] for v in f) for f in start.faces]
    segmentation = tools.lines('labels.seg', [[x] for x in labels])
    tight = tools.curves(mesh, '--segmentation', segmentation)
    gaps = tools.curves(mesh, '--segmentation', segmentation, '--free-junctions', '--stop-length', 0.85)
    panels = []
    for lines, name in ((tight.runs[0].state(0).lines, ORANGE), (tight.curves.values(), BLUE),
                        (gaps.curves.values(), GREEN)):
        panel = Panel(size_of(start.points))
        for region in set(labels):
            faces = [f for f, x in zip(start.faces, labels) if x == region]
            panel.surface(start.points, faces, REGIONS[region % len(REGIONS)])
        panel.tubes(lines, name, 0.005)
        panel.look((0.35, 0.2, 1))
        panels.append(panel)
    return panels


@figure(900, 420)
def early_stop(tools):
    """A network whose curves were stopped at 95 % of their lengths; and pulled tight."""
    mesh = tools.torus(96, 48)
    points, faces = read_off(mesh)
    panels = []
    for ratio, shade in ((0.95, ORANGE), (0, BLUE)):
        tools.run('network_early_stop_example', mesh, ratio)
        panel = Panel(size_of(points))
        panel.surface(points, faces)
        panel.tubes(read_vtp(tools.folder / 'network.vtp'), shade, 0.008)
        panel.look((0, -0.9, 1))
        panels.append(panel)
    return panels


@figure(900, 400)
def seams(tools):
    """The seams of a textured torus, as edges and straightened; thin lines are those of equal texture coordinates."""
    around, along = 72, 36
    points, _ = read_off(tools.torus(around, along))
    mesh, corners, plane = tools.folder / 'textured.obj', [], []
    with mesh.open('w') as out:
        out.writelines('v {} {} {}\n'.format(*p) for p in points)
        for i in range(around):
            for j in range(along):
                # Where the sheet is cut: in zigzags about the tube, and about the hole.
                du = around if i < 8 + abs((j + 6) % 12 - 6) else 0
                dv = along if j < 5 + abs((i + 4) % 8 - 4) else 0
                a, b, c, d = ((i + x, j + y) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
                for face in ((a, b, c), (a, c, d)):
                    for k, m in face:
                        corners.append(points[k % around * along + m % along])
                        plane.append(((k + du) / around, (m + dv) / along))
                        out.write('vt {} {}\n'.format(*plane[-1]))
                    texts = (f'{k % around * along + m % along + 1}/{n}' for (k, m), n in zip(face, (-3, -2, -1)))
                    out.write('f {} {} {}\n'.format(*texts))
    page = tools.curves(mesh, '--seams')
    panels = []
    for lines, name in ((page.runs[0].state(0).lines, ORANGE), (page.curves.values(), BLUE)):
        panel = Panel(size_of(points))
        panel.surface(page.points, page.faces)
        faces = [(k, k + 1, k + 2) for k in range(0, len(corners), 3)]
        for axis, count in ((0, 24), (1, 12)):
            levels = [(k + 0.5) / count for k in range(2 * count)]
            panel.contours(corners, faces, [p[axis] for p in plane], levels, INK, 0.0012)
        panel.tubes(lines, name, 0.009)
        panel.look((0.75, -0.35, 1), up=(0, 0, 1))
        panels.append(panel)
    return panels


@figure(900, 400)
def drawn_polyline(tools):
    """A polyline across the faces of a mesh; the edges that it is snapped to, and the geodesic that it becomes."""
    mesh = tools.torus(48, 24)
    tools.run('drawn_polyline_example', mesh)
    drawn, tight, snapped = read_vtp(tools.folder / 'drawn_polyline.vtp')
    points, faces = read_off(mesh)
    panels = []
    for shown in (((drawn, RED),), ((snapped, ORANGE), (tight, BLUE))):
        panel = Panel(size_of(points))
        panel.surface(points, faces, is_smooth=False)
        panel.edges(points, faces)
        for line, name in shown:
            panel.tubes([line], name, 0.009)
        panel.look((0, -0.6, 1))
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


@figure(1000, 440)
def loop_basis(tools):
    """Closed geodesics around the handles of two surfaces, found from the surfaces alone."""
    panels = []
    for name, view in (('elephant.off', (0.8, 0.45, -1)), ('eight.off', (0.3, -0.5, 1))):
        mesh = tools.mesh(name)
        points, faces = read_off(mesh)
        tools.run('loop_basis_example', mesh)
        panel = Panel(size_of(points))
        panel.surface(points, faces)
        panel.tubes(read_vtp(tools.folder / 'loop_basis.vtp'), BLUE, 0.007)
        panel.look(view)
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
    page = tools.curves(mesh, '--from', source, '--to', target)
    panel = Panel(size_of(page.points))
    panel.surface(page.points, page.faces)
    panel.tubes(read_vtp(tools.folder / 'cross_field.vtp'), BLUE, 0.0028)
    panel.tubes(page.curves.values(), RED, 0.009)
    panel.look((0, -0.8, 1))
    return [panel]


@figure(1000, 330)
def refinement(tools):
    """A coarse torus with a geodesic as edges; the refined triangulation; its common subdivision with the mesh."""
    mesh = tools.torus(24, 12)
    result = tools.folder / 'result.off'
    panels = []
    for arguments in (('--insert', result), ('--refine', 25), ('--refine', 25, '--subdivision', result)):
        page = tools.curves(mesh, '--from', 169, '--to', 257, *arguments)
        panel = Panel(size_of(page.points))
        if result in arguments:
            points, faces = read_off(result)
            panel.surface(points, faces, is_smooth=False)
            panel.edges(points, faces, width=0.0025)
        else:
            panel.surface(page.points, page.faces, is_smooth=False)
            panel.tubes(intrinsic_edges(page, page.runs[0].state(-1)), INK, 0.0025)
        panel.tubes(page.curves.values(), RED, 0.009)
        panel.look((0, -0.8, 1), target=(-0.35, -0.62, 0.3), zoom=2.1)
        panels.append(panel)
    return panels


@figure(900, 400)
def delaunay(tools):
    """The triangulation about a geodesic as flips have left it, and flipped to constrained Delaunay."""
    panels = []
    for arguments in ((), ('--delaunay',)):
        page = detour(tools, *arguments)
        state = page.runs[0].state(-1)
        panel = Panel(size_of(page.points))
        panel.surface(page.points, page.faces, is_smooth=False)
        panel.tubes(intrinsic_edges(page, state), INK, 0.003)
        panel.tubes(state.lines, RED, 0.009)
        panel.look((0.1, -0.6, 1), target=(0.0, -0.85, 0.2), zoom=1.5)
        panels.append(panel)
    return panels


@figure(900, 400)
def cut(tools):
    """A torus, cut open along closed geodesics into pieces, which are moved apart."""
    around, along = 96, 48
    mesh = tools.torus(around, along)
    loops = [['o', *(i * along + j for j in range(along))] for i in range(0, around, around // 3)]
    result = tools.folder / 'cut.off'
    network = tools.lines('network', loops)
    tools.run('flip_geodesics', mesh, '--network', network, '--cut', result, '--quiet')
    points, faces = read_off(result)
    pieces = Graph(points, faces).components()
    panels = []
    for distance in (0, 0.25):
        moved = list(points)
        for piece in pieces:
            middle = [sum(points[v][i] for v in piece) / len(piece) for i in range(3)]
            for v in piece:
                moved[v] = tuple(x + distance * m for x, m in zip(points[v], middle))
        panel = Panel(size_of(points))
        panel.surface(moved, faces)
        panel.tubes(boundaries(moved, faces), RED, 0.008)
        panel.look((0, -0.9, 1))
        panels.append(panel)
    return panels


def boundaries(points, faces):
    """The edges of one face only."""
    owners = {}
    for f in faces:
        for i in range(3):
            owners.setdefault(frozenset((f[i - 1], f[i])), []).append(f)
    return [[points[v] for v in edge] for edge, owning in owners.items() if len(owning) == 1]


@figure(1000, 420)
def flattening(tools):
    """A torus cut open along two geodesic loops and flattened, with lines of equal texture coordinates."""
    tools.run('flattening_example', tools.torus(96, 48), 0, 16, 32, 0, 1536, 3072, 0)
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


@figure(900, 420)
def tree(tools):
    """The tree of geodesics from one vertex of a torus, and what is replaced in it to make all paths shortest."""
    mesh = tools.torus(36, 18)
    source = 9
    trees = [tools.curves(mesh, '--source', source, *arguments) for arguments in ((), ('--shortest',))]
    lines = [{tuple(line) for line in page.curves.values()} for page in trees]
    panels = []
    for page, own, other in zip(trees, lines, lines[::-1]):
        panel = Panel(size_of(page.points))
        panel.surface(page.points, page.faces)
        panel.tubes([list(line) for line in own & other], BLUE, 0.0035)
        panel.tubes([list(line) for line in own - other], RED if page is trees[0] else GREEN, 0.006)
        panel.balls([page.points[source]], ORANGE, 0.025)
        panel.look((0, -0.9, 1))
        panels.append(panel)
    return panels


@figure(900, 420)
def shortest_path(tools):
    """A geodesic that is only locally shortest (orange), and the shortest path between the same vertices (blue)."""
    mesh = tools.torus(48, 24)
    ends = 6, 620
    tools.run('shortest_path_example', mesh, *ends)
    shortest, = read_vtp(tools.folder / 'shortest_path.vtp')
    page = tools.curves(mesh, '--from', ends[0], '--to', ends[1], '--search', 'dijkstra')
    panels = []
    for view in ((0, -0.9, 1), (0, 0.9, -1)):
        panel = Panel(size_of(page.points))
        panel.surface(page.points, page.faces)
        panel.tubes(page.curves.values(), ORANGE, 0.009)
        panel.tubes([shortest], BLUE, 0.009)
        panel.balls([page.points[v] for v in ends], RED, 0.025)
        panel.look(view)
        panels.append(panel)
    return panels


@figure(900, 440)
def isolines(tools):
    """Curves at the same distances from one vertex of a scan, and the Voronoi diagram of some vertices with isolines."""
    mesh = tools.mesh('bunny00.off')
    points, faces = read_off(mesh)
    graph = Graph(points, faces)
    seeds = [(0.1, 0.05, 0.45), (-0.45, 0.2, 0.3), (0.4, 0.35, 0.2), (0.5, -0.3, 0.2), (-0.1, -0.4, 0.3),
             (-0.15, 0.4, 0.1), (0.25, 0.05, 0.3), (-0.3, -0.1, 0.4), (0.15, -0.2, 0.4), (-0.1, 0.1, 0.3)]
    panels = []
    for sources in ([graph.nearest(seeds[0])], sorted({graph.nearest(seed) for seed in seeds})):
        tools.run('isolines_example', mesh, *sources)
        panel = Panel(size_of(points))
        panel.surface(points, faces)
        panel.tubes(read_vtp(tools.folder / 'isolines.vtp'), BLUE, 0.003)
        if len(sources) > 1:
            panel.tubes(read_vtp(tools.folder / 'voronoi.vtp'), ORANGE, 0.007)
        panel.balls([points[source] for source in sources], RED, 0.022)
        panel.look((0.35, 0.2, 1))
        panels.append(panel)
    return panels


@figure(900, 380)
def spline(tools):
    """A geodesic between points inside faces, and the Bezier curve and the B-spline of four such points."""
    mesh = tools.torus(20, 10)  # on which the example's faces lie well
    page = tools.curves(mesh, '--random', 1)
    tools.run('geodesic_spline_example', mesh)
    geodesic, bezier, b_spline = read_vtp(tools.folder / 'geodesic_spline.vtp')

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
        panel.tubes([b_spline], GREEN, 0.01)
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
