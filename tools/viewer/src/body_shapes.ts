// SPDX-License-Identifier: MIT
// Bodies as meshes: their shapes, and on blocks what the six faces bear.
import * as three from 'three';
import {ConvexGeometry} from 'three/examples/jsm/geometries/ConvexGeometry.js';
import {colourOfLed, rgbOf, type Palette, type Rgb} from './colours.js';
import type {Body} from './pose_run.js';

/** Of LEDs that are off, then Q1 to Q4, as lib/physical/robots/led.h has them. */
export const kLedColours: readonly Rgb[] =
    [[120, 124, 130], [255, 120, 255], [255, 208, 27], [74, 255, 27], [74, 255, 255]];
function ledColour(digit: string, palette: Palette): Rgb {
  const led = Number(digit);
  return led in kLedColours ? colourOfLed(led, kLedColours[led], palette) : kLedColours[0];
}

const kLedsOfAFace = 4;
// In half edges of a block; tag and LEDs where blocks/stigmergic.yaml has them.
const kTagHalf = 0.52, kInkHalf = 0.436, kLedPlace = 0.727, kLedHalf = 0.11;
const kTagPaper: Rgb = [238, 240, 242], kTagInk: Rgb = [32, 36, 42];
const kLift = 0.006;

function geometryOf({shape, half, points, surface}: Body): three.BufferGeometry {
  if (surface) {
    const places = surface.triangles.flatMap(corners => corners.flatMap(i => surface.points[i]));
    return new three.BufferGeometry()
        .setAttribute('position', new three.Float32BufferAttribute(places, 3));
  }
  const [x, y, z] = half;
  switch (shape) {
    case 'sphere':
      return new three.SphereGeometry(x, 20, 12);
    case 'cylinder':
      return new three.CylinderGeometry(x, x, 2 * z, 28).rotateX(Math.PI / 2);
    case 'hull':
      return new ConvexGeometry((points ?? []).map(([a, b, c]) => new three.Vector3(a, b, c)));
    case 'box':
      return new three.BoxGeometry(2 * x, 2 * y, 2 * z);
  }
}

/** Right and up on each face, as lib/physical/sensors/sensor_scene.cpp has them. */
const kFrames = [[[0, 1, 0], [0, 0, 1]], [[1, 0, 0], [0, 0, 1]], [[0, -1, 0], [0, 0, 1]],
                 [[-1, 0, 0], [0, 0, 1]], [[1, 0, 0], [0, 1, 0]], [[1, 0, 0], [0, -1, 0]]] as const;

/** Normal, right and up. */
function frameOf(face: number): [three.Vector3, three.Vector3, three.Vector3] {
  const [u, v] = kFrames[face].map(([x, y, z]) => new three.Vector3(x, y, z));
  return [u.clone().cross(v), u, v];
}

const kCorners = [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]] as const;

interface Quads {
  positions: number[];
  colours: number[];
}

function addSquare({positions, colours}: Quads, middle: three.Vector3, u: three.Vector3,
                   v: three.Vector3, half: number, colour: Rgb): void {
  const at = (a: number, b: number): number[] =>
    middle.clone().addScaledVector(u, a * half).addScaledVector(v, b * half).toArray();
  for (const [a, b] of kCorners) positions.push(...at(a, b));
  for (let i = 0; i < 6; ++i) colours.push(...colour.map(c => c / 255));
}

/** Tags and LEDs of a block whose LEDs show these colours, all or one by one. */
function faceMarks(half: number, leds: string, palette: Palette): three.BufferGeometry {
  const quads: Quads = {positions: [], colours: []};
  for (let face = 0; face < kFrames.length; ++face) {
    const [n, u, v] = frameOf(face);
    const middle = (lift: number): three.Vector3 => n.clone().multiplyScalar(1 + lift);
    addSquare(quads, middle(kLift), u, v, kTagHalf, kTagPaper);
    addSquare(quads, middle(2 * kLift), u, v, kInkHalf, kTagInk);
    [u, v, u.clone().negate(), v.clone().negate()].forEach((way, k) => {
      const digit = leds.length > 1 ? leds[face * kLedsOfAFace + k] : leds;
      addSquare(quads, middle(kLift).addScaledVector(way, kLedPlace), u, v, kLedHalf,
                ledColour(digit, palette));
    });
  }
  const out = new three.BufferGeometry();
  out.setAttribute('position', new three.Float32BufferAttribute(quads.positions, 3));
  out.setAttribute('color', new three.Float32BufferAttribute(quads.colours, 3));
  out.scale(half, half, half);
  return out;
}

const kMarks = new three.MeshBasicMaterial({vertexColors: true});

/** Makes meshes, and lets those that are alike share geometry and material. */
export class BodyShapes {
  /** In which LEDs are lit from now on. */
  palette: Palette = 'file';
  private readonly geometries = new Map<string, three.BufferGeometry>();
  private readonly materials = new Map<string, three.Material>();

  mesh(body: Body): three.Mesh {
    const key = JSON.stringify([body.shape, body.half, body.points, body.surface]);
    const out = new three.Mesh(this.geometry(key, () => geometryOf(body)),
                               this.material(body.color));
    if (body.block) {
      const marks = new three.Mesh(undefined, kMarks);
      out.add(marks);
      this.light(out, body, body.led);
    }
    return out;
  }

  /** Shows a block's LEDs: a digit for all, or one for each. */
  light(mesh: three.Mesh, body: Body, leds: string): void {
    const half = body.half[0];
    const marks = mesh.children.find(child => child instanceof three.Mesh);
    const {palette} = this;
    const key = `${half} ${leds} ${palette}`;
    if (marks) marks.geometry = this.geometry(key, () => faceMarks(half, leds, palette));
    const led = ledColour(leds[0], palette);
    const tint = leds.startsWith('0') || !body.block ? body.color : mixed(rgbOf(body.color), led);
    mesh.material = this.material(tint);
  }

  /** Without colour, until it is lit again. */
  grey(mesh: three.Mesh): void {
    mesh.material = this.material('#c9ccd1');
  }

  private geometry(key: string, make: () => three.BufferGeometry): three.BufferGeometry {
    const found = this.geometries.get(key) ?? make();
    this.geometries.set(key, found);
    return found;
  }

  private material(color: string): three.Material {
    const found = this.materials.get(color) ??
        new three.MeshLambertMaterial({color, flatShading: true, side: three.DoubleSide});
    this.materials.set(color, found);
    return found;
  }
}

/** Six tenths of the second. */
function mixed(a: Rgb, b: Rgb): string {
  const mix = (i: 0 | 1 | 2): number => Math.round(a[i] * 0.4 + b[i] * 0.6);
  return `rgb(${mix(0)}, ${mix(1)}, ${mix(2)})`;
}
