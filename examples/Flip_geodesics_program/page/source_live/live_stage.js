// SPDX-License-Identifier: LGPL-3.0-or-later

import { BufferAttribute, CanvasTexture, LinearFilter, Raycaster, Sprite, SpriteMaterial, SRGBColorSpace, Triangle, Vector2, Vector3 } from 'three';
import { Stage } from '../source/stage.js';
import { format, roundNumber, unit, withUnit } from './units.js';

const labelHeight = 22; // in pixels
const widestScale = 140;
const widthOfColors = 240;
// Maps of increasing lightness, which the color-blind can read, too.
const colorMaps = {
  violet: ['#380a5a', '#2b4688', '#017b95', '#0fad94', '#83d675', '#f9ed52'],
  blue: ['#082256', '#546178', '#aaa377', '#ffea6e'],
  gray: ['#222222', '#f0f0f0'],
};
const [colorCount, grayCount] = [256, 8]; // in the texture: those of a map, and those of vertices without a value

function labelTexture(text) {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  const font = `${2 * labelHeight - 14}px system-ui, sans-serif`; // twice as large as shown, for sharp screens
  context.font = font;
  canvas.width = Math.ceil(context.measureText(text).width) + 16;
  canvas.height = 2 * labelHeight;
  context.font = font;
  context.fillStyle = '#ffffffd0';
  context.fillRect(0, 4, canvas.width, canvas.height - 8);
  context.fillStyle = '#1c2127';
  context.fillText(text, 8, 1.5 * labelHeight);
  return new CanvasTexture(canvas);
}

function colorTexture(colors) {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [colorCount + grayCount, 1];
  const context = canvas.getContext('2d');
  const gradient = context.createLinearGradient(0, 0, colorCount, 0);
  colors.forEach((color, i) => gradient.addColorStop(i / (colors.length - 1), color));
  context.fillStyle = gradient;
  context.fillRect(0, 0, colorCount, 1);
  context.fillStyle = '#9a9a9a';
  context.fillRect(colorCount, 0, grayCount, 1);
  return Object.assign(new CanvasTexture(canvas), { colorSpace: SRGBColorSpace, minFilter: LinearFilter, generateMipmaps: false });
}

/*
 * A stage on which places of the surface are picked. A place is {face, weights, position}. Curves may have labels, the
 * surface may have colors by values at its vertices, and a legend shows the scale and the colors.
 */
export class Live_stage extends Stage {
  constructor(canvas, scene) {
    super(canvas, scene);
    this.labels = [];
    this.legend = document.createElement('canvas');
    this.legend.id = 'scale';
    canvas.after(this.legend);
  }

  setSurface(scene) {
    super.setSurface(scene);
    this.themeColor ??= this.surface.material.color.clone();
    this.setValues(undefined);
  }

  setTheme(name) {
    super.setTheme(name);
    this.themeColor = this.surface.material.color.clone();
    this.setColors();
  }

  // Colors the surface by values of the vertices, from zero to the greatest, by the map of this name. Without values it has
  // the color of the theme.
  setValues(values, map) {
    if (values !== this.values) {
      const finite = values?.filter(Number.isFinite) ?? [];
      this.greatest = finite.reduce((a, b) => Math.max(a, b), 0);
      const uv = new Float32Array(2 * (values?.length ?? 0));
      values?.forEach((x, i) => {
        const texel = Number.isFinite(x) ? 0.5 + (x / (this.greatest || 1)) * (colorCount - 1) : colorCount + grayCount / 2;
        uv[2 * i] = texel / (colorCount + grayCount);
      });
      this.surface.geometry.setAttribute('uv', new BufferAttribute(uv, 2));
    }
    if (values === this.values && map === this.map) return;
    [this.values, this.map] = [values, map];
    this.setColors();
  }

  setColors() {
    const { material } = this.surface;
    material.map?.dispose();
    material.map = material.emissiveMap = this.values ? colorTexture(colorMaps[this.map]) : null;
    // Shading changes the lightness, which shows the value, by less than it does without colors.
    material.emissive.setScalar(this.values ? 0.6 : 0);
    if (this.values) material.color.setScalar(0.4);
    else material.color.copy(this.themeColor);
    material.needsUpdate = true;
    this.requestFrame();
  }

