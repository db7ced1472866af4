// SPDX-License-Identifier: MIT
// A lattice run as something to be drawn.
import * as three from 'three';
import type {Bounds} from './bricks.js';
import {brickColours} from './colours.js';
import {Faces} from './faces.js';
import {floorGrid} from './floor.js';
import {pickBrick} from './pick.js';
import {standing, type LatticeRun} from './runs.js';
import type {Choices} from './view_state.js';

/** Which bricks another run does not have at the same time, or of another colour. */
function missingIn(other: LatticeRun, run: LatticeRun, time: number): Uint8Array {
  const {x, y, z} = run.bricks.cells;
  const there = standing(other, time);
  const out = new Uint8Array(run.bricks.count);
  for (let i = 0; i < out.length; ++i) {
    const twin = other.bricks.index.at(x[i], y[i], z[i]);
    if (twin < 0 || twin >= there || other.colour[twin] !== run.colour[i]) out[i] = 1;
  }
  return out;
}

export class LatticeView {
  readonly scene = new three.Scene();
  readonly bounds: Bounds;
  visible: Uint8Array;
  private readonly faces: Faces;
  private readonly ghost: Faces;
  private readonly floor: three.LineSegments | null;
  private readonly marker = new three.LineSegments(
      new three.EdgesGeometry(new three.BoxGeometry(1.06, 1.06, 1.06)),
      new three.LineBasicMaterial({color: 0xff00aa, depthTest: false}));
  private rgb: Uint8Array = new Uint8Array(0);
  private shownBy = '';
  private colouredBy = '';

  /** `other` is the run that differences are told from. */
  constructor(readonly run: LatticeRun, private readonly number: number,
              private readonly other: LatticeRun | null) {
    this.bounds = run.bricks.bounds;
    this.faces = new Faces(run.bricks);
    this.ghost = new Faces(run.bricks, 0.16);
    this.visible = new Uint8Array(run.bricks.count);
    this.floor = run.floor ? floorGrid(run.bricks.bounds) : null;
    this.marker.renderOrder = 1;
    this.scene.add(this.faces.object, this.ghost.object, this.marker);
    if (this.floor) this.scene.add(this.floor);
  }

  get facesDrawn(): number {
    return this.faces.count;
  }

  /** Does what has changed, and nothing else. */
  update(choices: Readonly<Choices>, dark: boolean): void {
    const {colouring, palette, low, high, apart, ghost, difference, hidden, lit} = choices;
    const coloured = `${colouring} ${palette}`;
    const now = standing(this.run, choices.time);
    const shown =
        [coloured, now, low, high, apart, ghost, difference, hidden.join(), lit].join(' ');
    if (coloured !== this.colouredBy) this.rgb = brickColours(this.run, colouring, palette);
    if (shown !== this.shownBy) this.fill(choices, now);
    this.colouredBy = coloured;
    this.shownBy = shown;
    this.mark(choices);
    if (this.floor) {
      (this.floor.material as three.LineBasicMaterial).color.set(dark ? 0x4a5566 : 0xb8c0cc);
    }
  }

  turnTo(camera: three.Camera, apart: number): void {
    this.faces.turnTo(camera, apart);
    this.ghost.turnTo(camera, apart);
  }

  /** The brick that a ray meets, or -1. */
  pick(ray: three.Ray): number {
    return pickBrick(this.run.bricks, this.faces.centres, this.visible, ray);
  }

  private fill(choices: Readonly<Choices>, now: number): void {
    const {apart} = choices;
    const wanted = this.wanted(choices);
    this.visible = wanted.map((yes, i) => i < now ? yes : 0);
    this.faces.fill({visible: this.visible, rgb: this.lit(choices), apart});
    const coming = wanted.map((yes, i) => choices.ghost && i >= now ? yes : 0);
    this.ghost.fill({visible: coming, rgb: this.rgb, apart});
  }

  /** Bricks that would be shown if they stood. */
  private wanted({low, high, hidden}: Readonly<Choices>): Uint8Array {
    const {bricks, colour} = this.run;
    const out = new Uint8Array(bricks.count);
    const left = new Set(hidden);
    for (let i = 0; i < out.length; ++i) {
      const level = bricks.cells.z[i];
      out[i] = level >= low && level <= high && !left.has(colour[i]) ? 1 : 0;
    }
    return out;
  }

  /** Colours, those that are not meant greyed. */
  private lit({lit, difference, time}: Readonly<Choices>): Uint8Array {
    const {run} = this;
    if (lit === null && !(difference && this.other)) return this.rgb;
    const other = difference && this.other ? missingIn(this.other, run, time) : null;
    const out = this.rgb.slice();
    for (let i = 0; i < run.bricks.count; ++i) {
      const meant = (lit === null || (i >= run.start && run.rule[i - run.start] === lit)) &&
          (other === null || other[i] === 1);
      if (meant) continue;
      const grey = 170 + (out[3 * i] + out[3 * i + 1] + out[3 * i + 2]) * 0.05;
      out.fill(grey, 3 * i, 3 * i + 3);
    }
    return out;
  }

  private mark({picked}: Readonly<Choices>): void {
    this.marker.visible = picked?.run === this.number && this.visible[picked.brick] === 1;
    if (picked && this.marker.visible) {
      this.marker.position.fromArray(this.faces.centres, 3 * picked.brick);
    }
  }
}
