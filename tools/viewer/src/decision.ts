// SPDX-License-Identifier: MIT
// What a robot has decided, as its program tells it (programs/mission/record.lua): which branch of
// its decisions it took, by the number in the program's text, and what it was told of the column.
import {parsed} from './shown_values.js';
import {lastBefore, type Said} from './pose_run.js';

export interface Decision {
  time: number;
  /** A number, or "none" where there was nothing to be done. */
  branch: string;
  told: string;
}

/** Empty of a program that does not tell. */
export function decisionsOf(said: Said | undefined): Decision[] {
  const out: Decision[] = [];
  said?.texts.forEach((text, i) => {
    if (!text.includes('"branch"')) return;
    const texts = parsed(text).texts as Record<string, unknown> | undefined;
    if (typeof texts?.branch !== 'string') return;
    const told = typeof texts.told === 'string' ? texts.told : '';
    out.push({time: said.times[i], branch: texts.branch, told});
  });
  return out;
}

/** The last one by a moment. */
export function decidedBy(decisions: readonly Decision[], time: number): Decision | null {
  const times = decisions.map(one => one.time);
  if (times.length === 0 || times[0] > time) return null;
  return decisions[lastBefore(times, time, 0, times.length)];
}

/** The number of the line, from 0, of a branch in a program's decisions; -1: there is none. */
export function lineOf(text: string, branch: string): number {
  return text.split('\n').findIndex(line => line.includes(`branch = ${branch} }`));
}
