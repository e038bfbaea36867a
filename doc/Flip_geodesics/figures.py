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
from collections import Counter
from pathlib import Path

import numpy as np
from PIL import Image

if not os.environ.get('DISPLAY') and shutil.which('xvfb-run'):
    os.execvp('xvfb-run', ['xvfb-run', '-a', sys.executable, *sys.argv])

here = Path(__file__).resolve().parent
root = here.parents[1]
sys.path[:0] = [str(here), str(root / 'examples/Flip_geodesics_program/page')]

from figure_browser import Browser  # noqa: E402
from figure_colors import FIFTH, FIXED, FOURTH, INK, MESH, RESULT, SECOND, START, SURFACE, THIRD, WHITE  # noqa: E402
from figure_drawing import Panel, axes_of, save_small, seen_height, size_of, to_image, write_picture  # noqa: E402
from figure_light import frame, unit  # noqa: E402
from figure_pictures import checker, compass  # noqa: E402
from figure_tools import Graph, Tools, read_obj, read_off, read_ply, read_vtp  # noqa: E402

figures = {}
WIDTH = 2400  # of a picture, in pixels
LYING = {'direction': (0, -0.9, 1), 'up': (0, 0, 1)}  # how the generated tori are seen


def figure(height, width=WIDTH, columns=None):
    """Registers a function of a `Tools` that returns panels, in rows of `columns` in a picture of that many pixels."""
    def register(function):
        figures[function.__name__] = (function, width, height, columns)
        return function
    return register


def surface_panel(points, faces, **style):
    panel = Panel(size_of(points))
    panel.surface(points, faces, **style)
    return panel


def panel_in_view(points, faces, view, aspect=1.2, **style):
    """A surface seen from somewhere, whose curves are as thick as those of other surfaces in panels of this shape."""
    panel = Panel(size_of(points), seen_height(points, aspect, **view))
    panel.surface(points, faces, **style)
    panel.look(**view)
    return panel


def length_of(line):
    return sum(map(math.dist, line, line[1:]))


def wire_panel(points, faces, width=0.0025, name=INK):
    """A surface with its edges."""
    panel = surface_panel(points, faces, is_smooth=False)
    panel.edges(points, faces, name, width)
    return panel


def spread(graph, source, count):
    """Vertices that lie far from each other, in turn the farthest from those before [G85]."""
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
    targets = spread(graph, source, 40)
    page = tools.curves('path', mesh, '--pairs', tools.lines('pairs', [(source, t) for t in targets]))
    panel = panel_in_view(points, faces, {'direction': (-0.2, 0.15, -1)})
    panel.tubes(page.curves.values(), RESULT, 0.011)
    panel.balls([points[t] for t in targets], FIXED, 0.025)
    panel.balls([points[source]], FIXED, 0.045)
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
    panel = panel_in_view(points, faces, {'direction': (0.15, 0.15, 1)})
    panel.dashes([[points[v] for v in loop + loop[:1]] for loop in loops], START, 0.013)
    panel.tubes(page.curves.values(), RESULT, 0.017)
    return panel


def segments(tools, mesh):
    """A scan in pieces about some of its vertices: a label for each face."""
    points, faces = read_off(mesh)
    graph = Graph(points, faces)
    spiral = [(0.5 * math.sqrt(k / 14), 2.4 * k) for k in range(14)]
    seeds = {graph.nearest((r * math.cos(t), r * math.sin(t), side)) for side in (-0.5, 0.5) for r, t in spiral}
    label = graph.regions(sorted(seeds))
    return points, faces, colored(faces, [max(label[v] for v in f) for f in faces])


def colored(faces, labels):
    """Labels from 0 on, as few as a greedy coloring takes, so that regions that share an edge have different ones."""
    regions, owners, beside = connected_regions(faces, labels), {}, {}
    for f, region in zip(faces, regions):
        beside.setdefault(region, set())
        for k in range(3):
            other = owners.setdefault(frozenset((f[k - 1], f[k])), region)
            if other != region:
                beside[region].add(other)
                beside[other].add(region)
    color = {}
    for region in beside:
        color[region] = min(set(range(len(beside))) - {color.get(other) for other in beside[region]})
    return [color[region] for region in regions]


FRONT = {'direction': (0.35, 0.2, 1)}  # how the bunny is seen


def patches(points, faces, labels, view=None):
    """A surface with a color per label of its faces, and without one below 0."""
    panel = Panel(size_of(points), seen_height(points, 1.2, **view) if view else None)
    for region in sorted(set(labels)):
        panel.surface(points, [f for f, x in zip(faces, labels) if x == region],
                      REGIONS[region % len(REGIONS)] if region >= 0 else SURFACE)
    if view:
        panel.look(**view)
    return panel


def connected_regions(faces, labels):
    """A number per face, the same for faces of one label that are connected."""
    owners, parent = {}, list(range(len(faces)))

    def root(i):
        while parent[i] != i:
            parent[i] = i = parent[parent[i]]
        return i

    for i, f in enumerate(faces):
        for k in range(3):
            other = owners.setdefault(frozenset((f[k - 1], f[k])), i)
            if labels[i] == labels[other]:
                parent[root(i)] = root(other)
    return [root(i) for i in range(len(faces))]


def labels_of_pieces(points, faces, labels, cut_points, cut_faces):
    """The labels of a mesh that was cut along their boundaries after these were moved: a piece has the label that most
    of its vertices had before; -1 where another piece has it, as between boundaries that are moved apart."""
    owners = {}
    for f, label in zip(faces, labels):
        for v in f:
            owners.setdefault(tuple(round(x, 9) for x in points[v]), set()).add(label)
    pieces, votes = Graph(cut_points, cut_faces).components(), []
    for number, piece in enumerate(pieces):
        count = Counter(label for v in piece for label in owners.get(tuple(round(x, 9) for x in cut_points[v]), ()))
        votes += [(n, label, number) for label, n in count.items()]
    label_of, taken = {}, set()
    for _, label, number in sorted(votes, reverse=True):
        if number not in label_of and label not in taken:
            label_of[number] = label
            taken.add(label)
    of_vertex = {v: label_of.get(number, -1) for number, piece in enumerate(pieces) for v in piece}
    return [of_vertex[f[0]] for f in cut_faces]


