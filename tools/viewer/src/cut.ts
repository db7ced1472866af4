// SPDX-License-Identifier: MIT
// A plane that cuts the picture open: what lies beyond it is not drawn.
import * as three from 'three';
import type {Bounds} from './bricks.js';
import type {Cut} from './view_state.js';

function axisOf(cut: Cut): 0 | 1 | 2 {
  return cut.endsWith('x') ? 0 : cut.endsWith('y') ? 1 : 2;
}

/** Where along its axis the plane is: at share 0 it is beyond everything, at 1 nothing is left. */
function heightOf(cut: Cut, share: number, {low, high}: Bounds): number {
  const axis = axisOf(cut);
  return cut.startsWith('+') ? high[axis] + (low[axis] - high[axis]) * share
                             : low[axis] + (high[axis] - low[axis]) * share;
}

/** Is a place on the side that is drawn? */
export function keeper(cut: Cut, share: number, bounds: Bounds):
    ((places: ArrayLike<number>, first: number) => boolean) | null {
  if (cut === 'none') return null;
  const axis = axisOf(cut), height = heightOf(cut, share, bounds);
  const sign = cut.startsWith('+') ? 1 : -1;
  return (places, first) => sign * places[first + axis] <= sign * height;
}

export function planesOf(cut: Cut, share: number, bounds: Bounds): three.Plane[] {
  if (cut === 'none') return [];
  const sign = cut.startsWith('+') ? -1 : 1;
  const normal = new three.Vector3().setComponent(axisOf(cut), sign);
  return [new three.Plane(normal, -sign * heightOf(cut, share, bounds))];
}
