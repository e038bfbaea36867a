// SPDX-License-Identifier: LGPL-3.0-or-later
//
//   npm ci && npm run build     writes viewer_page.html and live_page.html, with the libraries in them
//   npm run check               fails if they are not what build would write
//   npm run build-engine        compiles the engine of live_page.html first, with Emscripten
//
// The program is built with the pages, so that it needs neither Node.js nor Emscripten. The pages are rebuilt for a release
// only. They list the hashes of their sources, from which check_sources.cmake finds out whether they are older. Without
// build-engine the engine in live_page.html stays.

import { createHash } from 'node:crypto';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';
import { deflateSync } from 'node:zlib';

const folder = new URL('.', import.meta.url).pathname;
const read = (name) => readFileSync(new URL(name, import.meta.url), 'utf8');
const hashOf = (name) => `${name} ${createHash('sha256').update(readFileSync(new URL(name, import.meta.url))).digest('hex')}`;

async function bundle(entry, define = {}) {
  const { outputFiles } = await build({
    absWorkingDir: folder,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2020',
    legalComments: 'none',
    charset: 'ascii',
    define,
    write: false,
  });
  return outputFiles[0].text.trim();
}

const { version } = JSON.parse(read('node_modules/three/package.json'));
const licence = `three.js ${version}\n\n${read('node_modules/three/LICENSE').trim().replaceAll('\u00a9', '(c)')}`;

// Both pages are one frame with a panel of their own.
function fill(pieces) {
  let page = read('source/frame.html');
  for (const [mark, text] of Object.entries({ '@LICENCE@': licence, ...pieces })) {
    if (page.split(mark).length !== 2) throw new Error(`the frame does not have ${mark} once`);
    page = page.replace(mark, () => text);
  }
  if (page.split('@SCENE@').length !== 2) throw new Error('the page does not have @SCENE@ once');
  if (/[^\x00-\x7f]/.test(page)) throw new Error('the page is not ASCII');
  return page;
}

const sourcesIn = (name) => readdirSync(new URL(name, import.meta.url)).sort().map((file) => `${name}/${file}`);

async function viewerPage() {
  return fill({
    '@TITLE@': 'Geodesic curves',
    '@INTRODUCTION@': 'This page holds its data and its script, and loads nothing. The script contains',
    '@PANEL@': read('source/panel.html').trimEnd(),
    '@DATA@': '',
    '@SOURCES@': sourcesIn('source').map(hashOf).join('\n'),
    '@STYLE@': await bundle('source/style.css'),
    '@SCRIPT@': await bundle('source/main.js'),
  });
}

// The engine, packed, and the hashes of what it was made of: a new one, or that of the page as it is.
function engine() {
  const file = new URL('engine.wasm', import.meta.url);
  if (existsSync(file))
    return { code: deflateSync(readFileSync(file), { level: 9 }).toString('base64'), sources: read('engine.wasm.sources').trim() };
  const page = read('live_page.html');
  const [, code] = /<script type="text\/plain" id="engine">(.*?)<\/script>/s.exec(page);
  const [, sources] = /\nThose of the engine:\n(.*?)\n-->/s.exec(page);
  return { code, sources };
}

async function livePage() {
  const { code, sources } = engine();
  const shared = ['source/data.js', 'source/frame.html', 'source/playback.js', 'source/stage.js', 'source/style.css', 'source/words.js'];
  const worker = await bundle('source_live/engine_worker.js');
  return fill({
    '@TITLE@': 'Geodesic curves',
    '@INTRODUCTION@': `This page holds its data, its script and its engine, and loads nothing. The engine is
flip_geodesics itself as WebAssembly, made with CGAL, Boost and Eigen; parts of CGAL in it are under the GPL 3.0 or later.
The script contains`,
    '@PANEL@': read('source_live/panel.html').trimEnd(),
    '@DATA@': `<script type="text/plain" id="engine">${code}</script>\n`,
    '@SOURCES@': `${[...shared, ...sourcesIn('source_live')].map(hashOf).join('\n')}\nThose of the engine:\n${sources}`,
    '@STYLE@': `${await bundle('source/style.css')}${await bundle('source_live/live.css')}`,
    '@SCRIPT@': await bundle('source_live/main.js', { ENGINE_WORKER: JSON.stringify(worker) }),
  });
}

const pages = { 'viewer_page.html': await viewerPage(), 'live_page.html': await livePage() };
for (const [name, page] of Object.entries(pages)) {
  if (!process.argv.includes('--check')) {
    writeFileSync(new URL(name, import.meta.url), page);
    console.log(`${name}: ${page.length} bytes`);
  } else if (read(name) !== page) {
    throw new Error(`${name} is out of date: npm run build`);
  }
}
