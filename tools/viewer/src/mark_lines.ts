// SPDX-License-Identifier: MIT
// Coloured lines, gathered and then drawn at once.
import * as three from 'three';
import type {Rgb} from './colours.js';

const kHead = 0.25;       // of an arrow
const kMostHead = 0.008;  // m

export class Lines {
  private readonly points: number[] = [];
  private readonly colours: number[] = [];

  add(from: three.Vector3, to: three.Vector3, colour: Rgb): void {
    this.points.push(...from.toArray(), ...to.toArray());
    const [r, g, b] = colour.map(part => part / 255);
    const linear = new three.Color().setRGB(r, g, b, three.SRGBColorSpace).toArray();
    this.colours.push(...linear, ...linear);
  }

  /** A closed polygon. */
  ring(corners: readonly three.Vector3[], colour: Rgb): void {
    corners.forEach((corner, i) => this.add(corner, corners[(i + 1) % corners.length], colour));
  }

  /** With a head of four lines, which is seen from all sides. */
  arrow(from: three.Vector3, way: three.Vector3, colour: Rgb): void {
    const to = from.clone().add(way), long = way.length();
    if (long === 0) return;
    this.add(from, to, colour);
    const head = Math.min(kHead * long, kMostHead);
    const back = to.clone().addScaledVector(way, -head / long);
    const upright = Math.abs(way.z) > 0.9 * long;
    const side = new three.Vector3(upright ? 1 : 0, 0, upright ? 0 : 1).cross(way)
                     .setLength(head / 2);
    const other = side.clone().cross(way).setLength(head / 2);
    for (const across of [side, other]) {
      this.add(to, back.clone().add(across), colour);
      this.add(to, back.clone().sub(across), colour);
    }
  }

  /** Into what is drawn, in place of what it was. */
  show(object: three.LineSegments): void {
    object.geometry.dispose();
    object.geometry = new three.BufferGeometry();
    object.geometry.setAttribute('position', new three.Float32BufferAttribute(this.points, 3));
    object.geometry.setAttribute('color', new three.Float32BufferAttribute(this.colours, 3));
    object.visible = this.points.length > 0;
  }
}
