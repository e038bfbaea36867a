// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Puts the parts of the interactive viewer together: the engine, the curves, the stage and the panel.

import { Color, Vector3 } from 'three';
import { curvePieces, readMesh, readResults } from '../source/data.js';
import { hasWebGL } from '../source/stage.js';
import { Canvas_input } from './canvas_input.js';
import { Computation } from './computation.js';
import { Curve_list } from './curve_list.js';
import { levelOf, pointText, tools } from './curve_tools.js';
import { Engine } from './engine.js';
import { exampleMesh } from './example_mesh.js';
import { Live_stage } from './live_stage.js';
import { at, Panel } from './panel.js';
import { Player } from './player.js';
import { distance, middle } from './polyline.js';
import { format, roundNumber, withUnit } from './units.js';

// After the set of Okabe and Ito for the color-blind, darker or lighter than the surface.
const palettes = {
  light: { curves: ['#0b4fb3', '#007a5a', '#a8467f', '#b34700', '#1c7fb0', '#6b5b00'], point: '#d55e00', chosen: '#000000', tree: '#8a5a00' },
  dark: { curves: ['#6fb1ff', '#35d6a6', '#f09cc8', '#ff9a4d', '#8fd3ff', '#f0e442'], point: '#ff9a4d', chosen: '#ffffff', tree: '#e6c067' },
};
const mostRecordedPoints = 300000;
const mostVerticesOfTree = 50000;
const mostLabels = 60;
const longestFrame = 300; // milliseconds that a curve takes, to follow a point at once
const isolinesAtFirst = 16; // over the diameter of the mesh
const canceled = 'canceled';
const mark = (name, value) => (document.documentElement.dataset[name] = value);

class Live_page {
  constructor(engine) {
    this.engine = engine;
    this.selected = -1; // the point that is chosen
    this.shown = new Map(); // the last answer of each curve, until there is a newer one
    this.theme = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
    this.computation = new Computation(engine, {
      wanted: () => this.wanted(),
      onAnswer: (request, answer) => this.onAnswer(request, answer),
      onIdle: () => {
        this.setBusy();
        mark('isIdle', !this.isAiming);
      },
    });
    this.panel = new Panel(this);
    this.player = new Player(() => this.draw());
    this.listenToDrops();
  }

  // Opens a mesh. If that fails or is canceled, everything stays as it is.
  async open({ name, format: extension, bytes }) {
    this.fail('');
    mark('isIdle', false);
    try {
      const text = await this.whileBusy(`reading ${name}`, this.engine.open(extension ? `${name}.${extension}` : name, bytes));
      this.show(readMesh(text), name);
    } catch (error) {
      this.fail(error.message === canceled ? `reading ${name} was canceled` : error.message);
    }
    at('message').textContent = '';
    mark('isIdle', !this.computation.isRunning);
  }

  show(mesh, name) {
    Object.assign(this, { mesh, name, selected: -1 });
    this.list = new Curve_list(this.firstOptions());
    this.computation.forget();
    this.shown.clear();
    if (this.stage) {
      this.stage.setSurface(mesh);
      this.player.show(undefined);
      this.draw();
    } else {
      this.stage = new Live_stage(at('view'), mesh);
      this.input = new Canvas_input(this, at('view'));
    }
    this.setTheme(this.theme);
    this.panel.setMesh(this);
    this.stage.setSmooth(this.stage.isSmooth());
    this.stage.setShowsHidden(at('show-hidden').checked);
    this.stage.showMeshEdges(at('show-mesh').checked);
    this.stage.findHome();
    this.begin();
  }

  firstOptions() {
    const { radius } = this.mesh;
    return { closed: false, bspline: false, snap: false, tree: false, count: 3, angle: 0, length: roundNumber(2 * radius), spacing: roundNumber((2 * radius) / isolinesAtFirst) };
  }

  // Two points in sight, so that there is something to drag.
  begin() {
    const ends = [0.3, 0.7].map((x) => this.stage.pickNear(x, 0.5)).filter(Boolean);
    this.isBeginning = ends.length === 2;
    this.list.changeCurve(this.list.active.id, { points: ends });
    this.list.forget();
    this.update();
  }

  // What is shown and computed follows the list of curves.
  update() {
    this.selected = Math.min(this.selected, this.pointsOf(this.list.active).length - 1);
    mark('isIdle', false);
    this.computation.run();
    this.render();
  }

  get canHaveTree() {
    return this.mesh.vertices <= mostVerticesOfTree;
  }

  optionsOf({ options }) {
    return this.canHaveTree ? options : { ...options, tree: false };
  }

