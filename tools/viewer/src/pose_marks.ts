// SPDX-License-Identifier: MIT
// What is drawn about the bodies of a physical run: what cameras reach and have found, rays of
// rangefinders, ways driven, messages, where magnets point, and forces.
import * as three from 'three';
import {rgbOf, type Rgb} from './colours.js';
import {distanceOf, type CameraDevice} from './devices.js';
import {addForces, strongForce} from './forces.js';
import {Lines} from './mark_lines.js';
import {saidAt, type PoseRun} from './pose_run.js';
import {sensesAt, type Seen, type Senses} from './senses.js';
import type {Mark} from './view_state.js';

const kRobotColours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#999999'];
const kNorth = rgbOf('#d55e00'), kSouth = rgbOf('#0072b2');
const kSent = rgbOf('#e69f00'), kHeard = rgbOf('#56b4e9'), kReturn = rgbOf('#d55e00');
const kAboveFloor = 0.002;  // m
const kMagnetHalf = 0.006;  // m
const kLeastCircle = 0.02;  // m
const kTagCross = 0.012;    // m

export function robotColour(robot: number): Rgb {
  return rgbOf(kRobotColours[robot % kRobotColours.length]);
}

/** A body's frame at a moment; null while it is not there. */
export function frameOf(run: PoseRun, body: number, time: number): three.Matrix4 | null {
  const pose = run.tracks.at(body, time);
  return pose && new three.Matrix4().compose(new three.Vector3(...pose.p),
                                             new three.Quaternion(...pose.q),
                                             new three.Vector3(1, 1, 1));
}

/** A camera's frame: z ahead, x right, y down. */
export function cameraFrame(run: PoseRun, camera: CameraDevice, time: number):
    three.Matrix4 | null {
  const own = new three.Matrix4().compose(new three.Vector3(...camera.p),
                                          new three.Quaternion(...camera.q),
                                          new three.Vector3(1, 1, 1));
  return frameOf(run, camera.body, time)?.multiply(own) ?? null;
}

function addFrustum(lines: Lines, frame: three.Matrix4, {corners}: CameraDevice,
                    colour: Rgb): void {
  const at = corners.map(corner => new three.Vector3(...corner).applyMatrix4(frame));
  if (at.length !== 8) return;
  lines.ring(at.slice(0, 4), colour);
  lines.ring(at.slice(4), colour);
  for (let i = 0; i < 4; ++i) lines.add(at[i], at[i + 4], colour);
}

/** A line to each tag, and a cross where it is taken to be. */
function addDetections(lines: Lines, frame: three.Matrix4, {tags}: Seen, colour: Rgb): void {
  const eye = new three.Vector3().applyMatrix4(frame);
  for (const {place} of tags) {
    const at = new three.Vector3(...place).applyMatrix4(frame);
    lines.add(eye, at, colour);
    for (const axis of [[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const) {
      const arm = new three.Vector3(...axis).multiplyScalar(kTagCross);
      lines.add(at.clone().sub(arm), at.clone().add(arm), colour);
    }
  }
}

function addRanges(lines: Lines, run: PoseRun, robot: number, senses: Senses, time: number): void {
  run.robots[robot].devices?.ranges.forEach((device, i) => {
    const frame = frameOf(run, device.body, time), told = senses.ranges.at(i);
    if (!frame || told === undefined) return;
    const from = new three.Vector3(...device.from), reach = distanceOf(device, told);
    const to = from.clone().addScaledVector(new three.Vector3(...device.way), reach);
    lines.add(from.applyMatrix4(frame), to.applyMatrix4(frame),
              reach < device.range ? kReturn : robotColour(robot));
  });
}

function addCircle(lines: Lines, at: three.Vector3, radius: number, colour: Rgb): void {
  const corners = Array.from({length: 20}, (_, i) => {
    const angle = i / 10 * Math.PI;
    return at.clone().add(new three.Vector3(Math.cos(angle), Math.sin(angle), 0)
                              .multiplyScalar(radius));
  });
  lines.ring(corners, colour);
}

/** A circle about each radio that has sent, a smaller one about each that has heard. */
function addMessages(lines: Lines, run: PoseRun, robot: number, senses: Senses,
                     time: number): void {
  run.robots[robot].devices?.radios.forEach((device, i) => {
    const frame = frameOf(run, device.body, time);
    if (!frame) return;
    const at = new three.Vector3(...device.at).applyMatrix4(frame);
    const radius = Math.max(device.range, kLeastCircle);
    if (senses.sent.some(({radio}) => radio === i)) addCircle(lines, at, radius, kSent);
    if (senses.heard.some(({radio}) => radio === i)) addCircle(lines, at, radius / 2, kHeard);
  });
}

/** Each magnet of a block as a needle with two colours. */
function addMagnets(lines: Lines, run: PoseRun, time: number): void {
  for (const [body, said] of run.magnets) {
    const text = saidAt(said, time), frame = frameOf(run, body, time);
    const places = run.devices.magnets.at(run.devices.blocks.at(body) ?? -1) ?? [];
    if (text === null || !frame) continue;
    const parts = text.match(/-?\d+/g)?.map(Number) ?? [];
    if (parts.length < places.length * 3) continue;
    places.forEach((place, i) => {
      const way = new three.Vector3(...parts.slice(3 * i, 3 * i + 3) as [number, number, number])
                      .setLength(kMagnetHalf);
      const middle = new three.Vector3(...place);
      const [north, south] = [middle.clone().add(way), middle.clone().sub(way)]
                                 .map(end => end.applyMatrix4(frame));
      middle.applyMatrix4(frame);
      lines.add(middle, north, kNorth);
      lines.add(middle, south, kSouth);
    });
  }
}

/** Where a robot was, up to a moment, on the floor. */
function addWay(lines: Lines, run: PoseRun, robot: number, time: number): void {
  const body = run.robots[robot].bodies[0];
  const places = run.tracks.placesBy(body, time).map(([x, y]) =>
    new three.Vector3(x, y, kAboveFloor));
  places.slice(1).forEach((place, i) => lines.add(places[i], place, robotColour(robot)));
}

export class PoseMarks {
  readonly object = new three.LineSegments(new three.BufferGeometry(),
                                           new three.LineBasicMaterial({vertexColors: true}));
  /** Those that are seen through bodies. */
  readonly within = new three.LineSegments(
      new three.BufferGeometry(),
      new three.LineBasicMaterial({vertexColors: true, depthTest: false}));

  constructor(private readonly run: PoseRun) {
    this.within.renderOrder = 1;
    for (const lines of [this.object, this.within]) lines.frustumCulled = false;
  }

  update(marks: readonly Mark[], time: number): void {
    const {run} = this;
    const lines = new Lines(), within = new Lines();
    const has = (mark: Mark): boolean => marks.includes(mark);
    run.robots.forEach((robot, r) => {
      const senses = sensesAt(run, r, time);
      if (has('ways')) addWay(lines, run, r, time);
      if (has('ranges')) addRanges(lines, run, r, senses, time);
      if (has('radio')) addMessages(within, run, r, senses, time);
      if (!has('frusta')) return;
      robot.devices?.cameras.forEach((camera, c) => {
        const frame = cameraFrame(run, camera, time), seen = senses.cameras.at(c);
        if (!frame) return;
        addFrustum(lines, frame, camera, robotColour(r));
        if (seen) addDetections(within, frame, seen, robotColour(r));
      });
    });
    if (has('magnets')) addMagnets(within, run, time);
    if (has('forces')) addForces(within, run, strongForce(run), time);
    lines.show(this.object);
    within.show(this.within);
  }
}
