// SPDX-License-Identifier: MIT
// Which brick a ray meets first. Every visible one is tried, which takes milliseconds for a
// million, and needs nothing that has to be kept up to date.
import type * as three from 'three';
import type {Bricks} from './bricks.js';

/** The brick, or -1. */
export function pickBrick(bricks: Bricks, centres: Float32Array, visible: Uint8Array,
                          ray: three.Ray): number {
  const {origin: o, direction: d} = ray;
  const {faces} = bricks.shape;
  const speed = faces.map(({normal: n}) => n[0] * d.x + n[1] * d.y + n[2] * d.z);
  let nearest = Infinity, found = -1;
  for (let i = 0; i < bricks.count; ++i) {
    if (visible[i] === 0) continue;
    const x = centres[3 * i] - o.x, y = centres[3 * i + 1] - o.y, z = centres[3 * i + 2] - o.z;
    // Within the solid from the last entry through the plane of a face to the first exit.
    let enters = 0, leaves = nearest;
    for (let f = 0; f < faces.length && enters <= leaves; ++f) {
      const {normal: n} = faces[f];
      const way = n[0] * x + n[1] * y + n[2] * z + 0.5;
      if (speed[f] < 0) enters = Math.max(enters, way / speed[f]);
      else if (speed[f] > 0) leaves = Math.min(leaves, way / speed[f]);
      else if (way < 0) leaves = -1;
    }
    if (enters <= leaves && enters < nearest) {
      nearest = enters;
      found = i;
    }
  }
  return found;
}
