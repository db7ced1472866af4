// SPDX-License-Identifier: MIT
// What the surroundings of a site showed as the run went on, and where else they showed the same:
// a rule sees no more than that.
import {neighbourhoodText, symbolsAbout} from './brick_story.js';
import {element} from './elements.js';
import {type LatticeRun} from './runs.js';
import type {ViewState} from './view_state.js';

const kMostAlike = 12;        // listed
const kMostTried = 100_000;  // compared

/** Times at which something about a brick's cell changed, up to when it was placed. */
function changesAbout(run: LatticeRun, brick: number): number[] {
  const {cells, index} = run.bricks;
  const {x, y, z} = cells;
  const times = new Set<number>([0]);
  for (let dx = -1; dx <= 1; ++dx) {
    for (let dy = -1; dy <= 1; ++dy) {
      for (let dz = -1; dz <= 1; ++dz) {
        const there = index.at(x[brick] + dx, y[brick] + dy, z[brick] + dz);
        if (there >= run.start && there < brick) times.add(there - run.start + 1);
      }
    }
  }
  return [...times].sort((a, b) => a - b);
}

/** Other bricks that were placed where it looked the same, with what they are. */
function alike(run: LatticeRun, brick: number): number[] {
  const shown = symbolsAbout(run, brick, brick);
  const out: number[] = [];
  const end = Math.min(run.bricks.count, run.start + kMostTried);
  for (let other = run.start; other < end && out.length < kMostAlike; ++other) {
    if (other !== brick && symbolsAbout(run, other, other) === shown) out.push(other);
  }
  return out;
}

function linkTo(text: string, run: () => void): HTMLElement {
  const out = element('li', {class: 'state', text});
  out.tabIndex = 0;
  out.addEventListener('click', run);
  out.addEventListener('keydown', event => {
    if (event.key === 'Enter') run();
  });
  return out;
}

/** The states of a brick's site, each of which leads to its moment. */
export function localStates(run: LatticeRun, brick: number, state: ViewState): HTMLElement[] {
  if (brick < run.start) return [];
  const states = changesAbout(run, brick).map(time => {
    const row = linkTo(time === 0 ? 'at first' : `from brick ${time} on`,
                       () => state.set({time, playing: false}));
    row.append(element('pre', {text: neighbourhoodText(run, brick, run.start + time)}));
    return row;
  });
  const twins = alike(run, brick).map(other => {
    const {x, y, z} = run.bricks.cells;
    const rule = run.rules[run.rule[other - run.start]].name;
    return linkTo(`(${x[other]}, ${y[other]}, ${z[other]}): ${rule}`, () =>
      state.set({picked: {run: state.now.run, brick: other}, time: other - run.start + 1}));
  });
  return [
    element('h3', {text: 'States of this site, before it was filled'}),
    element('ul', {class: 'states'}, ...states),
    element('h3', {text: `Placed where it looked the same: ${twins.length}` +
        (twins.length === kMostAlike ? ' or more' : '')}),
    element('ul', {class: 'states'}, ...twins),
  ];
}