def cut_patches(tools, mesh, labels, view, *options):
    """The boundaries of regions after shortening, and the surface with the colors of the regions between them."""
    cut_mesh = tools.folder / 'cut.off'
    segmentation = tools.lines('labels.seg', [[x] for x in labels])
    page = tools.curves('network', mesh, '--segmentation', segmentation, '--cut', cut_mesh, *options)
    cut_points, cut_faces = read_off(cut_mesh)
    points, faces = read_off(mesh)
    regions = connected_regions(faces, labels)
    moved = labels_of_pieces(points, faces, regions, cut_points, cut_faces)
    moved = [labels[region] if region >= 0 else -1 for region in moved]  # regions have the numbers of faces
    return page, patches(cut_points, cut_faces, moved, view)


def patchwork(tools):
    """The boundaries of a segmentation, shortened."""
    mesh = tools.mesh('bunny00.off')
    page, panel = cut_patches(tools, mesh, segments(tools, mesh)[2], FRONT)
    panel.tubes(page.curves.values(), RESULT, 0.013)
    return panel


def draw_controls(panel, points, is_numbered=True):
    """Control points, with numbers on the far sides of their middle."""
    panel.balls(points, FIXED, 0.035)
    right, up = axes_of(panel.direction, panel.up)[:2]
    for k, p in enumerate(points if is_numbered else ()):
        away = unit(np.subtract(p, np.mean(points, axis=0)))
        x, y = unit((away @ right, away @ up))
        panel.label(p, str(k + 1), FIXED, shift=(1.3 * x, -1.3 * y))


def spline_on_head(tools, is_numbered=False):
    """A closed B-spline around the eyes of a lion, and its control polygon."""
    mesh = tools.mesh('lion-head.off')
    points, faces = read_off(mesh)
    places = (-0.08, 0.36), (0.1, 0.22), (0.07, 0.0), (-0.07, -0.12), (-0.2, 0.0), (-0.22, 0.22)
    controls = [in_front(points, *p) for p in places]
    polygon = tools.curves('path', mesh, '--pairs', tools.lines('pairs', zip(controls, controls[1:] + controls[:1])))
    curve = tools.curves('spline', mesh, '--bezier', tools.lines('controls', [('o', *controls)]))
    panel = panel_in_view(points, faces, {'direction': (-0.3, 0.2, 1)})
    panel.dashes(polygon.curves.values(), START, 0.010)
    panel.tubes(curve.curves.values(), RESULT, 0.014)
    draw_controls(panel, [points[v] for v in controls], is_numbered)
    return panel


ELEPHANT = {'direction': (0.8, 0.45, -1)}


def distances(tools):
    """Isolines of the distance from one vertex of an elephant."""
    mesh = tools.mesh('refined_elephant.off')
    points, faces = read_off(mesh)
    source = Graph(points, faces).nearest((-0.05, -0.1, -0.3))
    levels = ','.join(str(round(0.04 * k, 2)) for k in range(1, 50))
    page = tools.curves('distance', mesh, '--source', source, '--isolines', levels)
    panel = panel_in_view(points, faces, ELEPHANT)
    panel.tubes(page.curves.values(), RESULT, 0.007)
    panel.balls([points[source]], FIXED, 0.045)
    return panel


HEAT = '#2166ac', '#92c5de', '#f7f2e8', '#f4a582', '#b2182b'


def heat_panel(tools, mesh, source, target, view, lines=12):
    """Heat that flows off to a geodesic."""
    tools.run('poisson_example', mesh, source, target)
    points, faces, heat = read_ply(tools.folder / 'poisson.ply', 'u')
    most = max(heat)
    colors = [(most * k / 4, name) for k, name in enumerate(HEAT)]
    panel = Panel(size_of(points), seen_height(points, 1.2, **view))
    panel.colored_surface(points, faces, heat, colors)
    panel.contours(points, faces, heat, [most * k / lines for k in range(1, lines)], INK, 0.003)
    panel.tubes(tools.curves('path', mesh, '--from', source, '--to', target).curves.values(), WHITE, 0.017)
    panel.balls([points[source], points[target]], FIXED, 0.04)
    panel.look(**view)
    return panel, colors


def heated_dinosaur(tools):
    mesh = tools.mesh('diplodocus.off')
    graph = Graph(*read_off(mesh))
    ends = graph.nearest((-0.25, 0.1, 0.3)), graph.nearest((0.4, 0.45, 0.1))
    return heat_panel(tools, mesh, *ends, {'direction': (0.5, 0.25, 1)})


@figure(1240, columns=3)
def teaser(tools):
    """Six surfaces with results of the package."""
    return [*(draw(tools) for draw in (fan, rings, patchwork, spline_on_head, distances)), heated_dinosaur(tools)[0]]


def detour_path(graph):
    """A path of edges on a coarse surface that makes a detour."""
    way = [graph.nearest(p) for p in ((0.08, 0.1, 0.13), (0.17, 0.08, 0.19), (0.22, 0.02, 0.17), (0.17, 0.02, 0),
                                      (0.22, 0.02, -0.17), (0.08, 0.1, -0.13))]
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
    before = wire_panel(page.points, page.faces, name=MESH)
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


