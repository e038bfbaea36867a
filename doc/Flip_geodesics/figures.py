#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws the figures of the manual into fig/, from what the program computes.

    bash examples/run.sh                                builds the program and unpacks CGAL's data set
    python3 doc/Flip_geodesics/figures.py [NAME...]     draws all figures, or those that are named
    python3 doc/Flip_geodesics/figures.py --width 600   draws small ones, to try

Needs VTK, NumPy and Pillow for Python and a virtual screen, in Debian the packages python3-vtk9, python3-numpy,
python3-pil and xvfb, and for the figures of pages the package chromium. A figure is a function here with the decorator
@figure, which returns its panels, or an image. The file in fig/ has the function's name. A picture takes a minute.
"""

import argparse
import math
import os
import shutil
import sys
import tempfile
from pathlib import Path

from PIL import Image

if not os.environ.get('DISPLAY') and shutil.which('xvfb-run'):
    os.execvp('xvfb-run', ['xvfb-run', '-a', sys.executable, *sys.argv])

here = Path(__file__).resolve().parent
root = here.parents[1]
sys.path[:0] = [str(here), str(root / 'examples/Flip_geodesics_program/page')]

from figure_browser import Browser  # noqa: E402
from figure_colors import FIXED, INK, MESH, RESULT, SECOND, START, WHITE  # noqa: E402
from figure_drawing import Panel, size_of, to_image, write_picture  # noqa: E402
from figure_light import frame, unit  # noqa: E402
from figure_pictures import checker, compass  # noqa: E402
from figure_tools import Graph, Tools, read_obj, read_off, read_ply, read_vtp  # noqa: E402

figures = {}
WIDTH = 2400  # of a picture, in pixels
LYING = {'direction': (0, -0.9, 1), 'up': (0, 0, 1)}  # how the generated tori are seen


def figure(height, width=WIDTH):
    """Registers a function of a `Tools` that returns panels, side by side in a picture of that many pixels."""
    def register(function):
        figures[function.__name__] = (function, width, height)
        return function
    return register


def surface_panel(points, faces, **style):
    panel = Panel(size_of(points))
    panel.surface(points, faces, **style)
    return panel


def wire_panel(points, faces, width=0.0025):
    """A surface with its edges."""
    panel = surface_panel(points, faces, is_smooth=False)
    panel.edges(points, faces, width=width)
    return panel


def spread(graph, source, count):
    """Vertices that lie far from each other, in turn the farthest from those before [Gonzalez 1985]."""
    chosen, near = [source], [math.dist(p, graph.points[source]) for p in graph.points]
    while len(chosen) <= count:
        chosen.append(max(range(len(near)), key=near.__getitem__))
        near = [min(d, math.dist(p, graph.points[chosen[-1]])) for d, p in zip(near, graph.points)]
    return chosen[1:]


def in_front(points, x, y, reach=0.03):
    """The foremost vertex, the highest z, about a place in the plane of x and y."""
    return max((v for v, p in enumerate(points) if math.hypot(p[0] - x, p[1] - y) < reach), key=lambda v: points[v][2])


def ring(graph, center, axis, radius, count=8):
    """A loop of edges about a limb: past the vertices that are nearest to points on a circle."""
    u, v = frame(unit(axis))
    angles = [2 * math.pi * k / count for k in range(count)]
    way_points = [graph.nearest([c + radius * (math.cos(t) * a + math.sin(t) * b) for c, a, b in zip(center, u, v)])
                  for t in angles]
    return graph.loop([w for w, before in zip(way_points, way_points[-1:] + way_points) if w != before])


def fan(tools):
    """Geodesics from one vertex of an armadillo to others."""
    mesh = tools.mesh('armadillo.off')
    points, faces = read_off(mesh)
    graph = Graph(points, faces)
    source = graph.nearest((0, 15, -60))
    targets = spread(graph, source, 70)
    page = tools.curves('path', mesh, '--pairs', tools.lines('pairs', [(source, t) for t in targets]))
    panel = surface_panel(points, faces)
    panel.tubes(page.curves.values(), RESULT, 0.005)
    panel.balls([points[t] for t in targets], FIXED, 0.012)
    panel.balls([points[source]], FIXED, 0.03)
    panel.look((-0.2, 0.15, -1))
    return panel


def rings(tools):
    """Closed geodesics about the limbs of a bear."""
    mesh = tools.mesh('bear.off')
    points, faces = read_off(mesh)
    graph = Graph(points, faces)
    places = (((0, 0.3, 0), (0, 1, 0), 0.25), ((0, -0.1, 0), (0, 1, 0), 0.4),  # neck and belly
              ((-0.4, 0.15, 0), (1, -0.2, 0), 0.12), ((0.35, 0.17, 0.1), (1, 0.2, -0.2), 0.12),  # arms
              ((-0.42, -0.55, 0.1), (1, 0.3, -0.5), 0.12), ((0.42, -0.55, 0.1), (1, -0.3, 0.5), 0.12),  # legs
              ((-0.25, 0.78, 0), (1, -1, 0), 0.1), ((0.25, 0.7, 0), (1, 1, 0), 0.1))  # ears
    loops = [ring(graph, *place) for place in places]
    page = tools.curves('loop', mesh, '--loop', tools.lines('loops', loops))
    panel = surface_panel(points, faces)
    panel.dashes([[points[v] for v in loop + loop[:1]] for loop in loops], START, 0.006)
    panel.tubes(page.curves.values(), RESULT, 0.012)
    panel.look((0.15, 0.15, 1))
    return panel


def segments(tools, mesh):
    """A scan in pieces about some of its vertices: a label for each face."""
    points, faces = read_off(mesh)
    graph = Graph(points, faces)
    spiral = [(0.5 * math.sqrt(k / 14), 2.4 * k) for k in range(14)]
    seeds = {graph.nearest((r * math.cos(t), r * math.sin(t), side)) for side in (-0.5, 0.5) for r, t in spiral}
    label = graph.regions(sorted(seeds))
    return points, faces, [max(label[v] for v in f) for f in faces]


def patches(points, faces, labels):
    panel = Panel(size_of(points))
    for region in set(labels):
        panel.surface(points, [f for f, x in zip(faces, labels) if x == region], REGIONS[region % len(REGIONS)])
    return panel


def patchwork(tools):
    """The boundaries of a segmentation, pulled tight."""
    mesh = tools.mesh('bunny00.off')
    points, faces, labels = segments(tools, mesh)
    tight = tools.curves('network', mesh, '--segmentation', tools.lines('labels.seg', [[x] for x in labels]))
    panel = patches(points, faces, labels)
    panel.tubes(tight.curves.values(), RESULT, 0.008)
    panel.look((0.35, 0.2, 1))
    return panel


def spline_on_head(tools):
    """A closed B-spline about the eyes of a lion, and its control polygon."""
    mesh = tools.mesh('lion-head.off')
    points, faces = read_off(mesh)
    places = (-0.08, 0.36), (0.1, 0.22), (0.07, 0.0), (-0.07, -0.12), (-0.2, 0.0), (-0.22, 0.22)
    controls = [in_front(points, *p) for p in places]
    polygon = tools.curves('path', mesh, '--pairs', tools.lines('pairs', zip(controls, controls[1:] + controls[:1])))
    curve = tools.curves('spline', mesh, '--bezier', tools.lines('controls', [('o', *controls)]))
    panel = surface_panel(points, faces)
    panel.dashes(polygon.curves.values(), START, 0.008)
    panel.tubes(curve.curves.values(), RESULT, 0.014)
    panel.balls([points[v] for v in controls], FIXED, 0.032)
    panel.look((-0.3, 0.2, 1))
    return panel


def distances(tools):
    """Isolines of the distance from one vertex of an elephant."""
    mesh = tools.mesh('refined_elephant.off')
    points, faces = read_off(mesh)
    source = Graph(points, faces).nearest((-0.05, -0.1, -0.3))
    levels = ','.join(str(round(0.04 * k, 2)) for k in range(1, 50))
    page = tools.curves('distance', mesh, '--source', source, '--isolines', levels)
    panel = surface_panel(points, faces)
    panel.tubes(page.curves.values(), RESULT, 0.0045)
    panel.balls([points[source]], FIXED, 0.035)
    panel.look((0.8, 0.45, -1))
    return panel


HEAT = '#2166ac', '#92c5de', '#f7f2e8', '#f4a582', '#b2182b'


def heat_panel(tools, mesh, source, target, lines=12):
    """Heat that flows off to a geodesic."""
    tools.run('poisson_example', mesh, source, target)
    points, faces, heat = read_ply(tools.folder / 'poisson.ply', 'u')
    most = max(heat)
    panel = Panel(size_of(points))
    panel.colored_surface(points, faces, heat, [(most * k / 4, name) for k, name in enumerate(HEAT)])
    panel.contours(points, faces, heat, [most * k / lines for k in range(1, lines)], INK, 0.0018)
    panel.tubes(tools.curves('path', mesh, '--from', source, '--to', target).curves.values(), WHITE, 0.012)
    panel.balls([points[source], points[target]], FIXED, 0.026)
    return panel


def heated_dinosaur(tools):
    mesh = tools.mesh('diplodocus.off')
    graph = Graph(*read_off(mesh))
    panel = heat_panel(tools, mesh, graph.nearest((-0.25, 0.1, 0.3)), graph.nearest((0.4, 0.45, 0.1)))
    panel.look((0.5, 0.25, 1))
    return panel


@figure(500)
def teaser(tools):
    """Six surfaces with what can be had on them."""
    return [draw(tools) for draw in (fan, rings, patchwork, spline_on_head, distances, heated_dinosaur)]


def detour_path(graph):
    """A path of edges on a coarse surface that makes a detour."""
    way = [graph.nearest(p) for p in ((0.08, 0.1, 0.13), (0.17, 0.08, 0.19), (0.22, 0.02, 0.17), (0.17, 0.02, 0),
                                      (0.22, 0.02, -0.17), (0.17, 0.08, -0.19), (0.08, 0.1, -0.13))]
    return [v for a, b in zip(way, way[1:]) for v in graph.path(a, b)[:-1]] + way[-1:]


def detour(tools, *arguments):
    """The path with the detour, straightened."""
    mesh = tools.mesh('eight.off')
    path = detour_path(Graph(*read_off(mesh)))
    command = 'refine' if {'--refine', '--delaunay'} & set(arguments) else 'path'
    return tools.curves(command, mesh, '--edges', tools.lines('path', [path]), *arguments)


NEAR = {'direction': (0.9, 1, 0.1), 'target': (0.095, 0.085, 0.0), 'zoom': 2.3}


def intrinsic_edges(page, state):
    """All edges of the triangulation of the first run at a state."""
    return [[page.points[v] for v in side] for side in untouched_sides(page)] + state.edges


def untouched_sides(page):
    """The edges of the mesh that take no part in the first run."""
    sides = {frozenset((f[i], f[i - 1])) for f in page.faces for i in range(3)}
    return sides - {frozenset((a, b)) for _, a, b in page.runs[0].input_edges}


def ends_of(page):
    return [line[k] for line in page.curves.values() for k in (0, -1)]


@figure(1060)
def conforming_triangulation(tools):
    """A coarse mesh, and the intrinsic triangulation that has a geodesic as edges."""
    page = detour(tools)
    run = page.runs[0]
    state = run.state(-1)
    inputs = {edge for edge, _, _ in run.input_edges}
    before = wire_panel(page.points, page.faces)
    before.dashes(run.state(0).lines, START, 0.012)
    after = surface_panel(page.points, page.faces, is_smooth=False)
    sides = untouched_sides(page) | {frozenset((a, b)) for edge, a, b in run.input_edges if edge in state.present}
    after.tubes([[page.points[v] for v in side] for side in sides], MESH, 0.0025)
    after.tubes([run.polylines[e] for e in state.present - inputs], SECOND, 0.0045)
    after.tubes(state.lines, RESULT, 0.012)
    for panel in (before, after):
        panel.balls(ends_of(page), FIXED, 0.03)
        panel.look(**NEAR)
    return [before, after]


def flip_panel(page, step):
    """A state of a shortening: the edges that the last step has flipped are green."""
    run = page.runs[0]
    state = run.state(step)
    panel = surface_panel(page.points, page.faces, is_smooth=False)
    panel.tubes([[page.points[v] for v in side] for side in untouched_sides(page)], INK, 0.0018)
    panel.tubes(state.edges, INK, 0.0025)
    panel.tubes([run.polylines[e] for e in state.fresh], SECOND, 0.007)
    if 0 < step < len(run.steps):
        panel.tubes(state.lines, RESULT, 0.010)
    elif step == 0:
        panel.dashes(state.lines, START, 0.012)
    else:
        panel.tubes(state.lines, RESULT, 0.012)
    panel.balls(ends_of(page), FIXED, 0.03)
    panel.look(**NEAR)
    return panel


@figure(560, 1120)
def flips_animation(tools):
    """A shortening flip by flip, with the start behind."""
    page = detour(tools)
    run = page.runs[0]
    steps = [0, *(k + 1 for k, (flipped, *_) in enumerate(run.steps) if flipped), len(run.steps)]
    frames = []
    for step in steps:
        panel = flip_panel(page, step)
        if step > 0:
            panel.dashes(run.state(0).lines, START, 0.006)
        panel.look(**{**NEAR, 'zoom': 1.75})  # wider than high
        frames.append([panel])
    return Animation(frames)


@figure(620)
def flips(tools):
    """Four states of a shortening, close by."""
    page = detour(tools)
    count = len(page.runs[0].steps)
    with_flips = [step for step in range(1, count) if page.runs[0].steps[step - 1][0]]
    return [flip_panel(page, step) for step in (0, *with_flips[len(with_flips) // 4::len(with_flips) // 2][:2], count)]


REGIONS = '#b9c4d6', '#d8cdb4', '#b7d0bd', '#d6b9c1', '#c7bfdb', '#cfd3a8', '#a9ccd3'


@figure(860)
def network(tools):
    """Boundaries of a segmentation of a scan: as edges, pulled tight, and stopped early with free junctions."""
    mesh = tools.mesh('bunny00.off')
    points, faces, labels = segments(tools, mesh)
    segmentation = tools.lines('labels.seg', [[x] for x in labels])
    tight = tools.curves('network', mesh, '--segmentation', segmentation)
    free = tools.curves('network', mesh, '--segmentation', segmentation, '--free-junctions', '--stop-length', 0.85)
    panels = [patches(points, faces, labels) for _ in range(3)]
    panels[0].dashes(tight.runs[0].state(0).lines, START, 0.006)
    panels[1].tubes(tight.curves.values(), RESULT, 0.006)
    panels[2].tubes(free.curves.values(), RESULT, 0.006)
    for panel in panels:
        panel.look((0.35, 0.2, 1))
    return panels


@figure(1000)
def early_stop(tools):
    """A network whose curves were stopped at 95 % of their lengths; and pulled tight."""
    mesh = tools.mesh('refined_elephant.off')
    points, faces = read_off(mesh)
    panels = []
    for ratio in (0.95, 0):
        tools.run('network_early_stop_example', mesh, ratio)
        panel = surface_panel(points, faces)
        panel.tubes(read_vtp(tools.folder / 'network.vtp'), RESULT, 0.009)
        panel.look((0.8, 0.45, -1))
        panels.append(panel)
    return panels


@figure(960)
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
    page = tools.curves('network', mesh, '--seams')
    panels = []
    for is_tight in (False, True):
        panel = surface_panel(page.points, page.faces)
        faces = [(k, k + 1, k + 2) for k in range(0, len(corners), 3)]
        for axis, count in ((0, 24), (1, 12)):
            levels = [(k + 0.5) / count for k in range(2 * count)]
            panel.contours(corners, faces, [p[axis] for p in plane], levels, INK, 0.0012)
        if is_tight:
            panel.tubes(page.curves.values(), RESULT, 0.01)
        else:
            panel.dashes(page.runs[0].state(0).lines, START, 0.01)
        panel.look((0.75, -0.35, 1), up=(0, 0, 1))
        panels.append(panel)
    return panels


@figure(960)
def drawn_polyline(tools):
    """A polyline across the faces of a mesh; the edges that it is snapped to, and the geodesic that it becomes."""
    mesh = tools.torus(48, 24)
    tools.run('drawn_polyline_example', mesh)
    drawn, tight, snapped = read_vtp(tools.folder / 'drawn_polyline.vtp')
    points, faces = read_off(mesh)
    before, after = wire_panel(points, faces, 0.0015), wire_panel(points, faces, 0.0015)
    before.dashes([drawn], START, 0.011)
    after.tubes([snapped], SECOND, 0.008)
    after.tubes([tight], RESULT, 0.011)
    for panel in (before, after):
        panel.look((0, -0.6, 1), up=(0, 0, 1))
    return [before, after]


@figure(960)
def loops(tools):
    """Closed curves on a torus with bumps, before and after."""
    around, along = 96, 48
    start = [[around // 8 * i * along + j for j in range(along)] for i in range(8)]
    start.append([i * along + (round(6 * math.sin(10 * math.pi * i / around)) + 12) % along for i in range(around)])
    start[-1] = staircase(start[-1], along)
    page = tools.curves('loop', tools.torus(around, along), '--loop', tools.lines('loops', start))
    before, after = (surface_panel(page.points, page.faces) for _ in range(2))
    before.dashes([[page.points[v] for v in loop + loop[:1]] for loop in start], START, 0.009)
    after.tubes(page.curves.values(), RESULT, 0.009)
    for panel in (before, after):
        panel.look(**LYING)
    return [before, after]


@figure(1160)
def loop_basis(tools):
    """Closed geodesics around the handles of two surfaces, found from the surfaces alone."""
    panels = []
    for name, view in (('refined_elephant.off', (0.8, 0.45, -1)), ('eight.off', (0.75, 1, 0.3))):
        mesh = tools.mesh(name)
        points, faces = read_off(mesh)
        tools.run('loop_basis_example', mesh)
        panel = surface_panel(points, faces)
        panel.tubes(read_vtp(tools.folder / 'loop_basis.vtp'), RESULT, 0.01)
        panel.look(view)
        panels.append(panel)
    return panels


@figure(1000)
def handles_and_tunnels(tools):
    """Closed geodesics about the handles (blue) and the tunnels (green) of two solids."""
    panels = []
    for name, view in (('refined_elephant.off', (0.8, 0.45, -1)), ('eight.off', (0.75, 1, 0.3))):
        mesh = tools.mesh(name)
        tools.run('handle_and_tunnel_loops_example', mesh)
        panel = surface_panel(*read_off(mesh))
        for kind, color in (('handles', RESULT), ('tunnels', SECOND)):
            panel.tubes(read_vtp(tools.folder / f'{kind}.vtp'), color, 0.012)
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


@figure(1100)
def poisson(tools):
    """The temperature of surfaces that are heated evenly and kept at zero along a geodesic."""
    bunny = heat_panel(tools, tools.mesh('bunny00.off'), 13512, 11509)
    bunny.look((-0.35, 0.2, -1))
    return [bunny, heated_dinosaur(tools)]


@figure(1200)
def cross_field(tools):
    """The smoothest field of crosses that runs along a geodesic, on a torus."""
    mesh = tools.torus(72, 36)
    source, target = 9, 1340
    tools.run('cross_field_example', mesh, source, target)
    page = tools.curves('path', mesh, '--from', source, '--to', target)
    panel = surface_panel(page.points, page.faces)
    panel.tubes(read_vtp(tools.folder / 'cross_field.vtp'), SECOND, 0.003)
    panel.tubes(page.curves.values(), RESULT, 0.01)
    panel.balls(ends_of(page), FIXED, 0.025)
    panel.look((0, -0.8, 1), up=(0, 0, 1))
    return [panel]


@figure(800)
def refinement(tools):
    """A coarse mesh with a geodesic as edges; the refined triangulation; its common subdivision with the mesh."""
    result = tools.folder / 'result.off'
    panels = []
    for arguments in (('--insert', result), ('--refine', 25), ('--refine', 25, '--subdivision', result)):
        page = detour(tools, *arguments)
        if result in arguments:
            panel = wire_panel(*read_off(result))
        else:
            panel = surface_panel(page.points, page.faces, is_smooth=False)
            panel.tubes(intrinsic_edges(page, page.runs[0].state(-1)), INK, 0.0025)
        panel.tubes(page.curves.values(), RESULT, 0.01)
        panel.balls(ends_of(page), FIXED, 0.028)
        panel.look(**NEAR)
        panels.append(panel)
    return panels


@figure(1060)
def delaunay(tools):
    """The triangulation about a geodesic as flips have left it, and flipped to constrained Delaunay."""
    panels = []
    for arguments in ((), ('--delaunay',)):
        page = detour(tools, *arguments)
        state = page.runs[0].state(-1)
        panel = surface_panel(page.points, page.faces, is_smooth=False)
        panel.tubes(intrinsic_edges(page, state), INK, 0.003)
        panel.tubes(state.lines, RESULT, 0.012)
        panel.balls(ends_of(page), FIXED, 0.03)
        panel.look(**NEAR)
        panels.append(panel)
    return panels


@figure(1000)
def cut(tools):
    """A torus, cut open along closed geodesics into pieces, which are moved apart."""
    around, along = 96, 48
    mesh = tools.torus(around, along)
    loops = [['o', *(i * along + j for j in range(along))] for i in range(0, around, around // 3)]
    result = tools.folder / 'cut.off'
    network = tools.lines('network', loops)
    tools.run('flip_geodesics', 'network', mesh, '--network', network, '--cut', result, '--quiet')
    points, faces = read_off(result)
    pieces = Graph(points, faces).components()
    panels = []
    for distance in (0, 0.25):
        moved = list(points)
        for piece in pieces:
            middle = [sum(points[v][i] for v in piece) / len(piece) for i in range(3)]
            for v in piece:
                moved[v] = tuple(x + distance * m for x, m in zip(points[v], middle))
        panel = surface_panel(moved, faces)
        panel.tubes(boundaries(moved, faces), RESULT, 0.01)
        panel.look(**LYING)
        panels.append(panel)
    return panels


def boundaries(points, faces):
    """The edges of one face only."""
    owners = {}
    for f in faces:
        for i in range(3):
            owners.setdefault(frozenset((f[i - 1], f[i])), []).append(f)
    return [[points[v] for v in edge] for edge, owning in owners.items() if len(owning) == 1]


@figure(1000)
def flattening(tools):
    """A torus cut open along two geodesic loops and flattened, with lines of equal texture coordinates."""
    tools.run('flattening_example', tools.torus(96, 48), 0, 16, 32, 0, 1536, 3072, 0)
    mesh = read_obj(tools.folder / 'flattening.obj')
    corners = [mesh['v'][v] for face in mesh['f'] for v in face]
    flat = [(x, y, 0.0) for x, y in mesh['vt']]
    faces = [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(mesh['f']))]
    panels = []
    for points, view in ((corners, LYING), (flat, {'direction': (0, 0, 1), 'up': (1, 0, 0), 'has_ground': False})):
        panel = surface_panel(points, faces, is_smooth=False)
        for axis, color in ((0, RESULT), (1, SECOND)):
            values = [p[axis] for p in flat]
            step = 0.1
            first, last = round(min(values) / step), round(max(values) / step)
            panel.contours(points, faces, values, [step * k for k in range(first, last + 1)], color, 0.002)
        panel.look(**view)
        panels.append(panel)
    return panels


def is_torn(points, plane, face):
    """Is a side of a face much longer in a plane than in space, as where shortest paths arrive from two sides?"""
    return any(math.dist(plane[v], plane[w]) > 6 * math.dist(points[v], points[w])
               for v, w in zip(face, face[1:] + face[:1]))


@figure(1160)
def logarithmic_map(tools):
    """The plane about one vertex, a grid and circles, laid over a scan by the logarithmic map."""
    mesh = tools.mesh('bunny00.off')
    start = tools.curves('path', mesh, '--random', 1)
    source = Graph(start.points, start.faces).nearest((0.1, 0.05, 0.45))
    tools.run('geodesic_tree_example', mesh, source)
    data = read_obj(tools.folder / 'logarithmic_map.obj')
    points, plane = data['v'], data['vt']
    panels = []
    for numbers in (([x for x, _ in plane], [y for _, y in plane]), ([math.hypot(x, y) for x, y in plane],)):
        panel = surface_panel(points, data['f'])
        near = [f for f in data['f'] if all(math.hypot(*plane[v]) < 0.62 for v in f)]
        if len(numbers) > 1:  # circles do not tear
            near = [f for f in near if not is_torn(points, plane, f)]
        for values, name in zip(numbers, (RESULT, SECOND)):
            panel.contours(points, near, values, [0.05 * k + 0.001 for k in range(-13, 13)], name, 0.0035)
        panel.balls([points[source]], FIXED, 0.022)
        panel.look((0.35, 0.2, 1))
        panels.append(panel)
    return panels


@figure(1160)
def straightest(tools):
    """Straightest geodesics from one vertex in all directions, short ones and long ones."""
    mesh = tools.mesh('bunny00.off')
    points, faces = read_off(mesh)
    source = Graph(points, faces).nearest((0.27, -0.03, 0.4))
    panels = []
    for length, view in ((0.4, (0.35, 0.2, 1)), (1.2, (-0.35, 0.2, 1))):
        tools.run('trace_geodesic_example', mesh, length, source)
        rays = read_vtp(tools.folder / 'rays.vtp')
        panel = surface_panel(points, faces)
        panel.tubes(rays, RESULT, 0.006)
        panel.balls([ray[-1] for ray in rays], SECOND, 0.014)
        panel.balls([points[source]], FIXED, 0.026)
        panel.look(view)
        panels.append(panel)
    return panels


def face_along(points, faces, place, right, reach=0.04):
    """A face about a place, of which the first halfedge, from its last vertex on, runs in about this direction."""
    def turn(f):
        side = [b - a for a, b in zip(points[f[-1]], points[f[0]])]
        return sum(a * b for a, b in zip(side, right)) / math.hypot(*side)

    return max((i for i, f in enumerate(faces) if math.dist(points[f[0]], place) < reach), key=lambda i: turn(faces[i]))


@figure(1160)
def decal(tools):
    """A compass rose on a scan, and a board that is so large that it tears."""
    mesh = tools.mesh('bunny00.off')
    points, faces = read_off(mesh)
    graph = Graph(points, faces)
    panels = []
    for place, size, picture, view in (((0.27, -0.03, 0.4), 0.66, compass(), (0.35, 0.2, 1)),
                                       ((0.3, 0, 0.4), 2.4, checker(24), (-0.35, 0.2, 1))):
        middle = points[graph.nearest(place)]
        tools.run('decal_example', mesh, face_along(points, faces, middle, (0.95, 0, -0.3)), size)
        data = read_obj(tools.folder / 'decal.obj')
        panel = Panel(size_of(points))
        panel.textured_surface(data['v'], data['f'], data['ft'], data['vt'], picture)
        panel.look(view)
        panels.append(panel)
    return panels


@figure(900)
def tree(tools):
    """The tree of geodesics from one vertex, and what is replaced in it to make all paths shortest."""
    mesh = tools.mesh('eight.off')
    source = Graph(*read_off(mesh)).nearest((0.14, 0.1, 0.1))
    trees = [tools.curves('log', mesh, '--source', source, *arguments) for arguments in ((), ('--shortest',))]
    lines = [{tuple(line) for line in page.curves.values()} for page in trees]
    panels = []
    for page, own, other in zip(trees, lines, lines[::-1]):
        panel = surface_panel(page.points, page.faces, is_smooth=False)
        panel.tubes([list(line) for line in own & other], RESULT, 0.005)
        if page is trees[0]:
            panel.tubes([list(line) for line in own - other], START, 0.009)
        else:
            panel.tubes([list(line) for line in own - other], SECOND, 0.009)
        panel.balls([page.points[source]], FIXED, 0.028)
        panel.look((0.75, 1, 0.2))
        panels.append(panel)
    return panels


@figure(1000)
def shortest_path(tools):
    """A geodesic that is only locally shortest (dashed), and the shortest path between the same vertices."""
    mesh = tools.torus(96, 48)
    ends = 12, 2440
    tools.run('shortest_path_example', mesh, *ends)
    shortest, = read_vtp(tools.folder / 'shortest_path.vtp')
    page = tools.curves('path', mesh, '--from', ends[0], '--to', ends[1], '--search', 'dijkstra')
    panels = []
    for view in (LYING, {'direction': (0, 0.9, 1), 'up': (0, 0, 1)}):
        panel = surface_panel(page.points, page.faces)
        panel.dashes(page.curves.values(), START, 0.012)
        panel.tubes([shortest], RESULT, 0.012)
        panel.balls([page.points[v] for v in ends], FIXED, 0.03)
        panel.look(**view)
        panels.append(panel)
    return panels


def transport_panel(tools, mesh, points, faces, face, radius):
    tools.run('parallel_transport_example', mesh, face, radius)
    arrows = read_vtp(tools.folder / 'arrows.vtp')
    panel = surface_panel(points, faces)
    panel.tubes(arrows, RESULT, 0.005)
    panel.balls([arrow[0] for arrow in arrows], SECOND, 0.011)
    panel.balls([[sum(points[v][i] for v in faces[face]) / 3 for i in range(3)]], FIXED, 0.026)
    return panel


@figure(1000)
def parallel_transport(tools):
    """A direction carried from one place to all vertices about it, on two surfaces."""
    panels = []
    for mesh, place, right, radius, view in (
            (tools.torus(48, 24), (0, -1, 0.5), (1, 0, 0), 1.6, {'direction': (0, -0.75, 1), 'up': (0, 0, 1)}),
            (tools.mesh('eight.off'), (0.14, 0.1, 0.1), (0, 0, 1), 0.45, {'direction': (0.75, 1, 0.3)})):
        points, faces = read_off(mesh)
        middle = points[Graph(points, faces).nearest(place)]
        panel = transport_panel(tools, mesh, points, faces, face_along(points, faces, middle, right, 0.1), radius)
        panel.look(**view)
        panels.append(panel)
    return panels


@figure(1000)
def means(tools):
    """Points at equal lengths on the shortest paths from some vertices to their mean."""
    panels = []
    for name, places, view in (
            ('bunny00.off', ((-0.3, -0.1, 0.4), (0.4, -0.4, 0.4), (0.15, 0.3, 0.4)), (0.35, 0.2, 1)),
            ('bear.off', ((-0.3, 0.1, 0.3), (0.3, 0.1, 0.3), (-0.4, -0.6, 0.3), (0.4, -0.6, 0.3), (0, 0.6, 0.3)),
             (0.15, 0.15, 1))):
        mesh = tools.mesh(name)
        points, faces = read_off(mesh)
        graph = Graph(points, faces)
        vertices = [graph.nearest(place) for place in places]
        tools.run('means_example', mesh, *vertices)
        paths = read_vtp(tools.folder / 'mean.vtp')
        panel = surface_panel(points, faces)
        panel.balls([p for path in paths for p in path[1:-1]], RESULT, 0.016)
        panel.balls([paths[0][-1]], SECOND, 0.035)
        panel.balls([points[v] for v in vertices], FIXED, 0.03)
        panel.look(view)
        panels.append(panel)
    return panels


GREENS = SECOND, '#33a67f', '#66bf9d', '#95d5b9', '#bfe7d4'


def ways_panel(tools, mesh, ends, number, obstacles=()):
    """The shortest paths of several classes, the shortest blue and the others the lighter the longer, and obstacles."""
    tools.run('other_ways_example', mesh, *ends, number, *sorted(obstacles))
    points, faces = read_off(mesh)
    panel = surface_panel(points, [f for i, f in enumerate(faces) if i not in obstacles])
    if obstacles:
        panel.surface(points, [faces[i] for i in obstacles], FIXED)
    paths = read_vtp(tools.folder / 'other_ways.vtp')
    for k, (path, name) in enumerate(zip(paths, (RESULT, *GREENS))):
        panel.tubes([path], name, 0.012 - 0.0006 * k)  # where two run together, the shorter one shows
    panel.balls([points[v] for v in ends], FIXED, 0.03)
    return panel


@figure(1000)
def other_ways(tools):
    """The shortest paths of several classes on a torus, and about two obstacles on the head of a lion."""
    around, along = 96, 48
    torus = ways_panel(tools, tools.torus(around, along), (62 * along + 8, 82 * along + 8), 5)
    torus.look((0, -0.75, 1), up=(0, 0, 1))
    mesh = tools.mesh('lion-head.off')
    points, faces = read_off(mesh)
    eyes = (-0.2, 0.13), (0.07, 0.13)
    obstacles = {i for i, f in enumerate(faces) for eye in eyes
                 if max(math.dist(points[v][:2], eye) for v in f) < 0.052 and points[f[0]][2] > 0}
    head = ways_panel(tools, mesh, [in_front(points, *p) for p in ((-0.3, 0.07), (0.18, 0.07))], 4, obstacles)
    head.look((-0.3, 0.2, 1), target=(-0.07, 0.1, 0.3), zoom=1.5)
    return [torus, head]


@figure(1160)
def isolines(tools):
    """Curves at the same distances from one vertex, and the Voronoi diagram of several with isolines."""
    mesh = tools.mesh('bunny00.off')
    points, faces = read_off(mesh)
    graph = Graph(points, faces)
    seeds = [(0.1, 0.05, 0.45), (-0.45, 0.2, 0.3), (0.4, 0.35, 0.2), (0.5, -0.3, 0.2), (-0.1, -0.4, 0.3),
             (-0.15, 0.4, 0.1), (0.25, 0.05, 0.3), (-0.3, -0.1, 0.4), (0.15, -0.2, 0.4), (-0.1, 0.1, 0.3)]
    sources = sorted({graph.nearest(seed) for seed in seeds})
    tools.run('isolines_example', mesh, *sources)
    panel = surface_panel(points, faces)
    panel.tubes(read_vtp(tools.folder / 'isolines.vtp'), RESULT, 0.0035)
    panel.tubes(read_vtp(tools.folder / 'voronoi.vtp'), SECOND, 0.009)
    panel.balls([points[source] for source in sources], FIXED, 0.024)
    panel.look((0.35, 0.2, 1))
    return [distances(tools), panel]


@figure(1000)
def spline(tools):
    """The Bezier curve and the B-spline of four control points on a scan, and a closed B-spline on a lion's head."""
    mesh = tools.mesh('bunny00.off')
    points, faces = read_off(mesh)
    controls = [in_front(points, *p) for p in ((-0.12, -0.3), (-0.02, 0.05), (0.3, -0.02), (0.36, -0.32))]
    panel = surface_panel(points, faces)
    polygon = tools.curves('path', mesh, '--pairs', tools.lines('pairs', zip(controls, controls[1:])))
    panel.dashes(polygon.curves.values(), START, 0.009)
    for kind, name in (((), RESULT), (('s',), SECOND)):
        curve = tools.curves('spline', mesh, '--bezier', tools.lines('controls', [(*kind, *controls)]))
        panel.tubes(curve.curves.values(), name, 0.012)
    panel.balls([points[v] for v in controls], FIXED, 0.03)
    panel.look((0.35, 0.2, 1))
    return [panel, spline_on_head(tools)]


