// SPDX-License-Identifier: MIT
// What contacts push and magnets pull, as lib/physical/simulation/detail_json.h writes it, and the
// arrows that are drawn for it.
import * as three from 'three';
import {rgbOf} from './colours.js';
import type {Lines} from './mark_lines.js';
import {saidAt, type PoseRun, type Said} from './pose_run.js';

export const kContactColour = '#56b4e9', kMagnetColour = '#cc79a7';

const kContact = rgbOf(kContactColour), kMagnet = rgbOf(kMagnetColour);
const kPlaces = 1e3;       // of a metre
const kForces = 10;        // of a newton
const kLongest = 0.1;      // m, of the arrow of a strong force
const kStrong = 0.98;      // share of all forces that are weaker
const kNumbers = 7;        // of a contact
const kNumber = /-?\d+/g;  // all of them are whole

interface ContactForce {
  /** -1: the floor. */
  other: number;
  at: three.Vector3;
  /** On the body itself, N. */
  force: three.Vector3;
}

function numbersIn(text: string | null): number[] {
  return text?.match(kNumber)?.map(Number) ?? [];
}

function vector(numbers: readonly number[], from: number, parts: number): three.Vector3 {
  const [x, y, z] = numbers.slice(from, from + 3);
  return new three.Vector3(x / parts, y / parts, z / parts);
}

/** What is of another shape is passed over. */
export function contactsOf(text: string | null): ContactForce[] {
  const numbers = numbersIn(text), out: ContactForce[] = [];
  for (let i = 0; i + kNumbers <= numbers.length; i += kNumbers) {
    out.push({other: numbers[i], at: vector(numbers, i + 1, kPlaces),
              force: vector(numbers, i + 4, kForces)});
  }
  return out;
}

export function pullOf(text: string | null): three.Vector3 | null {
  const numbers = numbersIn(text);
  return numbers.length === 3 ? vector(numbers, 0, kForces) : null;
}

/** The next of 1, 2, 5, 10, … and their tenths. */
function roundUp(value: number): number {
  const ten = 10 ** Math.floor(Math.log10(value));
  return ten * ([1, 2, 5, 10].find(step => step * ten >= value * (1 - 1e-9)) ?? 10);
}

const kKnown = new WeakMap<PoseRun, number>();

/** The force of an arrow of 10 cm, N: all of a run have one scale, so that they can be compared. */
export function strongForce(run: PoseRun): number {
  const known = kKnown.get(run) ?? strongOf(run);
  kKnown.set(run, known);
  return known;
}

function strongOf({contacts, pulls}: PoseRun): number {
  const sizes: number[] = [];
  const each = (all: Map<number, Said>, add: (text: string) => void): void => {
    for (const {texts} of all.values()) for (const text of new Set(texts)) add(text);
  };
  each(contacts, text => sizes.push(...contactsOf(text).map(({force}) => force.length())));
  each(pulls, text => sizes.push(pullOf(text)?.length() ?? 0));
  const felt = sizes.filter(size => size > 0).sort((a, b) => a - b);
  const strong = felt.at(Math.floor(kStrong * felt.length));
  return strong === undefined ? 1 : roundUp(strong);
}

/** From where they touch, on each of the two bodies; of magnets from the body's middle. */
export function addForces(lines: Lines, run: PoseRun, strong: number, time: number): void {
  const scale = kLongest / strong;
  for (const [, said] of run.contacts) {
    for (const {other, at, force} of contactsOf(saidAt(said, time))) {
      const way = force.multiplyScalar(scale);
      lines.arrow(at, way, kContact);
      if (other >= 0) lines.arrow(at, way.clone().negate(), kContact);
    }
  }
  for (const [body, said] of run.pulls) {
    const force = pullOf(saidAt(said, time)), pose = run.tracks.at(body, time);
    if (!force || !pose) continue;
    lines.arrow(new three.Vector3(...pose.p), force.multiplyScalar(scale), kMagnet);
  }
}
