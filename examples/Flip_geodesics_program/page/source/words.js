// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What statuses and verdicts are called for people.

const statuses = {
  LOCALLY_SHORTEST: 'locally shortest',
  CONTRACTED: 'has shrunk to a point',
  LENGTH_LIMIT: 'stopped at the length that was asked for',
  MEMORY_LIMIT: 'stopped, as it takes too much memory',
  ISOLINE: 'isoline',
  BOUNDARY: 'boundary',
  ERROR: 'could not be computed',
};
const verdicts = {
  PROVEN: 'proven by exact arithmetic',
  PROBABLE: 'proven up to a tiny probability',
  BENT_SEGMENT: 'not straight within a face strip',
  BENT_JOINT: 'not straight at a joint',
};
export const statusText = (status) => statuses[status] ?? status.toLowerCase().replaceAll('_', ' ');
export const verdictText = (verdict) => verdicts[verdict] ?? '';
