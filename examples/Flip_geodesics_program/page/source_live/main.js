// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Puts the parts of the live page together: the engine, the stage, and the panel.

import { Color } from 'three';
import { readResults, readMesh } from '../source/data.js';
import { Playback } from '../source/playback.js';
import { statusText, verdictText } from '../source/words.js';
import { pointText, through, tools } from './curve_tools.js';
import { Engine } from './engine.js';
import { exampleMesh } from './example_mesh.js';
import { Live_stage } from './live_stage.js';

// From the set of Okabe and Ito, which the colour-blind can tell apart.
const palettes = {
  light: { curve: '#0b4fb3', point: '#d55e00', tree: '#8a5a00' },
  dark: { curve: '#6fb1ff', point: '#ff9a4d', tree: '#e6c067' },
};
const mostRecordedPoints = 300000;
const mostVerticesOfTree = 50000;
const longestFrame = 300; // milliseconds that a curve takes, to follow a point at once
const reach = 12; // in pixels, of a press to a point
const at = (id) => document.getElementById(id);
const format = (x) => (x === null ? '?' : Number(x).toPrecision(8));
const mark = (name, value) => (document.documentElement.dataset[name] = value);

// Sets a line of the results; one without a value is not shown.
function tell(id, text) {
  at(id).textContent = text;
  at(id).hidden = at(id).previousElementSibling.hidden = text === '';
}

class Live_page {
  constructor(engine) {
    this.engine = engine;
    this.points = [];
    this.tool = 'path';
    this.theme = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
    this.revision = 0;
    this.listen();
  }

  // Opens a mesh. One that cannot be read leaves everything as it is.
  async open({ name, format, bytes }) {
    this.say(`Reading ${name}\u2026`);
    try {
      const mesh = readMesh(await this.engine.open(format ? `${name}.${format}` : name, bytes));
      this.show(mesh, name);
      this.say(mesh.remarks.join('; '));
    } catch (error) {
      this.say('');
      this.fail(error.message);
    }
  }

  show(mesh, name) {
    this.mesh = mesh;
    this.name = name;
    this.results = null;
    this.points = [];
    if (this.stage) {
      this.stage.setSurface(mesh);
      this.showResults(null);
    } else {
      this.stage = new Live_stage(at('view'), mesh);
      this.listenToCanvas(at('view'));
    }
    this.stage.setTheme(this.theme);
    document.documentElement.dataset.theme = this.theme;
    at('title').textContent = name;
    document.title = `${name} - geodesics, live`;
    at('facts').textContent = `${mesh.vertices.toLocaleString('en')} vertices, ${mesh.triangles.toLocaleString('en')} triangles`;
    this.stage.setSmooth(this.stage.isSmooth());
    this.stage.setShowsHidden(at('show-hidden').checked);
    this.stage.showMeshEdges(at('show-mesh').checked);
    this.milliseconds = 0;
    this.stage.findHome();
    this.chooseTool(this.tool);
    this.begin();
  }

  // Two points in sight, so that there is something to drag.
  begin() {
    const box = this.stage.canvas.getBoundingClientRect();
    const find = (from, to) => {
      for (let x = from; Math.abs(x - to) > 0.01; x += 0.02 * Math.sign(to - from))
        for (const y of [0.5, 0.6, 0.4]) {
          const place = this.stage.pick(box.left + x * box.width, box.top + y * box.height);
          if (place) return this.point(place);
        }
      return null;
    };
    const ends = [find(0.22, 0.5), find(0.78, 0.5)].filter(Boolean);
    if (this.tool !== 'path' || ends.length < 2) return;
    this.isBeginning = true;
    this.setPoints(ends);
  }

  get isAtVertices() {
    return at('snap').checked || tools[this.tool].isAtVertices;
  }

  // A point of a curve at a place of the surface. The place stays as it was chosen while the point is at a vertex.
  point(place) {
    const corners = this.stage.cornersOf(place.face);
    if (!this.isAtVertices) return { place, position: place.position, text: pointText(place, corners) };
    const nearest = corners[place.weights.indexOf(Math.max(...place.weights))];
    return { place, position: this.stage.vertex(nearest).toArray(), text: String(nearest) };
  }