def flip_panel(page, step, is_start_drawn=False):
    """A state of a shortening: the edges that the last step has flipped are green."""
    run = page.runs[0]
    state = run.state(step)
    panel = surface_panel(page.points, page.faces, is_smooth=False)
    panel.tubes([[page.points[v] for v in side] for side in untouched_sides(page)], INK, 0.0018)
    panel.tubes(state.edges, INK, 0.0025)
    panel.tubes([run.polylines[e] for e in state.fresh], SECOND, 0.007)
    if is_start_drawn or step == 0:
        panel.dashes(run.state(0).lines, START, 0.009 if is_start_drawn else 0.010)  # inside of a curve on top
    if step > 0:
        panel.tubes(state.lines, RESULT, 0.010)
    panel.balls(ends_of(page), FIXED, 0.03)
    panel.look(**NEAR)
    return panel


@figure(640, 1120)
def flips_animation(tools):
    """A shortening flip by flip, with the start behind."""
    page = detour(tools)
    run = page.runs[0]
    steps = [0, *(k + 1 for k, (flipped, *_) in enumerate(run.steps) if flipped), len(run.steps)]
    frames = []
    for step in steps:
        panel = flip_panel(page, step, is_start_drawn=True)
        panel.look(**{**NEAR, 'zoom': 1.5, 'target': (0.115, 0.07, 0.0)})
        frames.append([panel])
    return Animation(frames)


