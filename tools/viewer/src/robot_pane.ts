// SPDX-License-Identifier: MIT
// One robot: what its camera makes out, where in its chart it is and what it has decided, what its
// sensors tell over time, what it hears and says.
import {factTable} from './brick_story.js';
import {showSeen} from './camera_picture.js';
import {chartPath, stepAt, type ChartStep} from './chart_path.js';
import {decidedBy, decisionsOf, lineOf, type Decision} from './decision.js';
import type {ChartState, Program} from './devices.js';
import {element} from './elements.js';
import {drawing, plot} from './plot.js';
import type {PoseRun} from './pose_run.js';
import {sensesAt, seriesOf, type Message, type Senses, type Series} from './senses.js';
import {standingRows} from './shown_values.js';
import type {ViewState} from './view_state.js';

const kLinesShown = 30;  // of a log
const kUntold = 'Its program tells of none, as those compiled by earlier versions.';
const kUnrecorded = 'This trace has none: it takes stigc simulate or validate --trace-detail.';

/** A part of the pane: what it looks like, and what it does as time passes. */
interface Part {
  parts: HTMLElement[];
  show: (time: number) => void;
}

/** The chart's states with where they lead, the present one and the way to it marked. */
function chartPart(chart: readonly ChartState[], path: readonly ChartStep[]): Part {
  const rows = chart.map(({state, to}) => {
    const ways = to.map(([event, next]) =>
      ({next, item: element('li', {text: `${event} → ${next}`})}));
    const row = element('li', {}, element('b', {text: state}),
                        element('ul', {}, ...ways.map(({item}) => item)));
    return {state, ways, row};
  });
  const doing = element('p', {class: 'hint'});
  const show = (time: number): void => {
    const now = stepAt(path, time);
    for (const {state, ways, row} of rows) {
      row.classList.toggle('now', state === now?.state);
      for (const {next, item} of ways) {
        item.classList.toggle('taken', state === now?.before && next === now.state);
      }
    }
    doing.textContent = !now || now.shown === now.state ? '' : `within it: ${now.shown}`;
  };
  return {parts: [element('h3', {text: 'Chart: state, and what it leads to'}), doing,
                  element('ul', {class: 'chart'}, ...rows.map(({row}) => row))], show};
}

/** The decisions, and the branch that was taken last. */
function decisionPart({decides}: Program, decisions: readonly Decision[]): Part {
  const lines = decides.text.split('\n').map(text => element('span', {class: 'line', text}));
  const about = element('p', {class: 'hint'});
  const none = decisions.length > 0 ? 'nothing decided so far' : kUntold;
  const show = (time: number): void => {
    const now = decidedBy(decisions, time);
    const taken = now ? lineOf(decides.text, now.branch) : -1;
    lines.forEach((line, i) => line.classList.toggle('taken', i === taken));
    const what = taken < 0 ? 'nothing to do here' : `branch ${now?.branch}`;
    about.textContent = now ? `at ${now.time.toFixed(1)} s: ${what}; told: ${now.told}` : none;
  };
  return {parts: [element('h3', {text: 'Decision: the branch taken last'}), about,
                  element('pre', {class: 'decides'}, ...lines)], show};
}

function cameraPart(run: PoseRun, robot: number): Part {
  const cameras = run.robots[robot].devices?.cameras ?? [];
  const pictures = cameras.map(({name}) => {
    const picture = drawing('svg', {class: 'seen'});
    const count = element('span', {class: 'count'});
    const row = element('div', {class: 'camera'}, element('span', {text: name}), count);
    row.append(picture);
    return {picture, count, row};
  });
  const show = (time: number): void => {
    const {cameras: all} = sensesAt(run, robot, time);
    pictures.forEach(({picture, count}, i) => {
      const seen = all.at(i) ?? {tags: [], leds: []};
      showSeen(picture, cameras[i], seen);
      count.textContent = `${seen.tags.length} tags, ${seen.leds.length} LEDs`;
    });
  };
  return {parts: [element('h3', {text: 'What its camera makes out'}),
                  ...pictures.map(({row}) => row)], show};
}

function messageText(run: PoseRun, robot: number, {radio, text}: Message): string {
  const name = run.robots[robot].devices?.radios.at(radio)?.name ?? String(radio + 1);
  return `${name}: ${text}`;
}

function radioPart(run: PoseRun, robot: number): Part {
  const table = element('div');
  const show = (time: number): void => {
    const {heard, sent}: Senses = sensesAt(run, robot, time);
    const lines = (list: Message[]): string =>
      list.map(message => messageText(run, robot, message)).join('\n') || '–';
    table.replaceChildren(factTable([['sends', lines(sent)], ['hears', lines(heard)]]));
  };
  return {parts: [element('h3', {text: 'Radio'}), table], show};
}

function plotsPart(series: readonly Series[], end: number, state: ViewState): Part {
  const goTo = (time: number): void => state.set({time, playing: false});
  const plots = series.map(one => plot(one, end, goTo));
  return {parts: [element('h3', {text: 'Over time'}), ...plots.map(({row}) => row)],
          show: time => plots.forEach(one => one.show(time))};
}

function logPart(run: PoseRun, robot: number): Part {
  const own = run.log.filter(({body}) => run.robots[robot].bodies.includes(body));
  const lines = element('pre', {class: 'log'});
  const show = (time: number): void => {
    const said = own.filter(line => line.time <= time + 1e-9).slice(-kLinesShown);
    lines.textContent = said.map(line => `${line.time.toFixed(2)}  ${line.text}`).join('\n') || '–';
  };
  return {parts: [element('h3', {text: 'Log'}), lines], show};
}

/** All that there is to know of one robot; `show` brings it to a moment. */
export function robotPane(run: PoseRun, robot: number, state: ViewState):
    {pane: HTMLElement; show: (time: number) => void} {
  const {name, bodies, devices} = run.robots[robot];
  const series = seriesOf(run, robot);
  const shown = standingRows(run.show.get(bodies[0]) ?? {times: [], texts: []});
  const program = run.devices.programs.find((_, i) => i === devices?.program);
  const list: Part[] = [];
  if (program && program.chart.length > 0) list.push(chartPart(program.chart, chartPath(shown)));
  if (program && program.decides.text !== '') {
    list.push(decisionPart(program, decisionsOf(run.show.get(bodies[0]))));
  }
  if (run.senses.has(bodies[0])) {
    list.push(cameraPart(run, robot), radioPart(run, robot));
  } else {
    list.push({parts: [element('h3', {text: 'Camera, sensors, radio'}),
                       element('p', {class: 'hint', text: kUnrecorded})], show: () => undefined});
  }
  list.push(plotsPart(series, run.end, state), logPart(run, robot));
  const pane = element('section', {class: 'pane'}, element('h2', {text: name}),
                       ...list.flatMap(({parts}) => parts));
  return {pane, show: time => list.forEach(part => part.show(time))};
}
