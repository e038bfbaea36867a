// SPDX-License-Identifier: LGPL-3.0-or-later

// A mesh to begin with: a torus with bumps, as the bytes of an OFF file.
export function exampleMesh() {
  const [around, across] = [120, 48];
  const lines = [];
  for (let i = 0; i < around; ++i)
    for (let k = 0; k < across; ++k) {
      const [u, v] = [(2 * Math.PI * i) / around, (2 * Math.PI * k) / across];
      const tube = 0.42 + 0.09 * Math.cos(5 * u) * Math.sin(3 * v + u);
      const radius = 1 + tube * Math.cos(v);
      lines.push([radius * Math.cos(u), radius * Math.sin(u), tube * Math.sin(v)].map((x) => x.toFixed(9)).join(' '));
    }
  const at = (i, k) => (i % around) * across + (k % across);
  for (let i = 0; i < around; ++i)
    for (let k = 0; k < across; ++k) {
      lines.push(`3 ${at(i, k)} ${at(i + 1, k)} ${at(i + 1, k + 1)}`);
      lines.push(`3 ${at(i, k)} ${at(i + 1, k + 1)} ${at(i, k + 1)}`);
    }
  const text = `OFF\n${around * across} ${2 * around * across} 0\n${lines.join('\n')}\n`;
  return { name: 'bumpy_torus.off', bytes: new TextEncoder().encode(text) };
}