  // The points of a curve: {place, position, text}. A point at a vertex keeps the place where it was set.
  pointsOf({ tool, points, options }) {
    const { isAtVertices, options: own, most } = tools[tool];
    const snaps = isAtVertices || (own.includes('snap') && options.snap);
    return points.slice(0, most).map((place) => {
      if (!snaps) return { place, position: place.position, text: pointText(place, this.stage.cornersOf(place.face)) };
      const nearest = this.stage.nearestVertex(place);
      return { place, position: this.stage.vertex(nearest).toArray(), text: String(nearest) };
    });
  }

  coordinates(position, digits = 4) {
    return withUnit(`(${this.stage.inUnits(position).map((x) => format(x, digits)).join(', ')})`);
  }

  describe({ text, position }) {
    return text.includes(',') ? this.coordinates(position) : `vertex ${text}`;
  }

  requestOf(curve) {
    const { option, least, line, request } = tools[curve.tool];
    const points = this.pointsOf(curve);
    const options = this.optionsOf(curve);
    if (points.length < least(options)) return null;
    const recorded = curve === this.list.active && at('show-intrinsic').checked ? mostRecordedPoints : 0;
    return { id: curve.id, option, line: (request ?? line)(points, options), mostPoints: recorded };
  }

  // A curve that takes long is computed where its point is let go.
  wanted() {
    const { list } = this;
    const isSlow = this.shown.get(list.active.id)?.answer.milliseconds > longestFrame;
    if (this.isDragging && isSlow) return [];
    return [list.active, ...list.curves].map((curve) => this.requestOf(curve)).filter(Boolean);
  }

  // What is known of a curve: until there is an answer for its points, the one before.
  answerOf(curve) {
    const request = this.requestOf(curve);
    if (!request) return null;
    const answer = this.computation.answer(request);
    if (answer) this.shown.set(curve.id, { tool: curve.tool, answer });
    const last = this.shown.get(curve.id);
    return last?.tool === curve.tool ? last.answer : null;
  }

  onAnswer({ id, option }, answer) {
    const curve = this.list.curves.find((c) => c.id === id);
    if (curve && !answer.error && tools[curve.tool].option === option) this.shown.set(id, { tool: curve.tool, answer });
    if (this.isBeginning && answer.error) this.list = new Curve_list(this.firstOptions()); // nobody has chosen the points
    this.isBeginning = false;
    this.render();
  }

  render() {
    const { list } = this;
    const answer = this.answerOf(list.active);
    this.panel.render();
    this.player.show(answer?.results?.runs[0], this.stage);
    this.draw();
    this.setBusy();
    const curves = answer?.results?.curves ?? [];
    const request = this.requestOf(list.active);
    mark('line', request?.line ?? '');
    mark('isCurrent', Boolean(request && this.computation.answer(request)));
    mark('lengths', curves.map((curve) => curve.length).join(' '));
    mark('certificates', curves.map((curve) => curve.certificate).join(' '));
  }

  colorOf({ color, id }) {
    const { curves } = palettes[this.theme];
    return color ?? curves[(id - 1) % curves.length];
  }

  draw() {
    if (!this.list) return;
    const colors = palettes[this.theme];
    const { active, curves } = this.list;
    const answers = curves.map((curve) => [curve, this.answerOf(curve)?.results]).filter(([, results]) => results);
    const map = at('colors').value;
    const values = map ? [active, ...curves].map((curve) => this.answerOf(curve)?.results?.distances).find(Boolean) : undefined;
    this.stage.setValues(values, map);
    mark('farthest', this.stage.greatest);
    const colorOf = (curve, line) => (line.tree ? colors.tree
      : values && !curve.color && levelOf(line) ? this.stage.contrastTo(levelOf(line)) : this.colorOf(curve));
    const lines = answers.flatMap(([curve, results]) => results.curves.map((line, i) => ({
      pieces: this.pieces(curve, results, i), ends: [], color: new Color(colorOf(curve, line)), isThin: line.tree,
    })));
    const ends = curves.flatMap((curve) => this.pointsOf(curve).map(({ position }, i) => ({
      pieces: [], ends: position, color: new Color(curve !== active ? this.colorOf(curve) : i === this.selected ? colors.chosen : colors.point),
    })));
    mark('curvePieces', this.stage.setCurves([...lines, ...ends]));
    this.stage.setLabels(at('show-labels').checked ? answers.flatMap(([, results]) => this.labels(results)).slice(0, mostLabels) : []);
    const shows = Boolean(this.player.playback) && at('show-intrinsic').checked;
    this.stage.setEdges(...(shows ? this.player.edges() : [[], []]), shows);
  }

