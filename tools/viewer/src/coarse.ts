// SPDX-License-Identifier: MIT
// Large structures in coarse cells, k fine ones wide, for as long as the picture moves: where
// software draws, the number of faces is what takes time.
import * as three from 'three';
import {Bricks} from './bricks.js';
import {Faces} from './faces.js';

const kCellsWanted = 20_000;
const kFacesWorthwhile = 60_000;

/** How wide coarse cells are to be; 1: fine ones will do. */
export function coarseness(bricks: number, faces: number): number {
  if (faces < kFacesWorthwhile) return 1;
  let wide = 2;
  while (bricks / wide ** 3 > kCellsWanted) ++wide;
  return wide;
}

export interface CoarseBricks {
  bricks: Bricks;
  rgb: Uint8Array;
}

/** Bricks that are visible, gathered: a coarse cell has the mean colour of those in it. */
export function coarsened(fine: Bricks, visible: Uint8Array, rgb: Uint8Array,
                          wide: number): CoarseBricks {
  const {x, y, z, lattice} = fine.cells;
  const known = new Map<number, number>();
  const parts: number[][] = [[], [], []], sums: number[] = [];
  const low = (of: Int32Array): number => of.reduce((a, b) => Math.min(a, b), 0);
  const [x0, y0, z0] = [low(x), low(y), low(z)];
  for (let i = 0; i < fine.count; ++i) {
    if (visible[i] === 0) continue;
    const cell = [x[i], y[i], z[i]].map(part => Math.floor(part / wide));
    const key = ((cell[0] - x0 + 1) * 2 ** 17 + (cell[1] - y0 + 1)) * 2 ** 17 + (cell[2] - z0 + 1);
    let place = known.get(key);
    if (place === undefined) {
      known.set(key, place = known.size);
      cell.forEach((part, axis) => parts[axis].push(part));
      sums.push(0, 0, 0, 0);
    }
    for (let part = 0; part < 3; ++part) sums[4 * place + part] += rgb[3 * i + part];
    ++sums[4 * place + 3];
  }
  const [cx, cy, cz] = parts.map(part => Int32Array.from(part));
  const mean = Uint8Array.from({length: 3 * known.size}, (_, i) =>
    sums[4 * Math.floor(i / 3) + i % 3] / sums[4 * Math.floor(i / 3) + 3]);
  return {bricks: new Bricks({lattice, x: cx, y: cy, z: cz}), rgb: mean};
}

/** Faces of coarse cells, where the fine ones are. */
export class CoarseFaces {
  readonly object = new three.Group();
  private faces: Faces | null = null;
  private shownBy = '';

  /** `key` says what is shown: the same is not gathered again. */
  show(key: string, wide: number, fine: Bricks, visible: Uint8Array, rgb: Uint8Array): void {
    this.object.visible = true;
    if (key === this.shownBy) return;
    this.shownBy = key;
    this.faces?.dispose();
    this.object.clear();
    const {bricks, rgb: colours} = coarsened(fine, visible, rgb, wide);
    this.faces = new Faces(bricks);
    this.faces.fill({visible: new Uint8Array(bricks.count).fill(1), rgb: colours, apart: 0});
    this.object.add(this.faces.object);
    this.object.scale.setScalar(wide);
    // Middles of fine cells are about whole numbers, upwards from them along z.
    const [u, v] = fine.shape.centre((wide - 1) / 2, (wide - 1) / 2, 0);
    this.object.position.set(u, v, 0);
    this.object.updateMatrixWorld();
  }

  get count(): number {
    return this.faces?.count ?? 0;
  }
}
