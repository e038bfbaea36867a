# SPDX-License-Identifier: LGPL-3.0-or-later
"""Uses the interactive viewer in a browser as a user does, by pointer, touch and keyboard, and compares the curves with
those that the program computes by the commands that the page shows.

    check_live_page.py --program flip_geodesics --mesh FILE.off --chromium BROWSER
"""

import argparse
import csv
import json
import math
import shlex
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

from browser import CTRL, SHIFT, Browser
from check_viewer_files import compare, read_glb, read_obj, read_off, read_ply, read_polylines_txt

SIZE = (1200, 800)

# Counts what a page could leave behind for every mesh that it opens.
COUNTERS = '''
const counted = { contexts: new Set(), workers: new Set(), observers: new Set() };
const getContext = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
  const context = getContext.call(this, kind, ...options);
  if (kind.startsWith('webgl') && context) counted.contexts.add(context);
  return context;
};
window.Worker = class extends Worker {
  constructor(...options) { super(...options); counted.workers.add(this); }
  terminate() { super.terminate(); counted.workers.delete(this); }
};
window.ResizeObserver = class extends ResizeObserver {
  constructor(...options) { super(...options); counted.observers.add(this); }
  disconnect() { super.disconnect(); counted.observers.delete(this); }
};
'''

# Two triangles of opposite orientation, one of them twice, and a point without faces.
PIECES = 'OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 9 9\n3 0 1 2\n3 0 3 2\n3 0 1 2\n'
QUAD = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n'
TRIANGLE = 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'


# Ends when what was changed has been drawn.
FRAMES = 'new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 100))))'
IMAGE = "document.getElementById('view').toDataURL()"


def check(condition, message):
    if not condition:
        raise SystemExit(f'check_live_page: {message}')


