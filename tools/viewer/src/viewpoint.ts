// SPDX-License-Identifier: MIT
// The camera: one for all runs, so that it stays when runs are switched. z is up.
import * as three from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import type {Bounds} from './bricks.js';

/** Where the camera stands, as seen from what it looks at. */
export const kPresets: Record<string, readonly [number, number, number]> = {
  iso: [0.55, -0.75, 0.5],
  front: [0, -1, 0],
  right: [1, 0, 0],
  back: [0, 1, 0],
  left: [-1, 0, 0],
  top: [0, -1e-4, 1],
};

const kFieldOfView = 35;  // degrees
const kMargin = 1.08;
const kCloseUp = 1.2;  // m: a robot that is followed

export class Viewpoint {
  private readonly perspective = new three.PerspectiveCamera(kFieldOfView, 1, 0.01, 1e5);
  private readonly parallel = new three.OrthographicCamera(-1, 1, 1, -1, -1e4, 1e5);
  private readonly controls: OrbitControls;
  private isParallel = false;
  private aspect = 1;

  constructor(element: HTMLElement, private bounds: Bounds, onMove: () => void) {
    for (const camera of [this.perspective, this.parallel]) camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.perspective, element);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', onMove);
    this.fit('iso');
  }

  get camera(): three.PerspectiveCamera | three.OrthographicCamera {
    return this.isParallel ? this.parallel : this.perspective;
  }

  get orthographic(): boolean {
    return this.isParallel;
  }

  set orthographic(wanted: boolean) {
    if (wanted === this.isParallel) return;
    const numbers = this.numbers();
    this.isParallel = wanted;
    this.controls.object = this.camera;
    this.place(numbers);
  }

  /** Does it obey mouse and fingers? */
  set enabled(wanted: boolean) {
    this.controls.enabled = wanted;
  }

  /** What `fit` shows from now on. */
  set shown(bounds: Bounds) {
    this.bounds = bounds;
  }

  /** Does the wheel zoom? */
  set zooms(wanted: boolean) {
    this.controls.enableZoom = wanted;
  }

  resize(aspect: number): void {
    if (aspect === this.aspect) return;
    this.aspect = aspect;
    this.perspective.aspect = aspect;
    this.perspective.updateProjectionMatrix();
    this.shapeParallel(this.parallel.top);
  }

  /** Shows everything from a direction, or from where the camera is. */
  fit(preset?: string): void {
    const {low, high} = this.bounds;
    const middle = new three.Vector3(...low).add(new three.Vector3(...high)).multiplyScalar(0.5);
    const from = preset === undefined
        ? this.camera.position.clone().sub(this.controls.target)
        : new three.Vector3(...kPresets[preset]);
    const half = new three.Vector3(...high).sub(middle);
    const away = this.distanceFor(half, from.normalize());
    this.place([...middle.clone().addScaledVector(from, away).toArray(), ...middle.toArray()]);
  }

  /** Is all that `fit` would show in the picture? */
  get showsAll(): boolean {
    const {low, high} = this.bounds;
    this.camera.updateMatrixWorld();
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(
        i => new three.Vector3(...low.map((x, axis) => i >> axis & 1 ? high[axis] : x)));
    return corners.every(corner => {
      const {x, y} = corner.project(this.camera);
      return Math.max(Math.abs(x), Math.abs(y)) <= 1;
    });
  }

  /** From a direction, as far as the camera is now. */
  lookFrom(preset: string): void {
    const {target} = this.controls;
    const away = this.camera.position.distanceTo(target);
    const from = new three.Vector3(...kPresets[preset]).normalize();
    this.place([...target.clone().addScaledVector(from, away).toArray(), ...target.toArray()]);
  }

  /** Place and target. */
  numbers(): number[] {
    const {target} = this.controls;
    const from = this.camera.position.clone().sub(target);
    // Zooming leaves a parallel camera where it is: its distance is told as what shows as much.
    if (this.isParallel) {
      from.setLength(this.parallel.top / this.parallel.zoom / tangent());
    }
    return [...target.clone().add(from).toArray(), ...target.toArray()];
  }

  place(numbers: readonly number[]): void {
    const [x, y, z, tx, ty, tz] = numbers;
    this.controls.target.set(tx, ty, tz);
    this.camera.position.set(x, y, z);
    const away = this.camera.position.distanceTo(this.controls.target);
    this.perspective.near = away / 1000;
    this.perspective.far = away * 1000;
    this.perspective.updateProjectionMatrix();
    this.parallel.zoom = 1;
    this.shapeParallel(away * tangent());
    this.controls.update();
  }

  /** Turns and zooms by keys: radians, and a factor. */
  turn(azimuth: number, height: number, zoom: number): void {
    const [x, y, z, ...target] = this.numbers();
    const at = new three.Vector3(...target as [number, number, number]);
    const way = new three.Spherical().setFromVector3(
        new three.Vector3(x - at.x, z - at.z, at.y - y));
    way.theta += azimuth;
    way.phi = Math.min(Math.max(way.phi + height, 1e-4), Math.PI - 1e-4);
    way.radius *= zoom;
    const from = new three.Vector3().setFromSpherical(way);
    this.place([at.x + from.x, at.y - from.z, at.z + from.y, ...target]);
  }

  /** Moves by keys, in parts of what is seen. */
  pan(right: number, up: number): void {
    const [x, y, z, tx, ty, tz] = this.numbers();
    const reach = tangent() * Math.hypot(x - tx, y - ty, z - tz);
    const across = new three.Vector3(), above = new three.Vector3();
    this.camera.updateMatrixWorld();
    this.camera.matrixWorld.extractBasis(across, above, new three.Vector3());
    const by = across.multiplyScalar(right * reach).addScaledVector(above, up * reach);
    this.place([x + by.x, y + by.y, z + by.z, tx + by.x, ty + by.y, tz + by.z]);
  }

  /** Turns to a place, as near as it is worth while to see something there. */
  lookAt(at: three.Vector3): void {
    const numbers = this.numbers();
    const way = new three.Vector3(...numbers.slice(0, 3) as [number, number, number])
                    .sub(this.controls.target);
    way.setLength(Math.min(way.length(), kCloseUp));
    this.place([...at.clone().add(way).toArray(), ...at.toArray()]);
  }

  /** Moves with what is followed. */
  shift(by: three.Vector3): void {
    this.controls.target.add(by);
    this.camera.position.add(by);
    this.controls.update();
  }

  private shapeParallel(half: number): void {
    this.parallel.top = half;
    this.parallel.bottom = -half;
    this.parallel.left = -half * this.aspect;
    this.parallel.right = half * this.aspect;
    this.parallel.updateProjectionMatrix();
  }

  /** So far away all corners of a box are within the picture. */
  private distanceFor(half: three.Vector3, from: three.Vector3): number {
    const up = Math.abs(from.z) > 0.99 ? new three.Vector3(0, 1, 0) : new three.Vector3(0, 0, 1);
    const right = up.clone().cross(from).normalize();
    const above = from.clone().cross(right);
    const reach = (v: three.Vector3): number =>
      Math.abs(v.x) * half.x + Math.abs(v.y) * half.y + Math.abs(v.z) * half.z;
    const wide = Math.max(reach(above), reach(right) / this.aspect);
    return kMargin * wide / tangent() + reach(from);
  }
}

function tangent(): number {
  return Math.tan(kFieldOfView * Math.PI / 360);
}
