// SPDX-License-Identifier: MIT
// What there is to say of one brick: who placed it, when, by which rule, and what stood around.
import {sliceRows} from './cells.js';
import {element, section} from './elements.js';
import type {LatticeRun} from './runs.js';

/** The symbol at a cell when so many bricks stood. */
function symbolAt(run: LatticeRun, x: number, y: number, z: number, standing: number): string {
  if (run.floor && z < 0) return '=';
  const there = run.bricks.index.at(x, y, z);
  if (there < 0 || there >= Math.max(standing, run.start)) return '.';
  return run.kinds[run.colour[there] - 1].symbol;
}

/** All that stands about a brick's cell when so many stand, as one word for comparisons. */
export function symbolsAbout(run: LatticeRun, brick: number, standing: number): string {
  const {x, y, z, lattice} = run.bricks.cells;
  const out: string[] = [];
  for (const dz of [1, 0, -1]) {
    for (const at of sliceRows(lattice).flat()) {
      if (!at || dz === 0 && at[0] === 0 && at[1] === 0) continue;
      out.push(symbolAt(run, x[brick] + at[0], y[brick] + at[1], z[brick] + dz, standing));
    }
  }
  return out.join(' ');
}

/** Slices above, on and below the level, as rule files draw them: when it was placed, or when so
    many bricks stood. */
export function neighbourhoodText(run: LatticeRun, brick: number, standing = brick): string {
  const {x, y, z, lattice} = run.bricks.cells;
  const wide = Math.max(1, ...run.kinds.map(kind => kind.symbol.length));
  const cell = (dx: number, dy: number, dz: number): string => {
    const site = dx === 0 && dy === 0 && dz === 0;
    return site ? '*' : symbolAt(run, x[brick] + dx, y[brick] + dy, z[brick] + dz,
                                     standing);
  };
  const rows = sliceRows(lattice).map(row => [1, 0, -1].map(dz => {
    const shown = row.filter(at => at !== null).map(([dx, dy]) => cell(dx, dy, dz).padEnd(wide));
    return shown.length < 3 ? ` ${shown.join(' ')} ` : shown.join(' ');
  }).join('   '));
  return rows.map(row => row.trimEnd()).join('\n');
}

function facts(run: LatticeRun, brick: number): [string, string][] {
  const {x, y, z} = run.bricks.cells;
  const kind = run.kinds[run.colour[brick] - 1];
  const name = kind.name === '' || kind.name === kind.symbol ? kind.symbol
                                                             : `${kind.symbol} (${kind.name})`;
  const out: [string, string][] = [
    ['brick', name], ['cell', `(${x[brick]}, ${y[brick]}, ${z[brick]})`]];
  const event = brick - run.start;
  if (event < 0) {
    if (run.rules.length > 0) out.push(['placed', 'there at the start']);
    return out;
  }
  const agent = run.agent[event];
  out.push(['placed', `as number ${event + 1}, in step ${run.step[event]}`],
           ['by', agent < 0 ? 'no agent: an order of events' : `agent ${agent}`],
           ['rule', run.rules[run.rule[event]].name]);
  return out;
}

export function factTable(rows: readonly [string, string][]): HTMLElement {
  const lines = rows.map(([name, value]) => element(
      'tr', {}, element('th', {text: name}), element('td', {text: value})));
  return element('table', {class: 'facts'}, element('tbody', {}, ...lines));
}

export function ruleLines(run: LatticeRun, rule: number): string {
  const {first, last} = run.rules[rule];
  return run.source.slice(first - 1, last).join('\n');
}

export function brickStory(run: LatticeRun, brick: number, ...more: Node[]): HTMLElement {
  const parts: Node[] = [factTable(facts(run, brick))];
  const event = brick - run.start;
  if (event >= 0) {
    const rule = run.rule[event];
    const {first, last} = run.rules[rule];
    parts.push(
        element('h3', {text: 'What stood around: above, on and below the level'}),
        element('pre', {text: neighbourhoodText(run, brick)}),
        element('h3', {text: `The rule, lines ${first} to ${last} of the rule set`}),
        element('pre', {class: 'lines', text: ruleLines(run, rule)}));
  }
  return section('story', 'Brick', ...parts, ...more);
}
