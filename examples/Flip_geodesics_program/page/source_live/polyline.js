// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polylines as arrays of coordinates, three for each point.

export const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
const pointAt = (points, i) => points.subarray(3 * i, 3 * i + 3);

function indexOfNearest(points, position) {
  const distances = Array.from({ length: points.length / 3 }, (_, i) => distance(pointAt(points, i), position));
  return distances.indexOf(Math.min(...distances));
}

// Halfway along a polyline from the point nearest to `from` to that nearest to `to`, past the end of a closed one.
export function middle(points, from, to) {
  const count = points.length / 3;
  const last = indexOfNearest(points, to);
  const pieces = [];
  for (let i = indexOfNearest(points, from); i !== last; i = (i + 1) % count) pieces.push([pointAt(points, i), pointAt(points, (i + 1) % count)]);
  let left = pieces.reduce((sum, [p, q]) => sum + distance(p, q), 0) / 2;
  for (const [p, q] of pieces) {
    const length = distance(p, q);
    if (length > 0 && length >= left) return Array.from(p, (x, k) => x + (left / length) * (q[k] - x));
    left -= length;
  }
  return from;
}