class Live_page:
    """The page, and what a user does with it. Each action waits until the page has computed."""

    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        subprocess.run([options.program, 'view', options.mesh, '--quiet', '--output', folder / 'live.html'], check=True)
        self.browser = Browser(options.chromium, folder / 'live.html', folder, SIZE, COUNTERS)
        self.browser.wait_for('document.documentElement?.dataset.state')
        check(self.data('state') == 'ready', self.browser.text('#message'))
        self.settle()
        self.points = read_off(options.mesh)[0]
        self.compared = 0

    def data(self, name):
        return self.browser.evaluate(f'document.documentElement.dataset.{name}')

    def settle(self):
        self.browser.wait_for("document.documentElement.dataset.isIdle === 'true'")

    def button(self, selector):
        self.browser.click(*self.browser.middle_of(selector))
        self.settle()

    def key(self, *key):
        self.browser.press(*key)
        self.settle()

    def type(self, selector, text):
        self.browser.type(selector, text)
        self.settle()

    def tool(self, name):
        self.button(f'label:has([data-tool={name}])')

    def option(self, name):
        self.button(f'[data-option={name}]')

    def on_view(self, x, y):
        """A point of the window, by shares of the view."""
        return self.browser.evaluate(f'''(() => {{
            const box = document.getElementById('view').getBoundingClientRect();
            return [box.left + {x} * box.width, box.top + {y} * box.height];
        }})()''')

    def click(self, x, y, modifiers=0, button='left'):
        self.browser.click(*self.on_view(x, y), modifiers, button)
        self.settle()

    def drag(self, start, end):
        """Drags in steps, and compares the curve after each, unless the page finds it too slow to follow the pointer."""
        (x, y), (u, v) = self.on_view(*start), self.on_view(*end)
        self.browser.mouse('mouseMoved', x, y, button='none')
        self.browser.mouse('mousePressed', x, y)
        lines = set()
        for t in (0.25, 0.5, 0.75, 1):
            self.browser.mouse('mouseMoved', x + t * (u - x), y + t * (v - y))
            self.settle()
            if self.data('isCurrent') == 'true':
                self.compare_with_program()
            lines.add(self.data('line'))
        self.browser.mouse('mouseReleased', u, v)
        self.settle()
        self.compare_with_program()
        check(len(lines) == 4, f'the drag has not moved the point: {lines}')

    def under(self, x, y):
        """The coordinates of the surface under a point of the window, or None."""
        self.browser.evaluate("document.getElementById('under').textContent = ''")
        self.browser.mouse('mouseMoved', x, y, button='none')
        self.browser.evaluate(FRAMES)
        words = self.browser.text('#under').replace(',', ' ').replace('(', ' ').replace(')', ' ').split()
        return tuple(map(float, words[:3])) if words else None

    def place_of(self, vertex, x, y):
        """Where in the view a vertex is that is drawn near a point of it."""
        def distance(place):
            found = self.under(*self.on_view(*place))
            return math.dist(found, self.points[vertex]) if found else math.inf
        best, least, step = (x, y), distance((x, y)), 0.03
        while step > 0.001:
            x, y = best
            places = [(x + step, y), (x - step, y), (x, y + step), (x, y - step)]
            nearest = min(places, key=distance)
            if distance(nearest) < least:
                best, least = nearest, distance(nearest)
            else:
                step /= 2
        return best

    def touch(self, at, expected):
        self.browser.touch(*at)
        self.browser.wait_for(expected)
        self.settle()

    def rows(self, items):
        return self.browser.evaluate(f"document.querySelectorAll('#{items} > li').length")

    def open(self, name, text):
        (self.folder / name).write_text(text)
        self.browser.choose_file('#file', self.folder / name)
        self.browser.wait_for(f"['title', 'error'].some((id) => document.getElementById(id).textContent.startsWith('{name}'))")
        self.settle()

    def save(self, kind):
        name = 'points.txt' if kind == 'points' else f'{self.options.mesh.stem}_curves.{kind}'
        return self.browser.download(name, lambda: self.browser.click(*self.browser.middle_of(f'[data-format="{kind}"]')))

    def lengths(self):
        return [float(length) for length in self.data('lengths').split()]

    def compare_with_program(self, tolerance=1e-12):
        """The lengths are those of the command that the page shows."""
        command = self.browser.text('#command').split(';')[0]
        check(command.startswith('flip_geodesics '), f'the page shows no command: {command}, {self.browser.text("#error")}')
        (self.folder / 'points.txt').write_text(self.data('line') + '\n')
        arguments = [self.options.mesh if word == self.options.mesh.name else word for word in shlex.split(command)[1:]]
        subprocess.run([self.options.program, *arguments, '--quiet', '--stats', 'stats.csv'], check=True, cwd=self.folder)
        with open(self.folder / 'stats.csv', encoding='ascii') as file:
            expected = [float(row['length']) for row in csv.DictReader(file)]
        found = self.lengths()
        check(len(found) == len(expected) > 0 and all(abs(a - b) <= tolerance * b for a, b in zip(found, expected)),
              f'{command}, {self.data("line")}: {found} on the page, {expected} by the program')
        self.compared += 1

    def check_certificate(self):
        check(set(self.data('certificates').split()) == {'PROVEN'}, f'{self.data("line")}: {self.data("certificates")}')


SPOTS = [(0.3, 0.5), (0.7, 0.5), (0.66, 0.62), (0.5, 0.3)]


