#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads back what flip_geodesics writes for viewers, without any code of the program, and compares it with the mesh,
the points of --polylines and the lengths of --stats.

    check_viewer_files.py --program flip_geodesics --mesh FILE.off [--chromium BROWSER] -- COMMAND OPTIONS
"""

import argparse
import csv
import json
import math
import re
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / 'examples/Flip_geodesics_program/page'))
from read_page import Page  # noqa: E402


def check(condition, message):
    if not condition:
        raise SystemExit(f'check_viewer_files: {message}')


def read_off(path):
    words = iter(path.read_text().split())
    check(next(words) == 'OFF', f'{path} is not an OFF file')
    vertices, faces, _ = (int(next(words)) for _ in range(3))
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(vertices)]
    return points, [tuple(int(next(words)) for _ in range(int(next(words)))) for _ in range(faces)]


def read_polylines(path):
    curves = {}
    for line in path.read_text().splitlines():
        words = line.split()
        curves.setdefault(int(words[0]), []).append(tuple(map(float, words[-3:])))
    return curves


def read_obj(path):
    points, faces, curves, curve = [], [], {}, None
    for line in path.read_text().splitlines():
        word, *rest = line.split()
        if word == 'v':
            points.append(tuple(map(float, rest)))
        elif word == 'f':
            faces.append(tuple(int(i) - 1 for i in rest))
        elif word == 'o' and rest[0].startswith('curve_'):
            curve = int(rest[0][len('curve_'):])
        elif word == 'l':
            curves[curve] = [int(i) - 1 for i in rest]
    return points, faces, {c: [points[i] for i in line] for c, line in curves.items()}


def read_ply(path):
    lines = iter(path.read_text().splitlines())
    counts = {}
    for line in lines:
        words = line.split()
        if words[0] == 'element':
            counts[words[1]] = int(words[2])
        if words[0] == 'end_header':
            break
    points = [tuple(map(float, next(lines).split()[:3])) for _ in range(counts['vertex'])]  # without their colors
    faces = [tuple(map(int, next(lines).split()[1:4])) for _ in range(counts['face'])]  # without their curves
    curves = {}
    for _ in range(counts['edge']):
        a, b, curve, *_ = map(int, next(lines).split())
        line = curves.setdefault(curve, [a])
        check(line[-1] == a, f'{path}: the edges of curve {curve} are no chain')
        line.append(b)
    check(next(lines, None) is None, f'{path}: there is more in it than the header says')
    return points, faces, {c: [points[i] for i in line] for c, line in curves.items()}


def read_vtp(path):
    piece = xml.etree.ElementTree.parse(path).getroot().find('PolyData/Piece')
    numbers = [float(x) for x in piece.find('Points/DataArray').text.split()]
    points = list(zip(numbers[0::3], numbers[1::3], numbers[2::3]))
    check(len(points) == int(piece.get('NumberOfPoints')), f'{path}: another number of points than announced')

    def cells(kind):
        arrays = {a.get('Name'): [int(x) for x in a.text.split()] for a in piece.find(kind)}
        starts = [0] + arrays['offsets']
        check(len(arrays['offsets']) == int(piece.get(f'NumberOf{kind}')), f'{path}: another number of {kind}')
        check(starts[-1] == len(arrays['connectivity']), f'{path}: the offsets of {kind} do not end at their end')
        return [tuple(arrays['connectivity'][a:b]) for a, b in zip(starts, starts[1:])]

    lines, faces = cells('Lines'), cells('Polys')
    numbers = [int(x) for x in piece.find('CellData/DataArray').text.split()]
    check(numbers[len(lines):] == [-1] * len(faces), f'{path}: faces belong to curve -1')
    return points, faces, {c: [points[i] for i in line] for c, line in zip(numbers, lines)}


def read_polylines_txt(path):
    lines = []
    for line in path.read_text().splitlines():
        count, *rest = line.split()
        numbers = [float(x) for x in rest]
        check(len(numbers) == 3 * int(count), f'{path}: a line has another number of points than it says')
        lines.append(list(zip(numbers[0::3], numbers[1::3], numbers[2::3])))
    return lines


def read_glb(path):
    data = path.read_bytes()
    magic, version, total = struct.unpack('<4sII', data[:12])
    check((magic, version, total) == (b'glTF', 2, len(data)), f'{path}: not a header of glTF 2')
    chunks, at = [], 12
    while at < len(data):
        size, kind = struct.unpack('<I4s', data[at:at + 8])
        check(size % 4 == 0 and at + 8 + size <= len(data), f'{path}: a chunk of {size} bytes')
        chunks.append((kind, data[at + 8:at + 8 + size]))
        at += 8 + size
    check([kind for kind, _ in chunks] == [b'JSON', b'BIN\0'], f'{path}: not one JSON and one BIN chunk')
    scene, binary = json.loads(chunks[0][1]), chunks[1][1]
    (root,) = scene['scenes'][scene['scene']]['nodes']
    move = scene['nodes'][root]['translation']

    def values(index):
        accessor = scene['accessors'][index]
        view = scene['bufferViews'][accessor['bufferView']]
        width = {'SCALAR': 1, 'VEC3': 3}[accessor['type']]
        check(view['byteLength'] == 4 * width * accessor['count'], f'{path}: accessor {index} does not fill its view')
        check(view['byteOffset'] + view['byteLength'] <= scene['buffers'][0]['byteLength'] <= len(binary),
              f'{path}: view of accessor {index} is outside the buffer')
        code = {5126: 'f', 5125: 'I'}[accessor['componentType']]
        numbers = struct.unpack_from(f'<{width * accessor["count"]}{code}', binary, view['byteOffset'])
        if width == 1:
            return numbers
        for i in range(3):
            check((min(numbers[i::3]), max(numbers[i::3])) == (accessor['min'][i], accessor['max'][i]),
                  f'{path}: the bounds of accessor {index} are not those of its points')
        return [tuple(x + m for x, m in zip(numbers[k:k + 3], move)) for k in range(0, len(numbers), 3)]

    points, faces, curves = [], [], {}
    for i in scene['nodes'][root]['children']:
        node = scene['nodes'][i]
        (primitive,) = scene['meshes'][node['mesh']]['primitives']
        positions = values(primitive['attributes']['POSITION'])
        if primitive['mode'] == 4:  # the surface, or a tube
            corners = [i + len(points) for i in values(primitive['indices'])]
            points = points + positions
            faces += [tuple(corners[k:k + 3]) for k in range(0, len(corners), 3)]
        else:
            check(primitive['mode'] == 3, f'{path}: {node["name"]} has mode {primitive["mode"]}')
            curves[int(node['name'][len('curve_'):])] = positions
    return points, faces, curves


def check_page(path):
    page = Page(path)
    check(not re.search(r'<(script|link|img|iframe)[^>]*\b(src|href)=', page.text), f'{path}: loads another file')
    check('three.js' in page.text[:2000] and 'MIT License' in page.text[:2000], f'{path}: the library has no licence')
    return page


def replay(page, number, statistics):
    """Takes the steps of a run, from the path of edges to the finished curves. Returns how many there are."""
    run = page.runs[number]
    sides = {tuple(sorted((f[i], f[(i + 1) % 3]))) for f in page.faces for i in range(3)}
    for edge, a, b in run.input_edges:
        check(tuple(sorted((a, b))) in sides, f'{a} and {b} share no edge of the mesh')
        check(edge is None or run.polylines[edge] == [page.points[a], page.points[b]], f'edge {edge} lies elsewhere')
    members = [c for c in page.scene['curves'] if c['run'] == number]
    check(len(run.start) == len(members), f'run {number} has {len(run.start)} curves')
    tolerance = 1e-5 * page.scene['radius']
    before = None
    for state in run.states():
        lines = state.lines
        total = sum(map(length, lines))
        if before is None:
            for curve, line in zip(members, lines):
                check(abs(length(line) - float(statistics[curve['number']]['initial_length'])) < tolerance,
                      f'curve {curve["number"]} does not start as its edge path')
        else:
            check(total <= before + tolerance, f'step {state.step} makes a curve longer')
        before = total
    for curve, line in zip(members, lines):
        compare_lines('the last step', line, page.curves.get(curve['number'], []), tolerance)
    if len(members) > 1:  # one curve by itself is recorded in a second run, by flips alone
        check(state.flips <= int(statistics[members[0]['number']]['flips']), 'more flips than there were')
    return state.step


def length(points):
    return sum(math.dist(p, q) for p, q in zip(points, points[1:]))


def compare_lines(path, found, expected, tolerance):
    check(len(found) == len(expected), f'{path}: {len(found)} points instead of {len(expected)}')
    for p, q in zip(found, expected):
        check(math.dist(p, q) <= tolerance, f'{path}: a point at {p} instead of {q}')


def compare(path, points, faces, curves, mesh, expected, tolerance):
    compare_lines(path, points[:len(mesh[0])], mesh[0], tolerance)
    check(faces == mesh[1], f'{path}: other faces than the mesh')
    check(sorted(curves) == sorted(expected), f'{path}: curves {sorted(curves)} instead of {sorted(expected)}')
    for curve, line in expected.items():
        compare_lines(path, curves[curve], line, tolerance)


def distance_to_piece(p, a, b):
    along = [y - x for x, y in zip(a, b)]
    squared = sum(x * x for x in along)
    t = min(max(sum((x - y) * z for x, y, z in zip(p, a, along)) / squared, 0), 1) if squared > 0 else 0
    return math.dist(p, [x + t * z for x, z in zip(a, along)])


def check_tubes(points, faces, curves, mesh, expected):
    """Curves are tubes of a five-hundredth of the mesh's size, closed, about the lines that they were."""
    radius = 0.002 * math.dist(*([extreme(p[i] for p in mesh[0]) for i in range(3)] for extreme in (min, max)))
    compare_lines('tubes', points[:len(mesh[0])], mesh[0], 0)
    check(faces[:len(mesh[1])] == mesh[1], 'tubes: other faces than the mesh')
    tubes = faces[len(mesh[1]):]
    thick = [line for line in expected.values() if length(line) > 0]
    check(bool(tubes) == bool(thick) and all(length(line) == 0 for line in curves.values()), 'curves are no tubes')
    sides = {(f[i - 1], f[i]) for f in tubes for i in range(3)}
    check(len(sides) == 3 * len(tubes) and all((b, a) in sides for a, b in sides), 'tubes are not closed')
    used = sorted({i for f in tubes for i in f})
    corners = [points[i] for i in used[::len(used) // 100 + 1]]  # some of very many
    all_pieces = [piece for line in thick for piece in zip(line, line[1:])]
    far = [min(distance_to_piece(p, *piece) for piece in all_pieces) for p in corners]
    check(not far or 0.9 * radius < max(far) < 1.5 * radius, f'corners of tubes are {max(far, default=0)} off')


def load_in_browser(browser, address):
    """The data that the page leaves at its root element. On a busy machine the browser's time can run out before the page
    has started; then it is loaded again."""
    data = {}
    for _ in range(5):
        with tempfile.TemporaryDirectory() as profile:
            command = [browser, '--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
                       '--no-first-run', '--disable-background-networking', '--disable-component-update',
                       '--disable-sync', f'--user-data-dir={profile}', '--virtual-time-budget=20000', '--dump-dom',
                       address]
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=120, check=False)
        element = re.search(r'<html[^>]*>', done.stdout.decode())
        check(element is not None, f'{browser} did not load the page')
        data = dict(re.findall(r'data-([a-z-]+)="([^"]*)"', element.group()))
        if 'state' in data:
            break
    check(data.get('state') == 'ready', f'the page in the browser: {data}')
    return data


def pieces(lines):
    return str(sum(len(line) - 1 for line in lines))


def run_in_browser(browser, path, page):
    """Loads the page as it is, and with the first run in the middle of its steps."""
    address = path.resolve().as_uri()
    data = load_in_browser(browser, address)
    check(data['curve-pieces'] == pieces(page.curves.values()), f'the browser draws other curves: {data}')
    if not page.runs[0].edges:
        return
    state = page.runs[0].state(len(page.runs[0].steps) // 2)
    data = load_in_browser(browser, f'{address}#step={state.step}&edges=1&theme=dark')
    others = [page.curves[c['number']] for c in page.scene['curves'] if c['run'] != 0]
    starts = page.runs[0].state(0).lines if state.step > 0 else []
    expected = {'theme': 'dark', 'step': str(state.step), 'start-pieces': pieces(starts),
                'edge-pieces': pieces(state.edges), 'curve-pieces': pieces(state.lines + others)}
    for name, value in expected.items():
        check(data.get(name) == value, f'the browser shows {name} {data.get(name)}, not {value}')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--program', required=True)
    parser.add_argument('--mesh', required=True, type=Path)
    parser.add_argument('--chromium')
    parser.add_argument('arguments', nargs='+')
    options = parser.parse_args()
    command, *arguments = options.arguments
    mesh = read_off(options.mesh)
    readers = {'obj': read_obj, 'ply': read_ply, 'vtp': read_vtp, 'glb': read_glb}
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        for kind in [*readers, 'polylines.txt']:
            subprocess.run([options.program, command, options.mesh, *arguments, '--quiet',
                            '--polylines', folder / 'points', '--stats', folder / 'stats.csv',
                            '--page', folder / 'page.html', '--mesh', folder / f'viewer.{kind}',
                            *(['--tubes', '0'] if kind in readers else [])], check=True)
        expected = read_polylines(folder / 'points')
        with open(folder / 'stats.csv', encoding='ascii') as file:
            statistics = {int(row['curve']): row for row in csv.DictReader(file)}
        for curve, line in expected.items():
            check(abs(length(line) - float(statistics[curve]['length'])) <= 1e-9 * length(line),
                  f'curve {curve} has another length than its points')
        size = max(math.dist(p, mesh[0][0]) for p in mesh[0])
        for kind, read in readers.items():
            tolerance = 1e-6 * size if kind == 'glb' else 0
            compare(kind, *read(folder / f'viewer.{kind}'), mesh, expected, tolerance)
        for kind in ('obj', 'ply'):
            path = folder / f'tubes.{kind}'
            subprocess.run([options.program, command, options.mesh, *arguments, '--quiet', '--mesh', path,
                            '--page', folder / 'page.html'], check=True)  # without it, paths are straightened otherwise
            check_tubes(*readers[kind](path), mesh, expected)
        check(read_polylines_txt(folder / 'viewer.polylines.txt') == list(expected.values()),
              'the polylines of CGAL are not the curves')
        page = check_page(folder / 'page.html')
        compare('the page', page.points, page.faces, page.curves, mesh, expected, 1e-6 * size)
        for curve in page.scene['curves']:
            row = statistics[curve['number']]
            check((curve['status'], curve['length']) == (row['status'], float(row['length'])),
                  f'the page says something else of curve {curve["number"]} than the statistics')
        steps = [replay(page, i, statistics) for i, run in enumerate(page.runs) if run.edges]
        check(sum(steps) > 0 or {'--source', '--ways'} & set(arguments), 'the page has no steps')
        if options.chromium:
            run_in_browser(options.chromium, folder / 'page.html', page)
        print(f'{len(expected)} curves and {sum(steps)} steps read back from {len(readers) + 2} formats'
              + (' and a browser' if options.chromium else ''))


if __name__ == '__main__':
    sys.exit(main())
