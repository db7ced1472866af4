// SPDX-License-Identifier: MIT
// A set of bricks on a lattice, in the order in which they came, with who is next to whom.
import {cellShape, type CellShape, type Lattice} from './cells.js';

export interface Cells {
  lattice: Lattice;
  x: Int32Array;
  y: Int32Array;
  z: Int32Array;
}

/** Numbers of bricks by cell: a hash table with open addressing, free places are -1. */
export class CellIndex {
  private readonly table: Int32Array;
  private readonly mask: number;

  constructor(private readonly cells: Cells) {
    let size = 16;
    while (size < cells.x.length * 2) size *= 2;
    this.table = new Int32Array(size).fill(-1);
    this.mask = size - 1;
    for (let i = 0; i < cells.x.length; ++i) {
      this.table[this.place(cells.x[i], cells.y[i], cells.z[i])] = i;
    }
  }

  /** The brick in a cell, or -1. */
  at(x: number, y: number, z: number): number {
    return this.table[this.place(x, y, z)];
  }

  private place(x: number, y: number, z: number): number {
    const {cells, table, mask} = this;
    let at = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b) ^ Math.imul(z, 0xc2b2ae35);
    at = (at ^ at >>> 15) & mask;
    for (;;) {
      const brick = table[at];
      if (brick < 0) return at;
      if (cells.x[brick] === x && cells.y[brick] === y && cells.z[brick] === z) return at;
      at = (at + 1) & mask;
    }
  }
}

export interface Bounds {
  low: [number, number, number];
  high: [number, number, number];
}

export class Bricks {
  readonly count: number;
  readonly shape: CellShape;
  readonly index: CellIndex;
  /** Of brick i behind its face f: `neighbours[i * faces + f]`, or -1. */
  readonly neighbours: Int32Array;
  /** Three numbers a brick, in cell widths. */
  readonly centres: Float32Array;
  /** Of the solids, in cell widths. */
  readonly bounds: Bounds;
  /** Lowest and highest z of a cell. */
  readonly levels: readonly [number, number];

  constructor(readonly cells: Cells) {
    this.count = cells.x.length;
    this.shape = cellShape(cells.lattice);
    this.index = new CellIndex(cells);
    this.neighbours = this.findNeighbours();
    this.centres = this.findCentres();
    this.bounds = this.findBounds();
    const {z} = cells;
    let low = this.count > 0 ? z[0] : 0, high = low;
    for (const level of z) {
      low = Math.min(low, level);
      high = Math.max(high, level);
    }
    this.levels = [low, high];
  }

  private findNeighbours(): Int32Array {
    const {x, y, z} = this.cells;
    const {faces} = this.shape;
    const out = new Int32Array(this.count * faces.length);
    faces.forEach(({neighbour: [dx, dy, dz]}, f) => {
      for (let i = 0; i < this.count; ++i) {
        out[i * faces.length + f] = this.index.at(x[i] + dx, y[i] + dy, z[i] + dz);
      }
    });
    return out;
  }

  private findCentres(): Float32Array {
    const {x, y, z} = this.cells;
    const out = new Float32Array(this.count * 3);
    for (let i = 0; i < this.count; ++i) {
      out.set(this.shape.centre(x[i], y[i], z[i]), i * 3);
    }
    return out;
  }

  private findBounds(): Bounds {
    if (this.count === 0) return {low: [-1, -1, 0], high: [1, 1, 1]};
    const low: [number, number, number] = [Infinity, Infinity, Infinity];
    const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < this.centres.length; ++i) {
      const axis = i % 3 as 0 | 1 | 2;
      low[axis] = Math.min(low[axis], this.centres[i] - 0.58);
      high[axis] = Math.max(high[axis], this.centres[i] + 0.58);
    }
    return {low, high};
  }
}