  // The place of the surface at a point of the window that is nearest to the eye, or null.
  pick(x, y) {
    const box = this.canvas.getBoundingClientRect();
    const at = new Vector2((2 * (x - box.left)) / box.width - 1, 1 - (2 * (y - box.top)) / box.height);
    this.camera.updateMatrixWorld();
    const ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    const [hit] = ray.intersectObject(this.surface, false);
    return hit ? this.place(hit.faceIndex, hit.point) : null;
  }

  // The place that is seen nearest to a point, in shares of the width and height of the view, or null.
  pickNear(x, y) {
    const box = this.canvas.getBoundingClientRect();
    for (let radius = 0; radius < 0.5; radius += 0.03)
      for (let k = 0; k < (radius === 0 ? 1 : 8); ++k) {
        const [dx, dy] = [Math.cos((k * Math.PI) / 4), Math.sin((k * Math.PI) / 4)].map((d) => d * radius * box.height);
        const place = this.pick(box.left + x * box.width + dx, box.top + y * box.height + dy);
        if (place) return place;
      }
    return null;
  }

  // The place nearest to a point in space.
  nearestPlace(point) {
    const [triangle, closest, best] = [new Triangle(), new Vector3(), new Vector3()];
    let [face, least] = [0, Infinity];
    for (let f = 0; f < this.data.triangles; ++f) {
      triangle.set(...this.cornersOf(f).map((v) => this.vertex(v)));
      const distance = triangle.closestPointToPoint(point, closest).distanceToSquared(point);
      if (distance >= least) continue;
      [face, least] = [f, distance];
      best.copy(closest);
    }
    return this.place(face, best);
  }

  // The place of a vertex, or null if it is in no face.
  placeOfVertex(v) {
    const corner = this.data.corners.indexOf(v);
    return corner < 0 ? null : this.place(Math.floor(corner / 3), this.vertex(v));
  }

  place(face, point) {
    const corners = this.cornersOf(face);
    const points = corners.map((v) => this.vertex(v));
    const weights = Triangle.getBarycoord(point, ...points, new Vector3());
    return { face, weights: weights ? weights.toArray() : [1, 0, 0], position: point.toArray() };
  }

  vertex(v) {
    return new Vector3().fromBufferAttribute(this.positions, v);
  }

  cornersOf(face) {
    return [...this.data.corners.subarray(3 * face, 3 * face + 3)];
  }

  // The corner of its face that is nearest to a place.
  nearestVertex({ face, weights }) {
    return this.cornersOf(face)[weights.indexOf(Math.max(...weights))];
  }

  // From coordinates of the page to those of the mesh file, in the unit of the user, and back.
  inUnits(position) {
    return position.map((x, i) => unit.factor * (x * this.data.radius + this.data.center[i]));
  }

  fromUnits(coordinates) {
    return new Vector3(...coordinates.map((x, i) => (x / unit.factor - this.data.center[i]) / this.data.radius));
  }

  // The camera may have moved since the last frame.
  project(position) {
    this.camera.updateMatrixWorld();
    return super.project(position);
  }

  // Is a point in front of what is drawn there?
  isVisible(position) {
    const hit = this.pick(...this.project(position));
    if (!hit) return true;
    const distance = (p) => this.camera.position.distanceTo(new Vector3(...p));
    return distance(position) < distance(hit.position) + 0.01;
  }

  // Turns the camera to the side of the surface on which a place is.
  face({ face }) {
    const [a, b, c] = this.cornersOf(face).map((v) => this.vertex(v));
    this.lookFrom(new Triangle(a, b, c).getNormal(new Vector3()));
  }