def check_points(page):
    """Points are set, dragged, inserted and removed, by mouse, keys, buttons and touch; all of it is undone."""
    page.button('#clear')
    page.click(*SPOTS[0])
    page.click(*SPOTS[1])
    page.compare_with_program()
    page.check_certificate()
    first = page.data('line')
    page.drag(SPOTS[1], SPOTS[2])
    dragged = page.data('line')
    page.key('z', CTRL)
    check(page.data('line') == first, f'a drag is not undone at once: {page.data("line")}')
    page.key('z', CTRL | SHIFT)
    check(page.data('line') == dragged, 'the drag is not redone')
    page.click(*SPOTS[3])
    page.compare_with_program()
    words = page.data('line').split()
    page.click(0.32, 0.4, SHIFT)
    inserted = page.data('line').split()
    check(len(inserted) == 4 and [w for w in inserted if w in words] == words and inserted[-1] == words[-1],
          f'no point between: {words}, {inserted}')
    page.compare_with_program()
    page.key('Delete')
    check(page.data('line').split() == words, 'the point that was inserted is not removed')

    (length,) = page.lengths()
    page.button('#points li:nth-child(2) .insert')
    inserted = page.data('line').split()
    check(len(inserted) == 4 and inserted[:2] == words[:2] and inserted[3] == words[2], f'no point behind: {inserted}')
    check(abs(page.lengths()[0] - length) < 1e-4 * length, 'the point that was inserted is not on the path')
    page.compare_with_program()
    before = page.data('line')
    for _ in range(3):
        page.key('ArrowRight')
    page.key('ArrowDown', SHIFT)
    moved = page.data('line').split()
    check([a == b for a, b in zip(moved, inserted)] == [True, True, False, True], f'the keys do not move the point: {moved}')
    page.compare_with_program()
    page.button('#undo')
    check(page.data('line') == before, 'the keys are not undone together')
    page.button('#redo')
    check(page.data('line').split() == moved, 'the keys are not redone')
    page.key('r')  # the keys have turned the view to a point that was hidden
    page.click(*SPOTS[0], button='right')
    check(page.data('line').split() == moved[1:], 'a right click does not remove a point')
    page.browser.call('Emulation.setTouchEmulationEnabled', enabled=True)
    page.touch(page.browser.middle_of('#points li:nth-child(2) .remove'), 'document.querySelectorAll("#points > li").length === 2')
    check(page.data('line').split() == [moved[1], moved[3]], 'a touch does not remove a point')
    page.touch(page.on_view(*SPOTS[0]), 'document.querySelectorAll("#points > li").length === 3')
    page.key('Escape')
    page.touch(page.on_view(*SPOTS[0]), 'document.querySelector("#points li:nth-child(3) [aria-pressed=true]")?.tagName === "BUTTON"')
    page.browser.call('Emulation.setTouchEmulationEnabled', enabled=False)
    page.key('Delete')
    check(page.data('line').split() == [moved[1], moved[3]], 'a point that was chosen by a touch is not removed')
    page.type('#place input', '17')
    check(page.data('line').split()[-1] == '17', f'no point at vertex 17: {page.data("line")}')
    before = page.data('line')
    page.type('#place input', '20.0')
    check(page.data('line') == before and 'number of a vertex' in page.browser.text('#error'), 'a coordinate is taken as a vertex')
    page.type('#place input', ', '.join(map(str, page.points[40])))
    check(page.data('line').split()[-1] == '40', f'no point at the coordinates of vertex 40: {page.data("line")}')
    page.browser.evaluate('document.activeElement.blur()')
    page.key('Escape')
    page.key('a')
    check(page.rows('points') == 5, 'the key does not add a point')
    page.compare_with_program()


def check_kinds(page):
    """Every kind of curve, with its options."""
    page.button('#clear')
    for spot in (SPOTS[0], SPOTS[2], SPOTS[3]):
        page.click(*spot)
    words = page.data('line').split()
    page.option('closed')
    check(page.data('line').split() == words + words[:1], 'the path is not closed')
    page.compare_with_program()
    page.option('snap')
    check(all(word.isdigit() for word in page.data('line').split()), f'points are not at vertices: {page.data("line")}')
    page.compare_with_program()
    page.button('#undo')
    page.tool('loop')
    check(page.data('line').split() == ['o', *words], f'the loop is not closed: {page.data("line")}')
    page.compare_with_program()
    page.check_certificate()
    page.option('closed')
    check(page.data('line').split() == words, f'the loop is not opened: {page.data("line")}')
    page.compare_with_program()
    page.tool('spline')
    page.compare_with_program()
    page.check_certificate()
    bezier = page.lengths()
    page.option('bspline')
    page.compare_with_program()
    check(page.lengths() != bezier, 'a B-spline is a Bezier curve')
    page.key('c')
    check(page.data('line').split()[0] == 'o', f'the spline is not closed: {page.data("line")}')
    page.compare_with_program()
    page.tool('shortest')
    page.compare_with_program()
    page.browser.press('ArrowRight')
    page.settle()
    check(page.browser.evaluate("document.querySelector('[data-tool=classes]').checked"), 'an arrow key does not choose a kind')
    page.type('[data-option=count]', '4')
    page.compare_with_program()
    check(len(page.lengths()) == 4 and sorted(page.lengths()) == page.lengths(), f'classes: {page.lengths()}')
    page.tool('trace')
    page.type('[data-option=angle]', '40')
    page.type('[data-option=length]', '1.5')
    page.compare_with_program()
    check(abs(page.lengths()[0] - 1.5) < 1e-9, f'a trace of length {page.lengths()}')
    page.tool('distances')
    page.type('[data-option=spacing]', '0.3')
    page.compare_with_program(1e-9)
    levels = [float(text) for text in page.browser.texts('#members li')]
    check(len(levels) >= 2 and levels == sorted(levels) and all(abs(v / 0.3 - round(v / 0.3)) < 1e-9 for v in levels), f'levels: {levels}')
    page.type('#unit', 'mm')
    check(page.browser.texts('#members li')[0] == '0.3 mm', f'no unit: {page.browser.texts("#members li")}')
    page.browser.wait_for("document.getElementById('scale').textContent.endsWith(' mm')")
    page.type('#unit', '')
    count = len(page.lengths())
    page.option('tree')
    check(len(page.lengths()) == count + len(page.points) - 1, 'the tree does not reach all vertices')
    page.option('tree')
    page.tool('path')
    check(page.data('line').split() == words, 'the points have moved')


