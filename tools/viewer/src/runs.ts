// SPDX-License-Identifier: MIT
// What a page shows: runs, each with its own time.
import {Bricks} from './bricks.js';
import type {Lattice, Triple} from './cells.js';
import {column, integers, type ColumnPlace, type PackedData} from './packed_data.js';
import {firstDifference} from './pose_difference.js';
import {poseRun, type PoseJson, type PoseRun} from './pose_run.js';

export interface BrickKind {
  symbol: string;
  name: string;
  color: string;
}

export interface RuleText {
  name: string;
  place: number;
  /** Lines of the source, from 1, the last one included. */
  first: number;
  last: number;
}

/** A cell that a refusal is about. */
export interface SceneMark {
  at: Triple;
  /** Is it in the way? Otherwise it is wanted. */
  way: boolean;
  text: string;
}

/** Bricks on a lattice as they came; a structure without history is all start. */
export interface LatticeRun {
  kind: 'lattice';
  /** Of the file. */
  name: string;
  title: string;
  floor: boolean;
  /** Of a refusal: what is marked, and why, in lines. */
  marks: SceneMark[];
  why: string[];
  /** Does its file say where it stands? */
  placed: boolean;
  /** How the run went, in words; empty for a structure. */
  facts: [string, string][];
  kinds: BrickKind[];
  rules: RuleText[];
  /** Lines of the rule set. */
  source: string[];
  bricks: Bricks;
  /** How many bricks were there at first. */
  start: number;
  /** By brick, from 1: index into kinds, plus 1. */
  colour: Int32Array;
  /** By brick placed (brick number minus start): index into rules; who (-1: nobody); when. */
  rule: Int32Array;
  agent: Int32Array;
  step: Float64Array;
  /** How often each rule has fired by the end. */
  fired: number[];
}

export type Run = LatticeRun | PoseRun;

export interface Page {
  title: string;
  runs: Run[];
  /** What runs are held against. */
  target: LatticeRun | null;
}

interface LatticeJson {
  kind: 'lattice';
  name: string;
  title: string;
  lattice: Lattice;
  floor: boolean;
  facts: [string, string][];
  bricks: BrickKind[];
  rules: RuleText[];
  source: string;
  start: number;
  placed?: boolean;
  marks?: SceneMark[];
  why?: string[];
  columns: Record<'x' | 'y' | 'z' | 'colour' | 'rule' | 'agent' | 'step', ColumnPlace>;
}

interface PageJson {
  version: number;
  title: string;
  runs: (LatticeJson | PoseJson)[];
  target?: LatticeJson;
}

function latticeRun(json: LatticeJson, data: PackedData): LatticeRun {
  const {columns} = json;
  const numbers = (name: keyof LatticeJson['columns']): Int32Array => integers(data, columns[name]);
  const rule = numbers('rule');
  const fired = json.rules.map(() => 0);
  for (const r of rule) ++fired[r];
  const cells = {lattice: json.lattice, x: numbers('x'), y: numbers('y'), z: numbers('z')};
  return {
    kind: 'lattice',
    name: json.name,
    title: json.title,
    floor: json.floor,
    placed: json.placed ?? true,
    marks: json.marks ?? [],
    why: json.why ?? [],
    facts: json.facts,
    kinds: json.bricks,
    rules: json.rules,
    source: json.source.split('\n'),
    bricks: new Bricks(cells),
    start: json.start,
    colour: numbers('colour'),
    rule,
    agent: numbers('agent'),
    step: column(data, columns.step),
    fired,
  };
}

export function pageOf(data: PackedData): Page {
  const json = data.json as PageJson;
  if (json.version !== 1) throw new Error(`a page of version ${String(json.version)}`);
  return {
    title: json.title,
    runs: json.runs.map(run =>
      run.kind === 'poses' ? poseRun(run, data) : latticeRun(run, data)),
    target: json.target ? latticeRun(json.target, data) : null,
  };
}

/** Bricks that stand at a time, which counts the bricks placed. */
export function standing(run: LatticeRun, time: number): number {
  return Math.min(run.bricks.count, run.start + Math.floor(time));
}

/** The last moment of a run. */
export function endOf(run: Run): number {
  return run.kind === 'poses' ? run.end : run.bricks.count - run.start;
}

/** How many placements two runs have in common before they part; undefined: they never do. */
function partingOf(a: LatticeRun, b: LatticeRun): number | undefined {
  const most = Math.min(endOf(a), endOf(b));
  for (let i = 0; i < most; ++i) {
    const [m, n] = [a.start + i, b.start + i];
    const [p, q] = [a.bricks.cells, b.bricks.cells];
    const same = p.x[m] === q.x[n] && p.y[m] === q.y[n] && p.z[m] === q.z[n] &&
        a.colour[m] === b.colour[n];
    if (!same) return i;
  }
  return endOf(a) === endOf(b) ? undefined : most;
}

/** Where two runs part, in words, and the moment; null: they never do. */
export function partingTextOf(a: Run, b: Run): {text: string; time: number} | null {
  if (a.kind === 'lattice' && b.kind === 'lattice') {
    // A structure has no rules that placed it, and so no order.
    if (a.rules.length === 0 || b.rules.length === 0) return null;
    const parting = partingOf(a, b);
    if (parting === undefined) return null;
    const text = ` parts after ${parting} ${parting === 1 ? 'brick' : 'bricks'}`;
    return {text, time: parting + 1};
  }
  if (a.kind !== 'poses' || b.kind !== 'poses') return null;
  const time = firstDifference(a, b);
  return time === undefined ? null : {text: ` differs from ${time.toFixed(1)} s on`, time};
}
