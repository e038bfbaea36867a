// SPDX-License-Identifier: LGPL-3.0-or-later

// The state of a run after any number of its steps: the curves' segments, and which edges there are.
export class Playback {
  constructor(run) {
    this.run = run;
    this.reset();
  }

  get length() {
    return this.run.steps.length;
  }

  reset() {
    this.step = 0;
    this.flips = 0;
    this.curves = this.run.curves.map((segments) => segments.slice());
    this.edges = new Set(this.run.edges);
    this.fresh = [];
  }

  // Going back starts anew: replaying thousands of steps takes milliseconds.
  goTo(step) {
    if (step < this.step) this.reset();
    while (this.step < step) this.advance();
  }

  advance() {
    const { flips, curve, keptInFront, keptAtEnd, inserted } = this.run.steps[this.step++];
    for (const [before] of flips) this.edges.delete(before);
    for (const [, after] of flips) this.edges.add(after);
    this.flips += flips.length;
    this.fresh = flips.map(([, after]) => after);
    const segments = this.curves[curve];
    segments.splice(keptInFront, segments.length - keptInFront - keptAtEnd, ...inserted);
  }

  // Calls use(i, j) for the indices of each two consecutive points of an edge, or of a segment.
  forEachPiece(edge, use) {
    const { starts } = this.run;
    for (let i = starts[edge]; i + 1 < starts[edge + 1]; ++i) use(i, i + 1);
  }

  // The ends of all pieces of some edges, as LineSegmentsGeometry wants them.
  piecesOf(edges) {
    const { points } = this.run;
    const result = [];
    for (const edge of edges)
      this.forEachPiece(edge, (i, j) => {
        result.push(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
        result.push(points[3 * j], points[3 * j + 1], points[3 * j + 2]);
      });
    return result;
  }

  curvePieces(curve) {
    return this.piecesOf(this.curves[curve].map((segment) => segment >> 1));
  }

  // In units of the mesh's radius.
  curveLength(curve) {
    const p = this.curvePieces(curve);
    let length = 0;
    for (let i = 0; i < p.length; i += 6) length += Math.hypot(p[i + 3] - p[i], p[i + 4] - p[i + 1], p[i + 5] - p[i + 2]);
    return length;
  }
}