  // Where one computation has several curves, each has its value: isolines anywhere, paths in their middle third.
  labels({ curves, curvePoints, curveStarts }) {
    if (curves.length < 2) return [];
    return curves.flatMap((curve, i) => {
      if (curve.tree) return [];
      const [start, end] = [curveStarts[i], curveStarts[i + 1]];
      const margin = curve.closed || curve.status === 'ISOLINE' ? 0 : Math.floor((end - start) / 3);
      return [{ text: this.panel.member(curve), points: curvePoints.subarray(3 * (start + margin), 3 * (end - margin)) }];
    });
  }

  pieces(curve, results, i) {
    const isPlayed = curve === this.list.active && this.player.isInTheMiddle;
    return isPlayed ? this.player.playback.curvePieces(i) : curvePieces(results, i);
  }

  // Actions on the list of curves.

  undo() {
    this.list.undo();
    this.update();
  }

  redo() {
    this.list.redo();
    this.update();
  }

  newCurve() {
    const { tool, options } = this.list.active;
    this.list.addCurve(tool, options);
    this.selected = -1;
    this.update();
  }

  removeCurve(id) {
    this.list.removeCurve(id);
    this.update();
  }

  chooseCurve(id) {
    if (id === this.list.active.id) return;
    this.list.choose(id);
    this.selected = -1;
    this.update();
  }

  changeCurve(id, changes, step) {
    this.list.changeCurve(id, changes, step);
    this.update();
  }

  chooseTool(tool) {
    this.list.chooseTool(tool);
    this.update();
  }

  setOption(name, value, step) {
    const { id, options } = this.list.active;
    this.changeCurve(id, { options: { ...options, [name]: value } }, step);
  }

  toggleOption(name) {
    const { tool, options } = this.list.active;
    if (tools[tool].options.includes(name)) this.setOption(name, !options[name]);
  }

  // Actions on the points of the curve that is edited, or of another one.

  setPoints(points, selected, step) {
    this.selected = selected;
    this.changeCurve(this.list.active.id, { points }, step);
  }

  choosePoint(i) {
    if (i === this.selected) return;
    this.selected = i;
    this.render();
  }

  // At the end, or between the two points where the detour is the shortest.
  addPoint(place, isBetween) {
    const { active } = this.list;
    const { most } = tools[active.tool];
    const points = active.points.slice(0, most && most - 1);
    const behind = isBetween && points.length > 1 ? this.nearestGap(place, points) : points.length - 1;
    this.setPoints(points.toSpliced(behind + 1, 0, place), behind + 1);
  }

  nearestGap({ position }, points) {
    const gaps = this.list.active.options.closed ? points : points.slice(0, -1);
    const detours = gaps.map((p, i) => {
      const next = points[(i + 1) % points.length].position;
      return distance(p.position, position) + distance(position, next) - distance(p.position, next);
    });
    return detours.indexOf(Math.min(...detours));
  }

  addInView() {
    const place = this.stage.pickNear(0.5, 0.5);
    if (place) this.addPoint(place, false);
    else this.fail('the surface does not cover the middle of the view; turn the view, or enter a vertex');
  }

  // text: the number of a vertex, or coordinates, for the nearest point of the surface
  addAt(text) {
    const numbers = text.trim().split(/[\s,;]+/).map(Number);
    const isVertex = /^[+-]?\d+$/.test(text.trim()); // as the program reads it: 17.0 can be a coordinate
    const place = isVertex ? this.stage.placeOfVertex(numbers[0])
      : numbers.length === 3 && numbers.every(Number.isFinite) ? this.stage.nearestPlace(this.stage.fromUnits(numbers)) : undefined;
    if (place) return this.addPoint(place, false);
    return this.fail(place === null ? `vertex ${numbers[0]} does not exist or has no faces; enter another one` : 'enter the number of a vertex, or three coordinates');
  }

  // Behind a point, in the middle of the curve to the next one.
  insertBehind(i) {
    const { points } = this.list.active;
    const ends = [points[i].position, points[(i + 1) % points.length].position];
    const results = this.answerOf(this.list.active)?.results;
    const line = results ? results.curvePoints.subarray(0, 3 * results.curveStarts[1]) : new Float32Array(ends.flat());
    const place = this.stage.nearestPlace(new Vector3(...middle(line, ...ends)));
    this.setPoints(points.toSpliced(i + 1, 0, place), i + 1);
  }

  removePoint(i, id = this.list.active.id) {
    const { points } = this.list.curves.find((curve) => curve.id === id);
    if (i < 0 || i >= points.length) return;
    this.chooseCurve(id);
    this.setPoints(points.toSpliced(i, 1), -1);
  }

  movePoint(i, place, step) {
    this.setPoints(this.list.active.points.with(i, place), i, step);
  }

