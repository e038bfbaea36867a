// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Numbers and lengths as the page shows them.

// The unit in which lengths and coordinates are shown and typed: `factor` of it are one unit of the mesh file.
export const unit = { factor: 1, name: '' };
export const format = (x, digits = 8) => (x === null || x === undefined ? '?' : String(Number(Number(x).toPrecision(digits))));
export const withUnit = (text) => `${text} ${unit.name}`.trim();
export const lengthText = (x) => withUnit(format(x && x * unit.factor)); // null if it is not finite

// Numbers of two digits of which the first is 1, 2 or 5: the greatest that is not above x.
export function roundNumber(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return Number(((x >= 5 * power ? 5 : x >= 2 * power ? 2 : 1) * power).toPrecision(2));
}
