// SPDX-License-Identifier: MIT
// What a robot's program shows (`robot.show`), as lib/physical/render/show_json.h writes it.

import type {Said} from './pose_run.js';

export interface ShownArrow {
  from: [number, number, number];
  to: [number, number, number];
  color: string;
}

/** The object that a text is, or an empty one. */
export function parsed(text: string | null): Record<string, unknown> {
  if (text === null) return {};
  try {
    const json: unknown = JSON.parse(text);
    return typeof json === 'object' && json !== null ? json as Record<string, unknown> : {};
  } catch {
    return {};  // a program of another version wrote it
  }
}

function isTriple(value: unknown): value is [number, number, number] {
  return Array.isArray(value) && value.length === 3 && value.every(x => typeof x === 'number');
}

/** In the frame of the robot's root; what is none is passed over. */
export function arrowsOf(text: string | null): ShownArrow[] {
  const {arrows} = parsed(text);
  if (!Array.isArray(arrows)) return [];
  const out: ShownArrow[] = [];
  for (const arrow of arrows as unknown[]) {
    if (!Array.isArray(arrow)) continue;
    const [from, to, color] = arrow as unknown[];
    const good = typeof color === 'string' && /^#[0-9a-f]{6}$/i.test(color);
    if (good && isTriple(from) && isTriple(to)) out.push({from, to, color});
  }
  return out;
}

/** Rows of a table from times on. */
export interface ShownRows {
  times: number[];
  rows: [string, string][][];
}

/** What stands at each time: of each name its newest value, since programs show what changes. */
export function standingRows(said: Said): ShownRows {
  const newest = new Map<string, string>();
  const out: ShownRows = {times: [], rows: []};
  said.texts.forEach((text, i) => {
    const rows = rowsOf(text);
    if (rows.every(([name, value]) => newest.get(name) === value)) return;
    for (const [name, value] of rows) newest.set(name, value);
    out.times.push(said.times[i]);
    out.rows.push([...newest]);
  });
  return out;
}

/** Texts first, then numbers, as rows of a table. */
function rowsOf(text: string | null): [string, string][] {
  const {numbers, texts} = parsed(text);
  const entries = (of: unknown): [string, unknown][] =>
    typeof of === 'object' && of !== null ? Object.entries(of) : [];
  const short = (value: unknown): string =>
    typeof value === 'number' ? String(Number(value.toPrecision(5))) : String(value);
  return [...entries(texts), ...entries(numbers)].map(([name, value]) => [name, short(value)]);
}
