// SPDX-License-Identifier: MIT
// What of a target is missing among the blocks of a physical run, as transparent bricks.
import * as three from 'three';
import {colourOfKind} from './colours.js';
import type {Triple} from './cells.js';
import type {PoseRun} from './pose_run.js';
import type {LatticeRun} from './runs.js';
import {frameOfTarget, middlesOf, thereOf} from './target.js';
import type {Choices} from './view_state.js';

const kOpacity = 0.28;
const kSlack = 0.96;  // of a side, so that ghosts do not shimmer where they touch

export class PoseTarget {
  readonly object = new three.Group();
  private readonly bricks: three.Mesh<three.BoxGeometry, three.MeshBasicMaterial>[];
  private readonly middles: Triple[];
  private readonly side: number;

  constructor(private readonly run: PoseRun, readonly target: LatticeRun) {
    const frame = frameOfTarget(run, target);
    this.middles = frame ? middlesOf(frame, target) : [];
    this.side = frame?.side ?? 1;
    const box = new three.BoxGeometry(1, 1, 1).scale(...this.scale());
    this.bricks = this.middles.map(at => {
      const mesh = new three.Mesh(box, new three.MeshBasicMaterial(
          {transparent: true, opacity: kOpacity, depthWrite: false}));
      mesh.position.set(...at);
      mesh.rotation.z = frame?.yaw ?? 0;
      return mesh;
    });
    for (const mesh of this.bricks) this.object.add(mesh);
  }

  update({target: wanted, time, palette}: Readonly<Choices>): void {
    const there = thereOf(this.run, this.middles, this.side, time);
    this.object.visible = wanted;
    this.bricks.forEach((mesh, i) => {
      mesh.visible = !there[i];
      const [r, g, b] = colourOfKind(this.target, this.target.colour[i], palette);
      mesh.material.color.setRGB(r / 255, g / 255, b / 255, three.SRGBColorSpace);
    });
  }

  /** How many of the target's bricks are there. */
  count(time: number): number {
    return thereOf(this.run, this.middles, this.side, time).filter(one => one).length;
  }

  private scale(): [number, number, number] {
    const edge = this.side * kSlack;
    return [edge, edge, edge];
  }
}
