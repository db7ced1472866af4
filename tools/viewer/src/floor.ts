// SPDX-License-Identifier: MIT
// The ground as a grid of lines at z = 0, a little wider than what stands on it.
import * as three from 'three';
import type {Bounds} from './bricks.js';

const kMostLines = 200;

export function floorGrid({low, high}: Bounds, unit = 1): three.LineSegments {
  const [x0, y0] = [0, 1].map(axis => Math.floor(low[axis] / unit - 1.5) * unit + unit / 2);
  const [x1, y1] = [0, 1].map(axis => Math.ceil(high[axis] / unit + 1.5) * unit - unit / 2);
  let spacing = unit;
  while ((x1 - x0 + y1 - y0) / spacing > kMostLines) spacing *= 2;
  const points: number[] = [];
  for (let x = x0; x <= x1 + 1e-9; x += spacing) points.push(x, y0, 0, x, y1, 0);
  for (let y = y0; y <= y1 + 1e-9; y += spacing) points.push(x0, y, 0, x1, y, 0);
  const geometry = new three.BufferGeometry();
  geometry.setAttribute('position', new three.Float32BufferAttribute(points, 3));
  return new three.LineSegments(geometry, new three.LineBasicMaterial());
}
