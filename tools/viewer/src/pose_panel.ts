// SPDX-License-Identifier: MIT
// What stands beside a physical run: the picked body, robots with what they show and say, events.
import {factTable} from './brick_story.js';
import {button, element, section} from './elements.js';
import {kEventKinds, lastBefore, saidAt, type PoseRun} from './pose_run.js';
import {standingRows, type ShownRows} from './shown_values.js';
import type {Choices, ViewState} from './view_state.js';

const kTouched = 0;
const kLinesShown = 60;  // of a log
const kHint = 'Click a robot or a block to learn what it is and what it does.';

function bodyStory(run: PoseRun, body: number, time: number): HTMLElement {
  const {name, block, half} = run.bodies[body];
  const edges = half.map(h => (2e3 * h).toFixed(1)).join(' × ');
  const rows: [string, string][] = [['name', name], ['size', `${edges} mm`]];
  const pose = run.tracks.at(body, time);
  rows.push(['place', pose ? `${pose.p.map(x => x.toFixed(4)).join(', ')} m` : 'not there']);
  if (block) {
    const leds = saidAt(run.leds.get(body), time) ?? String(run.bodies[body].led);
    rows.push(['LEDs', Array.from(leds, digit => digit === '0' ? 'off' : `Q${digit}`).join(' ')]);
  }
  return section('story', block ? 'Block' : 'Body', factTable(rows));
}

/** The robot that a body belongs to, or -1. */
export function robotOf(run: PoseRun, body: number): number {
  return run.robots.findIndex(robot => robot.bodies.includes(body));
}

function rowsAt({times, rows}: ShownRows, time: number): [string, string][] {
  if (times.length === 0 || times[0] > time) return [];
  return rows[lastBefore(times, time, 0, times.length)];
}

function robots(run: PoseRun, state: ViewState): {part: HTMLElement; show: () => void} {
  const rows = run.robots.map((robot, r) => {
    const follow = button('follow', 'the camera goes with it (v)',
                          () => state.set({follow: state.now.follow === r ? null : r}));
    const values = element('div', {class: 'values'});
    const row = element('div', {class: 'robot'}, element('h3', {text: robot.name}), follow, values);
    const said = run.show.get(robot.bodies[0]) ?? {times: [], texts: []};
    return {row, follow, values, shown: standingRows(said)};
  });
  const show = (): void => {
    const {time, follow} = state.now;
    rows.forEach((row, r) => {
      row.follow.classList.toggle('chosen', follow === r);
      row.values.replaceChildren(factTable(rowsAt(row.shown, time)));
    });
  };
  return {part: section('robots', 'Robots', ...rows.map(({row}) => row)), show};
}

/** Rows of a list that lead to their moments; those to come are dimmed. */
function moments(rows: readonly {time: number; text: string}[], state: ViewState):
    {list: HTMLElement; show: () => void} {
  const items = rows.map(({time, text}) => {
    const item = element('li', {}, element('span', {class: 'when', text: time.toFixed(2)}),
                         element('span', {text}));
    item.addEventListener('click', () => state.set({time, playing: false}));
    return item;
  });
  const show = (): void => items.forEach((item, i) =>
    item.classList.toggle('never', rows[i].time > state.now.time + 1e-9));
  return {list: element('ul', {class: 'moments'}, ...items), show};
}

function events(run: PoseRun, state: ViewState): {part: HTMLElement; show: () => void} {
  const nameOf = (body: number): string => body < 0 ? '' : run.bodies[body].name;
  const rows = run.events.filter(({kind}) => kind !== kTouched).map(({time, kind, body, other}) =>
    ({time, text: `${nameOf(body)} ${kEventKinds[kind]} ${nameOf(other)}`.trim()}));
  const {list, show} = moments(rows, state);
  return {part: section('events', `Events (${rows.length})`, list), show};
}

function log(run: PoseRun, state: ViewState): {part: HTMLElement; show: () => void} {
  const lines = element('pre', {class: 'log'});
  const show = (): void => {
    const said = run.log.filter(({time}) => time <= state.now.time + 1e-9).slice(-kLinesShown);
    lines.textContent = said.map(({time, text}) => `${time.toFixed(2)}  ${text}`).join('\n');
  };
  return {part: section('says', 'What programs said', lines), show};
}

export function posePanel(run: PoseRun, state: ViewState):
    {parts: HTMLElement[]; update: (changed: ReadonlySet<keyof Choices>) => void} {
  const story = element('div', {class: 'picked'});
  const tell = (): void => {
    const {picked, run: number, time} = state.now;
    story.replaceChildren(picked?.run === number ? bodyStory(run, picked.brick, time)
                                                 : element('p', {class: 'hint', text: kHint}));
  };
  const list = [events(run, state)];
  if (run.robots.length > 0) list.unshift(robots(run, state));
  if (run.log.length > 0) list.push(log(run, state));
  const showAll = (): void => {
    tell();
    for (const {show} of list) show();
  };
  showAll();
  const about = section('about', 'Run', factTable(run.facts));
  const parts = [story, ...list.map(({part}) => part), about];
  const update = (changed: ReadonlySet<keyof Choices>): void => {
    if (changed.has('time') || changed.has('picked') || changed.has('follow')) showAll();
  };
  return {parts, update};
}