def check_units(page):
    """Lengths and coordinates are shown and typed in the unit of the user. The commands are in that of the mesh."""
    def length(selector):
        value, name = page.browser.text(selector).split()
        check(name == 'cm', f'{selector} is in {name}')
        return float(value)

    def is_multiple(shown, lengths):
        return len(shown) == len(lengths) > 0 and all(abs(a - 2.5 * b) < 1e-6 * a for a, b in zip(shown, lengths))

    page.type('#unit', 'cm')
    page.type('#factor', '2.5')
    page.compare_with_program()
    check(is_multiple([length('#length')], page.lengths()), f'{page.browser.text("#length")} instead of 2.5 times {page.lengths()}')
    page.tool('classes')
    page.compare_with_program()
    shown = [float(text.split()[0]) for text in page.browser.texts('#members li')]
    check(is_multiple(shown, page.lengths()), f'{shown} instead of 2.5 times {page.lengths()}')
    bound = page.browser.text('#note').split('at least ')[1].split()
    check(float(bound[0]) >= shown[-1] * (1 - 1e-5) and bound[1] == 'cm', f'the paths are of lengths {shown}, others at least {bound}')
    page.tool('trace')
    page.type('[data-option=length]', '3')
    check(page.browser.text('#command').endswith(',1.2'), f'not of length 3 / 2.5: {page.browser.text("#command")}')
    page.compare_with_program()
    check(length('#length') == 3, f'a trace of length {page.browser.text("#length")}')
    page.tool('distances')
    page.type('[data-option=spacing]', '0.7')
    check(page.browser.text('#command').endswith('--spacing 0.28'), f'not 0.7 / 2.5: {page.browser.text("#command")}')
    page.compare_with_program(1e-9)
    check(page.browser.text('#members li') == '0.7 cm', f'the first isoline is at {page.browser.text("#members li")}')
    page.browser.evaluate(FRAMES)
    check(page.browser.text('#scale').count(' cm') == 2, f'the scale is {page.browser.text("#scale")}')
    page.tool('path')
    page.type('#place input', ' '.join(str(2.5 * x) for x in page.points[40]))
    check(page.data('line').split()[-1] == '40', f'no point at the coordinates of vertex 40: {page.data("line")}')
    page.button('#undo')
    for wrong in ('0', '-1', ''):
        page.type('#factor', wrong)
        check('positive' in page.browser.text('#error'), f'a factor {wrong}: {page.browser.text("#error")}')
        check(page.browser.evaluate("document.getElementById('factor').value") == '2.5', f'the factor {wrong} is kept')
    page.type('#factor', '1')
    page.type('#unit', '')


