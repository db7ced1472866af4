// SPDX-License-Identifier: MIT
// A physical run as something to be drawn.
import * as three from 'three';
import {BodyShapes} from './body_shapes.js';
import type {Bounds} from './bricks.js';
import type {Palette} from './colours.js';
import {floorGrid} from './floor.js';
import {alike, twinsOf} from './pose_difference.js';
import {PoseMarks} from './pose_marks.js';
import {PoseTarget} from './pose_target.js';
import {saidAt, type PoseRun} from './pose_run.js';
import type {LatticeRun} from './runs.js';
import {arrowsOf} from './shown_values.js';
import type {Choices} from './view_state.js';

const kGrid = 0.1;  // m

function boundsOf(run: PoseRun): Bounds {
  const low: Bounds['low'] = [Infinity, Infinity, 0];
  const high: Bounds['high'] = [-Infinity, -Infinity, 0.05];
  run.bodies.forEach((body, i) => {
    const reach = run.tracks.reach(i);
    if (!reach) return;
    for (const axis of [0, 1, 2] as const) {
      low[axis] = Math.min(low[axis], reach.low[axis] - body.half[axis]);
      high[axis] = Math.max(high[axis], reach.high[axis] + body.half[axis]);
    }
  });
  return low[0] > high[0] ? {low: [-1, -1, 0], high: [1, 1, 1]} : {low, high};
}

export class PoseView {
  readonly scene = new three.Scene();
  /** Of what there is in the run, or at present in one that goes on. */
  bounds: Bounds;
  private readonly shapes = new BodyShapes();
  private readonly meshes: (three.Mesh | null)[];
  private readonly leds: string[];
  private readonly floor: three.LineSegments;
  private readonly arrows = new three.LineSegments(
      new three.BufferGeometry(), new three.LineBasicMaterial({vertexColors: true}));
  private readonly marker = new three.LineSegments(
      new three.EdgesGeometry(new three.BoxGeometry(2, 2, 2)),
      new three.LineBasicMaterial({color: 0xff00aa, depthTest: false}));
  private readonly marks: PoseMarks;
  /** What of the target is missing. */
  readonly missing: PoseTarget | null;
  /** From where the other run has a body to where it is here. */
  private readonly ways = new three.LineSegments(
      new three.BufferGeometry(), new three.LineBasicMaterial({color: 0xff00aa, depthTest: false}));
  private readonly twins: number[];
  /** Bodies that are greyed. */
  private readonly greyed = new Set<number>();
  private drawnAt = NaN;
  private marked = '';
  private comparedAt = '';

  /** `other` is the run that differences are told from. */
  constructor(readonly run: PoseRun, private readonly number: number,
              private readonly other: PoseRun | null, target: LatticeRun | null) {
    this.twins = other ? twinsOf(run, other) : [];
    this.missing = target && new PoseTarget(run, target);
    if (this.missing) this.scene.add(this.missing.object);
    this.ways.frustumCulled = false;
    this.ways.visible = false;
    this.scene.add(this.ways);
    this.marks = new PoseMarks(run);
    this.bounds = boundsOf(run);
    this.meshes = run.bodies.map(() => null);
    this.leds = run.bodies.map(body => body.led);
    this.floor = floorGrid(this.bounds, kGrid);
    this.marker.renderOrder = 1;
    this.arrows.frustumCulled = false;
    const sun = new three.DirectionalLight(0xffffff, 1.7);
    sun.position.set(0.4, -0.7, 1);
    this.scene.add(new three.HemisphereLight(0xffffff, 0x8a8f98, 1.9), sun, this.floor, this.arrows,
                   this.marker, this.marks.object, this.marks.within);
  }

  /** In a run that goes on bodies have moved. */
  measure(): void {
    this.bounds = boundsOf(this.run);
  }

  update(choices: Readonly<Choices>, dark: boolean): void {
    const {time, marks} = choices;
    const marked = `${time} ${marks.join()}`;
    if (marked !== this.marked) this.marks.update(marks, time);
    this.marked = marked;
    if (time !== this.drawnAt) {
      this.run.bodies.forEach((_, i) => this.place(i, time));
      this.pointArrows(time);
    }
    this.drawnAt = time;
    this.paint(choices.palette);
    this.missing?.update(choices);
    this.compare(choices);
    this.mark(choices);
    (this.floor.material as three.LineBasicMaterial).color.set(dark ? 0x3d4755 : 0xc3cad3);
  }

  turnTo(): void {
    // All directions are drawn.
  }

