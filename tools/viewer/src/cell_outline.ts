// SPDX-License-Identifier: MIT
// The edges of a cell as lines upon everything else: of the brick that is picked, or the site that
// is asked about.
import * as three from 'three';
import {outlineOf, type CellShape} from './cells.js';

/** About its own middle; `wider` 1: as wide as the cell. */
export function cellOutline(shape: CellShape, wider: number, color: number): three.LineSegments {
  const geometry = new three.BufferGeometry();
  geometry.setAttribute('position', new three.Float32BufferAttribute(outlineOf(shape, wider), 3));
  return new three.LineSegments(
      geometry, new three.LineBasicMaterial({color, depthTest: false}));
}
