// SPDX-License-Identifier: MIT
// Why rules are refused, in words.
import {element, section, swatch} from './elements.js';
import type {LatticeRun} from './runs.js';
import {kInTheWay, kWanted} from './scene_marks.js';

/** Why it is refused, and what is marked; null where nothing is. */
export function refusalPart(run: LatticeRun): HTMLElement | null {
  if (run.why.length === 0 && run.marks.length === 0) return null;
  const lines = run.why.map((text, i) => element('p', i === 0 ? {text} : {class: 'hint', text}));
  const rows = run.marks.map(({at, way, text}) => element(
      'li', {class: 'mark'}, swatch(way ? kInTheWay : kWanted),
      element('span', {text: `(${at.join(', ')}) ${way ? 'in the way' : 'wanted'}: ${text}`})));
  return section('refusal', 'Why it is refused', ...lines, element('ul', {}, ...rows));
}