@figure(208, 208)
def flip_geodesics_small(tools):
    """The small picture of the package overview."""
    page = detour(tools)
    panel = wire_panel(page.points, page.faces, 0.006)
    panel.dashes([page.runs[0].state(0).lines[0]], START, 0.026)
    panel.tubes(page.curves.values(), RESULT, 0.034)
    panel.balls(ends_of(page), FIXED, 0.055)
    panel.look(**{**NEAR, 'zoom': 2.2})
    return [panel]


@figure(1500)
def page(tools):
    """The page of --page in a browser, in the middle of a shortening."""
    path = tools.folder / 'curves.html'
    mesh = tools.mesh('eight.off')
    graph = Graph(*read_off(mesh))
    others = ((0.2, 0, 0.3), (0, 0.1, 0.48)), ((0.2, 0, -0.3), (0, 0.1, -0.48))
    paths = [detour_path(graph), *(graph.path(*map(graph.nearest, ends)) for ends in others)]
    tools.run('flip_geodesics', 'path', mesh, '--edges', tools.lines('paths', paths), '--quiet', '--page', path)
    with Browser(tools.folder, 1200, 750) as browser:
        browser.open(f'{path.as_uri()}#curve=0&step=6&edges=1')
        browser.wait('document.documentElement.dataset.state === "ready"')
        return browser.picture()


