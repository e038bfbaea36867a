# SPDX-License-Identifier: LGPL-3.0-or-later
"""Drags a point on the live page in a browser, compares the lengths with those of the program, and opens other meshes.

    check_live_page.py --program flip_geodesics --mesh FILE.off --chromium BROWSER

The page is loaded from a file, as it was written; a script that is put behind it moves the pointer and posts what it
sees to this program, so that nothing depends on how long the browser takes.
"""

import argparse
import csv
import http.server
import json
import queue
import subprocess
import sys
import tempfile
from pathlib import Path

from check_viewer_files import compare, read_glb, read_obj, read_ply

# A step at a time: waits until the engine has answered, does something with the pointer, and waits again.
SCRIPT = '''
<script>
const data = document.documentElement.dataset;
const post = (value) => fetch('http://127.0.0.1:PORT/', { method: 'POST', mode: 'no-cors', body: JSON.stringify(value) });
addEventListener('error', (event) => post({ failure: event.message }));
const contexts = new Set(); // of WebGL, that the page has made
const getContext = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
  const context = getContext.call(this, kind, ...options);
  if (kind.startsWith('webgl') && context) contexts.add(context);
  return context;
};
addEventListener('unhandledrejection', (event) => post({ failure: String(event.reason) }));
const until = async (isTrue) => { while (!isTrue()) await new Promise((next) => setTimeout(next, 20)); };
const settle = async (action) => {
  const before = data.revision;
  action();
  await until(() => data.revision !== before);
  return { ...data };
};
const point = (x, y) => {
  const box = document.getElementById('view').getBoundingClientRect();
  return { clientX: box.left + x * box.width, clientY: box.top + y * box.height, pointerId: 1, button: 0, bubbles: true };
};
const send = (kind, at) => document.getElementById('view').dispatchEvent(new PointerEvent(kind, at));
const click = (x, y) => settle(() => { send('pointerdown', point(x, y)); send('pointerup', point(x, y)); });
// From a place to another one, in steps.
const drag = async (from, to) => {
  send('pointerdown', point(...from));
  const states = [];
  for (const t of [0.25, 0.5, 0.75, 1])
    states.push(await settle(() => send('pointermove', point(from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])))));
  send('pointerup', point(...to));
  return states;
};
const press = (id) => settle(() => document.getElementById(id).click());
const choose = (tool) => settle(() => document.querySelector(`[data-tool=${tool}]`).click());
const drop = async (name, text) => {
  const files = new DataTransfer();
  files.items.add(new File([text], name));
  dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true }));
};
// Opens a mesh, and sees what the page says of it.
const openMesh = async (name, text) => {
  const before = data.revision;
  data.error = '';
  await drop(name, text);
  await until(() => data.revision !== before || data.error);
  const read = (id) => document.getElementById(id).textContent;
  return { ...data, title: read('title'), facts: read('facts'), message: read('message') };
};
const frames = async (count) => { for (let i = 0; i < count; ++i) await new Promise(requestAnimationFrame); };
// The bytes of a file that the page saves, one character each.
const save = async (format) => {
  const create = URL.createObjectURL;
  const content = await new Promise((done) => {
    URL.createObjectURL = (blob) => { done(blob); return create.call(URL, blob); };
    document.querySelector(`[data-format=${format}]`).click();
  });
  URL.createObjectURL = create;
  return Array.from(new Uint8Array(await content.arrayBuffer()), (byte) => String.fromCharCode(byte)).join('');
};
(async () => {
  await until(() => data.state && (data.revision || data.state === 'failed'));
  if (data.state === 'failed') return post({ failure: document.getElementById('message').textContent });
  const seen = {};
  await press('clear');
  const spot = PLACES;
  await click(...spot[0]);
  seen.path = await click(...spot[1]);
  seen.drag = await drag(spot[1], spot[2]);
  seen.flips = await press('show-intrinsic');
  seen.through = await click(...spot[3]);
  seen.saved = {};
  for (const format of ['obj', 'ply', 'glb', 'points']) seen.saved[format] = await save(format);
  await press('show-intrinsic');
  seen.spline = await choose('spline');
  seen.loop = await choose('loop');
  seen.distances = await choose('distances');
  seen.distances.command = document.getElementById('command').textContent;
  seen.back = await choose('path');
  await drop('bad.off', 'OFF nothing');
  await until(() => data.error);
  seen.bad = { ...data, title: document.getElementById('title').textContent };
  seen.quad = await openMesh('quad.obj', 'v 0 0 0\\nv 1 0 0\\nv 1 1 0\\nv 0 1 0\\nf 1 2 3 4\\n');
  seen.pieces = await openMesh('pieces.off', PIECES);
  for (let i = 0; i < 4; ++i) await openMesh(`triangle${i}.off`, 'OFF\\n3 1 0\\n0 0 0\\n1 0 0\\n0 1 0\\n3 0 1 2\\n');
  document.getElementById('view').parentElement.style.width = '80px'; // which every observer sees before the next frame
  await frames(2);
  seen.contexts = [...contexts].filter((context) => !context.isContextLost()).length;
  return post(seen);
})();
</script>
'''


def check(condition, message):
    if not condition:
        raise SystemExit(f'check_live_page: {message}')


class Answers(http.server.BaseHTTPRequestHandler):
    def do_POST(self):
        body = self.rfile.read(int(self.headers['Content-Length']))
        self.send_response(204)
        self.end_headers()
        self.server.answers.put(json.loads(body))

    def log_message(self, *_):
        pass


