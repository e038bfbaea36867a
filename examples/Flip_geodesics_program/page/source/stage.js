// SPDX-License-Identifier: LGPL-3.0-or-later

import {
  AmbientLight,
  Box3,
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Color,
  DirectionalLight,
  DoubleSide,
  Float32BufferAttribute,
  GreaterDepth,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  NotEqualStencilFunc,
  PerspectiveCamera,
  Points,
  PointsMaterial,
  ReplaceStencilOp,
  Scene,
  Vector3,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { TrackballControls } from 'three/examples/jsm/controls/TrackballControls.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

const mostThickPieces = 300000; // curves with more straight pieces are drawn as thin lines, which is much faster
const curveWidth = 4; // in pixels of the style sheet, as all widths
const themes = {
  light: { back: '#ffffff', surface: '#c9ced6', mesh: '#5d6670', edges: '#2b3440', fresh: '#00855f', start: '#e08a00' },
  dark: { back: '#14171b', surface: '#7e8791', mesh: '#20252b', edges: '#dbe7f5', fresh: '#2fd0a5', start: '#ffb545' },
};

export const hasWebGL = () => document.createElement('canvas').getContext('webgl2') !== null;

// All edges of the triangles once, as pairs of vertices, but for those in `without`: an edge and its vertices in a row.
function uniqueEdges(corners, vertices, without) {
  const keys = new Float64Array(corners.length);
  const key = (a, b) => Math.min(a, b) * vertices + Math.max(a, b);
  for (let i = 0; i < corners.length; i += 3)
    for (let k = 0; k < 3; ++k) keys[i + k] = key(corners[i + k], corners[i + ((k + 1) % 3)]);
  keys.sort();
  const excluded = new Set();
  for (let i = 0; i < without.length; i += 3) excluded.add(key(without[i + 1], without[i + 2]));
  const pairs = new Uint32Array(2 * keys.length);
  let count = 0;
  for (let i = 0; i < keys.length; ++i) {
    if ((i > 0 && keys[i] === keys[i - 1]) || excluded.has(keys[i])) continue;
    pairs[count++] = Math.floor(keys[i] / vertices);
    pairs[count++] = keys[i] % vertices;
  }
  return pairs.slice(0, count);
}

function disk() {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 32;
  const context = canvas.getContext('2d');
  context.fillStyle = '#fff';
  context.arc(16, 16, 15, 0, 2 * Math.PI);
  context.fill();
  return new CanvasTexture(canvas);
}

// The pieces of curves one after the other, and the colors of their ends.
function joined(curves) {
  const count = curves.reduce((sum, curve) => sum + curve.pieces.length, 0);
  const pieces = new Float32Array(count);
  const colors = new Float32Array(count);
  let next = 0;
  for (const curve of curves) {
    const { r, g, b } = curve.color;
    pieces.set(curve.pieces, next);
    for (const end = next + curve.pieces.length; next < end; next += 3) colors.set([r, g, b], next);
  }
  return { pieces, colors };
}

/*
 * The surface, the lines on it, and the camera. Lines do not fight with the surface for the same depth, since the
 * surface is drawn a little behind where it is: by as much as it recedes over the width of a line.
 */
export class Stage {
  constructor(canvas, scene) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, stencil: true, preserveDrawingBuffer: true });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 100);
    this.scene.add(this.camera);
    this.addLights();
    this.addSurface(scene);
    this.addLines();
    this.controls = new TrackballControls(this.camera, canvas);
    this.controls.staticMoving = true;
    this.controls.rotateSpeed = 3;
    this.controls.keys = ['', '', ''];
    this.controls.minDistance = 0.02;
    this.controls.maxDistance = 20;
    this.controls.addEventListener('change', () => this.requestFrame());
    for (const event of ['pointermove', 'pointerdown', 'pointerup', 'wheel'])
      canvas.addEventListener(event, () => requestAnimationFrame(() => this.controls.update()), { passive: true });
    this.resize();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  addLights() {
    this.scene.add(new AmbientLight('#ffffff', 1.0));
    const lamp = new DirectionalLight('#ffffff', 2.2);
    lamp.position.set(-0.6, 0.8, 1.4);
    this.camera.add(lamp);
    this.camera.add(lamp.target);
    lamp.target.position.set(0, 0, -1);
  }

  addSurface(scene) {
    this.surface = new Mesh(new BufferGeometry(), new MeshLambertMaterial({ side: DoubleSide, flatShading: true }));
    this.surface.material.polygonOffset = true;
    this.surface.material.polygonOffsetUnits = 4;
    this.scene.add(this.surface);
    this.setSurface(scene);
  }

  // Another surface takes the place of this one, in the same context: a browser has few of them, and collects them late.
  setSurface(scene) {
    this.data = scene;
    this.positions = new BufferAttribute(scene.positions, 3);
    this.surface.geometry.dispose();
    this.surface.geometry = new BufferGeometry();
    this.surface.geometry.setAttribute('position', this.positions);
    this.surface.geometry.setIndex(new BufferAttribute(scene.corners, 1));
    this.meshEdgeCount = undefined; // its edges are made when they are shown
  }

  // Drawn in the order in which they are made, so that curves cover edges.
  addLines() {
    let order = 0;
    const wires = (opacity) => {
      const lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity }));
      lines.visible = false;
      lines.renderOrder = ++order;
      this.scene.add(lines);
      return lines;
    };
    const thick = (linewidth, options) => {
      // In front of what was made before, which runs along or through them.
      const offset = { polygonOffset: true, polygonOffsetFactor: 0, polygonOffsetUnits: -8 * ++order };
      const lines = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ linewidth, ...offset, ...options }));
      lines.frustumCulled = false;
      lines.renderOrder = order;
      this.scene.add(lines);
      return lines;
    };
    this.meshWires = wires(0.3);
    this.quietWires = wires(0.25); // the intrinsic edges that are edges of the mesh all the time
    this.edges = thick(1.2, {});
    this.freshEdges = thick(2.2, {});
    this.start = thick(2.2, { dashed: true, dashSize: 0.018, gapSize: 0.012 });
    this.thinCurves = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true }));
    this.thinCurves.renderOrder = ++order;
    this.scene.add(this.thinCurves);
    this.curves = thick(curveWidth, { vertexColors: true });
    this.hiddenCurves = thick(curveWidth - 1, {
      vertexColors: true,
      transparent: true,
      opacity: 0.3,
      depthFunc: GreaterDepth,
      depthWrite: false,
      stencilWrite: true, // pieces overlap at their ends, which would show
      stencilFunc: NotEqualStencilFunc,
      stencilRef: 1,
      stencilZPass: ReplaceStencilOp,
    });
    this.ends = new Points(
      new BufferGeometry(),
      new PointsMaterial({ size: 10, sizeAttenuation: false, vertexColors: true, map: disk(), alphaTest: 0.5 }),
    );
    this.ends.frustumCulled = false;
    this.ends.renderOrder = ++order;
    // A disk faces the camera; without a push towards it, the surface would cut through.
    this.ends.material.onBeforeCompile = (shader) => {
      const place = '#include <logdepthbuf_vertex>';
      const nearer = 'gl_Position = projectionMatrix * vec4(0.994 * mvPosition.xyz, mvPosition.w);';
      shader.vertexShader = shader.vertexShader.replace(place, `${nearer}\n${place}`);
    };
    this.scene.add(this.ends);
  }

  setTheme(name) {
    const theme = themes[name];
    this.scene.background = new Color(theme.back);
    this.surface.material.color.set(theme.surface);
    this.meshWires.material.color.set(theme.mesh);
    this.quietWires.material.color.set(theme.edges);
    this.edges.material.color.set(theme.edges);
    this.freshEdges.material.color.set(theme.fresh);
    this.start.material.color.set(theme.start);
    this.requestFrame();
  }

  // Do few corners have a vertex normal far from the face's own? Then there are no sharp edges to show.
  isSmooth() {
    const { geometry } = this.surface;
    geometry.computeVertexNormals();
    const { normal } = geometry.attributes;
    const { corners } = this.data;
    const [a, b, c, n] = [0, 0, 0, 0].map(() => new Vector3());
    let sharp = 0;
    for (let i = 0; i < corners.length; i += 3) {
      a.fromBufferAttribute(this.positions, corners[i]);
      b.fromBufferAttribute(this.positions, corners[i + 1]).sub(a);
      c.fromBufferAttribute(this.positions, corners[i + 2]).sub(a);
      b.cross(c).normalize();
      for (let k = 0; k < 3; ++k) if (n.fromBufferAttribute(normal, corners[i + k]).dot(b) < 0.8) ++sharp;
    }
    return sharp < 0.01 * corners.length;
  }

  setSmooth(isSmooth) {
    this.surface.material.flatShading = !isSmooth;
    this.surface.material.needsUpdate = true;
    this.requestFrame();
  }

  // `pieces`: ends of straight pieces, six numbers each. Returns how many there are.
  static setPieces(lines, pieces, colors) {
    lines.geometry.dispose();
    lines.geometry = new LineSegmentsGeometry();
    lines.visible = pieces.length > 0;
    if (pieces.length === 0) return 0;
    lines.geometry.setPositions(pieces);
    if (colors) lines.geometry.setColors(colors);
    return pieces.length / 6;
  }

  // curves: objects with `pieces`, `color` (a Color), the points `ends`, and `isThin` for lines a pixel wide.
  setCurves(curves) {
    const count = curves.reduce((sum, curve) => sum + curve.pieces.length, 0);
    const ends = [];
    const endColors = [];
    for (const curve of curves) {
      const { r, g, b } = curve.color;
      ends.push(...curve.ends);
      for (let i = 0; i < curve.ends.length; i += 3) endColors.push(r, g, b);
    }
    const isThin = (curve) => Boolean(curve.isThin) || count / 6 > mostThickPieces;
    const thick = joined(curves.filter((curve) => !isThin(curve)));
    const thin = joined(curves.filter(isThin));
    const segments = Stage.setPieces(this.curves, thick.pieces, thick.colors);
    this.thinCurves.geometry.dispose();
    this.thinCurves.geometry = new BufferGeometry();
    this.thinCurves.geometry.setAttribute('position', new BufferAttribute(thin.pieces, 3));
    this.thinCurves.geometry.setAttribute('color', new BufferAttribute(thin.colors, 3));
    this.hiddenCurves.geometry = this.curves.geometry;
    this.hiddenCurves.visible = this.showsHidden && segments > 0;
    this.ends.geometry.dispose();
    this.ends.geometry = new BufferGeometry();
    this.ends.geometry.setAttribute('position', new Float32BufferAttribute(ends, 3));
    this.ends.geometry.setAttribute('color', new Float32BufferAttribute(endColors, 3));
    this.requestFrame();
    return count / 6;
  }

  // Where the curves of a run have started, with dashes.
  setStart(pieces) {
    const count = Stage.setPieces(this.start, pieces);
    if (count > 0) this.start.computeLineDistances();
    this.requestFrame();
    return count;
  }

  setShowsHidden(shows) {
    this.showsHidden = shows;
    this.hiddenCurves.visible = shows && this.curves.visible;
    this.requestFrame();
  }

  setWires(lines, without) {
    const pairs = uniqueEdges(this.data.corners, this.data.vertices, without);
    lines.geometry.dispose();
    lines.geometry = new BufferGeometry();
    lines.geometry.setAttribute('position', this.positions);
    lines.geometry.setIndex(new BufferAttribute(pairs, 1));
    return pairs.length / 2;
  }

  showMeshEdges(shows) {
    this.meshEdgeCount ??= shows ? this.setWires(this.meshWires, []) : undefined;
    this.meshWires.visible = shows;
    this.requestFrame();
  }

  // The edges of the mesh that no step of a run touches, which are set once for it.
  setQuietEdges({ inputEdges }) {
    this.setWires(this.quietWires, inputEdges);
  }

  setEdges(pieces, freshPieces, areShown) {
    this.quietWires.visible = areShown;
    const count = Stage.setPieces(this.edges, areShown ? pieces : []);
    Stage.setPieces(this.freshEdges, areShown ? freshPieces : []);
    this.requestFrame();
    return count;
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.surface.material.polygonOffsetFactor = (curveWidth / 2) * window.devicePixelRatio + 1;
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.controls.handleResize();
    if (this.view && this.camera.position.equals(this.view.position)) this.lookFrom(this.view.direction);
    this.requestFrame();
  }

  requestFrame() {
    if (this.isRequested) return;
    this.isRequested = true;
    requestAnimationFrame(() => {
      this.isRequested = false;
      this.draw();
    });
  }

  draw() {
    const distance = this.camera.position.length();
    this.camera.near = Math.max(0.002, distance - 1.5);
    this.camera.far = distance + 1.5;
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
  }

  // Puts the camera as close as the whole mesh can be seen, in `direction` from its center. It stays so when the window is
  // resized, until the camera is moved.
  lookFrom(direction) {
    const up = Math.abs(direction.y) > 0.99 ? new Vector3(0, 0, -1) : new Vector3(0, 1, 0);
    const right = new Vector3().crossVectors(up, direction).normalize();
    const above = new Vector3().crossVectors(direction, right);
    const vertical = Math.tan((this.camera.fov * Math.PI) / 360);
    const horizontal = vertical * this.camera.aspect;
    const p = new Vector3();
    const stride = Math.max(1, Math.floor(this.data.vertices / 50000));
    let distance = 0.05;
    for (let v = 0; v < this.data.vertices; v += stride) {
      p.fromBufferAttribute(this.positions, v);
      const needed = Math.max(Math.abs(p.dot(right)) / horizontal, Math.abs(p.dot(above)) / vertical);
      distance = Math.max(distance, needed + p.dot(direction));
    }
    this.camera.up.copy(up);
    this.camera.position.copy(direction).multiplyScalar(1.06 * distance);
    this.controls.target.set(0, 0, 0);
    this.camera.lookAt(0, 0, 0);
    this.controls.update();
    this.view = { direction: direction.clone(), position: this.camera.position.clone() };
    this.requestFrame();
  }

  // The direction from which most of the curves is seen, of a few; tried out in a small picture.
  findHome() {
    const candidates = [
      ...this.outside(),
      [0.45, 0.35, 1], [-0.45, 0.35, 1], [1, 0.35, 0.45], [-1, 0.35, -0.45], [0.45, 0.35, -1], [0.3, 1, 0.6],
      [1, 0.35, -0.6], [-1, 0.35, 0.6], [0.3, -1, 0.6],
    ].map((v) => new Vector3(...v).normalize());
    [this.homeDirection] = candidates;
    if (this.curves.visible) {
      const visible = candidates.map((direction) => this.countVisible(direction));
      const most = Math.max(...visible);
      this.homeDirection = candidates[visible.findIndex((count) => count >= 0.9 * most)];
    }
    this.reset();
  }

  countVisible(direction) {
    const size = 160;
    this.target ??= new WebGLRenderTarget(size, size);
    this.lookFrom(direction);
    const probe = new Scene();
    const black = new MeshBasicMaterial({ color: 0, side: DoubleSide, polygonOffset: true });
    Object.assign(black, { polygonOffsetFactor: 2, polygonOffsetUnits: 4 });
    const line = new LineSegments2(this.curves.geometry, new LineMaterial({ linewidth: 1.5, color: 0xffffff }));
    line.frustumCulled = false;
    probe.add(new Mesh(this.surface.geometry, black), line);
    this.camera.updateMatrixWorld();
    this.renderer.setRenderTarget(this.target);
    this.renderer.render(probe, this.camera);
    const pixels = new Uint8Array(4 * size * size);
    this.renderer.readRenderTargetPixels(this.target, 0, 0, size, size, pixels);
    this.renderer.setRenderTarget(null);
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) count += pixels[i] > 127 ? 1 : 0;
    for (const material of [black, line.material]) material.dispose();
    return count;
  }

  // Where in the window a point is, of the three coordinates behind an index.
  project(points, i = 0, box = this.canvas.getBoundingClientRect()) {
    const p = new Vector3().fromArray(points, i).project(this.camera);
    return [box.left + ((p.x + 1) * box.width) / 2, box.top + ((1 - p.y) * box.height) / 2];
  }

  // How far a point of the window is from pieces as they are drawn, in pixels.
  distanceTo(x, y, pieces) {
    const box = this.canvas.getBoundingClientRect();
    let least = Infinity;
    for (let i = 0; i < pieces.length; i += 6) {
      const [ax, ay] = this.project(pieces, i, box);
      const [bx, by] = this.project(pieces, i + 3, box);
      const [dx, dy] = [bx - ax, by - ay];
      const square = dx * dx + dy * dy;
      const t = square > 0 ? Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
      least = Math.min(least, Math.hypot(ax + t * dx - x, ay + t * dy - y));
    }
    return least;
  }

  // The mean normal, if most of the surface faces one side: an open one is looked at from outside.
  outside() {
    const { corners } = this.data;
    const [a, b, c, sum] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
    let area = 0;
    for (let i = 0; i < corners.length; i += 3) {
      a.fromBufferAttribute(this.positions, corners[i]);
      b.fromBufferAttribute(this.positions, corners[i + 1]).sub(a);
      c.fromBufferAttribute(this.positions, corners[i + 2]).sub(a);
      sum.add(b.cross(c));
      area += b.length();
    }
    return sum.length() > 0.2 * area ? [sum.normalize().toArray()] : [];
  }

  // Goes close to some points, in the direction of now.
  goTo(points) {
    if (points.length === 0) return;
    const box = new Box3().setFromArray(points);
    const { target } = this.controls;
    const direction = this.camera.position.clone().sub(target).normalize();
    const fit = Math.sin((this.camera.fov * Math.PI) / 360) * Math.min(1, this.camera.aspect);
    box.getCenter(target);
    this.camera.position.copy(target).addScaledVector(direction, Math.max(0.05, box.getSize(new Vector3()).length() / 2 / fit));
    this.controls.update();
    this.requestFrame();
  }

  reset() {
    this.lookFrom(this.homeDirection);
  }

  // Turns the camera about the center by angles about the screen's vertical and horizontal axes.
  turn(aroundVertical, aroundHorizontal) {
    const { camera } = this;
    const right = new Vector3(1, 0, 0).applyQuaternion(camera.quaternion);
    const above = new Vector3(0, 1, 0).applyQuaternion(camera.quaternion);
    const arm = camera.position.clone().sub(this.controls.target);
    for (const [axis, angle] of [[above, aroundVertical], [right, aroundHorizontal]]) {
      arm.applyAxisAngle(axis, angle);
      camera.up.applyAxisAngle(axis, angle);
    }
    camera.position.copy(this.controls.target).add(arm);
    camera.lookAt(this.controls.target);
    this.controls.update();
    this.requestFrame();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.requestFrame();
  }
}
