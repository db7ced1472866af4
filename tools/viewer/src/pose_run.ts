// SPDX-License-Identifier: MIT
// A run in the physical world: bodies with their tracks, lights, what robots show and say.
import {kNoDevices, type Devices, type RobotDevices} from './devices.js';
import {column, integers, type ColumnPlace, type PackedData} from './packed_data.js';

export interface Body {
  name: string;
  shape: 'box' | 'sphere' | 'cylinder' | 'hull';
  /** Half the edges of the box around it, in m. */
  half: readonly [number, number, number];
  points?: readonly (readonly [number, number, number])[];
  /** What is looked at in place of the shape; without triangles, nothing. */
  surface?: {
    points: readonly (readonly [number, number, number])[];
    triangles: readonly (readonly [number, number, number])[];
  };
  color: string;
  block: boolean;
  /** At the start, as the channel has LEDs: a digit for all, or one for each. */
  led: string;
}

/** What a channel says of one body: texts from times on. */
export interface Said {
  times: number[];
  texts: string[];
}

export const kEventKinds =
    ['touched', 'slept', 'woke', 'left the arena', 'snapped to', 'let go of'];

export interface PoseEvent {
  time: number;
  /** Index into kEventKinds. */
  kind: number;
  body: number;
  /** -1: the floor, or nobody. */
  other: number;
}

export interface Robot {
  name: string;
  /** Its bodies; the first one is its root. */
  bodies: number[];
  /** What it has, where that is known. */
  devices: RobotDevices | null;
}

export interface PoseRun {
  kind: 'poses';
  name: string;
  title: string;
  facts: [string, string][];
  /** s */
  end: number;
  bodies: Body[];
  robots: Robot[];
  tracks: BodyTracks;
  events: PoseEvent[];
  leds: Map<number, Said>;
  show: Map<number, Said>;
  /** What robots sense and send, and where magnets point; of traces recorded in detail. */
  senses: Map<number, Said>;
  magnets: Map<number, Said>;
  /** What contacts push, by the body with the lower number, and what magnets pull. */
  contacts: Map<number, Said>;
  pulls: Map<number, Said>;
  devices: Devices;
  log: {time: number; body: number; text: string}[];
}

export interface ValuesJson {
  list: string[];
  ticks: ColumnPlace;
  bodies: ColumnPlace;
  texts: ColumnPlace;
}

export interface PoseJson {
  kind: 'poses';
  name: string;
  title: string;
  facts: [string, string][];
  step: number;
  end: number;
  place: number;
  bodies: Body[];
  tracks: {counts: ColumnPlace; ticks: ColumnPlace; left: ColumnPlace; parts: ColumnPlace[]};
  events: Record<'ticks' | 'kinds' | 'bodies' | 'others', ColumnPlace>;
  leds: ValuesJson;
  log: ValuesJson;
  show: ValuesJson;
  senses: ValuesJson;
  magnets: ValuesJson;
  contacts: ValuesJson;
  pulls: ValuesJson;
  devices: Partial<Devices>;
}

/** Index of the last time that is not after a moment, within [low, high); low when all are. */
export function lastBefore(times: ArrayLike<number>, time: number, low: number, high: number):
    number {
  let [first, beyond] = [low, high];
  while (beyond - first > 1) {
    const middle = first + beyond >> 1;
    if (times[middle] > time) beyond = middle;
    else first = middle;
  }
  return first;
}

/** Place in m and quaternion (x, y, z, w). */
export interface Pose {
  p: [number, number, number];
  q: [number, number, number, number];
}

/** Where bodies are, and were. */
export interface BodyTracks {
  /** The pose at a moment; null while the body is not there. */
  at(body: number, time: number): Pose | null;
  /** Where a body was at the moments that are kept of it, up to a time and at it. */
  placesBy(body: number, time: number): [number, number, number][];
  /** Lowest and highest places of a body while it is there; null: it never is. */
  reach(body: number): {low: number[]; high: number[]} | null;
}

/** Where bodies are, from the moments that the program has kept of them. */
export class Tracks implements BodyTracks {
  private readonly first: Int32Array;
  private readonly times: Float64Array;
  private readonly left: Int32Array;
  private readonly parts: Int32Array[];

  constructor(json: PoseJson, data: PackedData, private readonly unit: number) {
    const counts = integers(data, json.tracks.counts);
    this.first = new Int32Array(counts.length + 1);
    counts.forEach((count, i) => this.first[i + 1] = this.first[i] + count);
    this.times = column(data, json.tracks.ticks).map(tick => tick * json.step);
    this.left = integers(data, json.tracks.left);
    this.parts = json.tracks.parts.map(part => integers(data, part));
  }

