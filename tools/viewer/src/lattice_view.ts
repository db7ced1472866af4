// SPDX-License-Identifier: MIT
// A lattice run as something to be drawn.
import * as three from 'three';
import type {Bounds} from './bricks.js';
import {cellOutline} from './cell_outline.js';
import {CoarseFaces, coarseness} from './coarse.js';
import {brickColours} from './colours.js';
import {Faces} from './faces.js';
import {keeper} from './cut.js';
import {floorGrid} from './floor.js';
import {pickBrick} from './pick.js';
import {standing, type LatticeRun} from './runs.js';
import {markObjects, withMarks} from './scene_marks.js';
import {laidOn} from './target.js';
import type {Choices} from './view_state.js';

/** Which bricks another run does not have at the same time, or of another colour if these count. */
function missingIn(other: LatticeRun, run: LatticeRun, time: number, colours: boolean): Uint8Array {
  const {x, y, z} = run.bricks.cells;
  const there = standing(other, time);
  const out = new Uint8Array(run.bricks.count);
  for (let i = 0; i < out.length; ++i) {
    const twin = other.bricks.index.at(x[i], y[i], z[i]);
    const same = !colours || other.colour[twin] === run.colour[i];
    if (twin < 0 || twin >= there || !same) out[i] = 1;
  }
  return out;
}

function unionOf(a: Bounds, b: Bounds | undefined): Bounds {
  if (!b) return a;
  const each = (of: (x: number, y: number) => number, key: keyof Bounds): Bounds['low'] =>
    [of(a[key][0], b[key][0]), of(a[key][1], b[key][1]), of(a[key][2], b[key][2])];
  return {low: each(Math.min, 'low'), high: each(Math.max, 'high')};
}

export class LatticeView {
  readonly scene = new three.Scene();
  readonly bounds: Bounds;
  visible: Uint8Array;
  private readonly faces: Faces;
  private readonly ghost: Faces;
  /** What runs are held against, laid upon this one, and what of it is missing. */
  readonly target: LatticeRun | null;
  private readonly missing: Faces | null;
  private readonly floor: three.LineSegments | null;
  /** About the brick that is picked. */
  readonly marker: three.LineSegments;
  private readonly coarse = new CoarseFaces();
  private rgb: Uint8Array = new Uint8Array(0);
  /** Colours as they are drawn. */
  private drawn: Uint8Array = new Uint8Array(0);
  private shownBy = '';
  private colouredBy = '';

  /** `other` is the run that differences are told from. */
  constructor(readonly run: LatticeRun, private readonly number: number,
              private readonly other: LatticeRun | null, target: LatticeRun | null) {
    this.target = target && laidOn(run, target);
    this.missing = this.target && new Faces(this.target.bricks, 0.2);
    this.bounds = withMarks(run, unionOf(run.bricks.bounds, this.target?.bricks.bounds));
    this.faces = new Faces(run.bricks);
    this.ghost = new Faces(run.bricks, 0.16);
    this.visible = new Uint8Array(run.bricks.count);
    this.floor = run.floor ? floorGrid(this.bounds) : null;
    this.marker = cellOutline(run.bricks.shape, 1.06, 0xff00aa);
    this.marker.renderOrder = 1;
    this.scene.add(this.faces.object, this.ghost.object, this.marker);
    this.scene.add(markObjects(run), this.coarse.object);
    if (this.missing) this.scene.add(this.missing.object);
    if (this.floor) this.scene.add(this.floor);
  }

  get facesDrawn(): number {
    return this.faces.count;
  }

  /** Does what has changed, and nothing else. */
  update(choices: Readonly<Choices>, dark: boolean): void {
    const {colouring, palette, low, high, apart, ghost, difference, hidden, lit} = choices;
    const {cut, cutAt, target} = choices;
    const coloured = `${colouring} ${palette}`;
    const now = standing(this.run, choices.time);
    const shown =
        [coloured, now, low, high, apart, ghost, difference, hidden.join(), lit, cut,
         cut === 'none' ? 0 : cutAt, target].join(' ');
    if (coloured !== this.colouredBy) this.rgb = brickColours(this.run, colouring, palette);
    if (shown !== this.shownBy) this.fill(choices, now);
    this.colouredBy = coloured;
    this.shownBy = shown;
    this.mark(choices);
    if (this.floor) {
      (this.floor.material as three.LineBasicMaterial).color.set(dark ? 0x4a5566 : 0xb8c0cc);
    }
  }

  turnTo(camera: three.Camera, apart: number, coarse: boolean): void {
    const wide = coarse && apart === 0 ? coarseness(this.run.bricks.count, this.faces.count) : 1;
    this.faces.object.visible = this.ghost.object.visible = wide === 1;
    this.coarse.object.visible = false;
    if (wide > 1) {
      this.coarse.show(`${this.shownBy} ${wide}`, wide, this.run.bricks, this.visible, this.drawn);
      return;
    }
    this.faces.turnTo(camera, apart);
    this.ghost.turnTo(camera, apart);
    this.missing?.turnTo(camera, apart);
  }

  /** The brick that a ray meets, or -1. */
  pick(ray: three.Ray): number {
    return pickBrick(this.run.bricks, this.faces.centres, this.visible, ray);
  }

  private fill(choices: Readonly<Choices>, now: number): void {
    const {apart} = choices;
    const wanted = this.wanted(choices);
    this.visible = wanted.map((yes, i) => i < now ? yes : 0);
    this.drawn = this.lit(choices);
    this.faces.fill({visible: this.visible, rgb: this.drawn, apart});
    const coming = wanted.map((yes, i) => choices.ghost && i >= now ? yes : 0);
    this.ghost.fill({visible: coming, rgb: this.rgb, apart});
    this.fillMissing(choices, now);
  }

  private fillMissing(choices: Readonly<Choices>, now: number): void {
    const {target, missing, run} = this;
    if (!target || !missing) return;
    const {x, y, z} = target.bricks.cells;
    const keeps = keeper(choices.cut, choices.cutAt, this.bounds);
    const visible = Uint8Array.from(x, (_, i) => {
      const brick = run.bricks.index.at(x[i], y[i], z[i]);
      const wanted = choices.target && (brick < 0 || brick >= now) && z[i] >= choices.low &&
          z[i] <= choices.high && (keeps?.(target.bricks.centres, 3 * i) ?? true);
      return wanted ? 1 : 0;
    });
    const rgb = brickColours(target, 'brick', choices.palette);
    missing.fill({visible, rgb, apart: choices.apart});
  }

  /** Bricks that would be shown if they stood. */
  private wanted({low, high, hidden, cut, cutAt}: Readonly<Choices>): Uint8Array {
    const {bricks, colour} = this.run;
    const out = new Uint8Array(bricks.count);
    const left = new Set(hidden);
    const keeps = keeper(cut, cutAt, this.bounds);
    for (let i = 0; i < out.length; ++i) {
      const level = bricks.cells.z[i];
      const shown = level >= low && level <= high && !left.has(colour[i]) &&
          (keeps?.(bricks.centres, 3 * i) ?? true);
      out[i] = shown ? 1 : 0;
    }
    return out;
  }

  /** Colours, those that are not meant greyed. */
  private lit({lit, difference, time}: Readonly<Choices>): Uint8Array {
    const {run} = this;
    const against = this.other ?? this.target;
    if (lit === null && !(difference && against)) return this.rgb;
    const colours = this.other !== null;
    const other = difference && against ? missingIn(against, run, time, colours) : null;
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
