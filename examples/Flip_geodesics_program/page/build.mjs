// SPDX-License-Identifier: LGPL-3.0-or-later
//
//   npm ci && npm run build     writes viewer_page.html from source/, with the libraries in it
//   npm run check               fails if viewer_page.html is not what build would write
//
// The program is built with viewer_page.html, so that only who changes the page needs Node.js. The page has the hashes
// of its sources in it, which a test compares.

import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

const target = new URL('viewer_page.html', import.meta.url);
const read = (name) => readFileSync(new URL(name, import.meta.url), 'utf8');

const bundle = await build({
  absWorkingDir: new URL('.', import.meta.url).pathname,
  entryPoints: ['source/main.js'],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2020',
  legalComments: 'none',
  charset: 'ascii',
  write: false,
});
const style = await build({
  absWorkingDir: new URL('.', import.meta.url).pathname,
  entryPoints: ['source/style.css'],
  minify: true,
  charset: 'ascii',
  write: false,
});

const { version } = JSON.parse(read('node_modules/three/package.json'));
const licence = `three.js ${version}\n\n${read('node_modules/three/LICENSE').trim().replaceAll('\u00a9', '(c)')}`;
const sources = ['data.js', 'main.js', 'page.html', 'playback.js', 'stage.js', 'style.css'].map((name) => {
  const hash = createHash('sha256').update(readFileSync(new URL(`source/${name}`, import.meta.url))).digest('hex');
  return `source/${name} ${hash}`;
});
const pieces = {
  '@SOURCES@': sources.join('\n'),
  '@LICENCE@': licence,
  '@STYLE@': style.outputFiles[0].text.trim(),
  '@SCRIPT@': bundle.outputFiles[0].text.trim(),
};
let page = read('source/page.html');
for (const [mark, text] of Object.entries(pieces)) {
  if (page.split(mark).length !== 2) throw new Error(`source/page.html does not have ${mark} once`);
  page = page.replace(mark, () => text);
}
if (page.split('@SCENE@').length !== 2) throw new Error('the page does not have @SCENE@ once');
if (/[^\x00-\x7f]/.test(page)) throw new Error('the page is not ASCII');

if (process.argv.includes('--check')) {
  if (read('viewer_page.html') !== page) throw new Error('viewer_page.html is out of date: npm run build');
} else {
  writeFileSync(target, page);
  console.log(`viewer_page.html: ${page.length} bytes`);
}