def check_direction(page):
    """A trace turns towards the pointer that is dragged from its start, and by keys; each drag is undone at once."""
    def parts():
        source, angle, length = page.data('line').split(',')
        return source, math.degrees(float(angle)), length

    page.button('#clear')
    page.tool('trace')
    page.type('[data-option=length]', '0.9')
    page.browser.evaluate('document.activeElement.blur()')
    page.click(*SPOTS[0])
    first = parts()
    start = page.place_of(int(first[0]), *SPOTS[0])
    end = (start[0] - 0.06, start[1] + 0.2)
    target = page.under(*page.on_view(*end))
    page.drag(start, end)
    dragged = parts()
    check((dragged[0], dragged[2]) == (first[0], first[2]), f'a drag changes {first} to {dragged}')
    shown = page.browser.evaluate("document.querySelector('[data-option=angle]').valueAsNumber")
    check(abs(shown - dragged[1]) < 1e-5, f'a direction of {dragged[1]} degrees is shown as {shown}')
    trace = page.browser.text('#command').split()[-1]
    subprocess.run([page.options.program, 'trace', page.options.mesh, '--quiet', '--trace', trace, '--mesh', page.folder / 'trace.polylines.txt'],
                   check=True)
    (line,) = read_polylines_txt(page.folder / 'trace.polylines.txt')
    check(distance_to(target, line) < 1e-4, f'the trace does not pass {target}')
    page.key('z', CTRL)
    check(parts() == first, f'a drag is not undone at once: {parts()}')
    page.key('z', CTRL | SHIFT)
    check(parts() == dragged, 'the drag is not redone')
    for keys, turned in (((('ArrowLeft', 0),), 1), ((('ArrowRight', 0),) * 3, -2), ((('ArrowLeft', SHIFT),), 8), ((('ArrowRight', SHIFT),), -2)):
        for key in keys:
            page.key(*key)
        check(abs(parts()[1] - dragged[1] - turned) < 1e-9 and parts()[0] == first[0], f'turned from {dragged} to {parts()} by {keys}')
    page.compare_with_program()
    page.key('ArrowUp')
    check(abs(parts()[1] - dragged[1] + 2) < 1e-9 and parts()[0] == first[0], 'an arrow key moves the trace')
    page.key('z', CTRL)
    check(parts() == dragged, f'the keys are not undone together: {parts()}')
    page.browser.call('Emulation.setTouchEmulationEnabled', enabled=True)
    (x, y), (u, v) = page.on_view(*start), page.on_view(start[0] + 0.02, start[1] - 0.1)
    before = page.data('line')
    page.browser.swipe([(x + t * (u - x), y + t * (v - y)) for t in (0, 0.5, 1)])
    page.browser.wait_for(f'document.documentElement.dataset.line !== {json.dumps(before)}')
    page.settle()
    page.browser.call('Emulation.setTouchEmulationEnabled', enabled=False)
    check(parts()[0] == first[0] and parts()[1] != dragged[1], f'a touch turns {dragged} to {parts()}')
    page.compare_with_program()
    page.click(*SPOTS[2])
    check(parts()[0] != first[0], 'a click does not move the start')
    page.compare_with_program()


def distance_to(p, line):
    """The distance of a point from a polyline."""
    def to_segment(a, b):
        ab, ap = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, p)]
        square = sum(x * x for x in ab)
        t = min(1, max(0, sum(x * y for x, y in zip(ab, ap)) / square)) if square > 0 else 0
        return math.dist(p, [x + t * y for x, y in zip(a, ab)])
    return min(map(to_segment, line, line[1:]))


def check_colors(page):
    """The surface is darkest where the distance is least, by the map that is chosen, and the legend has the greatest."""
    page.tool('distances')
    page.type('[data-option=spacing]', '100')  # so that no line is drawn
    source = page.data('line').split('|')[0]
    subprocess.run([page.options.program, 'distance', page.options.mesh, '--quiet', '--source', source, '--map', page.folder / 'map.csv'],
                   check=True)
    with open(page.folder / 'map.csv', encoding='ascii') as file:
        distances = [float(row['distance']) for row in csv.DictReader(file)]
    farthest = max(distances)
    check(abs(float(page.data('farthest')) - farthest) < 1e-6 * farthest, f'{page.data("farthest")} instead of {farthest}')
    page.browser.evaluate(FRAMES)
    check(abs(float(page.browser.text('#scale').split()[-1]) - farthest) < 1e-3 * farthest, page.browser.text('#scale'))
    spots = []
    for x, y in ((a / 8, b / 8) for a in range(1, 8) for b in range(1, 8)):
        if page.under(*page.on_view(x, y)):
            spots.append((distances[int(page.browser.text('#under').split()[-1])], x, y))
    spots.sort()
    check(len(spots) > 12, f'the surface is under {len(spots)} places only')

    def colors():
        page.browser.evaluate(FRAMES)
        return page.browser.evaluate(f"""(async () => {{
            const image = new Image();
            image.src = {IMAGE};
            await image.decode();
            const canvas = new OffscreenCanvas(image.width, image.height);
            const context = canvas.getContext('2d');
            context.drawImage(image, 0, 0);
            return {json.dumps([spot[1:] for spot in spots])}.map(([x, y]) =>
                Array.from(context.getImageData(x * image.width, y * image.height, 1, 1).data));
        }})()""")

    seen = {}
    page.browser.evaluate("document.getElementById('colors').focus()")
    for name in ('violet', 'blue', 'gray', ''):
        check(page.browser.evaluate("document.getElementById('colors').value") == name, f'the colors are not {name}')
        seen[name] = colors()
        lightness = [0.2 * r + 0.7 * g + 0.1 * b for r, g, b, _ in seen[name]]
        third = len(spots) // 3
        growth = sum(lightness[-third:]) / third - sum(lightness[:third]) / third
        check(growth > 20 if name else abs(growth) < 20, f'{name}: lighter by {growth}')
        page.browser.press('ArrowDown')
    check(len({str(s) for s in seen.values()}) == 4, 'two maps have the same colors')
    check(all(max(c[:3]) - min(c[:3]) <= 3 for c in seen['gray']), 'the grays are colored')
    check('colors' not in page.browser.text('#scale'), 'the legend shows colors that are not there')
    page.browser.press('ArrowUp')
    check(colors() == seen['gray'], 'the colors are not shown again')
    page.browser.evaluate("document.activeElement.blur()")
    page.tool('path')
    check(colors() != seen['gray'], 'the colors of distances are shown without distances')
    page.click(*SPOTS[0])
    page.compare_with_program()