  // A trace keeps its start, and turns towards the place.
  dragPoint(i, place, step) {
    if (this.isTrace) this.aim(place, step);
    else this.movePoint(i, place, step);
  }

  get isTrace() {
    return this.list.active.tool === 'trace';
  }

  turnTrace(degrees) {
    const { id, options } = this.list.active;
    if (degrees !== 0) this.setOption('angle', options.angle + degrees, `turn ${id}`);
  }

  // While the engine computes a direction, the places in between are skipped.
  async aim(place, step) {
    this.aimed = { place, step };
    if (this.isAiming) return;
    this.isAiming = true;
    mark('isIdle', false);
    const { list, engine } = this;
    const { id } = list.active;
    const [source] = this.pointsOf(list.active);
    try {
      for (let next; (next = this.aimed); ) {
        this.aimed = undefined;
        const line = `${source.text} ${pointText(next.place, this.stage.cornersOf(next.place.face))}`;
        const { angle } = readResults(await this.whileBusy('computing', engine.compute({ option: 'direction', line, mostPoints: 0 })));
        if (list === this.list && id === list.active.id) this.setOption('angle', (180 / Math.PI) * angle, next.step);
      }
    } catch (error) {
      this.fail(error.message);
    }
    this.isAiming = false;
    mark('isIdle', !this.computation.isRunning);
  }

  beginDrag() {
    this.isDragging = true;
  }

  endDrag() {
    this.isDragging = false;
    this.update();
  }

  // Computations that take longer are shown, and can be canceled.

  async whileBusy(text, promise) {
    this.busy = { text, started: performance.now() };
    this.setBusy();
    try {
      return await promise;
    } finally {
      this.busy = null;
      this.setBusy();
    }
  }

  setBusy() {
    const busy = this.busy ?? (this.computation.isRunning ? { text: 'computing', started: this.computation.started } : null);
    clearTimeout(this.busyTimer);
    const seconds = busy ? (performance.now() - busy.started) / 1000 : 0;
    at('busy').hidden = seconds < 0.4;
    if (!busy) return;
    at('busy-text').textContent = `${busy.text}, ${seconds.toFixed(0)} s`;
    this.busyTimer = setTimeout(() => this.setBusy(), 500);
  }

  // Returns whether there was something to cancel.
  cancel() {
    if (!this.busy && !this.computation.isRunning) return false;
    this.engine.restart(canceled);
    return true;
  }

  retry() {
    this.computation.retry(this.requestOf(this.list.active));
    this.update();
  }

  setTheme(theme) {
    this.theme = document.documentElement.dataset.theme = theme;
    this.stage.setTheme(theme);
  }

  switchTheme() {
    this.setTheme(this.theme === 'dark' ? 'light' : 'dark');
    this.render();
  }

  listenToDrops() {
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
  }

  async openFile(file) {
    if (file) await this.open({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) });
  }

  command() {
    const { active } = this.list;
    return tools[active.tool].command(this.name, this.pointsOf(active), this.optionsOf(active));
  }

  // A file of points: a line for each curve of the same kind, in the order of the list.
  pointsFile() {
    const { tool } = this.list.active;
    const curves = this.list.curves.filter((curve) => curve.tool === tool && this.requestOf(curve));
    return curves.map((curve) => `${tools[tool].line(this.pointsOf(curve), curve.options)}\n`).join('');
  }

  async contentOf(kind) {
    if (kind === 'png') return this.stage.image();
    if (kind === 'points') return this.pointsFile();
    const requests = this.list.curves.map((curve) => this.requestOf(curve)).filter(Boolean);
    if (requests.length === 0) throw new Error('no curve has enough points to be saved; add points');
    return this.whileBusy('saving', this.engine.save(kind.replace('.txt', ''), requests));
  }

  async save(kind) {
    try {
      const link = document.createElement('a');
      link.href = URL.createObjectURL(new Blob([await this.contentOf(kind)]));
      link.download = kind === 'points' ? 'points.txt' : `${this.name.replace(/\.[^.]*$/, '')}_curves.${kind}`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    } catch (error) {
      this.fail(error.message);
    }
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
  const { name, format: extension, mesh } = JSON.parse(text);
  return { name, format: extension, bytes: Uint8Array.from(atob(mesh), (c) => c.charCodeAt(0)) };
}

async function start() {
  try {
    if (!hasWebGL()) throw new Error('WebGL 2 is not supported');
    const page = new Live_page(await Engine.load(at('engine').textContent));
    at('engine').textContent = '';
    await page.open(firstMesh());
    mark('state', 'ready');
  } catch (error) {
    mark('state', 'failed');
    at('message').textContent = `The page does not work in this browser: ${error.message}`;
  }
}

requestAnimationFrame(() => setTimeout(start, 0));
