// SPDX-License-Identifier: LGPL-3.0-or-later

import { CanvasTexture, Raycaster, Sprite, SpriteMaterial, Triangle, Vector2, Vector3 } from 'three';
import { Stage } from '../source/stage.js';
import { roundNumber, unit, withUnit } from './units.js';

const labelHeight = 22; // in pixels
const widestScale = 140;

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

/*
 * A stage on which places of the surface are picked. A place is {face, weights, position}. Curves may have labels, and a
 * bar shows the scale.
 */
export class Live_stage extends Stage {
  constructor(canvas, scene) {
    super(canvas, scene);
    this.labels = [];
    this.scaleBar = document.createElement('div');
    this.scaleBar.id = 'scale';
    canvas.after(this.scaleBar);
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
    const { pixels, text } = this.scale();
    this.scaleBar.style.width = `${pixels}px`;
    this.scaleBar.textContent = text;
  }

  // A round length, and how wide it is at the distance of the center of the view.
  scale() {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const perPixel = (unit.factor * this.data.radius * distance * 2 * Math.tan((this.camera.fov * Math.PI) / 360)) / this.canvas.clientHeight;
    const length = roundNumber(widestScale * perPixel);
    return { pixels: length / perPixel, text: withUnit(length) };
  }

  // The view as a PNG, with the bar of the scale.
  image() {
    this.draw();
    const image = document.createElement('canvas');
    [image.width, image.height] = [this.canvas.width, this.canvas.height];
    const context = image.getContext('2d');
    context.drawImage(this.canvas, 0, 0);
    const ratio = image.width / this.canvas.clientWidth;
    context.scale(ratio, ratio);
    const { pixels, text } = this.scale();
    const bottom = this.canvas.clientHeight - 16;
    context.fillStyle = getComputedStyle(this.scaleBar).color;
    context.font = '13px system-ui, sans-serif';
    context.fillText(text, 16, bottom - 8);
    context.fillRect(16, bottom - 3, pixels, 3);
    return new Promise((done) => image.toBlob(done));
  }
}
