// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The scene of the page: what is in the JSON, with its arrays decoded.

function bytes(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const result = new Uint8Array(binary.length);
  for (let i = 0; i < result.length; ++i) result[i] = binary.charCodeAt(i);
  return result;
}

// What the program packs: differences to the number three before, first all lowest bytes, then all second ones, deflated.
async function unpack({ packed }) {
  const stream = new Blob([bytes(packed)]).stream().pipeThrough(new DecompressionStream('deflate'));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer());
  const count = planes.length / 4;
  const result = new Uint32Array(count); // which counts modulo 2^32
  for (let i = 0; i < count; ++i) {
    const difference = planes[i] | (planes[count + i] << 8) | (planes[2 * count + i] << 16) | (planes[3 * count + i] << 24);
    result[i] = difference + (i < 3 ? 0 : result[i - 3]);
  }
  return result;
}

// Puts numbers in the place of all packed arrays of an object.
async function unpackAll(object) {
  for (const [name, member] of Object.entries(object)) {
    if (typeof member !== 'object' || member === null) continue;
    if (typeof member.packed === 'string') object[name] = await unpack(member);
    else await unpackAll(member);
  }
  return object;
}

// Numbers of four bytes, the lowest first, on any machine; or what was unpacked.
function numbers(text, ArrayType) {
  if (text instanceof Uint32Array) return new ArrayType(text.buffer);
  const data = bytes(text);
  if (new Uint8Array(new Uint32Array([1]).buffer)[0] !== 1)
    for (let i = 0; i < data.length; i += 4) data.subarray(i, i + 4).reverse();
  return new ArrayType(data.buffer, data.byteOffset, data.byteLength / 4);
}

const floats = (text) => numbers(text, Float32Array);
const integers = (text) => numbers(text, Uint32Array);

function readLists(array) {
  const lists = [];
  for (let i = 0; i < array.length; i += array[i] + 1) lists.push(Array.from(array.subarray(i + 1, i + 1 + array[i])));
  return lists;
}

function readSteps(array) {
  const steps = [];
  for (let i = 0; i < array.length; ) {
    const flips = [];
    for (let n = array[i++]; n > 0; --n, i += 2) flips.push([array[i], array[i + 1]]);
    const [curve, keptInFront, keptAtEnd, count] = array.subarray(i, i + 4);
    i += 4;
    steps.push({ flips, curve, keptInFront, keptAtEnd, inserted: Array.from(array.subarray(i, i + count)) });
    i += count;
  }
  return steps;
}

function readRun(run) {
  return {
    points: floats(run.edgePoints),
    starts: integers(run.edgeStarts),
    inputEdges: integers(run.inputEdges),
    edges: integers(run.edges),
    curves: readLists(integers(run.curves)),
    steps: readSteps(integers(run.steps)),
    hasAllSteps: run.hasAllSteps,
  };
}

function decodeMesh(mesh) {
  return { ...mesh, positions: floats(mesh.positions), corners: integers(mesh.corners) };
}

function decodeResults(results) {
  return {
    ...results,
    curvePoints: floats(results.curvePoints),
    curveStarts: integers(results.curveStarts),
    distances: results.distances && floats(results.distances),
    runs: results.runs.map(readRun),
  };
}

// The straight pieces of a curve: the ends of each, six numbers.
export function curvePieces({ curvePoints, curveStarts }, i) {
  const count = Math.max(0, curveStarts[i + 1] - curveStarts[i] - 1);
  const pieces = new Float32Array(6 * count);
  for (let k = 0; k < count; ++k) {
    const start = 3 * (curveStarts[i] + k);
    pieces.set(curvePoints.subarray(start, start + 6), 6 * k);
  }
  return pieces;
}

export const readMesh = (text) => decodeMesh(JSON.parse(text));
export const readResults = (text) => decodeResults(JSON.parse(text));
export const readScene = async (text) => decodeResults(decodeMesh(await unpackAll(JSON.parse(text))));