@figure(1560)
def live_page(tools):
    """The page of the command view in a browser: a path through points that were clicked, and its certificate."""
    path = tools.folder / 'live.html'
    tools.run('flip_geodesics', 'view', tools.torus(120, 48), '--quiet', '--output', path)
    state = 'document.documentElement.dataset'
    with Browser(tools.folder, 1200, 780) as browser:
        browser.open(path.as_uri())
        browser.wait(f'{state}.state && {state}.revision')
        browser.value('document.getElementById("clear").click()')
        for place in ((200, 560), (260, 300), (520, 160), (700, 470)):
            before = browser.value(f'{state}.revision')
            browser.click(*place)
            browser.wait(f'{state}.revision !== "{before}"')
        return browser.picture()


class Animation:
    """Pictures one after the other; the first and the last stay longer."""

    def __init__(self, frames):
        self.frames = frames

    def write(self, path, width, height):
        images = [to_image(panels, width, height) for panels in self.frames]
        times = [1500] + [400] * (len(images) - 2) + [3000]
        images[0].save(path, save_all=True, append_images=images[1:], duration=times, loop=0, quality=82, method=6)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--build', type=Path, default=root / 'build/examples', help='where examples/run.sh has built')
    parser.add_argument('--out', type=Path, default=here / 'fig')
    parser.add_argument('--width', type=int, default=WIDTH, help='of pictures, in pixels')
    parser.add_argument('names', nargs='*', help=', '.join(figures))
    options = parser.parse_args()
    if unknown := set(options.names) - set(figures):
        sys.exit(f'figures.py: no figure {", ".join(unknown)}; there are {", ".join(figures)}')
    for name in options.names or figures:
        draw, width, height = figures[name]
        scale = options.width / WIDTH
        with tempfile.TemporaryDirectory() as folder:
            result = draw(Tools(options.build.resolve(), folder))
            is_moving = isinstance(result, Animation)
            path = options.out / f'{name}.{"png" if name == "flip_geodesics_small" else "webp"}'
            size = round(scale * width), round(scale * height)
            if is_moving:
                result.write(path, *size)
            else:
                write_picture(path, result if isinstance(result, Image.Image) else to_image(result, *size))
            print(f'{path.name}: {path.stat().st_size // 1000} kB', flush=True)


if __name__ == '__main__':
    main()
