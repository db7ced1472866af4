// SPDX-License-Identifier: MIT
// Where a robot is in its chart, as its program tells it: its state in the chart, and, within a
// behaviour, what that is at.
import type {ShownRows} from './shown_values.js';

export interface ChartStep {
  time: number;
  state: string;
  /** The state that it came from; null at first. */
  before: string | null;
  /** What it shows within the state, or the state itself. */
  shown: string;
}

/** All that a program showed, as steps through its chart; empty of one that tells of none. */
export function chartPath({times, rows}: ShownRows): ChartStep[] {
  const out: ChartStep[] = [];
  rows.forEach((row, i) => {
    const state = row.find(([name]) => name === 'chart')?.[1];
    if (state === undefined) return;
    const shown = row.find(([name]) => name === 'state')?.[1] ?? state;
    const last = out.at(-1);
    if (last?.state === state && last.shown === shown) return;
    const before = last?.state === state ? last.before : last?.state ?? null;
    out.push({time: times[i], state, before, shown});
  });
  return out;
}

/** The step that lasts at a moment. */
export function stepAt(path: readonly ChartStep[], time: number): ChartStep | null {
  return path.filter(step => step.time <= time).at(-1) ?? null;
}
