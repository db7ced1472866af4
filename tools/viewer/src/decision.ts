// SPDX-License-Identifier: MIT
// Which branch of its decisions a robot has taken. A trace has no such thing: it follows from the
// brick that the robot put down next, and from what stood there then.
import type {ChartStep} from './chart_path.js';
import {lastBefore, saidAt, type PoseRun} from './pose_run.js';
import type {Series} from './senses.js';

const kSite = 'approach site';  // the chart's state that follows a decision

/** A brick that a robot put down, seen from it: the column is what it was put on or before. */
export interface Placement {
  /** s: when it was put down. */
  time: number;
  block: number;
  /** Of LEDs, 1 to 4. */
  colour: number;
  level: number;
  below: Top | null;
  behind: Top | null;
}

export interface Top {
  colour: number;
  level: number;
}

export interface Standing {
  block: number;
  x: number;
  y: number;
  level: number;
}

function colourAt(run: PoseRun, block: number, time: number): number {
  return Number((saidAt(run.leds.get(block), time) ?? String(run.bodies[block].led))[0]);
}

function standingAt(run: PoseRun, time: number): Standing[] {
  return run.bodies.flatMap(({block, half}, i) => {
    const pose = block ? run.tracks.at(i, time) : null;
    if (!pose) return [];
    const [x, y, z] = pose.p;
    return [{block: i, x, y, level: Math.round((z - half[2]) / (2 * half[2]))}];
  });
}

/** The highest brick of the column at a place, below a level. */
function topAt(run: PoseRun, all: readonly Standing[], x: number, y: number, near: number,
               under: number, time: number): Top | null {
  const column = all.filter(one => Math.hypot(one.x - x, one.y - y) < near && one.level < under);
  const top = column.sort((a, b) => b.level - a.level).at(0);
  return top ? {colour: colourAt(run, top.block, time), level: top.level} : null;
}

/** The block nearest to a robot of those whose LEDs have changed since a moment. */
function putDown(run: PoseRun, robot: number, since: number, time: number): number {
  const at = run.tracks.at(run.robots[robot].bodies[0], time);
  let nearest = Infinity, found = -1;
  for (const [block, said] of run.leds) {
    const change = said.times[lastBefore(said.times, time, 0, said.times.length)];
    if (colourAt(run, block, time) === 0) continue;
    const pose = run.tracks.at(block, time);
    if (!at || !pose || change <= since || change > time) continue;
    const way = Math.hypot(pose.p[0] - at.p[0], pose.p[1] - at.p[1]);
    if (way < nearest) [nearest, found] = [way, block];
  }
  return found;
}

function placementAt(run: PoseRun, robot: number, since: number, time: number): Placement | null {
  const block = putDown(run, robot, since, time);
  const from = run.tracks.at(run.robots[robot].bodies[0], time);
  const pose = block < 0 ? null : run.tracks.at(block, time);
  if (!from || !pose) return null;
  const side = 2 * run.bodies[block].half[0];
  const all = standingAt(run, time).filter(one => one.block !== block);
  const [x, y, z] = pose.p;
  const level = Math.round((z - side / 2) / side);
  const [dx, dy] = [x - from.p[0], y - from.p[1]];
  const length = Math.max(Math.hypot(dx, dy), 1e-9);
  return {
    time, block, level,
    colour: colourAt(run, block, time),
    below: topAt(run, all, x, y, side / 2, level, time),
    behind: topAt(run, all, x + dx / length * side, y + dy / length * side, side / 2, Infinity,
                  time),
  };
}

/** What a robot put down, by the number `placed` that its program shows. */
export function placementsOf(run: PoseRun, robot: number, series: readonly Series[]): Placement[] {
  const placed = series.find(({name}) => name === 'placed');
  const out: Placement[] = [];
  placed?.times.forEach((time, i) => {
    if (i === 0) return;
    const one = placementAt(run, robot, placed.times[i - 1], time);
    if (one) out.push(one);
  });
  return out;
}

interface Action {
  what: string;
  colour: number;
  level: number | null;
}

function actionIn(line: string): Action | null {
  const found = /return \{ what = '(\w+)', colour = (\d+)(?:, level = (\d+))?/.exec(line);
  if (!found) return null;
  const level = found.at(3);
  return {what: found[1], colour: Number(found[2]),
          level: level === undefined ? null : Number(level)};
}

/** "column.top_level == 0 or column.top_level == 1": the numbers; none: it says nothing of it. */
function wantedOf(line: string, what: string): number[] {
  return [...line.matchAll(new RegExp(`column\\.${what} == (\\d+)`, 'g'))].map(m => Number(m[1]));
}

const indent = (line: string): number => line.length - line.trimStart().length;

/** Does every condition around a line hold of the column, as far as it is known? */
function conditionsHold(lines: readonly string[], number: number, top: Top | null): boolean {
  let depth = indent(lines[number]);
  for (let i = number - 1; i >= 0; --i) {
    if (indent(lines[i]) >= depth || lines[i].trim().startsWith('--')) continue;
    depth = indent(lines[i]);
    const colours = wantedOf(lines[i], 'top_colour'), levels = wantedOf(lines[i], 'top_level');
    if (top && colours.length > 0 && !colours.includes(top.colour)) return false;
    if (top && levels.length > 0 && !levels.includes(top.level)) return false;
  }
  return true;
}

/** Numbers of the lines, from 0, that say what a robot has done. */
export function branchOf(text: string, done: Placement): number[] {
  const lines = text.split('\n');
  return lines.flatMap((line, i) => {
    const action = actionIn(line);
    if (action?.colour !== done.colour) return [];
    const raises = action.what === 'raise';
    if (raises ? !done.below : action.level !== null && action.level !== done.level) return [];
    return conditionsHold(lines, i, raises ? done.below : done.behind) ? [i] : [];
  });
}

/** The last placement that was decided on by a moment: when its robot set out to the site. */
export function decidedBy(placements: readonly Placement[], path: readonly ChartStep[],
                          time: number): Placement | null {
  const setOut = (before: number): number => {
    const site = path.filter(step => step.time <= before && step.state === kSite);
    // It may show several things there: the first of the last time counts.
    let first = site.length - 1;
    while (first > 0 && path[path.indexOf(site[first]) - 1].state === kSite) --first;
    return site.at(first)?.time ?? before;
  };
  return placements.filter(one => setOut(one.time) <= time).at(-1) ?? null;
}
