# SPDX-License-Identifier: LGPL-3.0-or-later
"""Plane geometry and SVG output for the schematic drawings of the manual, with the standard library only."""

import itertools
import math
import re
from html import escape

from figure_colors import INK, MESH, WHITE

WIDTH = 700  # of all drawings, in pixels
LINE, CURVE = 2, 3.5  # widths of lines and of curves on the surface
FAINT = '#f4f2ee'  # faces, and boxes of diagrams
DASHES = '9 5'
DOTS = '2 5'
SANS = 'Helvetica, Arial, &quot;Liberation Sans&quot;, &quot;DejaVu Sans&quot;, sans-serif'
MONO = '&quot;DejaVu Sans Mono&quot;, Menlo, Consolas, &quot;Liberation Mono&quot;, monospace'
TEXT_SIZE, CODE_SCALE, SUBSCRIPT_SCALE = 14, 0.9, 0.72
CODE_WIDTH = 0.602  # of each character of the monospaced font, in ems

# The widths of the characters from the space to the tilde, in thousandths of an em, in DejaVu Sans, plain and bold.
# Text set in one of the other fonts above is narrower.
CHARACTER_WIDTHS = [
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337, 636, 636, 636, 636, 636, 636,
    636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656,
    557, 863, 748, 787, 603, 787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838, 500, 500, 613,
    635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818,
    592, 592, 525, 636, 337, 636, 838]
BOLD_CHARACTER_WIDTHS = [
    348, 456, 521, 838, 696, 1002, 872, 306, 457, 457, 523, 838, 380, 415, 380, 365, 696, 696, 696, 696, 696, 696,
    696, 696, 696, 696, 400, 400, 838, 838, 838, 580, 1000, 774, 762, 734, 830, 683, 683, 821, 837, 372, 372, 775,
    637, 995, 837, 850, 733, 850, 770, 720, 682, 812, 774, 1103, 771, 724, 725, 457, 365, 457, 838, 500, 500, 675,
    716, 593, 716, 678, 435, 716, 712, 343, 343, 665, 343, 1042, 712, 687, 716, 716, 493, 595, 478, 712, 652, 924,
    645, 652, 582, 712, 365, 712, 838]
OTHER_CHARACTER_WIDTH = 660  # of Greek letters
MARKUP = re.compile(r'`([^`]+)`|\*([^*]+)\*|_\{([^}]+)\}|([^`*_]+|[*_])')


# --- plane geometry; points are pairs, and turns are counterclockwise ---

def plus(p, q, factor=1.0):
    return p[0] + factor * q[0], p[1] + factor * q[1]


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def between(p, q, t=0.5):
    return p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])


def centroid(points):
    return sum(p[0] for p in points) / len(points), sum(p[1] for p in points) / len(points)


def unit(v):
    length = math.hypot(*v)
    return v[0] / length, v[1] / length


def polar(degrees, radius=1.0):
    return radius * math.cos(math.radians(degrees)), radius * math.sin(math.radians(degrees))


def direction(p, q):
    """The angle of the vector from p to q in degrees."""
    return math.degrees(math.atan2(q[1] - p[1], q[0] - p[0]))


