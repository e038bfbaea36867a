// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Puts the parts together: the scene of the page, the stage that draws it, and the panel.

import { Color } from 'three';
import { curvePieces, readScene } from './data.js';
import { Playback } from './playback.js';
import { hasWebGL, Stage } from './stage.js';
import { plural, statusText, verdictText } from './words.js';

// Near the set of Okabe and Ito, which the color-blind can tell apart.
const palettes = {
  light: ['#0064a0', '#c44f00', '#00785a', '#a8437f', '#6e5600', '#1c2127'],
  dark: ['#56b4e9', '#ff9a4d', '#2fd0a5', '#f0a3cf', '#f0e442', '#ffffff'],
};
const mostRows = 300; // of the legend
const mostEnds = 300; // more curves than this are drawn without disks at their ends
const mostThickOfTree = 300; // more edges of a tree than this are drawn a pixel wide
const at = (id) => document.getElementById(id);
const format = (x) => (x === null ? '?' : Number(x).toPrecision(6));

const emptyStage = new Proxy({}, { get: () => () => 0 }); // that draws nothing

class Page {
  constructor(scene) {
    this.scene = scene;
    this.stage = hasWebGL() ? new Stage(at('view'), scene) : emptyStage;
    this.shown = scene.curves.map(() => true);
    this.chooseTheme(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
    at('title').textContent = scene.title;
    document.title = `${scene.title} - geodesic curves`;
    at('facts').textContent = `${plural(scene.vertices, 'vertex', 'vertices')}, ${plural(scene.triangles, 'triangle')}`;
    this.fillLegend();
    this.stage.setShowsHidden(at('show-hidden').checked);
    at('smooth').checked = this.stage.isSmooth();
    this.stage.setSmooth(at('smooth').checked);
    const first = this.firstCurve();
    this.chooseRun(scene.curves.length > 0 ? scene.curves[first].run : 0, first);
    this.stage.findHome();
    this.listen();
    this.obeyAddress();
  }

  // The curve whose run has the most steps, as that is worth seeing.
  firstCurve() {
    const steps = this.scene.curves.map(({ run }) => this.scene.runs[run]?.steps.length ?? 0);
    return Math.max(0, steps.indexOf(Math.max(...steps)));
  }

  // The address may end in, for example, #curve=2&step=10&edges=1&theme=dark.
  obeyAddress() {
    if (location.hash === '') return;
    const wish = new URLSearchParams(location.hash.slice(1));
    if (wish.get('theme') in palettes && wish.get('theme') !== this.theme) this.switchTheme();
    const curve = Number(wish.get('curve') ?? 0);
    if (curve in this.scene.curves) this.chooseRun(this.scene.curves[curve].run, curve);
    if (wish.get('edges') === '1' && !at('show-intrinsic').checked) this.toggle('show-intrinsic');
    if (wish.has('step')) this.goTo(Number(wish.get('step')) || 0);
  }

  // The edges of a tree have one color.
  color(i) {
    const palette = palettes[this.theme];
    const { run, tree } = this.scene.curves[i];
    return palette[(tree ? run : i) % palette.length];
  }

  chooseTheme(theme) {
    this.theme = theme;
    document.documentElement.dataset.theme = theme;
    this.stage.setTheme(theme);
    document.querySelectorAll('#curves .swatch').forEach((swatch, i) => (swatch.style.background = this.color(i)));
  }

  fillLegend() {
    const { curves } = this.scene;
    at('legend-title').textContent = plural(curves.length, 'curve');
    curves.slice(0, mostRows).forEach((curve, i) => at('curves').append(this.legendRow(curve, i)));
    if (curves.length > mostRows) at('more').textContent = `and ${curves.length - mostRows} more, which are also drawn`;
  }

  legendRow(curve, i) {
    const row = document.createElement('li');
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.checked = true;
    box.setAttribute('aria-label', `Show curve ${curve.number}`);
    box.addEventListener('change', () => {
      this.shown[i] = box.checked;
      this.drawCurves();
    });
    const button = document.createElement('button');
    const swatch = document.createElement('span');
    swatch.className = 'swatch';
    swatch.style.background = this.color(i);
    const numbers = document.createElement('span');
    numbers.className = 'numbers';
    const share = curve.initialLength > 0 && !curve.tree ? `${((100 * curve.length) / curve.initialLength).toFixed(2)} % of its initial length, ` : '';
    const status = document.createElement('span');
    status.textContent = [statusText(curve.status), verdictText(curve.certificate)].filter(Boolean).join(', ');
    if (curve.status !== 'LOCALLY_SHORTEST') status.className = 'other';
    numbers.append(share, status);
    const length = document.createElement('span');
    length.className = 'length';
    length.textContent = format(curve.length);
    const name = curve.tree ? curve.name : `curve ${curve.number}${curve.closed ? ', closed' : ''}`;
    button.append(swatch, name, length, numbers);
    button.title = curve.name;
    button.addEventListener('click', () => this.chooseRun(curve.run, i));
    row.append(box, button);
    return row;
  }

  // The run whose steps are played and whose triangulation is shown.
  chooseRun(run, curve) {
    this.pause();
    this.runNumber = run;
    this.run = this.scene.runs[run];
    this.firstOfRun = this.scene.curves.findIndex((c) => c.run === run);
    this.playback = this.run && this.run.edges.length > 0 ? new Playback(this.run) : null;
    this.quietRun = undefined;
    document.querySelectorAll('#curves button').forEach((b, i) => b.setAttribute('aria-pressed', String(i === curve)));
    const together = this.scene.curves.filter((c) => c.run === run).length > 1;
    this.curve = curve;
    at('run-name').textContent = together ? 'the curves' : `curve ${this.scene.curves[curve]?.number ?? ''}`;
    const steps = this.playback ? this.playback.length : 0;
    document.querySelectorAll('#player button, #player input, #player select').forEach((e) => (e.disabled = steps === 0));
    at('show-intrinsic').disabled = !this.playback;
    at('show-start').disabled = steps === 0;
    at('step').max = steps;
    this.startPieces = this.playback ? this.playback.curves.flatMap((_, k) => this.playback.curvePieces(k)) : [];
    this.goTo(steps);
    if (steps === 0) at('step-text').textContent = this.whyWithoutSteps();
  }

  whyWithoutSteps() {
    const curve = this.scene.curves[this.curve];
    if (curve?.tree) return 'The page does not contain the flips of a tree.';
    if (this.playback) return 'No flips were needed.';
    if (!curve || curve.flips === 0) return 'This curve was computed without flips.';
    return 'The page does not contain the flips of this curve.';
  }

  goTo(step) {
    if (this.playback) {
      this.playback.goTo(Math.max(0, Math.min(step, this.playback.length)));
      at('step').value = this.playback.step;
      at('step-text').textContent = this.describeStep();
      document.documentElement.dataset.step = this.playback.step;
    }
    this.drawCurves();
    this.drawEdges();
    this.drawStart();
  }

  // What has become another curve than it was.
  drawStart() {
    const shows = at('show-start').checked && this.playback !== null && this.playback.step > 0 && this.playback.length > 0;
    document.documentElement.dataset.startPieces = this.stage.setStart(shows ? this.startPieces : []);
  }

  describeStep() {
    const { step, length, flips } = this.playback;
    const merged = !this.run.hasAllSteps && step === length ? ' (the last steps combined)' : '';
    const curves = this.playback.curves.map((_, k) => this.playback.curveLength(k));
    const sum = curves.reduce((a, b) => a + b, 0) * this.scene.radius;
    return `step ${step} of ${length}${merged}, ${plural(flips, 'flip')}, length ${format(sum)}`;
  }

  // The finished curve, or where it is at the step that is shown.
  curvePieces(i) {
    if (this.playback && this.scene.curves[i].run === this.runNumber && this.playback.step < this.playback.length)
      return this.playback.curvePieces(i - this.firstOfRun);
    return curvePieces(this.scene, i);
  }

  curveEnds(i) {
    const { curves, curveStarts, curvePoints } = this.scene;
    const [first, end] = [curveStarts[i], curveStarts[i + 1]];
    if (curves[i].closed || first === end || curves.length > mostEnds) return [];
    return [...curvePoints.subarray(3 * first, 3 * first + 3), ...curvePoints.subarray(3 * end - 3, 3 * end)];
  }

  drawCurves() {
    const curves = [];
    this.scene.curves.forEach((_, i) => {
      if (!this.shown[i]) return;
      const isThin = this.scene.curves[i].tree && this.scene.curves.length > mostThickOfTree;
      curves.push({ pieces: this.curvePieces(i), ends: this.curveEnds(i), color: new Color(this.color(i)), isThin });
    });
    document.documentElement.dataset.curvePieces = this.stage.setCurves(curves);
  }

  drawEdges() {
    const shows = at('show-intrinsic').checked && this.playback !== null;
    if (shows && this.quietRun !== this.runNumber) {
      this.quietRun = this.runNumber;
      this.stage.setQuietEdges(this.run);
    }
    const pieces = shows ? this.playback.piecesOf(this.playback.edges) : [];
    const fresh = shows ? this.playback.piecesOf(this.playback.fresh) : [];
    document.documentElement.dataset.edgePieces = this.stage.setEdges(pieces, fresh, shows);
  }

  play() {
    if (!this.playback || this.playback.length === 0) return;
    if (this.playback.step === this.playback.length) this.goTo(0);
    at('show-intrinsic').checked = true;
    at('play').textContent = '||';
    at('play').setAttribute('aria-label', 'Pause');
    // A short record takes half a second per step, a long one twenty seconds in all; at the speed that is chosen.
    const share = 1 / Number(at('speed').value);
    const period = Math.max(16, share * Math.min(500, 20000 / this.playback.length));
    const stride = Math.max(1, Math.ceil((16 * this.playback.length) / (20000 * share)));
    this.timer = setInterval(() => {
      this.goTo(this.playback.step + stride);
      if (this.playback.step === this.playback.length) this.pause();
    }, period);
  }

  pause() {
    clearInterval(this.timer);
    this.timer = undefined;
    at('play').textContent = '\u25B6';
    at('play').setAttribute('aria-label', 'Play');
  }

  togglePlay() {
    if (this.timer) this.pause();
    else this.play();
  }

  stepBy(count) {
    this.pause();
    if (this.playback) this.goTo(this.playback.step + count);
  }

  toggle(id) {
    if (at(id).disabled) return;
    at(id).checked = !at(id).checked;
    at(id).dispatchEvent(new Event('change'));
  }

  listen() {
    const actions = {
      'to-start': () => this.stepBy(-Infinity), 'step-back': () => this.stepBy(-1), play: () => this.togglePlay(),
      'step-on': () => this.stepBy(1), 'to-end': () => this.stepBy(Infinity), reset: () => this.stage.reset(),
      theme: () => this.switchTheme(), focus: () => this.focus(),
    };
    for (const [id, action] of Object.entries(actions)) at(id).addEventListener('click', action);
    at('step').addEventListener('input', () => this.stepBy(Number(at('step').value) - this.playback.step));
    at('show-intrinsic').addEventListener('change', () => this.drawEdges());
    at('show-start').addEventListener('change', () => this.drawStart());
    at('speed').addEventListener('change', () => {
      if (!this.timer) return;
      this.pause();
      this.play();
    });
    at('show-mesh').addEventListener('change', () => this.stage.showMeshEdges(at('show-mesh').checked));
    at('show-hidden').addEventListener('change', () => this.stage.setShowsHidden(at('show-hidden').checked));
    at('smooth').addEventListener('change', () => this.stage.setSmooth(at('smooth').checked));
    this.listenToClicks(at('view'));
    addEventListener('keydown', (event) => this.onKey(event));
    addEventListener('hashchange', () => this.obeyAddress());
  }

  // A click on a curve picks it, as one on its line in the legend does.
  listenToClicks(canvas) {
    let pressed = [0, 0];
    canvas.addEventListener('pointerdown', (event) => (pressed = [event.clientX, event.clientY]));
    canvas.addEventListener('click', ({ clientX, clientY }) => {
      if (Math.hypot(clientX - pressed[0], clientY - pressed[1]) > 4) return;
      const i = this.curveAt(clientX, clientY);
      if (i >= 0) this.chooseRun(this.scene.curves[i].run, i);
    });
  }

  // The curve that is drawn within some pixels of a point of the window, or -1.
  curveAt(x, y) {
    let [nearest, least] = [-1, 8];
    this.scene.curves.forEach((_, i) => {
      const distance = this.shown[i] ? this.stage.distanceTo(x, y, this.curvePieces(i)) : Infinity;
      if (distance < least) [nearest, least] = [i, distance];
    });
    return nearest;
  }

  switchTheme() {
    this.chooseTheme(this.theme === 'dark' ? 'light' : 'dark');
    this.drawCurves();
  }

  focus() {
    if (this.curve < this.scene.curves.length) this.stage.goTo(this.curvePieces(this.curve));
  }

  onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const angle = Math.PI / 24;
    const keys = {
      ArrowLeft: () => this.stage.turn(-angle, 0), ArrowRight: () => this.stage.turn(angle, 0),
      ArrowUp: () => this.stage.turn(0, -angle), ArrowDown: () => this.stage.turn(0, angle),
      '+': () => this.stage.zoom(1 / 1.15), '=': () => this.stage.zoom(1 / 1.15), '-': () => this.stage.zoom(1.15),
      ',': () => this.stepBy(-1), '.': () => this.stepBy(1), Home: () => this.stepBy(-Infinity),
      End: () => this.stepBy(Infinity), ' ': () => this.togglePlay(), e: () => this.toggle('show-intrinsic'),
      g: () => this.toggle('show-start'),
      m: () => this.toggle('show-mesh'), h: () => this.toggle('show-hidden'), s: () => this.toggle('smooth'),
      r: () => this.stage.reset(), t: () => this.switchTheme(), f: () => this.focus(),
    };
    const action = keys[event.key];
    // The slider has its own arrows, and a button or a box its own space.
    const { target } = event;
    const isOwn = target.tagName === 'INPUT' ? (target.type === 'range' ? /Arrow|Home|End/ : / /) : target.tagName === 'BUTTON' ? / / : /$^/;
    if (!action || isOwn.test(event.key)) return;
    event.preventDefault();
    action();
  }
}

async function start() {
  try {
    const page = new Page(await readScene(at('scene').textContent));
    at('scene').textContent = ''; // free the text of large meshes
    at('message').textContent = hasWebGL() ? '' : 'This browser does not support WebGL 2, so the surface and the curves are not drawn.';
    page.stage.draw();
    document.documentElement.dataset.state = 'ready';
  } catch (error) {
    document.documentElement.dataset.state = 'failed';
    at('message').textContent = `The page cannot be shown: ${error.message}`;
  }
}

// The browser paints the message first: decoding a large mesh takes a moment.
requestAnimationFrame(() => setTimeout(start, 0));