  chooseTool(tool) {
    this.tool = tool;
    document.querySelectorAll('[data-tool]').forEach((b) => {
      b.setAttribute('role', 'radio');
      b.setAttribute('aria-checked', String(b.dataset.tool === tool));
    });
    document.querySelectorAll('.of-distances').forEach((e) => (e.hidden = tool !== 'distances'));
    at('hint').textContent = tools[tool].hint;
    at('tree').disabled = !this.mesh || this.mesh.vertices > mostVerticesOfTree;
    this.setPoints(this.points.map((p) => this.point(p.place)));
  }

  setPoints(points) {
    this.points = points;
    this.compute();
  }

  // While a point is dragged: a curve that takes long is computed once, where the point is let go.
  dragPoint(i, place) {
    const points = this.points.map((p, k) => (k === i ? this.point(place) : p));
    if (!(this.milliseconds > longestFrame)) return this.setPoints(points);
    this.points = points;
    this.isBehind = true;
    return this.draw();
  }

  endDrag() {
    if (this.isBehind) this.compute();
    this.isBehind = false;
  }

  settings() {
    const spacing = Number(((2 * this.mesh.radius) / Number(at('spacing').value)).toPrecision(4)); // as the command shows it
    return { spacing, hasTree: at('tree').checked && !at('tree').disabled };
  }

  // Asks the engine for the curve of the points as they are. While it computes, only the last change is kept.
  compute() {
    if (!this.mesh) return;
    this.pause();
    this.isChanged = true;
    this.draw();
    if (!this.isBusy) this.computeChanges();
  }

  async computeChanges() {
    this.isBusy = true;
    while (this.isChanged) {
      this.isChanged = false;
      await this.computeOnce();
    }
    this.isBusy = false;
    mark('revision', ++this.revision);
  }

  async computeOnce() {
    const { tool, points, mesh } = this;
    const { least, kind, line } = tools[tool];
    this.fail('');
    if (points.length < least) return this.showResults(null);
    const text = line(points, this.settings());
    const started = performance.now();
    const waiting = setTimeout(() => tell('time', 'computing\u2026'), 500);
    try {
      const answer = await this.engine.compute(kind, text, at('show-intrinsic').checked ? mostRecordedPoints : 0);
      if (mesh !== this.mesh) return undefined; // another one was opened
      this.milliseconds = performance.now() - started;
      this.showResults(readResults(answer));
      mark('line', text);
    } catch (error) {
      if (this.isBeginning) this.points = []; // nobody has chosen them
      this.showResults(null);
      if (!this.isBeginning) this.fail(error.message.replace(/^points line 1: /, ''));
    } finally {
      this.isBeginning = false;
      clearTimeout(waiting);
    }
    return undefined;
  }

  showResults(results) {
    this.results = results;
    const curves = results?.curves ?? [];
    const [first] = curves;
    const isOne = curves.length === 1 && this.tool !== 'distances';
    tell('count', isOne || curves.length === 0 ? '' : curves.length.toLocaleString('en'));
    tell('length', isOne ? format(first.length) : '');
    tell('status', isOne ? statusText(first.status) : '');
    tell('certificate', isOne ? verdictText(first.certificate) : '');
    tell('flips', isOne ? first.flips.toLocaleString('en') : '');
    tell('time', results ? `${this.milliseconds.toFixed(1)} ms` : '');
    const command = results ? tools[this.tool].command(this.name, this.points, this.settings()) : '';
    at('command').textContent = command && `flip_geodesics ${command}`;
    mark('length', isOne ? first.length : '');
    mark('certificate', isOne ? first.certificate : '');
    mark('flips', isOne ? first.flips : '');
    mark('curves', curves.length);
    this.showRun(results?.runs[0]);
    this.draw();
  }

  // The flips of the curve, if they were recorded.
  showRun(run) {
    this.playback = run && run.edges.length > 0 ? new Playback(run) : null;
    at('player').hidden = !this.playback || this.playback.length === 0;
    if (!this.playback) return;
    const touched = [];
    for (let i = 0; i < run.inputEdges.length; i += 3) touched.push(run.inputEdges[i + 1], run.inputEdges[i + 2]);
    this.stage.setQuietEdges(touched);
    at('step').max = this.playback.length;
    this.playback.goTo(this.playback.length);
    this.describeStep();
  }

