# SPDX-License-Identifier: LGPL-3.0-or-later
"""What the figures are made with: the programs and meshes, readers of their files, and paths of edges."""

import heapq
import math
import re
import struct
import subprocess
import sys
from pathlib import Path

from read_page import Page


class Tools:
    """The programs, the meshes, and a folder for what is in between."""

    def __init__(self, build, folder):
        self.build = build
        self.data = build / 'data'
        self.folder = Path(folder)

    def run(self, program, *arguments):
        """Runs a program in the folder; examples that run.sh does not build are built first."""
        kind = 'Flip_geodesics' if program.endswith('_example') else 'Flip_geodesics_program'
        path = self.build / 'examples' / kind / program
        if not path.exists():
            subprocess.run(['cmake', '--build', self.build, '--target', program], check=True)
        subprocess.run([path, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL, cwd=self.folder)

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

    def logarithms(self, mesh, source):
        """The places of the vertices in the tangent plane of a point, by their shortest paths."""
        path = self.folder / 'map.csv'
        self.run('flip_geodesics', 'log', mesh, '--source', source, '--shortest', '--quiet', '--map', path)
        return [tuple(map(float, row.split(',')[3:])) for row in path.read_text().splitlines()[1:]]

    def curves(self, command, mesh, *arguments):
        """The page that the program writes of some curves."""
        page = self.folder / 'page.html'
        self.run('flip_geodesics', command, mesh, *arguments, '--quiet', '--page', page)
        return Page(page)


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
    """The lines of an OBJ file by their first word: numbers, of which those of faces and lines count from 0. Below 'ft'
    is what the corners of each face have as texture coordinates, if they have any."""
    result = {'v': [], 'vt': [], 'f': [], 'ft': [], 'l': []}
    for line in path.read_text().splitlines():
        word, *rest = line.split()
        if word in ('v', 'vt'):
            result[word].append(tuple(map(float, rest)))
        elif word in ('f', 'l'):
            result[word].append(tuple(int(x.split('/')[0]) - 1 for x in rest))
        if word == 'f':
            result['ft'].append(tuple(int(x.split('/')[1]) - 1 for x in rest if '/' in x))
    return result


def read_off(path):
    """The points and faces of an OFF file in text."""
    numbers = iter(' '.join(line.split('#')[0] for line in path.read_text().splitlines()).split()[1:])
    points, faces = int(next(numbers)), int(next(numbers))
    next(numbers)
    return ([tuple(float(next(numbers)) for _ in range(3)) for _ in range(points)],
            [tuple(int(next(numbers)) for _ in range(int(next(numbers)))) for _ in range(faces)])


def read_vtp(path):
    """The polylines of a VTP file, as the library writes them: all numbers at the end, in eight bytes each."""
    head, data = path.read_bytes().split(b'<AppendedData encoding="raw">\n_', 1)
    section, arrays = '', {}
    for line in head.decode().splitlines():
        section = line.strip('<>') if line.startswith('<') and not line.startswith(('</', '<DataArray')) else section
        offset = re.search(r'offset="(\d+)"', line)
        if offset:
            start = int(offset[1])
            size, = struct.unpack_from('<Q', data, start)
            kind = 'd' if 'Float64' in line else 'q'
            name = re.search(r'Name="(\w+)"', line)
            arrays[section, name[1] if name else ''] = struct.unpack_from(f'<{size // 8}{kind}', data, start + 8)
    numbers = arrays['Points', '']
    points = list(zip(numbers[0::3], numbers[1::3], numbers[2::3]))
    corners = [points[i] for i in arrays['Lines', 'connectivity']]
    ends = arrays['Lines', 'offsets']
    return [corners[start:end] for start, end in zip((0, *ends), ends)]


class Graph:
    """Shortest paths of edges, to make loops and networks from."""

    def __init__(self, points, faces):
        self.points, self.faces = points, faces
        self.neighbors = [set() for _ in points]
        for f in faces:
            for i in range(3):
                self.neighbors[f[i]].update((f[i - 1], f[(i + 1) % 3]))

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
            for w in self.neighbors[v]:
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

    def regions(self, seeds):
        """For each vertex the number of the seed that is closest along edges."""
        label, queue = {}, [(0.0, seed, i) for i, seed in enumerate(seeds)]
        while queue:
            d, v, i = heapq.heappop(queue)
            if v in label:
                continue
            label[v] = i
            for w in self.neighbors[v]:
                if w not in label:
                    heapq.heappush(queue, (d + math.dist(self.points[v], self.points[w]), w, i))
        return label

    def components(self):
        """The vertices of each connected part."""
        left, parts = set(range(len(self.points))), []
        while left:
            part, found = [], [left.pop()]
            while found:
                v = found.pop()
                part.append(v)
                found += self.neighbors[v] & left
                left -= self.neighbors[v]
            parts.append(part)
        return parts
