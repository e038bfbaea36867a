// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What statuses and verdicts are called in pages.

const statuses = {
  LOCALLY_SHORTEST: 'locally shortest',
  CONTRACTED: 'contracted to a point',
  LENGTH_LIMIT: 'stopped at the requested length',
  MEMORY_LIMIT: 'stopped because it required too much memory',
  PRECISION_LIMIT: 'not decided because of rounding errors',
  DEGENERATE_FACES: 'bent at degenerate faces',
  WITHIN_ROUNDING: 'shortest up to rounding errors',
  WITHIN_TOLERANCE: 'shortest up to a relative error of 1e-10',
  UNDECIDED: 'not confirmed to be the shortest',
  LENGTH: 'of the requested length',
  BORDER: 'ended at the border',
  CROSSING_LIMIT: 'stopped because it crossed too many edges',
  ISOLINE: 'isoline',
  BOUNDARY: 'boundary',
  ERROR: 'could not be computed',
};
const verdicts = {
  PROVEN: 'proven to be a geodesic by exact arithmetic',
  PROBABLE: 'no bend found, but the proof would take too long',
  BENT_SEGMENT: 'not straight within a face strip',
  BENT_JOINT: 'not straight at a joint',
};
export const plural = (count, noun, nouns = `${noun}s`) => `${count.toLocaleString('en')} ${count === 1 ? noun : nouns}`;
export const statusText = (status) => statuses[status] ?? status.toLowerCase().replaceAll('_', ' ');
export const verdictText = (verdict) => verdicts[verdict] ?? '';