@figure(1560, columns=2)
def flips(tools):
    """Four states of a shortening, close by."""
    page = detour(tools)
    run = page.runs[0]
    count = len(run.steps)
    with_flips = [step for step in range(1, count) if run.steps[step - 1][0]]
    panels = []
    for step in (0, *with_flips[len(with_flips) // 4::len(with_flips) // 2][:2], count):
        state = run.state(step)
        panel = flip_panel(page, step)
        panel.look(**{**NEAR, 'zoom': 1.75, 'target': (0.115, 0.07, 0.0)})
        panel.title(f'{state.flips} flips, length {length_of(state.lines[0]):.3f}')
        panels.append(panel)
    return panels


REGIONS = '#b9c4d6', '#d8cdb4', '#b7d0bd', '#d6b9c1', '#c7bfdb', '#cfd3a8', '#a9ccd3'


@figure(1720, columns=2)
def network(tools):
    """Boundaries of a segmentation of a scan: as edges, shortened, and stopped early with free junctions."""
    mesh = tools.mesh('bunny00.off')
    points, faces, labels = segments(tools, mesh)
    tight, fixed = cut_patches(tools, mesh, labels, FRONT)
    start = patches(points, faces, labels, FRONT)
    start.dashes(tight.runs[0].state(0).lines, START, 0.011)
    fixed.tubes(tight.curves.values(), RESULT, 0.011)
    panels = [start, fixed]
    for zoom in (1, 3.2):
        loose, free = cut_patches(tools, mesh, labels, FRONT, '--free-junctions', '--stop-length', 0.85)
        free.tubes(loose.curves.values(), RESULT, 0.011 / math.sqrt(zoom))
        if zoom > 1:
            free.look(**FRONT, target=(0.1, 0.05, 0.45), zoom=zoom)
        panels.append(free)
    return panels


@figure(860)
def early_stop(tools):
    """Boundaries between boxes: as edges, stopped at 85 % of their lengths, and geodesics."""
    mesh = tools.mesh('refined_elephant.off')
    points, faces = read_off(mesh)
    labels = colored(faces, [sum(2 ** i for i in range(3) if points[f[0]][i] > 0.1) for f in faces])
    panels = [patches(points, faces, labels, ELEPHANT)]
    for ratio in (1, 0.85, 0):
        tools.run('network_early_stop_example', mesh, ratio)
        curves = read_vtp(tools.folder / 'network.vtp')
        if ratio == 1:
            panels[0].dashes(curves, START, 0.009)
            continue
        options = ('--stop-length', ratio) if ratio else ()
        panels.append(cut_patches(tools, mesh, labels, ELEPHANT, *options)[1])
        panels[-1].tubes(curves, RESULT, 0.009)
    return panels


def meander(x):
    """Steps of four to and fro, but not near 0."""
    return 4 if 6 <= x % 18 <= 12 else 0


@figure(960)
def seams(tools):
    """The seams of a textured torus, as edges and as geodesics; thin lines are those of equal texture coordinates."""
    around, along = 72, 36
    points, _ = read_off(tools.torus(around, along))
    mesh, corners, plane = tools.folder / 'textured.obj', [], []
    with mesh.open('w') as out:
        out.writelines('v {} {} {}\n'.format(*p) for p in points)
        for i in range(around):
            for j in range(along):
                # Where the sheet is cut: in meanders around the tube, and around the hole, which cross at one vertex.
                du = around if i < 20 + meander(j - 15) else 0
                dv = along if j < 15 - meander(i - 20) else 0
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
        panel = panel_in_view(page.points, page.faces, {'direction': (0, -0.45, 1), 'up': (0, 0, 1)})
        faces = [(k, k + 1, k + 2) for k in range(0, len(corners), 3)]
        for axis, count in ((0, 24), (1, 12)):
            levels = [(k + 0.5) / count for k in range(2 * count)]
            panel.contours(corners, faces, [p[axis] for p in plane], levels, INK, 0.0025)
        if is_tight:
            panel.tubes(page.curves.values(), RESULT, 0.012)
        else:
            panel.dashes(page.runs[0].state(0).lines, START, 0.012)
        panel.balls(ends_of(page), FIXED, 0.04)
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
    after.tubes([snapped], SECOND, 0.009)
    after.tubes([tight], RESULT, 0.011)
    for panel in (before, after):
        panel.look((0, -0.6, 1), up=(0, 0, 1))
    return [before, after]


@figure(960)
def loops(tools):
    """Closed curves on a torus with bumps, before and after."""
    around, along = 192, 96
    start = [[around // 4 * i * along + j for j in range(along)] for i in range(4)]
    start.append([i * along + round(24 + 14 * math.sin(6 * math.pi * i / around)) for i in range(around)])
    start[-1] = staircase(start[-1], along)
    page = tools.curves('loop', tools.torus(around, along), '--loop', tools.lines('loops', start))
    before, after = (surface_panel(page.points, page.faces) for _ in range(2))
    before.dashes([[page.points[v] for v in loop + loop[:1]] for loop in start], START, 0.009)
    after.tubes(page.curves.values(), RESULT, 0.009)
    for panel in (before, after):
        panel.look(**LYING)
    return [before, after]


def handles_of(loops):
    """A number per closed curve, the same for two that cross: those of one handle."""
    def reach(a, b):
        return np.linalg.norm(np.array(a)[:, None] - np.array(b), axis=2).min()

    fine = [[tuple(x + t * (y - x) for x, y in zip(p, q)) for p, q in zip(loop, loop[1:]) for t in (0, 0.25, 0.5, 0.75)]
            for loop in loops]
    def match(left):  # the distance between partners, and the pairs
        if not left:
            return 0, []
        first, *others = left
        found = []
        for other in others:
            far, pairs = match([k for k in others if k != other])
            found.append((far + reach(fine[first], fine[other]), [(first, other), *pairs]))
        return min(found)

    number = {k: i for i, pair in enumerate(match(list(range(len(loops))))[1]) for k in pair}
    return [number[k] for k in range(len(loops))]


TRUNK = {'direction': (0.9, 0.45, -0.5), 'target': (0.21, 0.25, 0.13), 'zoom': 2.8, 'has_ground': False}
TAIL = {'direction': (-0.35, 0.8, -0.7), 'target': (-0.28, -0.27, -0.06), 'zoom': 4.5, 'has_ground': False}
GENERA = (('refined_elephant.off', {'direction': (0.45, 0.65, -0.9)}), ('refined_elephant.off', TRUNK),
          ('refined_elephant.off', TAIL), ('eight.off', {'direction': (0.75, 1, 0.3)}))


def handle_panels(tools, example, draw):
    """Loops of an elephant, as a whole and at its trunk and its tail, and of a surface of genus 2."""
    panels = []
    for name, view in GENERA:
        mesh = tools.mesh(name)
        tools.run(example, mesh)
        panels.append(panel_in_view(*read_off(mesh), view, 1.5))
        draw(panels[-1])
    for letter, detail, shift in (('b', TRUNK, (-3, 0)), ('c', TAIL, (0, -2.5))):
        panels[0].label(detail['target'], f'({letter})', INK, shift=shift)
    return panels


@figure(1360, 2000, columns=2)
def loop_basis(tools):
    """Closed geodesics around the handles of two surfaces, found from the surfaces alone."""
    def draw(panel):
        loops = read_vtp(tools.folder / 'loop_basis.vtp')
        for loop, number in zip(loops, handles_of(loops)):
            panel.tubes([loop], (RESULT, SECOND, THIRD)[number], 0.017)

    return handle_panels(tools, 'loop_basis_example', draw)


@figure(1360, 2000, columns=2)
def handles_and_tunnels(tools):
    """Closed geodesics around the handles (blue) and the tunnels (green) of two solids."""
    def draw(panel):
        for kind, color in (('handles', RESULT), ('tunnels', SECOND)):
            panel.tubes(read_vtp(tools.folder / f'{kind}.vtp'), color, 0.017)

    return handle_panels(tools, 'handle_and_tunnel_loops_example', draw)


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
    mesh = tools.mesh('bunny00.off')
    target = Graph(*read_off(mesh)).nearest((-0.4, 0.2, -0.12))
    bunny = heat_panel(tools, mesh, 11509, target, {'direction': (-0.35, 0.2, -1)})
    panels = []
    for panel, colors in (bunny, heated_dinosaur(tools)):
        panel.color_bar(colors, [(0.05 * k, f'{0.05 * k:.2f}') for k in range(int(colors[-1][0] / 0.05) + 1)], 'u')
        panels.append(panel)
    return panels


@figure(1200, 1400)
def cross_field(tools):
    """The smoothest field of crosses that is aligned with a geodesic, and where it is singular, on a bear."""
    mesh = tools.mesh('bear.off')
    points, faces = read_off(mesh)
    graph = Graph(points, faces)
    ends = graph.nearest((-0.25, 0.1, 0.4)), graph.nearest((0.25, -0.45, 0.4))
    tools.run('cross_field_example', mesh, *ends)
    arms, singular = (read_vtp(tools.folder / f'{name}.vtp') for name in ('cross_field', 'singular_faces'))
    panel = panel_in_view(points, faces, {'direction': (0.15, 0.15, 1)}, 7 / 6)
    chosen = {points[v] for v in spread(graph, ends[0], 900)}
    lines, size = [], 0.016 * panel.unit
    for a, b in arms:
        middle, side = np.add(a, b) / 2, size * unit(np.subtract(b, a))
        lines.append([tuple(middle - side), tuple(middle + side)])
    panel.tubes([line for k, line in enumerate(lines) if points[k // 2] in chosen], SECOND, 0.006)
    panel.tubes(tools.curves('path', mesh, '--from', ends[0], '--to', ends[1]).curves.values(), RESULT, 0.016)
    panel.balls([tuple(np.mean(face, axis=0)) for face in singular], THIRD, 0.03)
    panel.balls([points[v] for v in ends], FIXED, 0.04)
    return [panel]


CLOSE = {'direction': (0.9, 1, 0.1), 'target': (0.1, 0.08, 0.0), 'zoom': 3.2}


def towards_us(points, faces, lines, view):
    """The parts of polylines that lie on faces which are seen from in front: others would show behind outlines."""
    corners = np.array(points)[np.array(faces)]
    origins, sides = corners[:, 0], corners[:, 1:] - corners[:, :1]
    normals = np.cross(sides[:, 0], sides[:, 1])
    is_seen = normals @ np.array(view['direction']) > 0
    inverse = np.linalg.inv(np.stack([sides[:, 0], sides[:, 1], normals], axis=2))

    def is_in_front(p, q):
        u, v, w = np.einsum('fij,fj->if', inverse, (np.array(p) + q) / 2 - origins)
        off = np.maximum.reduce([-u, -v, u + v - 1, np.abs(w)])
        return bool(is_seen[off < max(1e-6, 2 * off.min())].any())

    return [[p, q] for line in lines for p, q in zip(line, line[1:]) if is_in_front(p, q)]


def edges_panel(page, edges, view, fresh=()):
    """A surface with edges, some of them green, and the curves of a page on it."""
    panel = panel_in_view(page.points, page.faces, {**view, 'zoom': 1}, is_smooth=False)
    panel.tubes(towards_us(page.points, page.faces, edges, view), INK, 0.0035 / view['zoom'])
    panel.tubes(towards_us(page.points, page.faces, fresh, view), SECOND, 0.008 / view['zoom'])
    panel.tubes(page.curves.values(), RESULT, 0.015 / view['zoom'])
    panel.balls(ends_of(page), FIXED, 0.04 / view['zoom'])
    panel.look(**view)
    return panel


@figure(960)
def delaunay(tools):
    """The triangulation around a geodesic as flips have left it, and flipped to constrained Delaunay."""
    pages = [detour(tools, *arguments) for arguments in ((), ('--delaunay',))]
    edges = [{tuple(line) for line in intrinsic_edges(page, page.runs[0].state(-1))} for page in pages]
    known = {frozenset((line[0], line[-1], len(line))) for line in edges[0]}
    fresh = {line for line in edges[1] if frozenset((line[0], line[-1], len(line))) not in known}
    return [edges_panel(pages[0], edges[0], CLOSE), edges_panel(pages[1], edges[1] - fresh, CLOSE, fresh)]


@figure(1900, columns=2)
def refinement(tools):
    """A coarse mesh with a geodesic as edges; the refined triangulation; its common subdivision with the mesh."""
    result = tools.folder / 'result.off'
    panels = []
    for view, *arguments in ((CLOSE, '--insert', result), (CLOSE, '--refine', 25),
                             (CLOSE, '--refine', 25, '--subdivision', result),
                             ({**CLOSE, 'zoom': 9}, '--refine', 25, '--subdivision', result)):
        page = detour(tools, *arguments)
        if result in arguments:
            points, faces = read_off(result)
            sides = {frozenset((f[i], f[i - 1])) for f in faces for i in range(3)}
            edges = [[points[v] for v in side] for side in sides]
        else:
            edges = intrinsic_edges(page, page.runs[0].state(-1))
        if view is not CLOSE:
            line = page.curves[0]
            view = {**view, 'target': line[round(0.45 * len(line))]}
        panels.append(edges_panel(page, edges, view))
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


@figure(860)
def flattening(tools):
    """A torus cut open along two geodesic loops and flattened, with lines of equal texture coordinates and the seam."""
    tools.run('flattening_example', tools.torus(96, 48), 0, 16, 32, 0, 1536, 3072, 0)
    mesh = read_obj(tools.folder / 'flattening.obj')
    corners = [mesh['v'][v] for face in mesh['f'] for v in face]
    flat = [(x, y, 0.0) for x, y in mesh['vt']]
    faces = [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(mesh['f']))]
    owners = {}
    for f in faces:
        for a, b in zip(f, f[1:] + f[:1]):
            key = frozenset(tuple(round(x, 9) for x in flat[v]) for v in (a, b))
            owners.setdefault(key, []).append((a, b))
    seam = [side for sides in owners.values() if len(sides) == 1 for side in sides]
    panels = []
    for points, view in ((corners, LYING), (flat, {'direction': (0, 0, 1), 'up': (1, 0, 0), 'has_ground': False})):
        panel = panel_in_view(points, faces, view, is_smooth=False)
        for axis, color in ((0, INK), (1, SECOND)):
            values = [p[axis] for p in flat]
            step = 0.2
            first, last = round(min(values) / step), round(max(values) / step)
            panel.contours(points, faces, values, [step * k for k in range(first, last + 1)], color, 0.0035)
        panel.tubes(joined([[points[a], points[b]] for a, b in seam], 0), RESULT, 0.015)
        panels.append(panel)
    return panels


def cut_locus(points, faces, plane, ratio=5):
    """Pieces of the curves across which a map to the plane jumps, between the middles of edges that it stretches."""
    def is_torn(v, w):
        return math.dist(plane[v], plane[w]) > ratio * math.dist(points[v], points[w])

    pieces = []
    for face in faces:
        torn = [[(a + b) / 2 for a, b in zip(points[v], points[w])]
                for v, w in zip(face, face[1:] + face[:1]) if is_torn(v, w)]
        middle = [sum(x) / len(torn) for x in zip(*torn)]
        pieces += [torn] if len(torn) == 2 else [[p, middle] for p in torn] if len(torn) == 3 else []
    return pieces


def joined(pieces, rounds=20):
    """Segments that share ends as polylines, smoothed between the places where they branch or end."""
    key = {}
    links = [[key.setdefault(tuple(round(x, 9) for x in p), len(key)) for p in piece] for piece in pieces]
    places = [list(k) for k in key]
    around = [[] for _ in places]
    for a, b in links:
        around[a].append(b)
        around[b].append(a)
    for _ in range(rounds):
        places = [p if len(near) != 2 else [(2 * x + places[near[0]][i] + places[near[1]][i]) / 4
                                            for i, x in enumerate(p)] for p, near in zip(places, around)]
    lines, used = [], set()
    for start in sorted(range(len(places)), key=lambda v: len(around[v]) == 2):
        for after in around[start]:
            line = [start]
            while frozenset((line[-1], after)) not in used:
                used.add(frozenset((line[-1], after)))
                line.append(after)
                if len(around[after]) == 2:
                    after = next(v for v in around[after] if v != line[-2])
            if len(line) > 1:
                lines.append([tuple(places[v]) for v in line])
    return lines


@figure(1000)
def logarithmic_map(tools):
    """The plane about one vertex, a disk with a grid and circles, laid over a torus by the logarithmic map; and its cut
    locus."""
    around, along = 320, 160
    mesh = tools.torus(around, along)
    points, faces = read_off(mesh)
    source = 3 * around // 4 * along + along // 6
    plane = tools.logarithms(mesh, source)
    pieces = cut_locus(points, faces, plane)
    whole = [f for f in faces if not cut_locus(points, [f], plane)]
    distance = [math.hypot(x, y) for x, y in plane]
    disk = [f for f in whole if max(distance[v] for v in f) < 1.5]
    panels = []
    for part, numbers in ((disk, ([x for x, _ in plane], [y for _, y in plane])), (whole, (distance,))):
        panel = panel_in_view(points, faces, LYING)
        for values, name in zip(numbers, (RESULT, SECOND)):
            panel.contours(points, part, values, [0.15 * k + 0.001 for k in range(-40, 41)], name, 0.006)
        panel.tubes(joined(pieces), INK, 0.012)
        panel.balls([points[source]], FIXED, 0.04)
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


@figure(1060)
def decal(tools):
    """A compass rose on a bear, and a board on a torus that is so large that it is discontinuous at the cut locus."""
    panels = []
    for mesh, place, right, size, picture, view in (
            (tools.mesh('bear.off'), (0.02, -0.12, 0.45), (1, 0, 0), 0.62, compass(), {'direction': (0.15, 0.15, 1)}),
            (tools.torus(480, 240), (0.25, -1, 0.5), (1, 0, 0), 2.8, checker(14), LYING)):
        points, faces = read_off(mesh)
        middle = points[Graph(points, faces).nearest(place)]
        face = face_along(points, faces, middle, right, 0.1)
        tools.run('decal_example', mesh, face, size)
        data = read_obj(tools.folder / 'decal.obj')
        panel = Panel(size_of(points), seen_height(points, 1.2, **view))
        panel.textured_surface(data['v'], data['f'], data['ft'], data['vt'], picture)
        if view is LYING:
            mesh = tools.torus(240, 120)
            points, faces = read_off(mesh)
            source = Graph(points, faces).nearest(data['v'][data['f'][face][0]])
            panel.tubes(joined(cut_locus(points, faces, tools.logarithms(mesh, source))), INK, 0.014)
        panel.look(**view)
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
        replaced = [list(line) for line in own - other]
        panel = panel_in_view(page.points, page.faces, {'direction': (0.75, 1, 0.2)}, is_smooth=False)
        panel.tubes([list(line) for line in own & other], MESH, 0.004)
        if page is trees[0]:
            panel.dashes(replaced, START, 0.013)
        else:
            panel.tubes(replaced, RESULT, 0.013)
        panel.balls([line[-1] for line in replaced], SECOND, 0.025)
        panel.balls([page.points[source]], FIXED, 0.045)
        panels.append(panel)
    return panels


def bump(tools, count=71, height=0.7, shift=0.06):
    """A square with a bump, a little off the middle: vertex i * count + j lies at i in the first direction. The left
    half mirrors the right one."""
    def point(i, j):
        x, y = 2 * i / (count - 1) - 1, 2 * j / (count - 1) - 1
        return x, y, height * math.exp(-(x * x + (y - shift) ** 2) / 0.08)

    corners = [(i * count + j, (i + 1) * count + j, (i + 1) * count + j + 1, i * count + j + 1)
               for i in range(count - 1) for j in range(count - 1)]
    path = tools.folder / 'bump.off'
    with path.open('w') as out:
        out.write(f'OFF\n{count ** 2} {2 * len(corners)} 0\n')
        out.writelines('{} {} {}\n'.format(*point(i, j)) for i in range(count) for j in range(count))
        for a, b, c, d in corners:
            is_left = 2 * (a // count) < count - 1
            out.write(f'3 {a} {b} {c}\n3 {a} {c} {d}\n' if is_left else f'3 {a} {b} {d}\n3 {b} {c} {d}\n')
    return path


@figure(860, 1300)
def shortest_path(tools):
    """An edge path past a bump, the geodesic that it becomes, and the shortest path on the other side."""
    mesh = bump(tools)
    graph = Graph(*read_off(mesh))
    first, through, last = (graph.nearest(place) for place in ((-0.86, 0, 0), (0, 0.6, 0), (0.86, 0, 0)))
    tools.run('shortest_path_example', mesh, first, last)
    shortest = read_vtp(tools.folder / 'shortest_path.vtp')[0]
    start = graph.path(first, through) + graph.path(through, last)[1:]
    page = tools.curves('path', mesh, '--edges', tools.lines('start', [start]))
    panel = panel_in_view(page.points, page.faces, {'direction': (0, -0.42, 1), 'up': (0, 0, 1)}, 130 / 86)
    heights = [p[2] for p in page.points]
    panel.contours(page.points, page.faces, heights, [0.05 + 0.1 * k for k in range(7)], MESH, 0.003)
    panel.dashes([[page.points[v] for v in start]], START, 0.013)
    for line, name in ((*page.curves.values(), SECOND), (shortest, RESULT)):
        panel.tubes([line], name, 0.013)
        panel.label(line[len(line) // 4], f'{length_of(line):.3f}', name, shift=(1.2, 1.3))
    panel.balls([page.points[v] for v in (first, last)], FIXED, 0.035)
    return [panel]


def transported(line, vector, center):
    """A vector at the first point of a great circle of a sphere, and transported along it: one per point."""
    pole = unit(np.cross(np.subtract(line[0], center), np.subtract(line[-1], center)))
    frames = [(unit(np.cross(pole, np.subtract(p, center))), pole) for p in line]  # along the circle and across
    x, y = (vector @ axis for axis in frames[0])
    return [x * tangent + y * across for tangent, across in frames]


@figure(1000)
def parallel_transport(tools):
    """A direction carried along shortest paths on a torus, and around a geodesic triangle on a sphere."""
    around, along = 48, 24
    mesh = tools.torus(around, along)
    points, faces = read_off(mesh)
    view = {'direction': (0, -0.75, 1), 'up': (0, 0, 1)}
    middle = points[Graph(points, faces).nearest((0, -1, 0.5))]
    face = face_along(points, faces, middle, (1, 0, 0), 0.1)
    tools.run('parallel_transport_example', mesh, face, 1.6)
    arrows = read_vtp(tools.folder / 'arrows.vtp')
    field = panel_in_view(points, faces, view)
    source = tuple(np.mean([points[v] for v in faces[face]], axis=0))
    to_source = ','.join(map(str, (*faces[face], 1 / 3, 1 / 3)))
    curve = tools.curves('path', mesh, '--from', to_source, '--to', 44 * along + 6).curves[0]
    starts = [line[0] for line in arrows]
    starts = [p for p, is_facing in zip(starts, field.is_facing(starts, 0.45)) if is_facing]
    chosen = [source]
    for p in sorted(starts, key=lambda p: min(math.dist(p, q) for q in curve)):
        if min(math.dist(p, q) for q in chosen) > 0.115 * field.unit:
            chosen.append(p)
    vectors = {line[0]: unit(np.subtract(line[-1], line[0])) for line in arrows}
    vectors[source] = unit(np.subtract(points[faces[face][0]], points[faces[face][-1]]))
    lifted = np.array(chosen) + 0.012 * field.unit * field.normals_at(chosen)
    for these, name, length, width in ((slice(1), START, 0.16, 0.016), (slice(1, None), RESULT, 0.11, 0.012)):
        field.arrows(lifted[these], [length * field.unit * vectors[p] for p in chosen[these]], name, width)
    field.tubes([curve], INK, 0.012)
    field.balls([source], FIXED, 0.04)

    mesh = tools.mesh('sphere966.off')
    points, faces = read_off(mesh)
    graph = Graph(points, faces)
    center = np.mean(points, axis=0)
    radius = math.dist(points[0], center)
    directions = (-0.8, -0.35, 0.6), (0.8, -0.35, 0.6), (0, 0.95, 0.3)
    corners = [graph.nearest(center + radius * unit(d)) for d in directions]
    sides = tools.curves('path', mesh, '--pairs', tools.lines('pairs', zip(corners, corners[1:] + corners[:1])))
    loop = panel_in_view(points, faces, {'direction': (0, 0.15, 1)})
    loop.tubes(sides.curves.values(), INK, 0.012)
    vector = first = None
    for line in sides.curves.values():
        if first is None:
            out = np.subtract(line[0], center)
            sideways = unit(np.cross(out, np.subtract(line[-1], center)))
            first = vector = unit(unit(np.cross(sideways, out)) + sideways)
        carried = transported(line, vector, center)
        ends = np.cumsum([0, *map(math.dist, line, line[1:])])
        chosen = sorted({int(np.argmin(np.abs(ends - ends[-1] * k / 6))) for k in range(1, 7)})
        if line is list(sides.curves.values())[-1]:
            chosen = chosen[:-1]
        loop.arrows([line[k] for k in chosen], [0.16 * loop.unit * carried[k] for k in chosen], RESULT, 0.012)
        vector = carried[-1]
    start = points[corners[0]]
    for direction, name in ((first, START), (vector, SECOND)):
        loop.arrows([start], [0.2 * loop.unit * direction], name, 0.016)
    loop.balls([start], FIXED, 0.04)
    angle = math.acos(first @ vector)
    across = unit(vector - (vector @ first) * first)
    arc = [tuple(start + 0.11 * loop.unit * (math.cos(t) * first + math.sin(t) * across))
           for t in np.linspace(0, angle, 40)]
    loop.tubes([arc], INK, 0.006)
    loop.label(arc[20], f'{math.degrees(angle):.0f}\N{DEGREE SIGN}', INK, shift=(1.2, -0.8))
    return [field, loop]


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


WAYS = RESULT, SECOND, THIRD, FIFTH, FOURTH


def ways_panel(tools, mesh, ends, number, view, shares, obstacles=()):
    """The shortest paths of several classes, with their lengths at some shares of these, and obstacles."""
    tools.run('other_ways_example', mesh, *ends, number, *sorted(obstacles))
    points, faces = read_off(mesh)
    panel = panel_in_view(points, [f for i, f in enumerate(faces) if i not in obstacles], view)
    if obstacles:
        panel.surface(points, [faces[i] for i in obstacles], FIXED)
    paths = read_vtp(tools.folder / 'other_ways.vtp')
    for k, (path, name, (share, *shift)) in enumerate(zip(paths, WAYS, shares)):
        panel.tubes([path], name, 0.016 - 0.0012 * k)  # where two run together, the shorter one shows
        panel.label(path[round(share * (len(path) - 1))], f'{length_of(path):.3f}', name, shift=shift)
    panel.balls([points[v] for v in ends], FIXED, 0.04)
    return panel


@figure(1000)
def other_ways(tools):
    """The shortest paths of several classes on a torus, and past two obstacles on the head of a lion."""
    around, along = 96, 48
    torus = ways_panel(tools, tools.torus(around, along), (62 * along + 8, 82 * along + 8), 5,
                       {'direction': (0, -0.75, 1), 'up': (0, 0, 1)},
                       ((0.5, 0, -1), (0.1, -2, 0), (0.07, -2.2, 0.5), (0.5, 0, -1), (0.96, 2.2, 0.5)))
    mesh = tools.mesh('lion-head.off')
    points, faces = read_off(mesh)
    eyes = (-0.2, 0.13), (0.07, 0.13)
    obstacles = {i for i, f in enumerate(faces) for eye in eyes
                 if max(math.dist(points[v][:2], eye) for v in f) < 0.052 and points[f[0]][2] > 0}
    head = ways_panel(tools, mesh, [in_front(points, *p) for p in ((-0.3, 0.07), (0.18, 0.07))], 4,
                      {'direction': (-0.3, 0.2, 1), 'target': (-0.07, 0.1, 0.3), 'zoom': 1.5},
                      ((0.5, 0, 1.1), (0.2, -1, -1), (0.8, 2, 0.6), (0.6, 0, -1)), obstacles)
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
    panel = panel_in_view(points, faces, FRONT)
    panel.tubes(read_vtp(tools.folder / 'isolines.vtp'), RESULT, 0.007)
    panel.tubes(read_vtp(tools.folder / 'voronoi.vtp'), SECOND, 0.012)
    panel.balls([points[source] for source in sources], FIXED, 0.035)
    return [distances(tools), panel]


@figure(1000)
def spline(tools):
    """The Bezier curve and the B-spline of four control points on a scan, and a closed B-spline on a lion's head."""
    mesh = tools.mesh('bunny00.off')
    points, faces = read_off(mesh)
    controls = [in_front(points, *p) for p in ((-0.12, -0.3), (-0.02, 0.05), (0.3, -0.02), (0.36, -0.32))]
    panel = panel_in_view(points, faces, FRONT)
    polygon = tools.curves('path', mesh, '--pairs', tools.lines('pairs', zip(controls, controls[1:])))
    panel.dashes(polygon.curves.values(), START, 0.010)
    for kind, name in (((), RESULT), (('s',), SECOND)):
        curve = tools.curves('spline', mesh, '--bezier', tools.lines('controls', [(*kind, *controls)]))
        panel.tubes(curve.curves.values(), name, 0.014)
    draw_controls(panel, [points[v] for v in controls])
    return [panel, spline_on_head(tools, is_numbered=True)]


@figure(208, 208)
def flip_geodesics_small(tools):
    """The small picture of the package overview."""
    page = detour(tools)
    panel = wire_panel(page.points, page.faces, 0.006)
    panel.tubes(page.curves.values(), RESULT, 0.05)
    panel.balls(ends_of(page), FIXED, 0.075)
    panel.look(**{**NEAR, 'zoom': 2.6})
    return [panel]


@figure(1280)
def page(tools):
    """The page of --page in a browser, in the middle of a shortening."""
    path = tools.folder / 'curves.html'
    mesh = tools.mesh('eight.off')
    edges = tools.lines('paths', [detour_path(Graph(*read_off(mesh)))])
    tools.run('flip_geodesics', 'path', mesh, '--edges', edges, '--quiet', '--page', path)
    with Browser(tools.folder, 1200, 640) as browser:
        browser.open(f'{path.as_uri()}#curve=0&step=6&edges=1')
        browser.wait('document.documentElement.dataset.state === "ready"')
        return browser.picture()


@figure(1800)
def live_page(tools):
    """The page of the command view in a browser: a shortest path, and a path through clicked points."""
    path = tools.folder / 'live.html'
    tools.run('flip_geodesics', 'view', tools.torus(96, 48), '--quiet', '--output', path)
    is_idle = 'document.documentElement.dataset.isIdle === "true"'
    with Browser(tools.folder, 1200, 900) as browser:
        browser.open(path.as_uri())
        browser.wait(is_idle)
        browser.value('document.getElementById("clear").click()')
        for tool, places in (('shortest', ((640, 640), (680, 340))), ('path', ((220, 560), (260, 300), (520, 160)))):
            if tool == 'path':
                browser.value('document.getElementById("new-curve").click()')
            browser.value(f"document.querySelector('[data-tool={tool}]').click()")
            for place in places:
                browser.click(*place)
                browser.wait(is_idle)
        return browser.picture()


class Animation:
    """Pictures one after the other; the first and the last stay longer."""

    def __init__(self, frames):
        self.frames = frames

    def write(self, path, width, height):
        images = [to_image(panels, width, height) for panels in self.frames]
        times = [1500] + [400] * (len(images) - 2) + [3000]
        save_small(path, images[0], save_all=True, append_images=images[1:], duration=times, loop=0, method=6)


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
        draw, width, height, columns = figures[name]
        scale = options.width / WIDTH
        with tempfile.TemporaryDirectory() as folder:
            result = draw(Tools(options.build.resolve(), folder))
            is_moving = isinstance(result, Animation)
            path = options.out / f'{name}.{"png" if name == "flip_geodesics_small" else "webp"}'
            size = round(scale * width), round(scale * height)
            if is_moving:
                result.write(path, *size)
            else:
                write_picture(path, result if isinstance(result, Image.Image) else to_image(result, *size, columns))
            print(f'{path.name}: {path.stat().st_size // 1000} kB', flush=True)


if __name__ == '__main__':
    main()