def check_several(page):
    """A second curve has a name, a color and a result of its own; both are saved; a curve is removed."""
    page.browser.evaluate('document.activeElement.blur()')
    page.key('n')
    page.click(0.3, 0.4)
    page.click(0.6, 0.25)
    page.compare_with_program()
    page.type('#curves li:nth-child(2) .name', 'second')
    check(page.rows('curves') == 2, f'{page.rows("curves")} curves')
    page.key('e')
    page.compare_with_program()
    page.button('#show-intrinsic')
    lengths = [float(text) for text in page.browser.texts('#curves .length')]
    check(len(lengths) == 2 and abs(lengths[1] - page.lengths()[0]) < 1e-7, f'lengths: {lengths}, {page.lengths()}')
    check(all('proven' in text for text in page.browser.texts('#curves .numbers')), page.browser.texts('#curves .numbers'))
    colors = page.browser.evaluate("Array.from(document.querySelectorAll('#curves .color'), (e) => e.value)")
    check(len(set(colors)) == 2, f'colors: {colors}')
    check_saved(page)
    page.button('#curves li:nth-child(1) .choose')
    check(abs(page.lengths()[0] - lengths[0]) < 1e-7, 'the first curve is not chosen')
    page.compare_with_program()
    page.button('#curves li:nth-child(2) .remove')
    check(page.rows('curves') == 1, 'the curve is not removed')
    page.key('z', CTRL)
    check(page.rows('curves') == 2, 'the removal is not undone')
    name = page.browser.evaluate("document.querySelector('#curves li:nth-child(2) .name').value")
    check(name == 'second', f'the curve is called {name}')


def check_saved(page):
    """Files hold what the program computes, up to rounding: the mesh, and tubes along the curves. The image is the view."""
    points = page.save('points').decode()
    check(len(points.splitlines()) == 2 and points.splitlines()[1] == page.data('line'), f'saved points: {points}')
    (page.folder / 'both.txt').write_text(points)
    for kind, read in {'obj': read_obj, 'ply': read_ply, 'glb': read_glb}.items():
        own, found = page.folder / f'curves.{kind}', page.folder / f'saved.{kind}'
        subprocess.run([page.options.program, 'path', page.options.mesh, '--quiet', '--points', page.folder / 'both.txt', '--mesh', own],
                       check=True)
        found.write_bytes(page.save(kind))
        vertices, faces, curves = read(own)
        compare(found, *read(found), (vertices, faces), curves, 1e-5 if kind == 'glb' else 1e-9)  # a GLB has floats
    (page.folder / 'saved.polylines.txt').write_bytes(page.save('polylines.txt'))
    check(len(read_polylines_txt(page.folder / 'saved.polylines.txt')) == 2, 'not two polylines')
    image = page.save('png')
    width, height = struct.unpack('>2I', image[16:24])
    check((image[:8], height) == (b'\x89PNG\r\n\x1a\n', SIZE[1]) and width > SIZE[0] / 2, f'an image of {width} x {height}')


