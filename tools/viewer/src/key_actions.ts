// SPDX-License-Identifier: MIT
// What each key does.
import {kColourings, kPalettes} from './colours.js';
import type {KeyAction} from './keys.js';
import type {Player} from './player.js';
import {kSpeeds} from './time_bar.js';
import {kCuts, toggled, type Mark, type ViewState} from './view_state.js';
import {kPresets, type Viewpoint} from './viewpoint.js';

export interface Actions {
  state: ViewState;
  player: Player;
  viewpoint: Viewpoint;
  runs: number;
  levels: () => readonly [number, number];
  robots: () => number;
  /** Bricks that stand, or bodies, of the run on show. */
  pickable: () => number;
  /** Is the player a part of another page? */
  embedded: boolean;
  link: () => void;
  switchTheme: () => void;
}

const kTurn = Math.PI / 24;
const kPan = 0.1;  // of half the picture
const kZoom = 1.15;
const kManyEvents = 10;
const kCutStep = 0.05;

function next<T>(list: readonly T[], one: T, by = 1): T {
  return list[(list.indexOf(one) + by + list.length) % list.length];
}

function timeKeys({state, player}: Actions): KeyAction[] {
  const faster = (by: number): void => {
    const at = kSpeeds.indexOf(state.now.speed) + by;
    state.set({speed: kSpeeds[Math.min(Math.max(at, 0), kSpeeds.length - 1)]});
  };
  const step = (sign: number) => (event: KeyboardEvent) =>
    player.step(sign * (event.shiftKey ? kManyEvents : 1));
  return [
    {keys: [' '], shown: 'space', does: 'play or pause', run: () => player.toggle()},
    {keys: ['ArrowRight'], shown: '→', does: 'next event; with shift: ten', run: step(1)},
    {keys: ['ArrowLeft'], shown: '←', does: 'event before; with shift: ten', run: step(-1)},
    {keys: ['Home'], shown: 'Home', does: 'to the beginning', run: () => player.goTo(0)},
    {keys: ['End'], shown: 'End', does: 'to the end', run: () => player.goTo(player.timeline.end)},
    {keys: ['.'], shown: '.', does: 'faster', run: () => faster(1)},
    {keys: [','], shown: ',', does: 'slower', run: () => faster(-1)},
    {keys: ['l'], shown: 'l', does: 'loop', run: () => state.set({loop: !state.now.loop})},
  ];
}

function cameraKeys({state, viewpoint}: Actions): KeyAction[] {
  const turn = (azimuth: number, height: number, zoom = 1) => () =>
    viewpoint.turn(azimuth, height, zoom);
  const pan = (right: number, up: number) => () => viewpoint.pan(right, up);
  return [
    ...Object.keys(kPresets).map((name, i) => ({
      keys: [String(i + 1)], shown: String(i + 1), does: `look from: ${name}`,
      run: () => viewpoint.lookFrom(name),
    })),
    {keys: ['f'], shown: 'f', does: 'fit all into the view', run: () => viewpoint.fit()},
    {keys: ['o'], shown: 'o', does: 'orthographic or perspective',
     run: () => state.set({orthographic: !state.now.orthographic})},
    {keys: ['a'], shown: 'a', does: 'turn left', run: turn(-kTurn, 0)},
    {keys: ['e'], shown: 'e', does: 'turn right', run: turn(kTurn, 0)},
    {keys: ['w'], shown: 'w', does: 'turn up', run: turn(0, -kTurn)},
    {keys: ['x'], shown: 'x', does: 'turn down', run: turn(0, kTurn)},
    {keys: ['A'], shown: 'A', does: 'move left', run: pan(-kPan, 0)},
    {keys: ['E'], shown: 'E', does: 'move right', run: pan(kPan, 0)},
    {keys: ['W'], shown: 'W', does: 'move up', run: pan(0, kPan)},
    {keys: ['X'], shown: 'X', does: 'move down', run: pan(0, -kPan)},
    {keys: ['+', '='], shown: '+', does: 'nearer', run: turn(0, 0, 1 / kZoom)},
    {keys: ['-'], shown: '-', does: 'farther', run: turn(0, 0, kZoom)},
  ];
}

/** After the last one comes nobody. */
function nextRobot(follow: number | null, robots: number): number | null {
  const next = follow === null ? 0 : follow + 1;
  return next < robots ? next : null;
}

