// SPDX-License-Identifier: MIT
// A target beside a run: where it stands, and what of it is missing.
import {Bricks} from './bricks.js';
import type {Triple} from './cells.js';
import type {PoseRun} from './pose_run.js';
import {standing, type LatticeRun} from './runs.js';
import {placed, placeOf, triplesOf, type Place} from './target_place.js';

/** How much of a target is there, of how many bricks; and how many bricks are none of it. */
export interface TargetCount {
  there: number;
  of: number;
  beyond: number;
}

/** A target whose file does not say where it stands, or says otherwise, laid upon a run's end. */
export function laidOn(run: LatticeRun, target: LatticeRun): LatticeRun {
  const {cells} = target.bricks;
  if (target.placed || run.bricks.count === 0) return target;
  const all = triplesOf(cells), cubic = cells.lattice === 'cubic';
  const {place} = placeOf(all, triplesOf(run.bricks.cells), cubic);
  const moved = all.map(cell => placed(cell, place));
  const part = (axis: 0 | 1 | 2): Int32Array => Int32Array.from(moved, cell => cell[axis]);
  const bricks = new Bricks({lattice: cells.lattice, x: part(0), y: part(1), z: part(2)});
  return {...target, bricks};
}

export function countOf(run: LatticeRun, target: LatticeRun, time: number): TargetCount {
  const {x, y, z} = target.bricks.cells;
  const now = standing(run, time);
  let there = 0;
  for (let i = 0; i < target.bricks.count; ++i) {
    const brick = run.bricks.index.at(x[i], y[i], z[i]);
    if (brick >= 0 && brick < now) ++there;
  }
  return {there, of: target.bricks.count, beyond: now - there};
}

/** The lattice that blocks of a physical run stand in: that about one of them. */
export interface Frame {
  origin: Triple;
  yaw: number;
  side: number;
  place: Place;
}

const kOff = 0.25;  // of a side, by which a block may be off its cell

interface Block {
  p: Triple;
  yaw: number;
  side: number;
}

function blocksAt(run: PoseRun, time: number): Block[] {
  return run.bodies.flatMap(({block, half}, i) => {
    const pose = block ? run.tracks.at(i, time) : null;
    if (!pose) return [];
    const [x, y, z, w] = pose.q;
    const yaw = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
    return [{p: pose.p, yaw, side: 2 * half[0]}];
  });
}

/** Cells about one block that others stand in. */
function cellsAbout({p, yaw, side}: Block, all: readonly Block[]): Triple[] {
  const [cosine, sine] = [Math.cos(yaw), Math.sin(yaw)];
  return all.flatMap(other => {
    const [dx, dy] = [other.p[0] - p[0], other.p[1] - p[1]];
    const at: Triple = [(cosine * dx + sine * dy) / side, (cosine * dy - sine * dx) / side,
                        other.p[2] / side - 0.5];
    const cell = at.map(Math.round) as [number, number, number];
    return Math.hypot(...at.map((v, i) => v - cell[i])) < kOff ? [cell] : [];
  });
}

/** Where a target fits best to the blocks of a run at its end; null: there are none. */
export function frameOfTarget(run: PoseRun, target: LatticeRun): Frame | null {
  const all = blocksAt(run, run.end), cells = triplesOf(target.bricks.cells);
  let best: Frame | null = null, most = 0;
  for (const block of all) {
    // Heights are told from the floor, on which a target stands.
    const {place, fit} = placeOf(cells, cellsAbout(block, all), true);
    if (fit <= most) continue;
    most = fit;
    best = {origin: [block.p[0], block.p[1], 0], yaw: block.yaw, side: block.side, place};
  }
  return best;
}

/** Middles of a target's bricks in the world. */
export function middlesOf({origin, yaw, side, place}: Frame, target: LatticeRun): Triple[] {
  const [cosine, sine] = [Math.cos(yaw), Math.sin(yaw)];
  return triplesOf(target.bricks.cells).map(cell => {
    const [x, y, z] = placed(cell, place);
    return [origin[0] + side * (cosine * x - sine * y), origin[1] + side * (sine * x + cosine * y),
            side * (z + 0.5)];
  });
}

/** Which of a target's bricks are there, in a run of blocks. */
export function thereOf(run: PoseRun, middles: readonly Triple[], side: number, time: number):
    boolean[] {
  const all = blocksAt(run, time);
  return middles.map(at => all.some(({p}) =>
    Math.hypot(p[0] - at[0], p[1] - at[1], p[2] - at[2]) < side * kOff * 2));
}
