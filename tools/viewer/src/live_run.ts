// SPDX-License-Identifier: MIT
// A run that grows while it is looked at, from what lib/live/session.h says of it.
import {Bricks} from './bricks.js';
import type {BodyTracks, Pose, PoseRun} from './pose_run.js';
import type {LatticeRun, Page, Run} from './runs.js';

const kPlace = 1e-5;  // m, as in lib/physical/trace/pose_trace.h
const kTurn = 1 / 16384;
const kWayStep = 0.01;  // m between places that are kept of a way

export interface LiveState {
  run: number;
  time: number;
  /** 0: not known. */
  end: number;
  mode: 'running' | 'paused' | 'ended';
  why: string;
  /** null: as fast as it goes. */
  speed: number | null;
  /** Diagnostics of files that are not good, or have warnings. */
  trouble: string;
  /** Times at which checkpoints were taken. */
  checkpoints: number[];
  /** Of a physical run: whether each body has left, its place and its quaternion (w first), in
      whole quanta; a digit a body; by robot texts, broken (1) or failed (2), and x, y, z in m. */
  bodies?: number[][];
  leds?: string;
  show?: string[];
  broken?: number[];
  robots?: [number, number, number][];
}

/** Where bodies are now, and which way they came. */
export class LiveTracks implements BodyTracks {
  private readonly ways = new Map<number, [number, number, number][]>();
  private poses: (Pose | null)[];

  constructor(first: BodyTracks, bodies: number) {
    this.poses = Array.from({length: bodies}, (_, i) => first.at(i, 0));
  }

  update(bodies: readonly number[][]): void {
    this.poses = bodies.map(([left, x, y, z, qw, qx, qy, qz], i) => {
      if (left === 1) return null;
      const p: Pose['p'] = [x * kPlace, y * kPlace, z * kPlace];
      this.keep(i, p);
      return {p, q: [qx * kTurn, qy * kTurn, qz * kTurn, qw * kTurn]};
    });
  }

  at(body: number): Pose | null {
    return this.poses.at(body) ?? null;
  }

  placesBy(body: number): [number, number, number][] {
    return this.ways.get(body) ?? [];
  }

  reach(body: number): {low: number[]; high: number[]} | null {
    const pose = this.at(body);
    return pose && {low: pose.p, high: pose.p};
  }

  private keep(body: number, p: Pose['p']): void {
    const way = this.ways.get(body);
    const last = way?.at(-1);
    if (!way || !last) this.ways.set(body, [p]);
    else if (Math.hypot(p[0] - last[0], p[1] - last[1], p[2] - last[2]) > kWayStep) way.push(p);
  }
}

/** The page's run, made to grow. */
export function growing(page: Page): Run {
  const run = page.runs[0];
  if (run.kind === 'lattice') return run;
  return {...run, facts: [], end: 0, tracks: new LiveTracks(run.tracks, run.bodies.length)};
}

export function showBodies(run: PoseRun, state: LiveState): void {
  const {bodies, leds, show} = state;
  run.end = state.time;
  if (run.tracks instanceof LiveTracks && bodies) run.tracks.update(bodies);
  Array.from(leds ?? '', (led, i) => run.leds.set(i, {times: [0], texts: [led]}));
  show?.forEach((text, r) => {
    const body = run.robots[r].bodies[0];
    const said = run.show.get(body) ?? {times: [], texts: []};
    if (said.texts.at(-1) === text) return;
    said.times.push(state.time);
    said.texts.push(text);
    run.show.set(body, said);
  });
}

/** x, y, z, colour, rule, agent, step. */
export type NewBrick = [number, number, number, number, number, number, number];

/** The run with bricks that came. */
export function withBricks(run: LatticeRun, news: readonly NewBrick[]): LatticeRun {
  const column = (old: ArrayLike<number>, at: number): Int32Array => {
    const out = new Int32Array(old.length + news.length);
    out.set(old);
    news.forEach((brick, i) => out[old.length + i] = brick[at]);
    return out;
  };
  const {lattice, x, y, z} = run.bricks.cells;
  const rule = column(run.rule, 4);
  const fired = run.rules.map(() => 0);
  for (const r of rule) ++fired[r];
  return {
    ...run, rule, fired,
    facts: [],
    bricks: new Bricks({lattice, x: column(x, 0), y: column(y, 1), z: column(z, 2)}),
    colour: column(run.colour, 3),
    agent: column(run.agent, 5),
    step: Float64Array.from(column(run.step, 6)),
  };
}
