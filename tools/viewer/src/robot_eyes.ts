// SPDX-License-Identifier: MIT
// The view of a robot's own camera: a pinhole without distortion, the picture's borders, and in
// them what was found in the picture.
import * as three from 'three';
import {showSeen} from './camera_picture.js';
import {drawing} from './plot.js';
import {cameraFrame} from './pose_marks.js';
import type {PoseRun} from './pose_run.js';
import {sensesAt} from './senses.js';

// Cameras of WebGL look along -z with y up, those of robots along z with y down.
const kTurned = new three.Matrix4().makeRotationX(Math.PI);

export class RobotEyes {
  readonly camera = new three.PerspectiveCamera(60, 1, 0.003, 100);
  readonly picture = drawing('svg', {class: 'seen eyes'});

  /** Looks through the first camera of a robot; false: it has none, or is not there. */
  look(run: PoseRun, robot: number, time: number, aspect: number): boolean {
    const device = run.robots.at(robot)?.devices?.cameras.at(0);
    const frame = device ? cameraFrame(run, device, time) : null;
    if (!device || !frame) return false;
    const {camera, picture} = this;
    frame.multiply(kTurned).decompose(camera.position, camera.quaternion, camera.scale);
    const [width, height] = device.size;
    // All of the picture is in the pane, and what is beyond its borders where there is room.
    const tangent = Math.max(height / 2 / device.focal[1], width / 2 / device.focal[0] / aspect);
    camera.fov = Math.atan(tangent) * 360 / Math.PI;
    camera.aspect = aspect;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    showSeen(picture, device, sensesAt(run, robot, time).cameras.at(0) ?? {tags: [], leds: []});
    // The optical axis is in the middle of the pane, not of the picture.
    const [x, y] = [device.centre[0] - width / 2, device.centre[1] - height / 2];
    picture.setAttribute('viewBox', `${x} ${y} ${width} ${height}`);
    return true;
  }
}
