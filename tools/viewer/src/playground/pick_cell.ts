// SPDX-License-Identifier: MIT
// The empty cell that a ray leads to: before the face of the first brick that it meets, or on the
// floor.
import type * as three from 'three';
import type {CellShape, Triple} from '../cells.js';
import {pickBrick} from '../pick.js';
import type {LatticeView} from '../lattice_view.js';

/** The face of a brick through which a ray enters it. */
function faceEntered(view: LatticeView, brick: number, ray: three.Ray): number {
  const {bricks} = view.run;
  const {faces} = bricks.shape;
  const [x, y, z] = [0, 1, 2].map(axis => bricks.centres[3 * brick + axis]);
  let latest = -Infinity, found = 0;
  faces.forEach(({normal: n}, f) => {
    const speed = n[0] * ray.direction.x + n[1] * ray.direction.y + n[2] * ray.direction.z;
    if (speed >= 0) return;
    const way = n[0] * (x - ray.origin.x) + n[1] * (y - ray.origin.y) +
        n[2] * (z - ray.origin.z) + 0.5;
    if (way / speed > latest) [latest, found] = [way / speed, f];
  });
  return found;
}

/** The cell of a level whose centre is nearest. */
function cellNear(shape: CellShape, px: number, py: number, level: number): Triple {
  const [o, ex, ey] = [shape.centre(0, 0, 0), shape.centre(1, 0, 0), shape.centre(0, 1, 0)];
  const [ax, ay, bx, by] = [ex[0] - o[0], ex[1] - o[1], ey[0] - o[0], ey[1] - o[1]];
  const area = ax * by - ay * bx, dx = px - o[0], dy = py - o[1];
  const q = Math.round((dx * by - dy * bx) / area), r = Math.round((ax * dy - ay * dx) / area);
  let best: Triple = [q, r, level], nearest = Infinity;
  for (let x = q - 1; x <= q + 1; ++x) {
    for (let y = r - 1; y <= r + 1; ++y) {
      const at = shape.centre(x, y, level);
      const far = Math.hypot(at[0] - px, at[1] - py);
      if (far < nearest) [nearest, best] = [far, [x, y, level]];
    }
  }
  return best;
}

export function pickCell(view: LatticeView, centres: Float32Array, ray: three.Ray): Triple | null {
  const {bricks, floor} = view.run;
  const brick = pickBrick(bricks, centres, view.visible, ray);
  if (brick >= 0) {
    const {neighbour: n} = bricks.shape.faces[faceEntered(view, brick, ray)];
    const {x, y, z} = bricks.cells;
    return [x[brick] + n[0], y[brick] + n[1], z[brick] + n[2]];
  }
  if (!floor || ray.direction.z >= 0) return null;
  const way = -ray.origin.z / ray.direction.z;
  return cellNear(bricks.shape, ray.origin.x + way * ray.direction.x,
                  ray.origin.y + way * ray.direction.y, 0);
}
