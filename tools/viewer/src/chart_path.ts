// SPDX-License-Identifier: MIT
// Where a robot is in its chart. A program shows one state a control step, the finest: within a
// behaviour others of its parts are shown in place of the chart's. What these belong to is known of
// the library's behaviours (programs/mission).
import type {ChartState} from './devices.js';
import type {ShownRows} from './shown_values.js';

/** What behaviours show besides the state of the chart. */
const kWithin: Record<string, readonly string[]> = {
  search_block: ['search'],
  approach_block: ['approach', 'reach', 'back off', 'contact'],
  pick_up: ['pull'],
  search_structure: ['search'],
  find_cache: ['search'],
  approach_site: ['approach', 'reach', 'back off'],
  attach: ['slide in', 'release', 'reverse'],
};

export interface ChartStep {
  time: number;
  state: string;
  /** The state that it came from; null at first. */
  before: string | null;
  /** What it shows within the state, or the state itself. */
  shown: string;
}

/** The way to the nearest state in which something is shown: states after `from`. */
function wayTo(chart: readonly ChartState[], from: string, shown: string): string[] {
  const fits = ({state, does}: ChartState): boolean =>
    state === shown || (kWithin[does] ?? []).includes(shown);
  const ways: string[][] = [[from]], seen = new Set<string>();
  // The list grows while it is gone through.
  for (const way of ways) {
    const last = way.at(-1);
    const here = chart.find(({state}) => state === last);
    if (!here || seen.has(here.state)) continue;
    seen.add(here.state);
    if (fits(here)) return way.slice(1);
    for (const [, next] of here.to) ways.push([...way, next]);
  }
  return [];
}

/** All that a program showed, as steps through its chart; empty without one. */
export function chartPath(chart: readonly ChartState[], {times, rows}: ShownRows): ChartStep[] {
  const out: ChartStep[] = [];
  if (chart.length === 0) return out;
  let now = chart[0].state, before: string | null = null;
  rows.forEach((row, i) => {
    const shown = row.find(([name]) => name === 'state')?.[1];
    if (shown === undefined || shown === out.at(-1)?.shown) return;
    const known = chart.some(({state}) => state === shown);
    const way = known ? [shown].filter(state => state !== now) : wayTo(chart, now, shown);
    for (const state of way) [before, now] = [now, state];
    out.push({time: times[i], state: now, before, shown});
  });
  return out;
}

/** The step that lasts at a moment. */
export function stepAt(path: readonly ChartStep[], time: number): ChartStep | null {
  return path.filter(step => step.time <= time).at(-1) ?? null;
}
