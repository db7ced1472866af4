// SPDX-License-Identifier: MIT
// What the person who looks has chosen. Whoever shows or changes it asks this one place; listeners
// are told after every change.
import type {Colouring, Palette} from './colours.js';

/** From where a plane comes that cuts the picture open; none: nothing is cut. */
export const kCuts = ['none', '+x', '-x', '+y', '-y', '+z', '-z'] as const;
export type Cut = typeof kCuts[number];

/** What is drawn about the bodies of a physical run. */
export const kMarks = ['frusta', 'ranges', 'ways', 'radio', 'magnets', 'forces'] as const;
export type Mark = typeof kMarks[number];

export type Theme = 'auto' | 'light' | 'dark';

export interface Choices {
  /** Index of the run that is looked at. */
  run: number;
  /** All runs at once. */
  side: boolean;
  /** Bricks placed, or seconds. */
  time: number;
  playing: boolean;
  /** Times the usual. */
  speed: number;
  loop: boolean;
  /** Levels that are shown, inclusive. */
  low: number;
  high: number;
  apart: number;
  /** The plane that cuts, and how far it goes, 0 to 1. */
  cut: Cut;
  cutAt: number;
  /** What is missing of the target, drawn transparent. */
  target: boolean;
  /** What is still to come, drawn transparent. */
  ghost: boolean;
  /** Only what the first run, or the second beside it, or the target has not; of physical runs,
      what is elsewhere. */
  difference: boolean;
  colouring: Colouring;
  palette: Palette;
  /** Brick colours that are not shown, from 1. */
  hidden: readonly number[];
  /** The rule whose bricks are lit. */
  lit: number | null;
  /** The robot that the camera goes with. */
  follow: number | null;
  /** The robot through whose camera is looked. */
  eyes: number | null;
  /** The robot of which all is told. */
  robot: number;
  /** What is drawn about bodies. */
  marks: readonly Mark[];
  /** The brick, or the body, that is told about. */
  picked: {run: number; brick: number} | null;
  orthographic: boolean;
  theme: Theme;
  /** Over the whole window, of a player that is part of a report. */
  whole: boolean;
  help: boolean;
}

/** With one, or without it if it was there. */
export function toggled<T>(list: readonly T[], one: T): T[] {
  return list.includes(one) ? list.filter(x => x !== one) : [...list, one];
}

export class ViewState {
  private readonly listeners: ((changed: ReadonlySet<keyof Choices>) => void)[] = [];

  constructor(private choices: Choices) {}

  get now(): Readonly<Choices> {
    return this.choices;
  }

  set(changes: Partial<Choices>): void {
    const changed = new Set<keyof Choices>();
    for (const key of Object.keys(changes) as (keyof Choices)[]) {
      if (changes[key] !== this.choices[key]) changed.add(key);
    }
    if (changed.size === 0) return;
    this.choices = {...this.choices, ...changes};
    for (const listener of this.listeners) listener(changed);
  }

  onChange(listener: (changed: ReadonlySet<keyof Choices>) => void): void {
    this.listeners.push(listener);
  }
}

export const kFirstChoices: Choices = {
  run: 0,
  side: false,
  time: 0,
  playing: false,
  speed: 1,
  loop: false,
  low: -Infinity,
  high: Infinity,
  apart: 0,
  cut: 'none',
  cutAt: 0.5,
  target: true,
  ghost: false,
  difference: false,
  colouring: 'brick',
  palette: 'file',
  hidden: [],
  lit: null,
  follow: null,
  eyes: null,
  robot: 0,
  marks: [],
  picked: null,
  orthographic: false,
  theme: 'auto',
  whole: false,
  help: false,
};
