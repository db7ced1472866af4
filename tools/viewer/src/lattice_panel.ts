// SPDX-License-Identifier: MIT
// What stands beside a lattice run: legend, levels, colours, rules.
import {brickStory, factTable, ruleLines} from './brick_story.js';
import {colourOfKind, colourOfRule, cssOf, kColourings} from './colours.js';
import {cutPanel} from './cut_panel.js';
import {checkbox, element, section, select, swatch} from './elements.js';
import {standing, type LatticeRun} from './runs.js';
import {localStates} from './local_states.js';
import {paletteSelect} from './palette_select.js';
import {refusalPart} from './refusal_part.js';
import {countOf} from './target.js';
import {toggled, type Choices, type ViewState} from './view_state.js';

const kColouringText: Record<string, string> = {
  brick: 'by brick',
  order: 'by order of placement',
  rule: 'by rule',
  agent: 'by agent',
};

const kHint = 'Click a brick to learn who placed it, when and by which rule.';

/** How many bricks of each colour stand, index 0 unused. */
function counts(run: LatticeRun, time: number): number[] {
  const out = run.kinds.map(() => 0);
  out.push(0);
  const now = standing(run, time);
  for (let i = 0; i < now; ++i) ++out[run.colour[i]];
  return out;
}

function legend(run: LatticeRun, state: ViewState): HTMLElement {
  const rows = run.kinds.map((kind, k) => {
    const text = kind.name === '' || kind.name === kind.symbol ? kind.symbol
                                                               : `${kind.symbol}  ${kind.name}`;
    const {row, box} = checkbox('', 'show bricks of this colour', () =>
      state.set({hidden: toggled(state.now.hidden, k + 1)}));
    const square = swatch('');
    const count = element('span', {class: 'count'});
    row.append(square, element('span', {text}), count);
    return {row, box, square, count};
  });
  const show = (): void => {
    const {hidden, palette, time} = state.now;
    const bricks = counts(run, time);
    rows.forEach(({box, square, count}, k) => {
      box.checked = !hidden.includes(k + 1);
      square.style.background = cssOf(colourOfKind(run, k + 1, palette));
      count.textContent = String(bricks[k + 1]);
    });
  };
  return withUpdates(section('legend', 'Bricks', ...rows.map(({row}) => row)), show);
}

/** A part whose `show` is called now, and after every change by the panel that it is of. */
function withUpdates(out: HTMLElement,
                     show: (changed: ReadonlySet<keyof Choices> | null) => void): HTMLElement {
  show(null);
  updates.set(out, show);
  return out;
}

const updates = new WeakMap<HTMLElement, (changed: ReadonlySet<keyof Choices> | null) => void>();

function levels(run: LatticeRun, state: ViewState): HTMLElement {
  const [low, high] = run.bricks.levels;
  const slider = (label: string, from: number): HTMLInputElement => {
    const out = element('input', {type: 'range', label});
    out.min = String(low);
    out.max = String(high);
    out.value = String(from);
    return out;
  };
  const top = slider('highest level shown', high), bottom = slider('lowest level shown', low);
  const text = element('span', {class: 'count'});
  top.addEventListener('input', () => state.set({high: Number(top.value)}));
  bottom.addEventListener('input', () => state.set({low: Number(bottom.value)}));
  const apart = element('input', {type: 'range', label: 'drawn apart'});
  apart.max = '1.5';
  apart.step = '0.05';
  apart.addEventListener('input', () => state.set({apart: Number(apart.value)}));
  const ghost = checkbox('ghost of what is to come', 'ghost (g)', on => state.set({ghost: on}));
  const show = (): void => {
    const now = state.now;
    top.value = String(Math.min(now.high, high));
    bottom.value = String(Math.max(now.low, low));
    text.textContent = `${bottom.value} to ${top.value}`;
    apart.value = String(now.apart);
    ghost.box.checked = now.ghost;
  };
  return withUpdates(section('levels', 'Levels',
                             element('label', {}, 'up to ', top),
                             element('label', {}, 'from ', bottom),
                             text, element('label', {}, 'apart ', apart), ghost.row),
                     show);
}

function colours(state: ViewState): HTMLElement {
  const by = select('colour', kColourings.map(value => ({value, text: kColouringText[value]})),
                    value => state.set({colouring: kColourings.find(c => c === value) ?? 'brick'}));
  const palette = paletteSelect(state);
  const show = (): void => {
    by.value = state.now.colouring;
    palette.value = state.now.palette;
  };
  return withUpdates(section('colours', 'Colours', by, palette), show);
}

function rules(run: LatticeRun, state: ViewState): HTMLElement {
  const rows = run.rules.map((rule, r) => {
    const fired = run.fired[r];
    const square = swatch('');
    const name = fired === 0 ? 'rule never' : 'rule';
    const row = element('li', {class: name, title: ruleLines(run, r)}, square,
                        element('span', {text: rule.name}),
                        element('span', {class: 'count', text: String(fired)}));
    row.tabIndex = 0;
    const light = (): void => state.set({lit: r});
    const dim = (): void => state.set({lit: null});
    row.addEventListener('mouseenter', light);
    row.addEventListener('mouseleave', dim);
    row.addEventListener('focus', light);
    row.addEventListener('blur', dim);
    return {row, square};
  });
  const show = (): void => rows.forEach(({row, square}, r) => {
    const {colouring, palette, lit} = state.now;
    const {place} = run.rules[r];
    square.style.background = cssOf(colouring === 'rule' ? colourOfRule(r, palette)
                                                         : colourOfKind(run, place, palette));
    row.classList.toggle('lit', lit === r);
  });
  const list = element('ul', {}, ...rows.map(({row}) => row));
  return withUpdates(section('rules', 'Rules, and how often each fired', list), show);
}

/** What of a target is there. */
function targetPart(run: LatticeRun, target: LatticeRun, state: ViewState): HTMLElement {
  const {row, box} = checkbox('what is missing of it', '(0)', on => state.set({target: on}));
  const rows = element('div');
  const show = (): void => {
    const {there, of, beyond} = countOf(run, target, state.now.time);
    box.checked = state.now.target;
    const facts: [string, string][] =
        [['there', `${there} of ${of}`], ['not in it', String(beyond)]];
    rows.replaceChildren(factTable(facts));
  };
  return withUpdates(section('target', `Target: ${target.name}`, rows, row), show);
}

function cut(state: ViewState): HTMLElement {
  const {part, show} = cutPanel(state);
  return withUpdates(part, show);
}

/** The panel of a run; `update` is to be called after every change. */
export function latticePanel(run: LatticeRun, state: ViewState, target: LatticeRun | null):
    {parts: HTMLElement[]; update: (changed: ReadonlySet<keyof Choices>) => void} {
  const story = element('div', {class: 'picked'});
  const tell = (): void => {
    const {picked, run: number} = state.now;
    const told = picked?.run === number
        ? brickStory(run, picked.brick, ...localStates(run, picked.brick, state))
        : element('p', {class: 'hint', text: kHint});
    story.replaceChildren(told);
  };
  tell();
  const parts = [story, legend(run, state), levels(run, state), cut(state), colours(state)];
  const refusal = refusalPart(run);
  if (refusal) parts.unshift(refusal);
  if (target) parts.splice(2, 0, targetPart(run, target, state));
  if (run.rules.length > 0) parts.push(rules(run, state));
  if (run.facts.length > 0) parts.push(section('about', 'Run', factTable(run.facts)));
  const update = (changed: ReadonlySet<keyof Choices>): void => {
    if (changed.has('picked')) tell();
    for (const part of parts) updates.get(part)?.(changed);
  };
  return {parts, update};
}
