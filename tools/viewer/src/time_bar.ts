// SPDX-License-Identifier: MIT
// The controls of time at the foot of the page.
import {button, checkbox, element, select} from './elements.js';
import type {Player} from './player.js';
import type {ViewState} from './view_state.js';

export const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100];

function timeText(time: number, unit: 'brick' | 's'): string {
  return unit === 'brick' ? String(Math.floor(time)) : time.toFixed(2);
}

/** A field for a moment to go to. */
function typedTime(state: ViewState, player: Player): HTMLInputElement {
  const {unit} = player.timeline;
  const label = unit === 'brick' ? 'bricks placed' : 'seconds';
  const out = element('input', {type: 'text', class: 'typed', label});
  out.inputMode = 'decimal';
  out.title = unit === 'brick' ? 'bricks placed: type a number' : 'seconds: type a time';
  out.addEventListener('change', () => {
    const time = Number(out.value.replace(',', '.'));
    if (Number.isFinite(time)) player.goTo(time);
    out.value = timeText(state.now.time, unit);
  });
  return out;
}

function scrubber(state: ViewState, player: Player): HTMLInputElement {
  const {end, unit} = player.timeline;
  const out = element('input', {type: 'range', label: 'time', class: 'scrub'});
  out.min = '0';
  out.max = String(end);
  out.step = unit === 'brick' ? '1' : '0.01';
  out.addEventListener('input', () => {
    state.set({playing: false});
    player.goTo(Number(out.value));
  });
  return out;
}

export function timeBar(state: ViewState, player: Player): HTMLElement {
  const {end, unit} = player.timeline;
  const play = button('▶', 'play or pause (space)', () => player.toggle());
  play.classList.add('play');
  const slider = scrubber(state, player), typed = typedTime(state, player);
  const units = unit === 's' ? 's' : 'bricks';
  const of = element('span', {class: 'of', text: `of ${timeText(end, unit)} ${units}`});
  const speed = select('speed', kSpeeds.map(s => ({value: String(s), text: `${s}×`})),
                       value => state.set({speed: Number(value)}));
  const loop = checkbox('loop', 'begin again at the end (l)', on => state.set({loop: on}));
  const steps = [
    button('⇤', 'to the beginning (Home)', () => player.goTo(0)),
    button('‹', 'the event before (←)', () => player.step(-1)),
    play,
    button('›', 'the next event (→)', () => player.step(1)),
    button('⇥', 'to the end (End)', () => player.goTo(end)),
  ];
  const show = (): void => {
    const {time, playing} = state.now;
    slider.value = String(time);
    if (document.activeElement !== typed) typed.value = timeText(time, unit);
    play.textContent = playing ? '❚❚' : '▶';
    speed.value = String(state.now.speed);
    loop.box.checked = state.now.loop;
  };
  state.onChange(show);
  show();
  return element('footer', {class: 'time'}, element('span', {class: 'steps'}, ...steps), slider,
                 element('span', {class: 'numbers'}, typed, of, speed, loop.row));
}
