// SPDX-License-Identifier: MIT
// Time as it passes while a run is played.
import type {ViewState} from './view_state.js';

/** What time is counted in, and where something happens. */
export interface Timeline {
  end: number;
  unit: 'brick' | 's';
  /** Units in a second of playing at speed 1. */
  rate: number;
  /** Moments of events, ascending. */
  events: ArrayLike<number>;
}

/** Index of the first event later than a moment. */
export function eventAfter(events: ArrayLike<number>, time: number): number {
  let low = 0, high = events.length;
  while (low < high) {
    const middle = low + high >> 1;
    if (events[middle] > time) high = middle;
    else low = middle + 1;
  }
  return low;
}

const kCloseTo = 1e-9;

export class Player {
  private last = 0;

  constructor(private readonly state: ViewState, readonly timeline: Timeline) {
    state.onChange(changed => {
      if (changed.has('playing')) this.last = 0;
    });
  }

  /** Before a frame; true while there is more to play. */
  advance(now: number): boolean {
    const {playing, time, speed, loop} = this.state.now;
    if (!playing) return false;
    const passed = this.last === 0 ? 0 : Math.min(now - this.last, 250) / 1000;
    this.last = now;
    const next = time + passed * speed * this.timeline.rate;
    if (next < this.timeline.end) this.state.set({time: next});
    else if (loop) this.state.set({time: 0});
    else this.state.set({time: this.timeline.end, playing: false});
    return this.state.now.playing;
  }

  toggle(): void {
    const {playing, time} = this.state.now;
    const again = !playing && time >= this.timeline.end;
    this.state.set({playing: !playing, ...again && {time: 0}});
  }

  goTo(time: number): void {
    this.state.set({time: Math.min(Math.max(time, 0), this.timeline.end)});
  }

  /** By so many events, forward or back. */
  step(events: number): void {
    this.state.set({playing: false});
    const all = this.timeline.events;
    const {time} = this.state.now;
    const at = events > 0 ? eventAfter(all, time + kCloseTo) + events - 1
                          : eventAfter(all, time - kCloseTo) + events;
    if (at < 0) this.goTo(0);
    else if (at >= all.length) this.goTo(this.timeline.end);
    else this.goTo(all[at]);
  }
}