def check_view(page):
    """The coordinates under the pointer and the nearest vertex are shown. After a resize the mesh is in the middle."""
    found = page.under(*page.on_view(0.3, 0.55))
    vertex = int(page.browser.text('#under').split()[-1])
    points, faces = read_off(page.options.mesh)
    longest = max(math.dist(points[f[i]], points[f[i - 1]]) for f in faces for i in range(3))
    check(math.dist(points[vertex], found) < longest, f'vertex {vertex} is not at {found}')
    page.browser.resize(1900, 700)
    page.browser.evaluate(FRAMES)
    resized = page.browser.evaluate(IMAGE)
    page.key('r')
    page.browser.evaluate(FRAMES)
    check(page.browser.evaluate(IMAGE) == resized, 'the mesh is not in the middle after a resize')
    page.key('ArrowLeft')
    page.browser.evaluate(FRAMES)
    check(page.browser.evaluate(IMAGE) != resized, 'an arrow key does not turn the view')
    page.browser.resize(*SIZE)
    page.key('r')
    page.browser.evaluate(FRAMES)


def check_cancel(page):
    """Thousands of isolines are canceled, by key and by button, and the next curve is computed."""
    before = page.data('line')
    page.tool('distances')
    for cancel in (lambda: page.browser.press('Escape'), lambda: page.browser.click(*page.browser.middle_of('#cancel'))):
        page.browser.type('[data-option=spacing]', '0.0005')
        page.browser.wait_for("!document.getElementById('busy').hidden")
        check(page.data('isIdle') == 'false', 'the page does not compute')
        cancel()
        page.settle()
        check(page.browser.text('#error') == 'canceled', f'not canceled: {page.browser.text("#error")}')
        page.type('[data-option=spacing]', '0.5')
        page.compare_with_program(1e-9)
    page.tool('path')
    check(page.data('line') == before, 'the points have changed')
    page.compare_with_program()


def check_opening(page):
    """A bad file changes nothing. Meshes are repaired, with a report. What was opened before leaves nothing behind."""
    before = page.data('line')
    page.open('bad.off', 'OFF nothing')
    check(page.browser.text('#error').startswith('bad.off'), f'a bad file: {page.browser.text("#error")}')
    check((page.browser.text('#title'), page.data('line')) == (page.options.mesh.name, before), 'a bad file replaces the mesh')
    for name, text, facts, changes in (('quad.obj', QUAD, '4 vertices, 2 triangles', 1), ('pieces.off', PIECES, '5 vertices, 2 triangles', 2)):
        page.open(name, text)
        check((page.browser.text('#title'), page.browser.text('#facts')) == (name, facts), f'{name}: {page.browser.text("#facts")}')
        report = page.browser.texts('#remarks li')
        check('repaired' in page.browser.text('#remarks summary') and len(report) >= changes, f'{name}: {report}')
    check(any('polygon' in line or 'face' in line for line in report), f'the repair is not reported: {report}')
    for i in range(4):
        page.open(f'triangle{i}.off', TRIANGLE)
        check(page.browser.text('#facts') == '3 vertices, 1 triangle', page.browser.text('#facts'))
    check(not page.browser.evaluate("document.getElementById('remarks').checkVisibility()"), 'an old report is shown')
    counted = page.browser.evaluate('Object.fromEntries(Object.entries(counted).map(([name, set]) => [name, set.size]))')
    check(counted['contexts'] <= 2 and counted['workers'] == 1 and counted['observers'] == 1, f'left behind: {counted}')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--program', type=Path, required=True)
    parser.add_argument('--mesh', type=Path, required=True)
    parser.add_argument('--chromium', required=True)
    options = parser.parse_args()
    options.program, options.mesh = options.program.resolve(), options.mesh.resolve()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        page = Live_page(options, Path(folder))
        try:
            for part in (check_points, check_kinds, check_units, check_direction, check_colors, check_several, check_view, check_cancel, check_opening):
                part(page)
        finally:
            page.browser.close()
        check(not page.browser.failures, json.dumps(page.browser.failures))
        print(f'{page.compared} results of the page have the lengths that the program computes')


if __name__ == '__main__':
    sys.exit(main())
