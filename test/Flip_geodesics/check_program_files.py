#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks what flip_geodesics does to files and to who waits for it: inputs stay, results are whole or not there,
interruption and full disks are told.

    check_program_files.py --program flip_geodesics --torus generate_torus CASE
"""

import argparse
import csv
import math
import os
import re
import resource
import signal
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / 'examples/Flip_geodesics_program/page'))
from read_page import Page  # noqa: E402

PAIRS = '0 150\n3 77\n'
ENDLESS = ['--random', '500000', '--kernel', 'certified']  # for as long as a test may take


def check(condition, message):
    if not condition:
        raise SystemExit(f'check_program_files: {message}')


class Folder:
    """A folder with a mesh and files of curves, where the program runs."""

    def __init__(self, options, path):
        self.program, self.torus, self.path = options.program, options.torus, Path(path)
        self.processes = []
        self.make_torus('torus.off', 24, 12)
        (self.path / 'pairs.txt').write_text(PAIRS)

    def make_torus(self, name, around, along):
        subprocess.run([self.torus, self.path / name, str(around), str(along)], check=True, stdout=subprocess.DEVNULL)

    def names(self):
        return sorted(p.name for p in self.path.iterdir())

    def text(self, name):
        return (self.path / name).read_text()

    def start(self, *arguments, **how):
        how = {'stdout': subprocess.PIPE, 'stderr': subprocess.PIPE, **how}
        self.processes.append(subprocess.Popen([self.program, *arguments], cwd=self.path, text=True, **how))
        return self.processes[-1]

    def end(self):
        """Leaves nothing that runs, whatever a check has found."""
        for process in self.processes:
            process.kill()
            process.wait()

    def run(self, status, *arguments, **how):
        process = self.start(*arguments, **how)
        output, errors = process.communicate()
        check(process.returncode == status,
              f'{" ".join(arguments)}: exit status {process.returncode} instead of {status}\n{errors}')
        return output, errors

    def refuse(self, pattern, *arguments, **how):
        """Bad input is told in one line, and changes no file."""
        before = {name: self.path.joinpath(name).read_bytes() for name in self.names()}
        _, errors = self.run(2, *arguments, **how)
        check(re.fullmatch(r'flip_geodesics: [^\n]*\n', errors) and re.search(pattern, errors),
              f'{" ".join(arguments)}: {errors}')
        after = {name: self.path.joinpath(name).read_bytes() for name in self.names()}
        check(before == after, f'{" ".join(arguments)}: the files are others now')


def case_inputs(folder):
    """No result replaces what is read, whatever it is called."""
    pair = ['path', 'torus.off', '--from', '0', '--to', '150']
    os.symlink('torus.off', folder.path / 'soft.off')
    os.link(folder.path / 'torus.off', folder.path / 'hard.off')
    os.symlink(folder.path, folder.path.parent / (folder.path.name + '-link'))
    linked = folder.path.parent / (folder.path.name + '-link')
    try:
        for name in ['torus.off', './torus.off', str(folder.path / 'torus.off'), 'soft.off', 'hard.off',
                     str(linked / 'torus.off')]:
            for option in ['--insert', '--cut', '--stats', '--polylines', '--page']:
                if name != 'torus.off' and option not in ('--insert', '--stats'):
                    continue
                folder.refuse('this input file', *pair, option, name)
        folder.refuse('this input file', 'refine', *pair[1:], '--subdivision', 'torus.off')
    finally:
        linked.unlink()
    labels = ''.join(f'{i // 200}\n' for i in range(576))
    for command, option, content in [
            ('path', '--pairs', PAIRS), ('path', '--points', '0 150\n'), ('path', '--edges', '0 1 2\n'),
            ('loop', '--loop', '0 12 13\n'), ('network', '--network', '3 4 5\n'), ('spline', '--bezier', '0 15 40 65\n'),
            ('path', '--draw', '0 15 40\n'), ('cut', '--draw', '0 15 40\n'), ('network', '--segmentation', labels)]:
        (folder.path / 'curves.txt').write_text(content)
        folder.refuse('this input file', command, 'torus.off', option, 'curves.txt', '--polylines', './curves.txt')
        folder.run(0, command, 'torus.off', option, 'curves.txt', '--polylines', 'result.txt', '--quiet')
    folder.run(0, *pair, '--insert', 'elsewhere.off')
    folder.run(0, *pair, '--insert', 'torus.off', '--force')
    check(folder.text('torus.off') == folder.text('elsewhere.off'), 'with --force the mesh is not the result')
    check(folder.text('hard.off') != folder.text('torus.off'), 'a link that was not named has changed')


def case_results(folder):
    """Two results do not share a file, two runs do not mix theirs, and what is there stays as it is."""
    both = ['path', 'torus.off', '--random', '3']
    folder.refuse('two results', *both, '--stats', './same.txt', '--polylines', 'same.txt')
    (folder.path / 'below').mkdir()
    os.symlink('../nowhere.txt', folder.path / 'below/dangling.txt')
    _, errors = folder.run(2, *both, '--stats', 'below/dangling.txt', '--polylines', 'nowhere.txt')
    check('two results' in errors, errors)
    folder.run(0, *both, '--stats', 'below/dangling.txt', '--quiet')
    check((folder.path / 'below/dangling.txt').is_symlink() and (folder.path / 'nowhere.txt').is_file(),
          'a link has been replaced, not what it leads to')

    (folder.path / 'curves.txt.part').write_text('mine\n')
    (folder.path / 'curves.txt').write_text('earlier\n')
    os.chmod(folder.path / 'curves.txt', 0o640)
    folder.run(0, *both, '--polylines', 'curves.txt', '--quiet')
    check(folder.text('curves.txt.part') == 'mine\n', 'a file .part has been overwritten')
    check((folder.path / 'curves.txt').stat().st_mode & 0o777 == 0o640, 'the permissions are others')

    expected = []
    for seed in '12':
        folder.run(0, 'path', 'torus.off', '--random', '400', '--seed', seed, '--polylines', seed, '--quiet')
        expected.append(folder.text(seed))
    for _ in range(3):
        runs = [folder.start('path', 'torus.off', '--random', '400', '--seed', seed, '--polylines', 'both.txt', '--quiet')
                for seed in '12']
        check([run.wait() for run in runs] == [0, 0], 'two runs at once do not succeed')
        check(folder.text('both.txt') in expected, 'two runs have mixed their lines')
    check(not [n for n in folder.names() if n.endswith('.part') and n != 'curves.txt.part'], 'files are left over')


def without_times(table):
    """The rows of `--stats`, without the columns of seconds."""
    rows = list(csv.DictReader(table.splitlines()))
    return [{name: value for name, value in row.items() if not name.endswith('_s')} for row in rows]


def summary_without_times(output):
    """The table of curves without the column of milliseconds, and the lines below it without those of times."""
    lines = [line for line in output.splitlines() if not re.match(r'.*, read in |(search|shorten|extract) ', line)]
    return [re.sub(r'( [A-Z_]{4,}) +[0-9.]+ ', r'\1 ', line) for line in lines]


def case_page(folder):
    """A page shows a run and does not change its numbers, and it has the steps that lead to the curves."""
    (folder.path / 'points.txt').write_text('0 150\n0,1,0.25 100\n')
    (folder.path / 'corner.txt').write_text('0,1,0.25 13,14,26,0.3,0.3 100\n')
    (folder.path / 'bezier.txt').write_text('0,12,13,0.3,0.3 15 40,41,0.5 65\n')
    for curves, has_steps in ((['path', '--random', '8'], True), (['shortest', '--random', '8'], True),
                              (['path', '--points', 'points.txt'], True), (['path', '--points', 'corner.txt'], False),
                              (['spline', '--bezier', 'bezier.txt'], False)):
        curves.insert(1, 'torus.off')
        alone, _ = folder.run(0, *curves, '--stats', 'alone.csv', '--polylines', 'alone.txt')
        shown, _ = folder.run(0, *curves, '--stats', 'shown.csv', '--polylines', 'shown.txt', '--page',
                              'page.html')
        rows = without_times(folder.text('shown.csv'))
        check(rows and rows == without_times(folder.text('alone.csv')), f'{curves}: the page changes the statistics')
        check(folder.text('shown.txt') == folder.text('alone.txt'), f'{curves}: the page changes the curves')
        check(summary_without_times(shown) == summary_without_times(alone), f'{curves}: the page changes the summary')
        page = Page(folder.path / 'page.html')
        check(len(page.curves) == len(rows), f'{curves}: the page has {len(page.curves)} of {len(rows)} curves')
        check([curve['flips'] for curve in page.scene['curves']] == [int(row['flips']) for row in rows],
              f'{curves}: the page tells other numbers of flips')
        without = [number for number, run in enumerate(page.runs) if not any(flips for flips, *_ in run.steps)]
        check(page.runs and not (has_steps and without), f'{curves}: runs without flips: {without}')


def case_places(folder):
    """What is no plain file is written as it is."""
    folder.run(0, 'path', 'torus.off', '--random', '3', '--quiet', '--stats', 'stats.csv')
    lines = folder.text('stats.csv').count('\n')
    output, _ = folder.run(0, 'path', 'torus.off', '--random', '3', '--quiet', '--stats', '/dev/stdout')
    check(output.count('\n') == lines, 'standard output has not the lines of the file')
    folder.run(0, 'path', 'torus.off', '--random', '3', '--quiet', '--stats', '/dev/null', '--polylines', 'a.txt')
    os.mkfifo(folder.path / 'pipe')
    run = folder.start('path', 'torus.off', '--random', '3', '--quiet', '--stats', 'pipe')
    check(folder.text('pipe').count('\n') == lines and run.wait() == 0, 'the pipe has not the lines of the file')
    check((folder.path / 'pipe').is_fifo(), 'the pipe has become a file')
    (folder.path / 'folder').mkdir()
    _, errors = folder.run(2, 'path', 'torus.off', '--random', '3', '--stats', 'folder')
    check('folder: is a folder' in errors, errors)
    folder.run(0, 'path', 'torus.off', '--pairs', '/dev/stdin', '--polylines', '/dev/stdout', '--quiet',
               stdin=open(folder.path / 'pairs.txt', encoding='ascii'))


def case_standard_streams(folder):
    """`-` is standard input or output. What standard output holds stays, and a result there is not mixed with the table."""
    def torus():
        return open(folder.path / 'torus.off', encoding='ascii')

    pairs = ['--pairs', 'pairs.txt']
    folder.run(0, 'path', 'torus.off', *pairs, '--polylines', 'expected.txt', '--quiet')
    expected = folder.text('expected.txt')
    for name in ('-', '/dev/stdout', '/dev/fd/1'):
        output, errors = folder.run(0, 'path', '-', '--format', 'OFF', *pairs, '--polylines', name, stdin=torus())
        check(output == expected, f'{name} has not the polylines, or more than them:\n{output}')
        check('standard input: 288 vertices' in errors and 'LOCALLY_SHORTEST' in errors, f'no table:\n{errors}')
    output, _ = folder.run(0, 'path', 'torus.off', '--pairs', '-', '--polylines', '-', '--quiet',
                           stdin=open(folder.path / 'pairs.txt', encoding='ascii'))
    check(output == expected, 'pairs are not read from standard input')
    output, _ = folder.run(0, 'path', '-', '--format', 'off', *pairs, '--mesh', '-', '--output-format', 'ply', stdin=torus())
    check(output.startswith('ply\n'), 'standard output is not a PLY file')
    textured = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 5\nf 1/1 2/2 3/3\nf 1/1 3/5 4/4\n'
    (folder.path / 'textured').write_text(textured)
    folder.run(0, 'network', '-', '--format', 'obj', '--seams', stdin=open(folder.path / 'textured', encoding='ascii'))

    for mode, before in (('a', 'earlier\n'), ('w', '')):
        for name in ('-', '/dev/stdout', '/dev/fd/1'):
            (folder.path / 'log.txt').write_text('earlier\n')
            with open(folder.path / 'log.txt', mode, encoding='ascii') as log:
                folder.run(0, 'path', 'torus.off', *pairs, '--polylines', name, stdout=log)
            check(folder.text('log.txt') == before + expected, f'{name}, {mode}: {folder.text("log.txt")}')
    (folder.path / 'log.txt').write_text('earlier\n')
    with open(folder.path / 'log.txt', 'a', encoding='ascii') as log:
        folder.run(0, 'path', 'torus.off', *pairs, '--polylines', f'/dev/fd/{log.fileno()}', pass_fds=[log.fileno()])
    check(folder.text('log.txt') == 'earlier\n' + expected, f'another open file: {folder.text("log.txt")}')

    folder.refuse('standard input can be read only once', 'path', '-', '--format', 'off', '--pairs', '-')
    folder.refuse('two results', 'path', 'torus.off', *pairs, '--polylines', '-', '--stats', '/dev/stdout')
    folder.refuse('use --format with one of', 'path', '-', *pairs, stdin=torus())
    folder.refuse('--output-format determines the format of --output', 'path', 'torus.off', *pairs, '--mesh', '-')
    folder.refuse('--output-format requires a result on standard output', 'path', 'torus.off', *pairs, '--mesh', 'a.obj', '--output-format', 'obj')


def case_kinds_of_results(folder):
    """A page or lines of text do not replace a mesh whose name has got behind their option."""
    for name in ('a.obj', 'a.off', 'a.glb', 'A.PLY'):
        (folder.path / name).write_text('earlier\n')
        folder.refuse('--page writes a page', 'path', 'torus.off', '--random', '2', '--page', name)
        folder.refuse('--output writes a page', 'view', 'torus.off', '--output', name)
        for option in ('--stats', '--polylines'):
            folder.refuse(f'{option} writes lines', 'path', 'torus.off', '--random', '2', option, name)
        folder.refuse('--map writes lines', 'log', 'torus.off', '--source', '0', '--map', name)
    folder.refuse('--stats writes lines', 'path', 'torus.off', '--random', '2', '--stats', 'a.html')
    folder.refuse('--page writes a page', 'path', 'torus.off', '--random', '2', '--page', 'page')


def case_values_without_path(folder):
    """A vertex that no path reaches has an infinite distance and no source."""
    (folder.path / 'parts.off').write_text('OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n5 0 0\n6 0 0\n6 1 0\n3 0 1 2\n3 3 4 5\n')
    run = folder.start('distance', 'parts.off', '--source', '0', '--values', '-o', 'values.ply')
    check(run.wait() == 0, run.stderr.read())
    header, data = (folder.path / 'values.ply').read_bytes().split(b'end_header\n', 1)
    check(re.findall(rb'property (\w+ \w+)', header)[:5] == [b'double x', b'double y', b'double z', b'double distance',
                                                            b'double source'], header)
    vertices = [struct.unpack_from('<5d3B', data, 43 * v) for v in range(6)]
    check([v[4] for v in vertices[:3]] == [0, 0, 0], vertices)
    check(all(math.isinf(v[3]) and math.isnan(v[4]) for v in vertices[3:]), vertices)


def case_interruption(folder):
    """A signal removes temporary files and says so in one line; results of earlier runs stay."""
    def by_default():
        signal.signal(signal.SIGINT, signal.SIG_DFL)

    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        (folder.path / 'curves.txt').write_text('earlier\n')
        before = folder.names()
        run = folder.start('path', 'torus.off', *ENDLESS, '--quiet', '--polylines', 'curves.txt', '--stats', 'stats.csv',
                           preexec_fn=by_default)
        while len(folder.names()) < len(before) + 2 and run.poll() is None:
            pass
        run.send_signal(number)
        _, errors = run.communicate()
        check(run.returncode == 128 + number, f'exit status {run.returncode} after {number}\n{errors}')
        check(re.fullmatch(r'flip_geodesics: interrupted[^\n]*\n', errors), f'{errors} after {number}')
        check(folder.names() == before and folder.text('curves.txt') == 'earlier\n', 'the files are others')


def case_failed_curves(folder):
    """Files for curves, trees and meshes stay as they are where all curves fail; one that does not is written."""
    points, faces = '0 0 0\n1 0 0\n1 1 0\n9 9 0\n9 9 0\n', '3 0 1 2\n3 0 2 3\n3 3 2 4\n'
    (folder.path / 'degenerate.off').write_text('OFF\n5 3 0\n' + points + faces)
    (folder.path / 'one_fails.txt').write_text('0 4\n0 1\n')
    names = {'polylines': 'curves.txt', 'mesh': 'scene.obj', 'page': 'page.html', 'subdivision': 'common.off',
             'insert': 'inserted.off', 'cut': 'cut.off'}
    files = [word for option, name in names.items() for word in ('--' + option, name)]
    path = ['path', 'degenerate.off', '--from', '0', '--to', '4']
    all_results = ['refine', *path[1:], *files]
    tree = ['log', 'degenerate.off', '--source', '0', '--polylines', 'curves.txt', '--map', 'map.csv']
    before = folder.names()
    for curves in (all_results, tree):
        _, errors = folder.run(1, *curves, '--refuse-zero-edges')
        check('curve 0 ' in errors, errors)
        check(folder.names() == before, f'{" ".join(curves)}: there are files without a result')
    for name in [*names.values(), 'map.csv', 'scene.polylines.txt']:
        (folder.path / name).write_text('earlier\n')
    for curves in (all_results, tree, [*path, '--mesh', 'scene.polylines.txt', '--stats', 'stats.csv']):
        folder.run(1, *curves, '--refuse-zero-edges')
        for name in [*names.values(), 'map.csv', 'scene.polylines.txt']:
            check(folder.text(name) == 'earlier\n', f'{" ".join(curves)}: {name} has been replaced')
    check('ERROR' in folder.text('stats.csv'), 'no line for a curve that failed')
    folder.run(1, 'path', 'degenerate.off', '--refuse-zero-edges', '--pairs', 'one_fails.txt', '--polylines', 'curves.txt')
    check(folder.text('curves.txt').startswith('1 0 0 '), 'a curve is missing')
    # A pair that has no path, or none of a positive length, is an error of its own.
    (folder.path / 'parts.off').write_text('OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n5 0 0\n6 0 0\n6 1 0\n3 0 1 2\n3 3 4 5\n')
    (folder.path / 'some.txt').write_text('0 1\n0 3\n4 4\n3 5\n')
    for command, *options in (['path'], ['shortest'], ['path', '--kernel', 'double'], ['path', '--page', 'page.html'],
                              ['shortest', '--ways', '1']):
        _, errors = folder.run(1, command, 'parts.off', '--pairs', 'some.txt', '--stats', 'some.csv', '--polylines',
                               'some.out', '--quiet', *options)
        rows = list(csv.DictReader(folder.text('some.csv').splitlines()))
        check([row['source'] + row['target'] for row in rows] == ['01', '03', '44', '35'], folder.text('some.csv'))
        check(abs(float(rows[0]['length']) - 1) + abs(float(rows[3]['length']) - 2 ** 0.5) < 1e-12, folder.text('some.csv'))
        check(rows[1]['status'] == 'ERROR' and float(rows[2]['length']) != 1, folder.text('some.csv'))
        failed = [row['curve'] for row in rows if row['status'] == 'ERROR']
        check(re.findall(r'^flip_geodesics: curve (\d) \(some.txt line \d\): [^\n]+$', errors, re.M) == failed, errors)
        check(len(errors.splitlines()) == len(failed), errors)
    folder.run(0, 'distance', 'torus.off', '--source', '0', '--isolines', '99', '--polylines', 'curves.txt')
    check(folder.text('curves.txt') == '', 'there are other curves than those of the run, which are none')


def case_full_disk(folder):
    """What cannot be written to its end is told when it happens; the other results are written."""
    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

    (folder.path / 'curves.txt').write_text('earlier\n')
    before = folder.names() + ['stats.csv']
    _, errors = folder.run(1, 'path', 'torus.off', '--random', '20', '--quiet', '--polylines', 'curves.txt', '--stats',
                           'stats.csv', '--page', '/dev/full', preexec_fn=small_files)
    for name in ['curves.txt', '/dev/full']:
        check(errors.count(f'flip_geodesics: {name}: could not be written completely') == 1, errors)
    check(folder.text('stats.csv').count('\n') == 21, 'the other result is not whole')
    check(folder.text('curves.txt') == 'earlier\n' and folder.names() == sorted(before), 'the files are others')

    run = folder.start('path', 'torus.off', *ENDLESS, '--quiet', '--polylines', 'curves.txt', preexec_fn=small_files)
    check('could not be written' in run.stderr.readline(), 'it is not told when it happens')
    check(run.poll() is None and folder.names() == sorted(before), 'the file is not given up')
    run.terminate()
    run.communicate()

    for arguments in (['--help'], ['path', 'torus.off', '--random', '20']):
        for stream in ('/dev/full', None):
            how = {'stdout': open(stream, 'w', encoding='ascii')} if stream else {'preexec_fn': lambda: os.close(1)}
            _, errors = folder.run(1, *arguments, **how)
            check('standard output' in errors, errors)

    for arguments in (['path', 'torus.off', '--random', '2'],
                      ['path', 'torus.off', '--random', '20', '--polylines', '-', '--quiet']):
        reader, writer = os.pipe()
        os.close(reader)
        _, errors = folder.run(1, *arguments, stdout=writer)
        os.close(writer)
        check('standard output: could not be written completely; the receiving program has terminated' in errors,
              errors)


def case_little_memory(folder):
    """The lack of memory is told in one line. Sanitizers reserve more memory than this."""
    def little_memory():
        resource.setrlimit(resource.RLIMIT_AS, (150000000, 150000000))

    folder.make_torus('large.off', 600, 400)
    if folder.start('--version', preexec_fn=little_memory).wait() == 0:
        folder.refuse('there is not enough memory', 'info', 'large.off', '--quiet', preexec_fn=little_memory)


def case_closed_streams(folder):
    """A result does not become standard error, which a curve that fails writes to."""
    (folder.path / 'flat.off').write_text('OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n9 9 0\n9 9 0\n3 0 1 2\n3 0 2 3\n3 3 2 4\n')
    (folder.path / 'flat.txt').write_text('0 4\n0 1\n')
    arguments = ['path', 'flat.off', '--pairs', 'flat.txt', '--refuse-zero-edges', '--quiet', '--stats']
    folder.run(1, *arguments, 'expected.csv')
    folder.run(1, *arguments, 'closed.csv', stderr=None, preexec_fn=lambda: os.close(2))
    expected, closed = [[{key: value for key, value in row.items() if not key.endswith('_s')}
                         for row in csv.DictReader(folder.text(f'{name}.csv').splitlines())]
                        for name in ('expected', 'closed')]
    check(len(expected) == 2 and expected == closed, folder.text('closed.csv'))


def case_conditions(folder):
    """Weights and obstacles mean one thing in all commands."""
    def lengths(*arguments):
        folder.run(0, *arguments, '--quiet', '--stats', 'stats.csv')
        return [float(row['length']) for row in csv.DictReader(folder.text('stats.csv').splitlines())]

    def distances(*arguments):
        folder.run(0, 'distance', 'torus.off', '--source', '13', '--quiet', '--map', 'map.csv', *arguments)
        return [float(row['distance']) for row in csv.DictReader(folder.text('map.csv').splitlines())]

    def are_close(first, second, tolerance=1e-9):
        return len(first) == len(second) > 0 and all(abs(a - b) <= tolerance * max(a, b) for a, b in zip(first, second))

    vertices = [24, 100, 132, 150, 270]
    (folder.path / 'from_13.txt').write_text(''.join(f'13 {v}\n' for v in vertices))
    (folder.path / 'twice.txt').write_text('2\n' * 576)
    (folder.path / 'band.csv').write_text('# face, weight\n' + ''.join(f'{f}, 2.5\n' for f in range(100, 140)))
    (folder.path / 'edges.csv').write_text(''.join(f'{12 * i},{12 * i + 12},0.7\n' for i in range(23)))
    (folder.path / 'wall.txt').write_text('# a meridian\n0 1 2 3 4 5 6 7 8 9 10 11 0\n')
    paths = ['torus.off', '--pairs', 'from_13.txt']
    plain, weighted = lengths('shortest', *paths), {}
    for name in ('band.csv', 'twice.txt', 'edges.csv'):
        option = ['--edge-weights' if name == 'edges.csv' else '--face-weights', name]
        weighted[name] = lengths('shortest', *paths, *option)
        found = distances(*option)
        check(are_close(weighted[name], [found[v] for v in vertices]), f'{name}: paths and distances differ')
        check(are_close(weighted[name], lengths('shortest', *paths, *option, '--landmarks', '2')), f'{name}: landmarks')
        shortened = lengths('path', *paths, *option)
        check(all(a >= b * (1 - 1e-9) for a, b in zip(shortened, weighted[name])), f'{name}: a path is too short')
    check(are_close(weighted['twice.txt'], [2 * a for a in plain]), 'twice the weight is not twice the length')
    for name, sign in (('band.csv', 1), ('edges.csv', -1)):
        check(any(sign * (a - b) > 1e-3 for a, b in zip(weighted[name], plain)), f'{name} has no effect: {weighted[name]}, {plain}')
    twice = ['--face-weights', 'twice.txt']
    lines = ['distance', 'torus.off', '--source', '13,150', '--voronoi', '--isolines']
    check(are_close(lengths(*lines, '0.6', *twice), lengths(*lines, '0.3'), 1e-3), 'isolines at twice the distance')
    ends = []
    for length, option in (('2', twice), ('1', [])):
        trace = lengths('trace', 'torus.off', '--trace', f'13,0.4,{length}', '--polylines', 'trace.txt', *option)
        check(are_close(trace, [float(length)]), f'the length of a trace is {trace}')
        ends.append([float(x) for x in folder.text('trace.txt').splitlines()[-1].split()[-3:]])
    check(max(abs(a - b) for a, b in zip(*ends)) < 1e-9, 'a trace of twice the length ends elsewhere')

    around = ['--avoid', 'wall.txt']
    detours, found = lengths('shortest', *paths, *around), distances(*around)
    check(are_close(detours, [found[v] for v in vertices]), 'ways around a wall and distances differ')
    check(detours[-1] > 1.1 * plain[-1], 'the wall is passed')
    check(all(found[v] < 99 for v in range(288)), 'a vertex on the wall has no distance')
    check(all(a >= b * (1 - 1e-9) for a, b in zip(found, distances())), 'an obstacle makes a distance less')
    both = distances(*around, *twice)
    check(are_close(both, [2 * a for a in found]), 'obstacles and weights together')
    folder.run(0, 'distance', 'torus.off', '--source', '13,270', '--matrix', 'matrix.csv', '--quiet', *around)
    check(abs(float(folder.text('matrix.csv').splitlines()[0].split(',')[1]) - found[270]) < 1e-9, 'the matrix')
    folder.run(0, 'trace', 'torus.off', '--trace', '13,3,9', '--stats', 'stats.csv', '--quiet', *around)
    check(',BORDER,' in folder.text('stats.csv'), 'a trace passes the wall: ' + folder.text('stats.csv'))
    # Nothing of the results lies beyond the wall or behind the mesh's own numbers.
    folder.run(0, 'distance', 'torus.off', '--source', '13', '--spacing', '0.5', '--polylines', 'isolines.txt', '--cut',
               'pieces.off', '--quiet', *around)
    numbers = [line.split() for line in folder.text('isolines.txt').splitlines()]
    check(numbers and all(int(row[1]) < 288 and int(row[2]) < 288 for row in numbers), 'a vertex that the mesh lacks')


def case_progress(folder):
    """Told before the first curve is done, with figures that grow; nothing if it is to be quiet."""
    folder.make_torus('fine.off', 700, 400)
    folder.make_torus('finer.off', 1400, 800)
    quiet = folder.start('path', 'torus.off', *ENDLESS, '--quiet')
    tree = folder.start('log', 'fine.off', '--source', '0', '--shortest')
    random = folder.start('path', 'torus.off', *ENDLESS)
    pattern = (r'flip_geodesics: [a-z ]+(?:, [\d ]+ steps|, \d+ of 1 curves)?(?:, ([\d ]+) of 500 000 curves)?'
               r'(?:, ([\d ]+) flips)?, (\d+) s(?:, \d+ %, about \d+ s left)?\n')
    lines, figures = [], []
    while len(figures) < 2:
        lines.append(random.stderr.readline())
        match = re.fullmatch(pattern, lines[-1])
        check(match, ''.join(lines))
        if match[2]:  # the first line or two may be from before the first curve
            figures.append([int(figure.replace(' ', '')) for figure in match.groups()])
    check(all(0 < one < other for one, other in zip(*figures)), 'the figures do not grow:\n' + ''.join(lines))
    line = tree.stderr.readline()
    check(re.fullmatch(r'flip_geodesics: (reading the mesh|reading curves|growing the tree, [\d ]+ steps(, [\d ]+ flips)?|'
                       r'searching for shorter paths, [\d ]+ steps, [\d ]+ flips|extracting curves from the tree, [\d ]+ of 280 000 vertices, '
                       r'[\d ]+ flips), \d+ s(?:, \d+ %, about \d+ s left)?\n', line), line)
    slow = ((r'tracing isolines, [1-9][\d ]* evaluations, \d+ s', 'distance', 'torus.off', '--source', '0', '--spacing',
             '0.001', '--tolerance', '1e-5'),
            (r'searching for homotopy classes, [1-9][\d ]* steps, 0 of 1 curves, \d+ s', 'shortest', 'torus.off', '--from', '0', '--to',
             '150', '--ways', '900'),
            (r'repairing the mesh, [1-9][\d ]* of 2 240 000 polygons, \d+ s, \d+ %, about \d+ s left', 'repair',
             'finer.off', '--output', 'repaired.off'))
    for pattern, *arguments in slow:
        run = folder.start(*arguments)
        lines = [run.stderr.readline()]
        while lines[-1] and not re.fullmatch(f'flip_geodesics: {pattern}\n', lines[-1]):
            lines.append(run.stderr.readline())
        check(lines[-1], f'{" ".join(arguments)} does not tell how far it has come:\n' + ''.join(lines))
        run.terminate()
        run.communicate()
    for run in (quiet, tree, random):
        run.terminate()
    check(re.fullmatch(r'flip_geodesics: interrupted[^\n]*\n', quiet.communicate()[1]), 'it is not quiet')
    for run in (tree, random):
        run.communicate()


CASES = {name[len('case_'):]: case for name, case in globals().items() if name.startswith('case_')}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--program', required=True, type=Path)
    parser.add_argument('--torus', required=True, type=Path)
    parser.add_argument('case', choices=CASES)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as path:
        folder = Folder(options, path)
        try:
            CASES[options.case](folder)
        finally:
            folder.end()


if __name__ == '__main__':
    sys.exit(main())