  /** The body that a ray meets first, or -1. */
  pick(ray: three.Ray): number {
    const caster = new three.Raycaster(ray.origin, ray.direction);
    const there = this.meshes.filter(mesh => mesh !== null).filter(mesh => mesh.visible);
    const hit = caster.intersectObjects(there, false).at(0);
    return this.meshes.findIndex(mesh => mesh !== null && mesh === hit?.object);
  }

  /** Where a robot is; null: the run has no such robot, or it is not there. */
  placeOf(robot: number, time: number): three.Vector3 | null {
    const body = this.run.robots.at(robot)?.bodies.at(0);
    const pose = body === undefined ? null : this.run.tracks.at(body, time);
    return pose && new three.Vector3(...pose.p);
  }

  private place(i: number, time: number): void {
    const pose = this.run.tracks.at(i, time);
    const body = this.run.bodies[i];
    let mesh = this.meshes[i];
    if (!pose) {
      if (mesh) mesh.visible = false;
      return;
    }
    if (!mesh) {
      mesh = this.meshes[i] = this.shapes.mesh(body);
      this.scene.add(mesh);
    }
    mesh.visible = true;
    mesh.position.set(...pose.p);
    mesh.quaternion.set(...pose.q);
    if (!body.block) return;
    const leds = saidAt(this.run.leds.get(i), time) ?? body.led;
    if (leds !== this.leds[i]) this.shapes.light(mesh, body, leds);
    if (leds !== this.leds[i]) this.greyed.delete(i);
    this.leds[i] = leds;
  }

  /** Lights all LEDs anew, where the palette is another. */
  private paint(palette: Palette): void {
    if (palette === this.shapes.palette) return;
    this.shapes.palette = palette;
    this.run.bodies.forEach((body, i) => {
      const mesh = this.meshes[i];
      if (mesh && body.block && !this.greyed.has(i)) this.shapes.light(mesh, body, this.leds[i]);
    });
  }

  /** Greys what is in the other run where it is here; ways lead from where else it is. */
  private compare({difference, time}: Readonly<Choices>): void {
    const {other, run} = this;
    const at = `${difference} ${time}`;
    if (!other || at === this.comparedAt) return;
    this.comparedAt = at;
    const points: number[] = [];
    run.bodies.forEach((body, i) => {
      const mesh = this.meshes[i], twin = this.twins[i];
      const same = difference && alike(run, i, other, twin, time);
      if (mesh && same !== this.greyed.has(i)) this.grey(i, mesh, same);
      const there = difference && !same && twin >= 0 ? other.tracks.at(twin, time) : null;
      if (mesh?.visible && there && body.block) points.push(...there.p, ...mesh.position.toArray());
    });
    this.ways.geometry.dispose();
    this.ways.geometry = new three.BufferGeometry();
    this.ways.geometry.setAttribute('position', new three.Float32BufferAttribute(points, 3));
    this.ways.visible = points.length > 0;
  }

  private grey(i: number, mesh: three.Mesh, same: boolean): void {
    if (same) {
      this.greyed.add(i);
      this.shapes.grey(mesh);
    } else {
      this.greyed.delete(i);
      this.shapes.light(mesh, this.run.bodies[i], this.leds[i]);
    }
  }

  /** What robots' programs point at. */
  private pointArrows(time: number): void {
    const points: number[] = [], colours: number[] = [];
    for (const [body, said] of this.run.show) {
      const mesh = this.meshes[body];
      if (!mesh?.visible) continue;
      mesh.updateMatrixWorld();
      for (const {from, to, color} of arrowsOf(saidAt(said, time))) {
        const rgb = new three.Color(color).toArray();
        for (const end of [from, to]) {
          points.push(...new three.Vector3(...end).applyMatrix4(mesh.matrixWorld).toArray());
          colours.push(...rgb);
        }
      }
    }
    this.arrows.geometry.dispose();
    this.arrows.geometry = new three.BufferGeometry();
    this.arrows.geometry.setAttribute('position', new three.Float32BufferAttribute(points, 3));
    this.arrows.geometry.setAttribute('color', new three.Float32BufferAttribute(colours, 3));
    this.arrows.visible = points.length > 0;
  }

  private mark({picked}: Readonly<Choices>): void {
    const mesh = picked?.run === this.number ? this.meshes[picked.brick] : null;
    this.marker.visible = mesh?.visible ?? false;
    if (!mesh || !picked) return;
    this.marker.position.copy(mesh.position);
    this.marker.quaternion.copy(mesh.quaternion);
    this.marker.scale.set(...this.run.bodies[picked.brick].half).multiplyScalar(1.04);
  }
}