  describeStep() {
    const { step, length, flips } = this.playback;
    at('step').value = step;
    at('step-text').textContent = `step ${step} of ${length}, ${flips} flips`;
  }

  goTo(step) {
    this.playback.goTo(Math.max(0, Math.min(step, this.playback.length)));
    this.describeStep();
    this.draw();
  }

  pieces(i) {
    const { curveStarts, curvePoints } = this.results;
    if (this.playback && this.playback.step < this.playback.length) return this.playback.curvePieces(i);
    const count = Math.max(0, curveStarts[i + 1] - curveStarts[i] - 1);
    const pieces = new Float32Array(6 * count);
    for (let k = 0; k < count; ++k) {
      const start = 3 * (curveStarts[i] + k);
      pieces.set(curvePoints.subarray(start, start + 6), 6 * k);
    }
    return pieces;
  }

  draw() {
    if (!this.stage) return;
    const colors = palettes[this.theme];
    const curves = (this.results?.curves ?? []).map((curve, i) => ({
      pieces: this.pieces(i), ends: [], color: new Color(curve.tree ? colors.tree : colors.curve), isThin: curve.tree,
    }));
    curves.push({ pieces: [], ends: this.points.flatMap((p) => p.position), color: new Color(colors.point) });
    mark('curvePieces', this.stage.setCurves(curves));
    const shows = this.playback !== null && this.playback !== undefined && at('show-intrinsic').checked;
    const pieces = shows ? this.playback.piecesOf(this.playback.edges) : [];
    this.stage.setEdges(pieces, shows ? this.playback.piecesOf(this.playback.fresh) : [], shows);
  }

  play() {
    if (this.timer) return this.pause();
    if (this.playback.step === this.playback.length) this.goTo(0);
    at('play').textContent = '|| Pause';
    const stride = Math.max(1, Math.ceil(this.playback.length / 300));
    const period = Math.max(16, Math.min(300, 6000 / this.playback.length));
    this.timer = setInterval(() => {
      this.goTo(this.playback.step + stride);
      if (this.playback.step === this.playback.length) this.pause();
    }, period);
    return undefined;
  }

  pause() {
    clearInterval(this.timer);
    this.timer = undefined;
    at('play').textContent = '\u25B6 Play the flips';
  }

  // Which point is under the pointer, or -1.
  pointAt(x, y) {
    let [nearest, least] = [-1, reach];
    this.points.forEach(({ position }, i) => {
      const [px, py] = this.stage.project(position);
      const distance = Math.hypot(px - x, py - y);
      if (distance < least && this.stage.isVisible(position)) [nearest, least] = [i, distance];
    });
    return nearest;
  }

  // A press on a point drags it; elsewhere one that does not move adds a point. The stage turns by all others.
  listenToCanvas(canvas) {
    let dragged = -1;
    let pressed = null;
    canvas.addEventListener('pointerdown', (event) => {
      pressed = event.button === 0 ? [event.clientX, event.clientY] : null;
      dragged = event.button === 0 ? this.pointAt(event.clientX, event.clientY) : -1;
      this.stage.controls.enabled = dragged < 0;
      if (dragged >= 0) canvas.setPointerCapture?.(event.pointerId);
    }, { capture: true });
    canvas.addEventListener('pointermove', (event) => {
      if (dragged < 0) return;
      const place = this.stage.pick(event.clientX, event.clientY);
      if (place) this.dragPoint(dragged, place);
    });
    canvas.addEventListener('pointerup', (event) => {
      const isClick = pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 4;
      const place = isClick && dragged < 0 ? this.stage.pick(event.clientX, event.clientY) : null;
      dragged = -1;
      pressed = null;
      this.endDrag();
      this.stage.controls.enabled = true;
      if (place) this.setPoints([...this.points, this.point(place)]);
    });
    canvas.addEventListener('contextmenu', (event) => {
      event.preventDefault();
      const i = this.pointAt(event.clientX, event.clientY);
      if (i >= 0) this.setPoints(this.points.filter((_, k) => k !== i));
    });
  }

