// SPDX-License-Identifier: LGPL-3.0-or-later

import { Raycaster, Triangle, Vector2, Vector3 } from 'three';
import { Stage } from '../source/stage.js';

// A stage on which places of the surface are picked. A place is {face, weights, position}.
export class Live_stage extends Stage {
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

  // Where in the window a point is, and whether it is in front of what is drawn there.
  project(position) {
    this.camera.updateMatrixWorld();
    const p = new Vector3(...position).project(this.camera);
    const box = this.canvas.getBoundingClientRect();
    return [box.left + ((p.x + 1) * box.width) / 2, box.top + ((1 - p.y) * box.height) / 2];
  }

  isVisible(position) {
    const hit = this.pick(...this.project(position));
    if (!hit) return true;
    const distance = (p) => this.camera.position.distanceTo(new Vector3(...p));
    return distance(position) < distance(hit.position) + 0.01;
  }
}
