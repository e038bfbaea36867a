#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws the schematic drawings of the manual into fig/, as SVG, with the standard library only.

    drawings.py           writes all drawings
    drawings.py --check   fails if one of the committed drawings differs from what would be written

Each drawing is a function decorated by @drawing; the file in fig/ has its name. All geometry is computed, and modules()
reads the table of modules in Design.txt, so that a drawing cannot contradict what it illustrates.
"""

import argparse
import itertools
import random
import sys
from pathlib import Path

from drawing_tools import (CURVE, DASHES, DOTS, FAINT, LINE, WIDTH, Canvas, Panel, angle_at, between, centroid,
                           crossed_edges, delaunay, direction, edges_of, flip_out, funnel_steps, is_convex,
                           line_meeting, minus, plus, polar, shortest_in_class, shortest_in_strip, turn, unit,
                           visible_part)
from figure_colors import FIXED, INK, MESH, RESULT, SECOND, START, WHITE

DOC = Path(__file__).resolve().parent
FIGURES = DOC / 'fig'
sys.path.insert(0, str(DOC.parents[1] / 'test/Flip_geodesics'))
from check_modules import modules_of_table  # noqa: E402

TINT, SECOND_TINT, WARM_TINT = '#dceaf5', '#d9efe6', '#fbecd3'  # light areas of the colors of results and of starts
DRAWINGS = {}


def drawing(function):
    DRAWINGS[function.__name__] = function
    return function


# --- FlipOut ---

def fan_faces(b, fan):
    return [(b, p, q) for p, q in zip(fan, fan[1:])]


@drawing
def wedge_and_flip():
    canvas = Canvas(330, 'A joint with its wedge, and an edge flip')
    draw_wedge(canvas)
    draw_flip(canvas)
    draw_flip_that_is_impossible(canvas)
    return canvas


def draw_wedge(canvas):
    canvas.panel_letter('a', 8, 16)
    b = (0.0, 0.0)
    fan = [polar(163, 1.75), polar(132, 1.75), polar(103, 1.5), polar(72, 1.65), polar(34, 1.75)]
    below = [fan[0], polar(212, 1.25), polar(268, 1.15), polar(324, 1.3), fan[-1]]
    panel = Panel(canvas, (18, 42, 350, 292), fan + below)
    a, c = fan[0], fan[-1]
    for corners in fan_faces(b, below):
        panel.polygon(corners, FAINT, MESH)
    for corners in fan_faces(b, fan):
        panel.polygon(corners, TINT)
    for p in fan[1:-1]:
        panel.line([b, p], MESH)
    panel.line(fan, INK, CURVE)
    panel.line([a, b, c], START, CURVE, DASHES)
    panel.angle(b, direction(b, c), direction(b, a), 30)
    for p, name in zip(fan[1:-1], ('*n*_{1}', '*n*_{2}', '*n*_{3}')):
        panel.dot(p)
        panel.text(p, name, away=(0, 15))
    for p, name, away in ((a, '*a*', (-13, 4)), (b, '*b*', (11, -19)), (c, '*c*', (13, 4))):
        panel.text(p, name, away=away)
    panel.vertices((a, b, c), INK, 4.5)
    panel.text(polar(87, 0.92), '*α* < *π*')
    panel.text(between(between(fan[3], fan[4]), b, -0.16), 'outer arc', anchor='start', away=(-6, 0))
    panel.text(between(a, b), 'segment', START, away=(-6, -16))
    panel.text(between(c, b), 'segment', START, away=(14, -14))
    panel.text(centroid([b, fan[1], fan[2]]), 'wedge', RESULT, away=(-18, 20))


def quad_panel(canvas, box, quad, names):
    panel = Panel(canvas, box, quad)
    for p, name in zip(quad, names):
        away = unit(minus(p, centroid(quad)))
        panel.text(p, name, away=(14 * away[0], 14 * away[1]))
    return panel


def draw_flip(canvas):
    canvas.panel_letter('b', 384, 16)
    i, k, j, l = (0.0, -1.0), (-0.95, 0.1), (0.15, 1.0), (1.05, -0.25)
    quad = [i, k, j, l]
    assert is_convex(quad), 'the edge cannot be flipped'
    for box, ends, color in (((404, 42, 524, 152), (i, j), MESH), ((568, 42, 688, 152), (k, l), SECOND)):
        panel = quad_panel(canvas, box, quad, ('*i*', '*k*', '*j*', '*l*'))
        panel.polygon(quad, FAINT, MESH)
        panel.line(ends, color, CURVE if color == SECOND else LINE)
        panel.vertices(quad, INK, 4)
    canvas.line([(535, 75), (561, 75)], arrow=True)


def draw_flip_that_is_impossible(canvas):
    canvas.panel_letter('c', 384, 186)
    i, k, j, l = (0.0, -0.28), (-1.0, -0.75), (0.05, 1.0), (0.95, -0.8)
    quad = [i, k, j, l]
    assert not is_convex(quad), 'the edge can be flipped'
    panel = Panel(canvas, (404, 210, 524, 306), quad)
    panel.polygon(quad, FAINT, MESH)
    panel.line([i, j], MESH)
    panel.line([k, l], FIXED, LINE, DOTS)
    panel.angle(i, direction(i, l), direction(i, k), 15)
    panel.vertices(quad, INK, 4)
    for p, name, away in ((i, '*i*', (0, -14)), (k, '*k*', (-13, 2)), (j, '*j*', (0, 13)), (l, '*l*', (13, 2))):
        panel.text(p, name, away=away, has_halo=name == '*i*')
    for n, label in enumerate(('no flip: the angle at *i*', 'is at least *π*, and *kl*', 'lies outside the faces')):
        canvas.text((548, 240 + 19 * n), label, anchor='start')


@drawing
def flip_out_step():
    canvas = Canvas(430, 'One step of FlipOut')
    b = (0.0, 0.0)
    fan = [(-2.0, 0.95), (-1.3, 1.75), (-0.35, 0.68), (0.4, 1.9), (1.4, 1.75), (2.1, 1.0)]
    states = list(flip_out(b, fan))
    shown = (('a', 'before the step, with the angles *β*_{i}', 0), ('b', 'first flip, since *β*_{1} < *π*', 1),
             ('c', f'after {len(states) - 1} flips, no *β*_{{i}} < *π*', len(states) - 1),
             ('d', 'the outer arc is the new path', len(states) - 1))
    for (letter, title, last), (left, top) in zip(shown, ((0, 0), (350, 0), (0, 215), (350, 215))):
        canvas.panel_letter(letter, left + 8, top + 16)
        canvas.text((left + 38, top + 16), title, anchor='start')
        panel = Panel(canvas, (left + 30, top + 42, left + 320, top + 190), fan + [b])
        draw_flip_out_state(panel, b, fan, states[:last + 1], is_final=letter == 'd')
    return canvas


def draw_flip_out_state(panel, b, fan, states, is_final):
    names = {p: f'*n*_{{{i}}}' for i, p in enumerate(fan)} | {fan[0]: '*a*', fan[-1]: '*c*', b: '*b*'}
    sides = {fan[0]: (-14, 2), fan[-1]: (14, 2), b: (0, -15), fan[2]: (17, -12)}
    arc = states[-1][0]
    panel.polygon([b, *fan], FAINT)
    panel.polygon([b, *arc], WHITE if is_final else TINT)
    panel.line(fan, MESH)
    for _, flipped in states[1:]:
        panel.line([b, flipped], MESH, LINE, DOTS)
    for p in arc[1:-1]:
        panel.line([b, p], MESH)
    for (before, _), (_, gone) in zip(states, states[1:]):
        i = before.index(gone)
        panel.line([before[i - 1], before[i + 1]], SECOND, CURVE)
    panel.line([fan[0], b, fan[-1]], START, CURVE, DASHES)
    if is_final:
        panel.line(arc, RESULT, CURVE + 1)
    if len(states) == 1:
        for i in range(1, len(fan) - 1):
            panel.angle(fan[i], direction(fan[i], fan[i - 1]), direction(fan[i], fan[i + 1]), 11)
        for i, away in enumerate(((-2, -23), (24, 5), (13, -21), (2, -23)), 1):
            panel.text(fan[i], f'*β*_{{{i}}}', size=13, away=away)
    for p in [*fan, b]:
        panel.dot(p, FIXED if p in (fan[0], fan[-1]) else INK)
        panel.text(p, names[p], away=sides.get(p, (0, 15)))


# --- Isotopy ---

def perturbed_grid(columns, rows, jitter, seed):
    generator = random.Random(seed)
    return [(x + 0.5 * (y % 2) + jitter * (generator.random() - 0.5), 0.88 * y + jitter * (generator.random() - 0.5))
            for y in range(rows) for x in range(columns)]


def mesh_of(points):
    """The faces of the Delaunay triangulation of points except for flat ones, which lie along the border."""
    return [face for face in delaunay(points)
            if max(angle_at(points[face[i]], points[face[i - 1]], points[face[(i + 1) % 3]]) for i in range(3)) < 125]


def faces_near(faces, vertices, edges):
    return [face for face in faces if set(vertices) & set(face) or any(set(edge) <= set(face) for edge in edges)]


@drawing
def isotopy():
    canvas = Canvas(224, 'A vertex on no curve, and the end points of a curve as obstacles')
    points = perturbed_grid(7, 5, 0.3, 12)
    faces = mesh_of(points)
    upper, lower = [14, 21, 22, 30, 31, 32, 25, 26, 20], [14, 7, 8, 2, 3, 4, 11, 12, 20]
    for letter, left, curves, obstacles in (('a', 0, [upper], []), ('b', 350, [upper, lower], [24, 10])):
        canvas.panel_letter(letter, left + 8, 16)
        panel = Panel(canvas, (left + 20, 30, left + 330, 214), points)
        panel.mesh(points, faces)
        if obstacles:
                panel.line([points[v] for v in obstacles], SECOND, CURVE)
        for path in curves:
            assert all(tuple(sorted(pair)) in edges_of(faces) for pair in zip(path, path[1:])), 'not a path of edges'
            draw_shortened_curve(panel, [points[v] for v in path], [points[v] for v in obstacles])
        for v, name, away in ((14, '*s*', (-12, 0)), (20, '*t*', (13, 0)), (24, '*q*', (0, 15)), (10, '*r*', (0, -15))):
            if v in (14, 20) or v in obstacles:
                panel.dot(points[v], FIXED if v in (14, 20) else SECOND, 5)
                panel.text(points[v], name, away=away, has_halo=True)
        if not obstacles:
            panel.dot(points[24], INK)
            panel.text(points[24], '*q*', away=(14, 8), has_halo=True)
    return canvas


def draw_shortened_curve(panel, path, obstacles):
    panel.line(path, START, CURVE, DASHES)
    panel.line(shortest_in_class(path, obstacles), RESULT, CURVE)


# --- Normal coordinates and edge sequences ---

def number_in_disk(panel, p, label, color):
    panel.dot(p, color, 11)
    panel.text(p, label, WHITE, is_bold=True)


@drawing
def normal_coordinates():
    canvas = Canvas(300, 'Normal coordinates of the edges of an intrinsic triangle')
    points = perturbed_grid(6, 5, 0.5, 2)
    faces, corners = mesh_of(points), [9, 11, 20]
    sides = [(corners[i], corners[(i + 1) % 3]) for i in range(3)]
    crossed = [crossed_edges(points, edges_of(faces), points[a], points[b]) for a, b in sides]
    names = dict(zip(corners, ('*i*', '*j*', '*k*')))
    canvas.panel_letter('a', 8, 16)
    shown = faces_near(faces, corners, [edge for found in crossed for _, edge in found])
    panel = Panel(canvas, (20, 34, 370, 288), [points[v] for face in shown for v in face])
    panel.mesh(points, shown)
    panel.polygon([points[v] for v in corners], 'none', RESULT, CURVE)
    draw_counts(panel, points, sides, crossed, names)
    canvas.panel_letter('b', 392, 16)
    panel = Panel(canvas, (435, 40, 655, 220), [points[v] for v in corners])
    panel.polygon([points[v] for v in corners], FAINT)
    draw_pieces(panel, points, corners, crossed)
    panel.polygon([points[v] for v in corners], 'none', RESULT, CURVE)
    draw_counts(panel, points, sides, crossed, names)
    for y, label in zip((256, 276), corner_counts(corners, crossed)):
        canvas.text((545, y), label, size=13)
    return canvas


def draw_counts(panel, points, sides, crossed, names):
    middle = centroid([points[a] for a, _ in sides])
    for (a, b), found in zip(sides, crossed):
        for t, _ in found:
            panel.dot(between(points[a], points[b], t), INK, 3)
    for (a, b), found in zip(sides, crossed):
        number_in_disk(panel, label_place(panel, points[a], points[b], middle, 17), str(len(found)), RESULT)
    for v, name in names.items():
        away = unit(minus(points[v], middle))
        panel.dot(points[v], RESULT)
        panel.text(points[v], name, away=(15 * away[0], 15 * away[1]), has_halo=True)


def label_place(panel, p, q, inner, distance):
    """A place beside the middle of a segment, so many pixels away from it on the side opposite to `inner`."""
    along = unit(minus(q, p))
    side = (along[1], -along[0]) if turn(p, q, inner) > 0 else (-along[1], along[0])
    return plus(between(p, q), side, distance / panel.scale)


def draw_pieces(panel, points, corners, crossed):
    """The pieces of input edges inside a triangle."""
    places = {}
    for i, found in enumerate(crossed):
        for t, edge in found:
            places.setdefault(edge, []).append(between(points[corners[i]], points[corners[(i + 1) % 3]], t))
    for edge, ends in sorted(places.items()):
        ends += [points[v] for v in edge if v in corners]
        assert len(ends) == 2, 'an input edge enters a triangle without leaving it'
        panel.line(ends, INK)


def corner_counts(corners, crossed):
    """How many input edges cut off each corner of a triangle, and how many start in one."""
    on_sides = [{edge for _, edge in found} for found in crossed]
    cut = ', '.join(f'{len(on_sides[i] & on_sides[i - 1])} at *{name}*' for i, name in enumerate('ijk'))
    starting = [edge for edge in set().union(*on_sides) if set(edge) & set(corners)]
    return f'edges that cut off a corner: {cut}', f'edges that start in a corner: {len(starting)}'


@drawing
def edge_sequence():
    canvas = Canvas(340, 'The sequence of input edges that an intrinsic edge crosses')
    points = perturbed_grid(6, 5, 0.5, 11)
    faces, (i, j, k, l) = mesh_of(points), (25, 7, 3, 13)
    final = [edge for _, edge in crossed_edges(points, edges_of(faces), points[k], points[l])]
    along = sequence_along(points, edges_of(faces), (k, i, l), j)
    assert reduced(along, k, l) == final, 'the sequence of the path does not reduce to that of the edge'
    names = {edge: f'*e*_{{{n}}}' for n, edge in enumerate(final, 1)}
    names |= {edge: f'*f*_{{{n}}}' for n, edge in enumerate(dict.fromkeys(e for e in along if e not in names), 1)}
    shown = faces_near(faces, (i, j, k, l), along)
    for letter, left, crossed, draw in (('a', 0, final, draw_crossing_edge), ('b', 350, along, draw_path_around)):
        canvas.panel_letter(letter, left + 8, 16)
        panel = Panel(canvas, (left + 22, 30, left + 330, 290), [points[v] for face in shown for v in face])
        panel.mesh(points, shown)
        draw(panel, points, (i, j, k, l), {edge: names[edge] for edge in crossed})
        for v, name in zip((i, j, k, l), 'ijkl'):
            panel.dot(points[v], RESULT)
            away = unit(minus(points[v], centroid([points[w] for w in (i, j, k, l)])))
            panel.text(points[v], f'*{name}*', away=(15 * away[0], 15 * away[1]), has_halo=True)
    canvas.text((175, 320), 'edge *kl*: ' + ' '.join(names[e] for e in final))
    canvas.text((525, 320), 'path *k* *i* *l*: ' + ' '.join(names[e] for e in along))
    return canvas


def draw_crossing_edge(panel, points, corners, names):
    k, l = (points[v] for v in corners[2:])
    for edge in names:
        panel.line([points[v] for v in edge], INK)
    panel.line([k, l], RESULT, CURVE)
    for ((a, b), name), (is_label_left, distance) in zip(names.items(), ((True, 18), (False, 24), (False, 24))):
        p = line_meeting(k, l, points[a], points[b])
        end = points[a] if (turn(k, l, points[a]) > 0) == is_label_left else points[b]
        panel.dot(p, RESULT, 4)
        panel.text(plus(p, unit(minus(end, p)), distance / panel.scale), name, has_halo=True)


def draw_path_around(panel, points, corners, names):
    """The old diagonal ij and the path from k to l beside i, on the side of j."""
    i, j, k, l = (points[v] for v in corners)
    for edge in names:
        panel.line([points[v] for v in edge], INK)
    panel.polygon([i, k, j, l], 'none', RESULT, LINE)
    panel.line([i, j], RESULT, LINE, DOTS)
    panel.line([k, plus(i, unit(minus(centroid([j, k, l]), i)), 30 / panel.scale), l], START, CURVE, DASHES)
    for edge, name, part in zip(names, names.values(), (0.42, 0.3, 0.45, 0.5, 0.25, 0.8)):
        left, right = sorted(points[v] for v in edge)
        panel.text(between(left, right, part), name, has_halo=True)


def sequence_along(points, edges, path, inner):
    """The edges crossed along k, i, l when i is passed on the side of another vertex."""
    k, i, l = (points[v] for v in path)
    sign = 1 if turn(k, i, points[inner]) > 0 else -1
    start = direction(i, k)

    def turned(v):
        return (sign * (start - direction(i, points[v]))) % 360

    at_i = sorted((turned(sum(edge) - path[1]), edge) for edge in edges if path[1] in edge)
    end = (sign * (start - direction(i, l))) % 360
    return ([edge for _, edge in crossed_edges(points, edges, k, i)] + [edge for angle, edge in at_i if angle < end] +
            [edge for _, edge in crossed_edges(points, edges, i, l)])


def reduced(sequence, first, last):
    """Cancels edges that are crossed to and fro, and removes edges at the ends that start there."""
    result = []
    for edge in sequence:
        if result and result[-1] == edge:
            result.pop()
        else:
            result.append(edge)
    while result and first in result[0]:
        result.pop(0)
    while result and last in result[-1]:
        result.pop()
    return result


# --- Strips and windows ---

STRIP_START, STRIP_END = (0.0, 0.0), (5.6, 0.9)
STRIP_LEFT = [(0.5, 0.75), (1.3, 0.2), (1.75, 1.1), (1.8, 2.3), (3.4, 2.1), (4.7, 1.75)]
STRIP_RIGHT = [(0.75, -0.7), (1.7, -0.8), (2.6, -0.4), (2.65, 0.7), (4.0, 0.75), (4.9, 0.25)]
STRIP_ADVANCES = 'LRRRLLRLRL'  # the side on which each face of the strip has its third vertex


def strip_portals():
    i = j = 0
    portals = [(STRIP_LEFT[0], STRIP_RIGHT[0])]
    for side in STRIP_ADVANCES:
        i, j = (i + 1, j) if side == 'L' else (i, j + 1)
        portals.append((STRIP_LEFT[i], STRIP_RIGHT[j]))
    return portals


@drawing
def strip_and_funnel():
    canvas = Canvas(250, 'The strip of faces along a path, a funnel, and the shortest path in the strip')
    for letter, left, draw in (('a', 0, draw_funnel), ('b', 350, draw_path_in_strip)):
        canvas.panel_letter(letter, left + 8, 16)
        panel = Panel(canvas, (left + 22, 40, left + 328, 236), [STRIP_START, STRIP_END, *STRIP_LEFT, *STRIP_RIGHT])
        panel.polygon([STRIP_START, *STRIP_RIGHT, STRIP_END, *reversed(STRIP_LEFT)], FAINT, MESH)
        for portal in strip_portals():
            panel.line(portal, MESH)
        draw(panel)
        for p, name, away in ((STRIP_START, '*s*', (-12, 2)), (STRIP_END, '*t*', (13, 0))):
            panel.dot(p, FIXED, 5)
            panel.text(p, name, away=away)
    return canvas


def draw_funnel(panel):
    portals = strip_portals()
    last = portals.index((STRIP_LEFT[3], STRIP_RIGHT[4]))
    path, left, right = list(funnel_steps(STRIP_START, portals[:last + 1]))[-1]
    panel.polygon([*left, *reversed(right[1:])], TINT)
    for portal in portals[:last + 1]:
        panel.line(portal, INK)
    panel.line(path, RESULT, CURVE)
    panel.line(left, RESULT, LINE)
    panel.line(right, RESULT, LINE)
    panel.dot(path[-1], RESULT, 5)
    panel.text(path[-1], 'apex', away=(-11, 25))
    panel.text(between(*portals[last], 0.5), 'portal', anchor='start', away=(-15, 19))
    panel.text(between(left[-2], left[-1]), 'left chain', RESULT, anchor='end', away=(-22, 2))
    panel.text(between(right[-2], right[-1]), 'right chain', RESULT, away=(6, -15))


def draw_path_in_strip(panel):
    path = shortest_in_strip(STRIP_START, strip_portals(), STRIP_END)
    panel.line([STRIP_START, *STRIP_LEFT, STRIP_END], START, CURVE, DASHES)
    panel.line(path, RESULT, CURVE)
    panel.vertices(path[1:-1], RESULT, 5)


WINDOW_SOURCE = (0.0, 0.0)
WINDOW_PORTALS = [((-0.3, 0.95), (0.42, 0.8)), ((-0.3, 0.95), (1.2, 1.85)), ((-0.95, 2.0), (1.2, 1.85))]
WINDOW_OPPOSITE = (0.1, 3.15)


@drawing
def window():
    canvas = Canvas(330, 'A window, its propagation across a face, and a saddle vertex as pseudo-source')
    for letter, left in (('a', 0), ('b', 215), ('c', 430)):
        canvas.panel_letter(letter, left + 8, 16)
    points = [WINDOW_SOURCE, WINDOW_OPPOSITE, *(p for portal in WINDOW_PORTALS for p in portal)]
    draw_window(Panel(canvas, (12, 30, 202, 300), points))
    draw_propagation(Panel(canvas, (227, 30, 417, 300), points))
    draw_saddle(canvas)
    return canvas


def draw_unfolded_faces(panel):
    (l0, r0), (_, r1), (l1, _) = WINDOW_PORTALS
    for face in ((WINDOW_SOURCE, r0, l0), (l0, r0, r1), (l0, r1, l1)):
        panel.polygon(face, FAINT, MESH)


def draw_source(panel, p, label, away):
    panel.dot(p, FIXED, 5)
    panel.text(p, label, FIXED, away=away)


def draw_window(panel):
    draw_unfolded_faces(panel)
    start, end = visible_part(WINDOW_SOURCE, WINDOW_PORTALS)
    left, right = WINDOW_PORTALS[-1]
    panel.polygon([WINDOW_SOURCE, end, start], TINT)
    for portal in WINDOW_PORTALS:
        panel.line(portal, MESH)
    for p in (start, end):
        panel.line([WINDOW_SOURCE, p], RESULT)
    panel.line([start, end], RESULT, CURVE + 1.5)
    panel.vertices([left, right], INK, 4)
    panel.vertices([start, end], RESULT, 4)
    panel.text(between(start, end), 'window', RESULT, away=(0, 14))
    panel.text(between(WINDOW_SOURCE, start, 0.3), '*d*_{0}', away=(-16, 0))
    panel.text(between(WINDOW_SOURCE, end, 0.3), '*d*_{1}', away=(17, 0))
    panel.text(left, '*e*', away=(0, 14))
    draw_source(panel, WINDOW_SOURCE, 'source *s*, unfolded', (0, -17))


def draw_propagation(panel):
    draw_unfolded_faces(panel)
    start, end = visible_part(WINDOW_SOURCE, WINDOW_PORTALS)
    left, right = WINDOW_PORTALS[-1]
    panel.polygon([left, right, WINDOW_OPPOSITE], FAINT, MESH)
    on_left = line_meeting(WINDOW_SOURCE, start, left, WINDOW_OPPOSITE)
    on_right = line_meeting(WINDOW_SOURCE, end, right, WINDOW_OPPOSITE)
    panel.polygon([WINDOW_SOURCE, on_right, WINDOW_OPPOSITE, on_left], TINT)
    for portal in WINDOW_PORTALS:
        panel.line(portal, MESH)
    for p in (on_left, WINDOW_OPPOSITE, on_right):
        panel.line([WINDOW_SOURCE, p], RESULT)
    panel.line([start, end], RESULT, CURVE + 1.5)
    panel.line([on_left, WINDOW_OPPOSITE, on_right], RESULT, CURVE + 1.5)
    panel.vertices([left, right, WINDOW_OPPOSITE], INK, 4)
    panel.vertices([start, end, on_left, on_right], RESULT, 4)
    panel.text(between(on_right, WINDOW_OPPOSITE), 'new', RESULT, anchor='start', away=(10, 14))
    panel.text(between(on_right, WINDOW_OPPOSITE), 'windows', RESULT, anchor='start', away=(10, -2))
    draw_source(panel, WINDOW_SOURCE, '*s*', (0, -17))


def draw_saddle(canvas):
    """The faces behind a saddle vertex; the source has two images, one for each side on which rays pass the vertex."""
    v, distance, half_gap = (0.0, 0.0), 1.2, 24
    fan = [polar(176, 1.5), polar(122, 1.85), polar(54, 1.9), polar(6, 1.5)]
    images = [polar(270 + half_gap, distance), polar(270 - half_gap, distance)]  # for the left and for the right side
    far = [line_meeting(image, v, fan[1], fan[2]) for image in images]
    panel = Panel(canvas, (444, 50, 690, 290), [*fan, *images])
    panel.polygon([v, fan[0], fan[1], far[0]], TINT)
    panel.polygon([v, far[1], fan[2], fan[3]], TINT)
    panel.polygon([v, *far], SECOND_TINT)
    for corners in fan_faces(v, fan):
        panel.polygon(corners, 'none', MESH)
    for image, p, edges in zip(images, far, (fan[1::-1], fan[2:])):
        panel.line([image, v], RESULT)
        panel.line([v, p], RESULT, LINE, DOTS)
        panel.line([p, *edges], RESULT, CURVE + 1.5)
    panel.line(far, SECOND, CURVE + 1.5)
    panel.vertices(fan, INK, 4)
    panel.vertices(far, SECOND, 4)
    panel.text(between(*far), 'window of *v*', SECOND, away=(0, 15))
    panel.dot(v, SECOND, 5.5)
    panel.text(v, '*v*', SECOND, away=(14, -12))
    for image, name, edges in zip(images, ('*s*_{L}', '*s*_{R}'), (fan[:2], fan[2:])):
        draw_source(panel, image, name, (0, -17))
        panel.text(centroid([v, *edges]), f'from {name}', RESULT)


# --- Diagrams ---

@drawing
def objects():
    canvas = Canvas(500, 'The objects of a computation and the functions that lead from one to the next')
    left, width, height = 197, 258, 46
    stages = (('triangle mesh', '`FaceListGraph`, `HalfedgeListGraph`'),
              ('`Intrinsic_triangulation`', 'flips, points inserted by `insert()`'),
              ('`Edge_path_network`', 'curves as segments'), ('`Edge_path_network`', 'geodesics as segments'),
              ('curve on the input mesh', 'points, locations or crossed edges'))
    tops = [20 + i * 104 for i in range(len(stages))]
    fills = (FAINT, FAINT, WARM_TINT, TINT, TINT)
    for lines, top, fill in zip(stages, tops, fills):
        canvas.box(left, top, width, height, lines, fill)
    steps = (('constructor', 'faces are copied when a query reaches them'), ('`add_curve()`, `add_straightened_path()`',
             '`draw_polyline()`, `add_region_boundaries()`'), ('`shorten()`', 'flips edges of the triangulation'),
             ('`Curve_extractor`', 'follows edge sequences over the input'))
    for lines, top in zip(steps, tops):
        x = left + width / 2
        canvas.line([(x, top + height + 2), (x, top + 102)], arrow=True)
        for i, label in enumerate(lines):
            canvas.text((x + 14, top + height + 21 + 18 * i), label, anchor='start', size=13)
    draw_free_function(canvas, tops[0], tops[-1] + height)
    draw_side_results(canvas, left + width, tops, height)
    return canvas


def draw_free_function(canvas, top, bottom):
    x, right = 157, 188
    canvas.line([(right, top + 23), (x, top + 23), (x, bottom - 23), (right, bottom - 23)], SECOND, arrow=True)
    for i, label in enumerate(('`geodesic_path()`', '`geodesic_loop()`', '`geodesic_network()`', 'lead from a mesh',
                               'to curves in one call')):
        canvas.text((x - 10, (top + bottom) / 2 + 20 * (i - 2)), label, SECOND, anchor='end', size=13)


def draw_side_results(canvas, left, tops, height):
    for i, lines in ((1, ('better triangles', '`flip_to_delaunay()`, `refine()`')),
                     (3, ('verdict', '`certify()`')), (4, ('mesh with the curves', '`insert_curves()`'))):
        top = tops[i]
        canvas.line([(left + 3, top + height / 2), (left + 24, top + height / 2)], arrow=True)
        for j, label in enumerate(lines):
            canvas.text((left + 30, top + height / 2 + 18 * (j - 0.5)), label, anchor='start', size=13)


CHOICES = (
    ('two points', (('a locally shortest path', '`geodesic_path()`'), ('the shortest path', '`shortest_path()`'),
                    ('paths of several homotopy classes', '`shortest_paths_by_class()`'))),
    ('many pairs of points', (('a locally shortest path for each', '`geodesic_paths()`'),)),
    ('points in order', (('a geodesic through the points', '`geodesic_path_through()`'),
                         ('a smooth curve near the points', '`geodesic_spline()`'))),
    ('a closed curve', (('a closed geodesic in its class', '`geodesic_loop()`'),)),
    ('several curves', (('geodesics that do not cross', '`geodesic_network()`'),
                        ('a mesh with the curves as edges', '`insert_curves()`'))),
    ('sources: points or curves', (('distances of all vertices', '`geodesic_distances()`'),
                                   ('curves at equal distances', '`isolines()`'),
                                   ('the regions of nearest sources', '`voronoi_boundaries()`'))),
    ('a point and a direction', (('the straightest curve', '`trace_geodesic()`'),)),
    ('a point', (('directions and distances from it', '`logarithmic_map()`'),)),
    ('only the surface', (('loops that generate all others', '`geodesic_loop_basis()`'),
                          ('loops around handles and tunnels', '`handle_and_tunnel_loops()`'))))


@drawing
def which_function():
    row, gap, top = 30, 8, 46
    rows = sum(len(wanted) for _, wanted in CHOICES)
    canvas = Canvas(top + row * rows + gap * len(CHOICES), 'Which function computes what')
    for x, title in ((101, 'What is given'), (346, 'What is wanted'), (593, 'Function')):
        canvas.text((x, 20), title, size=15, is_bold=True)
    y = top
    for given, wanted in CHOICES:
        middle = y + row * len(wanted) / 2
        canvas.box(8, middle - 14, 186, 28, [given], WARM_TINT)
        for goal, function in wanted:
            center = y + row / 2
            canvas.line([(194, middle), (203, middle), (203, center), (219, center)], arrow=True)
            canvas.box(220, center - 13, 252, 26, [goal])
            canvas.line([(472, center), (493, center)], arrow=True)
            canvas.box(494, center - 13, 198, 26, [function], TINT, RESULT)
            y += row
        y += gap
    return canvas


KERNEL_ROWS = (
    ('binary floating point', '`float`, `double`, EPICK', ('exact predicates', 'PROVEN'),
     ('rounded, with a tolerance', 'UNDECIDED')),
    ('exact and rational', '`Gmpq`, `cpp_rational`, EPECK', ('exact predicates', 'PROVEN'),
     ('exact, for one radicand', 'PROVEN')),
    ('exact with square roots', '`CORE::Expr`, EPECK with roots', ('exact for rounded coordinates', 'UNDECIDED *'),
     ('exact', 'UNDECIDED *')),
    ('intervals', '`Interval_nt`', ('exact for rounded coordinates', 'UNDECIDED *'),
     ('exact, or an exception', 'UNDECIDED *')),
    ('rounded to other precisions', '`long double`', ('exact for rounded coordinates', 'UNDECIDED *'),
     ('rounded, with a tolerance', 'UNDECIDED')))


@drawing
def kernels():
    canvas = Canvas(416, 'The kernel of the mesh and the traits as two independent choices')
    columns, top, row, size = ((8, 214), (234, 212), (456, 236)), 98, 57, 13
    for y, label in ((58, 'Kernel `K` of the mesh:'), (78, 'the numbers of the surface')):
        canvas.text((115, y), label, size=size, is_bold=True)
    canvas.text((463, 16), 'Traits: the arithmetic of the predicates', size=size, is_bold=True)
    canvas.line([(234, 32), (692, 32)])
    for (left, width), lines in zip(columns[1:], (('default, or', '`geom_traits(K())`'),
                                                  ('`geom_traits()` with', '`Intrinsic_triangulation_traits<K>`'))):
        for i, label in enumerate(lines):
            canvas.text((left + width / 2, 54 + 22 * i), label, size=size - 1 if i else size)
    for i, (name, types, *cells) in enumerate(KERNEL_ROWS):
        y = top + i * row
        canvas.box(columns[0][0], y, columns[0][1], row - 8, (name, types), WARM_TINT, size=size)
        for (left, width), (arithmetic, verdict) in zip(columns[1:], cells):
            colors = (TINT, RESULT) if verdict == 'PROVEN' else (FAINT, MESH)
            canvas.box(left, y, width, row - 8, (arithmetic, f'`{verdict}`'), *colors, size=size)
    canvas.text((8, 398), '* `PROVEN` if all coordinates are doubles', anchor='start', size=size)
    return canvas


# --- Modules ---

def direct_uses(below):
    """The modules that each module uses and does not reach over another one that it uses."""
    return {module: sorted(other for other in used if not any(other in below[third] for third in used))
            for module, used in below.items()}


def levels_of(uses):
    levels = {}
    for module, used in uses.items():  # the table lists a module after those that it uses
        levels[module] = 1 + max((levels[other] for other in used), default=-1)
    return levels


def routes_of(uses, levels):
    """A route for each use: the user, a place in each row that it skips, and the module that it uses."""
    return [[user, *((user, used, level) for level in range(levels[user] - 1, levels[used], -1)), used]
            for user, others in uses.items() for used in others]


def module_places(uses, levels, routes):
    """The horizontal places of modules and of skipped rows for which the lines of the routes are shortest."""
    stops = [*uses, *(stop for route in routes for stop in route[1:-1])]
    rows = [[stop for stop in stops if (stop[2] if isinstance(stop, tuple) else levels[stop]) == level]
            for level in range(1 + max(levels.values()))]

    def places(orders):
        return {stop: WIDTH / 2 + (i - (len(order) - 1) / 2) * 172 for order in orders for i, stop in enumerate(order)}

    def cost(orders):
        x = places(orders)
        return sum((x[a] - x[b]) ** 2 for route in routes for a, b in zip(route, route[1:]))

    return places(min(itertools.product(*map(itertools.permutations, rows)), key=cost))


@drawing
def modules():
    below, _, wrong = modules_of_table(DOC / 'Design.txt')
    if wrong:
        raise ValueError('; '.join(wrong))
    uses = direct_uses(below)
    levels = levels_of(uses)
    routes = routes_of(uses, levels)
    x = module_places(uses, levels, routes)
    row, height, width = 62, 34, 144
    highest = max(levels.values())
    canvas = Canvas(20 + row * highest + height + 10, 'The modules of the library and their partial order')

    def top(level):
        return 14 + row * (highest - level)

    for module, level in levels.items():
        canvas.box(x[module] - width / 2, top(level), width, height, [f'`{module}`'], TINT)
    for user, *skipped, used in routes:
        points = [(x[user], top(levels[user]) + height)]
        for stop in skipped:
            points += [(x[stop], top(stop[2])), (x[stop], top(stop[2]) + height)]
        canvas.line([*points, (x[used], top(levels[used]) - 1)], arrow=True)
    return canvas


# --- The stages of a query ---

SHARED_STAGES = (
    ('import', '`Intrinsic_triangulation`', ('copies a face of the mesh', 'when it is first reached'),
     'one per thread'),
    ('search', '`Shortest_edge_path`', ('finds a short path of edges,', 'directed to the target'), 'memory is reused'))
OWN_STAGES = (
    ('funnel initialization', '`add_straightened_path()`',
     ('makes the shortest path in the strip', 'of faces along the edges'), 'for each path'),
    ('flips', '`shorten()`', ('FlipOut, until no wedge that is free', 'has an angle below *π*'), 'for each path'),
    ('certificate', '`Shortener::report()`', ('exact signs from the coordinates', 'of the input'), 'for each path'),
    ('extraction', '`Curve_extractor`', ('points where the curve crosses', 'edges of the input'), 'for each path'))


@drawing
def lifecycle_of_a_query():
    row, top, left, width, height = 66, 44, 112, 196, 48
    stages = SHARED_STAGES + OWN_STAGES
    canvas = Canvas(top + row * len(stages) - 8, 'The stages of geodesic_path() and what geodesic_paths() shares')
    for x, title in ((left + width / 2, 'Stage'), (440, 'Task'), (632, 'In a batch')):
        canvas.text((x, 20), title, size=15, is_bold=True)
    for i, (stage, function, task, batch) in enumerate(stages):
        y, is_shared = top + i * row, i < len(SHARED_STAGES)
        canvas.box(left, y, width, height, (stage, function), SECOND_TINT if is_shared else FAINT,
                   SECOND if is_shared else INK, first_bold=True)
        if i + 1 < len(stages):
            canvas.line([(left + width / 2, y + height), (left + width / 2, y + row - 1)], arrow=True)
        for j, label in enumerate(task):
            canvas.text((left + width + 16, y + height / 2 + 18 * (j - 0.5)), label, anchor='start', size=13)
        canvas.text((632, y + height / 2), batch, SECOND if is_shared else INK, size=13)
    draw_repetition(canvas, left, top + height / 2 + row * (len(stages) - 1), top + height / 2 + row)
    return canvas


def draw_repetition(canvas, right, bottom, top):
    canvas.line([(right - 2, bottom), (right - 16, bottom), (right - 16, top), (right - 2, top)], SECOND, arrow=True)
    for i, label in enumerate(('next pair', 'of a batch:', '`rollback()`')):
        canvas.text((right - 24, (top + bottom) / 2 + 20 * (i - 1)), label, SECOND, anchor='end', size=13)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--check', action='store_true', help='compare with the files in fig/ and write nothing')
    is_check = parser.parse_args().check
    different = []
    for name, draw in DRAWINGS.items():
        path, text = FIGURES / f'{name}.svg', draw().svg()
        if not is_check:
            path.write_text(text)
        elif not path.is_file() or path.read_text() != text:
            different.append(f'{path.relative_to(DOC)} is not what drawings.py writes; run it again')
    print('\n'.join(different) if different else f'{len(DRAWINGS)} drawings')
    return 1 if different else 0


if __name__ == '__main__':
    sys.exit(main())