def turn(p, q, r):
    """Twice the signed area of a triangle: positive if r lies to the left of the line from p to q."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def angle_at(q, p, r):
    """The angle at q between the directions to p and to r, from 0 to 180 degrees."""
    return abs((direction(q, p) - direction(q, r) + 180) % 360 - 180)


def is_convex(polygon):
    turns = [turn(polygon[i - 2], polygon[i - 1], p) for i, p in enumerate(polygon)]
    return min(turns) > 0 or max(turns) < 0


def crossing(p, q, a, b):
    """The parameter along pq at which that segment crosses the interior of ab; None if it does not."""
    at_p, at_q, at_a, at_b = turn(a, b, p), turn(a, b, q), turn(p, q, a), turn(p, q, b)
    return at_p / (at_p - at_q) if at_p * at_q < 0 and at_a * at_b < 0 else None


def line_meeting(p, q, a, b):
    """The point of the line ab on the line pq."""
    at_a, at_b = turn(p, q, a), turn(p, q, b)
    return between(a, b, at_a / (at_a - at_b))


def is_in_circle(p, a, b, c):
    """Whether p lies inside the circle through the corners of a counterclockwise triangle."""
    rows = [(x, y, x * x + y * y) for x, y in (minus(q, p) for q in (a, b, c))]
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) > 0


def delaunay(points):
    """The counterclockwise faces of the Delaunay triangulation of a few points in general position."""
    def is_face(face):
        corners = [points[v] for v in face]
        return not any(is_in_circle(p, *corners) for v, p in enumerate(points) if v not in face)

    faces = [(a, b, c) if turn(points[a], points[b], points[c]) > 0 else (a, c, b)
             for a, b, c in itertools.combinations(range(len(points)), 3)]
    return [face for face in faces if is_face(face)]


def edges_of(faces):
    return sorted({tuple(sorted((face[i - 1], face[i]))) for face in faces for i in range(len(face))})


def crossed_edges(points, edges, p, q):
    """The edges that a segment crosses, in order, each with the parameter of the crossing."""
    found = ((crossing(p, q, points[a], points[b]), (a, b)) for a, b in edges)
    return sorted((t, edge) for t, edge in found if t is not None)


def funnel_steps(start, portals):
    """
    The funnel after each portal (left, right) of a strip: the path from the start to the apex, and the chains from the
    apex to the left and to the right end of the portal [LP84].
    """
    path, left, right = [start], [start], [start]

    def extend(chain, other, p, sign):
        if p == chain[-1]:
            return
        while len(chain) > 1 and sign * turn(chain[-2], chain[-1], p) <= 0:
            chain.pop()
        while len(chain) == 1 and len(other) > 1 and sign * turn(other[0], other[1], p) <= 0:
            other.pop(0)
            chain[0] = other[0]
            path.append(other[0])
        chain.append(p)

    for left_end, right_end in portals:
        extend(left, right, left_end, 1)
        extend(right, left, right_end, -1)
        yield list(path), list(left), list(right)


def shortest_in_strip(start, portals, end):
    """The shortest path from start to end through the portals of a strip."""
    *_, (path, left, _) = funnel_steps(start, [*portals, (end, end)])
    return path + left[1:]


def shortest_in_class(path, obstacles):
    """The shortest path that a path can be moved to in the plane without crossing an obstacle: vertices that are not at
    obstacles are removed, and corners are replaced with the convex hull of the obstacles that they contain."""
    path = list(path)
    i = 1
    while i < len(path) - 1:
        a, b, c = path[i - 1:i + 2]
        sign = 1 if turn(a, b, c) > 0 else -1
        inside = [p for p in obstacles if p not in (a, b, c) and sign * turn(a, b, p) >= 0 and
                  sign * turn(b, c, p) >= 0 and sign * turn(c, a, p) >= 0]
        if b in obstacles or turn(a, b, c) == 0:
            i += 1
            continue
        chain = [a]
        while chain[-1] != c:  # gift wrapping along the side of b
            chain.append(next(p for p in [*inside, c] if p not in chain and
                              all(sign * turn(chain[-1], p, q) >= 0 for q in [*inside, c])))
        path[i:i + 1] = chain[1:-1]
        i = max(1, i - 1)
    return path


def visible_part(source, portals):
    """The directions from a source that pass all portals (left, right), as the two points of the last one."""
    left, right = portals[0]
    for end_on_left, end_on_right in portals[1:]:
        if turn(source, left, end_on_left) < 0:
            left = end_on_left
        if turn(source, right, end_on_right) > 0:
            right = end_on_right
    a, b = portals[-1]
    return line_meeting(source, left, a, b), line_meeting(source, right, a, b)


def flip_out(b, fan):
    """The fans after each flip of FlipOut [SC20, Algorithm 1] at b, from the given one on, and the flipped vertices."""
    def outer_angle(fan, i):
        return angle_at(fan[i], fan[i - 1], b) + angle_at(fan[i], b, fan[i + 1])

    yield list(fan), None
    while True:
        i = next((i for i in range(1, len(fan) - 1) if outer_angle(fan, i) < 180), None)
        if i is None:
            return
        assert is_convex([b, *fan[i - 1:i + 2]]), 'the edge cannot be flipped'
        flipped, fan = fan[i], fan[:i] + fan[i + 1:]
        yield list(fan), flipped


# --- SVG ---

def parts_of(label):
    """The parts of a label: pairs of a style and a text, of `code`, *italics*, _{subscripts} and plain text."""
    for code, italic, subscript, plain in MARKUP.findall(label):
        yield next((style, text) for style, text in
                   (('code', code), ('italic', italic), ('subscript', subscript), ('plain', plain)) if text)


def text_width(label, size, is_bold=False):
    widths = BOLD_CHARACTER_WIDTHS if is_bold else CHARACTER_WIDTHS

    def width(style, text):
        if style == 'code':
            return CODE_WIDTH * CODE_SCALE * len(text)
        ems = sum(widths[ord(c) - 32] if ' ' <= c <= '~' else OTHER_CHARACTER_WIDTH for c in text) / 1000
        return ems * (SUBSCRIPT_SCALE if style == 'subscript' else 1)

    return size * sum(width(style, text) for style, text in parts_of(label))


def number(x):
    """A coordinate with one decimal, so that the last bits of a computation have no effect."""
    text = f'{round(x, 1) + 0.0:.1f}'
    return text[:-2] if text.endswith('.0') else text


def spans(label, size):
    """The label as it stands between the tags of a text."""
    result, drop = '', 0.0
    for style, text in parts_of(label):
        shift = 0.28 * size if style == 'subscript' else 0.0
        attributes = f' dy="{number(shift - drop)}"' if shift != drop else ''
        attributes += {'code': f' font-family="{MONO}" font-size="{number(CODE_SCALE * size)}"',
                       'italic': ' font-style="italic"',
                       'subscript': f' font-size="{number(SUBSCRIPT_SCALE * size)}"', 'plain': ''}[style]
        result += f'<tspan{attributes}>{escape(text)}</tspan>' if attributes else escape(text)
        drop = shift
    return result


class Canvas:
    """A drawing of the common width. Coordinates are pixels from the upper left corner."""

    def __init__(self, height, title):
        self.height, self.title = height, title
        self._elements, self._labels = [], []

    def __call__(self, p):
        return p

    def _add(self, tag, fill='none', stroke='none', line_width=0.0, dashes=None, **attributes):
        listed = {**attributes, 'fill': fill}
        if stroke != 'none':
            listed.update({'stroke': stroke, 'stroke-width': number(line_width)})
        if dashes:
            listed['stroke-dasharray'] = dashes
        written = ' '.join(f'{name.replace("_", "-")}="{value}"' for name, value in listed.items())
        self._elements.append(f'<{tag} {written}/>')

    def polygon(self, points, fill, stroke='none', width=LINE):
        corners = ' '.join(','.join(map(number, self(p))) for p in points)
        self._add('polygon', fill, stroke, width, points=corners, stroke_linejoin='round')

    def line(self, points, color=INK, width=LINE, dashes=None, arrow=False):
        points = [self(p) for p in points]
        if arrow:
            points[-1] = self._arrow_head(points[-2], points[-1], color, width)
        self._add('polyline', 'none', color, width, dashes, points=' '.join(','.join(map(number, p)) for p in points),
                  stroke_linejoin='round', stroke_linecap='butt' if dashes == DASHES else 'round')

    def _arrow_head(self, p, tip, color, width):
        """Draws the head of an arrow, and returns the point where its line ends."""
        length = 5 + 2.2 * width
        along = unit(minus(tip, p))
        end, side = plus(tip, along, -length), (-along[1], along[0])
        corners = [tip, plus(end, side, 0.42 * length), plus(end, side, -0.42 * length)]
        self._add('polygon', color, points=' '.join(','.join(map(number, p)) for p in corners))
        return plus(tip, along, -0.8 * length)

    def dot(self, p, color=INK, radius=4.5):
        x, y = self(p)
        self._add('circle', color, WHITE, 1, cx=number(x), cy=number(y), r=number(radius))

    def angle(self, p, start, end, radius, color=INK, fill='none'):
        """The arc at p from one direction to another one, in degrees and counterclockwise, with a radius in pixels."""
        x, y = self(p)
        steps = max(2, round(((end - start) % 360) / 6))
        arc = [plus((x, y), polar(-(start + (end - start) % 360 * i / steps), radius)) for i in range(steps + 1)]
        points = ' '.join(','.join(map(number, q)) for q in arc)
        if fill != 'none':
            self._add('polygon', fill, points=f'{number(x)},{number(y)} {points}')
        self._add('polyline', 'none', color, LINE, points=points)

    def text(self, p, label, color=INK, size=TEXT_SIZE, anchor='middle', is_bold=False, away=(0, 0), has_halo=False):
        """A label with its middle, or its start or end, at p, moved by a vector of pixels with y upwards.
        Returns where it ends on the right."""
        x, y = self(p)
        x, y, width = x + away[0], y - away[1], text_width(label, size, is_bold)
        left = x - {'start': 0, 'middle': 0.5, 'end': 1}[anchor] * width
        self._labels.append((left, y - 0.42 * size, left + width, y + 0.42 * size, label))
        style = ' font-weight="bold"' if is_bold else ''
        style += f' stroke="{WHITE}" stroke-width="4" stroke-linejoin="round" paint-order="stroke"' if has_halo else ''
        place = f'x="{number(x)}" y="{number(y + 0.35 * size)}" text-anchor="{anchor}"'
        self._elements.append(f'<text {place} fill="{color}" font-size="{size}"{style}>{spans(label, size)}</text>')
        return left + width

    def upright_text(self, p, label, size):
        """A label that is read from below, with its middle at p."""
        x, y = p
        half = text_width(label, size) / 2
        self._labels.append((x - 0.42 * size, y - half, x + 0.42 * size, y + half, label))
        place = f'transform="translate({number(x + 0.35 * size)} {number(y)}) rotate(-90)" text-anchor="middle"'
        self._elements.append(f'<text {place} fill="{INK}" font-size="{size}">{spans(label, size)}</text>')

    def box(self, left, top, width, height, lines, fill=FAINT, stroke=INK, size=TEXT_SIZE, first_bold=False):
        """A box with centred lines of text. Returns the middles of its left, right, upper and lower side."""
        corners = {'x': left, 'y': top, 'width': width, 'height': height, 'rx': 6.0}
        self._add('rect', fill, stroke, LINE, **{name: number(value) for name, value in corners.items()})
        for i, label in enumerate(lines):
            is_bold = first_bold and i == 0
            assert text_width(label, size, is_bold) <= width - 8, f'"{label}" is too long for its box'
            y = top + height / 2 + (i - (len(lines) - 1) / 2) * 1.3 * size
            self.text((left + width / 2, y), label, size=size, is_bold=is_bold)
        return ((left, top + height / 2), (left + width, top + height / 2), (left + width / 2, top),
                (left + width / 2, top + height))

    def panel_letter(self, letter, left, top):
        self.text((left, top), f'({letter})', size=15, anchor='start', is_bold=True)

    def _check_labels(self):
        for a, b in itertools.combinations(self._labels, 2):
            if a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]:
                raise ValueError(f'{self.title}: the labels "{a[4]}" and "{b[4]}" overlap')
        for left, top, right, bottom, label in self._labels:
            if left < 0 or top < 0 or right > WIDTH or bottom > self.height:
                raise ValueError(f'{self.title}: the label "{label}" is not inside the drawing')

    def svg(self):
        self._check_labels()
        return '\n'.join([
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{self.height}" '
            f'viewBox="0 0 {WIDTH} {self.height}" role="img" font-family="{SANS}">',
            '<!-- SPDX-License-Identifier: LGPL-3.0-or-later; written by drawings.py -->',
            f'<title>{escape(self.title)}</title>',
            f'<rect width="{WIDTH}" height="{self.height}" fill="{WHITE}"/>', *self._elements, '</svg>', ''])


class Panel(Canvas):
    """A part of a canvas with coordinates of its own, y upwards, in which some points fill a box of pixels."""

    def __init__(self, canvas, box, points):
        left, top, right, bottom = box
        low = [min(p[i] for p in points) for i in (0, 1)]
        high = [max(p[i] for p in points) for i in (0, 1)]
        self.scale = min((right - left) / (high[0] - low[0]), (bottom - top) / (high[1] - low[1]))
        self._middle = between(low, high)
        self._center = (left + right) / 2, (top + bottom) / 2
        self._elements, self._labels = canvas._elements, canvas._labels

    def __call__(self, p):
        offset = minus(p, self._middle)
        return self._center[0] + self.scale * offset[0], self._center[1] - self.scale * offset[1]

    def mesh(self, points, faces, fill=FAINT, color=MESH, width=LINE):
        for face in faces:
            self.polygon([points[v] for v in face], fill)
        for a, b in edges_of(faces):
            self.line([points[a], points[b]], color, width)

    def vertices(self, points, color=MESH, radius=3.0):
        for p in points:
            self.dot(p, color, radius)


def power_name(value):
    """A power of ten with its digits in groups."""
    return f'{value:,.0f}'.replace(',', ' ') if value >= 1 else f'{value:.{-round(math.log10(value))}f}'


class Plot(Canvas):
    """A part of a canvas with axes, both logarithmic unless stated otherwise."""

    MARGIN = 0.04  # between the ranges and the ends of the axes, relative to the axes
    GRID = '#e1e3e6'

    def __init__(self, canvas, box, x_range, y_range, is_y_logarithmic=True):
        self.x_range, self.y_range, self.box = x_range, y_range, box
        self._canvas, self._is_y_logarithmic = canvas, is_y_logarithmic
        self._elements, self._labels = canvas._elements, canvas._labels

    def __call__(self, p):
        left, top, right, bottom = self.box
        x = self._part(p[0], self.x_range, True)
        y = self._part(p[1], self.y_range, self._is_y_logarithmic)
        return left + x * (right - left), bottom - y * (bottom - top)

    def _part(self, value, value_range, is_logarithmic):
        low, high, value = (math.log(v) if is_logarithmic else v for v in (*value_range, value))
        return self.MARGIN + (1 - 2 * self.MARGIN) * (value - low) / (high - low)

    @staticmethod
    def _powers(value_range, room, spacing):
        """The powers of ten in a range, and whether they have labels, which are at least `spacing` pixels apart."""
        low, high = (math.log10(value) for value in value_range)
        step = math.ceil(spacing * (high - low) / room)
        exponents = range(math.ceil(low), math.floor(high) + 1)
        return [(10.0 ** e, (e - exponents[-1]) % step == 0) for e in exponents]

    def axes(self, x_label, y_label):
        """Draws the axes and the grid of powers of ten. An axis without a name has no numbers either."""
        left, top, right, bottom = self.box
        for x, has_label in self._powers(self.x_range, right - left, 58):
            at = self((x, self.y_range[0]))[0]
            self._canvas.line([(at, top), (at, bottom)], self.GRID, 1)
            if has_label and x_label:
                self._canvas.text((at, bottom + 14), power_name(x), size=12)
        for y, has_label in self._powers(self.y_range, bottom - top, 18) if self._is_y_logarithmic else ():
            at = self((self.x_range[0], y))[1]
            self._canvas.line([(left, at), (right, at)], self.GRID, 1)
            if has_label and y_label:
                self._canvas.text((left - 7, at), power_name(y), size=12, anchor='end')
        self._canvas.line([(left, top), (left, bottom), (right, bottom)], MESH)
        if x_label:
            self._canvas.text(((left + right) / 2, bottom + 34), x_label, size=13)
        if y_label:
            self._canvas.upright_text((left - 52, (top + bottom) / 2), y_label, size=13)

    def dots(self, points, color, diameter=3.5):
        """Many dots as one element."""
        places = ''.join('M' + ','.join(map(number, self(p))) + 'h0' for p in points)
        self._add('path', 'none', color, diameter, d=places, stroke_linecap='round')

    def power_line(self, factor, power, color):
        """The graph of a power function, as far as it lies inside the ranges."""
        low, high = self.x_range
        bounds = sorted((y / factor) ** (1 / power) for y in self.y_range)
        self.line([(x, factor * x ** power) for x in (max(low, bounds[0]), min(high, bounds[1]))], color)

    def slope_triangle(self, corner, power):
        """A triangle over one power of ten with the slope of a power function, and with its exponent."""
        x, y = corner
        self.line([(x, y), (10 * x, y), (10 * x, y * 10 ** power), (x, y)], INK, 1.5)
        self.text((10 * x, y * 10 ** (power / 2)), f'{power:g}', size=12, anchor='start', away=(6, 0))
        self.text((x * 10 ** 0.5, y), '1', size=12, away=(0, -10))
