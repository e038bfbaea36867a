// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The kinds of curves: what the engine is asked for, and the command of the program that computes the same.

const exact = (x) => Math.floor(Math.min(1, Math.max(0, x)) * 1e6) / 1e6;

// A point as the program reads it: a vertex, or the corners of a face and two weights. `corners` are those of its face.
export function pointText({ weights }, corners) {
  const nearest = weights.indexOf(Math.max(...weights));
  const [t, u] = [exact(weights[1]), exact(weights[2])];
  if (weights[nearest] > 1 - 1e-6 || t + u > 1) return String(corners[nearest]);
  return `${corners.join(',')},${t},${u}`;
}

const through = (points, separator = ' ') => points.map((p) => p.text).join(separator);
const radians = (degrees) => (degrees * Math.PI) / 180;
const trace = ([source], { angle, length }) => `${source.text},${radians(angle)},${length}`;

// The value of an isoline; NaN for other curves.
export const levelOf = ({ name }) => Number(/^at distance (.*)$/.exec(name)?.[1]);

/*
 * Each kind: `option`, by which engine and program know it; the fewest points, and the most; the options in the panel;
 * `line`, the line of a file of the program; `request`, what the engine takes instead if it differs; and `command`.
 */
export const tools = {
  path: {
    hint: 'The geodesics from each point to the next. Click two or more points.',
    option: 'points',
    options: ['closed', 'snap'],
    least: () => 2,
    line: (points, { closed }) => through(closed ? [...points, points[0]] : points),
    command: (mesh) => `path ${mesh} --points points.txt`,
  },
  loop: {
    hint: 'The polyline through the points, shortened within its homotopy class. Click three or more points, for example around a handle.',
    option: 'draw',
    options: ['closed', 'snap'],
    isClosed: true,
    least: ({ closed }) => (closed ? 3 : 2),
    line: (points, { closed }) => (closed ? 'o ' : '') + through(points),
    command: (mesh) => `path ${mesh} --draw points.txt`,
  },
  spline: {
    hint: 'A Bezier curve or a cubic B-spline; a closed one is a B-spline. Click its control points.',
    option: 'bezier',
    options: ['closed', 'bspline', 'snap'],
    least: ({ closed }) => (closed ? 3 : 2),
    line: (points, { closed, bspline }) => (closed ? 'o ' : bspline ? 's ' : '') + through(points),
    command: (mesh) => `spline ${mesh} --bezier points.txt`,
  },
  shortest: {
    hint: 'The shortest of all paths between two vertices. Click both vertices.',
    option: 'shortest',
    options: [],
    isAtVertices: true,
    least: () => 2,
    most: 2,
    line: (points) => through(points),
    command: (mesh, [a, b]) => `shortest ${mesh} --from ${a.text} --to ${b.text}`,
  },
  classes: {
    hint: 'The shortest paths of several homotopy classes between two vertices. Click both vertices.',
    option: 'ways',
    options: ['count'],
    isAtVertices: true,
    least: () => 2,
    most: 2,
    line: (points) => through(points),
    request: (points, { count }) => `${through(points)}|${count}`,
    command: (mesh, [a, b], { count }) => `shortest ${mesh} --from ${a.text} --to ${b.text} --ways ${count}`,
  },
  trace: {
    hint: 'A straightest geodesic. Click the vertex at which it starts, and drag from there to set its direction.',
    option: 'trace',
    options: ['angle', 'length'],
    isAtVertices: true,
    least: () => 1,
    most: 1,
    line: (points) => through(points),
    request: trace,
    command: (mesh, points, options) => `trace ${mesh} --trace ${trace(points, options)}`,
  },
  distances: {
    hint: 'Isolines of the distance to the nearest source. Click one or more sources.',
    option: 'distances',
    options: ['spacing', 'tree'],
    isAtVertices: true,
    least: () => 1,
    line: (points) => through(points),
    request: (points, { spacing, tree }) => `${through(points, ',')}|${spacing}|${tree ? 1 : 0}`,
    command: (mesh, points, { spacing, tree }) =>
      `distance ${mesh} --source ${through(points, ',')} --spacing ${spacing}` +
      (tree ? `; flip_geodesics log ${mesh} --source ${points[0].text}` : ''),
  },
};