function robotKeys({state, robots}: Actions): KeyAction[] {
  const mark = (which: Mark) => (): void => state.set({marks: toggled(state.now.marks, which)});
  return [
    {keys: ['v'], shown: 'v', does: 'follow a robot, the next, nobody',
     run: () => state.set({follow: nextRobot(state.now.follow, robots())})},
    {keys: ['r'], shown: 'r', does: 'tell all of the next robot',
     run: () => state.set({robot: nextRobot(state.now.robot, robots()) ?? 0})},
    {keys: ['y'], shown: 'y', does: 'look through a robot\'s camera, the next, nobody\'s',
     run: () => state.set({eyes: nextRobot(state.now.eyes, robots()), side: false})},
    {keys: ['u'], shown: 'u', does: 'what cameras reach and find', run: mark('frusta')},
    {keys: ['h'], shown: 'h', does: 'rays of rangefinders', run: mark('ranges')},
    {keys: ['j'], shown: 'j', does: 'ways driven', run: mark('ways')},
    {keys: ['i'], shown: 'i', does: 'radio messages', run: mark('radio')},
    {keys: ['m'], shown: 'm', does: 'where magnets point', run: mark('magnets')},
    {keys: ['7'], shown: '7', does: 'what contacts push and magnets pull', run: mark('forces')},
  ];
}

/** Which levels are shown, and which brick is picked. */
function levelKeys({state, levels, pickable}: Actions): KeyAction[] {
  const top = (by: number) => (): void => {
    const [low, high] = levels();
    state.set({high: Math.min(Math.max(Math.min(state.now.high, high) + by, low), high)});
  };
  const bottom = (by: number) => (): void => {
    const [low, high] = levels();
    state.set({low: Math.min(Math.max(Math.max(state.now.low, low) + by, low), high)});
  };
  const pickNext = (by: number) => (): void => {
    const {picked, run} = state.now;
    const count = pickable();
    if (count === 0) return;
    const from = picked?.run === run ? picked.brick : by > 0 ? -1 : 0;
    state.set({picked: {run, brick: (from + by + count) % count}});
  };
  return [
    {keys: ['['], shown: '[', does: 'one level less', run: top(-1)},
    {keys: [']'], shown: ']', does: 'one level more', run: top(1)},
    {keys: ['('], shown: '(', does: 'show from a level lower', run: bottom(-1)},
    {keys: [')'], shown: ')', does: 'show from a level higher', run: bottom(1)},
    {keys: ['N'], shown: 'N', does: 'pick the next brick or body', run: pickNext(1)},
    {keys: ['B'], shown: 'B', does: 'pick the one before', run: pickNext(-1)},
  ];
}

function structureKeys({state, runs}: Actions): KeyAction[] {
  const cut = (by: number) => (): void =>
    state.set({cutAt: Math.min(Math.max(state.now.cutAt + by, 0), 1)});
  return [
    {keys: ['q'], shown: 'q', does: 'cut from one side, the next, none',
     run: () => state.set({cut: next(kCuts, state.now.cut)})},
    {keys: ['{'], shown: '{', does: 'cut less off', run: cut(-kCutStep)},
    {keys: ['}'], shown: '}', does: 'cut more off', run: cut(kCutStep)},
    {keys: ['0'], shown: '0', does: 'what is missing of the target',
     run: () => state.set({target: !state.now.target})},
    {keys: ['g'], shown: 'g', does: 'ghost of what is to come',
     run: () => state.set({ghost: !state.now.ghost})},
    {keys: ['b'], shown: 'b', does: 'bricks apart',
     run: () => state.set({apart: state.now.apart > 0 ? 0 : 0.6})},
    {keys: ['c'], shown: 'c', does: 'colours: by brick, order, rule, agent',
     run: () => state.set({colouring: next(kColourings, state.now.colouring)})},
    {keys: ['p'], shown: 'p', does: 'palette',
     run: () => state.set({palette: next(kPalettes, state.now.palette)})},
    {keys: ['n'], shown: 'n', does: 'next run',
     run: () => state.set({run: (state.now.run + 1) % runs, side: false})},
    {keys: ['s'], shown: 's', does: 'runs side by side',
     run: () => state.set({side: runs > 1 && !state.now.side})},
    {keys: ['d'], shown: 'd', does: 'difference of two runs, or from the target',
     run: () => state.set({difference: !state.now.difference})},
  ];
}

export function keyActions(actions: Actions): KeyAction[] {
  const {state} = actions;
  const whole = {keys: ['z'], shown: 'z', does: 'the whole window, or a part of the report',
                 run: () => state.set({whole: !state.now.whole})};
  return [
    ...timeKeys(actions), ...cameraKeys(actions), ...levelKeys(actions),
    ...structureKeys(actions), ...robotKeys(actions),
    ...actions.embedded ? [whole] : [],
    {keys: ['t'], shown: 't', does: 'light or dark', run: () => actions.switchTheme()},
    {keys: ['k'], shown: 'k', does: 'a link to this view', run: () => actions.link()},
    {keys: ['?'], shown: '?', does: 'this sheet', run: () => state.set({help: !state.now.help})},
    {keys: ['Escape'], shown: 'Escape', does: 'close, let go of the brick',
     run: () => state.set(state.now.help ? {help: false} : {picked: null, whole: false})},
  ];
}
