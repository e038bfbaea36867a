// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the points on the surface stand for: an option of the program, and a line of the file that it takes.

const exact = (x) => Math.floor(Math.min(1, Math.max(0, x)) * 1e6) / 1e6;

// A point as the program reads it: a vertex, or the corners of a face and two weights. `corners` are those of its face.
export function pointText({ weights }, corners) {
  const nearest = weights.indexOf(Math.max(...weights));
  const [t, u] = [exact(weights[1]), exact(weights[2])];
  if (weights[nearest] > 1 - 1e-6 || t + u > 1) return String(corners[nearest]);
  return `${corners.join(',')},${t},${u}`;
}

export const through = (points) => points.map((p) => p.text).join(' ');

// Each tool: what it needs, and what the engine and the program are asked for.
export const tools = {
  path: {
    hint: 'Click two points or more; the path goes through all of them.',
    least: 2,
    kind: 'points',
    line: (points) => through(points),
    command: (mesh) => `path ${mesh} --points points.txt`,
  },
  loop: {
    hint: 'Click three points or more around a handle or a neck; the loop through them is pulled tight.',
    least: 3,
    kind: 'draw',
    line: (points) => `o ${through(points)}`,
    command: (mesh) => `path ${mesh} --draw points.txt`,
  },
  spline: {
    hint: 'Click two control points or more of a Bezier curve.',
    least: 2,
    kind: 'bezier',
    line: (points) => through(points),
    command: (mesh) => `spline ${mesh} --bezier points.txt`,
  },
  distances: {
    hint: 'Click a source or several; the curves are at equal distances from the nearest.',
    least: 1,
    kind: 'distances',
    isAtVertices: true,
    line: (points, { spacing, hasTree }) => `${points.map((p) => p.text).join(',')}|${spacing}|${hasTree ? 1 : 0}`,
    command: (mesh, points, { spacing }) => `distance ${mesh} --source ${points.map((p) => p.text).join(',')} --spacing ${spacing}`,
  },
};