  listen() {
    document.querySelectorAll('[data-tool]').forEach((b) => b.addEventListener('click', () => this.chooseTool(b.dataset.tool)));
    document.querySelectorAll('[data-format]').forEach((b) => b.addEventListener('click', () => this.save(b.dataset.format)));
    const clicks = {
      undo: () => this.setPoints(this.points.slice(0, -1)), clear: () => this.setPoints([]), play: () => this.play(),
      reset: () => this.stage.reset(), theme: () => this.switchTheme(),
    };
    for (const [id, action] of Object.entries(clicks)) at(id).addEventListener('click', action);
    const changes = {
      'show-intrinsic': () => this.compute(), tree: () => this.compute(), spacing: () => this.compute(),
      'show-mesh': () => this.stage.showMeshEdges(at('show-mesh').checked),
      'show-hidden': () => this.stage.setShowsHidden(at('show-hidden').checked),
      snap: () => this.chooseTool(this.tool),
      file: () => this.openFile(at('file').files[0]),
    };
    for (const [id, action] of Object.entries(changes)) at(id).addEventListener('change', action);
    at('step').addEventListener('input', () => {
      this.pause();
      this.goTo(Number(at('step').value));
    });
    addEventListener('dragover', (event) => {
      event.preventDefault();
      document.body.classList.add('is-dropping');
    });
    addEventListener('dragleave', () => document.body.classList.remove('is-dropping'));
    addEventListener('drop', (event) => {
      event.preventDefault();
      document.body.classList.remove('is-dropping');
      if (event.dataTransfer.files.length > 0) this.openFile(event.dataTransfer.files[0]);
    });
    addEventListener('keydown', (event) => this.onKey(event));
  }

  onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === 'INPUT' || !this.stage) return;
    const boxes = { e: 'show-intrinsic', m: 'show-mesh', h: 'show-hidden', v: 'snap' };
    if (event.key in boxes) at(boxes[event.key]).click();
    else if (event.key === 'Backspace') at('undo').click();
    else if (event.key === 'r') at('reset').click();
    else if (event.key === 't') at('theme').click();
  }

  switchTheme() {
    this.theme = this.theme === 'dark' ? 'light' : 'dark';
    document.documentElement.dataset.theme = this.theme;
    this.stage.setTheme(this.theme);
    this.draw();
  }

  async openFile(file) {
    if (file) await this.open({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) });
  }

  // What a file of points has: a line of the program's, or the sources.
  pointsLine() {
    return this.tool === 'distances' ? through(this.points) : tools[this.tool].line(this.points, this.settings());
  }

  async save(kind) {
    if (!this.results) return this.fail('There is no curve to save yet.');
    try {
      const content = kind === 'points' ? `${this.pointsLine()}\n` : await this.engine.save(kind.slice(0, 9));
      const link = document.createElement('a');
      link.href = URL.createObjectURL(new Blob([content]));
      link.download = kind === 'points' ? 'points.txt' : `${this.name.replace(/\.[^.]*$/, '')}_curves.${kind}`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    } catch (error) {
      this.fail(error.message);
    }
    return undefined;
  }

  say(text) {
    at('message').textContent = text;
  }

  fail(line) {
    at('error').textContent = line;
    mark('error', line);
  }
}

// The mesh that the program has put in, or an example.
function firstMesh() {
  const text = at('scene').textContent;
  if (text.trim() === 'null') return exampleMesh();
  const { name, format, mesh } = JSON.parse(text);
  return { name, format, bytes: Uint8Array.from(atob(mesh), (c) => c.charCodeAt(0)) };
}

async function start() {
  try {
    if (!document.createElement('canvas').getContext('webgl2')) throw new Error('this browser shows no WebGL 2');
    const page = new Live_page(await Engine.start(at('engine').textContent));
    at('engine').textContent = '';
    await page.open(firstMesh());
    mark('state', 'ready');
  } catch (error) {
    mark('state', 'failed');
    at('message').textContent = `The page cannot compute here: ${error.message}`;
  }
}

requestAnimationFrame(() => setTimeout(start, 0));
