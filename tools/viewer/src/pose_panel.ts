// SPDX-License-Identifier: MIT
// What stands beside a physical run: the picked body, robots with what they show and say, events.
import {factTable} from './brick_story.js';
import {cssOf} from './colours.js';
import {cutPanel} from './cut_panel.js';
import {button, checkbox, element, section, swatch} from './elements.js';
import {paletteSelect} from './palette_select.js';
import {kContactColour, kMagnetColour, strongForce} from './forces.js';
import {robotColour} from './pose_marks.js';
import {kEventKinds, lastBefore, saidAt, type PoseRun} from './pose_run.js';
import type {PoseTarget} from './pose_target.js';
import {robotPane} from './robot_pane.js';
import {standingRows, type ShownRows} from './shown_values.js';
import {kMarks, toggled, type Choices, type Mark, type ViewState} from './view_state.js';

const kConcern = ['time', 'picked', 'follow', 'robot', 'eyes', 'marks', 'palette', 'cut', 'cutAt',
                  'target'] as const;
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
    const leds = saidAt(run.leds.get(body), time) ?? run.bodies[body].led;
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

interface Part {
  part: HTMLElement;
  show: () => void;
}

function robots(run: PoseRun, state: ViewState): Part {
  const rows = run.robots.map((robot, r) => {
    const tell = button('pane', 'tell all of it (r)', () => state.set({robot: r}));
    const follow = button('follow', 'the camera goes with it (v)',
                          () => state.set({follow: state.now.follow === r ? null : r}));
    const eyes = button('eyes', 'look through its camera (y)', () =>
      state.set({eyes: state.now.eyes === r ? null : r, side: false}));
    const values = element('div', {class: 'values'});
    const square = swatch(cssOf(robotColour(r)));
    const row = element('div', {class: 'robot'}, square, element('h3', {text: robot.name}), tell,
                        follow, ...robot.devices?.cameras.length ? [eyes] : [], values);
    const said = run.show.get(robot.bodies[0]) ?? {times: [], texts: []};
    return {row, tell, follow, eyes, values, shown: standingRows(said)};
  });
  const show = (): void => {
    const {time} = state.now;
    rows.forEach((row, r) => {
      row.tell.classList.toggle('chosen', state.now.robot === r);
      row.follow.classList.toggle('chosen', state.now.follow === r);
      row.eyes.classList.toggle('chosen', state.now.eyes === r);
      row.values.replaceChildren(factTable(rowsAt(row.shown, time)));
    });
  };
  return {part: section('robots', 'Robots', ...rows.map(({row}) => row)), show};
}

const kMarkText: Record<Mark, [string, string, boolean]> = {
  frusta: ['what cameras reach and find', 'u', false],
  ranges: ['rays of rangefinders', 'h', true],
  ways: ['ways driven', 'j', false],
  radio: ['radio messages', 'i', true],
  magnets: ['where magnets point', 'm', true],
  forces: ['forces', '7', true],
};

/** What is drawn about bodies; what a trace without details does not have says so. */
function marks(run: PoseRun, state: ViewState): Part {
  const scale = element('ul', {class: 'forces'});
  const rows = kMarks.map(mark => {
    const [text, key, detail] = kMarkText[mark];
    const missing = detail && (mark === 'forces' ? run.contacts : run.senses).size === 0 &&
        (mark === 'forces' || run.magnets.size === 0);
    const {row, box} = checkbox(text, missing ? 'this trace has none: --trace-detail' : `(${key})`,
                                () => state.set({marks: toggled(state.now.marks, mark)}));
    row.classList.toggle('never', missing);
    return {mark, row, box};
  });
  const show = (): void => {
    for (const {mark, box} of rows) box.checked = state.now.marks.includes(mark);
    scale.hidden = !state.now.marks.includes('forces') || run.contacts.size === 0;
    if (scale.hidden || scale.childElementCount > 0) return;
    const entry = (colour: string, text: string): HTMLElement =>
      element('li', {class: 'mark'}, swatch(colour), element('span', {text}));
    scale.append(entry(kContactColour, `of contacts; 10 cm are ${strongForce(run)} N`),
                 entry(kMagnetColour, 'of magnets, to the same scale'));
  };
  return {part: section('marks', 'Drawn about them', ...rows.map(({row}) => row), scale), show};
}

/** In which colours LEDs are lit. */
function ledPalette(state: ViewState): Part {
  const palette = paletteSelect(state);
  return {part: section('colours', 'Colours of LEDs', palette),
          show: () => palette.value = state.now.palette};
}

/** All of one robot: made anew when it is another's. */
function pane(run: PoseRun, state: ViewState): Part {
  const part = element('div');
  let told = -1, showPane: (time: number) => void = () => undefined;
  const show = (): void => {
    const robot = Math.min(state.now.robot, run.robots.length - 1);
    if (robot !== told) {
      const {pane: made, show: showMade} = robotPane(run, robot, state);
      part.replaceChildren(made);
      showPane = showMade;
    }
    told = robot;
    showPane(state.now.time);
  };
  return {part, show};
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

/** What of a target is there. */
function targetPart(missing: PoseTarget, state: ViewState): Part {
  const {row, box} = checkbox('what is missing of it', '(0)', on => state.set({target: on}));
  const {name, bricks} = missing.target;
  const rows = element('div');
  const show = (): void => {
    box.checked = state.now.target;
    const there = missing.count(state.now.time);
    rows.replaceChildren(factTable([['there', `${there} of ${bricks.count}`]]));
  };
  return {part: section('target', `Target: ${name}`, rows, row), show};
}

export function posePanel(run: PoseRun, state: ViewState, missing: PoseTarget | null):
    {parts: HTMLElement[]; update: (changed: ReadonlySet<keyof Choices>) => void} {
  const story = element('div', {class: 'picked'});
  const tell = (): void => {
    const {picked, run: number, time} = state.now;
    story.replaceChildren(picked?.run === number ? bodyStory(run, picked.brick, time)
                                                 : element('p', {class: 'hint', text: kHint}));
  };
  const list = [events(run, state)];
  if (run.robots.length > 0) {
    list.unshift(robots(run, state), marks(run, state), pane(run, state));
  } else if (run.magnets.size + run.contacts.size > 0) {
    list.unshift(marks(run, state));
  }
  list.push(ledPalette(state), cutPanel(state));
  if (missing) list.unshift(targetPart(missing, state));
  if (run.log.length > 0) list.push(log(run, state));
  const showAll = (): void => {
    tell();
    for (const {show} of list) show();
  };
  showAll();
  const about = section('about', 'Run', factTable(run.facts));
  const parts = [story, ...list.map(({part}) => part), about];
  const update = (changed: ReadonlySet<keyof Choices>): void => {
    if (kConcern.some(key => changed.has(key))) showAll();
  };
  return {parts, update};
}
