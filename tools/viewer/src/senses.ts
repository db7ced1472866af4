// SPDX-License-Identifier: MIT
// What a robot sensed, heard and sent in a control step, as lib/physical/simulation/detail_json.h
// writes it into traces that are recorded in detail.
import {lastBefore, saidAt, type PoseRun, type Said} from './pose_run.js';
import {parsed} from './shown_values.js';

export interface Tag {
  id: number;
  /** Four corners in the picture: u, v, u, v, ... */
  corners: number[];
  /** In the camera's frame, m. */
  place: [number, number, number];
}

export interface Seen {
  tags: Tag[];
  /** Place in the picture, and colour: u, v, Y, U, V. */
  leds: number[][];
}

export interface Message {
  radio: number;
  text: string;
}

export interface Senses {
  ranges: number[];
  wheels: number[];
  lift: number[];
  charge: number[];
  cameras: Seen[];
  heard: Message[];
  sent: Message[];
}

function list(value: unknown): unknown[] {
  return Array.isArray(value) ? value as unknown[] : [];
}

/** Of numbers alone; a single number is a list of one. */
function numbers(value: unknown): number[] {
  if (typeof value === 'number') return [value];
  return list(value).filter(one => typeof one === 'number');
}

function tagOf(value: unknown): Tag[] {
  const [id, corners, place] = list(value);
  const at = numbers(place), places = numbers(corners);
  if (typeof id !== 'number' || places.length !== 8 || at.length !== 3) return [];
  return [{id, corners: places, place: [at[0], at[1], at[2]]}];
}

function seen(value: unknown): Seen {
  const given = typeof value === 'object' && value !== null ? value as Record<string, unknown> : {};
  return {
    tags: list(given.tags).flatMap(tagOf),
    leds: list(given.leds).map(numbers).filter(led => led.length === 5),
  };
}

function messages(value: unknown): Message[] {
  return list(value).flatMap(one => {
    const [radio, text] = list(one);
    return typeof radio === 'number' && typeof text === 'string' ? [{radio, text}] : [];
  });
}

/** What is of another shape is passed over. */
export function sensesOf(text: string | null): Senses {
  const json = parsed(text);
  return {
    ranges: numbers(json.ranges), wheels: numbers(json.wheels), lift: numbers(json.lift),
    charge: numbers(json.charge), cameras: list(json.cameras).map(seen),
    heard: messages(json.heard), sent: messages(json.sent),
  };
}

/** What a robot perceived last. */
export function sensesAt(run: PoseRun, robot: number, time: number): Senses {
  return sensesOf(saidAt(run.senses.get(run.robots[robot].bodies[0]), time));
}

/** A number over time, which stays what it is until the next. */
export interface Series {
  name: string;
  unit: string;
  times: number[];
  values: number[];
}

export function valueAt({times, values}: Series, time: number): number | null {
  if (times.length === 0 || times[0] > time) return null;
  return values[lastBefore(times, time, 0, times.length)];
}

class SeriesList {
  private readonly known = new Map<string, Series>();

  add(name: string, unit: string, time: number, value: number | undefined): void {
    if (value === undefined) return;
    const series = this.known.get(name) ?? {name, unit, times: [], values: []};
    this.known.set(name, series);
    if (series.values.at(-1) === value) return;
    series.times.push(time);
    series.values.push(value);
  }

  get all(): Series[] {
    return [...this.known.values()];
  }
}

function addShown(out: SeriesList, said: Said | undefined): void {
  said?.texts.forEach((text, i) => {
    const {numbers: shown} = parsed(text);
    const entries = typeof shown === 'object' && shown !== null ? Object.entries(shown) : [];
    for (const [name, value] of entries) {
      if (typeof value === 'number') out.add(name, '', said.times[i], value);
    }
  });
}

/** What a robot's program shows, and what its sensors tell, over time. */
export function seriesOf(run: PoseRun, robot: number): Series[] {
  const out = new SeriesList();
  const {bodies, devices} = run.robots[robot];
  addShown(out, run.show.get(bodies[0]));
  const said = run.senses.get(bodies[0]);
  said?.texts.forEach((text, i) => {
    const {ranges, wheels, lift, charge} = sensesOf(text);
    const time = said.times[i];
    out.add('left wheel', 'm/s', time, wheels[0]);
    out.add('right wheel', 'm/s', time, wheels[1]);
    out.add('lift', 'm', time, lift[0]);
    out.add('charge', 'V', time, charge[0]);
    ranges.forEach((value, r) => {
      const device = devices?.ranges[r];
      const unit = device?.calibration.length === 0 ? 'm' : '';
      out.add(`range ${device?.name ?? r + 1}`, unit, time, value);
    });
  });
  return out.all;
}