def run_in_browser(browser, page, script, folder):
    """What the script posts, or nothing if the browser has not come so far in two minutes."""
    server = http.server.HTTPServer(('127.0.0.1', 0), Answers)
    server.answers = queue.Queue()
    server.timeout = 120
    text = page.read_text() + script.replace('PORT', str(server.server_address[1]))
    (folder / 'scripted.html').write_text(text)
    command = [browser, '--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
               '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
               '--window-size=1200,800', '--remote-debugging-port=0', f'--user-data-dir={folder / "profile"}',
               (folder / 'scripted.html').resolve().as_uri()]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        server.handle_request()
    finally:
        process.terminate()
        process.wait()
        server.server_close()
    check(not server.answers.empty(), 'the page does not answer')
    return server.answers.get()


def native_length(options, folder, option, line):
    (folder / 'points.txt').write_text(line + '\n')
    subprocess.run([options.program, 'spline' if option == '--bezier' else 'path', options.mesh, '--quiet', option,
                    folder / 'points.txt', '--stats', folder / 'stats.csv'], check=True)
    with open(folder / 'stats.csv', encoding='ascii') as file:
        return float(next(csv.DictReader(file))['length'])


def check_saved(options, folder, saved, line):
    """Files that the page saves hold what the program computes, up to rounding: the mesh, and tubes along the curve."""
    check(saved['points'] == line + '\n', f'saved points: {saved["points"]}')
    (folder / 'points.txt').write_text(saved['points'])
    for format, read in {'obj': read_obj, 'ply': read_ply, 'glb': read_glb}.items():
        own, found = folder / f'curves.{format}', folder / f'saved.{format}'
        subprocess.run([options.program, 'path', options.mesh, '--quiet', '--points', folder / 'points.txt', '--mesh', own],
                       check=True)
        found.write_bytes(saved[format].encode('latin-1'))
        points, faces, curves = read(own)
        compare(found, *read(found), (points, faces), curves, 1e-5 if format == 'glb' else 1e-9)  # a GLB has floats


# Two triangles of opposite orientation, one of them twice, and a point without faces.
PIECES = 'OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 9 9\n3 0 1 2\n3 0 3 2\n3 0 1 2\n'


def check_opened(seen):
    """Meshes that need a repair are repaired, as the page says; those before leave nothing behind."""
    check((seen['quad']['title'], seen['quad']['facts']) == ('quad.obj', '4 vertices, 2 triangles'), seen['quad'])
    check('polygon' in seen['quad']['message'], f'no word of the repair: {seen["quad"]}')
    check((seen['pieces']['title'], seen['pieces']['facts']) == ('pieces.off', '5 vertices, 2 triangles'), seen['pieces'])
    check(seen['pieces']['message'].count(';') >= 1, f'one thing is told, not all: {seen["pieces"]}')
    check(seen['contexts'] <= 2, f'{seen["contexts"]} WebGL contexts are left by the meshes opened before')


def check_isolines(options, folder, seen):
    """The command that the page shows gives as many isolines."""
    _, command, mesh, *arguments = seen['command'].split()
    check(mesh == options.mesh.name and arguments[0] == '--source', f'the command of isolines: {seen["command"]}')
    subprocess.run([options.program, command, options.mesh, '--quiet', *arguments, '--stats', folder / 'isolines.csv'], check=True)
    with open(folder / 'isolines.csv', encoding='ascii') as file:
        count = sum(1 for _ in csv.DictReader(file))
    check(count == int(seen['curves']) >= 2, f'{seen["curves"]} isolines on the page, {count} by {seen["command"]}')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--program', required=True)
    parser.add_argument('--mesh', type=Path, required=True)
    parser.add_argument('--chromium', required=True)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        folder = Path(folder)
        subprocess.run([options.program, 'view', options.mesh, '--quiet', '--output', folder / 'live.html'], check=True)
        script = SCRIPT.replace('PIECES', json.dumps(PIECES)).replace('PLACES', json.dumps([[0.3, 0.5], [0.7, 0.5], [0.66, 0.62], [0.5, 0.3]]))
        seen = run_in_browser(options.chromium, folder / 'live.html', script, folder)
        check('failure' not in seen, f'the page fails: {seen}')
        compared = 0
        lines = set()
        for name, option in [('path', '--points'), ('drag', '--points'), ('flips', '--points'),
                             ('through', '--points'), ('spline', '--bezier'), ('loop', '--draw')]:
            for state in seen[name] if isinstance(seen[name], list) else [seen[name]]:
                length = native_length(options, folder, option, state['line'])
                check(length > 0, f'{name}: a curve of length {length}')
                check(abs(float(state['length']) - length) <= 1e-12 * length,
                      f'{name}, {state["line"]}: length {state["length"]} on the page, {length} by the program')
                check(state['certificate'] == 'PROVEN', f'{name}: {state}')
                lines.add(state['line'])
                compared += 1
        check_saved(options, folder, seen['saved'], seen['through']['line'])
        check(len(lines) >= 7, f'the drags have not moved the point: {lines}')
        check_isolines(options, folder, seen['distances'])
        check(seen['bad']['error'].startswith('bad.off'), f'a bad file: {seen["bad"]}')
        check(seen['back']['line'] == seen['through']['line'],
              f'the points have moved: {seen["back"]["line"]} instead of {seen["through"]["line"]}')
        check(seen['bad']['title'] == options.mesh.name and seen['bad']['curves'] == seen['back']['curves'],
              f'a bad file replaces the mesh: {seen["bad"]}')
        check_opened(seen)
        print(f'{compared} curves of the page have the lengths that the program computes')


if __name__ == '__main__':
    sys.exit(main())
