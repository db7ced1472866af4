// SPDX-License-Identifier: MIT
// Cells that a refusal is about: the brick that is wanted, transparent, and those in the way.
import * as three from 'three';
import type {Bounds} from './bricks.js';
import {cellShape} from './cells.js';
import type {LatticeRun, SceneMark} from './runs.js';

export const kWanted = '#009e73', kInTheWay = '#d55e00';
const kEdge = 1.04;  // of a cell, so that the outline stands off the brick

function middleOf(run: LatticeRun, {at}: SceneMark): three.Vector3 {
  return new three.Vector3(...cellShape(run.bricks.cells.lattice).centre(at[0], at[1], at[2]));
}

export function markObjects(run: LatticeRun): three.Group {
  const out = new three.Group();
  const box = new three.BoxGeometry(kEdge, kEdge, kEdge);
  for (const mark of run.marks) {
    const color = mark.way ? kInTheWay : kWanted;
    const outline = new three.LineSegments(
        new three.EdgesGeometry(box), new three.LineBasicMaterial({color, depthTest: false}));
    outline.renderOrder = 1;
    const body = new three.Mesh(box, new three.MeshBasicMaterial(
        {color, transparent: true, opacity: mark.way ? 0.45 : 0.25, depthWrite: false}));
    for (const object of [outline, body]) {
      object.position.copy(middleOf(run, mark));
      out.add(object);
    }
  }
  return out;
}

/** With room for what is marked. */
export function withMarks(run: LatticeRun, {low, high}: Bounds): Bounds {
  const out: Bounds = {low: [...low], high: [...high]};
  for (const mark of run.marks) {
    const middle = middleOf(run, mark).toArray();
    for (const axis of [0, 1, 2] as const) {
      out.low[axis] = Math.min(out.low[axis], middle[axis] - 0.5);
      out.high[axis] = Math.max(out.high[axis], middle[axis] + 0.5);
    }
  }
  return out;
}