  at(body: number, time: number): Pose | null {
    const [low, high] = [this.first[body], this.first[body + 1]];
    if (low === high) return null;
    const key = lastBefore(this.times, time, low, high);
    if (this.left[key] === 1) return null;
    const next = key + 1 < high && this.left[key + 1] === 0 ? key + 1 : key;
    const span = this.times[next] - this.times[key];
    const share = span > 0 ? Math.min(Math.max((time - this.times[key]) / span, 0), 1) : 0;
    const mix = (part: number): number => {
      const numbers = this.parts[part];
      return numbers[key] + (numbers[next] - numbers[key]) * share;
    };
    const [w, x, y, z] = [mix(3), mix(4), mix(5), mix(6)];
    const length = Math.hypot(w, x, y, z);
    return {
      p: [mix(0) * this.unit, mix(1) * this.unit, mix(2) * this.unit],
      q: [x / length, y / length, z / length, w / length],
    };
  }

  placesBy(body: number, time: number): [number, number, number][] {
    const out: [number, number, number][] = [];
    for (let key = this.first[body]; key < this.first[body + 1]; ++key) {
      if (this.times[key] > time) break;
      if (this.left[key] === 1) continue;
      const [x, y, z] = [0, 1, 2].map(part => this.parts[part][key] * this.unit);
      out.push([x, y, z]);
    }
    const now = this.at(body, time);
    if (now) out.push(now.p);
    return out;
  }

  reach(body: number): {low: number[]; high: number[]} | null {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let key = this.first[body]; key < this.first[body + 1]; ++key) {
      if (this.left[key] === 1) continue;
      for (let axis = 0; axis < 3; ++axis) {
        low[axis] = Math.min(low[axis], this.parts[axis][key] * this.unit);
        high[axis] = Math.max(high[axis], this.parts[axis][key] * this.unit);
      }
    }
    return low[0] > high[0] ? null : {low, high};
  }
}

interface Value {
  time: number;
  body: number;
  text: string;
}

function valuesOf(json: ValuesJson, step: number, data: PackedData): Value[] {
  const ticks = column(data, json.ticks), bodies = integers(data, json.bodies);
  const texts = integers(data, json.texts);
  return Array.from(texts, (text, i) =>
    ({time: ticks[i] * step, body: bodies[i], text: json.list[text]}));
}

function byBody(values: readonly Value[]): Map<number, Said> {
  const out = new Map<number, Said>();
  for (const {time, body, text} of values) {
    const said = out.get(body) ?? {times: [], texts: []};
    said.times.push(time);
    said.texts.push(text);
    out.set(body, said);
  }
  return out;
}

/** What was said of a body last. */
export function saidAt(said: Said | undefined, time: number): string | null {
  if (!said || said.times.length === 0 || said.times[0] > time) return null;
  return said.texts[lastBefore(said.times, time, 0, said.times.length)];
}

/** Bodies called "robot 1/left wheel" make up "robot 1". */
function robotsOf(bodies: readonly Body[], devices: Devices): Robot[] {
  const out = new Map<string, Robot>();
  bodies.forEach(({name, block}, i) => {
    const slash = name.indexOf('/');
    if (block || slash < 0) return;
    const whole = name.slice(0, slash);
    const known = devices.robots.find(robot => robot.name === whole) ?? null;
    const robot = out.get(whole) ?? {name: whole, bodies: [], devices: known};
    robot.bodies.push(i);
    out.set(whole, robot);
  });
  return [...out.values()];
}

function eventsOf(json: PoseJson, data: PackedData): PoseEvent[] {
  const {events} = json;
  const ticks = column(data, events.ticks), kinds = integers(data, events.kinds);
  const bodies = integers(data, events.bodies), others = integers(data, events.others);
  return Array.from(kinds, (kind, i) =>
    ({time: ticks[i] * json.step, kind, body: bodies[i], other: others[i]}));
}

export function poseRun(json: PoseJson, data: PackedData): PoseRun {
  const {name, title, facts, step, bodies} = json;
  const devices = {...kNoDevices, ...json.devices};
  return {
    kind: 'poses', name, title, facts, bodies,
    end: json.end * step,
    robots: robotsOf(bodies, devices),
    devices,
    tracks: new Tracks(json, data, json.place),
    events: eventsOf(json, data),
    leds: byBody(valuesOf(json.leds, step, data)),
    show: byBody(valuesOf(json.show, step, data)),
    senses: byBody(valuesOf(json.senses, step, data)),
    magnets: byBody(valuesOf(json.magnets, step, data)),
    contacts: byBody(valuesOf(json.contacts, step, data)),
    pulls: byBody(valuesOf(json.pulls, step, data)),
    log: valuesOf(json.log, step, data),
  };
}
