// SPDX-License-Identifier: MIT
// What stands below a live run: how it goes, and what can be done to it.
import {button, element, select} from './elements.js';
import type {LiveHand} from './live_hand.js';
import type {LiveLink} from './live_link.js';
import type {LiveState} from './live_run.js';
import {robotOf} from './pose_panel.js';
import {kSpeeds} from './time_bar.js';

const kFullSpeed = 'max';

export class LiveBar {
  readonly element: HTMLElement;
  private readonly play = button('❚❚', 'run or pause (space)', () => this.live.toggle());
  private readonly status = element('span', {class: 'status'});
  private readonly said = element('span', {class: 'said'});
  private readonly trouble = element('pre', {class: 'trouble'});
  private readonly speed: HTMLSelectElement;
  private readonly back: HTMLSelectElement;
  private readonly picked = element('span', {class: 'of', text: 'nothing picked'});
  private readonly fields = ['x', 'y', 'z'].map(label =>
    element('input', {type: 'text', label: `${label} in m`, class: 'typed', value: '0'}));
  private kept = 0;
  private shownOf = '';

  constructor(private readonly live: LiveLink, private readonly hand: LiveHand) {
    this.speed = select('speed', [...kSpeeds.map(s => ({value: String(s), text: `${s}×`})),
                                  {value: kFullSpeed, text: 'as fast as it goes'}],
                        value => this.setSpeed(value));
    this.back = select('go back', [{value: '', text: 'go back to …'}], value => {
      if (value !== '') void live.ask({do: 'back', checkpoint: Number(value)});
      this.back.value = '';
    });
    this.play.classList.add('play');
    this.element = element('footer', {class: 'live'}, this.trouble, this.runRow(),
                           ...live.run.kind === 'poses' ? [this.handRow()] : []);
    hand.onPlaced = at => this.showPlace(at);
    live.viewer.state.onChange(changed => {
      if (changed.has('picked')) this.showPicked();
    });
  }

  private runRow(): HTMLElement {
    const {live} = this;
    return element('div', {class: 'row'}, this.play,
                   button('step', 'one step (→; with shift: ten)',
                          () => void live.ask({do: 'step', count: 1})),
                   this.speed,
                   button('again', 'from the beginning', () => void live.ask({do: 'again'})),
                   button('checkpoint', 'take one, to go back to', () => void this.checkpoint()),
                   this.back, this.status, this.said);
  }

  private handRow(): HTMLElement {
    const {live} = this;
    const grab = button('hand', 'drag blocks and robots; with shift: up and down', () => {
      this.hand.on = !this.hand.on;
      grab.classList.toggle('chosen', this.hand.on);
    });
    return element('div', {class: 'row hand'}, grab, this.picked, ...this.fields,
                   button('put there', 'move what is picked to x, y, z in m',
                          () => void this.hand.put(this.typed())),
                   button('drop', 'a block of the scene\'s stock, at x, y, z in m',
                          () => void live.ask({do: 'drop', at: this.typed()})),
                   button('break', 'the picked robot stands still', () => this.repair('break')),
                   button('mend', 'the picked robot goes on', () => this.repair('mend')));
  }

  private typed(): number[] {
    return this.fields.map(field => Number(field.value));
  }

  private setSpeed(value: string): void {
    if (value === kFullSpeed) void this.live.ask({do: 'speed', times: null});
    else if (Number(value) === this.live.viewer.state.now.speed) {
      void this.live.ask({do: 'speed', times: Number(value)});
    } else this.live.viewer.state.set({speed: Number(value)});
  }

  private repair(what: 'break' | 'mend'): void {
    const robot = this.robot;
    if (robot < 0) this.say('pick a robot first');
    else void this.live.ask({do: what, robot});
  }

  /** The robot that is picked, or -1. */
  private get robot(): number {
    const {run} = this.live;
    const body = this.live.viewer.state.now.picked?.brick ?? -1;
    return run.kind === 'poses' ? robotOf(run, body) : -1;
  }

  private async checkpoint(): Promise<void> {
    const {ok, checkpoint} = await this.live.ask({do: 'checkpoint'});
    if (ok) this.say('', checkpoint);
  }

  /** What a command was answered; a checkpoint with its file. */
  say(text: string, checkpoint?: number): void {
    this.said.textContent = text;
    if (checkpoint === undefined) return;
    const link = element('a', {text: `save checkpoint ${checkpoint}`});
    link.href = this.live.address('checkpoint', {number: String(checkpoint)});
    link.download = '';
    this.said.replaceChildren(link);
  }

  connected(is: boolean): void {
    this.element.classList.toggle('away', !is);
    if (!is) this.status.textContent = 'the program does not answer';
  }

  private showPicked(): void {
    const {run} = this.live;
    const body = this.live.viewer.state.now.picked?.brick;
    if (run.kind !== 'poses') return;
    const name = body === undefined ? 'nothing picked' : run.bodies[body].name.split('/')[0];
    this.picked.textContent = name;
    this.showPlace(this.hand.placeOf(body ?? -1) ?? []);
  }

  private showPlace(at: readonly number[]): void {
    at.forEach((x, i) => this.fields[i].value = x.toFixed(3));
  }

  show(state: LiveState): void {
    const {mode, why, time, end, speed, trouble, checkpoints, broken} = state;
    const physical = this.live.run.kind === 'poses';
    const unit = physical ? `${time.toFixed(2)} of ${end} s` : `${time} bricks`;
    const halted = broken?.filter(one => one > 0).length ?? 0;
    this.play.textContent = mode === 'running' ? '❚❚' : '▶';
    this.speed.value = speed === null ? kFullSpeed : String(speed);
    const text = [unit, mode + (why === '' ? '' : `: ${why}`),
                  ...halted > 0 ? [`${halted} broken`] : []].join(', ');
    if (text !== this.shownOf) this.status.textContent = text;
    this.shownOf = text;
    this.trouble.textContent = trouble;
    if (checkpoints.length === this.kept) return;
    this.kept = checkpoints.length;
    this.back.replaceChildren(element('option', {value: '', text: 'go back to …'}),
                              ...checkpoints.map((at, i) => element('option', {
                                value: String(i + 1), text: `${i + 1}: ${at.toFixed(2)}`})));
  }
}
