# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads the scene back from a page of `flip_geodesics --page`: for tests, figures, and scripts of users.

    page = Page('curves.html')
    page.points, page.faces        the mesh
    page.curves[i]                 the points of curve i
    for state in page.runs[0].states():
        state.edges                the polylines of the intrinsic edges that take part in the run
        state.lines                the curves of the run at that step
"""

import base64
import json
import re
import struct
import zlib
from pathlib import Path


def _integers(array):
    """Numbers in base 64; or, packed, differences to the number three before, first their lowest bytes, deflated."""
    if isinstance(array, str):
        data = base64.b64decode(array, validate=True)
        return struct.unpack(f'<{len(data) // 4}I', data)
    data = zlib.decompress(base64.b64decode(array['packed'], validate=True))
    count = len(data) // 4
    together = bytearray(len(data))
    for k in range(4):
        together[k::4] = data[k * count:(k + 1) * count]
    numbers = list(struct.unpack(f'<{count}I', together))
    for i in range(3, count):
        numbers[i] = (numbers[i] + numbers[i - 3]) & 0xffffffff
    return tuple(numbers)


def _lists(numbers):
    """Lists that have their length in front."""
    numbers, result = iter(numbers), []
    for count in numbers:
        result.append([next(numbers) for _ in range(count)])
    return result


def _expect(condition, message):
    if not condition:
        raise ValueError(message)


class State:
    """A run after `step` of its steps. A curve is a list of segments, 2 * edge + (1 if it is passed backwards)."""

    def __init__(self, run):
        self.run = run
        self.step = 0
        self.flips = 0
        self.present = set(run.edges)
        self.fresh = []
        self.curves = [list(curve) for curve in run.start]

    def advance(self):
        flips, curve, in_front, at_end, inserted = self.run.steps[self.step]
        for old, new in flips:
            _expect(old in self.present and new not in self.present, f'a flip from edge {old} to edge {new}')
            self.present.remove(old)
            self.present.add(new)
        self.fresh = [new for _, new in flips]
        self.curves[curve][in_front:len(self.curves[curve]) - at_end] = inserted
        self.step += 1
        self.flips += len(flips)

    @property
    def edges(self):
        return [self.run.polylines[edge] for edge in sorted(self.present)]

    @property
    def lines(self):
        return [self._line(curve) for curve in self.curves]

    def _line(self, curve):
        result = []
        for segment in curve:
            _expect(segment // 2 in self.present, f'a segment runs along edge {segment // 2}, which is not there')
            piece = self.run.polylines[segment // 2][::-1 if segment % 2 else 1]
            _expect(not result or result[-1] == piece[0], 'segments of a curve do not meet')
            result += piece[1:] if result else piece
        return result


class Run:
    """How curves were shortened together: `polylines` of all edges that took part, `edges`, the numbers of those at
    the start, `steps`, and `input_edges`, the edges of the mesh that took part: each its number in `polylines`, None
    if it was gone before the start, and its vertices."""

    def __init__(self, page, run):
        self.polylines = page.to_polylines(run['edgePoints'], run['edgeStarts'])
        numbers = _integers(run['inputEdges'])
        triples = zip(numbers[0::3], numbers[1::3], numbers[2::3])
        self.input_edges = [(None if edge == 0xffffffff else edge, a, b) for edge, a, b in triples]
        self.edges = _integers(run['edges'])
        self.start = _lists(_integers(run['curves']))
        self.steps = list(self._read_steps(iter(_integers(run['steps']))))
        self.has_all_steps = run['hasAllSteps']

    @staticmethod
    def _read_steps(numbers):
        for count in numbers:
            flips = [(next(numbers), next(numbers)) for _ in range(count)]
            curve, in_front, at_end, inserted = (next(numbers) for _ in range(4))
            yield flips, curve, in_front, at_end, [next(numbers) for _ in range(inserted)]

    def states(self):
        """One state, before the first step, after it, and so on to the end."""
        state = State(self)
        yield state
        while state.step < len(self.steps):
            state.advance()
            yield state

    def state(self, step):
        """The state after some steps; negative ones count from the end, -1 being the last."""
        state = State(self)
        for _ in range(step if step >= 0 else len(self.steps) + 1 + step):
            state.advance()
        return state


class Page:
    """A page: `points` and `faces` of the mesh, `curves` by number, `runs`, and the JSON object `scene`."""

    def __init__(self, path):
        self.text = Path(path).read_text(encoding='utf-8')
        found = re.findall(r'<script type="application/json" id="scene">(.*?)</script>', self.text, re.S)
        _expect(len(found) == 1, f'{path}: not one scene')
        self.scene = json.loads(found[0])
        self.points = self.to_points(self.scene['positions'])
        corners = _integers(self.scene['corners'])
        self.faces = list(zip(corners[0::3], corners[1::3], corners[2::3]))
        lines = self.to_polylines(self.scene['curvePoints'], self.scene['curveStarts'])
        self.curves = {c['number']: line for c, line in zip(self.scene['curves'], lines) if line}
        self.runs = [Run(self, run) for run in self.scene['runs']]

    def to_points(self, array):
        bits = _integers(array)
        numbers = struct.unpack(f'<{len(bits)}f', struct.pack(f'<{len(bits)}I', *bits))
        center, radius = self.scene['center'], self.scene['radius']
        return [tuple(c + radius * x for c, x in zip(center, numbers[k:k + 3])) for k in range(0, len(numbers), 3)]

    def to_polylines(self, points, starts):
        points, starts = self.to_points(points), _integers(starts)
        _expect(starts[0] == 0 and starts[-1] == len(points), 'polylines do not fill their points')
        return [points[a:b] for a, b in zip(starts, starts[1:])]
