// SPDX-License-Identifier: MIT
// How two physical runs differ: bodies of one name that are elsewhere, or lit otherwise.
import {saidAt, type PoseRun} from './pose_run.js';

const kElsewhere = 0.002;  // m
const kStep = 0.2;         // s, in which runs are compared

/** Numbers of the bodies of another run by those of a run; -1: it has none of that name. */
export function twinsOf(run: PoseRun, other: PoseRun): number[] {
  const numbers = new Map(other.bodies.map(({name}, i) => [name, i]));
  return run.bodies.map(({name}) => numbers.get(name) ?? -1);
}

/** Is a body of one run where its twin is, and lit alike? */
export function alike(run: PoseRun, body: number, other: PoseRun, twin: number, time: number):
    boolean {
  const a = run.tracks.at(body, time), b = twin < 0 ? null : other.tracks.at(twin, time);
  if (!a || !b) return a === b;
  const way = Math.hypot(...a.p.map((at, axis) => at - b.p[axis]));
  const leds = (of: PoseRun, one: number): string =>
    saidAt(of.leds.get(one), time) ?? of.bodies[one].led;
  return way < kElsewhere && leds(run, body) === leds(other, twin);
}

/** The first moment at which some body is not where its twin is; undefined: there is none. */
export function firstDifference(run: PoseRun, other: PoseRun): number | undefined {
  const twins = twinsOf(run, other), end = Math.min(run.end, other.end);
  for (let step = 0; step * kStep <= end; ++step) {
    const time = step * kStep;
    if (twins.some((twin, body) => !alike(run, body, other, twin, time))) return time;
  }
  return undefined;
}