  // labels: objects with `text` and the points of the curve that they belong to, three numbers each
  setLabels(labels) {
    const isSame = ({ text, points }, i) => text === this.labels[i].text && points.buffer === this.labels[i].points.buffer;
    if (labels.length === this.labels.length && labels.every(isSame)) return;
    for (const { sprite } of this.labels) {
      this.scene.remove(sprite);
      sprite.material.map.dispose();
      sprite.material.dispose();
    }
    this.labels = labels.map(({ text, points }) => {
      const sprite = new Sprite(new SpriteMaterial({ map: labelTexture(text), sizeAttenuation: false, depthTest: false }));
      sprite.renderOrder = 100;
      this.scene.add(sprite);
      return { sprite, text, points };
    });
    this.requestFrame();
  }

  // Each label is at the point of its curve that is nearest to the camera.
  placeLabels() {
    const unit = (2 * Math.tan((this.camera.fov * Math.PI) / 360)) / this.canvas.clientHeight;
    const p = new Vector3();
    for (const { sprite, points } of this.labels) {
      const { width, height } = sprite.material.map.image;
      sprite.scale.set((unit * labelHeight * width) / height, unit * labelHeight, 1);
      let least = Infinity;
      for (let i = 0; i < points.length; i += 3) {
        const distance = p.fromArray(points, i).distanceToSquared(this.camera.position);
        if (distance >= least) continue;
        least = distance;
        sprite.position.copy(p);
      }
    }
  }

  draw() {
    this.placeLabels();
    super.draw();
    this.drawLegend();
  }

  // A round length, and how wide it is at the distance of the center of the view.
  scale() {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const perPixel = (unit.factor * this.data.radius * distance * 2 * Math.tan((this.camera.fov * Math.PI) / 360)) / this.canvas.clientHeight;
    const length = roundNumber(widestScale * perPixel);
    return { pixels: length / perPixel, text: withUnit(length) };
  }

  // Black or white, whichever differs more from the color of a value.
  contrastTo(value) {
    return value < this.greatest / 2 ? '#ffffff' : '#000000';
  }

  // Values at which the bar of the colors has marks: {text, at}, the latter a share of its width.
  marks() {
    const greatest = this.greatest * unit.factor;
    const step = roundNumber(greatest / 2);
    return Array.from({ length: Math.floor(greatest / step) + 1 }, (_, i) => ({ text: format(i * step), at: (i * step) / greatest }));
  }

  drawLegend() {
    const { legend } = this;
    const hasColors = Boolean(this.values) && this.greatest > 0;
    const [width, height] = [widthOfColors + 60, hasColors ? 75 : 25];
    const ratio = window.devicePixelRatio;
    Object.assign(legend, { width: width * ratio, height: height * ratio });
    Object.assign(legend.style, { width: `${width}px`, height: `${height}px` });
    const context = legend.getContext('2d');
    context.scale(ratio, ratio);
    context.font = '13px system-ui, sans-serif';
    context.fillStyle = getComputedStyle(legend).color;
    const { pixels, text } = this.scale();
    context.fillText(text, 0, height - 8);
    context.fillRect(0, height - 3, pixels, 3);
    legend.textContent = text;
    if (!hasColors) return;
    context.drawImage(this.surface.material.map.image, 0, 0, colorCount, 1, 0, 0, widthOfColors, 12);
    const marks = this.marks();
    marks.forEach((mark, i) => {
      context.fillRect(mark.at * widthOfColors, 12, 1, 4);
      context.textAlign = i === 0 ? 'left' : 'center';
      context.fillText(i + 1 < marks.length ? mark.text : withUnit(mark.text), mark.at * widthOfColors, 29);
    });
    legend.textContent += `; colors from 0 to ${withUnit(format(this.greatest * unit.factor, 4))}`;
  }

  // The view as a PNG, with the legend.
  image() {
    this.draw();
    const image = document.createElement('canvas');
    [image.width, image.height] = [this.canvas.width, this.canvas.height];
    const context = image.getContext('2d');
    context.drawImage(this.canvas, 0, 0);
    const margin = 16 * window.devicePixelRatio;
    context.drawImage(this.legend, margin, image.height - this.legend.height - margin);
    return new Promise((done) => image.toBlob(done));
  }
}
